//! Messages about names.

use super::words::{declared, did_you_mean, first_of, is_acceleration, is_load, is_rate, is_velocity, list, listed, shortened};
use crate::diag::NameFact;
use crate::quantity::{Dim, Role};
use crate::words::{Home, equivalent, foreign, usual_dimension};
use std::fmt::{Display, Formatter, Result};

/// Words for how a body is turned.
const TURNS: [&str; 8] = ["roll", "pitch", "yaw", "rotation", "euler", "rpy", "quaternion", "attitude"];

/// The units that are named where no unit is near.
const USUAL: [&str; 16] = ["m", "mm", "in", "rad", "deg", "s", "kg", "N", "Nm", "rpm", "rad_s", "m_s", "kgm2", "N_m", "W", "Pa"];

impl Display for NameFact {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match self {
            NameFact::UnitAlone { name } if name == "g" => {
                write!(
                    f,
                    "nothing is called `g` here\nhelp: write the acceleration of gravity as `9.81m_s2`, or declare `param g: Acceleration = 9.81m_s2;`"
                )
            }
            NameFact::UnitAlone { name } => {
                write!(
                    f,
                    "nothing is called `{name}` here\nhelp: a unit belongs to a number, as in `1{name}`; that of a rate is one word, as in `1rad_s`"
                )
            }
            NameFact::UnitInParts { written, instead } => {
                write!(f, "a unit is one word, and `{written}` is several\nhelp: write `{instead}`")
            }
            NameFact::PointInBody { name } => {
                write!(f, "`{name}` does not belong to this body, whose items are written in its own coordinates")?;
                write!(f, "\nhelp: name the coordinates with `let c = (…);`, and write `c` for both")
            }
            NameFact::OutputRead { name } => {
                write!(f, "`{name}` is an output: it is read from Rust, not in the declaration")?;
                write!(f, "\nhelp: name its value with `let {name} = …;` and give that out with `output {name} = {name};`")
            }
            NameFact::UnknownName { name, near: None, .. } if ["x", "y", "z"].contains(&name.as_str()) => {
                let along = [("x", "(1, 0)` or in space `(1, 0, 0)"), ("y", "(0, 1)` or in space `(0, 1, 0)"), ("z", "(0, 0, 1)")];
                let along = along.iter().find(|(known, _)| name == known).map_or("", |(_, along)| along);
                write!(f, "nothing is called `{name}` here\nhelp: write `body.{name}` for a coordinate, `{along}` for the direction of {name}")
            }
            NameFact::UnknownName { name, .. } if ["π", "M_PI", "Pi"].contains(&name.as_str()) => {
                write!(f, "nothing is called `{name}` here\nhelp: write `pi`")
            }
            NameFact::UnknownName { name, .. } if ["math", "Math", "np", "numpy", "cmath"].contains(&name.as_str()) => {
                write!(f, "nothing is called `{name}` here\nhelp: functions and `pi` stand by themselves, as in `sin(pi * t / 1s)`")
            }
            NameFact::UnknownName { name, near: None, .. } if ["rev", "revs", "revolution", "turns", "turn"].contains(&name.as_str()) => {
                write!(
                    f,
                    "nothing is called `{name}` here\nhelp: a turn is `1turn`; the lead of a screw is the length of one turn, as in `lead: 5mm`"
                )
            }
            NameFact::UnknownName { name, near: None, .. } if ["teeth", "tooth"].contains(&name.as_str()) => {
                write!(f, "nothing is called `{name}` here\nhelp: numbers of teeth have no unit: write the number alone")
            }
            NameFact::UnknownName { name, near: None, .. } if name == "e" => {
                write!(f, "nothing is called `e` here\nhelp: write `exp(x)` for a power of e")
            }
            NameFact::UnknownName { name, near: None, .. } if ["loads", "energy"].contains(&name.as_str()) => {
                let word = if name == "loads" { "loads" } else { "energies" };
                write!(f, "nothing is called `{name}` here\nnote: {word} are computed for a state, in Rust")?;
                write!(f, "\nhelp: write `mechanism.{name}(&state)` there")
            }
            NameFact::UnknownName { name, near: None, .. } if is_constant(name) && usual_dimension(name).is_none() => {
                write!(
                    f,
                    "nothing is called `{name}` here\nhelp: constants of Rust are not seen: write the value, or set a `param` from Rust"
                )
            }
            NameFact::UnknownName { name, near, is_of_definition } => {
                write!(f, "nothing is called `{name}` here{}", did_you_mean(near))?;
                match usual_dimension(name).filter(|_| near.is_none()) {
                    Some(dimension) => write!(f, "\nhelp: {}", declaration(name, dimension, *is_of_definition)),
                    None => Ok(()),
                }
            }
            NameFact::UnknownField { owner, name, known, .. }
                if (is_rate(name) || ["angular_velocity", "omega"].contains(&name.as_str())) && owner.ends_with(" joint") =>
            {
                write!(f, "{owner} has no `{name}`\nhelp: write ")?;
                let has = |word: &str| known.first.iter().any(|known| known == word);
                let values = if is_rate(name) { ["displacement", "angle"] } else { ["angle", "displacement"] };
                match values.into_iter().find(|word| has(word)) {
                    Some("angle") => write!(f, "`rate(hinge.angle)`"),
                    Some(_) => write!(f, "`rate(slide.displacement)`"),
                    None => write!(f, "`body.angular_velocity`, or `rate(body.position)` of the body that it moves"),
                }
            }
            NameFact::UnknownField { owner, name, near, .. } if is_rate(name) => {
                let rate = near.as_deref().filter(|near| near.starts_with("rate(")).unwrap_or("rate(body.position)");
                write!(f, "{owner} has no `{name}`\nhelp: write `{rate}`: points and numbers have rates")
            }
            NameFact::UnknownField { owner, name, near: None, .. } if is_acceleration(name) => {
                write!(
                    f,
                    "{owner} has no `{name}`\nhelp: an output is given with its rate and its acceleration; equations and forces contain none"
                )
            }
            NameFact::UnknownField { owner, name, near, .. }
                if ["center", "mass", "inertia"].contains(&name.as_str()) && near.as_ref().is_none_or(|near| near == "position") =>
            {
                write!(f, "{owner} has no `{name}` that expressions can read")?;
                match name.as_str() {
                    "center" => write!(f, "\nhelp: declare a point at the centre of mass; weight acts by `gravity = …;`"),
                    _ => write!(f, "\nhelp: name its value with `let`, for the body and for this"),
                }
            }
            NameFact::UnknownField { owner, name, near: None, .. } if is_load(name) => {
                write!(f, "{owner} has no `{name}`\nnote: loads are computed for a state, in Rust")?;
                write!(f, "\nhelp: `mechanism.loads(&state)` has a method for each joint, with `force` and `torque`, ")?;
                write!(f, "and for each drive, with `effort` and `power`")
            }
            NameFact::UnknownField { owner, name, near: None, known }
                if TURNS.contains(&name.as_str()) && known.first.iter().any(|known| known == "angular_velocity") =>
            {
                if known.first.iter().any(|known| known == "angle") {
                    return write!(f, "{owner} has no `{name}`\nhelp: in the plane write `.angle`");
                }
                write!(f, "{owner} has no `{name}`\nhelp: angles are those of joints, such as `hinge.angle`; ")?;
                write!(f, "the orientation of a state is read in Rust, by `state.body().orientation()`")
            }
            NameFact::UnknownField { owner, name, .. } if owner == "a number" && name == "value" => {
                write!(f, "{owner} has no `{name}`\nhelp: write its name alone, without `.{name}`")
            }
            NameFact::UnknownField { owner, name, near: Some(near), .. } if name == "angle" && near.ends_with(".angle") => {
                write!(f, "{owner} has no `angle` in the plane\nhelp: bodies have one: write `{near}`")
            }
            NameFact::UnknownField { owner, name, near: Some(near), .. } if name == "displacement" && near.starts_with("dot(") => {
                write!(f, "{owner} has no `displacement` in the plane\nhelp: bodies have a place: write `{near}`")
            }
            NameFact::UnknownField { owner, name, near, known } => {
                write!(f, "{owner} has no `{name}`{}", did_you_mean(near))?;
                if near.is_none() && known.count > 0 {
                    write!(f, "\nnote: it has {}", first_of(&known.first, known.count))?;
                }
                if near.is_none() && owner == "`ground`" && name.starts_with(char::is_uppercase) {
                    write!(f, "\nhelp: declare it in ground, as in `ground {{ point {name} = (…); }}`")?;
                }
                Ok(())
            }
            NameFact::NoHeight { owner, is_axis } => {
                match is_axis {
                    true => write!(f, "the `z` of {owner} is an axis here, and no place has a `z` in the plane")?,
                    false => write!(f, "{owner} has no `z` in the plane")?,
                }
                write!(f, "\nhelp: write `.x` or `.y`, or for a mechanism in space `mechanism Name in space {{ … }}`")
            }
            NameFact::AngleOfBody { body, joint } => {
                write!(f, "`{body}` has no `angle`: in space a body has an orientation, and a joint has an angle")?;
                match joint {
                    Some(joint) => write!(f, "\nhelp: write `{joint}.angle`"),
                    None => write!(f, "\nhelp: write `joint.angle` with the name of a joint, or `joint_angle(a, b)` of two axes"),
                }
            }
            NameFact::UnknownFunction { name, is_force: Some(false), .. } if name == "distance" => {
                write!(f, "`distance` is a constraint, not a function\nhelp: the distance of two points is `norm(Q - P)`")
            }
            NameFact::UnknownFunction { name, is_force: Some(is_force), .. } => {
                let [kind, item] = declared(*is_force);
                write!(f, "`{name}` is a {kind}, not a function\nhelp: write `{item} name = {name}(…);`")
            }
            NameFact::UnknownFunction { name, near, .. }
                // A product is the line to type, with the arguments as written.
                if near.as_ref().is_none_or(|near| foreign(name).is_some() && !near.contains('*')) =>
            {
                write!(f, "no function is called `{name}`")?;
                match foreign(name) {
                    Some((reason, instead)) => write!(f, "{reason}\nhelp: {instead}"),
                    None => {
                        write!(f, "\nhelp: declare it, such as `function {name}(x: Angle) -> Length = …;`")?;
                        write!(f, "; a function of Rust is declared by its path, `function {name}(Angle) -> Length = crate::{name};`")
                    }
                }
            }
            NameFact::UnknownFunction { name, near, .. } => write!(f, "no function is called `{name}`{}", did_you_mean(near)),
            NameFact::UnknownShape { name, near: Some(near), .. } => write!(f, "no shape is called `{name}`\nhelp: write `{near}`"),
            NameFact::UnknownShape { name, known, .. } => {
                write!(f, "no shape is called `{name}`\nnote: there are {}", listed(known.iter().copied()))?;
                write!(f, "\nhelp: write moments of inertia for a body of another shape")
            }
            NameFact::UnknownConstraint { name, near: Some(near), home: Some(Home::Force(call)), .. }
                if call.starts_with(near.as_str()) =>
            {
                write!(f, "no constraint is called `{name}`\nhelp: write `force name = {call};`")
            }
            NameFact::UnknownConstraint { name, near: Some(near), is_force: true, .. } => {
                write!(f, "no constraint is called `{name}`\nhelp: did you mean the force `{near}`? write `force name = {near}(…);`")
            }
            NameFact::UnknownConstraint { name, near: Some(near), .. }
                if ["drive_angle", "drive_rotation"].contains(&near.as_str())
                    && ["velocity", "speed", "rpm", "omega"].iter().any(|word| name.contains(word)) =>
            {
                write!(f, "no constraint is called `{name}`\nhelp: a speed is driven by its integral: write `{near}(…, 60rpm * t)`")
            }
            NameFact::UnknownConstraint { name, near, home, known, .. } => {
                write!(f, "no constraint is called `{name}`{}", did_you_mean(near))?;
                match home.filter(|_| near.is_none()) {
                    _ if near.is_some() => Ok(()),
                    Some(Home::Joint([only])) => write!(f, "\nhelp: write `{only}`"),
                    Some(Home::Joint(calls)) => write!(f, "\nhelp: write one of {}", listed(calls.iter().copied())),
                    Some(Home::Drive(call)) => write!(f, "\nhelp: write `drive name = {call};`"),
                    Some(Home::Force(call)) => write!(f, "\nhelp: write `force name = {call};`"),
                    Some(Home::Equation) => write!(f, "\nhelp: write its equation, `{{ lhs == rhs; }}`"),
                    Some(Home::Nothing) => write!(
                        f,
                        "\nhelp: take it away: a body that no joint holds moves freely, with `freedom p = body.position; freedom q = body.angle;`, in space `body.angular_velocity`"
                    ),
                    Some(Home::Body) => {
                        write!(f, "\nhelp: declare `body {name} {{ … }}` and join it to others; `distance(P, Q, c)` is a rod without mass")
                    }
                    None => {
                        write!(f, "\nnote: there are {}", first_of(&known.first, known.count))?;
                        write!(f, "\nhelp: bring in your own with `use path::to::{name};`")
                    }
                }
            }
            NameFact::UnknownUnit { name, .. } if name.eq_ignore_ascii_case("Hz") => {
                write!(
                    f,
                    "no unit is called `{name}`\nhelp: a speed of rotation is in `rpm` or `rad_s`, 1 turn a second is `60rpm`; a frequency is a number by a time, `2 / 1s`"
                )
            }
            NameFact::UnknownUnit { number, name, .. } if name == "pi" => {
                write!(f, "no unit is called `pi`\nhelp: write `{number} * pi`")
            }
            NameFact::UnknownUnit { number, name, .. } if name == "t" => {
                write!(f, "no unit is called `t`\nhelp: of the time write `{number} * t`; a tonne is `1000kg`")
            }
            NameFact::UnknownUnit { name, .. } if name == "nm" => {
                write!(f, "no unit is called `nm`\nhelp: a torque is in `Nm`; a nanometre is `0.001um`")
            }
            NameFact::UnknownUnit { number, name, near } => {
                if let Some(equivalent) = equivalent(name) {
                    return write!(f, "no unit is called `{name}`\nhelp: `1{name}` is `{equivalent}`");
                }
                write!(f, "no unit is called `{}`{}", shortened(name), did_you_mean(&near.as_ref().map(|near| format!("{number}{near}"))))?;
                if near.is_none() {
                    let rest = crate::quantity::units().count() - USUAL.len();
                    let usual: String = USUAL.iter().map(|unit| format!("`{unit}`, ")).collect();
                    write!(f, "\nnote: there are {usual}and {rest} more: see \"Units\" on the page of `mechanism!`")?;
                }
                Ok(())
            }
            NameFact::UnknownDimension { name, near } => {
                write!(f, "no dimension is called `{name}`{}", did_you_mean(near))?;
                let product = match name.to_lowercase().as_str() {
                    "volume" => Some("Length^3"),
                    "density" => Some("Mass / Length^3"),
                    "momentum" => Some("Mass * Velocity"),
                    "jerk" => Some("Length / Time^3"),
                    _ => None,
                };
                if let Some(product) = product.filter(|_| near.is_none()) {
                    return write!(f, "\nhelp: write `{product}`");
                }
                if near.is_none() {
                    write!(f, "\nnote: there are {}", listed(Dim::names()))?;
                }
                Ok(())
            }
            NameFact::UnknownStart { name, value, body, in_space, .. } if is_velocity(name) => {
                let owner = if *in_space { "hinge" } else { body };
                let turns = ["rad_s", "deg_s", "rpm"].iter().any(|unit| value.ends_with(unit));
                let speed = if turns { value } else { "5rad_s" };
                write!(f, "a body does not start with `{name}`: a velocity at the start is that of a freedom")?;
                write!(f, "\nhelp: write `freedom name = {owner}.angle from 0deg at {speed};` with the angle at the start")
            }
            NameFact::UnknownStart { name, near, in_space, .. } => {
                let words = if *in_space { "`x`, `y`, `z`, `position` or `orientation`" } else { "`x`, `y`, `position` or `angle`" };
                write!(f, "a body {}does not start with `{name}`{}", if *in_space { "in space " } else { "" }, did_you_mean(near))?;
                write!(f, "\nnote: it starts with {words}")?;
                if *in_space && name == "angle" { write!(f, ", such as `start orientation = turn((0, 0, 1), 30deg);`") } else { Ok(()) }
            }
            NameFact::NotAConstraint { name } => {
                write!(f, "`{name}` is not a constraint\nhelp: `use` brings in what `reuleaux::constraint!` defines")
            }
            NameFact::UnknownKind { name, near } => {
                write!(f, "no parameter can take `{name}`{}", did_you_mean(near))?;
                if near.is_none() {
                    write!(
                        f,
                        "\nnote: it takes a `Point`, `Axis`, `Body`, `Quantity`, `Function(…) -> …`, `Joint(…)`, or a dimension such as `Length`"
                    )?;
                }
                Ok(())
            }
            NameFact::Duplicate { name, .. } if name == "gravity" => write!(f, "there is one gravity only\nhelp: take one of them away"),
            NameFact::Duplicate { name, first } => write!(f, "the name `{name}` is taken: {first} has it\nhelp: choose another name"),
            NameFact::BroughtAlong { name, by } => {
                write!(f, "`{by}` brings a component `{name}` of its own along, and another one has this name here")?;
                write!(f, "\nhelp: give the other one another name, in a `use` item by `use … as …;`")
            }
            NameFact::DuplicateMark { name, body } => write!(f, "`{body}` has another `{name}` already\nhelp: choose another name"),
            NameFact::DuplicateStart { name, body } => {
                let is_start = !["mass", "center", "inertia"].contains(&name.as_str());
                write!(f, "{}`{body}` gives `{name}` twice\nhelp: take one away", if is_start { "the start of " } else { "" })?;
                if !is_start || name == Role::Angle.name() { Ok(()) } else { write!(f, "; `position` is both `x` and `y`") }
            }
            NameFact::DuplicateRange => write!(f, "there is one range of time only\nhelp: take one of them away"),
            NameFact::DuplicateGround => write!(f, "there is one ground only\nhelp: put all its points and axes into one `ground {{ … }}`"),
            NameFact::Reserved { name } if name == "ground" => {
                write!(
                    f,
                    "`ground` is what stands still\nhelp: its points go into `ground {{ … }}`, without `body`; all else has another name"
                )
            }
            NameFact::Reserved { name } => {
                let axes = [("x", "u"), ("y", "v"), ("z", "w")];
                let other = axes.into_iter().find(|(known, _)| name == known).map_or_else(|| format!("{name}_1"), |(_, other)| other.to_owned());
                write!(f, "`{name}` has a meaning of its own in expressions\nhelp: choose another name, such as `{other}`")
            }
            NameFact::Generated { name } => {
                let what = if name.starts_with(char::is_uppercase) { "constant" } else { "function" };
                write!(f, "an output cannot be called `{name}`: a generated {what} has that name")?;
                write!(f, "\nhelp: choose another name, such as `{}_value`", name.trim_start_matches('_').to_lowercase())
            }
            NameFact::Cycle { name, through } if through.is_empty() => write!(f, "`{name}` depends on itself"),
            NameFact::Cycle { name, through } => write!(f, "`{name}` depends on itself, by way of {}", list(through)),
            NameFact::Recursion { name } => {
                write!(f, "the function `{name}` calls itself\nnote: functions are written out where they are called; this would not end")
            }
        }
    }
}

/// How to declare a number of this name.
fn declaration(name: &str, dimension: &str, is_of_definition: bool) -> String {
    if is_of_definition {
        return format!("take it as an argument, `{name}: {dimension}`");
    }
    let input = match dimension {
        "Angle" => format!(", or `input {name}: Angle;` if it is given at each step; the angle of a body is `body.angle`"),
        _ => String::new(),
    };
    format!("declare it, such as `param {name}: {dimension} = …;`{input}")
}

/// True for a name that is written as constants are in Rust.
fn is_constant(name: &str) -> bool {
    name.len() > 2 && name.chars().all(|letter| letter.is_ascii_uppercase() || letter == '_')
}
