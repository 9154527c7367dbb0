//! D6: the heavy top of the literature on differential-algebraic equations, spun about its axis.

use reuleaux::nalgebra::{SMatrix, SVector, Vector3, Vector4};
use reuleaux::{Balance, Constraints, Coordinate, Description, Dynamics, Energy, ParameterOutOfRange, Row, State, mechanism};

mechanism! {
    /// A top whose axis is y.
    pub mechanism Top in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        body top { mass = 15kg;  center = (0m, 1m, 0m);  inertia = (0.234375kgm2, 0.46875kgm2, 0.234375kgm2); }
        joint tip = spherical((0m, 0m, 0m), top.position);
        freedom turning = top.angular_velocity from (0rad_s, 150rad_s, -4.61538rad_s);
    }
}

/// The mass centre (m) after two seconds; two integrators agree to 4e-13.
pub const CENTER: [f64; 3] = [-0.150_416_822_745_2, -0.724_165_591_636_9, -0.673_022_269_560_5];
/// In s.
pub const DURATION: f64 = 2.0;
/// Moments of inertia about the tip, across the axis and about it (kg m²), and m g l (N m).
pub const NUMBERS: [f64; 3] = [15.234375, 0.46875, 15.0 * 9.81];

/// The mass centre from the quaternion (w, x, y, z).
#[must_use]
pub fn center(q: [f64; 4]) -> [f64; 3] {
    let [w, x, y, z] = q;
    let size: f64 = q.iter().map(|entry| entry * entry).sum();
    [2.0 * (x * y - w * z) / size, (w * w - x * x + y * y - z * z) / size, 2.0 * (y * z + w * x) / size]
}

/// By hand: a quaternion, Euler's equations in the frame of the top.
#[derive(Clone, Copy, Debug)]
pub struct ByHand;

impl ByHand {
    /// Second derivatives of the quaternion: q̈ = q ω̇ / 2 − q q̇² / q² with ω = 2 q* q̇ / q².
    #[inline(always)]
    #[must_use]
    pub fn turning([w, x, y, z]: [f64; 4], [dw, dx, dy, dz]: [f64; 4]) -> [f64; 4] {
        let [across, about, weight] = NUMBERS;
        let (ww, xx, yy, zz) = (w * w, x * x, y * y, z * z);
        let per = 1.0 / (ww + xx + yy + zz);
        let twice = 2.0 * per;
        let a = twice * (w * dx - x * dw - y * dz + z * dy);
        let b = twice * (w * dy - y * dw - z * dx + x * dz);
        let c = twice * (w * dz - z * dw - x * dy + y * dx);
        // The vertical in the frame of the top, but for its y.
        let (up_x, up_z) = (twice * (x * z - w * y), per * (ww - xx - yy + zz));
        let rest = about - across;
        let (ta, tc) = ((rest * b * c - weight * up_z) * (0.5 / across), (weight * up_x - rest * a * b) * (0.5 / across));
        let inward = per * (dw * dw + dx * dx + dy * dy + dz * dz);
        [-x * ta - z * tc - inward * w, w * ta + y * tc - inward * x, z * ta - x * tc - inward * y, w * tc - y * ta - inward * z]
    }

    /// At the beginning.
    #[must_use]
    pub fn start() -> State<f64, 4> {
        let rates = Vector4::new(0.0, 0.0, 75.0, -2.30769);
        State::new(0.0, Vector4::new(1.0, 0.0, 0.0, 0.0), rates, Vector4::zeros())
    }
}

impl Description<f64, 4> for ByHand {
    const NAME: &'static str = "Top";
    const COORDINATES: &'static [Coordinate] = &[
        Coordinate::number("top", "e0"),
        Coordinate::number("top", "e1"),
        Coordinate::number("top", "e2"),
        Coordinate::number("top", "e3"),
    ];
    const ROWS: &'static [Row] = &[];

    fn start(&self) -> SVector<f64, 4> {
        Vector4::new(1.0, 0.0, 0.0, 0.0)
    }

    fn characteristic_length(&self) -> f64 {
        1.0
    }

    fn validate(&self) -> Result<(), ParameterOutOfRange<f64>> {
        Ok(())
    }
}

impl Dynamics<f64, 4, 4, 1, 1> for ByHand {
    const INTEGRATED: [usize; 4] = [0, 1, 2, 3];
    const IS_LENGTH: [bool; 4] = [false; 4];
    const JOINTS: [&'static str; 1] = ["tip"];
    const LEVELS: [[bool; 2]; 1] = [[true, true]];

    fn constraints(&self, q: &SVector<f64, 4>, _: f64, found: &mut Constraints<f64, 1, 4>) {
        (found.phi[0], found.jacobian) = (q.norm_squared() - 1.0, q.transpose() * 2.0);
    }

    fn initial(&self, q: &SVector<f64, 4>, t: f64, found: &mut Constraints<f64, 1, 4>) {
        self.constraints(q, t, found);
    }

    fn balance(&self, q: &SVector<f64, 4>, qd: &SVector<f64, 4>, _: f64, found: &mut Balance<f64, 1, 4>) {
        let turning = Self::turning((*q).into(), (*qd).into());
        (found.jacobian, found.gamma[0]) = (q.transpose() * 2.0, -2.0 * qd.norm_squared());
        (found.mass, found.forces) = (SMatrix::identity(), -SVector::from(turning));
    }

    #[inline(always)]
    fn accelerations(&self, q: &SVector<f64, 4>, qd: &SVector<f64, 4>, _: f64) -> Option<SVector<f64, 4>> {
        Some(Self::turning((*q).into(), (*qd).into()).into())
    }

    fn complete(&self, q: &SVector<f64, 4>, qd: &SVector<f64, 4>, qdd: &SVector<f64, 4>, _: f64) -> [SVector<f64, 4>; 3] {
        [*q, *qd, *qdd]
    }

    fn parameter_hash(&self) -> u64 {
        0
    }

    fn energy(&self, q: &SVector<f64, 4>, qd: &SVector<f64, 4>, _: f64) -> Energy<f64> {
        let [across, about, weight] = NUMBERS;
        let (w, v) = (q[0], Vector3::new(q[1], q[2], q[3]));
        let (dw, dv) = (qd[0], Vector3::new(qd[1], qd[2], qd[3]));
        let omega = (dv * w - v * dw - v.cross(&dv)) * 2.0;
        let kinetic = 0.5 * (across * (omega.x * omega.x + omega.z * omega.z) + about * omega.y * omega.y);
        Energy { kinetic, potential: weight * center((*q).into())[2], power: 0.0 }
    }
}
