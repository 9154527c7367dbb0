//! `table(x, [(x0, y0), …], periodic)`: a cubic spline through points.

use super::{Valuer, constant};
use crate::diag::{Range, ValueFact};
use crate::expr::Exact;
use crate::expr::spline::{Ends, Table};
use crate::names::{Scalar, Scope};
use crate::quantity::InferredDim;
use crate::syntax::ast::{self, ExpressionKind};
use proc_macro2::Ident;

/// The expression of a table.
pub(crate) fn table(work: &mut impl Valuer, name: &Ident, arguments: &[ast::Expression], scope: &Scope) -> Option<Scalar> {
    let is_list = |written: &ast::Expression| matches!(written.kind, ExpressionKind::List(_) | ExpressionKind::Tuple(_));
    let columns_apart = arguments.iter().skip(1).filter(|written| is_list(written)).count() > 1;
    if let Some(first) = arguments.get(1).filter(|_| columns_apart) {
        return work.reject(first.range, ValueFact::TableNeedsList);
    }
    let (x, points, ends) = match arguments {
        [x, points] => (x, points, Ends::Linear),
        [x, points, ends] => (x, points, self::ends(work, ends)?),
        _ => return work.reject(name.into(), ValueFact::TableArity { found: arguments.len() }),
    };
    let ExpressionKind::List(items) = &points.kind else {
        return match &x.kind {
            ExpressionKind::List(_) => {
                let instead = format!("table({points}, […])");
                work.reject(name.into(), ValueFact::TableTakesArgumentFirst { word: "table", instead })
            }
            _ => work.reject(points.range, ValueFact::TableNeedsList),
        };
    };
    let argument = work.number(x, scope)?;
    let mut columns = [argument.measure, InferredDim::Any];
    let read = pairs(work, "table", points.range, items, &mut columns, scope)?;
    // The greatest is out of proportion if any is.
    if let (InferredDim::Known(dim), Some(ExpressionKind::Tuple(last))) = (argument.measure, items.last().map(|item| &item.kind)) {
        last.first().into_iter().for_each(|greatest| work.bare(greatest, dim));
    }
    let pairs: Vec<(f64, f64)> = read.iter().map(|[x, y]| (x.to_f64(), y.to_f64())).collect();
    if ends == Ends::Periodic {
        returns(work, "table", items, &read, columns[1])?;
    }
    let number = work.table_number(Table::through(&pairs, ends));
    Some(Scalar { expr: work.arena().call(number, 0, argument.expr), measure: columns[1] })
}

/// Reads the points of a `table` or a `spline`, two at least, whose first numbers must increase.
pub(super) fn pairs(
    work: &mut impl Valuer,
    word: &'static str,
    range: Range,
    items: &[ast::Expression],
    columns: &mut [InferredDim; 2],
    scope: &Scope,
) -> Option<Vec<[Exact; 2]>> {
    let mut pairs: Vec<[Exact; 2]> = Vec::new();
    for item in items {
        let [at, value] = pair(work, item)?;
        let (x, y) = (entry(work, word, at, &mut columns[0], scope)?, entry(work, word, value, &mut columns[1], scope)?);
        if let Some([before, _]) = pairs.last().filter(|last| last[0].to_f64() >= x.to_f64()) {
            let [before, found] = [before, &x].map(|value| value.to_f64());
            return work.reject(at.range, ValueFact::TableNotIncreasing { word, before, found, dim: columns[0].settled() });
        }
        pairs.push([x, y]);
    }
    match pairs.len() {
        found @ (0 | 1) => work.reject(range, ValueFact::TableTooShort { word, found }),
        _ => Some(pairs),
    }
}

/// Checks that the last point has the value of the first.
pub(super) fn returns(
    work: &mut impl Valuer,
    word: &'static str,
    items: &[ast::Expression],
    pairs: &[[Exact; 2]],
    to: InferredDim,
) -> Option<()> {
    let (Some(end), [[_, first], .., [_, last]]) = (items.last(), pairs) else { return Some(()) };
    let [first, last] = [first, last].map(|value| value.to_f64());
    if first != last {
        return work.reject(end.range, ValueFact::TableNotPeriodic { word, first, last, dim: to.settled() });
    }
    Some(())
}

/// The two numbers of a pair as written.
fn pair<'a>(work: &mut impl Valuer, item: &'a ast::Expression) -> Option<[&'a ast::Expression; 2]> {
    match &item.kind {
        ExpressionKind::Tuple(pair) => match pair.as_slice() {
            [one, two] => Some([one, two]),
            _ => work.reject(item.range, ValueFact::TableNeedsPairs),
        },
        _ => work.reject(item.range, ValueFact::TableNeedsPairs),
    }
}

/// The two constants of a pair.
pub(super) fn values(
    work: &mut impl Valuer,
    word: &'static str,
    item: &ast::Expression,
    [from, to]: &mut [InferredDim; 2],
    scope: &Scope,
) -> Option<[Exact; 2]> {
    let [one, two] = pair(work, item)?;
    Some([entry(work, word, one, from, scope)?, entry(work, word, two, to, scope)?])
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

/// Evaluates one constant; all entries of a column have the same dimension.
fn entry(work: &mut impl Valuer, word: &'static str, entry: &ast::Expression, column: &mut InferredDim, scope: &Scope) -> Option<Exact> {
    let scalar = work.number(entry, scope)?;
    let Some(common) = column.common(scalar.measure) else {
        return work.reject(entry.range, ValueFact::WrongDimension { wanted: column.settled(), found: scalar.measure.settled() });
    };
    *column = common;
    let (place, help) = match word {
        "table" => ("an entry of a table", "multiply the table by what changes"),
        _ => ("an entry of a spline", "multiply the spline by what changes"),
    };
    match constant(work, scalar.expr) {
        Some(value) => Some(value),
        None => work.reject(entry.range, ValueFact::NotConstant { place, help }),
    }
}
