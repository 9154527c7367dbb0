//! From the tree of what was written to a model in which every name is an id and every quantity
//! has a dimension.
//!
//! In: an [`ast::Mechanism`](crate::syntax::ast::Mechanism) and the definitions it uses. Out: a
//! [`Model`], whose joints are lists of residuals in one arena. Not done here: derivatives.
//!
//! Items may stand in any order: parameters, `let`s and points are resolved when first asked for.

mod arithmetic;
mod bounds;
mod builtin;
mod components;
mod declare;
mod definition;
mod elaborate;
pub(crate) mod example;
mod frames;
mod index;
mod instance;
mod items;
mod key;
mod layout;
mod name;
mod names;
mod register;
mod resolve;
mod signature;
pub mod sketch;
pub(crate) mod spline;
mod statement;
mod unused;
pub(crate) mod value;

pub use components::Components;
pub use layout::{Component, Field, Layout, Of, Part};
pub use name::Name;
pub use sketch::Sketch;
pub use spline::{Ends, Table};

use crate::expr::{Arena, Expr};
use crate::quantity::{Dim, Role};
use crate::syntax::ast::{Closing, Docs, Following, Relation};
use proc_macro2::{Ident, TokenStream};

pub(crate) use definition::{check as check_definition, check_names};
pub(crate) use name::Said;
pub(crate) use names::is_generated;
pub(crate) use register::is_of_generated_type;
pub(crate) use resolve::{Outline, outline, resolve};

/// A mechanism in which nothing is only a name any more.
#[derive(Clone, Debug)]
pub struct Model {
    /// All expressions.
    pub arena: Arena,
    /// Doc attributes of the generated struct.
    pub docs: Docs,
    /// `pub` and the like.
    pub visibility: TokenStream,
    /// Name of the generated struct.
    pub name: Ident,
    /// No `solve` is generated.
    pub equations_only: bool,
    /// What is done where the declared defaults do not assemble.
    pub closing: Closing,
    /// There is no warning where the assembly is far from the declared start.
    pub allows_far_start: bool,
    /// It names constraints with `use`, and a stub stands beside it for the case that one of them is none.
    pub has_stub: bool,
    /// How the motion is followed from the start.
    pub following: Following,
    /// The range of time, if it is declared.
    pub range: Option<Times>,
    /// What the mechanism and its components are made of.
    pub layout: Layout,
    /// The fields of the generated structs.
    pub parameters: Vec<Parameter>,
    /// The moving bodies, in the order declared.
    pub bodies: Vec<Body>,
    /// Local coordinates of all points, from which a characteristic length is taken.
    pub lengths: Vec<Expr>,
    /// Joints and drives, in the order declared.
    pub joints: Vec<Joint>,
    /// Named outputs, in the order declared.
    pub outputs: Vec<Output>,
    /// The methods that give them.
    pub methods: Vec<Method>,
    /// Functions that the arena knows by number.
    pub functions: Vec<Function>,
    /// Conditions on parameters.
    pub requirements: Vec<Requirement>,
    /// What a picture needs.
    pub sketch: Sketch,
}

/// A field of the generated struct.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: Name,
    /// What it measures.
    pub dim: Dim,
    /// Its default, a constant.
    pub default: Expr,
    /// Where it lies, if that was declared.
    pub bounds: Option<Bounds>,
}

/// The values that a parameter may have, in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// The least one.
    pub from: Option<f64>,
    /// The greatest one.
    pub to: Option<f64>,
    /// The greatest one is allowed.
    pub is_inclusive: bool,
    /// As declared: `5 mm ..= 50 mm`.
    pub text: String,
}

/// The times that a mechanism is meant for, in s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// The first.
    pub from: f64,
    /// The last.
    pub to: f64,
}

/// A moving body: a list of coordinates with a kind.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name.
    pub name: Name,
    /// The index in q of its first coordinate.
    pub first: usize,
    /// Its coordinates, in their order in q.
    pub coordinates: Vec<BodyCoordinate>,
}

/// One coordinate of a body.
#[derive(Clone, Debug)]
pub struct BodyCoordinate {
    /// Its part in the placement of the body.
    pub role: Role,
    /// Its declared start value, a function of parameters.
    pub start: Option<Expr>,
}

/// A joint or a drive: residuals that must vanish.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Its name.
    pub name: Name,
    /// The constraint it is made of; `equation` if written inline.
    pub kind: String,
    /// Declared by `drive`.
    pub is_drive: bool,
    /// Declared by `redundant joint`: those of its equations that follow from others are checked instead of solved.
    pub is_redundant: bool,
    /// Left minus right side of each scalar equation.
    pub residuals: Vec<Residual>,
}

/// Left minus right side of one scalar equation.
#[derive(Clone, Copy, Debug)]
pub struct Residual {
    /// Its value.
    pub expr: Expr,
    /// Its dimension.
    pub dim: Dim,
}

/// A named output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name.
    pub name: Name,
    /// The body that it is, if it is a whole one.
    pub body: Option<usize>,
    /// One component for a number, two for a vector or a point, none for a body.
    pub components: Vec<Expr>,
    /// What it measures.
    pub dim: Dim,
}

/// A generated method: one output, or an array of them.
#[derive(Clone, Debug)]
pub struct Method {
    /// Its name; that of an output in a part begins with the part's.
    pub name: Ident,
    /// Doc attributes.
    pub docs: Docs,
    /// How many outputs there are for each index; empty for a single one.
    pub sizes: Vec<usize>,
    /// The outputs by number, the last index running fastest.
    pub members: Vec<usize>,
    /// It can be solved for alone: one of the outputs is declared as `slice output`.
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

/// A condition on parameters.
#[derive(Clone, Debug)]
pub struct Requirement {
    /// Left side.
    pub lhs: Expr,
    /// How they must compare.
    pub relation: Relation,
    /// Right side.
    pub rhs: Expr,
    /// What both sides measure.
    pub dim: Dim,
    /// The joint that asks for it, with the name of what is compared: `g.a`.
    pub joint: String,
    /// What to do instead.
    pub why: String,
}
