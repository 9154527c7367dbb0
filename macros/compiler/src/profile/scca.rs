//! `scca(u, b, c)`: a rise from 0 to 1 whose acceleration is sine, constant, cosine, constant and sine.
//!
//! b and c are the shares of the duration in which the acceleration is a quarter of a sine at both ends and constant; for the rest, d, it is
//! half a cosine:
//!
//! ```text
//!   0   … b/2          A sin(πu/b)                 d = 1 − b − c
//!   b/2 … (1 − d)/2    A
//!   (1 − d)/2 … 1/2    A cos(π/d (u − (1 − d)/2))  then the same backwards, negative
//!
//!   A = 4π² / ((π² − 8)(b² − d²) − 2π(π − 2) b + π²)
//! ```
//!
//! Reference: Norton, Cam Design and Manufacturing Handbook, chapter 3, on the SCCA family.

use super::{SCCA, Valuer, constant};
use crate::diag::{ArityFact, ValueFact};
use crate::expr::{Exact, Expr};
use crate::names::{Scalar, Scope, Value};
use crate::quantity::{Dim, InferredDim};
use crate::syntax::{ast, parse_formula};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// The expression of the law.
pub(super) fn scca(work: &mut impl Valuer, name: &Ident, arguments: &[ast::Expression], scope: &Scope) -> Option<Scalar> {
    let [u, b, c] = arguments else {
        return work.reject(name.into(), ArityFact::FunctionArity { name: SCCA.to_owned(), wanted: 3, found: arguments.len() });
    };
    let (u, sine, constant) = (number(work, u, scope)?, share(work, b, scope)?, share(work, c, scope)?);
    let cosine = rest(sine, constant);
    let Some(cosine) = cosine.filter(|cosine| [sine, constant, *cosine].iter().all(|share| share.signum() >= 0)) else {
        let found = [sine, constant].map(Exact::to_f64);
        return work.reject(name.into(), ValueFact::SharesOfLaw { found });
    };
    let bound = [("u", u)]
        .into_iter()
        .chain([("b", sine), ("c", constant), ("d", cosine)].map(|(name, share)| (name, work.arena().constant(share))));
    let value = |expr| Value::Scalar(Scalar { expr, measure: InferredDim::Known(Dim::NUMBER) });
    let mut scope = Scope { bound: bound.map(|(name, expr)| (name.to_owned(), value(expr))).collect(), ..Scope::default() };
    let peak = formula(work, name, quote!(4 * pi ^ 2 / ((pi ^ 2 - 8) * (b ^ 2 - d ^ 2) - 2 * pi * (pi - 2) * b + pi ^ 2)), &scope)?;
    scope.bound.push(("A".to_owned(), value(peak)));
    let law = rise([sine, constant, cosine].map(|share| !share.is_zero()));
    Some(Scalar { expr: formula(work, name, law, &scope)?, measure: InferredDim::Known(Dim::NUMBER) })
}

/// The law in its parts, of which only those that last are written.
fn rise([sine, constant, cosine]: [bool; 3]) -> TokenStream {
    let parts = [
        (sine, quote!(b / 2), quote!(A * (b / pi * u - (b / pi) ^ 2 * sin(pi * u / b)))),
        (constant, quote!((1 - d) / 2), quote!(A * (u ^ 2 / 2 + b * (1 / pi - 1 / 2) * u + b ^ 2 * (1 / 8 - 1 / pi ^ 2)))),
        (cosine, quote!((1 + d) / 2), quote!(1 / 2 + A * ((b / pi + c / 2) * (u - 1 / 2) + (d / pi) ^ 2 * sin(pi / d * (u - 1 / 2))))),
        (constant, quote!(1 - b / 2), quote!(1 - A * ((1 - u) ^ 2 / 2 + b * (1 / pi - 1 / 2) * (1 - u) + b ^ 2 * (1 / 8 - 1 / pi ^ 2)))),
        (sine, quote!(1), quote!(1 - A * (b / pi * (1 - u) - (b / pi) ^ 2 * sin(pi * (1 - u) / b)))),
    ];
    let mut lasting = parts.into_iter().filter(|(lasts, ..)| *lasts).rev();
    // NaN is not less, and takes the last part, which contains u.
    let last = lasting.next().map_or_else(|| quote!(u), |(_, _, value)| value);
    let inside = lasting.fold(last, |after, (_, end, value)| quote!(if u < #end { #value } else { #after }));
    quote!(if u < 0 { 0 } else if 1 < u { 1 } else { #inside })
}

/// The value of a formula of the language.
fn formula(work: &mut impl Valuer, name: &Ident, formula: TokenStream, scope: &Scope) -> Option<Expr> {
    let Some(expression) = parse_formula(formula) else { return work.reject(name.into(), ValueFact::NotALaw) };
    Some(work.number(&expression, scope)?.expr)
}

/// 1 − b − c, without the rounding of shares that fill the duration.
fn rest(sine: Exact, constant: Exact) -> Option<Exact> {
    let exact = sine.checked_add(constant).and_then(|sum| Exact::ONE.checked_sub(sum));
    let rest = exact.or_else(|| Exact::binary(1.0 - sine.to_f64() - constant.to_f64()))?;
    if rest.to_f64().abs() < 4.0 * f64::EPSILON { Some(Exact::ZERO) } else { Some(rest) }
}

/// An argument without a unit.
fn number(work: &mut impl Valuer, argument: &ast::Expression, scope: &Scope) -> Option<Expr> {
    let scalar = work.number(argument, scope)?;
    if !scalar.measure.fits(Dim::NUMBER) {
        return work.reject(argument.range, ValueFact::WrongDimension { wanted: Dim::NUMBER, found: scalar.measure.settled() });
    }
    Some(scalar.expr)
}

/// A share of the duration.
fn share(work: &mut impl Valuer, argument: &ast::Expression, scope: &Scope) -> Option<Exact> {
    let expr = number(work, argument, scope)?;
    match constant(work, expr) {
        Some(share) => Some(share),
        None => work.reject(argument.range, ValueFact::NotConstant { place: "a share of `scca`", help: "" }),
    }
}
