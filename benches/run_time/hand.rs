//! What one would write by hand: dyads in closed form, and Newton's method.

use reuleaux::nalgebra::{SVector, Vector2};
use reuleaux::{Equations, State};

/// A point with its velocity and acceleration.
#[derive(Clone, Copy)]
pub(crate) struct Point {
    pub(crate) p: Vector2<f64>,
    pub(crate) v: Vector2<f64>,
    pub(crate) a: Vector2<f64>,
}

/// A point that does not move.
pub(crate) fn fixed(x: f64, y: f64) -> Point {
    Point { p: Vector2::new(x, y), v: Vector2::zeros(), a: Vector2::zeros() }
}

/// The end of a crank of length 1 about the origin: φ with its first and second derivative.
#[inline]
pub(crate) fn crank(length: f64, [angle, rate, acceleration]: [f64; 3]) -> Point {
    let (sine, cosine) = libm::sincos(angle);
    let (along, across) = (Vector2::new(cosine, sine) * length, Vector2::new(-sine, cosine) * length);
    Point { p: along, v: across * rate, a: across * acceleration - along * (rate * rate) }
}

/// The point at distance `ra` from a and `rb` from b, to the left of the way from a to b if `side` is 1.
#[inline]
pub(crate) fn dyad(a: &Point, ra: f64, b: &Point, rb: f64, side: f64) -> Point {
    let d = b.p - a.p;
    let square = d.dot(&d);
    let along = 0.5 + (ra * ra - rb * rb) / (2.0 * square);
    let across = side * (ra * ra / square - along * along).sqrt();
    let p = a.p + d * along + Vector2::new(-d.y, d.x) * across;
    let (u, w) = (p - a.p, p - b.p);
    let share = 1.0 / (u.x * w.y - u.y * w.x);
    let solve = |r: f64, s: f64| Vector2::new((r * w.y - u.y * s) * share, (u.x * s - r * w.x) * share);
    let v = solve(u.dot(&a.v), w.dot(&b.v));
    let (ua, wb) = (v - a.v, v - b.v);
    let acceleration = solve(u.dot(&a.a) - ua.dot(&ua), w.dot(&b.a) - wb.dot(&wb));
    Point { p, v, a: acceleration }
}

/// W1 by Newton's method on the angles of coupler and rocker, from q + h q̇ + h² q̈/2.
#[derive(Clone, Copy, Default)]
pub(crate) struct Angles {
    pub(crate) q: [f64; 2],
    pub(crate) qd: [f64; 2],
    pub(crate) qdd: [f64; 2],
}

impl Angles {
    #[inline]
    pub(crate) fn step(&mut self, t: f64, h: f64) {
        let omega = core::f64::consts::TAU;
        let crank = crank(1.0, [omega * t, omega, 0.0]);
        let mut q = [0, 1].map(|i| self.q[i] + h * (self.qd[i] + 0.5 * h * self.qdd[i]));
        loop {
            let ((s2, c2), (s3, c3)) = (libm::sincos(q[0]), libm::sincos(q[1]));
            let phi = [crank.p.x + 3.5 * c2 - 4.0 - 3.0 * c3, crank.p.y + 3.5 * s2 - 3.0 * s3];
            let [[a, b], [c, d]] = [[-3.5 * s2, 3.0 * s3], [3.5 * c2, -3.0 * c3]];
            let share = 1.0 / (a * d - b * c);
            let solve = |r: [f64; 2]| [(d * r[0] - b * r[1]) * share, (a * r[1] - c * r[0]) * share];
            if phi[0].abs().max(phi[1].abs()) <= 1e-12 {
                let qd = solve([-crank.v.x, -crank.v.y]);
                let (e2, e3) = (3.5 * qd[0] * qd[0], 3.0 * qd[1] * qd[1]);
                let qdd = solve([-crank.a.x + e2 * c2 - e3 * c3, -crank.a.y + e2 * s2 - e3 * s3]);
                (self.q, self.qd, self.qdd) = (q, qd, qdd);
                return;
            }
            let change = solve(phi);
            q = [q[0] - change[0], q[1] - change[1]];
        }
    }
}

/// Newton's method on all coordinates with nalgebra's LU, from q + h q̇ + h² q̈/2 or from q; Φ and its derivatives are the
/// generated ones, which nobody writes better.
macro_rules! absolute {
    ($name:ident, $n:literal) => {
        pub(crate) fn $name<E: Equations<f64, $n, $n>>(equations: &E, state: &mut State<f64, $n>, t: f64, has_predictor: bool) {
            let h = if has_predictor { t - state.t } else { 0.0 };
            let mut q: SVector<f64, $n> = state.q + (state.qd + state.qdd * (0.5 * h)) * h;
            loop {
                let (phi, jacobian) = equations.linearize(&q, t);
                let factors = jacobian.lu();
                if phi.amax() <= 1e-12 {
                    let qd = factors.solve(&equations.nu(&q, t)).expect("regular");
                    let qdd = factors.solve(&equations.gamma(&q, &qd, t)).expect("regular");
                    (state.t, state.q, state.qd, state.qdd) = (t, q, qd, qdd);
                    return;
                }
                q -= factors.solve(&phi).expect("regular");
            }
        }
    };
}
absolute!(absolute_9, 9);
absolute!(absolute_21, 21);
