//! The resolved mechanism: bodies, joints, outputs and parameters, with names replaced by ids.
//!
//! Data types only: `resolve` builds them.

pub(crate) mod example;
mod layout;
mod mass;
mod name;
mod neglected;
pub mod sketch;
mod solid;

pub use crate::expr::spline::{Ends, Table};
pub use crate::geometry::{Components, Facing, Geometry, JointQuantity, Place, Relationship, Triad};
pub use layout::{Component, Field, Layout, Of, Part};
pub use mass::Mass;
pub use name::Name;
pub(crate) use name::Said;
pub use sketch::Sketch;
pub use solid::Solid;

use crate::diag::{Range, Warning};
use crate::expr::{Arena, Expr, Leaf, Values, evaluate};
use crate::quantity::{Ambient, Dim, Role, SpeedRole};
use crate::syntax::ast::{Closing, Docs, Following, Relation, Requests, Task};
use proc_macro2::{Ident, TokenStream};
use std::collections::BTreeSet;

/// Number of the first declared coordinate in space. Coordinates of the solution are different ones, numbered from 0.
pub(crate) const DECLARED: u32 = 1 << 24;

/// Number of a declared coordinate of a body in space.
pub(crate) fn declared_coordinate(body: usize, at: usize) -> u32 {
    DECLARED + (Role::SPACE.len() * body + at) as u32
}

/// Number of a declared speed of a body in space.
pub(crate) fn declared_speed(body: usize, at: usize) -> u32 {
    DECLARED + (Ambient::Space.first_speed(body) + at) as u32
}

/// Numbers of the declared angular speeds of a body in space.
pub(crate) fn declared_angular(body: usize) -> [u32; 3] {
    SpeedRole::angular(body).map(|speed| DECLARED + speed as u32)
}

/// The speed equal to the rate of each declared coordinate in space. Components of orientations have no such speed: vectors fixed in a
/// body are differentiated as a whole.
pub(crate) fn declared_rates(coordinates: usize) -> Vec<Option<u32>> {
    let each = Role::SPACE.len();
    let rate = |number: usize| {
        let (body, at) = (number / each, number % each);
        Role::SPACE[at].is_position().then(|| declared_speed(body, at))
    };
    (0..coordinates).map(rate).collect()
}

/// A mechanism with all names resolved.
#[derive(Clone, Debug)]
pub struct Model {
    /// All expressions.
    pub arena: Arena,
    /// Doc attributes of the generated struct.
    pub docs: Docs,
    /// Visibility, such as `pub`.
    pub visibility: TokenStream,
    /// Name of the generated struct.
    pub name: Ident,
    /// Motion in the plane or in space.
    pub ambient: Ambient,
    /// Relations between bodies that joints in space impose.
    pub space: Geometry,
    /// For each angle and displacement of joints, the item that names it first.
    pub quantity_items: Vec<Option<Name>>,
    /// Declared starts of angles and displacements of joints.
    pub starts: Vec<JointStart>,
    /// Task of the generated code.
    pub task: Task,
    /// Policy if the mechanism does not assemble at the declared defaults.
    pub closing: Closing,
    /// True if an assembly far from the declared start causes no warning.
    pub allows_far_start: bool,
    /// True if constraints are imported with `use`; a stub of the type is emitted as well, in case one of them is not a constraint.
    pub has_stub: bool,
    /// Policy for following the motion from the start.
    pub following: Following,
    /// Code that is generated on request.
    pub requests: Requests,
    /// Declared range of time, if any.
    pub range: Option<Times>,
    /// Composition of the mechanism and its components.
    pub layout: Layout,
    /// The fields of the generated structs.
    pub parameters: Vec<Parameter>,
    /// The moving bodies, in the order declared.
    pub bodies: Vec<Body>,
    /// Local coordinates of all points, from which a characteristic length is taken.
    pub lengths: Vec<Expr>,
    /// Joints and drives, in the order declared, and after them the freedoms.
    pub joints: Vec<Joint>,
    /// Forces and torques on bodies, in the order of the declared forces.
    pub forces: Vec<Force>,
    /// Declared forces.
    pub declared_forces: Vec<DeclaredForce>,
    /// Potential energies, declared and of forces.
    pub energies: Vec<Energy>,
    /// Acceleration of free fall, by components in ground.
    pub gravity: Option<Vec<Expr>>,
    /// Named outputs, in the order declared.
    pub outputs: Vec<Output>,
    /// Generated methods that return the outputs.
    pub methods: Vec<Method>,
    /// Functions that the arena refers to by number.
    pub functions: Vec<Function>,
    /// Conditions on parameters.
    pub requirements: Vec<Requirement>,
    /// Geometry for the picture.
    pub sketch: Sketch,
    /// Warnings about numbers whose unit may be missing.
    pub doubts: Vec<Warning>,
}

impl Model {
    /// Inputs and their rates, by number and order, with the values at the start.
    pub(crate) fn inputs(&self) -> impl Iterator<Item = (u32, u8, Expr)> {
        let holds_inputs = |component: &Component| component.fields.iter().any(|field| field.of == Of::Input);
        let component = self.layout.components.iter().position(holds_inputs);
        let parts = component.into_iter().flat_map(|component| self.layout.parts.iter().filter(move |part| part.component == component));
        let values = parts.flat_map(|part| part.members.iter().flatten());
        values.flat_map(move |first| {
            (0..=Leaf::HIGHEST_RATE).map(move |order| (*first as u32, order, self.parameters[first + usize::from(order)].default))
        })
    }

    /// True if states hold the inputs that they were solved for.
    pub(crate) fn holds_inputs(&self) -> bool {
        self.task.is_solved() && self.inputs().next().is_some()
    }

    /// The numbers of the parameters that belong to inputs.
    pub(crate) fn of_inputs(&self) -> BTreeSet<usize> {
        self.inputs().map(|(number, order, _)| number as usize + usize::from(order)).collect()
    }
}

/// A field of the generated struct.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name.
    pub name: Name,
    /// Dimension.
    pub dim: Dim,
    /// Default value, a constant.
    pub default: Expr,
    /// The default as written: `45 rpm`; in SI where it is more than a number with a unit.
    pub written: String,
    /// Declared range, if any.
    pub bounds: Option<Bounds>,
}

/// Declared start of an angle or a displacement of a joint in space.
#[derive(Clone, Debug)]
pub struct JointStart {
    /// The angle or displacement.
    pub quantity: JointQuantity,
    /// Value, a function of parameters.
    pub value: Expr,
    /// As written: `hinge.angle`.
    pub written: String,
    /// Where it is written.
    pub range: Range,
}

/// Declared range of a parameter, in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// Lower bound.
    pub from: Option<f64>,
    /// Upper bound.
    pub to: Option<f64>,
    /// True if the upper bound belongs to the range.
    pub is_inclusive: bool,
    /// As written: `5 mm ..= 50 mm`.
    pub text: String,
}

impl Bounds {
    /// True if `value` lies within the bounds.
    #[must_use]
    pub fn hold(&self, value: f64) -> bool {
        let is_below = |to: f64| if self.is_inclusive { value <= to } else { value < to };
        self.from.is_none_or(|from| from <= value) && self.to.is_none_or(is_below)
    }
}

/// Range of time of a mechanism, in s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// Start.
    pub from: f64,
    /// End.
    pub to: f64,
}

/// A moving body: a list of coordinates with a kind.
#[derive(Clone, Debug)]
pub struct Body {
    /// Name.
    pub name: Name,
    /// Index in q of the first coordinate.
    pub first: usize,
    /// Coordinates, in their order in q.
    pub coordinates: Vec<BodyCoordinate>,
    /// Masses fixed in it, each with a centre of its own; none if nothing is declared.
    pub masses: Vec<Mass>,
}

/// A force as declared: a list of forces at points and torques on bodies.
#[derive(Clone, Debug)]
pub struct DeclaredForce {
    /// Name.
    pub name: Name,
    /// It can be computed alone: declared as `slice force`.
    pub is_slice: bool,
}

/// A potential energy.
#[derive(Clone, Copy, Debug)]
pub struct Energy {
    /// Its value.
    pub value: Expr,
    /// Its rate if a declared force has it; `None` if its force is minus its gradient.
    pub rate: Option<Expr>,
}

/// A force at a point of a body, or a torque on it.
#[derive(Clone, Debug)]
pub struct Force {
    /// Index of the declared force that it belongs to.
    pub of: usize,
    /// Index of the body; `None` for ground.
    pub body: Option<usize>,
    /// Local components of the point; `None` for a torque.
    pub point: Option<Vec<Expr>>,
    /// Components in ground; in the plane a torque has one.
    pub parts: Vec<Expr>,
}

/// One coordinate of a body.
#[derive(Clone, Debug)]
pub struct BodyCoordinate {
    /// Role in the placement of the body.
    pub role: Role,
    /// Declared start value, a function of parameters.
    pub start: Option<Expr>,
}

/// Initial value of a freedom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Freedom {
    /// True if it is the value at the declared start, which the residuals do not contain.
    pub is_from_start: bool,
}

/// A joint, a drive or a freedom: residuals that must vanish.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Name.
    pub name: Name,
    /// Name of the constraint; `equation` for inline equations.
    pub kind: String,
    /// True if declared by `drive` or `freedom`.
    pub is_drive: bool,
    /// True if declared by `redundant joint`: equations that follow from others are checked instead of solved.
    pub is_redundant: bool,
    /// For a freedom, its initial value; the residuals of a freedom hold at t = 0 only.
    pub freedom: Option<Freedom>,
    /// Left minus right side of each scalar equation.
    pub residuals: Vec<Residual>,
    /// Its load can be computed alone: declared as `slice joint` or `slice drive`.
    pub is_slice: bool,
    /// Where `#[velocity]` stands, if its equations of velocities are not to be integrated.
    pub velocity: Option<Range>,
    /// Body on which the load of the joint acts, and the local components of the point of application.
    pub place: Option<(usize, Vec<Expr>)>,
}

impl Joint {
    /// True for a drive, false for a freedom.
    pub(crate) fn is_driven(&self) -> bool {
        self.is_drive && self.freedom.is_none()
    }
}

/// Left minus right side of one scalar equation.
#[derive(Clone, Copy, Debug)]
pub struct Residual {
    /// Value.
    pub expr: Expr,
    /// Dimension; for a row of velocities, dimension of its integral.
    pub dim: Dim,
    /// True if it contains speeds: a row of velocities.
    pub is_velocity: bool,
}

/// A named output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name.
    pub name: Name,
    /// Index of the body, if the output is a whole body.
    pub body: Option<usize>,
    /// One component for a number, two for a vector or a point, none for a body.
    pub components: Vec<Expr>,
    /// Dimension.
    pub dim: Dim,
    /// Number of its derivatives by time that are given: 2, 1 if the output contains velocities, 3 if it is declared with jerk.
    pub derivatives: usize,
}

/// A generated method: one output, or an array of them.
#[derive(Clone, Debug)]
pub struct Method {
    /// Name; for an output of a part it begins with the name of the part.
    pub name: Ident,
    /// Doc attributes.
    pub docs: Docs,
    /// Size for each index; empty for a single output.
    pub sizes: Vec<usize>,
    /// The outputs by number; the last index varies fastest.
    pub members: Vec<usize>,
    /// True if one of the outputs is declared as `slice output` and can be solved for alone.
    pub is_slice: bool,
}

/// A function of one variable with its first two derivatives.
#[derive(Clone, Debug)]
pub enum Function {
    /// A Rust function, by its path as written.
    Rust(TokenStream),
    /// A cubic spline.
    Table(Table),
}

/// Value and derivatives of the function with a number. Tables are evaluated; Rust functions are unknown to the compiler and return NaN, so
/// that their rows are left out.
pub(crate) fn tabulated(functions: &[Function], number: u32, x: f64) -> [f64; 3] {
    match functions.get(number as usize) {
        Some(Function::Table(table)) => table.evaluate(x),
        _ => [f64::NAN; 3],
    }
}

/// Defaults of the parameters.
pub(crate) fn defaults(model: &Model, arena: &Arena) -> Vec<f64> {
    let defaults: Vec<Expr> = model.parameters.iter().map(|parameter| parameter.default).collect();
    let functions = |number: u32, x: f64| tabulated(&model.functions, number, x);
    let nothing = Values { time: 0.0, parameters: &[], coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
    evaluate(arena, &defaults, &nothing)
}

/// A condition on parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Requirement {
    /// Left side.
    pub lhs: Expr,
    /// Relation that must hold.
    pub relation: Relation,
    /// Right side.
    pub rhs: Expr,
    /// Dimension of both sides.
    pub dim: Dim,
    /// Joint that states the condition, with the name of the compared quantity, or the body and its quantity: `g.a`, `rod.mass`.
    pub joint: String,
    /// Advice to the user if the condition fails.
    pub why: String,
}
