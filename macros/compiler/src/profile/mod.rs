//! Functions given piece by piece: tables of points, splines, programs of segments, and laws in parts.
//!
//! In: the arguments of a call as written, and a [`Valuer`] that evaluates them. Out: one expression. Checked here: whether points and
//! segments fit together. Not done here: names, which the valuer knows.

mod piecewise;
mod scca;
mod segments;
mod spline;
mod table;

pub(crate) use table::table;

use crate::diag::{Fact, Range};
use crate::expr::spline::Table;
use crate::expr::{Arena, Exact, Expr};
use crate::model::Requirement;
use crate::names::{Scalar, Scope};
use crate::quantity::Dim;
use crate::syntax::ast;
use proc_macro2::Ident;

/// The word before a program.
pub(crate) const SEGMENTS: &str = "segments";

/// The word before a spline with conditions at its ends.
pub(crate) const SPLINE: &str = "spline";

/// The word before a law whose acceleration is sine, constant and cosine.
pub(crate) const SCCA: &str = "scca";

/// The words of this module that a declared function may have, too.
pub(crate) const WORDS: &[&str] = &[SEGMENTS, SPLINE, SCCA];

/// The expression of a call of one of these words.
pub(crate) fn called(work: &mut impl Valuer, name: &Ident, arguments: &[ast::Expression], scope: &Scope) -> Option<Scalar> {
    if name == SPLINE {
        spline::spline(work, name, arguments, scope)
    } else if name == SCCA {
        scca::scca(work, name, arguments, scope)
    } else {
        segments::segments(work, name, arguments, scope)
    }
}

/// True for this word alone.
fn is_word(expr: &ast::Expression, word: &str) -> bool {
    matches!(&expr.kind, ast::ExpressionKind::Path(path) if path.name.as_ref().is_some_and(|name| name == word))
}

/// The value of an expression of numbers; a root or a sine of numbers has no exact one and is rounded.
fn constant(work: &mut impl Valuer, expr: Expr) -> Option<Exact> {
    let arena = work.arena();
    arena.as_constant(expr).or_else(|| arena.value(expr).and_then(Exact::binary))
}

/// Evaluates the expressions inside a profile.
pub(crate) trait Valuer {
    /// The arena of all expressions.
    fn arena(&mut self) -> &mut Arena;

    /// Evaluates an expression that must be a number.
    fn number(&mut self, expr: &ast::Expression, scope: &Scope) -> Option<Scalar>;

    /// Records a number that may lack its unit.
    fn bare(&mut self, written: &ast::Expression, wanted: Dim);

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
