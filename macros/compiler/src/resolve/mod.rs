//! Resolves the syntax tree to a model in which every name is an id and every quantity has a dimension.
//!
//! In: an [`ast::Mechanism`](crate::syntax::ast::Mechanism) and the definitions it uses. Out: a
//! [`Model`], whose joints are lists of residuals in one arena. Not done here: derivatives.
//!
//! Items may be declared in any order: parameters, `let`s and points are resolved on first use.

mod arithmetic;
mod bounds;
mod builtin;
mod declare;
mod definition;
mod dynamics;
mod elaborate;
mod frames;
mod freedom;
mod index;
mod instance;
mod items;
mod layout;
mod masses;
mod meant;
mod order;
mod register;
mod sketch;
pub(crate) mod space;
mod speeds;
mod statement;
mod unused;
mod whole;

pub(crate) use definition::check as check_definition;
pub(crate) use whole::{Outline, outline, resolve};

use crate::model::{
    Body, BodyCoordinate, Bounds, Component, Components, DeclaredForce, Energy, Field, Force, Freedom, Function, Joint, Layout, Mass,
    Method, Model, Name, Of, Output, Parameter, Part, Requirement, Residual, Times, tabulated,
};
