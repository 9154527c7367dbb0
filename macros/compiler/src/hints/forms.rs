//! Forms of expressions that are often written for others.

use crate::syntax::ast::{Expression, ExpressionKind};

/// The two factors of `cross(a, b)`.
pub(crate) fn cross_product(value: &Expression) -> Option<[&Expression; 2]> {
    match &value.kind {
        ExpressionKind::Call(path, arguments) if path.last == "cross" => arguments.iter().collect::<Vec<_>>().try_into().ok(),
        _ => None,
    }
}

/// True for a zero that is written out, as a number or as a vector.
pub(crate) fn is_zero(value: &Expression) -> bool {
    match &value.kind {
        ExpressionKind::Number { digits, .. } => digits.parse() == Ok(0.0),
        ExpressionKind::Tuple(items) => items.iter().all(is_zero),
        _ => false,
    }
}

/// The name of a point that is written `body.point`.
pub(crate) fn point_of(value: &Expression, body: &str) -> Option<String> {
    let ExpressionKind::Field(owner, point) = &value.kind else { return None };
    let ExpressionKind::Path(path) = &owner.kind else { return None };
    (path.name.as_ref()? == body).then(|| point.to_string())
}
