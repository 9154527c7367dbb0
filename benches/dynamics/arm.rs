//! D4: the arm of six hinges of the UR5's dimensions: torques that a motion takes, and accelerations that torques give.

use std::f64::consts::TAU;

use reuleaux::nalgebra::Vector3;
use reuleaux::{Dynamics, SimdReal, mechanism};
use reuleaux_benches::multibody::Model;
use reuleaux_benches::multibody::arm::{self, A, CENTERS, D, DRIVES, INERTIAS, MASSES, TWIST};
use reuleaux_benches::multibody::forces::reaction;

use crate::case::{ACCELERATIONS, Case, Entry, Given, HAND_ACCELERATIONS, HAND_LOADS, LOADS, STATES, exact_in};

macro_rules! arm {
    ($(#[$page:meta])* $name:ident, $($rest:tt)*) => {
        mechanism! {
            $(#[$page])*
            pub(crate) mechanism $name in space {
                $($rest)*
                gravity = (0m_s2, 0m_s2, -9.81m_s2);
                ground { axis z = (0, 0, 1) from (1, 0, 0); }
                body one {
                    axis z = (0, 0, 1) from (1, 0, 0);  axis next = (0, -1, 0) from (1, 0, 0);  point P = (0m, 0m, 0.089159m);
                    mass = 3.7kg;  center = (0m, -0.02561m, 0.00193m);  inertia = (0.0084kgm2, 0.0064kgm2, 0.0084kgm2);
                }
                body two {
                    axis z = (0, 0, 1) from (1, 0, 0);  point P = (-0.425m, 0m, 0m);
                    mass = 8.393kg;  center = (0.2125m, 0m, 0.11336m);  inertia = (0.0078kgm2, 0.21kgm2, 0.21kgm2);
                }
                body three {
                    axis z = (0, 0, 1) from (1, 0, 0);  point P = (-0.39225m, 0m, 0m);
                    mass = 2.275kg;  center = (0.11993m, 0m, 0.0265m);  inertia = (0.0016kgm2, 0.0462kgm2, 0.0462kgm2);
                }
                body four {
                    axis z = (0, 0, 1) from (1, 0, 0);  axis next = (0, -1, 0) from (1, 0, 0);  point P = (0m, 0m, 0.10915m);
                    mass = 1.219kg;  center = (0m, -0.0018m, 0.01634m);  inertia = (0.0016kgm2, 0.0016kgm2, 0.0009kgm2);
                }
                body five {
                    axis z = (0, 0, 1) from (1, 0, 0);  axis next = (0, 1, 0) from (1, 0, 0);  point P = (0m, 0m, 0.09465m);
                    mass = 1.219kg;  center = (0m, 0.0018m, 0.01634m);  inertia = (0.0016kgm2, 0.0016kgm2, 0.0009kgm2);
                }
                body six {
                    axis z = (0, 0, 1) from (1, 0, 0);
                    mass = 0.1879kg;  center = (0m, 0m, -0.001159m);  inertia = (0.0001kgm2, 0.0001kgm2, 0.0001kgm2);
                }
                joint a = revolute(ground.position, ground.z, one.position, one.z);
                joint b = revolute(one.P, one.next, two.position, two.z);
                joint c = revolute(two.P, two.z, three.position, three.z);
                joint d = revolute(three.P, three.z, four.position, four.z);
                joint e = revolute(four.P, four.next, five.position, five.z);
                joint f = revolute(five.P, five.next, six.position, six.z);
            }
        }
    };
}

arm!(
    /// All joints swing.
    Driven,
    drive of_a = drive_rotation(a, 0.3rad + 0.8rad * sin(1turn * t / 1s));
    drive of_b = drive_rotation(b, -1.2rad + 0.5rad * sin(1turn * t / 1s + 0.4rad));
    drive of_c = drive_rotation(c, 1.1rad + 0.6rad * sin(2turn * t / 1s + 1rad));
    drive of_d = drive_rotation(d, -0.7rad + 0.7rad * sin(1turn * t / 1s + 1.5rad));
    drive of_e = drive_rotation(e, 0.9rad + 0.9rad * sin(2turn * t / 1s + 2.2rad));
    drive of_f = drive_rotation(f, 0.2rad + 1.1rad * sin(1turn * t / 1s + 0.9rad));
);

arm!(
    /// No joint is driven.
    Free,
    param start_a: Angle = 0.3rad;  param speed_a: AngularVelocity = 0rad_s;
    param start_b: Angle = -1.2rad;  param speed_b: AngularVelocity = 0rad_s;
    param start_c: Angle = 1.1rad;  param speed_c: AngularVelocity = 0rad_s;
    param start_d: Angle = -0.7rad;  param speed_d: AngularVelocity = 0rad_s;
    param start_e: Angle = 0.9rad;  param speed_e: AngularVelocity = 0rad_s;
    param start_f: Angle = 0.2rad;  param speed_f: AngularVelocity = 0rad_s;
    freedom of_a = a.angle from start_a at speed_a;
    freedom of_b = b.angle from start_b at speed_b;
    freedom of_c = c.angle from start_c at speed_c;
    freedom of_d = d.angle from start_d at speed_d;
    freedom of_e = e.angle from start_e at speed_e;
    freedom of_f = f.angle from start_f at speed_f;
);

const GRAVITY: f64 = 9.81;

type Vector = Vector3<f64>;
/// Angles, rates and accelerations.
type Motion = [[f64; 6]; 3];

fn motion(number: usize) -> Motion {
    let t = number as f64 / STATES as f64;
    let mut motion = [[0.0; 6]; 3];
    for (k, [offset, amplitude, frequency, phase]) in DRIVES.into_iter().enumerate() {
        let omega = TAU * frequency;
        let (sine, cosine) = (omega * t + phase).sin_cos();
        let of = [offset + amplitude * sine, amplitude * omega * cosine, -amplitude * omega * omega * sine];
        (0..3).for_each(|level| motion[level][k] = of[level]);
    }
    motion
}

/// a x − b y, without the products by a zero that is known.
#[inline(always)]
fn difference(a: f64, x: f64, b: f64, y: f64) -> f64 {
    match (a == 0.0, b == 0.0) {
        (true, true) => 0.0,
        (true, false) => -(b * y),
        (false, true) => a * x,
        (false, false) => a * x - b * y,
    }
}

/// v × c of a constant c.
#[inline(always)]
fn across(v: Vector, [x, y, z]: [f64; 3]) -> Vector {
    Vector::new(difference(z, v.y, y, v.z), difference(x, v.z, z, v.x), difference(y, v.x, x, v.y))
}

/// A vector of the link before along the axes of a link after the twist and the turn of its hinge, and back.
#[inline(always)]
fn inward<const K: usize>(v: Vector, [sine, cosine]: [f64; 2]) -> Vector {
    let (y, z) = match TWIST[K - 1] {
        1 => (v.z, -v.y),
        -1 => (-v.z, v.y),
        _ => (v.y, v.z),
    };
    Vector::new(cosine * v.x + sine * y, cosine * y - sine * v.x, z)
}

#[inline(always)]
fn outward<const K: usize>(v: Vector, [sine, cosine]: [f64; 2]) -> Vector {
    let (x, y) = (cosine * v.x - sine * v.y, sine * v.x + cosine * v.y);
    match TWIST[K - 1] {
        1 => Vector::new(x, -v.z, y),
        -1 => Vector::new(x, v.z, -y),
        _ => Vector::new(x, y, v.z),
    }
}

/// Angular velocity and acceleration, and the acceleration of the origin less gravity, in the axes of the link.
type Link = [Vector; 3];

#[inline(always)]
fn link<const K: usize>([omega, alpha, origin]: Link, turn: [f64; 2], rate: f64, acceleration: f64) -> Link {
    let arm = [A[K - 1], 0.0, D[K - 1]];
    let place = origin + across(alpha, arm) + omega.cross(&across(omega, arm));
    let mut before = inward::<K>(omega, turn);
    let mut after = inward::<K>(alpha, turn);
    after.x += before.y * rate;
    after.y -= before.x * rate;
    after.z += acceleration;
    before.z += rate;
    [before, after, inward::<K>(place, turn)]
}

/// Force and torque about the origin that a link takes.
#[inline(always)]
fn taken<const K: usize>([omega, alpha, origin]: Link) -> [Vector; 2] {
    let (c, i) = (CENTERS[K], INERTIAS[K]);
    let force = (origin + across(alpha, c) + omega.cross(&across(omega, c))) * MASSES[K];
    let spin = Vector::new(i[0] * omega.x, i[1] * omega.y, i[2] * omega.z);
    let torque = Vector::new(i[0] * alpha.x, i[1] * alpha.y, i[2] * alpha.z) + omega.cross(&spin);
    [force, torque - across(force, c)]
}

/// Of a link and all after it.
#[inline(always)]
fn sum<const K: usize>(own: [Vector; 2], next: [Vector; 2], turn: [f64; 2]) -> [Vector; 2] {
    let (force, torque) = (outward::<K>(next[0], turn), outward::<K>(next[1], turn));
    [own[0] + force, own[1] + torque - across(force, [A[K - 1], 0.0, D[K - 1]])]
}

/// Newton and Euler's equations outwards and back again.
#[inline(always)]
fn torques(turns: &[[f64; 2]; 6], rate: &[f64; 6], acceleration: &[f64; 6]) -> [f64; 6] {
    let base = [Vector::new(0.0, 0.0, rate[0]), Vector::new(0.0, 0.0, acceleration[0]), Vector::new(0.0, 0.0, GRAVITY)];
    let one = link::<1>(base, turns[1], rate[1], acceleration[1]);
    let two = link::<2>(one, turns[2], rate[2], acceleration[2]);
    let three = link::<3>(two, turns[3], rate[3], acceleration[3]);
    let four = link::<4>(three, turns[4], rate[4], acceleration[4]);
    let five = link::<5>(four, turns[5], rate[5], acceleration[5]);
    let f = taken::<5>(five);
    let e = sum::<5>(taken::<4>(four), f, turns[5]);
    let d = sum::<4>(taken::<3>(three), e, turns[4]);
    let c = sum::<3>(taken::<2>(two), d, turns[3]);
    let b = sum::<2>(taken::<1>(one), c, turns[2]);
    // The first link turns about a vertical axis.
    let moment = INERTIAS[0][2] + MASSES[0] * (CENTERS[0][0] * CENTERS[0][0] + CENTERS[0][1] * CENTERS[0][1]);
    let a = outward::<1>(b[1], turns[1]).z + moment * acceleration[0];
    [a, b[1].z, c[1].z, d[1].z, e[1].z, f[1].z]
}

#[inline(always)]
fn turns(angle: &[f64; 6]) -> [[f64; 2]; 6] {
    f64::fast_sin_cos_of_each(*angle).map(|(sine, cosine)| [sine, cosine])
}

/// Mass, first moment and the moments of inertia about the origin (xx, yy, zz, xy, xz, yz) of a link with all after it.
#[derive(Clone, Copy)]
struct Composite {
    mass: f64,
    first: Vector,
    second: [f64; 6],
}

impl Composite {
    #[inline(always)]
    fn of<const K: usize>() -> Self {
        let ([x, y, z], [a, b, c], m) = (CENTERS[K], INERTIAS[K], MASSES[K]);
        let second = [a + m * (y * y + z * z), b + m * (x * x + z * z), c + m * (x * x + y * y), -m * x * y, -m * x * z, -m * y * z];
        Self { mass: m, first: Vector::new(m * x, m * y, m * z), second }
    }

    /// With the link K after it.
    #[inline(always)]
    fn with<const K: usize>(&self, next: &Self, [s, c]: [f64; 2]) -> Self {
        let [xx, yy, zz, xy, xz, yz] = next.second;
        let (cc, ss, sc) = (c * c, s * s, s * c);
        let turned = [
            cc * xx + ss * yy - 2.0 * sc * xy,
            ss * xx + cc * yy + 2.0 * sc * xy,
            zz,
            sc * (xx - yy) + (cc - ss) * xy,
            c * xz - s * yz,
            s * xz + c * yz,
        ];
        let [xx, yy, zz, xy, xz, yz] = match TWIST[K - 1] {
            1 => [turned[0], turned[2], turned[1], -turned[4], turned[3], -turned[5]],
            -1 => [turned[0], turned[2], turned[1], turned[4], -turned[3], -turned[5]],
            _ => turned,
        };
        let h = outward::<K>(next.first, [s, c]);
        let (a, d, m) = (A[K - 1], D[K - 1], next.mass);
        // Shifted by p = (a, 0, d): J + m (p·p E − p pᵀ) + 2 h·p E − h pᵀ − p hᵀ.
        let shifted = [
            xx + m * d * d + 2.0 * h.z * d,
            yy + m * (a * a + d * d) + 2.0 * (h.x * a + h.z * d),
            zz + m * a * a + 2.0 * h.x * a,
            xy - h.y * a,
            xz - m * a * d - h.x * d - h.z * a,
            yz - h.y * d,
        ];
        Self {
            mass: self.mass + m,
            first: self.first + h + Vector::new(m * a, 0.0, m * d),
            second: std::array::from_fn(|k| self.second[k] + shifted[k]),
        }
    }

    /// Momentum and its moment at unit speed of the hinge.
    #[inline(always)]
    fn momentum(&self) -> [Vector; 2] {
        [Vector::new(-self.first.y, self.first.x, 0.0), Vector::new(self.second[4], self.second[5], self.second[2])]
    }
}

/// A momentum in the link before.
#[inline(always)]
fn before<const K: usize>([force, torque]: [Vector; 2], turn: [f64; 2]) -> [Vector; 2] {
    sum::<K>([Vector::zeros(), Vector::zeros()], [force, torque], turn)
}

/// The lower triangle of the mass matrix, link by link.
#[inline(always)]
fn masses(turns: &[[f64; 2]; 6]) -> [[f64; 6]; 6] {
    let six = Composite::of::<5>();
    let five = Composite::of::<4>().with::<5>(&six, turns[5]);
    let four = Composite::of::<3>().with::<4>(&five, turns[4]);
    let three = Composite::of::<2>().with::<3>(&four, turns[3]);
    let two = Composite::of::<1>().with::<2>(&three, turns[2]);
    let one = Composite::of::<0>().with::<1>(&two, turns[1]);
    let mut h = [[0.0; 6]; 6];
    let mut m = six.momentum();
    h[5][5] = m[1].z;
    m = before::<5>(m, turns[5]);
    h[5][4] = m[1].z;
    let column = |h: &mut [[f64; 6]; 6], mut m: [Vector; 2], row: usize, from: usize| {
        if from >= 4 {
            m = before::<4>(m, turns[4]);
            h[row][3] = m[1].z;
        }
        if from >= 3 {
            m = before::<3>(m, turns[3]);
            h[row][2] = m[1].z;
        }
        if from >= 2 {
            m = before::<2>(m, turns[2]);
            h[row][1] = m[1].z;
        }
        m = before::<1>(m, turns[1]);
        h[row][0] = m[1].z;
    };
    column(&mut h, m, 5, 4);
    for (row, own) in [(4, five), (3, four), (2, three), (1, two)] {
        let m = own.momentum();
        h[row][row] = m[1].z;
        column(&mut h, m, row, row);
    }
    h[0][0] = one.second[2];
    h
}

/// Torques at rest of the accelerations, the mass matrix, and L D Lᵀ.
#[inline(always)]
fn released(angle: &[f64; 6], rate: &[f64; 6]) -> [f64; 6] {
    let turns = turns(angle);
    let mut right = torques(&turns, rate, &[0.0; 6]).map(|torque| -torque);
    let mut h = masses(&turns);
    let mut inverse = [0.0; 6];
    for k in 0..6 {
        inverse[k] = 1.0 / h[k][k];
        let column = h.map(|row| row[k]);
        for i in k + 1..6 {
            let factor = column[i] * inverse[k];
            for (entry, other) in h[i][k + 1..=i].iter_mut().zip(&column[k + 1..=i]) {
                *entry -= factor * other;
            }
            right[i] -= factor * right[k];
        }
    }
    for k in (0..6).rev() {
        for i in k + 1..6 {
            right[k] -= h[i][k] * right[i];
        }
        right[k] *= inverse[k];
    }
    right
}

fn released_model() -> Model {
    let mut model = arm::model("arm");
    model.drives.clear();
    model.gravity = [0.0, 0.0, -GRAVITY];
    model
}

pub(crate) fn cases() -> [Case; 2] {
    [inverse(), forward()]
}

fn inverse() -> Case {
    let mechanism = Driven::default();
    let exact = |k: usize| {
        let [angle, rate, acceleration] = motion(k);
        let driven: Vec<(usize, f64)> = acceleration.into_iter().enumerate().collect();
        reaction(&released_model(), &angle, &rate, &driven).efforts
    };
    let states = (0..STATES).map(|k| mechanism.solve(k as f64 / STATES as f64).unwrap_or_else(|failure| panic!("{failure}")));
    Case {
        name: "D4 arm, torques".to_owned(),
        exact: exact_in(8, exact),
        given: Some(Given { model: released_model(), states: (0..STATES).map(|k| motion(k).map(Vec::from).to_vec()).collect() }),
        entries: vec![
            Entry::new(
                HAND_LOADS,
                (0..STATES).map(motion).collect(),
                |[angle, rate, acceleration]| torques(&turns(angle), rate, acceleration),
                |_, torques| torques.to_vec(),
            ),
            Entry::new(
                LOADS,
                states.collect(),
                move |state: &mut DrivenState<f64>| mechanism.loads(state),
                |_, loads| {
                    [loads.of_a(), loads.of_b(), loads.of_c(), loads.of_d(), loads.of_e(), loads.of_f()].map(|drive| drive.effort).to_vec()
                },
            ),
        ],
    }
}

fn forward() -> Case {
    let exact = |k: usize| {
        let [angle, rate, _] = motion(k);
        reaction(&released_model(), &angle, &rate, &[]).accelerations
    };
    let state = |k: usize| {
        let [q, u, _] = motion(k);
        let mechanism = Free {
            start_a: q[0],
            start_b: q[1],
            start_c: q[2],
            start_d: q[3],
            start_e: q[4],
            start_f: q[5],
            speed_a: u[0],
            speed_b: u[1],
            speed_c: u[2],
            speed_d: u[3],
            speed_e: u[4],
            speed_f: u[5],
        };
        (mechanism, mechanism.initial_state().unwrap_or_else(|stopped| panic!("{stopped}")))
    };
    Case {
        name: "D4 arm, accelerations".to_owned(),
        exact: exact_in(8, exact),
        given: Some(Given {
            model: released_model(),
            states: (0..STATES).map(|k| motion(k)[..2].iter().map(|of| of.to_vec()).collect()).collect(),
        }),
        entries: vec![
            Entry::new(
                HAND_ACCELERATIONS,
                (0..STATES).map(motion).collect(),
                |[angle, rate, _]| released(angle, rate),
                |_, found| found.to_vec(),
            ),
            Entry::new(
                ACCELERATIONS,
                (0..STATES).map(state).collect(),
                |(mechanism, state): &mut (Free, FreeState<f64>)| mechanism.accelerations(&state.q, &state.qd, state.t),
                |_, found| found.iter().flatten().copied().collect(),
            ),
        ],
    }
}
