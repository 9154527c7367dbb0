//! Messages about joints, drives and definitions, each on its own.

use super::words::equation;
use crate::diag::EquationFact;
use crate::quantity::Ambient;
use std::fmt::{Display, Formatter, Result};

impl Display for EquationFact {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match self {
            EquationFact::TimeIn { place } => {
                write!(f, "{place} does not change with time: `t` cannot be used in it")?;
                match *place {
                    "the default of a parameter" => write!(f, "\nhelp: write `let name = …;` for a law"),
                    "a point or an axis" => {
                        write!(f, "\nhelp: declare a body with drives, such as `drive lift = drive_y(base.position, …);`")?;
                        write!(f, ", and write its points and axes in their place")
                    }
                    _ => Ok(()),
                }
            }
            EquationFact::InputIn { place, input } => {
                write!(f, "{place} does not change with time: the input `{input}` cannot be used in it")
            }
            EquationFact::InputInJoint { joint, input } => {
                write!(
                    f,
                    "a joint does not change with time, the input `{input}` is for drives\nhelp: write `drive {joint} = …;` for `joint {joint} = …;`"
                )
            }
            EquationFact::TimeInDefinition => {
                write!(
                    f,
                    "`t` is not known in a definition\nhelp: take the law as a parameter, such as `C: Length`, and let a `drive` pass it"
                )
            }
            EquationFact::TimeInJoint { joint, has_places } => {
                write!(f, "a joint does not change with time, `t` is for drives\nhelp: ")?;
                if *has_places {
                    return write!(
                        f,
                        "a place that moves is that of a body with drives, such as `drive lift = drive_y(base.position, …);`"
                    );
                }
                write!(f, "write `drive {joint} = …;` for `joint {joint} = …;`")
            }
            EquationFact::RequirementFails { why, instead } => {
                write!(f, "{why}")?;
                instead.as_ref().map_or(Ok(()), |instead| write!(f, "\nhelp: {instead}"))
            }
            EquationFact::RequirementFailsAtDefaults { why, value } => write!(f, "{why}\nnote: it is {value} at the declared defaults"),
            EquationFact::RowOfNothing { joint, row, of, at_defaults } => {
                let when = if *at_defaults { ", at the declared defaults" } else { "" };
                write!(f, "{} of `{joint}` does not depend on the position of any body{when}", equation(*row, *of))
            }
            EquationFact::EquationInForce => {
                write!(f, "a force has no equations\nhelp: write `at point: force;` or `on body: torque;`, and equations in a `joint`")
            }
            EquationFact::ForceInJoint => {
                write!(
                    f,
                    "a joint has equations and no forces\nhelp: write `force name = …;` for what pushes or turns, `joint name = …;` for what holds"
                )
            }
            EquationFact::NotAffine { joint, row, of } => {
                write!(f, "{} of `{joint}` contains products or functions of velocities", equation(*row, *of))?;
                write!(f, "\nhelp: write an equation in which each velocity stands alone, with a factor that contains none")
            }
            EquationFact::RateOfSpeed => {
                write!(f, "the value of this freedom is a velocity already")?;
                write!(f, "\nhelp: write its value at t = 0 after `from`, and nothing after `at`")
            }
            EquationFact::CrossProduct { rows, parallel } => {
                write!(f, "a cross product in space has three rows, and where it vanishes two of them say it all")?;
                match rows {
                    Some(rows) => write!(f, "\nhelp: write `{rows}`, which has two rows")?,
                    None => write!(f, "\nhelp: write `across(axis, v) == 0;` with an axis of a body, or `dot` with two axes across it")?,
                }
                parallel.as_ref().map_or(Ok(()), |parallel| write!(f, ", or `{parallel}`"))
            }
            EquationFact::OnGround { joint, kind } => {
                write!(f, "`{joint}` joins ground to ground, and ground does not move")?;
                write!(f, "\nhelp: give `{kind}` at least one body, or a point or an axis of one")
            }
            EquationFact::ForceOnGround { force, ambient } => {
                let push = if *ambient == Ambient::Space { "(0N, 0N, -5N)" } else { "(0N, -5N)" };
                write!(f, "`{force}` acts on ground alone, and ground does not move")?;
                write!(f, "\nhelp: let it act on a body, such as `at body.P: {push};`")
            }
            EquationFact::EnergyOfNothing { is_of_force } => {
                let so = if *is_of_force { "a force has no such potential" } else { "no force follows from it" };
                write!(f, "this energy does not depend on the position of any body: {so}")?;
                write!(f, "\nhelp: write it with points or angles of bodies, such as `0.5 * k * norm(body.P - ground.Q)^2`")
            }
            EquationFact::NoEquations { name } => write!(f, "`{name}` has no equations\nhelp: write `lhs == rhs;`"),
            EquationFact::NoForces { name, body, ambient } => {
                let (force, torque) = match ambient {
                    Ambient::Plane => ("(0N, -5N)", "2Nm"),
                    Ambient::Space => ("(0N, 0N, -5N)", "(0Nm, 0Nm, 2Nm)"),
                };
                let (point, body) = match body {
                    Some(body) => (format!("{body}.position"), body.as_str()),
                    None => ("P".to_owned(), "body"),
                };
                write!(f, "`{name}` pushes nothing and turns nothing")?;
                write!(f, "\nhelp: write `at {point}: {force};` for a force at a point, `on {body}: {torque};` for a torque")
            }
            EquationFact::EmptyBundle { name } => {
                write!(f, "the bundle `{name}` is empty\nhelp: put `constraint name(…) {{ … }}` or `component Name(…) {{ … }}` into it")
            }
            EquationFact::GroundStart => {
                write!(f, "ground does not move: it has no start values\nhelp: a frame that stands elsewhere is a body with a `weld`")
            }
        }
    }
}
