//! Warnings about rods whose centre was probably not meant to be the origin of the body, or their direction not to be x, and about points that
//! were probably meant as centres.
//!
//! A point at the distance of the whole length lies outside of a rod that has its centre at the origin.

use super::is_zero;
use crate::diag::{Doubt, Warning};
use crate::syntax::ast::{Expression, ExpressionKind, Feature, FrameItem, Item, MassItem, Mechanism, every_item};

/// Warnings about bodies with `inertia = rod(l)`, without `center`, and with a point at `(l, 0)`; about those with a point at `(0, l, 0)` or
/// `(0, 0, l)`; and about points called `center`.
pub(crate) fn centered_rods(tree: &Mechanism) -> Vec<Warning> {
    let body = |item: &Item| if let Item::Body(body) = item { of_body(body) } else { None };
    let all = every_item(&tree.items);
    all.filter_map(body).chain(every_item(&tree.items).filter_map(point_called_center)).collect()
}

/// A body with a mass whose only centre is a point of that name.
fn point_called_center(item: &Item) -> Option<Warning> {
    let Item::Body(body) = item else { return None };
    let [mass, center] = ["mass", "center"].map(|word| body.masses.iter().any(|mass| mass.what == word));
    let point = body
        .marks
        .single
        .iter()
        .find(|mark| !mark.is_axis && mark.name == "center" && !is_zero(&mark.value))
        .filter(|_| mass && !center)?;
    Some(Warning { doubt: Doubt::PointCalledCenter { body: body.name.to_string() }, range: (&point.name).into() })
}

/// A rod, which lies along x, in a body in space with a point at its length along y or z.
fn across(body: &FrameItem, inertia: &MassItem, length: &Expression) -> Option<Warning> {
    let along = |point: &Expression| match &point.kind {
        ExpressionKind::Tuple(parts) => match parts.as_slice() {
            [x, y, z] if is_zero(x) && is_same(y, length) && is_zero(z) => Some("turn((0, 0, 1), 90deg)"),
            [x, y, z] if is_zero(x) && is_zero(y) && is_same(z, length) => Some("turn((0, 1, 0), 90deg)"),
            _ => None,
        },
        _ => None,
    };
    let mut points = body.marks.single.iter().filter(|mark| !mark.is_axis);
    let (point, turn) = points.find_map(|mark| Some((mark, along(&mark.value)?)))?;
    let (body, point, instead) = (body.name.to_string(), point.name.to_string(), format!("{} along {turn}", inertia.value));
    Some(Warning { doubt: Doubt::RodAcross { body, point, instead }, range: inertia.value.range })
}

fn of_body(body: &FrameItem) -> Option<Warning> {
    let inertia = body.masses.iter().find(|mass| mass.what == "inertia")?;
    let ExpressionKind::Call(shape, lengths) = &inertia.value.kind else { return None };
    let [length] = lengths.as_slice() else { return None };
    let is_rod = shape.name.as_ref().is_some_and(|name| name == "rod");
    if let Some(warning) = across(body, inertia, length).filter(|_| is_rod && inertia.along.is_none()) {
        return Some(warning);
    }
    if body.masses.iter().any(|mass| mass.what == "center") {
        return None;
    }
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
