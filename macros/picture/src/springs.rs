//! Symbols of springs and dampers between two points, in the plane and in space.

/// Kinds of forces with a symbol.
pub(crate) const KINDS: [&str; 7] = ["spring", "damper", "spring_damper", "constant_force", "gas_spring", "nonlinear_spring", STOP];

/// The kind that gives way to the others.
const STOP: &str = "stop";

/// Distance from the line between the points to each of a spring and a damper side by side.
const BESIDE: f64 = 9.5;

/// The symbol of joint `own`, if that is a force. A spring and a damper between the same ends are drawn side by side, by the first of them; a stop
/// is drawn where it is alone.
///
/// * `joints`: the kind of each joint, and the ends of each that has two points.
pub(crate) fn drawn<'a, E: Copy>(own: usize, joints: &[(&'a str, Option<[E; 2]>)], are_same: impl Fn(E, E) -> bool) -> Option<&'a str> {
    let (kind, [p, q]) = (joints.get(own)?.0, joints.get(own)?.1?);
    let is_here = |[one, two]: [E; 2]| are_same(p, one) && are_same(q, two) || are_same(p, two) && are_same(q, one);
    let is_force = |(kind, ends): &(&str, Option<[E; 2]>)| KINDS.contains(kind) && ends.is_some_and(is_here);
    let here: Vec<usize> = (0..joints.len()).filter(|number| is_force(&joints[*number])).collect();
    let is_alone = here.iter().all(|number| joints[*number].0 == STOP);
    let here: Vec<usize> = here.into_iter().filter(|number| is_alone || joints[*number].0 != STOP).collect();
    if !here.contains(&own) {
        return None;
    }
    if here.iter().all(|number| look(joints[*number].0) == look(kind)) {
        return Some(look(kind));
    }
    (here.first() == Some(&own)).then_some(KINDS[2])
}

/// The kind whose symbol a kind has: a gas spring is a cylinder with a piston.
fn look(kind: &str) -> &str {
    match kind {
        "constant_force" | "nonlinear_spring" => "spring",
        "gas_spring" => "damper",
        kind => kind,
    }
}

/// The lines of a symbol. `at(part, beside)` is the place after a part of the way between the points, and `beside` units of the picture beside it.
pub(crate) fn symbol<P>(kind: &str, at: impl Fn(f64, f64) -> P) -> Vec<Vec<P>> {
    match kind {
        "spring" => vec![coil(&at, [0.0, 1.0], 0.0)],
        "damper" => pot(&at, [0.0, 1.0], 0.0),
        STOP => buffer(&at),
        _ => {
            let ends = [0.1, 0.9];
            let mut lines = vec![vec![at(0.0, 0.0), at(ends[0], 0.0)], vec![at(ends[1], 0.0), at(1.0, 0.0)]];
            lines.extend(ends.map(|end| vec![at(end, BESIDE), at(end, -BESIDE)]));
            lines.push(coil(&at, ends, BESIDE));
            lines.extend(pot(&at, ends, -BESIDE));
            lines
        }
    }
}

/// A coil of straight turns, with the same number of turns at any length.
fn coil<P>(at: &impl Fn(f64, f64) -> P, [from, to]: [f64; 2], beside: f64) -> Vec<P> {
    let turn = |step: i32| at(0.15 + 0.7 * (f64::from(step) + 0.5) / 12.0, beside + if step % 2 == 0 { 7.0 } else { -7.0 });
    let (first, last) = ([from, 0.15].map(|part| at(part, beside)), [0.85, to].map(|part| at(part, beside)));
    first.into_iter().chain((0..12).map(turn)).chain(last).collect()
}

/// A pot, and a piston on a rod.
fn pot<P>(at: &impl Fn(f64, f64) -> P, [from, to]: [f64; 2], beside: f64) -> Vec<Vec<P>> {
    let wall = [(0.6, 8.0), (0.3, 8.0), (0.3, -8.0), (0.6, -8.0)].map(|(part, across)| at(part, beside + across));
    vec![
        vec![at(from, beside), at(0.3, beside)],
        wall.into(),
        vec![at(0.5, beside + 6.0), at(0.5, beside - 6.0)],
        vec![at(0.5, beside), at(to, beside)],
    ]
}

/// A block, and a plate on a rod before it.
fn buffer<P>(at: &impl Fn(f64, f64) -> P) -> Vec<Vec<P>> {
    let block = [(0.3, 7.0), (0.45, 7.0), (0.45, -7.0), (0.3, -7.0), (0.3, 7.0)].map(|(part, across)| at(part, across));
    vec![vec![at(0.0, 0.0), at(0.3, 0.0)], block.into(), vec![at(0.55, 7.0), at(0.55, -7.0)], vec![at(0.55, 0.0), at(1.0, 0.0)]]
}
