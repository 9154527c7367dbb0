//! What was written: the tree that the parser gives. Names are still names.
//!
//! Items that may be repeated are shared, so that a part declared once and used many times is never copied.

mod node;
mod repeated;

pub use node::{Node, NodeId};
pub use repeated::{Bounds, Component, For, Part};

use crate::diag::Range;
use crate::quantity::Dim;
use proc_macro2::{Ident, TokenStream};

/// A whole `mechanism!` declaration.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// Doc attributes, re-emitted on the generated struct.
    pub docs: Docs,
    /// `#[equations_only]`: no `solve` is generated, and the system need not be square.
    pub equations_only: bool,
    /// `#[closure(…)]`
    pub closing: Closing,
    /// `#[allow(far_start)]`: no warning where the assembly is far from the declared start.
    pub allows_far_start: bool,
    /// How the motion is followed from the start.
    pub following: Following,
    /// `pub` and the like.
    pub visibility: TokenStream,
    /// Name of the generated struct.
    pub name: Ident,
    /// Everything between the braces, in the order written.
    pub items: Vec<Item>,
}

/// What is done where a mechanism does not assemble at its declared defaults, or not in one way that is clear.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Closing {
    /// It is refused.
    #[default]
    Deny,
    /// It is said in its documentation.
    Allow,
    /// No assembly is looked for.
    Off,
}

/// What becomes of a motion that ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Following {
    /// It is refused within a declared range, and warned of where none is declared.
    #[default]
    Declared,
    /// It is refused in any case.
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
    Parameter(Node<Parameter>),
    /// `let name: Dimension = value;`
    Let(Node<Let>),
    /// `function name(argument: Dimension) -> Dimension = value;`
    Function(Node<Function>),
    /// `ground { … }`
    Ground(Node<Frame>),
    /// `body name { … }`
    Body(Node<Frame>),
    /// `joint name = …;` or `drive name = …;`
    Joint(Node<Joint>),
    /// `output name = value;` or `slice output name = value;`
    Output(Node<Output>),
    /// `component Name(parameters) { items }`
    Component(Node<Component>),
    /// `range t in from..to;`
    Range(Node<Times>),
    /// `part name = Component(arguments);`
    Part(Node<Part>),
    /// `for variable in from..to { items }`
    For(Node<For<Vec<Item>>>),
    /// An item that was refused, as far as its name could be read.
    Refused(Refused),
}

/// The times that a mechanism is meant for.
#[derive(Clone, Debug)]
pub struct Times {
    /// `range`
    pub keyword: Ident,
    /// The first and the last.
    pub limits: Limits,
}

/// What a refused item would have declared; the stub of the mechanism has it all the same.
#[derive(Clone, Debug)]
pub struct Refused {
    /// `param`, `body`, …
    pub keyword: Ident,
    /// The promised name.
    pub name: Ident,
    /// Its indices.
    pub indices: Vec<Expr>,
}

/// One imported constraint.
#[derive(Clone, Debug)]
pub struct Use {
    /// The path as written.
    pub path: Path,
    /// The name it has in this mechanism.
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
    /// First to last token.
    pub range: Range,
}

/// A parameter of a mechanism.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Doc attributes of the field.
    pub docs: Docs,
    /// Name of the field.
    pub name: Ident,
    /// Its indices, if it is one of an array.
    pub indices: Vec<Expr>,
    /// What it measures.
    pub dimension: Dimension,
    /// Its default.
    pub default: Expr,
    /// `in` and the range that it lies in.
    pub limits: Option<Limits>,
}

/// `from..to` or `from..=to`, of which one end may be missing.
#[derive(Clone, Debug)]
pub struct Limits {
    /// The least value.
    pub from: Option<Expr>,
    /// The greatest value.
    pub to: Option<Expr>,
    /// `..=`: the greatest value belongs to the range.
    pub is_inclusive: bool,
    /// First to last token.
    pub range: Range,
}

/// A derived quantity.
#[derive(Clone, Debug)]
pub struct Let {
    /// Its name.
    pub name: Ident,
    /// Its indices, if it is one of an array.
    pub indices: Vec<Expr>,
    /// What it measures, if said.
    pub dimension: Option<Dimension>,
    /// Its value.
    pub value: Expr,
}

/// A function of one variable written in the language, or a Rust function given a signature.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its name.
    pub name: Ident,
    /// The argument's name; a Rust function has none.
    pub argument: Option<Ident>,
    /// What the argument measures.
    pub from: Dimension,
    /// What the value measures.
    pub to: Dimension,
    /// The value, or the path of a Rust function.
    pub value: Expr,
}

/// `Length * Angle / Time^2`: a product of named dimensions.
#[derive(Clone, Debug)]
pub struct Dimension {
    /// Names with their integer exponents.
    pub factors: Vec<(Ident, i16)>,
    /// First to last token.
    pub range: Range,
}

impl Dimension {
    /// The product of powers, if all its names are known.
    pub(crate) fn dim(&self) -> Option<Dim> {
        self.factors
            .iter()
            .try_fold(Dim::NUMBER, |product, (name, exponent)| Some(product.times(Dim::named(&name.to_string())?.raised(*exponent)?)))
    }
}

/// A body, or ground.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Doc attributes of the accessor.
    pub docs: Docs,
    /// Name of the body; `ground` for ground.
    pub name: Ident,
    /// Its indices, if it is one of an array.
    pub indices: Vec<Expr>,
    /// Points and axes fixed in it.
    pub marks: Marks,
    /// Start values.
    pub starts: Vec<Start>,
}

/// Points and axes fixed in a body.
#[derive(Clone, Debug, Default)]
pub struct Marks {
    /// Those declared one by one.
    pub single: Vec<Node<Mark>>,
    /// Those declared in loops.
    pub loops: Vec<Node<For<Marks>>>,
}

/// A point or an axis fixed in a body.
#[derive(Clone, Debug)]
pub struct Mark {
    /// A direction rather than a place.
    pub is_axis: bool,
    /// Its name.
    pub name: Ident,
    /// Its indices, if it is one of an array.
    pub indices: Vec<Expr>,
    /// `(x, y)` in the body's frame.
    pub value: Expr,
}

/// `start angle = …;`
#[derive(Clone, Debug)]
pub struct Start {
    /// `x`, `y`, `angle` or `position`.
    pub what: Ident,
    /// Its value.
    pub value: Expr,
}

/// A joint or a drive.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Doc attributes.
    pub docs: Docs,
    /// Only a drive may contain `t`.
    pub is_drive: bool,
    /// Those of its equations that follow from others are checked instead of solved.
    pub is_redundant: bool,
    /// Its name.
    pub name: Ident,
    /// Its indices, if it is one of an array.
    pub indices: Vec<Expr>,
    /// What it demands.
    pub body: JointBody,
}

/// What a joint demands.
#[derive(Clone, Debug)]
pub enum JointBody {
    /// `kind(arguments)`
    Of {
        /// Which constraint.
        kind: Ident,
        /// Its arguments.
        arguments: Vec<Argument>,
    },
    /// `{ lhs == rhs; … }`
    Equations(Vec<Statement>),
}

/// An argument, positional or named.
#[derive(Clone, Debug)]
pub struct Argument {
    /// `name:` before it.
    pub name: Option<Ident>,
    /// Its value.
    pub value: Expr,
}

/// A named output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Doc attributes of the generated method.
    pub docs: Docs,
    /// It can be solved for alone.
    pub is_slice: bool,
    /// Its name.
    pub name: Ident,
    /// Its indices, if it is one of an array.
    pub indices: Vec<Expr>,
    /// Its value.
    pub value: Expr,
}

/// A `constraint!` invocation: definitions that are exported one by one, or bundles of many.
#[derive(Clone, Debug)]
pub struct Definitions {
    /// In the order written.
    pub exports: Vec<Export>,
}

/// What one exported name stands for.
#[derive(Clone, Debug)]
pub struct Export {
    /// Doc attributes of the exported macro.
    pub docs: Docs,
    /// `pub` and the like.
    pub visibility: TokenStream,
    /// The exported name.
    pub name: Ident,
    /// One definition, or all those of a bundle.
    pub definitions: Vec<Definition>,
    /// The tokens of the definitions, handed over to mechanisms.
    pub tokens: TokenStream,
    /// It was written as `bundle name { … }`.
    pub is_bundle: bool,
    /// The constraints of a bundle one by one, each with its own tokens.
    pub members: Vec<(Ident, TokenStream)>,
}

/// One `constraint` definition.
#[derive(Clone, Debug)]
pub struct Definition {
    /// Its manual page.
    pub docs: Docs,
    /// Its name.
    pub name: Ident,
    /// What it takes.
    pub parameters: Vec<Formal>,
    /// Its equations.
    pub statements: Vec<Statement>,
}

/// A formal parameter of a definition.
#[derive(Clone, Debug)]
pub struct Formal {
    /// Its name.
    pub name: Ident,
    /// What it takes.
    pub kind: Kind,
    /// What it is when left out.
    pub default: Option<Expr>,
}

/// What a formal parameter takes.
#[derive(Clone, Debug)]
pub enum Kind {
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
    Equation(Expr, Expr),
    /// `require lhs != rhs: "why";`
    Require(Requirement),
}

/// A condition on parameters, checked when they are known.
#[derive(Clone, Debug)]
pub struct Requirement {
    /// Left of the relation.
    pub lhs: Expr,
    /// How they must compare.
    pub relation: Relation,
    /// Right of the relation.
    pub rhs: Expr,
    /// What a user should do instead.
    pub why: String,
}

/// How two numbers compare.
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
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// First to last token.
    pub range: Range,
    /// Longest way down to a leaf, bounded by the parser.
    pub depth: u16,
}

/// What an expression is.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// `120mm`
    Number {
        /// The digits, without unit.
        digits: String,
        /// The unit's name, empty if none.
        unit: String,
    },
    /// A name or a path to a Rust item.
    Path(Path),
    /// `value.field`
    Field(Box<Expr>, Ident),
    /// `array[index]`
    Index(Box<Expr>, Box<Expr>),
    /// `function(arguments)`
    Call(Path, Vec<Expr>),
    /// `-value`
    Negative(Box<Expr>),
    /// `lhs op rhs`
    Binary(Operator, Box<Expr>, Box<Expr>),
    /// `(x, y)`
    Tuple(Vec<Expr>),
    /// `[a, b, …]`
    List(Vec<Expr>),
    /// `if lhs < rhs { then } else { otherwise }`
    If {
        /// Left of the relation.
        lhs: Box<Expr>,
        /// How they must compare.
        relation: Relation,
        /// Right of the relation.
        rhs: Box<Expr>,
        /// Value if they do.
        then: Box<Expr>,
        /// Value if they do not.
        otherwise: Box<Expr>,
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
