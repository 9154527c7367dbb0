//! Space: orientations, axes with the directions across them, and the relations of joints.
//!
//! ```text
//! triad of an axis   z = a/|a|,  x = (b − (b·z) z)/|…| for the declared direction b,  y = z × x
//! joint angle        θ = atan2(y_i · x_j, x_i · x_j), continued over whole turns
//! displacement       z_i · (r_Q − r_P)
//! ```

use super::{elaborate::Elaborator, statement::ScalarEquation};
use crate::diag::{ArityFact, Range, ValueFact, Wanted};
use crate::expr::{Expr, Frame, Leaf, Mark, Node, Triple, cross, dot};
use crate::geometry::{
    Components, JointQuantity, Place, Relationship, Rotation, Triad, Turn, angle_near, difference, longest, natural, rotated, rotation,
};
use crate::hints::{by_turns, decimal_comma};
use crate::model::{DECLARED, declared_angular};
use crate::names::{Arguments, Fixed, FrameId, Scalar, Scope, Value, Vector};
use crate::quantity::{Dim, InferredDim, Role};
use crate::syntax::ast::{self, Statement};
use proc_macro2::Ident;

impl Elaborator<'_> {
    /// Declares the frame of a body with the quaternion that rotates it and with speeds of its own.
    pub(super) fn declare_frame(&mut self, body: u32, quaternion: &[Expr]) {
        let &[w, x, y, z] = quaternion else { return };
        let columns = rotation(&mut self.arena, [w, x, y, z]).0;
        let zero = self.arena.integer(0);
        let speed = |leaf: fn(u32) -> Leaf| declared_angular(body as usize).map(leaf);
        let velocity = speed(Leaf::Speed).map(|leaf| self.arena.leaf(leaf));
        let acceleration = speed(Leaf::Acceleration).map(|leaf| self.arena.leaf(leaf));
        let acceleration_at_constant_speeds = [zero; 3];
        let leaf = |part: &Expr| if let Node::Leaf(leaf) = self.arena.node(*part) { Some(*leaf) } else { None };
        let own = quaternion.iter().filter_map(leaf).collect();
        let turns = self.arena.turns_about_ground(body as usize).to_vec();
        self.arena.add_frame(Frame { columns, velocity, acceleration, acceleration_at_constant_speeds, turns, against: None, own });
    }

    /// A vector fixed in a body, by its components in ground.
    pub(super) fn turned(&mut self, fixed: Fixed) -> Components {
        match (fixed.frame.body(), fixed.local.in_space()) {
            (Some(body), Some(local)) => Components::space(self.arena.turned(body, local)),
            _ => fixed.local,
        }
    }

    /// `from (x, y, z)` of an axis.
    pub(super) fn zero_direction(&mut self, mark: &ast::Feature, scope: &Scope, axis: Components) -> Option<Option<Components>> {
        let Some(written) = &mark.zero else { return Some(None) };
        let zero = self.vector(written, scope)?.parts;
        let (Some(one), Some(two)) = (axis.in_space(), zero.in_space()) else {
            return self.refuse(written.range, ValueFact::OnlyInSpace { word: "from".to_owned(), typed: None });
        };
        if !zero.iter().all(|part| self.arena.is_fixed(*part)) {
            return self.refuse(written.range, ValueFact::NotFixed { place: "a point or an axis" });
        }
        let normal = cross(&mut self.arena, one, two);
        if normal.iter().all(|part| self.arena.as_constant(*part).is_some_and(|value| value.is_zero())) {
            let is_zero = |part: &Expr| self.arena.as_constant(*part).is_some_and(|value| value.is_zero());
            let is_along_x = one[1..].iter().all(is_zero);
            return self.refuse(written.range, ValueFact::AlongItsAxis { name: mark.name.to_string(), is_along_x });
        }
        Some(Some(zero))
    }

    /// `(x, y, z)`
    pub(super) fn triple(&mut self, range: Range, items: &[ast::Expression], scope: &Scope) -> Option<Vector> {
        if items.len() != 3 {
            return self.refuse(range, ValueFact::NotThreeComponents { found: items.len(), meant: decimal_comma(items.iter()) });
        }
        let found: Vec<Option<Scalar>> = items.iter().map(|item| self.scalar(item, scope)).collect();
        let found: Option<Vec<Scalar>> = found.into_iter().collect();
        let found = found?;
        let mut measure = found[0].measure;
        for scalar in &found[1..] {
            match measure.common(scalar.measure) {
                Some(common) => measure = common,
                None => {
                    let (one, two) = (measure.settled(), scalar.measure.settled());
                    return self.refuse(range, ValueFact::Unlike { action: "make one vector of", one, two });
                }
            }
        }
        Some(Vector { parts: Components::space([found[0].expr, found[1].expr, found[2].expr]), measure })
    }

    /// Notes that a vector leads from one point to another.
    pub(super) fn note_difference(&mut self, parts: Components, from: Fixed, to: Fixed) {
        if let (Some(parts), Some(from), Some(to)) = (parts.in_space(), place(from), place(to)) {
            self.space.differences.insert(parts, (from, to));
            self.space.origins.insert(parts.to_vec(), Relationship::Coincident(from, to));
        }
    }

    /// A built-in function of space.
    pub(super) fn spatial_builtin(&mut self, name: &Ident, arguments: &[ast::Expression], scope: &Scope) -> Option<Value> {
        let word = name.to_string();
        let wanted = if word.ends_with("_axis") { 1 } else { 2 };
        if arguments.len() != wanted {
            return self.refuse(name, ArityFact::FunctionArity { name: word, wanted, found: arguments.len() });
        }
        let values: Option<Vec<Value>> = arguments.iter().map(|argument| self.value(argument, scope)).collect();
        let values = values?;
        let Some(axis) = self.as_axis(values[0].clone()) else {
            if let (Value::Scalar(_) | Value::Point(_) | Value::Vector(_), Some(_)) = (&values[0], self.as_axis(values[1 % wanted].clone()))
            {
                let call = format!("{word}({}, {})", arguments[1], arguments[0]);
                return self.refuse(arguments[0].range, ArityFact::FunctionOrder { name: word, call });
            }
            return self.not_a(arguments[0].range, Wanted::Axis, values[0].kind());
        };
        self.is_not_zero(arguments[0].range, &arguments[0], axis.local)?;
        let triad = self.triad(axis)?;
        match word.as_str() {
            "x_axis" | "y_axis" | "z_axis" => {
                let which = ["x_axis", "y_axis", "z_axis"].iter().position(|known| *known == word).unwrap_or(2);
                let local = Components::space(triad.axes[which]);
                Some(Value::Axis(Fixed { frame: axis.frame, local, measure: InferredDim::Known(Dim::NUMBER), zero: None }))
            }
            "turn" => {
                let angle = self.scalar_of(&arguments[1], Dim::ANGLE, scope)?.expr;
                Some(Value::Orientation([Rotation::Turn(Turn { body: triad.body, axis: triad.axes[2], angle })].into()))
            }
            "across" | "along" => {
                let second = values[1].clone();
                let other = self.as_axis(second.clone());
                let vector = self.vector_of(arguments[1].range, second, Wanted::Vector)?;
                if word == "along" { self.along(triad, vector).map(Value::Scalar) } else { self.across(triad, vector, other) }
            }
            _ => {
                let Some(other) = self.as_axis(values[1].clone()) else {
                    return self.not_a(arguments[1].range, Wanted::Axis, values[1].kind());
                };
                let other = self.triad(other)?;
                if word == "joint_angle" {
                    return Some(Value::Scalar(self.joint_angle(triad, other)));
                }
                Some(Value::Vector(self.misalignment(triad, other)))
            }
        }
    }

    /// An axis; a constant vector stands for a direction in ground.
    fn as_axis(&self, value: Value) -> Option<Fixed> {
        match value {
            Value::Axis(axis) => Some(axis),
            Value::Vector(Vector { parts, measure }) if parts.iter().all(|part| self.arena.is_fixed(*part)) => {
                Some(Fixed { frame: FrameId::GROUND, local: parts, measure, zero: None })
            }
            _ => None,
        }
    }

    /// The triad of an axis.
    fn triad(&mut self, axis: Fixed) -> Option<Triad> {
        let own = place(axis)?;
        let zero = axis.zero.and_then(Components::in_space);
        let known = self.space.triads.get(&(own, zero)).copied();
        let triad = known.unwrap_or_else(|| {
            let toward = zero.unwrap_or_else(|| self.some_direction_across(own.local));
            Triad::along(&mut self.arena, own, toward)
        });
        self.space.triads.insert((own, zero), triad);
        self.space.latest.insert(Place { body: triad.body, local: triad.axes[2] }, triad);
        Some(triad)
    }

    /// The axis of the frame that follows the one nearest to `axis`: x for z, y for x, z for y.
    fn some_direction_across(&mut self, axis: Triple) -> Triple {
        let values = self.numbers(&self.defaults, &axis);
        natural(&mut self.arena)[(longest(&values) + 1) % 3]
    }

    /// x · v and y · v
    fn across(&mut self, triad: Triad, vector: Vector, other: Option<Fixed>) -> Option<Value> {
        let [x, y, _] = triad.in_ground(&mut self.arena);
        let relation = match other {
            Some(other) => Some(Relationship::SameDirection(triad, self.triad(other)?)),
            None => {
                let difference = vector.parts.in_space().and_then(|parts| self.space.differences.get(&parts).copied());
                difference.map(|(from, to)| Relationship::OnLine(triad, from, to))
            }
        };
        // The direction of an axis is a unit vector.
        let (v, measure) = match relation {
            Some(Relationship::SameDirection(_, other)) => (other.in_ground(&mut self.arena)[2], InferredDim::Known(Dim::NUMBER)),
            _ => (vector.parts.in_space()?, vector.measure),
        };
        let rows = [dot(&mut self.arena, x, v), dot(&mut self.arena, y, v)];
        if let Some(relation) = relation {
            self.space.origins.insert(rows.to_vec(), relation);
        }
        Some(Value::Vector(Vector { parts: Components::plane(rows[0], rows[1]), measure }))
    }

    /// z · v
    fn along(&mut self, triad: Triad, vector: Vector) -> Option<Scalar> {
        let z = triad.in_ground(&mut self.arena)[2];
        let v = vector.parts.in_space()?;
        let value = dot(&mut self.arena, z, v);
        let expr = match self.space.differences.get(&v).copied() {
            Some((from, to)) => self.quantity(JointQuantity::Displacement(triad, from, to), |_, _| value),
            None => value,
        };
        Some(Scalar { expr, measure: vector.measure })
    }

    /// The angle of the second triad against the first, near the joint's own coordinate.
    fn joint_angle(&mut self, one: Triad, two: Triad) -> Scalar {
        let ([x, y, _], [other, _, _]) = (one.in_ground(&mut self.arena), two.in_ground(&mut self.arena));
        let bodies = self.names.frames.len() as u32 - 1;
        let expr = self.quantity(JointQuantity::Angle(one, two), |arena, number| {
            let near = arena.leaf(Leaf::Coordinate(DECLARED + Role::SPACE.len() as u32 * bodies + number));
            let (sine, cosine) = (dot(arena, y, other), dot(arena, x, other));
            angle_near(arena, near, sine, cosine)
        });
        Scalar { expr, measure: InferredDim::Known(Dim::ANGLE) }
    }

    /// The marked expression of a quantity.
    fn quantity(&mut self, quantity: JointQuantity, value: impl FnOnce(&mut crate::expr::Arena, u32) -> Expr) -> Expr {
        let known = &self.space.geometry.quantities;
        if let Some((_, expr)) = known.iter().find(|(known, _)| *known == quantity) {
            return *expr;
        }
        let number = known.len() as u32;
        let value = value(&mut self.arena, number);
        let expr = self.arena.build(Node::Marked { mark: Mark::OfJoint(number), value });
        self.space.geometry.quantities.push((quantity, expr));
        self.space.quantity_items.push(self.space.item.clone());
        expr
    }

    /// The angle or displacement of a joint that an expression is.
    pub(super) fn quantity_at(&self, expr: Expr) -> Option<JointQuantity> {
        self.space.geometry.quantities.iter().find(|(_, known)| *known == expr).map(|(quantity, _)| *quantity)
    }

    /// y_i · z_j, z_i · x_j and x_i · y_j, which vanish where the triads are equal.
    fn misalignment(&mut self, one: Triad, two: Triad) -> Vector {
        let ([xi, yi, zi], [xj, yj, zj]) = (one.in_ground(&mut self.arena), two.in_ground(&mut self.arena));
        let rows = [(yi, zj), (zi, xj), (xi, yj)].map(|(a, b)| dot(&mut self.arena, a, b));
        self.space.origins.insert(rows.to_vec(), Relationship::SameOrientation(one, two));
        Vector { parts: Components::space(rows), measure: InferredDim::Known(Dim::NUMBER) }
    }

    /// Notes that the product of two vectors fixed in bodies means something where it vanishes.
    pub(super) fn note_product(&mut self, product: Expr, one: Option<Fixed>, two: Option<Fixed>) {
        if let (Some(one), Some(two)) = (one.and_then(place), two.and_then(place)) {
            self.space.origins.insert(vec![product], Relationship::Perpendicular(one, two));
        }
    }

    /// The meanings of the rows of a joint.
    pub(super) fn note_relations(&mut self, joint: usize, rows: &[ScalarEquation]) {
        let exprs: Vec<Expr> = rows.iter().map(|row| row.residual.expr).collect();
        let mut at = 0;
        while at < exprs.len() {
            let found = (1..=3.min(exprs.len() - at)).rev().find_map(|length| self.space.origins.get(&exprs[at..at + length]).copied());
            if let Some(relation) = found {
                self.space.relate(joint, at, relation);
            }
            at += found.map_or(1, |relation| relation.rows());
        }
    }

    /// A quantity that a joint names with `let`.
    pub(super) fn quantity_of(&mut self, kind: &str, arguments: &Arguments, name: &str) -> Option<Value> {
        let definition = self.known_definition(kind).or_else(|| self.names.definition_at_home(kind).cloned())?;
        let mut scope = Scope { bound: arguments.to_vec(), ..Scope::default() };
        for statement in &definition.statements {
            if let Statement::Let(binding) = statement {
                let value = self.binding(binding, &scope)?;
                if binding.name == name {
                    return Some(value);
                }
                scope.bound.push((binding.name.to_string(), value));
            }
        }
        None
    }

    /// Evaluates an orientation that consists of turns alone.
    pub(super) fn turns(&mut self, written: &ast::Expression, place: &'static str, scope: &Scope) -> Option<Vec<Turn>> {
        let rotations = match self.value(written, scope)? {
            Value::Orientation(rotations) => rotations,
            other => match by_turns(written) {
                Some(instead) => return self.refuse(written.range, ValueFact::AnglesForOrientation { instead }),
                None => return self.not_a(written.range, Wanted::Orientation, other.kind()),
            },
        };
        let turns: Option<Vec<Turn>> = rotations.iter().map(|rotation| rotation.turn()).collect();
        turns.or_else(|| self.refuse(written.range, ValueFact::NotFixed { place }))
    }

    /// `body.orientation`
    pub(super) fn orientation_of(&self, frame: FrameId) -> Value {
        Value::Orientation(frame.body().map(Rotation::OfBody).into_iter().collect())
    }

    /// The rows that make two orientations equal.
    pub(super) fn between_orientations(&mut self, one: &[Rotation], two: &[Rotation]) -> Vector {
        let (parts, relation) = difference(&mut self.arena, one, two);
        self.space.origins.extend(relation.map(|relation| (parts.to_vec(), relation)));
        Vector { parts: Components::space(parts), measure: InferredDim::Known(Dim::ANGLE) }
    }

    /// A vector after an orientation.
    pub(super) fn oriented(&mut self, rotations: &[Rotation], vector: Vector) -> Option<Vector> {
        let [parts] = rotated(&mut self.arena, rotations, [vector.parts.in_space()?]);
        Some(Vector { parts: Components::space(parts), ..vector })
    }
}

fn place(fixed: Fixed) -> Option<Place> {
    Some(Place { body: fixed.frame.body(), local: fixed.local.in_space()? })
}
