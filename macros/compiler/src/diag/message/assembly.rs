//! Messages about the assembly at the declared defaults.

use super::words::{equation, list, meant};
use crate::diag::{AssemblyFact, Bound, Driven, Gap};
use crate::quantity::{Dim, Role};
use std::fmt::{Display, Formatter, Result};

impl Display for AssemblyFact {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match self {
            AssemblyFact::StaysOpen { joint, gap, others, drives, starts, bound } => {
                write!(f, "`{joint}` stays open by {}", of_gap(gap))?;
                let with = if others.len() == 1 { "is" } else { "are" };
                if !others.is_empty() {
                    write!(f, " when {} {with} closed", list(others))?;
                }
                remedy(f, drives, starts, bound.as_deref())
            }
            AssemblyFact::NeverCloses { joints, drives, starts, bound } => {
                write!(f, "no way was found to close {} together, not even with one of them left open", list(joints))?;
                remedy(f, drives, starts, bound.as_deref())
            }
            AssemblyFact::HasNoValue { joint, row, of, drives, has_none_anywhere, kind } => {
                write!(f, "{}", equation(*row, *of))?;
                let place = if *has_none_anywhere { "at t = 0" } else { "near the start" };
                write!(
                    f,
                    " of `{joint}` has no value {place}: a root or logarithm of something negative, an arc sine beyond 1, a division by zero or a number beyond 1e308"
                )?;
                if *has_none_anywhere {
                    return write!(f, "\nhelp: let `{joint}` have another value at t = 0");
                }
                if kind == "involute_mesh" {
                    return write!(
                        f,
                        "\nhelp: `line` is the direction from `A` to `B`, whose distance exceeds |a + b| times the cosine of `pressure_angle`"
                    );
                }
                write!(f, "\nhelp: declare a `start` at which it has one")?;
                if drives.is_empty() { Ok(()) } else { write!(f, ", or let {} have another value at t = 0", list(drives)) }
            }
            AssemblyFact::ForceWithoutValue { force } => {
                write!(f, "`{force}` has no value at the start: a root of a negative number, a direction between points that coincide, ")?;
                write!(
                    f,
                    "or a division by zero, as by a speed that is zero\nhelp: let the motion begin elsewhere, or write a law with a value there, "
                )?;
                write!(f, "such as `v / sqrt(v^2 + (1mm_s)^2)` for `v / abs(v)`")
            }
            AssemblyFact::HasNoRate { joint, row, of } => {
                write!(f, "{} of `{joint}` has no finite first and second derivative by time at t = 0", equation(*row, *of))?;
                write!(f, "\nhelp: a root of what vanishes there has none: take a law that begins smoothly")
            }
            AssemblyFact::SingularStart { neglected, bodies, in_line, drives, has_others } => {
                let (is, verb) = if bodies.len() == 1 { ("is", "stands") } else { ("are", "stand") };
                if *in_line {
                    write!(f, "the start is singular: {} {is} in line at t = 0", list(bodies))?;
                } else {
                    write!(f, "the start is singular: {} {verb} at a dead point at t = 0", list(bodies))?;
                }
                write!(f, "\nnote: two assemblies meet there, and how fast {} {is} moving is not determined", list(bodies))?;
                meant(f, neglected)?;
                let elsewhere = if *has_others { "declare a `start` that leads to another assembly, or " } else { "" };
                match drives.as_slice() {
                    [] => write!(f, "\nhelp: {elsewhere}change a length or a place"),
                    drives => write!(f, "\nhelp: {elsewhere}let {} have another value at t = 0", list(drives)),
                }
            }
            AssemblyFact::AmbiguousStart { body, owner, coordinate, values, place, turn, is_declared } => {
                let is_angle = *coordinate == Role::Angle;
                let shown = |value: f64| if is_angle { degrees(value) } else { millimetres(value) };
                let [one, other] = values.map(shown);
                let near = if *is_declared { "equally near the declared start" } else { "equally near" };
                write!(f, "two assemblies are {near}: `{owner}.{}` = {one} or {other}", coordinate.name())?;
                let of = if body.contains(['.', '[']) { format!("the body `{body}`") } else { format!("`body {body}`") };
                if let Some(turn) = turn {
                    return write!(f, "\nhelp: write `start orientation = {turn};` in {of}");
                }
                if is_angle {
                    return write!(f, "\nhelp: write `start angle = {}deg;` in {of}", between(*values));
                }
                if coordinate.name() == "z" {
                    return write!(f, "\nhelp: write `start z = {}mm;` in {of}", significant(values[0] * 1e3));
                }
                if *coordinate == Role::Displacement {
                    return write!(f, "\nhelp: write `start {owner}.displacement = {}mm;` outside bodies", significant(values[0] * 1e3));
                }
                let place: Vec<String> = place.iter().map(|value| format!("{}mm", significant(value * 1e3))).collect();
                write!(f, "\nhelp: write `start position = ({});` in {of}", place.join(", "))
            }
            AssemblyFact::MotionEnds { joint, driven, time, in_line, until, declared } => {
                match driven.as_slice() {
                    [only] => write!(f, "{}", stops(only))?,
                    _ => write!(f, "the motion stops")?,
                }
                write!(f, " at t = {} s", significant(*time))?;
                if driven.len() > 1 {
                    write!(f, ", {}", places(driven))?;
                }
                write!(f, ": `{joint}` cannot stay closed beyond that")?;
                if !in_line.is_empty() {
                    write!(f, "\nnote: {} are in line there", list(in_line))?;
                }
                let before = short_of(*time);
                let [from, to] = if *time < 0.0 {
                    [before, declared.map_or(0.0, |declared| declared[1])]
                } else {
                    [declared.map_or(0.0, |declared| declared[0]), before]
                };
                let range = format!("range t in {}s..{}s;", significant(from), significant(to));
                if declared.is_some() {
                    return write!(f, "\nhelp: end the range before it, `{range}`, or change a length");
                }
                write!(
                    f,
                    "\nnote: no `range` is declared, so it is followed until everything repeats itself, to t = {} s",
                    significant(*until)
                )?;
                write!(f, "\nhelp: write `{range}` if it is to go no further, or change a length")
            }
            AssemblyFact::Crosses { driven, time } => {
                write!(f, "two assemblies meet at t = {} s", significant(*time))?;
                if driven.is_empty() { Ok(()) } else { write!(f, ", {}", places(driven)) }
            }
        }
    }
}

/// `crank` stops at 43.8°
fn stops(driven: &Driven) -> String {
    match place(driven) {
        Some(place) => format!("`{}` stops at {place}", driven.name),
        None => format!("`{}` stops", driven.name),
    }
}

/// `crank` at 43.8° and `slider` at x = 30 mm
fn places(driven: &[Driven]) -> String {
    let one = |driven: &Driven| match place(driven) {
        Some(place) => format!("`{}` at {place}", driven.name),
        None => format!("`{}`", driven.name),
    };
    let all: Vec<String> = driven.iter().map(one).collect();
    match all.split_last() {
        Some((last, first)) if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => all.concat(),
    }
}

fn place(driven: &Driven) -> Option<String> {
    let (value, dim) = driven.value?;
    let value = if dim == Dim::ANGLE { degrees(value) } else { millimetres(value) };
    Some(match driven.coordinate.filter(|role| role.is_position()) {
        Some(role) => format!("{} = {value}", role.name()),
        None => value,
    })
}

/// Rounds a time to two digits towards 0, always to less than the time.
fn short_of(time: f64) -> f64 {
    let unit = 10.0_f64.powf(time.abs().log10().floor() - 1.0);
    let whole = (time.abs() / unit * (1.0 - 1e-6)).floor();
    (whole * unit).copysign(time)
}

/// Writes why the mechanism does not close, if that is known, and a remedy.
fn remedy(f: &mut Formatter, drives: &[String], starts: &[String], bound: Option<&Bound>) -> Result {
    if let Some(bound) = bound {
        write!(f, "\nnote: {}", of_bound(bound))?;
    }
    write!(f, "\nhelp: change a length or a place")?;
    if !starts.is_empty() && bound.is_none_or(|bound| !bound.is_always) {
        let each = if starts.len() == 1 { "" } else { "each of " };
        write!(f, ", or declare another `start` of {each}{}", list(starts))?;
    }
    match (drives.is_empty(), bound) {
        (true, _) => Ok(()),
        (_, Some(Bound { is_always: true, .. })) => write!(f, ": no value of {} helps", list(drives)),
        _ => write!(f, ", or let {} have another value at t = 0", list(drives)),
    }
}

/// `50 mm`, `3.5°`, `50 mm and 3.5°`
fn of_gap(Gap { length, angle, other }: &Gap) -> String {
    let mut parts = Vec::new();
    // A part far smaller than the largest is left out; here 1 rad counts as 1 m.
    let most = other.as_ref().map_or(0.0, |(other, _)| *other).max(*length).max(*angle);
    if *length > 1e-6 * most {
        parts.push(millimetres(*length));
    }
    if *angle > 1e-6 * most {
        parts.push(degrees(*angle));
    }
    if let Some((other, unit)) = other
        && *other > 1e-6 * most
    {
        parts.push(format!("{} {unit}", significant(*other)).trim_end().to_owned());
    }
    if parts.is_empty() { "an amount that is not finite".to_owned() } else { parts.join(" and ") }
}

/// `crank` (100 mm) + `coupler` (200 mm) is 30 mm short of `ground` (330 mm)
fn of_bound(bound: &Bound) -> String {
    // As many decimals as the missing length needs.
    let decimals = (1.0 - (bound.missing() * 1e3).log10().floor()).clamp(0.0, 9.0) as usize;
    let fine = |length: f64| format!("{:.decimals$}", length * 1e3).trim_end_matches('0').trim_end_matches('.').to_owned();
    let shown = |length: f64| if bound.missing() < length / 1e3 { format!("{} mm", fine(length)) } else { millimetres(length) };
    let with_length = |(name, length): &(String, f64)| format!("{name} ({})", shown(*length));
    let (missing, span) = (millimetres(bound.missing()), with_length(&bound.span));
    let ways: Vec<String> = bound.ways.iter().filter(|(_, length)| *length > 0.0).map(with_length).collect();
    match ways.len() {
        0 => format!("{span} should be nothing"),
        1 => format!("{} is {missing} shorter than {span}", ways[0]),
        _ => format!("{} is {missing} short of {span}", ways.join(" + ")),
    }
}

pub(crate) fn millimetres(length: f64) -> String {
    format!("{} mm", significant(length * 1e3))
}

pub(crate) fn degrees(angle: f64) -> String {
    format!("{}°", significant(angle.to_degrees()))
}

/// Formats four significant digits, without trailing zeros.
pub(crate) fn significant(value: f64) -> String {
    let digits = if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
    let decimals = (3 - digits).clamp(0, 9) as usize;
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// The first of two angles, in degrees, with as few digits as distinguish it from the other.
fn between([one, other]: [f64; 2]) -> String {
    let (one, other) = (one.to_degrees(), other.to_degrees());
    let decimals = (0..6).find(|decimals| (one - other).abs() * 10.0_f64.powi(*decimals) > 4.0).unwrap_or(6) as usize;
    let text = format!("{one:.decimals$}");
    if text == "-0" { "0".to_owned() } else { text }
}
