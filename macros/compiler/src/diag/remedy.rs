//! Suggested corrections, from what was found and what was expected.

use crate::quantity::Dim;

/// For a value of the wrong kind; empty if there is no suggestion.
pub(super) fn of_kind(wanted: &str, found: &str) -> &'static str {
    match (wanted, found) {
        ("a number", "a body") | ("a number or a vector", "a body") => {
            "\nhelp: its coordinates are `.x`, `.y` and `.angle`, its place is `.position`"
        }
        ("a number", "a point" | "a vector" | "an axis") => "\nhelp: its components are `.x` and `.y`, its length is `norm(…)`",
        ("a number" | "a number or a vector", "a function") => "\nhelp: give it its argument, as in `f(x)`",
        ("a number" | "a number or a vector", "a joint") => "\nhelp: what it was made with has values, as in `joint.P`",
        ("a number", "a string" | "text") => "\nhelp: a quantity is a number with its unit right behind it, such as `120mm`",
        ("a function", "a number") => "\nhelp: a product is written with `*`",
        ("a vector or a point", "a number") => "\nhelp: write both components, `(x, y)`",
        ("a vector or a point", "a body") => "\nhelp: its place is `.position`",
        ("a point", "a number") => "\nhelp: write `(x, y)` for a place in ground, `body.P` for a point of a body",
        ("an axis", "a number") => "\nhelp: write `(1, 0)` for the direction of x",
        ("an axis in space", _) => "\nhelp: write `(1, 0, 0)` for the direction of x",
        ("a function of one variable", _) => "\nhelp: declare one, such as `function name(x: Angle) -> Length = …;`",
        _ => "",
    }
}

/// For two values that cannot be equated.
pub(super) fn of_equation(one: &str, two: &str, in_space: bool) -> &'static str {
    match (one, two) {
        ("a number", "a point" | "a vector" | "an axis") | ("a point" | "a vector" | "an axis", "a number") if in_space => {
            "\nhelp: write `.x`, `.y` or `.z` for one component, or `(x, y, z)` on the other side for all"
        }
        ("a body", "a body") if in_space => "\nhelp: `weld` holds two bodies together; the place of a body is `.position`",
        ("a body", _) | (_, "a body") if in_space => "\nhelp: its place is `.position`; angles are those of joints, `joint.angle`",
        ("a number", "a point" | "a vector" | "an axis") | ("a point" | "a vector" | "an axis", "a number") => {
            "\nhelp: write `.x` or `.y` for one component, or `(x, y)` on the other side for both"
        }
        ("a body", "a body") => "\nhelp: `weld` holds two bodies together; their numbers are `.x`, `.y` and `.angle`",
        ("a body", _) | (_, "a body") => "\nhelp: its coordinates are `.x`, `.y` and `.angle`, its place is `.position`",
        _ => "",
    }
}

/// For two quantities with different dimensions.
pub(super) fn of_dimensions(one: Dim, two: Dim) -> &'static str {
    let is_rate = |rate: Dim, of: Dim| rate.times(Dim::TIME) == of && !of.is_of_time();
    if is_rate(one, two) || is_rate(two, one) {
        return "\nhelp: multiply the rate by `t`";
    }
    if one.is_of_time() || two.is_of_time() {
        return match (one, two) {
            (Dim::ANGLE, _) | (_, Dim::ANGLE) => "\nhelp: give `t` a factor with a unit, such as `2rad_s * t`",
            (Dim::LENGTH, _) | (_, Dim::LENGTH) => "\nhelp: give `t` a factor with a unit, such as `2mm_s * t`",
            _ => "\nhelp: give `t` a factor with a unit, such as `2rad_s * t` for an angle, `2mm_s * t` for a length",
        };
    }
    match (one, two) {
        (Dim::LENGTH, Dim::ANGLE) | (Dim::ANGLE, Dim::LENGTH) => "\nhelp: an arc is a radius times an angle",
        _ => "",
    }
}

/// A value in the units of a drawing, `5 mm` or `30°`; other dimensions in SI.
pub(crate) fn quantity(value: f64, dim: Dim) -> String {
    // Twelve decimals, so that the conversion of units preserves decimal fractions.
    let short = |value: f64| format!("{:.12}", value).trim_end_matches('0').trim_end_matches('.').to_owned();
    match dim {
        Dim::ANGLE => format!("{}°", short(value.to_degrees())),
        Dim::LENGTH => format!("{} mm", short(value * 1e3)),
        _ => format!("{value} {}", dim.unit()).trim_end().to_owned(),
    }
}
