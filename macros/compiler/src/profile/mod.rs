//! Functions given piece by piece: tables of points, and programs of segments.
//!
//! In: the arguments of a call as written, and a [`Valuer`] that evaluates them. Out: one expression. Checked here: whether points and
//! segments fit together. Not done here: names, which the valuer knows.

mod segments;
mod table;

pub(crate) use segments::{SEGMENTS, segments};
pub(crate) use table::table;

use crate::diag::{Fact, Range};
use crate::expr::spline::Table;
use crate::expr::{Arena, Expr};
use crate::model::Requirement;
use crate::names::{Scalar, Scope};
use crate::syntax::ast;

/// Evaluates the expressions inside a profile.
pub(crate) trait Valuer {
    /// The arena of all expressions.
    fn arena(&mut self) -> &mut Arena;

    /// Evaluates an expression that must be a number.
    fn number(&mut self, expr: &ast::Expression, scope: &Scope) -> Option<Scalar>;

    /// Reports an error and returns `None`.
    fn reject<T>(&mut self, range: Range, fact: impl Into<Fact>) -> Option<T>;

    /// True if an expression contains parameters only, or if that is not known yet.
    fn may_be_fixed(&self, expr: Expr) -> bool;

    /// Values at the declared defaults and t = 0; NaN where they are not known.
    fn at_defaults(&self, roots: &[Expr]) -> Vec<f64>;

    /// Number of a table; equal tables have the same.
    fn table_number(&mut self, table: Table) -> u32;

    /// States a condition on parameters, which is tested again with their values at run time.
    fn require(&mut self, range: Range, requirement: Requirement);
}
