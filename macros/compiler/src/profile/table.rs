//! `table(x, [(x0, y0), …], periodic)`: a spline through points.

use super::Valuer;
use crate::diag::ValueFact;
use crate::expr::spline::{Ends, Table};
use crate::names::{Scalar, Scope};
use crate::quantity::InferredDim;
use crate::syntax::ast::{self, ExpressionKind};
use proc_macro2::Ident;

/// The expression of a table.
pub(crate) fn table(work: &mut impl Valuer, name: &Ident, arguments: &[ast::Expression], scope: &Scope) -> Option<Scalar> {
    let (x, points, ends) = match arguments {
        [x, points] => (x, points, Ends::Linear),
        [x, points, ends] => (x, points, self::ends(work, ends)?),
        _ => return work.reject(name.into(), ValueFact::TableArity { found: arguments.len() }),
    };
    let ExpressionKind::List(items) = &points.kind else {
        return work.reject(points.range, ValueFact::TableNeedsList);
    };
    let argument = work.number(x, scope)?;
    let mut to = InferredDim::Any;
    let pairs = pairs(work, items, argument.measure, &mut to, scope)?;
    let (Some(first), Some(last), Some(end)) = (pairs.first(), pairs.last(), items.last().filter(|_| pairs.len() > 1)) else {
        return work.reject(points.range, ValueFact::TableTooShort { found: pairs.len() });
    };
    if ends == Ends::Periodic && first.1 != last.1 {
        return work.reject(end.range, ValueFact::TableNotPeriodic { first: first.1, last: last.1, dim: to.settled() });
    }
    let number = work.table_number(Table::through(&pairs, ends));
    Some(Scalar { expr: work.arena().call(number, 0, argument.expr), measure: to })
}

/// Reads the pairs of a table; their first numbers must increase.
fn pairs(
    work: &mut impl Valuer,
    items: &[ast::Expression],
    mut from: InferredDim,
    to: &mut InferredDim,
    scope: &Scope,
) -> Option<Vec<(f64, f64)>> {
    let mut pairs: Vec<(f64, f64)> = Vec::new();
    for item in items {
        let ExpressionKind::Tuple(pair) = &item.kind else {
            return work.reject(item.range, ValueFact::TableNeedsPairs);
        };
        let [at, value] = pair.as_slice() else {
            return work.reject(item.range, ValueFact::TableNeedsPairs);
        };
        let (x, y) = (entry(work, at, &mut from, scope)?, entry(work, value, to, scope)?);
        if let Some((before, _)) = pairs.last().filter(|last| last.0 >= x) {
            return work.reject(at.range, ValueFact::TableNotIncreasing { before: *before, found: x, dim: from.settled() });
        }
        pairs.push((x, y));
    }
    Some(pairs)
}

fn ends(work: &mut impl Valuer, expr: &ast::Expression) -> Option<Ends> {
    let word = match &expr.kind {
        ExpressionKind::Path(path) => path.tokens.to_string(),
        _ => String::new(),
    };
    match word.as_str() {
        "periodic" => Some(Ends::Periodic),
        "linear" => Some(Ends::Linear),
        "hold" => Some(Ends::Hold),
        "" => work.reject(expr.range, ValueFact::TableEnds { found: "this".to_owned() }),
        _ => work.reject(expr.range, ValueFact::TableEnds { found: format!("`{word}`") }),
    }
}

/// Evaluates one constant of a table; all entries of a column have the same dimension.
fn entry(work: &mut impl Valuer, entry: &ast::Expression, column: &mut InferredDim, scope: &Scope) -> Option<f64> {
    let scalar = work.number(entry, scope)?;
    let Some(common) = column.common(scalar.measure) else {
        return work.reject(entry.range, ValueFact::WrongDimension { wanted: column.settled(), found: scalar.measure.settled() });
    };
    *column = common;
    match work.arena().as_constant(scalar.expr) {
        Some(value) => Some(value.to_f64()),
        None => {
            work.reject(entry.range, ValueFact::NotConstant { place: "an entry of a table", help: "multiply the table by what changes" })
        }
    }
}
