//! Bodies and ground: coordinates, points and axes fixed in them, start values; start values of joints.

use super::elaborate::Elaborator;
use super::{Body, BodyCoordinate, Name, Requirement};
use crate::diag::{NameFact, Range, ValueFact};
use crate::expr::{Expr, Leaf};
use crate::geometry::{Components, JointQuantity, quaternion};
use crate::model::{DECLARED, JointStart};
use crate::names::{Context, EntityId, Fixed, FixedValue, FrameId, FrameScope, Key, Register, Scope, Value};
use crate::quantity::{Ambient, Dim, InferredDim, Role};
use crate::syntax::ast;
use crate::words::nearest;

impl Elaborator<'_> {
    /// Adds a frame with new coordinates.
    pub(super) fn new_frame(&mut self, name: &str) -> FrameId {
        let first = self.names.frames.last().map_or(0, |before| before.first + before.coordinates.len());
        let base = if self.names.ambient == Ambient::Space { DECLARED } else { 0 };
        let leaf = |(offset, role): (usize, &Role)| (*role, self.arena.leaf(Leaf::Coordinate(base + (first + offset) as u32)));
        let coordinates: Vec<(Role, Expr)> = self.names.ambient.coordinates().iter().enumerate().map(leaf).collect();
        if self.names.ambient == Ambient::Space {
            let quaternion: Vec<Expr> = coordinates[3..].iter().map(|(_, leaf)| *leaf).collect();
            let body = self.names.frames.len() as u32 - 1;
            self.declare_frame(body, &quaternion);
        }
        let space = self.names.new_space(format!("{name}."), None);
        self.names.frames.push(FrameScope { name: name.to_owned(), first, coordinates, space });
        FrameId(self.names.frames.len() - 1)
    }

    /// Resolves a point or an axis of a frame.
    pub(super) fn fixed(&mut self, frame: FrameId, mark: &ast::Shared<ast::Feature>, context: &Context) -> Option<Value> {
        let scope = Scope::of(context).timeless("a point or an axis").within(frame);
        let vector = if mark.is_axis { self.vector(&mark.value, &scope)? } else { self.location(&mark.value, &scope)? };
        let local = vector.parts;
        if !local.iter().all(|part| self.arena.is_fixed(*part)) {
            return self.refuse(mark.value.range, ValueFact::NotFixed { place: "a point or an axis" });
        }
        let noun = if mark.is_axis { "a component of the axis" } else { "a coordinate of the point" };
        for part in local.iter() {
            self.has_to_be_finite(*part, Key::Value(mark.id(), 0), mark.value.range, noun);
        }
        if mark.is_axis {
            self.is_not_zero(mark.value.range, &mark.name, local)?;
            let measure = InferredDim::Known(vector.measure.settled());
            let zero = self.zero_direction(mark, &scope, local)?;
            return Some(Value::Axis(Fixed { frame, local, measure, zero }));
        }
        Some(Value::Point(Fixed { frame, local, measure: InferredDim::Known(Dim::LENGTH), zero: None }))
    }

    /// Refuses the direction of an axis whose components are all zero.
    pub(super) fn is_not_zero(&mut self, range: Range, name: &dyn ToString, axis: Components) -> Option<()> {
        let is_zero = axis.iter().all(|part| self.arena.as_constant(*part).is_some_and(|value| value.is_zero()));
        let in_space = self.names.ambient == Ambient::Space;
        if is_zero { self.refuse(range, ValueFact::ZeroAxis { name: name.to_string(), in_space }) } else { Some(()) }
    }

    /// Records a value to be checked for finiteness once all defaults are known. Always returns true.
    fn has_to_be_finite(&mut self, expr: Expr, item: Key, range: Range, noun: &'static str) {
        if self.arena.as_constant(expr).is_none() && !self.names.is_abstract() && !self.is_unused {
            let place = self.place.clone();
            self.fixed_values.push(FixedValue { expr, item, range, noun, place });
        }
    }

    /// Resolves every point and axis, used or not; returns the local coordinates of the points.
    pub(super) fn marks(&mut self, register: &Register) -> Vec<Expr> {
        let mut lengths = Vec::new();
        for mark in &register.marks {
            let range = Range::from(&self.names.declared[mark.0].name);
            match self.entity(*mark, range) {
                Some(Value::Point(point)) => lengths.extend(point.local.iter().copied()),
                Some(Value::Axis(axis)) => self.has_direction(*mark, &axis),
                _ => {}
            }
        }
        lengths
    }

    /// Requires that an axis that depends on parameters does not vanish.
    fn has_direction(&mut self, mark: EntityId, axis: &Fixed) {
        if axis.local.iter().all(|part| self.arena.leaves(*part).is_empty()) {
            return;
        }
        let squares = axis.local.map(|part| self.arena.mul(part, part));
        let (lhs, rhs) = (self.arena.sum(&squares), self.arena.integer(0));
        let name = self.names.declared[mark.0].name.clone();
        let (joint, why) = (name.to_string(), "an axis of length zero has no direction".to_owned());
        let dim = match axis.measure {
            InferredDim::Known(dim) => dim.times(dim),
            _ => Dim::NUMBER,
        };
        self.requirements.push(Requirement { lhs, relation: ast::Relation::Greater, rhs, dim, joint, why });
        self.requirement_places.push((Range::from(&name), name));
    }

    /// Resolves all bodies with their coordinates and start values.
    pub(super) fn bodies(&mut self, register: &Register) -> Vec<Body> {
        let body = |(id, frame): &(EntityId, ast::Shared<ast::FrameItem>)| {
            self.resolved(*id, frame, |this, name, context| {
                let own = this.entity(*id, (&frame.name).into())?.frame()?;
                Some(this.body(frame, own, name, context))
            })
        };
        let mut bodies: Vec<Body> = register.bodies.iter().filter_map(body).collect();
        let mut next = 0;
        for body in &mut bodies {
            body.first = next;
            next += body.coordinates.len();
        }
        Name::tell_apart(bodies.iter_mut().map(|body| &mut body.name).collect());
        bodies
    }

    fn body(&mut self, frame: &ast::Shared<ast::FrameItem>, own: FrameId, name: &Name, context: &Context) -> Body {
        let ambient = self.names.ambient;
        let mut starts: Vec<Option<Expr>> = vec![None; ambient.coordinates().len()];
        let scope = Scope::of(context).timeless("a start value");
        for (number, start) in frame.starts.iter().enumerate() {
            let word = start.what.to_string();
            let place = |role: Role| ambient.coordinates().iter().position(|other| *other == role);
            let found: Option<Vec<(usize, Expr)>> = match ambient.coordinate(&word) {
                Some(role) => self.scalar_of(&start.value, role.dim(), &scope).and_then(|value| Some(vec![(place(role)?, value.expr)])),
                None if word == "position"
                    && ambient == Ambient::Plane
                    && matches!(&start.value.kind, ast::ExpressionKind::Tuple(items) if items.len() == 3) =>
                {
                    self.refuse(start.value.range, ValueFact::PoseAsPosition { written: start.value.to_string() })
                }
                None if word == "position" => {
                    self.location(&start.value, &scope).map(|vector| (0..).zip(vector.parts.iter().copied()).collect())
                }
                None if word == "orientation" && ambient == Ambient::Space => {
                    let turns = self.turns(&start.value, "a start value", &scope);
                    turns.map(|turns| (3..).zip(quaternion(&mut self.arena, &turns)).collect())
                }
                None => {
                    let near = nearest(&word, ambient.start_words());
                    let (name, value, body, in_space) =
                        (word.clone(), start.value.to_string(), name.to_string(), ambient == Ambient::Space);
                    self.refuse(&start.what, NameFact::UnknownStart { name, value, body, near, in_space })
                }
            };
            for (which, expr) in found.unwrap_or_default() {
                if !self.arena.is_fixed(expr) {
                    self.refuse::<()>(start.value.range, ValueFact::NotFixed { place: "a start value" });
                    continue;
                }
                self.has_to_be_finite(expr, Key::Value(frame.id(), number), start.value.range, "the start value");
                if starts[which].replace(expr).is_some() {
                    self.refuse::<()>(&start.what, NameFact::DuplicateStart { name: word.clone(), body: frame.name.to_string() });
                    break;
                }
            }
        }
        let coordinates = ambient.coordinates().iter().zip(starts).map(|(role, start)| BodyCoordinate { role: *role, start }).collect();
        let masses = self.mass(frame, &Scope::of(context).timeless("the mass of a body").within(own));
        Body { name: name.clone(), first: 0, coordinates, masses }
    }

    /// Declared starts of angles and displacements of joints.
    pub(super) fn joint_starts(&mut self, register: &Register) {
        for (start, context) in &register.starts {
            self.unless_refused(start, |this| this.joint_start(start, &Scope::of(context).timeless("a start value")));
        }
    }

    fn joint_start(&mut self, start: &ast::Shared<ast::StartItem>, scope: &Scope) -> Option<()> {
        let (range, ambient) = (start.quantity.range, self.names.ambient);
        let written = start.quantity.to_string();
        let (owner, word) = written.rsplit_once('.').unwrap_or(("", &written));
        let body = self.names.frames.iter().skip(1).find(|frame| frame.name == owner).map(|frame| frame.name.as_str());
        let body = body.or_else(|| self.names.moved_by(owner).filter(|_| ambient == Ambient::Plane)).map(str::to_owned);
        let is_owned = body.is_some() || (owner.is_empty() && word.len() > 1);
        let is_known = is_owned && (ambient.start_words().any(|known| known == word) || ["angle", "displacement"].contains(&&*written));
        let value = if ambient == Ambient::Plane || is_known { None } else { Some(self.value(&start.quantity, scope)?) };
        let Some(found) = value.and_then(|value| self.quantity_at(value.scalar()?.expr)) else {
            return self.refuse(range, ValueFact::NotAStart { written, body, ambient });
        };
        let dim = if matches!(found, JointQuantity::Angle(..)) { Dim::ANGLE } else { Dim::LENGTH };
        let value = self.scalar_of(&start.value, dim, scope)?.expr;
        if !self.arena.is_fixed(value) {
            return self.refuse(start.value.range, ValueFact::NotFixed { place: "a start value" });
        }
        self.has_to_be_finite(value, Key::Value(start.id(), 0), start.value.range, "the start value");
        if self.space.starts.iter().any(|known| known.quantity == found) {
            return self.refuse(range, NameFact::DuplicateStart { name: word.to_owned(), body: owner.to_owned() });
        }
        self.space.starts.push(JointStart { quantity: found, value, written, range });
        Some(())
    }
}
