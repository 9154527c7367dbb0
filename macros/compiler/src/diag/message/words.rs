//! Formats lists, numbers and the like.

use crate::diag::Neglected;
use std::fmt::{Formatter, Result};

/// The kind of a definition, and the item that declares one.
pub(super) fn declared(is_force: bool) -> [&'static str; 2] {
    if is_force { ["force", "force"] } else { ["constraint", "joint"] }
}

/// `, did you mean …` as a help line, or nothing.
pub(super) fn did_you_mean(near: &Option<String>) -> String {
    near.as_ref().map_or(String::new(), |near| format!("\nhelp: did you mean `{near}`?"))
}

/// `a`, `b` and `c`
pub(super) fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let mut names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    match names.pop() {
        Some(last) if !names.is_empty() => format!("{} and {last}", names.join(", ")),
        Some(only) => only,
        None => String::new(),
    }
}

/// Shortens a long text to its beginning.
pub(super) fn shortened(text: &str) -> String {
    const LONGEST: usize = 60;
    if text.chars().count() <= LONGEST { text.to_owned() } else { text.chars().take(LONGEST / 2).chain(['…']).collect() }
}

/// `a`, `b` and `c`; of a long list only the first names.
pub(super) fn list(names: &[String]) -> String {
    const MOST: usize = 6;
    if names.is_empty() { "nothing".to_owned() } else { first_of(&names[..names.len().min(MOST)], names.len()) }
}

/// `a`, `b` and 4 more: the first of `all` names.
pub(super) fn first_of(first: &[String], all: usize) -> String {
    if all <= first.len() {
        return listed(first.iter().map(String::as_str));
    }
    let names: Vec<String> = first.iter().map(|name| format!("`{name}`")).collect();
    format!("{} and {} more", names.join(", "), all - first.len())
}

/// 1, 2 and 4
pub(super) fn numbers(numbers: &[usize]) -> String {
    let words: Vec<String> = numbers.iter().map(usize::to_string).collect();
    match words.split_last() {
        Some((last, first)) if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => words.concat(),
    }
}

/// Formats three significant digits.
pub(super) fn rounded(value: f64) -> String {
    let digits = (2.0 - value.abs().log10().floor()).clamp(0.0, 12.0);
    let text = format!("{value:.*}", digits as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

pub(super) fn plural(count: usize, noun: &str) -> String {
    match (count, noun.strip_suffix('y')) {
        (1, _) => format!("1 {noun}"),
        (_, Some(stem)) => format!("{count} {stem}ies"),
        (_, None) => format!("{count} {noun}s"),
    }
}

/// Writes small numbers as words.
pub(super) fn counted(number: usize) -> String {
    match number {
        0 => "no".to_owned(),
        1 => "one".to_owned(),
        2 => "two".to_owned(),
        3 => "three".to_owned(),
        many => many.to_string(),
    }
}

/// `no drive`, `only 1 drive`, `only 2 drives`
pub(super) fn drives_there_are(drives: usize, freedoms: usize) -> String {
    let count = |number: usize, one: &str, many: &str| if number == 1 { format!("1 {one}") } else { format!("{number} {many}") };
    let of_freedoms = count(freedoms, "freedom", "freedoms");
    match (drives, freedoms) {
        (0, 0) => "no drive".to_owned(),
        (_, 0) => format!("only {}", plural(drives, "drive")),
        (0, _) => format!("only {of_freedoms} declared"),
        _ => format!("only {} and {of_freedoms} declared", plural(drives, "drive")),
    }
}

/// `a` is, `a` and `b` are
pub(super) fn are(names: &[String]) -> String {
    format!("{} {}", list(names), if names.len() == 1 { "is" } else { "are" })
}

/// Names of the bodies with these coordinates.
pub(super) fn bodies(coordinates: &[String]) -> Vec<String> {
    let mut bodies: Vec<String> = coordinates.iter().filter_map(|name| name.rsplit_once('.')).map(|(body, _)| body.to_owned()).collect();
    bodies.dedup();
    bodies
}

/// A point that may be meant in the place of another.
pub(super) fn meant(f: &mut Formatter, neglected: &Option<Box<Neglected>>) -> Result {
    let Some(neglected) = neglected else { return Ok(()) };
    let Neglected { point, taken, joints } = &**neglected;
    write!(f, "\nhelp: {} take `{taken}`, and nothing takes `{point}`: is it meant in one of them?", list(joints))
}

/// `that`, or `one of them`
pub(super) fn one_of(names: &[String]) -> &'static str {
    if names.len() == 1 { "that" } else { "one of them" }
}

/// `2 arguments`, `2 or 3 arguments`, `2 to 4 arguments`
pub(super) fn range_of([least, most]: &[usize; 2], noun: &str) -> String {
    match most - least {
        0 => plural(*most, noun),
        1 => format!("{least} or {}", plural(*most, noun)),
        _ => format!("{least} to {}", plural(*most, noun)),
    }
}

/// `the equation`, or `equation 2 of 3` where there are more.
pub(super) fn equation(row: usize, of: usize) -> String {
    if of == 1 { "the equation".to_owned() } else { format!("equation {row} of {of}") }
}

/// True for words for a velocity.
pub(super) fn is_rate(name: &str) -> bool {
    ["rate", "velocity", "speed", "vel", "dot", "vx", "vy", "vz"].contains(&name)
}

/// True for words for velocities at the start.
pub(super) fn is_velocity(name: &str) -> bool {
    is_rate(name) || ["angular_velocity", "omega", "initial_velocity", "angular_speed", "vx", "vy"].contains(&name)
}

/// True for words for loads.
pub(super) fn is_load(name: &str) -> bool {
    ["force", "torque", "effort", "power", "load", "loads", "reaction"].contains(&name)
}

/// True for words for an acceleration.
pub(super) fn is_acceleration(name: &str) -> bool {
    ["acceleration", "accel", "ddot", "angular_acceleration"].contains(&name)
}
