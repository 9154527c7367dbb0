//! Evaluates expressions of the syntax tree to values in the arena, and checks their dimensions.

use super::{Components, Energy, Force, Function as Numbered, Mass, Name, Requirement};
use crate::diag::{ArrayFact, Diag, EquationFact, Fact, GrammarFact, Kind, Known, NameFact, Range, ValueFact, Wanted};
use crate::expr::{Arena, Exact, Expr, Leaf};
use crate::hints::{BareNumbers, noted};
use crate::names::{
    Fixed, FixedValue, FrameId, GroupId, HEIGHT, Instance, Key, Names, Notes, Scalar, Scope, Sort, SpaceId, Timeless, Value, Vector,
    misread_height, unknown_field,
};
use crate::quantity::{self, Ambient, Dim, InferredDim, Role};
use crate::syntax::ast::{self, ExpressionKind};
use crate::words::{is_synonym, nearest, nearest_unit};
use proc_macro2::Ident;
use std::collections::{BTreeMap, BTreeSet};

/// State while a mechanism or a definition is resolved.
pub(crate) struct Elaborator<'a> {
    pub(super) arena: Arena,
    pub(super) diag: &'a mut Diag,
    pub(super) names: Names,
    pub(super) functions: Vec<Numbered>,
    pub(super) requirements: Vec<Requirement>,
    /// For each requirement, the source range of its error, and the joint that states it.
    pub(super) requirement_places: Vec<(Range, Name)>,
    /// Definition being instantiated, and the token at which its errors are reported.
    pub(super) blame: Option<Instance>,
    /// Current nesting of values being evaluated.
    pub(super) depth: u16,
    /// Number of items so far, with loops unrolled and parts expanded, plus the number of loop iterations.
    pub(super) count: usize,
    /// Current item, if its declaration is expanded several times: ``in `leg[3].coupler` ``.
    pub(super) place: Option<String>,
    /// Declarations that were rejected; they are not checked again for other instances.
    pub(super) refused: BTreeSet<Key>,
    /// Values to check once all defaults are known, such as points and start values.
    pub(super) fixed_values: Vec<FixedValue>,
    /// True while a component without parts is checked: its arguments may be anything.
    pub(super) is_unused: bool,
    /// Values of functions of the language computed before, by function and argument.
    pub(super) calls: BTreeMap<(ast::ItemId, Expr), (ast::Shared<ast::FunctionItem>, Scalar)>,
    /// Defaults of the parameters, once they are known.
    pub(super) defaults: Vec<f64>,
    /// Names of inputs, by the numbers of their values among the parameters.
    pub(super) inputs: BTreeMap<u32, String>,
    /// Forces found so far, while a force is resolved.
    pub(super) applied: Option<Vec<Force>>,
    /// Masses that joints and forces add, with their bodies.
    pub(super) added: Vec<(usize, Mass)>,
    /// Potential energies.
    pub(super) energies: Vec<Energy>,
    /// Relations of joints in space.
    pub(super) space: Notes,
    /// Numbers that are written without a unit, and the longest length with one.
    pub(super) bare: BareNumbers,
    /// The last expression in which a declared name stands like a unit, that name, and the number with the unit.
    pub(super) declared_unit: Option<(Range, String, String)>,
    /// True if rows that always depend on others will be refused, so that a better reason may be given before.
    pub(super) judges_rows: bool,
}

/// Largest nesting of values: a longer chain of names that are used before they are declared could exhaust the stack.
const DEEPEST: u16 = 400;

/// After this many errors mistyped names get no more suggestions.
const SUGGESTIONS: usize = 100;

/// Largest number of operations: a mechanism with more does not compile in reasonable time.
const LARGEST: usize = 200_000;

impl Elaborator<'_> {
    /// Creates an elaborator without expressions.
    pub(super) fn new(diag: &mut Diag, names: Names) -> Elaborator<'_> {
        Elaborator {
            arena: Arena::new(),
            diag,
            names,
            functions: Vec::new(),
            requirements: Vec::new(),
            requirement_places: Vec::new(),
            blame: None,
            depth: 0,
            count: 0,
            place: None,
            refused: BTreeSet::new(),
            fixed_values: Vec::new(),
            is_unused: false,
            calls: BTreeMap::new(),
            defaults: Vec::new(),
            inputs: BTreeMap::new(),
            applied: None,
            added: Vec::new(),
            energies: Vec::new(),
            space: Notes::default(),
            bare: BareNumbers::default(),
            declared_unit: None,
            judges_rows: false,
        }
    }

    /// Reports an error. Inside a definition that is being instantiated it is reported at the joint that uses the definition.
    pub(super) fn refuse<T>(&mut self, range: impl Into<Range>, fact: impl Into<Fact>) -> Option<T> {
        let fact = fact.into();
        let (range, fact) = match self.blame.clone() {
            None => (range.into(), fact),
            Some(Instance { place, definition, quantities }) => {
                (place, Fact::InDefinition { definition, quantities, fact: Box::new(fact) })
            }
        };
        self.refuse_here(range, fact)
    }

    /// Reports an error at this very range, and names the current item if its declaration is expanded several times.
    pub(super) fn refuse_here<T>(&mut self, range: impl Into<Range>, fact: impl Into<Fact>) -> Option<T> {
        let fact = fact.into();
        let fact = match &self.place {
            Some(place) => Fact::InInstance { place: place.clone(), fact: Box::new(fact) },
            None => fact,
        };
        self.diag.refuse(range, fact)
    }

    /// Evaluates an expression. An array without all its indices is an error.
    pub(super) fn value(&mut self, expr: &ast::Expression, scope: &Scope) -> Option<Value> {
        match self.value_or_array(expr, scope)? {
            Value::Array { group, at } => {
                let name = self.names.member_name(group, &at);
                let index = scope.index(&self.arena).unwrap_or("0").to_owned();
                self.refuse(expr.range, ArrayFact::ArrayWithoutIndex { name, index })
            }
            value => Some(value),
        }
    }

    /// Evaluates an expression, which may be an array without all its indices.
    pub(super) fn value_or_array(&mut self, expr: &ast::Expression, scope: &Scope) -> Option<Value> {
        let in_function = !self.names.open_functions.is_empty();
        if self.depth >= DEEPEST {
            return self.give_up(expr.range, GrammarFact::LongChain { limit: DEEPEST, in_function });
        }
        if self.arena.len() > LARGEST {
            return self.give_up(expr.range, ValueFact::TooLarge { limit: LARGEST, in_function });
        }
        self.depth += 1;
        let value = self.value_of(expr, scope);
        self.depth -= 1;
        value.map(|value| value.inside(scope.body))
    }

    /// Reports that a limit is exceeded, and suppresses all errors after it.
    pub(super) fn give_up<T>(&mut self, range: impl Into<Range>, fact: impl Into<Fact>) -> Option<T> {
        self.refuse::<()>(range, fact);
        self.diag.exhaust();
        None
    }

    fn value_of(&mut self, expr: &ast::Expression, scope: &Scope) -> Option<Value> {
        match &expr.kind {
            ExpressionKind::Number { digits, unit } => self.number(expr.range, digits, unit).map(Value::Scalar),
            ExpressionKind::Path(path) => self.named(path, scope),
            ExpressionKind::Field(value, field) => self.field(value, field, scope),
            ExpressionKind::Index(value, index) => self.indexed(value, index, scope),
            ExpressionKind::Call(path, arguments) => self.call(expr.range, path, arguments, scope),
            ExpressionKind::Negative(value) => self.negative(value, scope),
            ExpressionKind::Binary(..) if self.unit_of_parts(expr, scope).is_some() => {
                let instead = self.unit_of_parts(expr, scope)?;
                self.refuse(expr.range, NameFact::UnitInParts { written: expr.to_string(), instead })
            }
            ExpressionKind::Binary(operator, lhs, rhs) => self.binary(expr.range, *operator, lhs, rhs, scope),
            ExpressionKind::Tuple(items) => self.tuple(expr.range, items, scope).map(Value::Vector),
            ExpressionKind::List(_) => self.refuse(expr.range, ValueFact::ListOutsideTable),
            ExpressionKind::If { lhs, relation, rhs, then, otherwise } => {
                self.choice(expr.range, (lhs, *relation, rhs), (then, otherwise), scope)
            }
        }
    }

    /// Evaluates an expression that must be a number.
    pub(super) fn scalar(&mut self, expr: &ast::Expression, scope: &Scope) -> Option<Scalar> {
        match self.value(expr, scope)? {
            Value::Scalar(scalar) => Some(scalar),
            other => match misread_height(self.names.ambient, expr, &other) {
                Some(fact) => self.refuse(expr.range, fact),
                None => self.not_a(expr.range, Wanted::Number, other.kind()),
            },
        }
    }

    /// Evaluates a number that must have the dimension `wanted`.
    pub(super) fn scalar_of(&mut self, expr: &ast::Expression, wanted: Dim, scope: &Scope) -> Option<Scalar> {
        let scalar = self.scalar(expr, scope)?;
        self.note_bare(expr, wanted);
        if !scalar.measure.fits(wanted) {
            let found = scalar.measure.settled();
            let written = (found == Dim::NUMBER).then_some((expr, wanted));
            let fact = noted(&self.declared_unit, ValueFact::WrongDimension { wanted, found }, expr.range, written);
            return self.refuse(expr.range, fact);
        }
        Some(Scalar { measure: InferredDim::Known(wanted), ..scalar })
    }

    /// Records a number without a unit. Those in definitions are not the mistakes of the mechanism that uses them.
    pub(super) fn note_bare(&mut self, written: &ast::Expression, wanted: Dim) {
        if self.blame.is_none() {
            self.bare.note(written, wanted);
        }
    }

    /// Records a number without a unit that is added to, compared with or equated with another.
    pub(super) fn note_beside(&mut self, sides: [(&ast::Expression, Scalar); 2]) {
        match sides.map(|(written, scalar)| (written, scalar.measure)) {
            [(_, InferredDim::Known(dim)), (bare, InferredDim::Any)] | [(bare, InferredDim::Any), (_, InferredDim::Known(dim))] => {
                self.note_bare(bare, dim);
            }
            _ => {}
        }
    }

    /// Evaluates a vector in ground; a point stands for its position and an axis for its direction.
    pub(super) fn vector(&mut self, expr: &ast::Expression, scope: &Scope) -> Option<Vector> {
        let value = self.value(expr, scope)?;
        self.vector_of(expr.range, value, Wanted::VectorOrPoint)
    }

    /// Converts a value to a vector, where `wanted` is.
    pub(super) fn vector_of(&mut self, range: Range, value: Value, wanted: Wanted) -> Option<Vector> {
        let found = value.kind();
        match self.as_vector(value) {
            Some(vector) => Some(vector),
            None => self.not_a(range, wanted, found),
        }
    }

    /// Refuses a value of another kind than `wanted`.
    pub(super) fn not_a<T>(&mut self, range: Range, wanted: Wanted, found: Kind) -> Option<T> {
        let ambient = self.names.ambient;
        self.refuse(range, ValueFact::NotA { wanted, found, ambient })
    }

    /// Converts a value to a vector; a point becomes its position, an axis its direction.
    pub(super) fn as_vector(&mut self, value: Value) -> Option<Vector> {
        match value {
            Value::Vector(vector) => Some(vector),
            Value::Point(point) => Some(self.place(point)),
            Value::Axis(axis) => Some(self.direction(axis)),
            _ => None,
        }
    }

    /// r_P = r + A(φ) s'
    fn place(&mut self, point: Fixed) -> Vector {
        let turned = self.direction(point);
        let coordinates = &self.names.frames[point.frame.0].coordinates;
        let origin: Vec<Expr> = coordinates.iter().filter(|(role, _)| role.is_position()).map(|(_, expr)| *expr).collect();
        let Some(origin) = Components::new(&origin) else { return turned };
        Vector { parts: origin.zip(turned.parts, |origin, part| self.arena.add(origin, part)), measure: point.measure }
    }

    /// A(φ) s', A = [cos −sin; sin cos]
    pub(super) fn direction(&mut self, axis: Fixed) -> Vector {
        if self.names.ambient == Ambient::Space {
            return Vector { parts: self.turned(axis), measure: axis.measure };
        }
        let (Some([sx, sy]), Some(angle)) = (axis.local.in_plane(), self.coordinate(axis.frame, Role::Angle)) else {
            return Vector { parts: axis.local, measure: axis.measure };
        };
        let arena = &mut self.arena;
        let (sine, cosine) = (arena.sin(angle), arena.cos(angle));
        let (cx, sy_) = (arena.mul(cosine, sx), arena.mul(sine, sy));
        let (sx_, cy) = (arena.mul(sine, sx), arena.mul(cosine, sy));
        Vector { parts: Components::plane(arena.sub(cx, sy_), arena.add(sx_, cy)), measure: axis.measure }
    }

    /// Coordinate of a body; `None` for ground.
    fn coordinate(&self, frame: FrameId, role: Role) -> Option<Expr> {
        self.names.frames[frame.0].coordinates.iter().find(|(other, _)| *other == role).map(|(_, expr)| *expr)
    }

    fn number(&mut self, range: Range, digits: &str, unit: &str) -> Option<Scalar> {
        let (size, measure) = match quantity::unit(unit) {
            Some((size, dim)) => (size, InferredDim::Known(dim)),
            None if unit.is_empty() => (Exact::ONE, InferredDim::Any),
            None if self.names.find(SpaceId::MECHANISM, unit).is_some() => {
                let (flaw, instead) = ("an operator is missing between a number and a name", format!("{digits} * {unit}"));
                return self.refuse(range, GrammarFact::Misspelt { flaw, instead });
            }
            None => {
                let near = nearest_unit(unit);
                return self.refuse(range, NameFact::UnknownUnit { number: digits.to_owned(), name: unit.to_owned(), near });
            }
        };
        match Exact::measured(digits, size) {
            Some(value) if measure == InferredDim::Known(Dim::LENGTH) => {
                self.bare.longest = self.bare.longest.max(value.to_f64().abs());
                Some(Scalar { expr: self.arena.constant(value), measure })
            }
            Some(value) => Some(Scalar { expr: self.arena.constant(value), measure }),
            None => self.refuse(range, ValueFact::NumberOutOfRange { number: format!("{digits}{unit}") }),
        }
    }

    fn named(&mut self, path: &ast::Path, scope: &Scope) -> Option<Value> {
        let Some(name) = &path.name else {
            // A path of several segments is a Rust function, whose dimensions follow from its use.
            return Some(Value::Function(self.rust_function(path, InferredDim::Any, InferredDim::Any)));
        };
        if let Some(value) = scope.value_of(name) {
            return Some(value.clone());
        }
        if self.names.misused.contains(&name.to_string()) {
            return None;
        }
        if name == "pi" {
            return Some(Value::Scalar(Scalar { expr: self.arena.constant(Exact::PI), measure: InferredDim::Any }));
        }
        if name == "ground" {
            return Some(Value::Body(FrameId::GROUND));
        }
        if let Some(space) = scope.space {
            if name == "t" {
                return self.time(path.range, scope);
            }
            if let Some((own, group)) = self.names.own_mark(scope, &name.to_string()) {
                return self.visible(path.range, group, own);
            }
            if let Some(group) = self.names.visible(space, &name.to_string()) {
                self.input_may_stand(group, path.range, scope)?;
                return self.visible(path.range, group, space);
            }
        } else if name == "t" {
            return self.refuse(path.range, EquationFact::TimeInDefinition);
        }
        if self.is_library_function(name) {
            return self.library_function(name).map(Value::Function);
        }
        if scope.space.is_some_and(|space| self.names.outputs.contains(&(space, name.to_string()))) {
            return self.refuse(path.range, NameFact::OutputRead { name: name.to_string() });
        }
        if scope.body.is_some()
            && let Some(name) = self.names.mark_called(name)
        {
            return self.refuse(path.range, NameFact::PointInBody { name });
        }
        let near = self.similar(name, scope);
        // A shorter name is no likelier than a unit: `m` resembles `mm`.
        if near.as_ref().is_none_or(|near| near.len() < name.to_string().len()) && quantity::unit(&name.to_string()).is_some() {
            return self.refuse(path.range, NameFact::UnitAlone { name: name.to_string() });
        }
        self.refuse(path.range, NameFact::UnknownName { name: name.to_string(), near, is_of_definition: scope.space.is_none() })
    }

    fn time(&mut self, range: Range, scope: &Scope) -> Option<Value> {
        match &scope.timeless {
            Some(Timeless::Place(place)) => return self.refuse(range, EquationFact::TimeIn { place }),
            Some(Timeless::Joint { name, has_places }) => {
                return self.refuse(range, EquationFact::TimeInJoint { joint: name.clone(), has_places: *has_places });
            }
            None => {}
        }
        Some(Value::Scalar(Scalar { expr: self.arena.leaf(Leaf::Time), measure: InferredDim::Known(Dim::TIME) }))
    }

    /// Refuses an input where `t` is refused.
    fn input_may_stand(&mut self, group: GroupId, range: Range, scope: &Scope) -> Option<()> {
        let (word, is_input) = (self.names.group(group).word.clone(), self.names.group(group).sort == Sort::Input);
        match &scope.timeless {
            Some(Timeless::Place(place)) if is_input => self.refuse(range, EquationFact::InputIn { place, input: word }),
            Some(Timeless::Joint { name, .. }) if is_input => {
                self.refuse(range, EquationFact::InputInJoint { joint: name.clone(), input: word })
            }
            _ => Some(()),
        }
    }

    /// Name of the input that an expression contains, if any.
    pub(super) fn input_in(&self, expr: Expr) -> Option<String> {
        self.arena.leaves(expr).into_iter().find_map(|leaf| match leaf {
            Leaf::Input { number, .. } => self.inputs.get(&number).cloned(),
            _ => None,
        })
    }

    /// Known name nearest to a mistyped one; `None` after too many errors.
    pub(super) fn nearest<'n>(&self, typed: &str, known: impl Iterator<Item = &'n str>) -> Option<String> {
        if self.diag.refusals().len() < SUGGESTIONS { nearest(typed, known) } else { None }
    }

    /// Visible name nearest to a mistyped one.
    fn similar(&self, name: &Ident, scope: &Scope) -> Option<String> {
        let own = scope.space.into_iter().flat_map(|space| self.names.all(space));
        let bound = scope.bound.iter().map(|(known, _)| known.as_str());
        let fixed = ["t", "pi", "ground"].into_iter();
        if scope.space == Some(SpaceId::MECHANISM)
            && let Some(full) = self.names.mark_called(name)
        {
            return Some(full);
        }
        self.nearest(&name.to_string(), bound.chain(own).chain(fixed))
    }

    fn field(&mut self, owner: &ast::Expression, field: &Ident, scope: &Scope) -> Option<Value> {
        if let ExpressionKind::Number { digits, unit } = &owner.kind
            && quantity::unit(&format!("{unit}{field}")).is_some()
        {
            let (written, instead) = (format!("{digits}{unit}.{field}"), format!("{digits}{unit}{field}"));
            return self.refuse(owner.range.to(field), NameFact::UnitInParts { written, instead });
        }
        let value = self.value(owner, scope)?;
        let name = field.to_string();
        match (&value, name.as_str()) {
            (Value::Body(frame), _) => return self.body_field(*frame, field),
            (Value::Part(space), _) => return self.part_field(*space, field),
            (Value::Point(fixed) | Value::Axis(fixed), "body") => return Some(Value::Body(fixed.frame)),
            (Value::Joint { kind, arguments }, _) => {
                if let Some((_, argument)) = arguments.iter().find(|(known, _)| *known == name) {
                    return Some(argument.clone());
                }
                let (kind, arguments) = (kind.clone(), arguments.clone());
                if let Some(value) = self.quantity_of(&kind, &arguments, &name) {
                    return Some(value);
                }
                let mut words: Vec<&str> = arguments.iter().map(|(known, _)| known.as_str()).collect();
                words.extend(
                    ["angle", "displacement", "angle_a", "angle_b", "x", "y"]
                        .into_iter()
                        .filter(|word| self.quantity_of(&kind, &arguments, word).is_some()),
                );
                let near = self.nearest(&name, words.iter().copied());
                let near = near.or_else(|| self.names.of_bodies(&name, &owner.to_string(), &arguments));
                let known = Known::of(words.iter().copied());
                return self.refuse(field, NameFact::UnknownField { owner: crate::library::described(&kind), name, near, known });
            }
            _ if self.names.ambient.component(&name).is_some() => {}
            _ => return self.refuse(field, unknown_field(&value, name, owner, self.names.ambient)),
        }
        let unknown = unknown_field(&value, name.clone(), owner, self.names.ambient);
        let Some(vector) = self.as_vector(value) else {
            return self.refuse(field, unknown);
        };
        let expr = *vector.parts.get(self.names.ambient.component(&name)?)?;
        Some(Value::Scalar(Scalar { expr, measure: vector.measure }))
    }

    fn body_field(&mut self, frame: FrameId, field: &Ident) -> Option<Value> {
        let zero = self.arena.integer(0);
        let name = field.to_string();
        // In space axes may be called x, y and z.
        let own = self.names.find(self.names.frames[frame.0].space, &name).filter(|_| self.names.ambient == Ambient::Space);
        if let Some(group) = own {
            return self.of_group(group, field);
        }
        match self.names.ambient.coordinate(&name) {
            _ if self.names.misused.contains(&format!("{}.{name}", self.names.frames[frame.0].name)) => None,
            Some(role) => {
                let expr = self.coordinate(frame, role).unwrap_or(zero);
                Some(Value::Scalar(Scalar { expr, measure: InferredDim::Known(role.dim()) }))
            }
            None if name == "position" => {
                let local = Components::plane(zero, zero).resized(self.names.ambient.components());
                Some(Value::Point(Fixed { frame, local, measure: InferredDim::Known(Dim::LENGTH), zero: None }))
            }
            None if name == "angular_velocity" => Some(self.angular_velocity(frame)),
            None if name == "orientation" && self.names.ambient == Ambient::Space => Some(self.orientation_of(frame)),
            None if name == "angle" && self.names.find(self.names.frames[frame.0].space, &name).is_none() => {
                let (body, joint) = (self.names.frames[frame.0].name.clone(), self.hinge_of(frame));
                self.refuse(field, NameFact::AngleOfBody { body, joint })
            }
            None => {
                let space = self.names.frames[frame.0].space;
                if let Some(group) = self.names.find(space, &name) {
                    return self.of_group(group, field);
                }
                if name == HEIGHT {
                    let owner = format!("`{}`", self.names.frames[frame.0].name);
                    return self.refuse(field, NameFact::NoHeight { owner, is_axis: false });
                }
                let (axes, others): (Vec<Role>, Vec<Role>) = self.names.ambient.named().partition(|role| role.is_position());
                let own: Vec<&str> = self.names.words(space).collect();
                // In space an axis may be called like a coordinate.
                let words = others.into_iter().chain(axes).map(Role::name).filter(|word| !own.contains(word));
                let words: Vec<&str> =
                    words.chain(["angular_velocity"]).chain((self.names.ambient == Ambient::Space).then_some("orientation")).collect();
                let known = || own.iter().copied().chain(["position"]).chain(words.iter().copied());
                let rate = || is_synonym("rate", &name).then(|| format!("rate({}.position)", self.names.frames[frame.0].name));
                let (near, known) = (rate().or_else(|| self.nearest(&name, known())), Known::of(known()));
                let owner = format!("`{}`", self.names.frames[frame.0].name);
                self.refuse(field, NameFact::UnknownField { owner, name, near, known })
            }
        }
    }

    /// True if the expression contains no coordinate.
    pub(super) fn is_still(&self, expr: Expr) -> bool {
        !self.arena.leaves(expr).iter().any(|leaf| matches!(leaf, Leaf::Coordinate(_)))
    }
}
