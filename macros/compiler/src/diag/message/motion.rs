//! Messages about forces, drives and freedoms.

use super::words::{are, did_you_mean, list, listed};
use crate::diag::Kind;
use crate::diag::fact::{JerkObstacle, JointValue, MotionFact, Word};
use crate::quantity::Ambient;
use std::fmt::{Display, Formatter, Result};

impl Display for Word {
    fn fmt(&self, f: &mut Formatter) -> Result {
        f.write_str(match self {
            Word::Joint => "joint",
            Word::Drive => "drive",
            Word::Force => "force",
        })
    }
}

/// Words for a force that is given from outside.
const APPLIED: [&str; 10] =
    ["force", "load", "payload", "external_force", "applied_force", "point_force", "body_force", "point_load", "tip_force", "disturbance"];

/// Names that other programs give to the force of gravity.
const GRAVITY: [&str; 5] = ["gravity", "weight", "self_weight", "gravitational_field", "gravitation"];

impl Display for MotionFact {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match self {
            MotionFact::PlaceWithoutAt { place } => {
                write!(f, "a force comes after `at` and its point, a torque behind `on` and its body\nhelp: write `at {place}: …;`")
            }
            MotionFact::StartWithEquals { value, start } => {
                write!(f, "a freedom has its value at t = 0 behind `from`\nhelp: write `{value} from {start}`")
            }
            MotionFact::FreedomWithoutName { value } => {
                write!(f, "a freedom has a name of its own\nhelp: write `freedom name = {value};`")
            }
            MotionFact::DriveWithoutName { value } => {
                write!(f, "a drive has a name of its own\nhelp: write `drive name = {{ {value} == …; }}`")
            }
            MotionFact::GravityWithoutDirection { value, ambient } => {
                let value = value.trim_start_matches('-');
                write!(f, "gravity is a vector, the acceleration of free fall, found a number\nhelp: write ")?;
                match ambient {
                    Ambient::Plane => write!(f, "`gravity = (0, -{value});`"),
                    Ambient::Space => write!(f, "`gravity = (0, 0, -{value});`"),
                }
            }
            MotionFact::InertiaOfNumbers { found, first } => {
                write!(f, "the inertia of a body in space is three numbers or six, found {found}")?;
                if first.starts_with('[') {
                    write!(f, "\nhelp: write `(I_xx, I_yy, I_zz)`, or with products of inertia `(I_xx, I_yy, I_zz, I_xy, I_xz, I_yz)`")?;
                    return write!(f, ", each such as `0.1kgm2`");
                }
                write!(f, "\nhelp: write `({first}, {first}, {first})` for I_xx, I_yy, I_zz, or a shape such as `ball(30mm)`")
            }
            MotionFact::InertiaAlongInPlane { inertia } => {
                write!(f, "in the plane an inertia is one number, however the body is turned\nhelp: write `inertia = {inertia};`")
            }
            MotionFact::InertiaOfVector { inertia } => {
                write!(f, "in the plane an inertia is one number, about the axis out of the plane")?;
                match inertia {
                    Some(inertia) => write!(f, "\nhelp: write `inertia = {inertia};`"),
                    None => write!(f, "\nhelp: write `inertia = 0.1kgm2;`, or a shape such as `disk(30mm)`"),
                }
            }
            MotionFact::TorqueWithoutAxis { torque, axis } => {
                write!(f, "a torque in space is a vector along its axis, found a number")?;
                match axis {
                    Some(axis) => write!(f, "\nhelp: write `{torque} * unit({axis})`, or its components in ground, `(0Nm, 0Nm, 5Nm)`"),
                    None => write!(f, "\nhelp: write its components in ground, such as `(0Nm, 0Nm, {torque})`"),
                }
            }
            MotionFact::TorqueWithAxis { body, torque } => {
                write!(f, "a torque in the plane is a number, positive to the left, found a vector")?;
                let torque = torque.as_deref().unwrap_or("5Nm");
                write!(f, "\nhelp: write `on {body}: {torque};`, or `at {body}.position: (5N, 0N);` for a force")
            }
            MotionFact::ForceWithoutDirection { force, ambient, on } => {
                write!(f, "a force is a vector in ground, found a number\nhelp: write ")?;
                match (on, ambient) {
                    (Some(body), Ambient::Plane) => write!(f, "`on {body}: {force};` for a torque"),
                    (Some(body), Ambient::Space) => write!(f, "`on {body}: {force} * unit(v);` for a torque about a vector `v`"),
                    (None, Ambient::Plane) => {
                        write!(f, "`({force}, 0N)` for a force along x, `{force} * unit(v)` for one along a vector `v`")
                    }
                    (None, Ambient::Space) => {
                        write!(f, "`({force}, 0N, 0N)` for a force along x, `{force} * unit(v)` for one along a vector `v`")
                    }
                }
            }
            MotionFact::ForceAtNoPoint { found, instead } => {
                write!(f, "a force acts at a point, found {found}")?;
                match instead {
                    Some(instead) => write!(f, "\nhelp: write `at {instead}: …;`"),
                    None if *found == Kind::Vector => write!(f, "\nhelp: declare `point P = …;` in the body on which it acts"),
                    None => Ok(()),
                }
            }
            MotionFact::TorqueOnNoBody { found, instead } => {
                write!(f, "a torque acts on a body, found {found}")?;
                instead.as_ref().map_or(Ok(()), |instead| write!(f, "\nhelp: write `on {instead}: …;`, or `at` for a force at a point"))
            }
            MotionFact::EquationWithoutBraces { word, name, equation } => {
                write!(f, "equations stand in braces\nhelp: write `{word} {name} = {{ {equation}; }}`")
            }
            MotionFact::ValueForForce { value, instead, laws } => {
                write!(f, "`{value}` is a value, and a force says where it acts\nhelp: write `{instead}`")?;
                write!(
                    f,
                    "\nhelp: or call a law, such as `spring(P, Q, stiffness: 500N_m)`: there are {}",
                    listed(laws.iter().map(String::as_str))
                )
            }
            MotionFact::ValueForConstraint { word: Word::Drive, value, instead } => {
                write!(f, "`{value}` is a value, and a drive says what it moves\nhelp: write `{instead}`")
            }
            MotionFact::ValueForConstraint { value, instead, .. } => {
                write!(f, "`{value}` is a value, and a joint relates bodies\nhelp: write `{instead}`, or an equation, `{{ lhs == rhs; }}`")
            }
            MotionFact::UnknownForce { name, ambient, .. } if GRAVITY.contains(&name.to_lowercase().as_str()) => {
                let instead = if *ambient == Ambient::Plane { "(0, -9.81m_s2)" } else { "(0, 0, -9.81m_s2)" };
                write!(f, "no force is called `{name}`: gravity acts on every mass\nhelp: write `gravity = {instead};` in its place")
            }
            MotionFact::UnknownForce { name, ambient, .. } if APPLIED.contains(&name.to_lowercase().as_str()) => {
                let [force, torque] = match ambient {
                    Ambient::Plane => ["(0N, -5N)", "5Nm"],
                    Ambient::Space => ["(0N, 0N, -5N)", "(0Nm, 0Nm, 5Nm)"],
                };
                write!(f, "no force is called `{name}`\nhelp: write where it acts, ")?;
                write!(f, "`{{ at P: {force}; }}` for a force at a point, `{{ on b: {torque}; }}` for a torque on a body")
            }
            MotionFact::UnknownForce { name, near, laws, ambient } => {
                write!(f, "no force is called `{name}`{}", did_you_mean(near))?;
                write!(f, "\nnote: there are {}", listed(laws.iter().map(String::as_str)))?;
                if near.is_some() {
                    return Ok(());
                }
                let [one, two] = match ambient {
                    Ambient::Plane => ["(0N, -5N)", "(0N, 5N)"],
                    Ambient::Space => ["(0N, 0N, -5N)", "(0N, 0N, 5N)"],
                };
                write!(f, "\nhelp: write out another one, such as `{{ at P: {one}; at Q: {two}; }}`")
            }
            MotionFact::ForceForConstraint { force, word, name, instead } => {
                write!(f, "`{force}` is a force, and a {word} ")?;
                write!(f, "{}", if *word == Word::Drive { "prescribes a motion" } else { "holds bodies together" })?;
                write!(f, "\nhelp: write `force {name} = {force}(…);`")?;
                instead.as_ref().map_or(Ok(()), |instead| write!(f, ", or `drive {name} = {instead};` for a given motion"))
            }
            MotionFact::ConstraintForForce { constraint, is_drive, name } => {
                let word = if *is_drive { Word::Drive } else { Word::Joint };
                write!(f, "`{constraint}` is a {word}, not a force\nhelp: write `{word} {name} = {constraint}(…);`")?;
                write!(f, ", or say where a force acts, such as `{{ at P: (0N, -5N); }}`")
            }
            MotionFact::JointForDrive { constraint, name } => {
                write!(
                    f,
                    "`{constraint}` is a joint, and no argument of it can follow a law\nhelp: write `joint {name} = {constraint}(…);`"
                )
            }
            MotionFact::RateForStart { rate } => {
                write!(f, "`{rate}` is a rate, and `from` gives the value at t = 0\nhelp: write `at {rate}`")
            }
            MotionFact::StartForRate { start } => {
                write!(f, "`{start}` is a value, and `at` gives its rate at t = 0\nhelp: write `from {start}`")
            }
            MotionFact::RateBeforeStart { value, from, at } => {
                write!(f, "the value at t = 0 stands before the rate\nhelp: write `{value} from {from} at {at}`")
            }
            MotionFact::JointWithoutValue { definition, wanted: JointValue::Angle, kind, .. } if kind == "universal" => {
                write!(
                    f,
                    "`{definition}` takes one angle, and a `universal` joint has two\nhelp: write `angle_a` or `angle_b` after its name"
                )
            }
            MotionFact::JointWithoutValue { definition, wanted, kind, instead } => {
                let (noun, kinds) = match wanted {
                    JointValue::Angle => ("an angle", "`revolute`, `cylindrical` or `screw`"),
                    JointValue::Displacement => ("a displacement", "`translational`, `cylindrical` or `screw`"),
                };
                write!(f, "`{definition}` takes {noun}, and a `{kind}` joint has none")?;
                match (instead, wanted) {
                    (Some(instead), _) => write!(f, "\nhelp: write `{instead}`, or take a {kinds} joint"),
                    (None, JointValue::Angle) => {
                        write!(f, "\nhelp: take a {kinds} joint, or `joint_angle(a, b)` of two axes for the joint")
                    }
                    (None, JointValue::Displacement) => write!(f, "\nhelp: take a {kinds} joint, or `along(a, Q - P)` for the joint"),
                }
            }
            MotionFact::FreedomOfNothing { name, value, coordinate } => {
                write!(f, "a freedom names a coordinate or a velocity, and `{value}` is a value")?;
                write!(f, "\nhelp: write `freedom {name} = {coordinate} from {value};` with the name of the coordinate")
            }
            MotionFact::FreedomOfOrientation { name, body } => {
                write!(f, "a freedom is a number or a vector, found an orientation")?;
                write!(f, "\nhelp: three turns are free: write `freedom {name} = {body}.angular_velocity;`")
            }
            MotionFact::FreedomOfJoint { name, joint, offers, start } => {
                write!(f, "a freedom is a number or a vector, and `{joint}` is a joint")?;
                let lines: Vec<String> = offers.iter().map(|offer| format!("freedom {name} = {offer}{start};")).collect();
                match lines.as_slice() {
                    [] => Ok(()),
                    [only] => write!(f, "\nhelp: write `{only}`"),
                    [one, two, ..] => write!(f, "\nhelp: write `{one}` or `{two}`"),
                }
            }
            MotionFact::FreedomIsHeld { freedom, of, by, free } => {
                if *of == 1 {
                    write!(f, "`{freedom}` is not free: {} {} it", list(by), if by.len() == 1 { "holds" } else { "hold" })?;
                } else {
                    write!(
                        f,
                        "not all {of} numbers of `{freedom}` are free: {} {} some",
                        list(by),
                        if by.len() == 1 { "holds" } else { "hold" }
                    )?;
                }
                if free.is_empty() {
                    return write!(f, "\nhelp: take it away: nothing can move there");
                }
                write!(f, "\nhelp: declare what can still move, such as `freedom {freedom} = {};`", free[0])?;
                if free.len() > 1 { write!(f, "; {} free", are(free)) } else { Ok(()) }
            }
            MotionFact::SliceBesideFreedom { output, freedom } => {
                write!(f, "`{output}` cannot be solved for alone: {}, and all bodies with it", integrated(freedom))?;
                write!(f, "\nhelp: write `output` for `slice output`")
            }
            MotionFact::InputBesideFreedom { drive, input, freedom } => {
                write!(f, "`{drive}` is driven by the input `{input}`, and {}", integrated(freedom))?;
                write!(f, "\nnote: between two steps of a controller the input is not known, and integration needs it there")?;
                write!(f, "\nhelp: drive by a law of `t`, or by a `param` that is changed between two calls; or let the input be a force")
            }
            MotionFact::SliceBesideInput { output, input } => {
                write!(f, "`{output}` cannot be solved for alone: what the input `{input}` was is kept in whole states")?;
                write!(f, "\nhelp: write `output` for `slice output`")
            }
            MotionFact::NoJerk { output, obstacle } => no_jerk(f, output, obstacle),
            MotionFact::RangeBesideFreedom { freedom } => {
                write!(f, "a range says how long drives are followed, and {}", integrated(freedom))?;
                write!(f, "\nhelp: take the range away; `advance` integrates to any time")
            }
        }
    }
}

/// A freedom, or the whole mechanism.
fn integrated(freedom: &Option<String>) -> String {
    freedom
        .as_ref()
        .map_or_else(|| "the mechanism is `#[integrated]`".to_owned(), |freedom| format!("the freedom `{freedom}` is integrated"))
}

/// An output without a third derivative.
fn no_jerk(f: &mut Formatter, output: &str, obstacle: &JerkObstacle) -> Result {
    match obstacle {
        JerkObstacle::Body => {
            write!(f, "numbers, vectors and points have a jerk, and `{output}` is a body")?;
            write!(f, "\nhelp: write outputs of its points and of its angle with jerk")
        }
        JerkObstacle::Velocity => {
            write!(f, "`{output}` contains velocities, and its first derivative is the last that is given")?;
            write!(f, "\nhelp: take `with jerk` away; the position itself can be given with jerk")
        }
        JerkObstacle::Integrated { freedom } => {
            write!(f, "`{output}` has no jerk: {}, and forces and velocities are not differentiated", integrated(freedom))?;
            write!(f, "\nhelp: take `with jerk` away")
        }
        JerkObstacle::EquationsOnly => {
            write!(f, "`{output}` has no jerk: the mechanism is `#[equations_only]`, and nothing is solved")?;
            write!(f, "\nhelp: take `with jerk` away")
        }
        JerkObstacle::TwoDerivatives { joint } => {
            let place = joint.as_ref().map_or_else(|| "it contains".to_owned(), |joint| format!("it depends on `{joint}`, which contains"));
            write!(f, "`{output}` has no jerk: {place} an input, a table or a Rust function, and these have two derivatives")?;
            write!(f, "\nhelp: write the law as an expression or by `segments`, or take `with jerk` away")
        }
    }
}
