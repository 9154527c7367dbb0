//! S1: Haug's slider-crank across its plane; a crank about x, a rod with a ball at the pin and a cross at the slider.

use std::f64::consts::TAU;

use reuleaux::nalgebra::Vector3;
use reuleaux::{SpatialBody, mechanism};
use reuleaux_benches::multibody::{Cut, Joint, Law, Model};

use crate::Workload;
use crate::follower::{Entry, HAND, HAND_FAST, Hand, Point, Runtime, Standard, Trigonometry, Turning, declared};

mechanism! {
    /// A crank that turns across the way of its slider; frames lie in the mass centres.
    pub mechanism SliderCrank in space {
        ground {
            point axle = (0m, 0.1m, 0.12m);
            axis x = (1, 0, 0) from (0, 0, 1);
        }
        body crank  { axis x = (1, 0, 0) from (0, 0, 1);  point O = (0m, 0m, -0.04m);  point A = (0m, 0m, 0.04m); }
        body slider { axis x = (1, 0, 0) from (0, 0, 1);  start position = (0.2m, 0m, 0m); }
        body rod {
            axis y = (0, 1, 0);  point A = (-0.15m, 0m, 0m);  point B = (0.15m, 0m, 0m);
            start orientation = turn((1, 0, 0), -26deg) * turn((0, 1, 0), 48deg);
        }

        joint axle = revolute(ground.axle, ground.x, crank.O, crank.x);
        joint ball = spherical(crank.A, rod.A);
        joint cross_pin = universal(slider.position, slider.x, rod.B, rod.y);
        joint rail = translational(ground.position, ground.x, slider.position, slider.x);
        drive motor = drive_rotation(axle, 1turn * t / 1s);
    }
}

const ARM: f64 = 0.08;
const ROD: f64 = 0.3;
const AXLE: [f64; 2] = [0.1, 0.12];

pub(crate) fn workload() -> Workload {
    let mut model = Model::new("S1 slider-crank");
    let crank = model.hang("crank", None, &[Joint::Turn(0)], &[0.0]);
    (crank.place, crank.center) = ([0.0, AXLE[0], AXLE[1]], [0.0, 0.0, 0.5 * ARM]);
    (crank.mass, crank.inertia) = (0.12, [1e-4; 3]);
    let slider = model.hang("slider", None, &[Joint::Shift(0)], &[0.2]);
    (slider.mass, slider.inertia) = (2.0, [1e-3; 3]);
    let rod = model.hang("rod", Some(1), &[Joint::Turn(0), Joint::Turn(1)], &[-0.4636, 0.84]);
    (rod.center, rod.mass, rod.inertia) = ([-0.5 * ROD, 0.0, 0.0], 0.5, [4e-4, 4e-3, 4e-3]);
    model.cuts.push(Cut::Meet((Some(0), [0.0, 0.0, ARM]), (Some(2), [-ROD, 0.0, 0.0])));
    model.drives.push((0, Law::Turning));
    model.close();
    Workload { model, contenders }
}

fn contenders() -> Vec<Entry> {
    vec![
        Entry::new(HAND_FAST, Hand::new((), |(), t| closed::<Runtime>(t))),
        Entry::new(HAND, Hand::new((), |(), t| closed::<Standard>(t))),
        declared!(SliderCrank, SliderCrankState, |state| vec![state.crank(), state.slider(), state.rod()]),
    ]
}

/// The slider is where the distance from the pin is the rod's length; the rod's axis u leads from pin to slider, and its y axis is at
/// right angles to x and u.
#[inline(always)]
fn closed<T: Trigonometry>(t: f64) -> [SpatialBody<f64>; 3] {
    let (sine, cosine) = T::of(TAU * t);
    let square = TAU * TAU;
    let crank = Turning {
        axes: [Vector3::x(), Vector3::new(0.0, cosine, sine), Vector3::new(0.0, -sine, cosine)],
        omega: Vector3::new(TAU, 0.0, 0.0),
        alpha: Vector3::zeros(),
    };
    let (y, z) = (-ARM * sine, ARM * cosine);
    let half = Point {
        p: Vector3::new(0.0, AXLE[0] + 0.5 * y, AXLE[1] + 0.5 * z),
        v: Vector3::new(0.0, -0.5 * TAU * z, 0.5 * TAU * y),
        a: Vector3::new(0.0, -0.5 * square * y, -0.5 * square * z),
    };
    // The pin A, and x² = l² − A·A.
    let ([ay, az], [vy, vz], [wy, wz]) = ([AXLE[0] + y, AXLE[1] + z], [-TAU * z, TAU * y], [-square * y, -square * z]);
    let across = ay * ay + az * az;
    let x = (ROD * ROD - across).sqrt();
    let vx = -(ay * vy + az * vz) / x;
    let wx = -(vx * vx + vy * vy + vz * vz + ay * wy + az * wz) / x;
    // u = (x, −A)/l = (cos b, sin b sin a, −sin b cos a), n = sin b.
    let n = across.sqrt() * (1.0 / ROD);
    let (ux, per) = (x * (1.0 / ROD), 1.0 / (ROD * n));
    let (sa, ca) = (-ay * per, az * per);
    let a_rate = -(vy * ca + vz * sa) * per;
    let b_rate = -vx * per;
    let across_rate = -(vy * sa - vz * ca) * (1.0 / ROD);
    let a_acceleration = -(wy * ca + wz * sa) * per - 2.0 * a_rate * across_rate / n;
    let b_acceleration = -wx * per - ux * b_rate * b_rate / n;
    let rod = Turning {
        axes: [Vector3::new(ux, n * sa, -n * ca), Vector3::new(0.0, ca, sa), Vector3::new(n, -ux * sa, ux * ca)],
        omega: Vector3::new(a_rate, b_rate * ca, b_rate * sa),
        alpha: Vector3::new(a_acceleration, b_acceleration * ca - b_rate * a_rate * sa, b_acceleration * sa + b_rate * a_rate * ca),
    };
    let middle = Point {
        p: Vector3::new(0.5 * x, 0.5 * ay, 0.5 * az),
        v: Vector3::new(0.5 * vx, 0.5 * vy, 0.5 * vz),
        a: Vector3::new(0.5 * wx, 0.5 * wy, 0.5 * wz),
    };
    let slide = Point { p: Vector3::new(x, 0.0, 0.0), v: Vector3::new(vx, 0.0, 0.0), a: Vector3::new(wx, 0.0, 0.0) };
    let still = Turning { axes: [Vector3::x(), Vector3::y(), Vector3::z()], omega: Vector3::zeros(), alpha: Vector3::zeros() };
    [crank.body(&half), still.body(&slide), rod.body(&middle)]
}
