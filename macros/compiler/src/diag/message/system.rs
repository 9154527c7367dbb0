//! Messages about the mechanism as a whole: its mobility, and redundant or contradictory joints.

use super::degrees;
use super::words::{are, bodies, counted, drives_there_are, first_of, list, meant, numbers, one_of, plural, rounded};
use crate::diag::{Count, Demand, Forgotten, NoPosition, SystemFact};
use std::fmt::{Display, Formatter, Result};

impl Display for SystemFact {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match self {
            SystemFact::NoBodies { name } => write!(f, "`{name}` has no bodies\nhelp: declare one with `body name {{ … }}`"),
            SystemFact::BodyIsFree { body, example } => {
                write!(f, "nothing holds `{body}`: it is in no equation")?;
                write!(f, "\nhelp: join it to ground or to another body, such as `{example}`, or take it away")
            }
            SystemFact::AngleOfTwoDirections { name, bodies: [one, two], apart } => {
                write!(
                    f,
                    "`{name}` takes the angle of an axis of `{two}` against one of `{one}`, and joints keep them {} apart",
                    degrees(*apart)
                )?;
                write!(f, "\nhelp: take two axes of one direction, such as those of the joint between them")
            }
            SystemFact::Repeats { joint, other } => write!(f, "`{joint}` demands the same as `{other}`\nhelp: take one of them away"),
            SystemFact::PassiveSpin { bodies, joints: [one, two] } => {
                let (it, them) = if bodies.len() == 1 { ("it", "the body") } else { ("them", "the bodies") };
                write!(
                    f,
                    "{} can turn about the line from `{one}` to `{two}`: each holds {it} by one point, and nothing else does",
                    list(bodies)
                )?;
                write!(f, "\nhelp: make one of the joints `universal`, or write `distance(…)` of the two points instead of {them}")?;
                if bodies.len() > 1 { write!(f, ", for a length that is driven `drive_distance(…)`") } else { Ok(()) }
            }
            SystemFact::VelocityDepends { joint, row, of, is_drive, is_redundant } => {
                let which = if *of == 1 { format!("`{joint}`") } else { format!("equation {row} of {of} of `{joint}`") };
                let kind = if *is_drive { "drive" } else { "joint" };
                write!(f, "{which} relates velocities that other joints and drives determine already where the mechanism is assembled")?;
                if *is_redundant {
                    write!(f, "\nnote: an equation between velocities cannot be `redundant`")?;
                }
                if *of == 1 {
                    return write!(f, "\nhelp: take this {kind} away, or another one that determines the same");
                }
                write!(
                    f,
                    "\nhelp: if its other equations are needed, write them alone: `{kind} {joint} = {{ … == 0; }}`; if not, take it away"
                )
            }
            SystemFact::FreedomDepends { freedom, of } => {
                let which =
                    if *of == 1 { format!("`{freedom}` is not free") } else { format!("not all {of} numbers of `{freedom}` are free") };
                write!(f, "{which}: joints, drives and the freedoms before it determine its rate where the mechanism is assembled")?;
                write!(f, "\nhelp: take the freedom away, or the drive that moves the same bodies; declare what can still move")
            }
            SystemFact::FreedomsMissing { name, missing, declared, candidates } => {
                freedoms_missing(f, name, [*missing, *declared], candidates)
            }
            SystemFact::Massless { bodies, has_any, without_inertia, zero } => {
                write!(f, "no mass or inertia resists a motion of {}: its acceleration does not follow from forces", list(bodies))?;
                if !zero.is_empty() {
                    return write!(f, "\nhelp: the mass and the inertia declared for {} are 0: write those that it has", list(zero));
                }
                if !without_inertia.is_empty() {
                    let have = if without_inertia.len() == 1 { "has" } else { "have" };
                    write!(f, "\nhelp: {} {have} a mass only: write `inertia = …;` there", list(without_inertia))?;
                    return write!(f, ", or a `center` away from the axis, or `drive` for `freedom`");
                }
                let place = if *has_any { "in a body that moves with it" } else { "in the bodies" };
                write!(f, "\nhelp: write `mass = …;` and `inertia = …;` {place}, or `drive` for `freedom`")
            }
            SystemFact::SliceWithoutLoads { name } => {
                write!(f, "`{name}` has no load that could be computed alone: no body has a mass, and no force acts")?;
                write!(f, "\nhelp: write `mass = …;` in a body, or take `slice` away")
            }
            SystemFact::ActsOnMassless { joint, without_mass, without_inertia, adds, freedom } => {
                acts_on_massless(f, joint, [without_mass, without_inertia], *adds, freedom)
            }
            SystemFact::NoVelocity { joint } => {
                write!(f, "`#[velocity]` keeps equations of velocities as they are, and `{joint}` has none\nhelp: take it away")
            }
            SystemFact::Nonholonomic { joint, row, of, obstacle } => nonholonomic(f, joint, [*row, *of], *obstacle),
            SystemFact::FollowsFrom { joint, is_drive, rows, of, others, free, moves, kinds } => {
                let place = if *moves { "in every position tried" } else { "where the mechanism stands" };
                let sources = if others.is_empty() { "the rest of it".to_owned() } else { list(others) };
                match (rows == of, of) {
                    (true, 1) => write!(f, "`{joint}` adds nothing: its equation follows from {sources} {place}")?,
                    (true, 2) => write!(f, "`{joint}` adds nothing: both its equations follow from {sources} {place}")?,
                    (true, of) => write!(f, "`{joint}` adds nothing: its {of} equations follow from {sources} {place}")?,
                    (false, of) => {
                        let verb = if *rows == 1 { "adds" } else { "add" };
                        let it = if *rows == 1 { "it follows" } else { "they follow" };
                        write!(f, "{rows} of the {of} equations of `{joint}` {verb} nothing: {it} from {sources} {place}")?;
                    }
                }
                if !free.is_empty() {
                    let (remains, one) = if free.len() == 1 { ("remains", "it") } else { ("remain", "one of them") };
                    return write!(f, "\nnote: {} {remains} free\nhelp: let it hold or drive {one} instead", list(free));
                }
                match (is_drive, rows == of) {
                    _ if others.is_empty() => write!(f, "\nhelp: say it once"),
                    (true, _) => write!(f, "\nhelp: take it away"),
                    (false, true) => write!(f, "\nhelp: take it away, or write `redundant joint` for `joint` to keep it as a check"),
                    (false, false) => {
                        let or = saved_rows(kinds, of - rows).map_or(String::new(), |instead| format!("{instead}; or "));
                        write!(f, "\nhelp: {or}write `redundant joint` for `joint`: what is needed of it is solved, the rest is checked")
                    }
                }
            }
            SystemFact::NotRedundant { joint, free } => {
                write!(f, "`{joint}` is not redundant: none of its equations follows from others")?;
                if !free.is_empty() {
                    let are = if free.len() == 1 { "is" } else { "are" };
                    write!(f, "\nnote: without it {} {are} free", list(free))?;
                }
                write!(f, "\nhelp: write `joint` for `redundant joint`")
            }
            SystemFact::CannotHold { joint, bodies, length, angle, time, is_redundant } => {
                write!(f, "`{joint}` contradicts the other joints: ")?;
                match *time {
                    Some(0.0) => write!(f, "with all of them closed it is {}", off(*length, *angle))?,
                    Some(time) => write!(f, "with all of them closed it is, at t = {} s, {}", rounded(time), off(*length, *angle))?,
                    None => write!(f, "it fits at the start, but not when the drives move on")?,
                }
                if bodies.len() > 1 {
                    write!(f, "\nnote: it joins {}", list(bodies))?;
                }
                let fit = if *is_redundant { "a redundant joint must fit as well" } else { "what is held twice must fit" };
                write!(f, "\nhelp: {fit}: change a measure, or take it away")
            }
            SystemFact::NotOnGround { bodies } => {
                write!(f, "{} are joined to each other but not to ground", list(bodies))?;
                let first = bodies.first().map_or("", String::as_str);
                write!(f, "\nhelp: join one of them to ground, such as `joint name = revolute(ground.position, {first}.position);`")
            }
            SystemFact::FreeCoordinates { body, coordinates, has_place, example, freedom } => {
                let nothing = if coordinates.len() == 1 { "it is in no equation" } else { "they are in no equation" };
                write!(f, "nothing determines {}: {nothing}", list(coordinates))?;
                match has_place {
                    true if example.is_empty() => write!(f, "\nhelp: join `{body}` to another body once more, or drive it"),
                    true => write!(f, "\nhelp: join `{body}` to another body once more, or drive it, such as `{example}`"),
                    false => write!(f, "\nhelp: join `{body}` to ground or to another body, such as `{example}`"),
                }?;
                match freedom {
                    Some(free) => write!(f, "\nhelp: if it follows from forces, write `freedom name = {free};`"),
                    None => Ok(()),
                }
            }
            SystemFact::DrivesMissing { name, count, forgotten, candidates, example, freedom } => {
                let Count { freedoms, in_space, joints, drives, declared, missing } = count.as_ref();
                let Forgotten { loose, line, holds } = forgotten.as_ref();
                write!(f, "`{name}` has mobility {}, but {}", missing + drives, drives_there_are(drives - declared, *declared))?;
                let of_bodies = if *in_space { format!("{freedoms} freedoms of bodies") } else { plural(*freedoms, "coordinate") };
                write!(f, "\nnote: {of_bodies} and {} of joints", plural(*joints, "equation"))?;
                if !loose.is_empty() {
                    let ends = if loose.len() == 1 { "is" } else { "are each" };
                    write!(f, "\nnote: {} {ends} joined to one neighbour only", list(loose))?;
                }
                let (mut or, mut or_joints) = ("", if loose.is_empty() { "" } else { " or joints" });
                if let Some(line) = line {
                    write!(f, "\nhelp: a joint may be missing, such as `{line}`, which holds {}", list(holds))?;
                    (or, or_joints) = ("or ", "");
                }
                match (missing, candidates.len()) {
                    (1, 1) => write!(f, "\nhelp: drive {}", list(candidates))?,
                    (1, _) => write!(f, "\nhelp: add a drive on one of {}", list(candidates))?,
                    _ if candidates.iter().any(|name| name.ends_with(".orientation")) => {
                        write!(f, "\nhelp: {or}add {missing} drives{or_joints}, for {}", list(candidates))?
                    }
                    _ => {
                        write!(f, "\nhelp: {or}add {missing} drives{or_joints}; drives on {} go together", first_of(candidates, *missing))?
                    }
                }
                if !example.is_empty() {
                    write!(f, ", such as `{example}`")?;
                }
                match freedom {
                    Some(freedom) => write!(f, "\nhelp: what follows from forces is a freedom, such as `{freedom}`"),
                    None => Ok(()),
                }
            }
            SystemFact::NothingToDrive { drive, joints, equations: [equations, of], coordinates, free, neglected, held_by } => {
                write!(f, "`{drive}` has nothing to drive: ")?;
                match coordinates.as_slice() {
                    [] => write!(f, "{} {} already what it would move", list(joints), if joints.len() == 1 { "holds" } else { "hold" })?,
                    [only] => write!(f, "{} determines `{only}` already", list(joints))?,
                    many => {
                        write!(f, "{} {} no freedom", list(joints), if joints.len() == 1 { "leaves" } else { "leave" })?;
                        let on = plural(many.len(), "coordinate");
                        match equations == of {
                            true => write!(f, "\nnote: they are {} on {on}: mobility 0", plural(*equations, "equation"))?,
                            false => write!(f, "\nnote: {equations} of their {of} equations are on {on} alone: {}", list(many))?,
                        }
                    }
                }
                if let Some(joint) = held_by {
                    return write!(f, "\nhelp: `{joint}` keeps constant what `{drive}` would move: take `{joint}` away");
                }
                meant(f, neglected)?;
                if free.is_empty() {
                    return write!(f, "\nhelp: take `{drive}` or a joint away");
                }
                write!(f, "\nhelp: {} left free: drive {} instead", are(free), one_of(free))
            }
            SystemFact::DrivesContend { drives, declared_free, freedoms, joints, coordinates, free, .. } if !declared_free.is_empty() => {
                let (few, way) = (counted(*freedoms), if *freedoms == 1 { "way" } else { "ways" });
                write!(f, "{} determine the same: the mechanism can move in {few} {way} there", list(drives))?;
                match coordinates.as_slice() {
                    [only] => write!(f, "\nnote: each determines `{only}`")?,
                    _ if joints.is_empty() => write!(f, "\nnote: they determine {}", list(coordinates))?,
                    _ => {}
                }
                match declared_free.len() == drives.len() {
                    true => write!(f, "\nhelp: take one of them away")?,
                    false => {
                        let laws: Vec<String> = drives.iter().filter(|drive| !declared_free.contains(drive)).cloned().collect();
                        write!(
                            f,
                            "\nhelp: nothing else may determine a freedom: take {} away if a law gives the motion",
                            list(declared_free)
                        )?;
                        write!(f, ", or {} if forces do", list(&laws))?;
                    }
                }
                if free.is_empty() { Ok(()) } else { write!(f, ", or declare {}", list(free)) }
            }
            SystemFact::DrivesContend { drives, numbers, freedoms, joints, coordinates, free, in_space, .. } => {
                let (many, few) = (counted(drives.len()), counted(*freedoms));
                let freedom = if *freedoms == 1 { "freedom" } else { "freedoms" };
                match *numbers > drives.len() {
                    false => write!(f, "{many} drives on {few} {freedom}: {}", list(drives))?,
                    true => {
                        let give = if drives.len() == 1 { "gives" } else { "give" };
                        write!(f, "{} {give} {} numbers for {few} {freedom}", list(drives), counted(*numbers))?;
                    }
                }
                match coordinates.as_slice() {
                    [only] => write!(f, "\nnote: both determine `{only}`")?,
                    _ if joints.is_empty() => write!(f, "\nnote: they determine {}", list(coordinates))?,
                    _ => {
                        write!(f, "\nnote: {} {} {few} {freedom}", list(joints), if joints.len() == 1 { "leaves" } else { "leave" })?;
                        if *in_space { write!(f, " in {}", list(coordinates)) } else { Ok(()) }?;
                    }
                }
                if free.is_empty() && *numbers > drives.len() {
                    return write!(f, "\nhelp: give as many as there are freedoms: of a point one coordinate, such as `.x`");
                }
                if free.is_empty() && drives.len() > freedoms + 1 {
                    return write!(f, "\nhelp: take {} of the drives away", drives.len() - freedoms);
                }
                if free.is_empty() {
                    return write!(f, "\nhelp: take one of the drives away");
                }
                write!(f, "\nhelp: {} left free: drive {} instead", are(free), one_of(free))
            }
            SystemFact::Follows { joint, is_drive, rows, of, others } => {
                let mark = if *is_drive { "" } else { ", or write `redundant joint` for `joint` to keep it as a check" };
                if others.is_empty() {
                    return write!(f, "the equations of `{joint}` follow from each other\nhelp: take those away that say the same");
                }
                let verb = if others.len() == 1 { "says" } else { "say" };
                if rows.len() == *of {
                    return write!(f, "`{joint}` adds nothing: {} {verb} the same\nhelp: take `{joint}` away{mark}", list(others));
                }
                write!(f, "`{joint}` demands in part what {} {verb}: its ", list(others))?;
                match rows.as_slice() {
                    [only] => write!(f, "equation {only} of {of} adds nothing")?,
                    many => write!(f, "equations {} of {of} add nothing", numbers(many))?,
                }
                write!(f, "\nhelp: take one of them away, or demand less with it{mark}")
            }
            SystemFact::Contradicts { joint, others, demand, off } => {
                if others.is_empty() {
                    return write!(f, "the equations of `{joint}` contradict each other: they differ by {off}");
                }
                write!(f, "`{joint}` contradicts {}", list(others))?;
                match demand.as_deref() {
                    Some(Demand { form, wanted, found }) => {
                        write!(f, ": it demands `{form}` = {wanted}, ")?;
                        match others.as_slice() {
                            [only] => write!(f, "`{only}` demands {found}"),
                            _ => write!(f, "they make it {found}"),
                        }
                    }
                    None => write!(f, ": where {} {}, it is off by {off}", list(others), if others.len() == 1 { "holds" } else { "hold" }),
                }?;
                write!(f, "\nhelp: take one of them away")
            }
            SystemFact::AxesContradict { joint, other, bodies: [one, two], angles } => {
                let [on_one, on_two] = angles.map(|angle| rounded(angle.to_degrees()));
                write!(f, "`{joint}` contradicts `{other}`: their axes are {on_one}° apart on `{one}` and {on_two}° on `{two}`")?;
                write!(f, "\nhelp: give both joints the same axes, or take one of them away")
            }
            SystemFact::Askew { joints, bodies, angle, others } => {
                let angle = rounded(angle.to_degrees());
                match joints.as_slice() {
                    [joint] => write!(f, "the axis of `{joint}` is {angle}° askew on {}", list(bodies))?,
                    both => write!(f, "the axes of {} are {angle}° apart on {}", list(both), list(bodies))?,
                }
                let (those, need) = if others.len() == 1 { ("that", "is") } else { ("those", "are") };
                write!(f, ", {those} of {} {need} parallel: such a loop of hinges locks", list(others))?;
                write!(f, "\nhelp: parallel axes were probably meant: give {} parallel axes for {}", list(bodies), list(joints))
            }
            SystemFact::TwoAxes { joint, other, bodies: [one, two], angle } => {
                write!(
                    f,
                    "`{other}` and `{joint}` hold `{one}` and `{two}` together: nothing turns about two axes {}° apart",
                    rounded(angle.to_degrees())
                )?;
                write!(f, "\nhelp: take one of them away, or write `weld` for both")
            }
            SystemFact::Collides { joint, others, off } => {
                write!(
                    f,
                    "`{joint}` demands again what {} demand, with other numbers: both hold only where `{off}` is zero",
                    list(others)
                )?;
                write!(f, "\nhelp: take one of them away")
            }
            SystemFact::TooManyEquations { joint, others, equations, coordinates, free, for_free } => {
                let surplus = equations - coordinates.len();
                let many = if surplus == 1 { "one equation".to_owned() } else { plural(surplus, "equation") };
                write!(f, "`{joint}` is {many} too many")?;
                match others.is_empty() {
                    true => write!(f, ": it has {}", plural(*equations, "equation"))?,
                    false => write!(f, " with {}: together they are {}", list(others), plural(*equations, "equation"))?,
                }
                match coordinates.as_slice() {
                    few @ ([_] | [_, _] | [_, _, _]) => write!(f, " on {}, {}", plural(few.len(), "coordinate"), list(few))?,
                    many => write!(f, " on {} of {}", plural(many.len(), "coordinate"), list(&bodies(many)))?,
                }
                if !free.is_empty() {
                    let have = if free.len() == 1 { "has" } else { "have" };
                    let equations =
                        if *for_free == 0 { "no equation".to_owned() } else { format!("only {}", plural(*for_free, "equation")) };
                    return write!(f, "\nnote: {} {have} {equations}", list(free));
                }
                write!(f, "\nnote: that is a mobility of -{surplus}\nhelp: take one of these joints away")
            }
        }
    }
}

/// For joints in a loop in space, the refused one last: what demands less in place of one. `needed`: equations of it that are needed.
fn saved_rows(kinds: &[String], needed: usize) -> Option<&'static str> {
    let count = |kind: &str| kinds.iter().filter(|known| *known == kind).count();
    match (count("screw"), count("universal"), count("revolute"), count("cylindrical")) {
        (1.., ..) => {
            Some("where other joints hold its bodies in line, the one equation of a screw is `rack_pinion(angle, P, a, Q, radius)`")
        }
        (_, 1.., ..) | (_, _, 0 | 1, 1..) if needed == 4 => Some("a cylindrical joint in its place demands no more than is needed"),
        (_, 1.., ..) | (_, _, 0 | 1, 1..) => {
            Some("where other joints hold the place of a bearing, `parallel_axes(a, b)` holds its direction alone")
        }
        (_, _, 2.., _) => Some("in a loop a spherical and a cylindrical joint in place of two revolutes demand no more than is needed"),
        _ => None,
    }
}

/// `3 mm and 2° off`
fn off(length: Option<f64>, angle: Option<f64>) -> String {
    match (length, angle) {
        (Some(length), Some(angle)) => format!("{} mm and {}° off", rounded(length * 1e3), rounded(angle.to_degrees())),
        (Some(length), None) => format!("{} mm off", rounded(length * 1e3)),
        (None, Some(angle)) => format!("{}° off", rounded(angle.to_degrees())),
        (None, None) => "off".to_owned(),
    }
}

/// A joint whose equations relate velocities of bodies, of which the first lack a mass and the second an inertia.
fn acts_on_massless(f: &mut Formatter, joint: &str, lists: [&[String]; 2], adds: bool, freedom: &str) -> Result {
    write!(f, "`{joint}` relates velocities of ")?;
    let [without_mass, without_inertia] = lists;
    match lists {
        [one, []] => write!(f, "{}, whose translation no mass resists", list(one))?,
        [[], two] => write!(f, "{}, whose rotation no inertia resists", list(two))?,
        [one, two] if one == two => write!(f, "{}, whose translation no mass and whose rotation no inertia resists", list(one))?,
        [one, two] => {
            write!(f, "{}, whose translation no mass resists, and of {}, whose rotation no inertia resists", list(one), list(two))?;
        }
    }
    write!(f, "\nnote: the motion follows from forces, since `{freedom}` is a freedom, and forces move only what has a mass")?;
    for (what, bodies) in [("mass", without_mass), ("inertia", without_inertia)] {
        if bodies.is_empty() {
            continue;
        }
        write!(f, "\nhelp: write `{what} = …;` in {}", list(bodies))?;
        if adds {
            write!(f, ", or `{what}: …` in `{joint}`, which adds it to each of its bodies")?;
        }
    }
    write!(f, "\nhelp: or relate positions or angles: these may hold what has no mass")
}

fn freedoms_missing(f: &mut Formatter, name: &str, [missing, declared]: [usize; 2], candidates: &[String]) -> Result {
    let example = candidates.first().map_or("", String::as_str);
    if declared == 0 {
        let (ways, it) = if missing == 1 { ("one way".to_owned(), "it") } else { (format!("{missing} independent ways"), "them") };
        write!(f, "`{name}` can move in {ways} that no drive determines")?;
        write!(f, "\nhelp: drive {it}, or declare {it} as a freedom if it follows from forces, such as `freedom name = {example};`")?;
    } else {
        let found = if declared == 1 { "1 freedom is".to_owned() } else { format!("{} are", plural(declared, "freedom")) };
        write!(f, "`{name}` can move in {} independent ways, but {found} declared", missing + declared)?;
        write!(f, "\nhelp: declare what else can move, such as `freedom name = {example};`")?;
    }
    if candidates.len() > 1 { write!(f, "; {} are free", list(candidates)) } else { Ok(()) }
}

/// An equation of velocities from which no position follows, where positions are solved for.
fn nonholonomic(f: &mut Formatter, joint: &str, [row, of]: [usize; 2], obstacle: NoPosition) -> Result {
    let which = if of == 1 { "the equation".to_owned() } else { format!("equation {row} of {of}") };
    match obstacle {
        NoPosition::Factors => write!(
            f,
            "{which} of `{joint}` relates velocities by factors that change, and the compiler finds no equation between positions with this rate"
        )?,
        NoPosition::Side => write!(f, "{which} of `{joint}` sets velocities to a value that changes, and no position follows from it")?,
        NoPosition::Kept => write!(f, "`#[velocity]` keeps {which} of `{joint}` as it is, and no position follows from it")?,
    }
    write!(f, "\nhelp: where drives determine the motion, write `#[integrated]` before `mechanism`")?;
    write!(f, "\nhelp: where forces do, declare a freedom, such as `freedom spin = body.angular_velocity;`")?;
    let otherwise = if obstacle == NoPosition::Kept { "take `#[velocity]` away" } else { "relate positions or angles instead" };
    write!(f, "\nhelp: or {otherwise}, or write `#[equations_only]` to have its rows alone")
}
