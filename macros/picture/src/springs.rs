//! Symbols of springs and dampers between two points, in the plane and in space.

/// Kinds of forces with a symbol.
pub(crate) const KINDS: [&str; 3] = ["spring", "damper", "spring_damper"];

/// Distance from the line between the points to each of a spring and a damper side by side.
const BESIDE: f64 = 9.5;

/// The symbol of force `own` among all `between` the same points, each with its number and its kind: a spring and a damper are drawn side by side,
/// by the first of them.
pub(crate) fn shared<'a>(own: usize, between: &[(usize, &'a str)]) -> Option<&'a str> {
    let kind = between.iter().find(|(number, _)| *number == own)?.1;
    let is_first = between.first().is_some_and(|(number, _)| *number == own);
    match between.iter().any(|(_, other)| *other != kind) {
        true => is_first.then_some(KINDS[2]),
        false => Some(kind),
    }
}

/// The lines of a symbol. `at` is the place at a part of the way between the points, and so many units of the picture beside it.
pub(crate) fn symbol<P>(kind: &str, at: impl Fn(f64, f64) -> P) -> Vec<Vec<P>> {
    match kind {
        "spring" => vec![coil(&at, [0.0, 1.0], 0.0)],
        "damper" => pot(&at, [0.0, 1.0], 0.0),
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
