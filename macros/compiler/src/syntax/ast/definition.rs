//! Definitions of constraints, and the statements in them.

use super::{ComponentItem, Dimension, Docs, Expression, Let, MassItem, Relation};
use crate::diag::Range;
use crate::quantity::Ambient;
use proc_macro2::{Ident, TokenStream};

/// A `constraint!` invocation: constraints, forces and components that are exported one by one, or bundles of many.
#[derive(Clone, Debug)]
pub struct Definitions {
    /// Exports, in the order written.
    pub exports: Vec<Export>,
}

impl Definition {
    /// True if an argument is a number or a function of one variable.
    #[must_use]
    pub(crate) fn takes_numbers(&self) -> bool {
        let is_number = |formal: &Formal| matches!(formal.kind, FormalKind::Quantity | FormalKind::Scalar(_) | FormalKind::Function(..));
        self.parameters.iter().any(is_number)
    }
}

/// What a name of `constraint!` stands for.
#[derive(Clone, Debug)]
pub enum Defined {
    /// A constraint or a force.
    Constraint(Definition),
    /// A component.
    Component(ComponentItem),
}

impl Defined {
    /// Name, parameters and ambient; of a constraint or a force its statements as well.
    #[must_use]
    pub fn head(&self) -> &Definition {
        match self {
            Defined::Constraint(definition) => definition,
            Defined::Component(component) => &component.head,
        }
    }

    /// Where it may be used: a constraint everywhere unless it says otherwise, a component in the plane.
    pub(crate) fn ambient(&self) -> Option<Ambient> {
        match self {
            Defined::Constraint(definition) => definition.ambient,
            Defined::Component(component) => Some(component.head.ambient.unwrap_or_default()),
        }
    }
}

/// A definition handed over to a mechanism.
#[derive(Clone, Debug)]
pub struct Handed {
    /// The definition.
    pub defined: Defined,
    /// Its tokens.
    pub tokens: TokenStream,
    /// True if the name handed over stands for it, false if a component handed over calls it.
    pub is_named: bool,
    /// True if the name handed over is that of a bundle.
    pub is_of_bundle: bool,
    /// The crate of the definition, if there are components among those handed over.
    pub origin: String,
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
    pub definitions: Vec<Defined>,
    /// The tokens of the definitions, handed over to mechanisms.
    pub tokens: TokenStream,
    /// True if written as `bundle name { … }`.
    pub is_bundle: bool,
    /// The definitions of a bundle one by one, each with its own tokens.
    pub members: Vec<(Ident, TokenStream)>,
}

impl Export {
    /// Names of its definitions.
    pub(crate) fn own_names(&self) -> Vec<&Ident> {
        self.definitions.iter().map(|defined| &defined.head().name).collect()
    }
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
    /// `in space` or `in plane`; `None` if it may be used in both.
    pub ambient: Option<Ambient>,
    /// True for a force, false for a constraint.
    pub is_force: bool,
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
    /// `at point: force;` or `on body: torque;`
    Apply(Applied),
    /// `potential: energy;`
    Potential(Expression),
    /// `add mass at point: mass;` or `add inertia on body: inertia;`
    Add(Added),
}

/// A force at a point, or a torque on a body.
#[derive(Clone, Debug)]
pub struct Applied {
    /// True for `on body: torque;`.
    pub is_torque: bool,
    /// Point or body.
    pub target: Expression,
    /// Force or torque.
    pub value: Expression,
}

/// Mass or inertia that a joint or a force adds to a body.
#[derive(Clone, Debug)]
pub struct Added {
    /// Point of a mass, body of an inertia.
    pub target: Expression,
    /// The mass or inertia that is added.
    pub item: MassItem,
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

impl Condition {
    /// Source range from the first token to the last.
    pub(crate) fn range(&self) -> Range {
        self.lhs.range.to(self.rhs.range)
    }
}
