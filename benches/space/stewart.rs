//! S2: a Stewart platform whose lengths are given as samples with rates and accelerations.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use reuleaux::nalgebra::{Matrix3, Vector3};
use reuleaux::{Motion, SpatialBody, mechanism};
use reuleaux_benches::STEPS;
use reuleaux_benches::multibody::exact::{self, Numbers};
use reuleaux_benches::multibody::{Cut, Joint, Law, Model};

use crate::Workload;
use crate::follower::{DECLARED, Declared, Entry, HAND, Hand, Point, Turning};

mechanism! {
    /// A platform on six cylinders that are measured.
    pub mechanism Stewart in space {
        input length[0]: Length = 1.11944m;
        input length[1]: Length = 1.21463m;
        input length[2]: Length = 1.18574m;
        input length[3]: Length = 1.21681m;
        input length[4]: Length = 1.30976m;
        input length[5]: Length = 1.18323m;
        ground {
            for k in 0..3 {
                point B[2 * k] = (1m * cos(120deg * k - 10deg), 1m * sin(120deg * k - 10deg), 0m);
                point B[2 * k + 1] = (1m * cos(120deg * k + 10deg), 1m * sin(120deg * k + 10deg), 0m);
            }
        }
        body platform {
            for k in 0..3 {
                point P[2 * k] = (0.6m * cos(120deg * k - 50deg), 0.6m * sin(120deg * k - 50deg), 0m);
                point P[2 * k + 1] = (0.6m * cos(120deg * k + 50deg), 0.6m * sin(120deg * k + 50deg), 0m);
            }
            start position = (0m, 0.1m, 1m);
            start orientation = turn((0, 1, 0), 0.12rad) * turn((1, 0, 0), 0.067rad);
        }
        for k in 0..6 { drive leg[k] = drive_distance(ground.B[k], platform.P[k], length[k]); }
    }
}

/// Radii of base and platform (m), and half the angles between the ends of neighbouring legs (degrees).
const RADII: [f64; 2] = [1.0, 0.6];
const HALVES: [f64; 2] = [10.0, 50.0];
/// Place and angles about z, y and x of the motion: offset, amplitude, frequency in turns, phase.
const MOTION: [[f64; 4]; 6] = [
    [0.0, 0.1, 1.0, 0.0],
    [0.0, 0.1, 1.0, FRAC_PI_2],
    [1.0, 0.05, 2.0, 0.0],
    [0.0, 0.1, 1.0, 0.0],
    [0.0, 0.12, 1.0, FRAC_PI_2],
    [0.0, 0.08, 1.0, 1.0],
];

type Vector = Vector3<f64>;
/// Lengths of all legs in all steps, with rates and accelerations.
type Samples = Vec<[[f64; 3]; 6]>;

/// Ends of the legs at the base and in the platform.
fn ends() -> [[Vector; 6]; 2] {
    [0, 1].map(|of| {
        std::array::from_fn(|k| {
            let half = if k % 2 == 0 { -HALVES[of] } else { HALVES[of] };
            let (sine, cosine) = (120.0 * (k / 2) as f64 + half).to_radians().sin_cos();
            Vector::new(RADII[of] * cosine, RADII[of] * sine, 0.0)
        })
    })
}

fn platform(name: &str) -> Model {
    let mut model = Model::new(name);
    let joints = [Joint::Shift(0), Joint::Shift(1), Joint::Shift(2), Joint::Turn(2), Joint::Turn(1), Joint::Turn(0)];
    model.hang("platform", None, &joints, &[0.0, 0.1, 1.0, 0.0, 0.12, 0.067]);
    model
}

/// The lengths of the legs while the platform moves.
fn samples() -> Samples {
    let mut model = platform("motion");
    model.drives = MOTION.iter().enumerate().map(|(k, &[o, a, turns, phase])| (k, Law::Harmonic(o, a, TAU * turns, phase))).collect();
    let mut motion = exact::Motion::new(&model);
    let sampled = |k: usize| {
        motion.follow(k as f64 / STEPS as f64);
        legs(&motion.bodies()[0])
    };
    (0..STEPS).map(sampled).collect()
}

fn legs(body: &Numbers) -> [[f64; 3]; 6] {
    let [base, platform] = ends();
    let [p, v, omega, a, alpha] = [9, 12, 15, 18, 21].map(|first: usize| Vector::new(body[first], body[first + 1], body[first + 2]));
    let rotation = Matrix3::from_row_slice(&body[..9]);
    std::array::from_fn(|k| {
        let turning = Turning { axes: [0, 1, 2].map(|j| rotation.column(j).into()), omega, alpha };
        let end = Point { p, v, a }.beside(&turning, rotation * platform[k]);
        let edge = end.p - base[k];
        let length = edge.norm();
        let rate = edge.dot(&end.v) / length;
        [length, rate, (end.v.norm_squared() + edge.dot(&end.a) - rate * rate) / length]
    })
}

pub(crate) fn workload() -> Workload {
    let samples = samples();
    let mut model = platform("S2 Stewart platform");
    let [base, platform] = ends().map(|ends| ends.map(|end| -> [f64; 3] { end.into() }));
    model.cuts = (0..6)
        .map(|k| Cut::Distance((Some(0), platform[k]), (None, base[k]), Law::Samples(samples.iter().map(|legs| legs[k]).collect())))
        .collect();
    model.close();
    Workload { model, contenders }
}

/// The step of this time.
fn number(t: f64) -> usize {
    (t * STEPS as f64).round() as usize
}

fn contenders() -> Vec<Entry> {
    let samples = Arc::new(samples());
    let legs = Arc::clone(&samples);
    let rig = Rig { ends: ends() };
    let mut start = Pose { t: 0.0, place: Vector::new(0.0, 0.1, 1.0), turn: [1.0, 0.0, 0.0, 0.0], rates: [[0.0; 6]; 2] };
    rig.followed(&mut start, 0.0, &samples[0]);
    vec![Entry::new(HAND, Hand::new(start, move |pose, t| [rig.followed(pose, t, &legs[number(t)])])), declared(samples)]
}

fn declared(samples: Arc<Samples>) -> Entry {
    let mechanism = Stewart::default();
    let inputs = move |t: f64| StewartInputs { length: samples[number(t)].map(|[value, rate, change]| Motion::new(value, rate, change)) };
    let origin = mechanism.solve(0.0, inputs(0.0)).unwrap_or_else(|failure| panic!("{failure}"));
    let advance = move |mechanism: &mut Stewart, state: &mut StewartState<f64>, t: f64| {
        mechanism.advance(state, t, inputs(t)).unwrap_or_else(|failure| panic!("{failure}"));
    };
    let read = |state: &StewartState<f64>| vec![state.platform()];
    Entry::new(DECLARED, Declared { state: origin.clone(), mechanism, origin, advance, read })
}

/// Ends of the legs at the base and in the platform.
struct Rig {
    ends: [[Vector; 6]; 2],
}

/// Place, quaternion, velocity and angular velocity, and their accelerations.
#[derive(Clone)]
struct Pose {
    t: f64,
    place: Vector,
    turn: [f64; 4],
    rates: [[f64; 6]; 2],
}

/// Legs and unknowns in an order in which pivots are large: z, x, a turn about x, one about z, y, a turn about y.
const LEGS: [usize; 6] = [2, 1, 5, 0, 3, 4];
const UNKNOWNS: [usize; 6] = [2, 0, 3, 5, 1, 4];

/// Legs as vectors, and from the platform's place to their ends.
struct Legs {
    edges: [Vector; 6],
    arms: [Vector; 6],
}

/// L and U, with one over the pivots.
struct Factors([[f64; 6]; 6]);

impl Factors {
    /// Of how the halves of the squares of the lengths grow.
    #[allow(clippy::needless_range_loop)] // Two rows of one matrix.
    #[inline(always)]
    fn new(legs: &Legs) -> Self {
        let mut matrix: [[f64; 6]; 6] = std::array::from_fn(|row| {
            let leg = LEGS[row];
            let (edge, moment) = (legs.edges[leg], legs.arms[leg].cross(&legs.edges[leg]));
            let entries = [edge.x, edge.y, edge.z, moment.x, moment.y, moment.z];
            UNKNOWNS.map(|unknown| entries[unknown])
        });
        for k in 0..6 {
            let pivot = 1.0 / matrix[k][k];
            matrix[k][k] = pivot;
            for i in k + 1..6 {
                let factor = matrix[i][k] * pivot;
                matrix[i][k] = factor;
                for j in k + 1..6 {
                    matrix[i][j] -= factor * matrix[k][j];
                }
            }
        }
        Self(matrix)
    }

    #[inline(always)]
    fn solve(&self, of_legs: [f64; 6]) -> [f64; 6] {
        let mut found = LEGS.map(|leg| of_legs[leg]);
        for k in 0..6 {
            for i in k + 1..6 {
                found[i] -= self.0[i][k] * found[k];
            }
        }
        for k in (0..6).rev() {
            for j in k + 1..6 {
                found[k] -= self.0[k][j] * found[j];
            }
            found[k] *= self.0[k][k];
        }
        let mut ordered = [0.0; 6];
        for (place, value) in UNKNOWNS.into_iter().zip(found) {
            ordered[place] = value;
        }
        ordered
    }
}

fn halves([x, y, z, u, v, w]: [f64; 6]) -> [Vector; 2] {
    [Vector::new(x, y, z), Vector::new(u, v, w)]
}

impl Rig {
    #[inline(always)]
    fn legs(&self, place: Vector, axes: &[Vector; 3]) -> Legs {
        let arms = self.ends[1].map(|end| axes[0] * end.x + axes[1] * end.y);
        Legs { edges: std::array::from_fn(|k| place + arms[k] - self.ends[0][k]), arms }
    }

    /// Newton's method from where the platform would be with the acceleration of the step before.
    #[inline(always)]
    fn followed(&self, pose: &mut Pose, t: f64, lengths: &[[f64; 3]; 6]) -> SpatialBody<f64> {
        let h = t - pose.t;
        let guess: [f64; 6] = std::array::from_fn(|k| h * (pose.rates[0][k] + 0.5 * h * pose.rates[1][k]));
        let [shift, turn] = halves(guess);
        let (mut place, mut quaternion) = (pose.place + shift, turned(pose.turn, turn));
        let (axes, legs) = loop {
            let axes = columns(quaternion);
            let legs = self.legs(place, &axes);
            let short = std::array::from_fn(|k| 0.5 * (lengths[k][0] * lengths[k][0] - legs.edges[k].norm_squared()));
            let change = Factors::new(&legs).solve(short);
            let [shift, turn] = halves(change);
            (place, quaternion) = (place + shift, turned(quaternion, turn));
            // The next correction would be about the square of this one.
            if shift.norm_squared() + turn.norm_squared() < 1e-15 {
                let axes = columns(quaternion);
                break (axes, self.legs(place, &axes));
            }
        };
        let factors = Factors::new(&legs);
        let rates = factors.solve(lengths.map(|[length, rate, _]| length * rate));
        let [v, omega] = halves(rates);
        let changes = factors.solve(std::array::from_fn(|k| {
            let [length, rate, change] = lengths[k];
            let swing = omega.cross(&legs.arms[k]);
            rate * rate + length * change - (v + swing).norm_squared() - legs.edges[k].dot(&omega.cross(&swing))
        }));
        *pose = Pose { t, place, turn: quaternion, rates: [rates, changes] };
        let [a, alpha] = halves(changes);
        Turning { axes, omega, alpha }.body(&Point { p: place, v, a })
    }
}

/// The quaternion after a small turn by this vector, about axes of ground, of length one to all digits.
#[inline(always)]
fn turned([w, x, y, z]: [f64; 4], by: Vector) -> [f64; 4] {
    let square = by.norm_squared();
    let half = by * (0.5 - square * (1.0 / 48.0));
    let (a, b, c) = (half.x, half.y, half.z);
    let change = 1.0 - square * (0.125 - square * (1.0 / 384.0));
    let turned = [
        change * w - a * x - b * y - c * z,
        change * x + a * w + b * z - c * y,
        change * y + b * w + c * x - a * z,
        change * z + c * w + a * y - b * x,
    ];
    let square: f64 = turned.iter().map(|entry| entry * entry).sum();
    let per = 1.5 - 0.5 * square;
    turned.map(|entry| entry * per)
}

/// The columns of the matrix of a quaternion.
#[inline(always)]
fn columns([w, x, y, z]: [f64; 4]) -> [Vector; 3] {
    let (x2, y2, z2) = (x + x, y + y, z + z);
    let (xx, yy, zz, xy, yz, zx) = (x * x2, y * y2, z * z2, x * y2, y * z2, z * x2);
    let (wx, wy, wz) = (w * x2, w * y2, w * z2);
    [
        Vector::new(1.0 - yy - zz, xy + wz, zx - wy),
        Vector::new(xy - wz, 1.0 - xx - zz, yz + wx),
        Vector::new(zx + wy, yz - wx, 1.0 - xx - yy),
    ]
}
