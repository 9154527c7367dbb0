//! All messages of the compiler. Stages report facts with their numbers; only this module contains text.
//!
//! A message starts lower-case and ends without a full stop. Code is in backticks, a suggestion follows `help:`, a further fact follows
//! `note:`.

mod arity;
mod arrays;
mod assembly;
mod equations;
mod grammar;
mod kinds;
mod motion;
mod names;
mod system;
mod values;
mod words;

pub(crate) use assembly::{degrees, millimetres, significant};

use super::{AngleOf, Doubt, Fact, Note, ValueFact};
use crate::quantity::Dim;
use std::fmt;

impl Fact {
    /// The message of a compile error, with the code at the end of the first line.
    ///
    /// There the code is visible even if only first lines are shown, and can be searched for.
    #[must_use]
    pub fn message(&self) -> String {
        let sentence = self.to_string();
        let (first, rest) = parted(&sentence);
        format!("{first} [reuleaux::{}]{rest}", self.code())
    }
}

/// A message up to its first suggestion.
fn without_help(fact: &Fact) -> String {
    let sentence = fact.to_string();
    sentence.split("\nhelp").next().unwrap_or_default().to_owned()
}

/// Splits a message after its first line.
fn parted(sentence: &str) -> (&str, &str) {
    sentence.split_at(sentence.find('\n').unwrap_or(sentence.len()))
}

impl fmt::Display for Fact {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Fact::Grammar(fact) => fact.fmt(f),
            Fact::Array(fact) => fact.fmt(f),
            Fact::Name(fact) => fact.fmt(f),
            Fact::Arity(fact) => fact.fmt(f),
            Fact::Value(fact) => fact.fmt(f),
            Fact::Equation(fact) => fact.fmt(f),
            Fact::System(fact) => fact.fmt(f),
            Fact::Assembly(fact) => fact.fmt(f),
            Fact::Motion(fact) => fact.fmt(f),
            Fact::InInstance { place, fact } => {
                let sentence = fact.to_string();
                let (first, rest) = parted(&sentence);
                write!(f, "{first}\nnote: {place}{}", as_seen_inside(place, rest))
            }
            Fact::Noted { fact, note: Note::DeclaredUnit { name, instead } } => {
                write!(
                    f,
                    "{}\nnote: `{name}` is declared in this mechanism, so it is no unit here\nhelp: a unit is one word: write `{instead}`",
                    without_help(fact)
                )
            }
            Fact::Noted { fact, note: Note::Instead { written } } => write!(f, "{}\nhelp: write `{written}`", without_help(fact)),
            Fact::Noted { fact, note: Note::WithoutTime { written } } => {
                write!(f, "{}\nhelp: take the factor `t` away: `{written}`", without_help(fact))
            }
            Fact::Noted { fact, note: Note::BareFactor { number, instead } } => {
                write!(f, "{}\nhelp: `{number}` has no unit: write `{instead}`", without_help(fact))
            }
            Fact::Doubtful { fact, doubt } if matches!(**doubt, Doubt::ShaftsForArms { .. }) => {
                write!(f, "{}\nnote: {doubt}", without_help(fact))
            }
            Fact::Doubtful { fact, doubt } => write!(f, "{fact}\nnote: {doubt}"),
            Fact::InDefinition { definition, quantities, fact } => {
                write!(f, "in {definition}: {fact}")?;
                let words: Vec<String> = quantities.iter().map(|(name, dim)| format!("`{name}` is {dim}")).collect();
                if words.is_empty() {
                    return Ok(());
                }
                write!(f, "\nnote: here {}", words.join(", "))?;
                let dim = |name: &str| quantities.iter().find(|(known, _)| known == name).map(|(_, dim)| *dim);
                match (&**fact, [dim("a"), dim("b")]) {
                    (Fact::Value(ValueFact::Unlike { .. }), [Some(a), Some(b)]) if a != b && [a, b].contains(&Dim::LENGTH) => {
                        write!(f, "\nhelp: give `a` and `b` alike: two numbers, such as teeth, or two lengths")
                    }
                    _ => Ok(()),
                }
            }
        }
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Doubt::FarStart { what, coordinate, found, declared, apart, drive, instead } => {
                match drive {
                    Some(drive) => write!(f, "`{drive}` puts `{what}` at {found} at t = 0")?,
                    None => write!(f, "the nearest assembly has `{what}` at {found}")?,
                }
                write!(f, ", {apart} from its declared start at {declared}")?;
                write!(f, "\nhelp: write `start {coordinate} = {instead};`, or `#[allow(far_start)]` before the mechanism")
            }
            Doubt::FarOrientation { body, angle, apart, drive, instead } => {
                match (drive, angle) {
                    (Some(drive), Some((angle, found))) => write!(f, "`{drive}` turns `{body}` to `{angle}` = {found} at t = 0")?,
                    (None, Some((angle, found))) => write!(f, "the nearest assembly has `{body}` at `{angle}` = {found}")?,
                    (_, None) => write!(f, "the joints keep `{body}`")?,
                }
                let turned = if angle.is_some() { ", turned" } else { " turned" };
                write!(f, "{turned} {apart} away from its declared start")?;
                write!(f, "\nhelp: write `start orientation = {instead};`, or `#[allow(far_start)]` before the mechanism")
            }
            Doubt::BareLength { number, longest } => {
                write!(f, "`{number}` has no unit: it is {number} m, where no other length exceeds {longest}")?;
                write!(f, "\nhelp: write `{number}mm`, or `{number}m` if it is meant")
            }
            Doubt::BareAngle { of, number } => {
                let in_unit = |unit: &str| match of {
                    AngleOf::Function(function) => format!("{function}({number}{unit})"),
                    AngleOf::Start | AngleOf::Law | AngleOf::Argument | AngleOf::Part | AngleOf::Parameter(_) => format!("{number}{unit}"),
                };
                write!(f, "`{number}` has no unit: it is {number} rad")?;
                match of {
                    AngleOf::Law => {
                        write!(
                            f,
                            ", at which the drive stands still\nhelp: write `{number}rpm * t` for a speed, or `{number}deg` for an angle"
                        )
                    }
                    AngleOf::Parameter(name) => write!(f, " where it is an angle\nhelp: write `{name}: Angle = {}`", in_unit("deg")),
                    AngleOf::Start | AngleOf::Function(_) | AngleOf::Argument | AngleOf::Part => {
                        write!(f, "\nhelp: write `{}`, or `{}` if it is meant", in_unit("deg"), in_unit("rad"))
                    }
                }
            }
            Doubt::BareSpeed { number } => {
                let in_rpm = number.parse::<f64>().map_or(f64::NAN, |value| (value * 30.0 / std::f64::consts::PI).round());
                write!(f, "`{number}` has no unit: it is {number} rad/s, {in_rpm} rpm")?;
                write!(f, "\nhelp: write `{number}rpm`, or `{number}rad_s` if it is meant")
            }
            Doubt::Unlikely { flaw, help, .. } => write!(f, "{flaw}\nhelp: {help}"),
            Doubt::RaisedNumber { written, meaning, instead } => {
                write!(f, "`{written}` raises the number, too: it is `{meaning}`\nhelp: write `{instead}`, or `{meaning}` if it is meant")
            }
            Doubt::TurnsAsAngle { written } => {
                write!(f, "`{written}` counts turns, and as an angle it is taken in radians")?;
                write!(f, "\nhelp: write `1turn * {written}`, or give an `AngularVelocity` instead of a `Frequency`")
            }
            Doubt::InputByTime { input } => {
                write!(f, "a change of `{input}` acts over all the time before it: `{input} * t` jumps")?;
                write!(f, "\nhelp: a commanded speed is a `param` of a mechanism that is `#[integrated]`: see the page on control loops")
            }
            Doubt::GravityWithoutMass => {
                write!(f, "gravity acts on masses, and no body has one\nhelp: write `mass = 1kg;` in a body, or take `gravity` away")
            }
            Doubt::UnusualGravity { found, instead } => {
                write!(f, "the acceleration of free fall is {found} here, and 9.81 m/s² on Earth\nhelp: write `{instead}`")
            }
            Doubt::WideInertia { body, radius, longest } => {
                write!(f, "the inertia of `{body}` is that of its mass at a distance of {radius}, where no length exceeds {longest}")?;
                write!(f, "\nhelp: a number without a unit is in kg m²; write `kgm2`, `kgcm2` or `kgmm2`")
            }
            Doubt::RodAcross { body, point, instead } => {
                write!(f, "a rod lies along x, but `{point}` of `{body}` lies across it\nhelp: write `inertia = {instead};`")
            }
            Doubt::ShaftsForArms { joint } => {
                write!(
                    f,
                    "`{joint}` is given two axes in line, as shafts are; those of a universal joint are the arms of its cross, at right angles"
                )?;
                write!(
                    f,
                    "\nhelp: declare them across the shafts, such as `axis arm = (0, 0, 1);` in one body and `axis arm = (0, 1, 0);` in the other"
                )
            }
            Doubt::DiskAcross { body, axis, instead } => {
                let shape = instead.split(" along").next().unwrap_or(instead);
                write!(f, "the axis of `{shape}` lies along z, but `{axis}` of `{body}` lies across it\nhelp: write `inertia = {instead};`")
            }
            Doubt::NegativeCoefficient { written, is_damping: true } => {
                write!(
                    f,
                    "`{written}` drives the motion instead of damping it\nhelp: take the minus away, or name the number with `let` if it is meant"
                )
            }
            Doubt::NegativeCoefficient { written, .. } => {
                write!(f, "`{written}` pushes away from rest\nhelp: take the minus away, or name the number with `let` if it is meant")
            }
            Doubt::NegativeRest { written, of } => {
                write!(
                    f,
                    "`{written}` is negative, and no {of} is\nhelp: take the minus away, or name the number with `let` if it is meant"
                )
            }
            Doubt::ConvertedTwice { written, instead } => {
                write!(f, "`{written}` converts a quantity that carries its unit already\nhelp: write `{instead}`")
            }
            Doubt::ProgramEnds { function } => {
                write!(f, "`{function}` is a program of a whole turn, after which the follower stays at rest")?;
                write!(f, "\nhelp: write `segments(…, periodic)` if it begins anew with each turn, or `hold` if it does not")
            }
            Doubt::RiseOfOne { written } => {
                write!(
                    f,
                    "`{written}` leads from 0 to 1, and as an angle to 1 rad\nhelp: write `90deg * {written}` for a quarter of a turn"
                )
            }
            Doubt::NumberAsPhase { written, gears } => {
                write!(f, "`{written}` is `c` of `{gears}`, the angle in which the gears mesh at the start, and no size of a gear")?;
                write!(f, "\nhelp: take it away: two sizes belong to `{gears}`, and pressure angles do not matter; or write `c: {written}`")
            }
            Doubt::PercentageOfFriction { written, instead } => {
                write!(f, "a coefficient of friction of {written} is rare\nhelp: write `{instead}` for {written} per cent")
            }
            Doubt::GravityUpwards { written } => {
                write!(f, "gravity points upwards here\nhelp: write `-{written}`, or name the number with `let` if it is meant")
            }
            Doubt::TurnsAsSpeed { written, in_rpm } => {
                write!(
                    f,
                    "`{written}` is a number of radians a second\nhelp: write `{in_rpm}` for as many turns, or `rad_s` if radians are meant"
                )
            }
            Doubt::PeriodsAsAngle { written, instead } => {
                write!(f, "`{written}` is taken in radians\nhelp: write `{instead}`")
            }
            Doubt::PointCalledCenter { body } => {
                write!(
                    f,
                    "`center` is a point here, and the centre of mass of `{body}` is its origin\nhelp: write `center = (…);` for the centre of mass"
                )
            }
            Doubt::CenteredRod { body, point, center, origin } => {
                write!(f, "`{body}` has its centre of mass at its origin, so that its rod ends at half the distance of `{point}`")?;
                write!(f, "\nhelp: write `center = {center};`, or `center = {origin};` if the origin is meant")
            }
            Doubt::Undercut { joint, angle, radius, roller: Some(roller) } => {
                write!(
                    f,
                    "the cam of `{joint}` is undercut at ψ = {angle}: its pitch curve has a radius of {radius} there, the roller one of {roller}"
                )?;
                write!(f, "\nhelp: take a larger base circle, a smaller roller or a longer rise")
            }
            Doubt::Undercut { joint, angle, radius, roller: None } => {
                write!(
                    f,
                    "the cam of `{joint}` is not convex at ψ = {angle}, and its face would cut into it: the radius of the outline is {radius} there"
                )?;
                write!(f, "\nhelp: take a larger base circle or a longer rise")
            }
            Doubt::GearsApart { joint, distance, needed, is_internal } => {
                let how = if *is_internal { "differ by" } else { "add up to" };
                write!(f, "the axes of the gears of `{joint}` are {distance} apart, and their radii {how} {needed}")?;
                write!(f, "\nhelp: change a radius, or the place of an axis")
            }
            Doubt::DegreesInOutput { written, angle } => {
                write!(f, "`{written}` is an angle, and outputs of angles are in rad: it is 57 times too large")?;
                write!(f, "\nhelp: write `{angle} / 1deg` for the number of degrees, or `.to_degrees()` in Rust")
            }
            Doubt::CarrierAsRing { carrier, instead } => {
                write!(f, "`{carrier}` is in the place of the ring gear\nhelp: write `{instead}`: sun gear, ring gear, carrier")
            }
            Doubt::RingInsideSun { joint, ring, sun } => {
                write!(f, "the ring gear of `{joint}` ({ring}) is not larger than the sun gear inside it ({sun})")?;
                write!(f, "\nhelp: the sun gear comes first, as in `z_sun: 20, z_ring: 60`; the teeth of the planets are not given")
            }
            Doubt::MotionEnds(fact) => write!(f, "{fact}"),
            Doubt::UnusedImport { name } => write!(f, "nothing in this mechanism uses `{name}`\nhelp: remove `{name}` from `use`"),
        }
    }
}

/// Help with names as they are typed in a part or in a loop: without the name of the part, and with the variable of the loop.
///
/// * `place`: given, as in "in `leg`", "here `i` is 0" or "in `leg`, where `i` is 0".
fn as_seen_inside(place: &str, help: &str) -> String {
    let mut quoted = place.split('`').skip(1).step_by(2);
    let part = quoted.next().filter(|_| place.starts_with("in "));
    let mut seen = help.to_owned();
    // The place is a part, or an item of one.
    let owner = part.and_then(|item| item.rsplit_once('.')).map(|(owner, _)| owner);
    for prefix in part.into_iter().chain(owner) {
        for before in ["`", " ", "(", "-"] {
            seen = seen.replace(&format!("{before}{prefix}."), before);
        }
    }
    // Of several variables the values may be the same.
    let clause = place.split_once("here `").map(|(_, clause)| clause).filter(|clauses| !clauses.contains(" and "));
    if let Some((name, value)) = clause.and_then(|clause| clause.split_once("` is ")) {
        seen = seen.replace(&format!("[{value}]"), &format!("[{name}]"));
    }
    seen
}
