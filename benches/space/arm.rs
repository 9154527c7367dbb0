//! S3: an arm of six hinges with the dimensions of the UR5, all driven.

use std::f64::consts::TAU;

use reuleaux::nalgebra::Vector3;
use reuleaux::{SpatialBody, mechanism};
use reuleaux_benches::multibody::arm::{self, A, CENTERS, D, DRIVES};

use crate::Workload;
use crate::follower::{Entry, HAND, HAND_FAST, Hand, Point, Runtime, Standard, Trigonometry, Turning, declared};

mechanism! {
    /// An arm whose joints swing; frames lie in the mass centres.
    pub mechanism Arm in space {
        ground { axis z = (0, 0, 1) from (1, 0, 0); }
        body upper_base {
            axis z = (0, 0, 1) from (1, 0, 0);  point O = (0m, 0.02561m, -0.00193m);
            axis next = (0, -1, 0) from (1, 0, 0);  point P = (0m, 0.02561m, 0.087229m);
        }
        body shoulder {
            axis z = (0, 0, 1) from (1, 0, 0);  point O = (-0.2125m, 0m, -0.11336m);
            axis next = (0, 0, 1) from (1, 0, 0);  point P = (-0.6375m, 0m, -0.11336m);
        }
        body elbow {
            axis z = (0, 0, 1) from (1, 0, 0);  point O = (-0.11993m, 0m, -0.0265m);
            axis next = (0, 0, 1) from (1, 0, 0);  point P = (-0.51218m, 0m, -0.0265m);
        }
        body wrist_a {
            axis z = (0, 0, 1) from (1, 0, 0);  point O = (0m, 0.0018m, -0.01634m);
            axis next = (0, -1, 0) from (1, 0, 0);  point P = (0m, 0.0018m, 0.09281m);
        }
        body wrist_b {
            axis z = (0, 0, 1) from (1, 0, 0);  point O = (0m, -0.0018m, -0.01634m);
            axis next = (0, 1, 0) from (1, 0, 0);  point P = (0m, -0.0018m, 0.07831m);
        }
        body wrist_c { axis z = (0, 0, 1) from (1, 0, 0);  point O = (0m, 0m, 0.001159m); }

        joint a = revolute(ground.position, ground.z, upper_base.O, upper_base.z);
        joint b = revolute(upper_base.P, upper_base.next, shoulder.O, shoulder.z);
        joint c = revolute(shoulder.P, shoulder.next, elbow.O, elbow.z);
        joint d = revolute(elbow.P, elbow.next, wrist_a.O, wrist_a.z);
        joint e = revolute(wrist_a.P, wrist_a.next, wrist_b.O, wrist_b.z);
        joint f = revolute(wrist_b.P, wrist_b.next, wrist_c.O, wrist_c.z);
        drive of_a = drive_rotation(a, 0.3rad + 0.8rad * sin(1turn * t / 1s));
        drive of_b = drive_rotation(b, -1.2rad + 0.5rad * sin(1turn * t / 1s + 0.4rad));
        drive of_c = drive_rotation(c, 1.1rad + 0.6rad * sin(2turn * t / 1s + 1rad));
        drive of_d = drive_rotation(d, -0.7rad + 0.7rad * sin(1turn * t / 1s + 1.5rad));
        drive of_e = drive_rotation(e, 0.9rad + 0.9rad * sin(2turn * t / 1s + 2.2rad));
        drive of_f = drive_rotation(f, 0.2rad + 1.1rad * sin(1turn * t / 1s + 0.9rad));
    }
}

pub(crate) fn workload() -> Workload {
    Workload { model: arm::model("S3 arm"), contenders }
}

fn contenders() -> Vec<Entry> {
    vec![
        Entry::new(HAND_FAST, Hand::new((), |(), t| swung::<Runtime>(t))),
        Entry::new(HAND, Hand::new((), |(), t| swung::<Standard>(t))),
        declared!(Arm, ArmState, |state| {
            vec![state.upper_base(), state.shoulder(), state.elbow(), state.wrist_a(), state.wrist_b(), state.wrist_c()]
        }),
    ]
}

/// A link's frame and the origin of its hinge.
type Link = (Turning, Point);

/// A point in the frame that turns with the base, (h, n, z): h and z span the plane in which the three parallel hinges move the links, at
/// n from the base's axis.
#[derive(Clone, Copy)]
struct Planar {
    /// Along h and z, with rates and accelerations.
    place: [[f64; 2]; 3],
    offset: f64,
}

impl Planar {
    /// The point at this distance along the direction of this angle, and at this one along n.
    #[inline(always)]
    fn beside(&self, length: f64, turned: &Turned, offset: f64) -> Self {
        let (c, s) = (length * turned.cosine, length * turned.sine);
        let square = turned.rate * turned.rate;
        let [p, v, a] = self.place;
        Self {
            place: [
                [p[0] + c, p[1] + s],
                [v[0] - s * turned.rate, v[1] + c * turned.rate],
                [a[0] - s * turned.acceleration - c * square, a[1] + c * turned.acceleration - s * square],
            ],
            offset: self.offset + offset,
        }
    }

    /// In ground.
    #[inline(always)]
    fn point(&self, base: &Turned) -> Point {
        let ([[r, z], [r1, z1], [r2, z2]], n) = (self.place, self.offset);
        let (w, dw, square) = (base.rate, base.acceleration, base.rate * base.rate);
        let ground = |h: f64, n: f64, z: f64| Vector3::new(h * base.cosine + n * base.sine, h * base.sine - n * base.cosine, z);
        Point {
            p: ground(r, n, z),
            v: ground(r1 + w * n, -w * r, z1),
            a: ground(r2 + dw * n - square * r, -dw * r - 2.0 * w * r1 - square * n, z2),
        }
    }
}

/// An angle with its sine, cosine, rate and acceleration.
#[derive(Clone, Copy)]
struct Turned {
    sine: f64,
    cosine: f64,
    rate: f64,
    acceleration: f64,
}

impl Turned {
    #[inline(always)]
    fn plus(&self, other: &Self) -> Self {
        Self {
            sine: self.sine * other.cosine + self.cosine * other.sine,
            cosine: self.cosine * other.cosine - self.sine * other.sine,
            rate: self.rate + other.rate,
            acceleration: self.acceleration + other.acceleration,
        }
    }

    /// The frame of a link that the parallel hinges have turned by this angle.
    #[inline(always)]
    fn frame(&self, base: &Self) -> Turning {
        let (h, n) = (Vector3::new(base.cosine, base.sine, 0.0), Vector3::new(base.sine, -base.cosine, 0.0));
        let gyro = base.rate * self.rate;
        Turning {
            axes: [
                Vector3::new(self.cosine * base.cosine, self.cosine * base.sine, self.sine),
                Vector3::new(-self.sine * base.cosine, -self.sine * base.sine, self.cosine),
                n,
            ],
            omega: Vector3::new(n.x * self.rate, n.y * self.rate, base.rate),
            alpha: Vector3::new(n.x * self.acceleration + h.x * gyro, n.y * self.acceleration + h.y * gyro, base.acceleration),
        }
    }
}

/// The base, three parallel hinges in the plane that turns with it, and two hinges of the wrist.
#[inline(always)]
fn swung<T: Trigonometry>(t: f64) -> [SpatialBody<f64>; 6] {
    let phases = T::of_each::<6>(std::array::from_fn(|k| TAU * DRIVES[k][2] * t + DRIVES[k][3]));
    let angles = T::of_each::<6>(std::array::from_fn(|k| DRIVES[k][0] + DRIVES[k][1] * phases[k].0));
    let turned = |k: usize| {
        let (omega, amplitude, (sine, cosine)) = (TAU * DRIVES[k][2], DRIVES[k][1], phases[k]);
        let (rate, acceleration) = (amplitude * omega * cosine, -amplitude * omega * omega * sine);
        Turned { sine: angles[k].0, cosine: angles[k].1, rate, acceleration }
    };
    let base = turned(0);
    let first = Turning {
        axes: [Vector3::new(base.cosine, base.sine, 0.0), Vector3::new(-base.sine, base.cosine, 0.0), Vector3::z()],
        omega: Vector3::new(0.0, 0.0, base.rate),
        alpha: Vector3::new(0.0, 0.0, base.acceleration),
    };
    let at = |height: f64| Planar { place: [[0.0, height], [0.0; 2], [0.0; 2]], offset: 0.0 };
    let first_center = Planar { offset: -CENTERS[0][1], ..at(CENTERS[0][2]) };
    let second = turned(1);
    let third = second.plus(&turned(2));
    let fourth = third.plus(&turned(3));
    let elbow = at(D[0]).beside(A[1], &second, 0.0);
    let wrist = elbow.beside(A[2], &third, 0.0);
    let centers = [
        first_center,
        at(D[0]).beside(CENTERS[1][0], &second, CENTERS[1][2]),
        elbow.beside(CENTERS[2][0], &third, CENTERS[2][2]),
        // Across the link, a quarter of a turn ahead.
        wrist.beside(CENTERS[3][1], &Turned { sine: fourth.cosine, cosine: -fourth.sine, ..fourth }, CENTERS[3][2]),
    ];
    let [a, b, c, d] = centers.map(|center| center.point(&base));
    let frame = fourth.frame(&base);
    let fifth = hinged(&(frame, Planar { offset: wrist.offset + D[3], ..wrist }.point(&base)), true, &turned(4));
    let place = fifth.1.beside(&fifth.0, fifth.0.axes[2] * D[4]);
    let sixth = hinged(&(fifth.0, place), false, &turned(5));
    let of_fifth = fifth.0.axes[1] * CENTERS[4][1] + fifth.0.axes[2] * CENTERS[4][2];
    [
        first.body(&a),
        second.frame(&base).body(&b),
        third.frame(&base).body(&c),
        frame.body(&d),
        fifth.0.body(&fifth.1.beside(&fifth.0, of_fifth)),
        sixth.0.body(&sixth.1.beside(&sixth.0, sixth.0.axes[2] * CENTERS[5][2])),
    ]
}

/// The next link about its z axis, after a quarter of a turn about x.
#[inline(always)]
fn hinged((before, place): &Link, is_left: bool, by: &Turned) -> Link {
    let [x, y, z] = before.axes;
    let (y, z) = if is_left { (z, -y) } else { (-z, y) };
    let spin = z * by.rate;
    let alpha = before.alpha + z * by.acceleration + before.omega.cross(&spin);
    (Turning { axes: [x * by.cosine + y * by.sine, y * by.cosine - x * by.sine, z], omega: before.omega + spin, alpha }, *place)
}
