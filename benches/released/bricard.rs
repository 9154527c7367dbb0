//! D5: Bricard's linkage, six hinges at right angles in a loop, falls under its weight.

use reuleaux::nalgebra::{SMatrix, SVector, Vector1, Vector3};
use reuleaux::{Balance, Constraints, Coordinate, Description, Dynamics, Energy, ParameterOutOfRange, Row, State, mechanism};
use serde_json::{Value, json};

use crate::multibody::{Cut, Joint, Model};

mechanism! {
    /// Five rods of 1 m and 1 kg; bodies are turned as ground is where the rods lie along the edges of a cube.
    pub mechanism Bricard in space {
        /// Angle of the first hinge at the beginning.
        param start: Angle = 0rad;
        /// Its rate.
        param speed: AngularVelocity = 0rad_s;
        gravity = (0m_s2, -9.81m_s2, 0m_s2);
        ground { axis x = (1, 0, 0);  axis y = (0, 1, 0);  point end = (0m, 0m, 1m); }
        body first {
            axis y = (0, 1, 0);  point end = (1m, 0m, 0m);  axis z = (0, 0, 1);
            mass = 1kg;  center = (0.5m, 0m, 0m);  inertia = block(1m, 0.1m, 0.1m);
        }
        body second {
            axis z = (0, 0, 1);  point end = (0m, -1m, 0m);  axis x = (1, 0, 0);
            mass = 1kg;  center = (0m, -0.5m, 0m);  inertia = block(0.1m, 1m, 0.1m);  start position = (1m, 0m, 0m);
        }
        body third {
            axis x = (1, 0, 0);  point end = (0m, 0m, 1m);  axis y = (0, 1, 0);
            mass = 1kg;  center = (0m, 0m, 0.5m);  inertia = block(0.1m, 0.1m, 1m);  start position = (1m, -1m, 0m);
        }
        body fourth {
            axis y = (0, 1, 0);  point end = (-1m, 0m, 0m);  axis z = (0, 0, 1);
            mass = 1kg;  center = (-0.5m, 0m, 0m);  inertia = block(1m, 0.1m, 0.1m);  start position = (1m, -1m, 1m);
        }
        body fifth {
            axis z = (0, 0, 1);  point end = (0m, 1m, 0m);  axis x = (1, 0, 0);
            mass = 1kg;  center = (0m, 0.5m, 0m);  inertia = block(0.1m, 1m, 0.1m);  start position = (0m, -1m, 1m);
        }
        joint one = revolute(ground.position, ground.y, first.position, first.y);
        joint two = revolute(first.end, first.z, second.position, second.z);
        joint three = revolute(second.end, second.x, third.position, third.x);
        joint four = revolute(third.end, third.y, fourth.position, fourth.y);
        joint five = revolute(fourth.end, fourth.z, fifth.position, fifth.z);
        redundant joint six = revolute(fifth.end, fifth.x, ground.end, ground.x);
        freedom fall = one.angle from start at speed;
        /// Angle of the first hinge.
        output a = one.angle;
        /// Angle of the second hinge.
        output b = two.angle;
    }
}

/// The angle of the first hinge (rad) at [`DURATION`], computed with 60 digits.
pub const ANGLE: f64 = 6.725_995_973_259_582e-5;
/// In s.
pub const DURATION: f64 = 5.0;

const GRAVITY: f64 = 9.81;
/// Moments of inertia of a rod along it and across it, in kg m².
const INERTIA: [f64; 2] = [1.0 / 600.0, 1.01 / 12.0];

/// For other people's programs: the rods, where the last one ends, and the axes that stay at right angles.
#[must_use]
pub fn described() -> Value {
    let mut model = Model::new("D5 Bricard's linkage");
    model.gravity = [0.0, -GRAVITY, 0.0];
    let mut place = [0.0; 3];
    // Axis of the hinge, and the rod.
    for (k, (axis, rod, sign)) in [(1, 0, 1.0), (2, 1, -1.0), (0, 2, 1.0), (1, 0, -1.0), (2, 1, 1.0)].into_iter().enumerate() {
        let body = model.hang("rod", k.checked_sub(1), &[Joint::Turn(axis)], &[0.0]);
        (body.place, body.inertia) = (place, [INERTIA[1]; 3]);
        (body.center[rod], body.inertia[rod]) = (0.5 * sign, INERTIA[0]);
        place = [0.0; 3];
        place[rod] = sign;
    }
    model.cuts.push(Cut::Meet((Some(4), place), (None, [0.0, 0.0, 1.0])));
    let mut described = model.described();
    described["aligned"] = json!([[[4, 0], [null, 1]], [[4, 0], [null, 2]]]);
    described
}

/// By hand: the angle of the first hinge alone, others from sin a + sin b + sin a sin b = 0.
#[derive(Clone, Copy, Debug)]
pub struct ByHand;

/// The linkage in a motion with ȧ = 1.
struct Unit {
    /// Cosine and sine of b, first and second derivative of b by a.
    b: [f64; 4],
    /// 2 T / ȧ², half its derivative, and the derivative of the potential energy over g, all by a.
    balance: [f64; 3],
    /// The potential energy over g.
    height: f64,
}

/// A turn about an axis of the frame, by cosine and sine.
#[inline(always)]
fn turned(axes: &mut [Vector3<f64>; 3], axis: usize, cosine: f64, sine: f64) {
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    let (a, b) = (axes[next], axes[last]);
    (axes[next], axes[last]) = (a * cosine + b * sine, b * cosine - a * sine);
}

impl Unit {
    #[inline(always)]
    fn at(a: f64) -> Self {
        let (sine, cosine) = reuleaux::SimdReal::fast_sin_cos(a);
        let per = 1.0 / (1.0 + sine);
        let sine_b = -sine * per;
        let cosine_b = (1.0 - sine_b * sine_b).sqrt();
        let per_b = 1.0 / cosine_b;
        let slope = -cosine * per * per * per_b;
        let bend = (per * per * (sine + 2.0 * cosine * cosine * per) + sine_b * slope * slope) * per_b;
        let mut axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let zero = Vector3::zeros();
        let (mut w, mut alpha, mut v, mut acceleration) = (zero, zero, zero, zero);
        let (mut mass, mut half, mut weight, mut height, mut hinge) = (0.0, 0.0, 0.0, 0.0, 0.0);
        // Axis of the hinge, and the rod.
        for (k, (axis, rod, sign)) in [(1, 0, 1.0), (2, 1, -1.0), (0, 2, 1.0), (1, 0, -1.0), (2, 1, 1.0)].into_iter().enumerate() {
            let is_first = k % 2 == 0;
            let (cosine, sine) = if is_first { (cosine, sine) } else { (cosine_b, sine_b) };
            let direction = axes[axis];
            if is_first {
                alpha += w.cross(&direction);
                w += direction;
            } else {
                alpha += w.cross(&direction) * slope + direction * bend;
                w += direction * slope;
            }
            turned(&mut axes, axis, cosine, sine);
            let d = axes[rod] * sign;
            let u = w.cross(&d);
            let e = alpha.cross(&d) + w.cross(&u);
            let (vc, ac) = (v + u * 0.5, acceleration + e * 0.5);
            let (about, turning) = (w.dot(&d), alpha.dot(&d));
            mass += vc.norm_squared() + INERTIA[1] * w.norm_squared() + (INERTIA[0] - INERTIA[1]) * about * about;
            half += vc.dot(&ac) + INERTIA[1] * w.dot(&alpha) + (INERTIA[0] - INERTIA[1]) * about * turning;
            weight += vc.y;
            height += hinge + 0.5 * d.y;
            hinge += d.y;
            (v, acceleration) = (v + u, acceleration + e);
        }
        Self { b: [cosine_b, sine_b, slope, bend], balance: [mass, half, weight], height }
    }
}

impl ByHand {
    /// ä and b̈.
    #[inline(always)]
    #[must_use]
    pub fn turning(a: f64, rate: f64) -> [f64; 2] {
        let Unit { b: [_, _, slope, bend], balance: [mass, half, weight], .. } = Unit::at(a);
        let turning = -(half * rate * rate + GRAVITY * weight) / mass;
        [turning, slope * turning + bend * rate * rate]
    }

    /// At the beginning.
    #[must_use]
    pub fn start() -> State<f64, 1> {
        State::new(0.0, Vector1::zeros(), Vector1::zeros(), Vector1::zeros())
    }
}

impl Description<f64, 1> for ByHand {
    const NAME: &'static str = "Bricard";
    const COORDINATES: &'static [Coordinate] = &[Coordinate::angle("first", "angle")];
    const ROWS: &'static [Row] = &[];

    fn start(&self) -> SVector<f64, 1> {
        Vector1::zeros()
    }

    fn characteristic_length(&self) -> f64 {
        1.0
    }

    fn validate(&self) -> Result<(), ParameterOutOfRange<f64>> {
        Ok(())
    }
}

impl Dynamics<f64, 1, 1, 0, 0> for ByHand {
    const INTEGRATED: [usize; 1] = [0];
    const IS_LENGTH: [bool; 1] = [false];
    const JOINTS: [&'static str; 0] = [];
    const LEVELS: [[bool; 2]; 0] = [];

    fn constraints(&self, _: &SVector<f64, 1>, _: f64, _: &mut Constraints<f64, 0, 1>) {}

    fn initial(&self, _: &SVector<f64, 1>, _: f64, _: &mut Constraints<f64, 0, 1>) {}

    fn balance(&self, q: &SVector<f64, 1>, qd: &SVector<f64, 1>, _: f64, found: &mut Balance<f64, 0, 1>) {
        let [turning, _] = Self::turning(q[0], qd[0]);
        (found.mass, found.forces) = (SMatrix::identity(), Vector1::new(-turning));
    }

    #[inline(always)]
    fn accelerations(&self, q: &SVector<f64, 1>, qd: &SVector<f64, 1>, _: f64) -> Option<SVector<f64, 1>> {
        Some(Vector1::new(Self::turning(q[0], qd[0])[0]))
    }

    fn complete(&self, q: &SVector<f64, 1>, qd: &SVector<f64, 1>, qdd: &SVector<f64, 1>, _: f64) -> [SVector<f64, 1>; 3] {
        [*q, *qd, *qdd]
    }

    fn parameter_hash(&self) -> u64 {
        0
    }

    fn energy(&self, q: &SVector<f64, 1>, qd: &SVector<f64, 1>, _: f64) -> Energy<f64> {
        let unit = Unit::at(q[0]);
        Energy { kinetic: 0.5 * unit.balance[0] * qd[0] * qd[0], potential: GRAVITY * unit.height, power: 0.0 }
    }
}
