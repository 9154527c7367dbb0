//! The syntax tree. Names are not resolved.
//!
//! Items that may be repeated are shared, so that a part declared once and used many times is never copied.

mod node;
mod repeated;

pub use node::{ItemId, Shared};
pub use repeated::{ComponentItem, For, IndexRange, PartItem};

use crate::diag::Range;
use crate::quantity::Dim;
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
    /// Visibility, such as `pub`.
    pub visibility: TokenStream,
    /// Name of the generated struct.
    pub name: Ident,
    /// Items between the braces, in the order written.
    pub items: Vec<Item>,
}

/// Policy for a mechanism that does not assemble at its declared defaults, or whose assembly is ambiguous.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Closing {
    /// An error.
    #[default]
    Deny,
    /// A note in the generated documentation.
    Allow,
    /// No assembly is computed.
    Off,
}

/// Task of the generated code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Task {
    /// Positions, velocities and accelerations are solved for.
    #[default]
    Kinematics,
    /// `#[equations_only]`: no `solve` is generated, and the system need not be square.
    EquationsOnly,
}

impl Task {
    /// True if the equations are solved.
    #[must_use]
    pub fn is_solved(self) -> bool {
        match self {
            Task::Kinematics => true,
            Task::EquationsOnly => false,
        }
    }
}

/// Policy for a motion that ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Following {
    /// An error within a declared range; a warning if no range is declared.
    #[default]
    Declared,
    /// Always an error.
    Strict,
    /// The motion is not followed.
    Off,
}

/// Doc attributes as tokens, and their text.
#[derive(Clone, Debug, Default)]
pub struct Docs {
    /// The attributes, as written.
    pub tokens: TokenStream,
    /// Their text, one line per attribute.
    pub text: Vec<String>,
}

/// One item of a mechanism.
#[derive(Clone, Debug)]
pub enum Item {
    /// `use path::to::constraint;`
    Use(Vec<Use>),
    /// `param name: Dimension = default;`
    Parameter(Shared<ParameterItem>),
    /// `let name: Dimension = value;`
    Let(Shared<Let>),
    /// `function name(argument: Dimension) -> Dimension = value;`
    Function(Shared<FunctionItem>),
    /// `ground { … }`
    Ground(Shared<FrameItem>),
    /// `body name { … }`
    Body(Shared<FrameItem>),
    /// `joint name = …;` or `drive name = …;`
    Joint(Shared<JointItem>),
    /// `output name = value;` or `slice output name = value;`
    Output(Shared<OutputItem>),
    /// `component Name(parameters) { items }`
    Component(Shared<ComponentItem>),
    /// `range t in from..to;`
    Range(Shared<TimeRange>),
    /// `part name = Component(arguments);`
    Part(Shared<PartItem>),
    /// `for variable in from..to { items }`
    For(Shared<For<Vec<Item>>>),
    /// A rejected item, as far as its name could be read.
    Refused(Refused),
}

/// Declared range of time.
#[derive(Clone, Debug)]
pub struct TimeRange {
    /// `range`
    pub keyword: Ident,
    /// Start and end.
    pub limits: Limits,
}

/// Declaration of a rejected item, which the stub of the mechanism contains all the same.
#[derive(Clone, Debug)]
pub struct Refused {
    /// `param`, `body`, …
    pub keyword: Ident,
    /// Declared name.
    pub name: Ident,
    /// Indices.
    pub indices: Vec<Expression>,
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

/// A parameter of a mechanism.
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
    /// Default.
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
    /// `(x, y)` in the frame of the body.
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

/// A joint or a drive.
#[derive(Clone, Debug)]
pub struct JointItem {
    /// Doc attributes.
    pub docs: Docs,
    /// True for a drive. Only a drive may contain `t`.
    pub is_drive: bool,
    /// True for a redundant joint: equations that follow from others are checked instead of solved.
    pub is_redundant: bool,
    /// Name.
    pub name: Ident,
    /// Indices, if it is an element of an array.
    pub indices: Vec<Expression>,
    /// Equations of the joint.
    pub body: JointBody,
}

/// Equations of a joint: an instance of a constraint, or written inline.
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
}

/// A `constraint!` invocation: definitions that are exported one by one, or bundles of many.
#[derive(Clone, Debug)]
pub struct Definitions {
    /// Exports, in the order written.
    pub exports: Vec<Export>,
}

/// Definitions that are exported under one name.
#[derive(Clone, Debug)]
pub struct Export {
    /// Doc attributes of the exported macro.
    pub docs: Docs,
    /// Visibility, such as `pub`.
    pub visibility: TokenStream,
    /// The exported name.
    pub name: Ident,
    /// One definition, or all definitions of a bundle.
    pub definitions: Vec<Definition>,
    /// The tokens of the definitions, handed over to mechanisms.
    pub tokens: TokenStream,
    /// True if written as `bundle name { … }`.
    pub is_bundle: bool,
    /// The constraints of a bundle one by one, each with its own tokens.
    pub members: Vec<(Ident, TokenStream)>,
}

/// One `constraint` definition.
#[derive(Clone, Debug)]
pub struct Definition {
    /// Manual page.
    pub docs: Docs,
    /// Name.
    pub name: Ident,
    /// Parameters.
    pub parameters: Vec<Formal>,
    /// Statements.
    pub statements: Vec<Statement>,
}

/// A formal parameter of a definition.
#[derive(Clone, Debug)]
pub struct Formal {
    /// Name.
    pub name: Ident,
    /// Kind of argument.
    pub kind: FormalKind,
    /// Default, if any.
    pub default: Option<Expression>,
}

/// Kind of argument that a formal parameter takes.
#[derive(Clone, Debug)]
pub enum FormalKind {
    /// A point of a body or of ground.
    Point,
    /// A direction fixed in a body or in ground.
    Axis,
    /// A body or ground.
    Body,
    /// A number of any dimension.
    Quantity,
    /// A function of one variable.
    Function(Dimension, Dimension),
    /// A joint of the named kind.
    Joint(Ident),
    /// A number of one dimension.
    Scalar(Dimension),
}

/// A statement of a definition or of an inline joint.
#[derive(Clone, Debug)]
pub enum Statement {
    /// `let name = value;`
    Let(Let),
    /// `lhs == rhs;`
    Equation(Expression, Expression),
    /// `require lhs != rhs: "why";`
    Require(Condition),
}

/// A condition on parameters, checked when they are known.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Left side of the relation.
    pub lhs: Expression,
    /// Relation that must hold.
    pub relation: Relation,
    /// Right side of the relation.
    pub rhs: Expression,
    /// Advice to the user if the condition fails.
    pub why: String,
}

/// Relation between two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
    /// `==`
    Equal,
    /// `!=`
    Different,
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expression {
    /// Kind of expression.
    pub kind: ExpressionKind,
    /// Source range, from the first to the last token.
    pub range: Range,
    /// Longest path to a leaf, bounded by the parser.
    pub depth: u16,
}

/// Kinds of expressions.
#[derive(Clone, Debug)]
pub enum ExpressionKind {
    /// `120mm`
    Number {
        /// The digits, without unit.
        digits: String,
        /// Name of the unit; empty if there is none.
        unit: String,
    },
    /// A name or a path to a Rust item.
    Path(Path),
    /// `value.field`
    Field(Box<Expression>, Ident),
    /// `array[index]`
    Index(Box<Expression>, Box<Expression>),
    /// `function(arguments)`
    Call(Path, Vec<Expression>),
    /// `-value`
    Negative(Box<Expression>),
    /// `lhs op rhs`
    Binary(Operator, Box<Expression>, Box<Expression>),
    /// `(x, y)`
    Tuple(Vec<Expression>),
    /// `[a, b, …]`
    List(Vec<Expression>),
    /// `if lhs < rhs { then } else { otherwise }`
    If {
        /// Left side of the relation.
        lhs: Box<Expression>,
        /// Relation to test.
        relation: Relation,
        /// Right side of the relation.
        rhs: Box<Expression>,
        /// Value if the relation holds.
        then: Box<Expression>,
        /// Value if it does not.
        otherwise: Box<Expression>,
    },
}

/// A binary operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
    /// `%`
    Rem,
    /// `^`
    Power,
}
