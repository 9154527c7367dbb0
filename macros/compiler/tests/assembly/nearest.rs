//! The nearest of all assemblies is taken: random linkages with one, two and three declared angles, compared with all their assemblies from
//! a scan by plane geometry.
//!
//! `REULEAUX_NEAREST=1000 cargo test -p reuleaux-compiler --test assembly nearest` tests 1000 linkages of each kind.

use crate::{Random, samples, start};
use core::f64::consts::{PI, TAU};

pub(crate) type Point = [f64; 2];

/// Angles of two bars, and a point on them.
pub(crate) type Dyad = (f64, f64, Point);

/// A linkage: its declaration without starts, the bodies whose angles distinguish assemblies, and these angles in each assembly.
pub(crate) struct Linkage {
    pub(crate) declaration: String,
    pub(crate) bodies: Vec<&'static str>,
    pub(crate) assemblies: Vec<Vec<f64>>,
}

/// Angles closer than this, in rad, do not decide; nor do squared distances with a smaller relative difference.
const CLOSE: f64 = 1e-4;

pub(crate) fn minus(one: Point, other: Point) -> Point {
    [one[0] - other[0], one[1] - other[1]]
}

pub(crate) fn length(way: Point) -> f64 {
    way[0].hypot(way[1])
}

pub(crate) fn angle(way: Point) -> f64 {
    way[1].atan2(way[0])
}

/// The point at a rotated offset from a point.
pub(crate) fn from(place: Point, way: Point, angle: f64) -> Point {
    let (sine, cosine) = angle.sin_cos();
    [place[0] + cosine * way[0] - sine * way[1], place[1] + sine * way[0] + cosine * way[1]]
}

/// Half the common chord, squared, of two circles with these centres and radii; their intersections unless it is negative.
fn circles(one: Point, r: f64, other: Point, s: f64) -> (f64, Option<[Point; 2]>) {
    let way = minus(other, one);
    let d = length(way);
    let along = (d * d + r * r - s * s) / (2.0 * d);
    let square = r * r - along * along;
    let points = (square >= 0.0).then(|| {
        let (u, h) = ([way[0] / d, way[1] / d], square.sqrt());
        [1.0, -1.0].map(|side| [one[0] + along * u[0] - side * h * u[1], one[1] + along * u[1] + side * h * u[0]])
    });
    (square, points)
}

/// Three decimals, so that the declared number is exact.
pub(crate) fn rounded(value: f64) -> f64 {
    (value * 1e3).round() / 1e3
}

pub(crate) fn place(random: &mut Random, size: f64) -> Point {
    [random.between(-size, size), random.between(-size, size)]
}

/// A binary link.
pub(crate) fn link(name: &str, length: f64) -> String {
    format!("body {name} {{ point B = ({length}mm, 0mm); /*{name}*/ }} ")
}

/// A crank from (0, 0) to A, a coupler from A to B with a point P on it, a rocker from C to B; all in mm.
pub(crate) struct FourBar {
    pub(crate) crank: f64,
    pub(crate) at: f64,
    pub(crate) coupler: f64,
    pub(crate) rocker: f64,
    pub(crate) c: Point,
    pub(crate) p: Point,
}

impl FourBar {
    fn random(random: &mut Random) -> FourBar {
        let (a, b, c) = (place(random, 200.0), place(random, 400.0), place(random, 400.0));
        let at = rounded(angle(a).to_degrees());
        FourBar {
            crank: rounded(length(a)),
            at,
            coupler: rounded(length(minus(b, a))),
            rocker: rounded(length(minus(b, c))),
            c,
            p: place(random, 300.0),
        }
    }

    fn declaration(&self) -> String {
        let ([cx, cy], [px, py]) = (self.c, self.p);
        format!(
            "ground {{ point C = ({cx}mm, {cy}mm); }} {}{} body coupler {{ point B = ({}mm, 0mm); point P = ({px}mm, {py}mm); /*coupler*/ }}
            joint o = revolute(ground.position, crank.position); joint a = revolute(crank.B, coupler.position);
            joint b = revolute(coupler.B, rocker.B); joint c = revolute(rocker.position, ground.C); ",
            link("crank", self.crank),
            link("rocker", self.rocker),
            self.coupler
        )
    }

    /// A crank angle between each pair of angles at which coupler and rocker are in line: every range in which the loop closes contains
    /// one.
    fn between_ends(&self) -> Vec<f64> {
        let (ground, crank) = (length(self.c), self.crank);
        let cosines = [self.coupler + self.rocker, self.coupler - self.rocker]
            .map(|reach| (ground * ground + crank * crank - reach * reach) / (2.0 * ground * crank));
        let ends = cosines.into_iter().filter(|cosine| cosine.abs() <= 1.0).flat_map(|cosine| [cosine.acos(), -cosine.acos()]);
        let mut ends: Vec<f64> = ends.map(|end| within_a_turn(angle(self.c) + end)).collect();
        ends.sort_by(f64::total_cmp);
        ends.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect()
    }

    /// For a crank angle: half the common chord, squared, as in `circles`; unless it is negative, the angles of coupler and rocker and the
    /// position of P in both assemblies.
    pub(crate) fn closed(&self, crank: f64) -> (f64, Option<[Dyad; 2]>) {
        let a = [self.crank * crank.cos(), self.crank * crank.sin()];
        let (square, points) = circles(a, self.coupler, self.c, self.rocker);
        let all = points.map(|points| {
            points.map(|b| {
                let coupler = angle(minus(b, a));
                (coupler, angle(minus(b, self.c)), from(a, self.p, coupler))
            })
        });
        (square, all)
    }
}

fn random_four_bar(random: &mut Random) -> Linkage {
    let bar = FourBar::random(random);
    let crank = bar.at.to_radians();
    let assemblies = bar.closed(crank).1.into_iter().flatten().map(|(coupler, rocker, _)| vec![coupler, rocker, crank]).collect();
    let declaration = format!("{} drive input = drive_angle(crank, ({}) * 1deg + 1rad_s * t);", bar.declaration(), bar.at);
    Linkage { declaration, bodies: vec!["coupler", "rocker", "crank"], assemblies }
}

/// A four-bar with a link from its coupler to a lever.
fn six_bar(random: &mut Random) -> (FourBar, f64, f64, Point, Point, String) {
    let bar = FourBar::random(random);
    let (q, d) = (place(random, 500.0), place(random, 500.0));
    // Link and lever meet in one of the four-bar's assemblies.
    let p = bar.closed(bar.at.to_radians()).1.map_or([0.0; 2], |all| all[0].2);
    let (reach, lever) = (rounded(length(minus(q, p))), rounded(length(minus(q, d))));
    let declaration = format!(
        "{}{}{} joint d = revolute(coupler.P, reach.position); joint e = revolute(reach.B, lever.B); joint f = revolute(lever.position, ({}mm, {}mm)); ",
        bar.declaration(),
        link("reach", reach),
        link("lever", lever),
        d[0],
        d[1]
    );
    (bar, reach, lever, q, d, declaration)
}

/// The crank is driven: two dyads in sequence.
fn random_watt(random: &mut Random) -> Linkage {
    let (bar, reach, lever, _, d, declaration) = six_bar(random);
    let crank = bar.at.to_radians();
    let mut assemblies = Vec::new();
    for (coupler, rocker, p) in bar.closed(crank).1.into_iter().flatten() {
        for q in circles(p, reach, d, lever).1.into_iter().flatten() {
            assemblies.push(vec![coupler, rocker, angle(minus(q, p)), angle(minus(q, d)), crank]);
        }
    }
    let declaration = format!("{declaration} drive input = drive_angle(crank, ({}) * 1deg + 1rad_s * t);", bar.at);
    Linkage { declaration, bodies: vec!["coupler", "rocker", "reach", "lever", "crank"], assemblies }
}

/// The lever is driven: the crank angle is an unknown, at an intersection of a coupler curve with a circle.
fn random_stephenson(random: &mut Random) -> Linkage {
    let (bar, reach, lever, q, d, declaration) = six_bar(random);
    let turned = rounded(angle(minus(q, d)).to_degrees());
    let at = turned.to_radians();
    let q = [d[0] + lever * at.cos(), d[1] + lever * at.sin()];
    let declaration = format!("{declaration} drive input = drive_angle(lever, ({turned}) * 1deg + 1rad_s * t);");
    let assemblies = scanned(&bar, &|_, (_, _, p)| length(minus(*p, q)) - reach).into_iter().map(|(crank, side)| {
        let (coupler, rocker, p) = bar.closed(crank).1.expect("it closes where it was found")[side];
        vec![crank, coupler, rocker, angle(minus(q, p)), at]
    });
    Linkage { assemblies: assemblies.collect(), declaration, bodies: vec!["crank", "coupler", "rocker", "reach", "lever"] }
}

/// All crank angles, each with the side of the coupler, at which a function vanishes.
///
/// The circle is divided into the ranges in which the four-bar closes. Each is sampled, densely near its ends, where both sides meet. Every
/// change of sign is bisected, and every extremum that may cross zero is searched for two zeros.
pub(crate) fn scanned(bar: &FourBar, off: &dyn Fn(f64, &Dyad) -> f64) -> Vec<(f64, usize)> {
    const STEPS: usize = 720;
    let closes = |crank: f64| bar.closed(crank).0 >= 0.0;
    let mut grid: Vec<f64> = (0..=STEPS).map(|step| TAU * step as f64 / STEPS as f64 - PI).collect();
    grid.extend(bar.between_ends());
    grid.sort_by(f64::total_cmp);
    let edge = |mut inside: f64, mut outside: f64| {
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            if closes(middle) { inside = middle } else { outside = middle }
        }
        inside
    };
    let mut samples: Vec<Vec<f64>> = vec![Vec::new()];
    for pair in grid.windows(2) {
        let is_in = [closes(pair[0]), closes(pair[1])];
        // Denser towards an end.
        let finer = |end: f64, other: f64| (1..=40).map(move |step| end + (other - end) * (f64::from(step) / 40.0).powi(4));
        match is_in {
            [true, true] => samples.last_mut().unwrap().extend([pair[0], 0.5 * (pair[0] + pair[1]), pair[1]]),
            [true, false] => {
                let end = edge(pair[0], pair[1]);
                let mut last: Vec<f64> = finer(end, pair[0]).collect();
                last.reverse();
                samples.last_mut().unwrap().extend(last);
                samples.last_mut().unwrap().push(end);
                samples.push(Vec::new());
            }
            [false, true] => {
                let end = edge(pair[1], pair[0]);
                samples.push(vec![end]);
                samples.last_mut().unwrap().extend(finer(end, pair[1]));
            }
            [false, false] => {}
        }
    }
    let mut found: Vec<(f64, usize)> = Vec::new();
    for side in 0..2 {
        let off = |crank: f64| bar.closed(crank).1.map_or(f64::NAN, |all| off(crank, &all[side]));
        let root = |mut one: f64, mut other: f64| {
            let sign = off(one).signum();
            for _ in 0..80 {
                let middle = 0.5 * (one + other);
                if off(middle).signum() == sign { one = middle } else { other = middle }
            }
            0.5 * (one + other)
        };
        for range in &samples {
            let values: Vec<f64> = range.iter().map(|crank| off(*crank)).collect();
            for index in 1..range.len() {
                if values[index - 1] * values[index] < 0.0 {
                    found.push((root(range[index - 1], range[index]), side));
                }
            }
            for index in 1..range.len().saturating_sub(1) {
                let [before, here, after] = [values[index - 1], values[index], values[index + 1]];
                if before * here > 0.0 && here * after > 0.0 && here.abs() <= before.abs() && here.abs() <= after.abs() {
                    // The extremum, by ternary search.
                    let (mut low, mut high) = (range[index - 1], range[index + 1]);
                    for _ in 0..60 {
                        let (one, other) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
                        if off(one) * here < off(other) * here { high = other } else { low = one }
                    }
                    if off(low) * here < 0.0 {
                        found.push((root(range[index - 1], low), side));
                        found.push((root(low, range[index + 1]), side));
                    }
                }
            }
        }
    }
    let mut apart: Vec<(f64, usize)> = Vec::new();
    for (crank, side) in found {
        if apart.iter().all(|(other, same)| *same != side || within_a_turn(crank - other).abs() > 1e-9) {
            apart.push((crank, side));
        }
    }
    apart
}

pub(crate) fn within_a_turn(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// Squared distances of an assembly from its declared values and, for undeclared ones, from 0, modulo whole turns.
fn far(assembly: &[f64], declared: &[Option<f64>]) -> [f64; 2] {
    let mut far = [0.0; 2];
    for (value, declared) in assembly.iter().zip(declared) {
        far[usize::from(declared.is_none())] += within_a_turn(value - declared.unwrap_or(0.0)).powi(2);
    }
    far
}

/// Declared values decide between two assemblies unless they are equally near; then undeclared ones do. `None`: too close to decide.
fn order(one: [f64; 2], other: [f64; 2]) -> Option<core::cmp::Ordering> {
    let is_alike = |a: f64, b: f64| (a - b).abs() <= 1e-6 * a.max(b) + 1e-12;
    let is_doubtful = |a: f64, b: f64| (a - b).abs() <= CLOSE * a.max(b) + 1e-8;
    for (a, b) in one.into_iter().zip(other) {
        if !is_alike(a, b) {
            return (!is_doubtful(a, b)).then(|| a.total_cmp(&b));
        }
    }
    None
}

/// Tests random linkages of a kind: `all` in `.ci/run`, a third of them in the usual run, or as many as `REULEAUX_NEAREST` says. Those whose
/// nearest assembly is too close to call do not count.
pub(crate) fn look(kind: fn(&mut Random) -> Linkage, seed: u64, all: usize) {
    let count = std::env::var("REULEAUX_NEAREST").ok().and_then(|count| count.parse().ok()).unwrap_or(samples(all / 3, all));
    let mut random = Random(seed);
    let (mut judged, mut wrong) = (0, Vec::new());
    for number in 0..2 * count {
        let linkage = kind(&mut random);
        let how_many = (1 + number % 3).min(linkage.bodies.len());
        let mut declared: Vec<Option<f64>> = vec![None; linkage.bodies.len()];
        while declared.iter().flatten().count() < how_many {
            let which = (random.between(0.0, linkage.bodies.len() as f64) as usize).min(linkage.bodies.len() - 1);
            declared[which] = Some(random.between(-180.0, 180.0));
        }
        let radians: Vec<Option<f64>> = declared.iter().map(|degrees| degrees.map(f64::to_radians)).collect();
        let mut by_distance: Vec<([f64; 2], &Vec<f64>)> = linkage.assemblies.iter().map(|found| (far(found, &radians), found)).collect();
        by_distance.sort_by(|one, other| order(one.0, other.0).unwrap_or(core::cmp::Ordering::Equal));
        let Some((nearest, wanted)) = by_distance.first() else { continue };
        if by_distance[1..].iter().any(|(far, _)| order(*nearest, *far) != Some(core::cmp::Ordering::Less)) {
            continue;
        }
        let mut source = format!("mechanism Linkage {{ {} }}", linkage.declaration);
        for (body, degrees) in linkage.bodies.iter().zip(&declared) {
            let start = degrees.map_or(String::new(), |degrees| format!("start angle = ({degrees}) * 1deg;"));
            source = source.replace(&format!("/*{body}*/"), &start);
        }
        judged += 1;
        match reuleaux_compiler::compile(source.parse().expect("tokens")) {
            Ok(compiled) => {
                let found: Vec<f64> = linkage.bodies.iter().map(|body| start(&compiled, &format!("{body}.angle"))).collect();
                let is_same = |(found, wanted): (&f64, &f64)| within_a_turn(found - wanted).abs() < 1e-6;
                if !found.iter().zip(wanted.iter()).all(is_same) {
                    wrong.push(format!("{found:?} for {wanted:?} of {}\n{source}", linkage.assemblies.len()));
                }
                for (body, (found, declared)) in linkage.bodies.iter().zip(found.iter().zip(&radians)) {
                    let is_driven = source.contains(&format!("drive_angle({body}"));
                    assert!(
                        is_driven || (found - declared.unwrap_or(0.0)).abs() <= PI + 1e-9,
                        "{body} makes needless turns: {found}\n{source}"
                    );
                }
            }
            Err(refusals) => wrong.push(format!("{}\n{source}", refusals[0].fact)),
        }
        if judged == count {
            break;
        }
    }
    assert!(judged >= count.min(20), "{judged} could be judged");
    assert!(wrong.is_empty(), "{} of {judged}, first {}", wrong.len(), wrong[0]);
}

#[test]
fn nearest_of_a_four_bar() {
    look(random_four_bar, 0x9e37_79b9_7f4a_7c15, 60);
}

#[test]
fn nearest_of_two_dyads() {
    look(random_watt, 0x1357_9bdf_0246_8ace, 45);
}

#[test]
fn nearest_of_a_coupler_curve_and_a_circle() {
    look(random_stephenson, 0x0f1e_2d3c_4b5a_6978, 45);
}
