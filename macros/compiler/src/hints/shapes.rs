//! Warnings about rods whose centre was probably not meant to be the origin of the body, or their direction not to be x, about disks that were
//! probably not meant to lie across z, and about points that were probably meant as centres.
//!
//! A point at the distance of the whole length lies outside of a rod that has its centre at the origin.

use super::is_zero;
use crate::diag::{Doubt, Warning};
use crate::syntax::ast::{Expression, ExpressionKind, FrameItem, Item, MassItem, Mechanism, every_item};

/// Warnings about bodies with `inertia = rod(l)`, without `center`, and with a point at the distance l along x, in the plane also along y; in space
/// about those with such a point along y or z; about those with `inertia = disk(r)` and one axis, along x or y; and about points called `center`.
pub(crate) fn doubtful_shapes(tree: &Mechanism) -> Vec<Warning> {
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

/// A point on an axis of its body, at the distance of a length.
struct End {
    /// The number of the axis.
    axis: usize,
    /// True on the negative side.
    is_behind: bool,
    /// The number of coordinates.
    of: usize,
}

impl End {
    /// None for a point that lies elsewhere.
    fn of(point: &Expression, length: &Expression) -> Option<End> {
        let ExpressionKind::Tuple(parts) = &point.kind else { return None };
        let axis = parts.iter().position(|part| !is_zero(part))?;
        let (is_behind, part) = match &parts[axis].kind {
            ExpressionKind::Negative(part) => (true, part.as_ref()),
            _ => (false, &parts[axis]),
        };
        let is_end = is_same(part, length) && parts[axis + 1..].iter().all(is_zero);
        is_end.then_some(End { axis, is_behind, of: parts.len() })
    }

    /// The point in the middle between the origin and this one.
    fn middle(&self, half: &str) -> String {
        let sign = if self.is_behind { "-" } else { "" };
        let parts: Vec<String> = (0..self.of).map(|k| if k == self.axis { format!("{sign}{half}") } else { "0m".to_owned() }).collect();
        format!("({})", parts.join(", "))
    }
}

/// A disk or a ring, which lies across z, in a body in space whose only axis is x or y.
fn disk_across(body: &FrameItem, inertia: &MassItem) -> Option<Warning> {
    let mut axes = body.marks.single.iter().filter(|mark| mark.is_axis);
    let (axis, None) = (axes.next()?, axes.next()) else { return None };
    let ExpressionKind::Tuple(parts) = &axis.value.kind else { return None };
    let turn = match parts.as_slice() {
        [x, y, z] if is_zero(x) != is_zero(y) && is_zero(z) => {
            if is_zero(y) {
                "turn((0, 1, 0), 90deg)"
            } else {
                "turn((1, 0, 0), 90deg)"
            }
        }
        _ => return None,
    };
    let (body, axis, instead) = (body.name.to_string(), axis.name.to_string(), format!("{} along {turn}", inertia.value));
    Some(Warning { doubt: Doubt::DiskAcross { body, axis, instead }, range: inertia.value.range })
}

fn of_body(body: &FrameItem) -> Option<Warning> {
    let inertia = body.masses.iter().find(|mass| mass.what == "inertia").filter(|inertia| inertia.along.is_none())?;
    let ExpressionKind::Call(shape, lengths) = &inertia.value.kind else { return None };
    let shape = shape.name.as_ref()?.to_string();
    if ["disk", "ring", "cylinder"].contains(&shape.as_str()) {
        return disk_across(body, inertia);
    }
    let [length] = lengths.as_slice() else { return None };
    let mut points = body.marks.single.iter().filter(|mark| !mark.is_axis && shape == "rod");
    let (point, end) = points.find_map(|mark| Some((mark, End::of(&mark.value, length)?)))?;
    let (body_name, point) = (body.name.to_string(), point.name.to_string());
    // A rod lies along x.
    if end.of == 3 && end.axis > 0 {
        let instead =
            format!("{} along {}", inertia.value, if end.axis == 1 { "turn((0, 0, 1), 90deg)" } else { "turn((0, 1, 0), 90deg)" });
        return Some(Warning { doubt: Doubt::RodAcross { body: body_name, point, instead }, range: inertia.value.range });
    }
    if body.masses.iter().any(|mass| mass.what == "center") {
        return None;
    }
    let half = match &length.kind {
        ExpressionKind::Number { digits, unit } => format!("{digits}{unit} / 2"),
        ExpressionKind::Path(path) => format!("{} / 2", path.last),
        _ => return None,
    };
    let doubt = Doubt::CenteredRod { body: body_name, point, center: end.middle(&half), origin: end.middle("0m").replace('-', "") };
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
