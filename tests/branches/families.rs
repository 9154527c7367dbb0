//! Mechanisms whose loops have many assemblies, several of them with the same sign of the determinant, with random dimensions and laws:
//! as a declaration, and as a loop of distances.

use fastrand::Rng;
use reuleaux::nalgebra::SVector;
use reuleaux::{Mechanism, mechanism};
use std::f64::consts::{PI, TAU};

use super::track::{Bar, Complex, Law, Led, Loop, Place, Way, complex};

mechanism! {
    /// A plate on three cylinders.
    #[closure(off)]
    pub mechanism Cylinders {
        for i in 0..3 {
            param x[i]: Length = 0;
            param y[i]: Length = 0;
            param u[i]: Length = 0;
            param v[i]: Length = 0;
            param length[i]: Length = 0;
            param stroke[i]: Length = 0;
            param frequency[i]: AngularVelocity = 0;
            param phase[i]: Angle = 0;
        }
        ground { for i in 0..3 { point A[i] = (x[i], y[i]); } }
        body plate { for i in 0..3 { point P[i] = (u[i], v[i]); } }
        for i in 0..3 {
            drive cylinder[i] = drive_distance(ground.A[i], plate.P[i], length[i] + stroke[i] * sin(frequency[i] * t + phase[i]));
        }
    }
}

mechanism! {
    /// A plate on three links, each on a driven crank.
    #[closure(off)]
    pub mechanism Platform {
        for i in 0..3 {
            param x[i]: Length = 0;
            param y[i]: Length = 0;
            param arm[i]: Length = 0;
            param link_length[i]: Length = 0;
            param u[i]: Length = 0;
            param v[i]: Length = 0;
            param angle[i]: Angle = 0;
            param speed[i]: AngularVelocity = 0;
            param swing[i]: Angle = 0;
            param frequency[i]: AngularVelocity = 0;
            param phase[i]: Angle = 0;
        }
        ground { for i in 0..3 { point O[i] = (x[i], y[i]); } }
        for i in 0..3 {
            body crank[i] { point B = (arm[i], 0); }
            body link[i] { point P = (link_length[i], 0); }
        }
        body plate { for i in 0..3 { point P[i] = (u[i], v[i]); } }
        for i in 0..3 {
            joint o[i] = revolute(ground.O[i], crank[i].position);
            joint b[i] = revolute(crank[i].B, link[i].position);
            joint p[i] = revolute(link[i].P, plate.P[i]);
            drive motor[i] = drive_angle(crank[i], angle[i] + speed[i] * t + swing[i] * sin(frequency[i] * t + phase[i]));
        }
    }
}

mechanism! {
    /// A Stephenson six-bar driven at its far link: two levers on fixed pivots carry a coupler, whose third point a driven crank leads.
    #[closure(off)]
    pub mechanism Stephenson {
        for i in 0..3 {
            param x[i]: Length = 0;
            param y[i]: Length = 0;
            param link_length[i]: Length = 0;
            param u[i]: Length = 0;
            param v[i]: Length = 0;
        }
        param arm: Length = 0;
        param angle: Angle = 0;
        param speed: AngularVelocity = 0;
        param swing: Angle = 0;
        param frequency: AngularVelocity = 0;
        param phase: Angle = 0;
        ground { for i in 0..3 { point O[i] = (x[i], y[i]); } }
        body crank { point B = (arm, 0); }
        for i in 0..3 { body link[i] { point P = (link_length[i], 0); } }
        body plate { for i in 0..3 { point P[i] = (u[i], v[i]); } }
        joint o = revolute(ground.O[2], crank.position);
        joint b = revolute(crank.B, link[2].position);
        for i in 0..2 { joint pivot[i] = revolute(ground.O[i], link[i].position); }
        for i in 0..3 { joint p[i] = revolute(link[i].P, plate.P[i]); }
        drive motor = drive_angle(crank, angle + speed * t + swing * sin(frequency * t + phase));
    }
}

mechanism! {
    /// A group of the fourth class: two triangles, each with a corner on a driven crank, joined by two bars.
    #[closure(off)]
    pub mechanism Fourth {
        for i in 0..2 {
            param x[i]: Length = 0;
            param y[i]: Length = 0;
            param arm[i]: Length = 0;
            param angle[i]: Angle = 0;
            param speed[i]: AngularVelocity = 0;
            param swing[i]: Angle = 0;
            param frequency[i]: AngularVelocity = 0;
            param phase[i]: Angle = 0;
            param bar_length[i]: Length = 0;
            for j in 0..2 {
                param u[i][j]: Length = 0;
                param v[i][j]: Length = 0;
            }
        }
        ground { for i in 0..2 { point O[i] = (x[i], y[i]); } }
        for i in 0..2 {
            body crank[i] { point E = (arm[i], 0); }
            body plate[i] { for j in 0..2 { point P[j] = (u[i][j], v[i][j]); } }
            body link[i] { point end = (bar_length[i], 0); }
            joint o[i] = revolute(ground.O[i], crank[i].position);
            joint e[i] = revolute(crank[i].E, plate[i].position);
            drive motor[i] = drive_angle(crank[i], angle[i] + speed[i] * t + swing[i] * sin(frequency[i] * t + phase[i]));
        }
        for j in 0..2 {
            joint a[j] = revolute(plate[0].P[j], link[j].position);
            joint b[j] = revolute(link[j].end, plate[1].P[j]);
        }
    }
}

/// A mechanism and its loop of distances.
#[derive(Clone, Debug)]
pub struct Sample<M, const N: usize> {
    /// The mechanism.
    pub mechanism: M,
    /// The loop as distances.
    pub distances: Loop<2, 4>,
    /// Position of the loop at t = 0.
    pub start: Place<2>,
    /// The same position in the mechanism's coordinates.
    pub guess: SVector<f64, N>,
    /// Bodies whose angles are those of `distances.arms`.
    pub bodies: Vec<String>,
    /// Bodies with origins at the ends of these vectors.
    pub origins: Vec<(String, Way<2>)>,
}

/// Mechanisms of one topology.
pub trait Family<const N: usize>: Mechanism<f64, N> + Sized + Clone + std::fmt::Debug {
    /// Name of the family.
    const TITLE: &'static str;

    /// A random mechanism; None if the random numbers give none that closes.
    fn random(random: &mut Rng) -> Option<Sample<Self, N>>;
}

const ONE: Complex = complex(1.0, 0.0);
const NONE: Complex = complex(0.0, 0.0);

/// Shortest length, in m; lengths are those of a small machine.
const SHORTEST: f64 = 0.02;

fn between(random: &mut Rng, least: f64, most: f64) -> f64 {
    least + (most - least) * random.f64()
}

fn point(random: &mut Rng, size: f64) -> Complex {
    complex(between(random, -size, size), between(random, -size, size))
}

fn angle(random: &mut Rng) -> f64 {
    between(random, -PI, PI)
}

/// Law of an angle that oscillates or increases steadily.
fn turning(random: &mut Rng) -> Law {
    let constant = angle(random);
    match random.u8(0..3) {
        0 => Law { rate: if random.bool() { TAU } else { -TAU }, constant, ..Law::default() },
        kind => {
            let (amplitude, frequency) = (between(random, 0.1, 2.5), TAU * f64::from(random.u8(1..4)));
            let phase = if kind == 1 { 0.0 } else { angle(random) };
            Law { constant, amplitude, frequency, phase, rate: 0.0 }
        }
    }
}

/// Law of a length that is `now` at t = 0.
fn stroke(random: &mut Rng, now: f64) -> Law {
    let amplitude = between(random, 0.05, 0.9) * now.min(0.3);
    let phase = if random.bool() { 0.0 } else { angle(random) };
    let constant = now - amplitude * phase.sin();
    Law { constant, amplitude: amplitude.min(0.95 * constant), frequency: TAU * f64::from(random.u8(1..4)), phase, rate: 0.0 }
}

fn led(random: &mut Rng, size: f64) -> Led {
    Led { pivot: point(random, size), arm: between(random, 0.03, 0.25), angle: turning(random) }
}

/// The condition that the arm z_k of a rotating body keeps its length.
fn turned(index: usize, size: f64) -> Bar<2> {
    let mut factors = [NONE; 2];
    factors[index] = ONE;
    Bar { way: Way { factors, from: Led::default(), to: Led::default() }, length: Law::fixed(size) }
}

/// A plate with three points: z₀ is its position, z₁ its direction times the greatest distance of a point.
struct Plate {
    points: [Complex; 3],
    size: f64,
    z: [Complex; 2],
    turn: f64,
}

impl Plate {
    fn random(random: &mut Rng) -> Self {
        let points = [0; 3].map(|_| point(random, 0.25));
        let size = points.iter().map(|point| point.abs()).fold(0.0, f64::max);
        let turn = angle(random);
        Self { points, size, z: [point(random, 0.25), Complex::polar(size, turn)], turn }
    }

    /// Vector from a driven point to a point of the plate.
    fn way(&self, from: Led, index: usize) -> Way<2> {
        Way { factors: [ONE, self.points[index].times(1.0 / self.size)], from, to: Led::default() }
    }

    fn arm(&self) -> Way<2> {
        Way { factors: [NONE, ONE], from: Led::default(), to: Led::default() }
    }

    fn origin(&self) -> Way<2> {
        Way { factors: [ONE, NONE], from: Led::default(), to: Led::default() }
    }

    /// A plate whose points have these distances from driven points.
    fn on(&self, lengths: [Law; 3], feet: [Led; 3]) -> Loop<2, 4> {
        let bar = |i: usize| Bar { way: self.way(feet[i], i), length: lengths[i] };
        let bars = [bar(0), bar(1), bar(2), turned(1, self.size)];
        Loop { bars, arms: vec![self.arm()] }
    }
}

/// A vector of coordinates from the positions and angles of bodies.
fn coordinates<M: Mechanism<f64, N>, const N: usize>(bodies: &[(String, Complex, f64)]) -> SVector<f64, N> {
    let mut q = SVector::zeros();
    for (body, origin, angle) in bodies {
        for (name, value) in [("x", origin.x), ("y", origin.y), ("angle", *angle)] {
            q[index::<M, N>(body, name)] = value;
        }
    }
    q
}

/// The index of a coordinate in q.
///
/// # Panics
/// If there is none.
#[must_use]
pub fn index<M: Mechanism<f64, N>, const N: usize>(body: &str, name: &str) -> usize {
    let is_meant = |coordinate: &reuleaux::Coordinate| coordinate.body == body && coordinate.name == name;
    M::COORDINATES.iter().position(is_meant).unwrap_or_else(|| panic!("no {name} of {body} in {}", M::NAME))
}

fn texts(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

impl Family<3> for Cylinders {
    const TITLE: &'static str = "plate on three cylinders";

    fn random(random: &mut Rng) -> Option<Sample<Self, 3>> {
        let plate = Plate::random(random);
        let feet = [0; 3].map(|_| Led::fixed(point(random, 0.4)));
        let now = [0, 1, 2].map(|i| plate.way(feet[i], i).at(&plate.z, 0.0).abs());
        let lengths = now.map(|now| stroke(random, now));
        let mechanism = Cylinders {
            x: feet.map(|foot| foot.pivot.x),
            y: feet.map(|foot| foot.pivot.y),
            u: plate.points.map(|point| point.x),
            v: plate.points.map(|point| point.y),
            length: lengths.map(|law| law.constant),
            stroke: lengths.map(|law| law.amplitude),
            frequency: lengths.map(|law| law.frequency),
            phase: lengths.map(|law| law.phase),
        };
        let distances = plate.on(lengths, feet);
        let guess = coordinates::<Self, 3>(&[("plate".to_owned(), plate.z[0], plate.turn)]);
        let is_one = now.iter().zip(&lengths).all(|(now, law)| *now > SHORTEST && (law.value(0.0) - now).abs() < 1e-9);
        let start = distances.place(plate.z, 0.0);
        let origins = vec![("plate".to_owned(), plate.origin())];
        is_one.then(|| Sample { start, guess, distances, bodies: texts(&["plate"]), origins, mechanism })
    }
}

impl Family<21> for Platform {
    const TITLE: &'static str = "plate on three cranks and links";

    fn random(random: &mut Rng) -> Option<Sample<Self, 21>> {
        let plate = Plate::random(random);
        let feet = [0; 3].map(|_| led(random, 0.4));
        let ways = [0, 1, 2].map(|i| plate.way(feet[i], i));
        let now = ways.map(|way| way.at(&plate.z, 0.0));
        let mechanism = Platform {
            x: feet.map(|foot| foot.pivot.x),
            y: feet.map(|foot| foot.pivot.y),
            arm: feet.map(|foot| foot.arm),
            link_length: now.map(Complex::abs),
            u: plate.points.map(|point| point.x),
            v: plate.points.map(|point| point.y),
            angle: feet.map(|foot| foot.angle.constant),
            speed: feet.map(|foot| foot.angle.rate),
            swing: feet.map(|foot| foot.angle.amplitude),
            frequency: feet.map(|foot| foot.angle.frequency),
            phase: feet.map(|foot| foot.angle.phase),
        };
        let mut distances = plate.on(now.map(|way| Law::fixed(way.abs())), feet);
        distances.arms.extend(ways);
        let mut bodies = vec![("plate".to_owned(), plate.z[0], plate.turn)];
        for (i, foot) in feet.iter().enumerate() {
            bodies.push((format!("crank[{i}]"), foot.pivot, foot.angle.value(0.0)));
            bodies.push((format!("link[{i}]"), foot.at(0.0), now[i].angle()));
        }
        let guess = coordinates::<Self, 21>(&bodies);
        let start = distances.place(plate.z, 0.0);
        let is_one = now.iter().all(|way| way.abs() > SHORTEST);
        let bodies = texts(&["plate", "link[0]", "link[1]", "link[2]"]);
        let origins = vec![("plate".to_owned(), plate.origin())];
        is_one.then_some(Sample { start, guess, distances, bodies, origins, mechanism })
    }
}

impl Family<15> for Stephenson {
    const TITLE: &'static str = "Stephenson six-bar driven at its far link";

    fn random(random: &mut Rng) -> Option<Sample<Self, 15>> {
        let plate = Plate::random(random);
        let feet = [Led::fixed(point(random, 0.4)), Led::fixed(point(random, 0.4)), led(random, 0.4)];
        let ways = [0, 1, 2].map(|i| plate.way(feet[i], i));
        let now = ways.map(|way| way.at(&plate.z, 0.0));
        let crank = feet[2];
        let mechanism = Stephenson {
            x: feet.map(|foot| foot.pivot.x),
            y: feet.map(|foot| foot.pivot.y),
            link_length: now.map(Complex::abs),
            u: plate.points.map(|point| point.x),
            v: plate.points.map(|point| point.y),
            arm: crank.arm,
            angle: crank.angle.constant,
            speed: crank.angle.rate,
            swing: crank.angle.amplitude,
            frequency: crank.angle.frequency,
            phase: crank.angle.phase,
        };
        let mut distances = plate.on(now.map(|way| Law::fixed(way.abs())), feet);
        distances.arms.extend(ways);
        let mut bodies = vec![("plate".to_owned(), plate.z[0], plate.turn), ("crank".to_owned(), crank.pivot, crank.angle.value(0.0))];
        bodies.extend(feet.iter().enumerate().map(|(i, foot)| (format!("link[{i}]"), foot.at(0.0), now[i].angle())));
        let guess = coordinates::<Self, 15>(&bodies);
        let start = distances.place(plate.z, 0.0);
        let is_one = now.iter().all(|way| way.abs() > SHORTEST);
        let bodies = texts(&["plate", "link[0]", "link[1]", "link[2]"]);
        let origins = vec![("plate".to_owned(), plate.origin())];
        is_one.then_some(Sample { start, guess, distances, bodies, origins, mechanism })
    }
}

impl Family<18> for Fourth {
    const TITLE: &'static str = "group of the fourth class";

    fn random(random: &mut Rng) -> Option<Sample<Self, 18>> {
        let feet = [0; 2].map(|_| led(random, 0.3));
        let points = [0; 2].map(|_| [0; 2].map(|_| point(random, 0.3)));
        let sizes = points.map(|[one, two]| one.abs().max(two.abs()));
        let turns = [0; 2].map(|_| angle(random));
        let z = [0, 1].map(|i| Complex::polar(sizes[i], turns[i]));
        // From a point of the first triangle to a point of the second.
        let ways = [0, 1].map(|j| {
            let part = |i: usize| points[i][j].times(1.0 / sizes[i]);
            Way { factors: [part(0).times(-1.0), part(1)], from: feet[0], to: feet[1] }
        });
        let now = ways.map(|way| way.at(&z, 0.0));
        let mechanism = Fourth {
            x: feet.map(|foot| foot.pivot.x),
            y: feet.map(|foot| foot.pivot.y),
            arm: feet.map(|foot| foot.arm),
            angle: feet.map(|foot| foot.angle.constant),
            speed: feet.map(|foot| foot.angle.rate),
            swing: feet.map(|foot| foot.angle.amplitude),
            frequency: feet.map(|foot| foot.angle.frequency),
            phase: feet.map(|foot| foot.angle.phase),
            bar_length: now.map(Complex::abs),
            u: points.map(|pair| pair.map(|point| point.x)),
            v: points.map(|pair| pair.map(|point| point.y)),
        };
        let bar = |j: usize| Bar { way: ways[j], length: Law::fixed(now[j].abs()) };
        let triangles = [0, 1].map(|i| turned(i, sizes[i]));
        let distances =
            Loop { bars: [bar(0), bar(1), triangles[0], triangles[1]], arms: vec![triangles[0].way, triangles[1].way, ways[0], ways[1]] };
        let mut places = Vec::new();
        for (i, foot) in feet.iter().enumerate() {
            places.push((format!("crank[{i}]"), foot.pivot, foot.angle.value(0.0)));
            places.push((format!("plate[{i}]"), foot.at(0.0), turns[i]));
            let corner = feet[0].at(0.0) + points[0][i].times(1.0 / sizes[0]) * z[0];
            places.push((format!("link[{i}]"), corner, now[i].angle()));
        }
        let guess = coordinates::<Self, 18>(&places);
        let start = distances.place(z, 0.0);
        let is_one = now.iter().all(|way| way.abs() > SHORTEST) && sizes.iter().all(|size| *size > SHORTEST);
        let bodies = texts(&["plate[0]", "plate[1]", "link[0]", "link[1]"]);
        is_one.then(|| Sample { start, guess, distances, bodies, origins: Vec::new(), mechanism })
    }
}
