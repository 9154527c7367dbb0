//! S1b: a loop of a crank about z, a coupler with a ball at the crank and a cross at the rocker, and a rocker about an axis askew.

use std::f64::consts::TAU;

use reuleaux::nalgebra::Vector3;
use reuleaux::{SpatialBody, mechanism};
use reuleaux_benches::multibody::{Cut, Joint, Law, Model, product, turn};

use crate::Workload;
use crate::follower::{Entry, HAND, HAND_FAST, Hand, Point, Runtime, Standard, Trigonometry, Turning, declared};

mechanism! {
    /// A crank-rocker in space; frames lie in the mass centres.
    pub mechanism CrankRocker in space {
        ground {
            axis z = (0, 0, 1) from (1, 0, 0);
            point O = (2.2m, 0.3m, 0.5m);
            axis skew = (sin(0.3), -sin(0.5) * cos(0.3), cos(0.5) * cos(0.3)) from (cos(0.3), sin(0.5) * sin(0.3), -cos(0.5) * sin(0.3));
        }
        body crank   { axis z = (0, 0, 1) from (1, 0, 0);  point O = (-0.25m, 0m, 0m);  point A = (0.25m, 0m, 0m); }
        body rocker {
            axis z = (0, 0, 1) from (1, 0, 0);  axis y = (0, 1, 0);
            point O = (-0.5m, 0m, 0m);  point B = (0.9m, 0m, 0m);
            start orientation = turn((1, 0, 0), 0.5rad) * turn((0, 1, 0), 0.3rad) * turn((0, 0, 1), -1.33rad);
        }
        body coupler {
            axis z = (0, 0, 1);  point A = (-1.1m, 0m, 0m);  point B = (1.1m, 0m, 0m);
            start orientation = turn((1, 0, 0), 0.5rad) * turn((0, 1, 0), 0.3rad) * turn((0, 0, 1), -1.33rad) * turn((0, 1, 0), -0.55rad) * turn((0, 0, 1), 0.82rad);
        }

        joint axle = revolute(ground.position, ground.z, crank.O, crank.z);
        joint pivot = revolute(ground.O, ground.skew, rocker.O, rocker.z);
        joint ball = spherical(crank.A, coupler.A);
        joint cross_pin = universal(rocker.B, rocker.y, coupler.B, coupler.z);
        drive motor = drive_rotation(axle, 1turn * t / 1s);
    }
}

pub(crate) fn workload() -> Workload {
    let mut model = Model::new("S1b crank-rocker");
    let crank = model.hang("crank", None, &[Joint::Turn(2)], &[0.0]);
    crank.center = [0.25, 0.0, 0.0];
    let rocker = model.hang("rocker", None, &[Joint::Turn(2)], &[-1.33]);
    (rocker.place, rocker.turned, rocker.center) = ([2.2, 0.3, 0.5], product(turn(0, 0.5), turn(1, 0.3)), [0.5, 0.0, 0.0]);
    let coupler = model.hang("coupler", Some(1), &[Joint::Turn(1), Joint::Turn(2)], &[-0.55, 0.82]);
    (coupler.place, coupler.center) = ([1.4, 0.0, 0.0], [-1.1, 0.0, 0.0]);
    model.cuts.push(Cut::Meet((Some(0), [0.5, 0.0, 0.0]), (Some(2), [-2.2, 0.0, 0.0])));
    model.drives.push((0, Law::Turning));
    model.close();
    Workload { model, contenders }
}

fn contenders() -> Vec<Entry> {
    let [fast, plain] = [(); 2].map(|()| Axle::new([2.2, 0.3, 0.5], product(turn(0, 0.5), turn(1, 0.3))));
    vec![
        Entry::new(HAND_FAST, Hand::new((), move |(), t| closed::<Runtime>(&fast, t))),
        Entry::new(HAND, Hand::new((), move |(), t| closed::<Standard>(&plain, t))),
        declared!(CrankRocker, CrankRockerState, |state| vec![state.crank(), state.rocker(), state.coupler()]),
    ]
}

/// An axle: its place and frame.
pub(crate) struct Axle {
    pub(crate) place: Vector3<f64>,
    pub(crate) axes: [Vector3<f64>; 3],
}

impl Axle {
    /// With this place and the rows of its matrix.
    pub(crate) fn new(place: [f64; 3], rows: [[f64; 3]; 3]) -> Self {
        Self { place: place.into(), axes: [0, 1, 2].map(|j| Vector3::new(rows[0][j], rows[1][j], rows[2][j])) }
    }

    /// The point at the end of an arm that turns about the axle: its direction, the same a quarter of a turn ahead, and its length.
    #[inline(always)]
    pub(crate) fn end(&self, [out, ahead]: [Vector3<f64>; 2], length: f64, [rate, turning]: [f64; 2]) -> Point {
        let (out, ahead) = (out * length, ahead * length);
        Point { p: self.place + out, v: ahead * rate, a: ahead * turning - out * (rate * rate) }
    }
}

const ROCKER: f64 = 1.4;
const COUPLER: f64 = 2.2;

#[inline(always)]
fn closed<T: Trigonometry>(of: &Axle, t: f64) -> [SpatialBody<f64>; 3] {
    let (sine, cosine) = T::of(TAU * t);
    let square = TAU * TAU;
    let crank = Turning {
        axes: [Vector3::new(cosine, sine, 0.0), Vector3::new(-sine, cosine, 0.0), Vector3::z()],
        omega: Vector3::new(0.0, 0.0, TAU),
        alpha: Vector3::zeros(),
    };
    let at = |length: f64| {
        let (x, y) = (length * cosine, length * sine);
        Point { p: Vector3::new(x, y, 0.0), v: Vector3::new(-TAU * y, TAU * x, 0.0), a: Vector3::new(-square * x, -square * y, 0.0) }
    };
    let pin = at(0.5);
    let (rocker, speeds) = rocked(of, &pin, ROCKER, COUPLER);
    let along = |length: f64| of.end([rocker.axes[0], rocker.axes[1]], length, speeds);
    let (coupler, center) = coupled(&rocker, &pin, &along(ROCKER), COUPLER, 1.0);
    [crank.body(&at(0.25)), rocker.body(&along(0.5)), coupler.body(&center)]
}

/// Where the end of an arm is at the coupler's length from the pin: p cos ψ + q sin ψ = k; with its rate and acceleration.
#[inline(always)]
pub(crate) fn rocked(of: &Axle, pin: &Point, arm: f64, coupler: f64) -> (Turning, [f64; 2]) {
    let d = pin.p - of.place;
    let [p, q] = [d.dot(&of.axes[0]), d.dot(&of.axes[1])];
    let k = (d.norm_squared() + (arm * arm - coupler * coupler)) * (0.5 / arm);
    let size = p * p + q * q;
    let root = (size - k * k).sqrt();
    let both = 1.0 / (size * root);
    let (per, lever) = (root * both, size * both * (1.0 / arm));
    let (cosine, sine) = ((p * k - q * root) * per, (q * k + p * root) * per);
    let x = of.axes[0] * cosine + of.axes[1] * sine;
    let y = of.axes[1] * cosine - of.axes[0] * sine;
    // b·(ẏ − Ȧ) = 0 for the coupler b, and its derivative; b·x = arm − k and b·y = root.
    let b = x * arm - d;
    let rate = b.dot(&pin.v) * lever;
    let b_rate = y * (arm * rate) - pin.v;
    let turning = (b.dot(&pin.a) - b_rate.norm_squared() + (arm - k) * (arm * rate * rate)) * lever;
    (Turning { axes: [x, y, of.axes[2]], omega: of.axes[2] * rate, alpha: of.axes[2] * turning }, [rate, turning])
}

/// A coupler and its mass centre: its axis leads from the pin to the rocker, its z axis is across that and the rocker's y axis, on the side
/// of their product or on the other.
#[inline(always)]
pub(crate) fn coupled(rocker: &Turning, pin: &Point, end: &Point, length: f64, side: f64) -> (Turning, Point) {
    let per = 1.0 / length;
    let (x, x1, x2) = ((end.p - pin.p) * per, (end.v - pin.v) * per, (end.a - pin.a) * per);
    let y_rocker = rocker.axes[1];
    let z = x.cross(&y_rocker);
    let share = side / z.norm_squared().sqrt();
    let z = z * share;
    let y = z.cross(&x);
    // The angular velocity against the rocker has no part along e, at right angles to both axes of the cross; x·e is one over the share.
    let e = y_rocker.cross(&z);
    let across = x.cross(&x1);
    let spin = (rocker.omega - across).dot(&e) * share;
    let omega = across + x * spin;
    let against = omega - rocker.omega;
    let of_rate = against.dot(&y_rocker) * rocker.omega.dot(&z) - against.dot(&z) * omega.dot(&y_rocker);
    let turning = x.cross(&x2) + x1 * spin;
    let spin_rate = ((rocker.alpha - turning).dot(&e) - of_rate) * share;
    let center = Point { p: (end.p + pin.p) * 0.5, v: (end.v + pin.v) * 0.5, a: (end.a + pin.a) * 0.5 };
    (Turning { axes: [x, y, z], omega, alpha: turning + x * spin_rate }, center)
}
