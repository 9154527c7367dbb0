//! The syntax tree. Names are not resolved.
//!
//! Items that may be repeated are shared, so that a part declared once and used many times is never copied.

mod definition;
mod expression;
mod node;
mod options;
mod repeated;
mod text;

pub use definition::{Added, Applied, Condition, Defined, Definition, Definitions, Export, Formal, FormalKind, Handed, Statement};
pub use expression::{Expression, ExpressionKind, Operator, Relation};
pub use node::{ItemId, Shared};
pub use options::{Closing, Following, Requests, Task};
pub use repeated::{ComponentHome, ComponentItem, For, IndexRange, PartItem};
pub(crate) use repeated::{every_item, has_item, outermost_first};

use crate::diag::Range;
use crate::quantity::{Ambient, Dim};
use proc_macro2::{Ident, TokenStream};

/// A whole `mechanism!` declaration.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// Doc attributes, re-emitted on the generated struct.
    pub docs: Docs,
    /// Task of the generated code.
    pub task: Task,
    /// `#[closure(…)]`
    pub closing: Closing,
    /// `#[allow(far_start)]`: no warning if the assembly is far from the declared start.
    pub allows_far_start: bool,
    /// Policy for following the motion from the start.
    pub following: Following,
    /// `#[picture]`, `#[serde]`: code that is generated on request.
    pub requests: Requests,
    /// Visibility, such as `pub`.
    pub visibility: TokenStream,
    /// Name of the generated struct.
    pub name: Ident,
    /// `in space` or `in plane`.
    pub ambient: Ambient,
    /// Items between the braces, in the order written.
    pub items: Vec<Item>,
    /// Definitions that imported components see.
    pub homes: Vec<ComponentHome>,
    /// True if a mass is written somewhere, also where it could not be read.
    pub mentions_masses: bool,
}

/// Doc attributes as tokens, and their text; and attributes for Rust.
#[derive(Clone, Debug, Default)]
pub struct Docs {
    /// The attributes, as written.
    pub tokens: TokenStream,
    /// Their text, one line per attribute.
    pub text: Vec<String>,
    /// Other attributes of the generated struct or field, as written.
    pub passed: TokenStream,
}

/// One item of a mechanism.
#[derive(Clone, Debug)]
pub enum Item {
    /// `use path::to::constraint;`
    Use(Vec<Use>),
    /// `param name: Dimension = default;`
    Parameter(Shared<ParameterItem>),
    /// `input name: Dimension = default;`
    Input(Shared<ParameterItem>),
    /// `let name: Dimension = value;`
    Let(Shared<Let>),
    /// `function name(argument: Dimension) -> Dimension = value;`
    Function(Shared<FunctionItem>),
    /// `ground { … }`
    Ground(Shared<FrameItem>),
    /// `body name { … }`
    Body(Shared<FrameItem>),
    /// `joint name = …;`, `drive name = …;` or `freedom name = …;`
    Joint(Shared<JointItem>),
    /// `force name = …;` or `energy name = …;`
    Force(Shared<JointItem>),
    /// `gravity = (x, y);`
    Gravity(Shared<Gravity>),
    /// `start joint.angle = value;`
    Start(Shared<StartItem>),
    /// `output name = value;`, `slice output name = value;` or `output name = value with jerk;`
    Output(Shared<OutputItem>),
    /// `component Name(parameters) { items }`
    Component(Shared<ComponentItem>),
    /// `range t in from..to;`
    Range(Shared<TimeRange>),
    /// `part name = Component(arguments);`
    Part(Shared<PartItem>),
    /// `for variable in from..to { items }`
    For(Shared<For<Vec<Item>>>),
    /// A rejected item, as far as it could be read; the stub of the mechanism contains it all the same.
    Refused(Box<Item>),
}

/// Acceleration of free fall.
#[derive(Clone, Debug)]
pub struct Gravity {
    /// `gravity`
    pub keyword: Ident,
    /// The vector.
    pub value: Expression,
}

/// Declared range of time.
#[derive(Clone, Debug)]
pub struct TimeRange {
    /// `range`
    pub keyword: Ident,
    /// Start and end.
    pub limits: Limits,
}

/// One imported constraint.
#[derive(Clone, Debug)]
pub struct Use {
    /// The path as written.
    pub path: Path,
    /// Name in this mechanism.
    pub name: Ident,
}

/// `a::b::c`, or a single name.
#[derive(Clone, Debug)]
pub struct Path {
    /// The tokens as written.
    pub tokens: TokenStream,
    /// The last segment.
    pub last: Ident,
    /// The only segment, if there is only one.
    pub name: Option<Ident>,
    /// Source range, from the first to the last token.
    pub range: Range,
}

/// A parameter or an input of a mechanism.
#[derive(Clone, Debug)]
pub struct ParameterItem {
    /// Doc attributes of the field.
    pub docs: Docs,
    /// Name of the field.
    pub name: Ident,
    /// Indices, if it is an element of an array.
    pub indices: Vec<Expression>,
    /// Dimension.
    pub dimension: Dimension,
    /// Default; of an input, its value at the start.
    pub default: Expression,
    /// Range after `in`, if any.
    pub limits: Option<Limits>,
}

/// `from..to` or `from..=to`; one of the bounds may be missing.
#[derive(Clone, Debug)]
pub struct Limits {
    /// Lower bound.
    pub from: Option<Expression>,
    /// Upper bound.
    pub to: Option<Expression>,
    /// True for `..=`: the upper bound belongs to the range.
    pub is_inclusive: bool,
    /// Source range, from the first to the last token.
    pub range: Range,
}

/// A derived quantity.
#[derive(Clone, Debug)]
pub struct Let {
    /// Name.
    pub name: Ident,
    /// Indices, if it is an element of an array.
    pub indices: Vec<Expression>,
    /// Dimension, if declared.
    pub dimension: Option<Dimension>,
    /// Value.
    pub value: Expression,
}

/// A function of one variable written in the language, or a Rust function given a signature.
#[derive(Clone, Debug)]
pub struct FunctionItem {
    /// Name.
    pub name: Ident,
    /// Name of the argument; `None` for a Rust function.
    pub argument: Option<Ident>,
    /// Dimension of the argument.
    pub from: Dimension,
    /// Dimension of the value.
    pub to: Dimension,
    /// The value, or the path of a Rust function.
    pub value: Expression,
}

/// `Length * Angle / Time^2`: a product of named dimensions.
#[derive(Clone, Debug)]
pub struct Dimension {
    /// Names with their integer exponents.
    pub factors: Vec<(Ident, i16)>,
    /// Source range, from the first to the last token.
    pub range: Range,
}

impl Dimension {
    /// The product of powers, if all names are known.
    pub(crate) fn dim(&self) -> Option<Dim> {
        self.factors
            .iter()
            .try_fold(Dim::NUMBER, |product, (name, exponent)| Some(product.times(Dim::named(&name.to_string())?.raised(*exponent)?)))
    }
}

/// A body, or ground.
#[derive(Clone, Debug)]
pub struct FrameItem {
    /// Doc attributes of the accessor.
    pub docs: Docs,
    /// Name of the body; `ground` for ground.
    pub name: Ident,
    /// Indices, if it is an element of an array.
    pub indices: Vec<Expression>,
    /// Points and axes fixed in it.
    pub marks: Marks,
    /// Start values.
    pub starts: Vec<Start>,
    /// `mass`, `center` and `inertia`.
    pub masses: Vec<MassItem>,
}

/// Points and axes fixed in a body.
#[derive(Clone, Debug, Default)]
pub struct Marks {
    /// Points and axes declared one by one.
    pub single: Vec<Shared<Feature>>,
    /// Points and axes declared in loops.
    pub loops: Vec<Shared<For<Marks>>>,
}

/// A point or an axis fixed in a body.
#[derive(Clone, Debug)]
pub struct Feature {
    /// True for an axis, which is a direction.
    pub is_axis: bool,
    /// Name.
    pub name: Ident,
    /// Indices, if it is an element of an array.
    pub indices: Vec<Expression>,
    /// `(x, y)` or `(x, y, z)` in the frame of the body.
    pub value: Expression,
    /// `from (x, y, z)`: the direction from which angles about the axis are counted.
    pub zero: Option<Expression>,
}

/// `start hinge.angle = …;`
#[derive(Clone, Debug)]
pub struct StartItem {
    /// The angle or the displacement of a joint.
    pub quantity: Expression,
    /// Value.
    pub value: Expression,
}

/// `start angle = …;`
#[derive(Clone, Debug)]
pub struct Start {
    /// `x`, `y`, `angle` or `position`.
    pub what: Ident,
    /// Value.
    pub value: Expression,
}

/// `mass = …;`, `center = …;` or `inertia = … along …;`
#[derive(Clone, Debug)]
pub struct MassItem {
    /// `mass`, `center` or `inertia`.
    pub what: Ident,
    /// Value.
    pub value: Expression,
    /// How the axes of an inertia are turned against those of the body.
    pub along: Option<Expression>,
}

/// A joint, a drive or a freedom.
#[derive(Clone, Debug)]
pub struct JointItem {
    /// Doc attributes.
    pub docs: Docs,
    /// True for a drive, and for a freedom, which is a drive at t = 0. Only they may contain `t`.
    pub is_drive: bool,
    /// True for a redundant joint: equations that follow from others are checked instead of solved.
    pub is_redundant: bool,
    /// True if its load can be computed alone.
    pub is_slice: bool,
    /// `#[velocity]`, if its equations of velocities are not to be integrated.
    pub velocity: Option<Ident>,
    /// Name.
    pub name: Ident,
    /// Indices, if it is an element of an array.
    pub indices: Vec<Expression>,
    /// Equations of the joint.
    pub body: JointBody,
}

impl JointItem {
    /// True for a freedom.
    #[must_use]
    pub(crate) fn is_freedom(&self) -> bool {
        matches!(self.body, JointBody::Freedom(_))
    }

    /// True for a joint of the library that takes points or axes and no law.
    #[must_use]
    pub(crate) fn takes_places(&self) -> bool {
        const KINDS: [&str; 9] =
            ["revolute", "translational", "weld", "point_on_line", "spherical", "cylindrical", "universal", "planar", "point_on_plane"];
        matches!(&self.body, JointBody::Of { kind, .. } if KINDS.iter().any(|known| kind == known))
    }
}

/// Equations of a joint: an instance of a constraint, or written inline; of a freedom, its quantity.
#[derive(Clone, Debug)]
pub enum JointBody {
    /// `kind(arguments)`
    Of {
        /// Name of the constraint.
        kind: Ident,
        /// Arguments.
        arguments: Vec<Argument>,
    },
    /// `{ lhs == rhs; … }`
    Equations(Vec<Statement>),
    /// `freedom name = value from start at rate;`
    Freedom(Box<FreedomItem>),
    /// `energy name = value;`
    Energy(Box<Expression>),
    /// A value alone, which no joint and no force is.
    Value(Box<Expression>),
}

/// A quantity that follows from forces.
#[derive(Clone, Debug)]
pub struct FreedomItem {
    /// The quantity.
    pub value: Expression,
    /// `from value`: its value at t = 0.
    pub from: Option<Expression>,
    /// `at rate`: its rate at t = 0.
    pub at: Option<Expression>,
}

/// An argument, positional or named.
#[derive(Clone, Debug)]
pub struct Argument {
    /// Name of the parameter, if written.
    pub name: Option<Ident>,
    /// Value.
    pub value: Expression,
}

/// A named output.
#[derive(Clone, Debug)]
pub struct OutputItem {
    /// Doc attributes of the generated method.
    pub docs: Docs,
    /// It can be solved for alone.
    pub is_slice: bool,
    /// Name.
    pub name: Ident,
    /// Indices, if it is an element of an array.
    pub indices: Vec<Expression>,
    /// Value.
    pub value: Expression,
    /// `jerk`, if its third derivative is given as well.
    pub jerk: Option<Ident>,
}
