//! Warnings about rods whose centre was probably not meant to be the origin of the body.
//!
//! A point at the distance of the whole length lies outside of a rod that has its centre at the origin.

use super::is_zero;
use crate::diag::{Doubt, Warning};
use crate::syntax::ast::{Expression, ExpressionKind, Feature, FrameItem, Item, Mechanism, every_item};

/// Warnings about bodies with `inertia = rod(l)`, without `center`, and with a point at `(l, 0)`.
pub(crate) fn centered_rods(tree: &Mechanism) -> Vec<Warning> {
    let body = |item: &Item| if let Item::Body(body) = item { of_body(body) } else { None };
    every_item(&tree.items).filter_map(body).collect()
}

fn of_body(body: &FrameItem) -> Option<Warning> {
    if body.masses.iter().any(|mass| mass.what == "center") {
        return None;
    }
    let inertia = body.masses.iter().find(|mass| mass.what == "inertia")?;
    let ExpressionKind::Call(shape, lengths) = &inertia.value.kind else { return None };
    let [length] = lengths.as_slice() else { return None };
    let is_rod = shape.name.as_ref().is_some_and(|name| name == "rod");
    let components = |point: &Expression| match &point.kind {
        ExpressionKind::Tuple(parts) => match parts.split_first() {
            Some((along, across)) if is_same(along, length) && across.iter().all(is_zero) => parts.len(),
            _ => 0,
        },
        _ => 0,
    };
    let is_at_end = |mark: &Feature| is_rod && inertia.along.is_none() && !mark.is_axis && components(&mark.value) > 0;
    let point = body.marks.single.iter().find(|mark| is_at_end(mark))?;
    let zeros = ", 0m".repeat(components(&point.value).saturating_sub(1));
    let half = match &length.kind {
        ExpressionKind::Number { digits, unit } => format!("{digits}{unit} / 2"),
        ExpressionKind::Path(path) => format!("{} / 2", path.last),
        _ => return None,
    };
    let [center, origin] = [half.as_str(), "0m"].map(|along| format!("({along}{zeros})"));
    let doubt = Doubt::CenteredRod { body: body.name.to_string(), point: point.name.to_string(), center, origin };
    Some(Warning { doubt, range: inertia.value.range })
}

/// True if two lengths are written alike.
fn is_same(one: &Expression, two: &Expression) -> bool {
    match (&one.kind, &two.kind) {
        (ExpressionKind::Number { digits: one, unit: of_one }, ExpressionKind::Number { digits: two, unit: of_two }) => {
            one == two && of_one == of_two
        }
        (ExpressionKind::Path(one), ExpressionKind::Path(two)) => one.name.is_some() && one.name == two.name,
        _ => false,
    }
}
