//! States between two others, by polynomials of degree five.

use nalgebra::SVector;

use super::equations::Dynamics;
use super::places::{picked, put};
use crate::number::Scalar;
use crate::state::State;

/// A state on the way between two others.
pub(super) fn between<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    to: &State<T, N>,
    part: T,
) -> State<T, N>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let ([q, qd, qdd], t) = interpolated(&S::INTEGRATED, from, to, part);
    let [q, qd, qdd] = mechanism.complete(&q, &qd, &qdd, t);
    State::new(t, q, qd, qdd)
}

/// The integrated entries of a state on the way between two others, by the polynomials of degree five through their positions, speeds and
/// accelerations, and its time.
pub(super) fn interpolated<T: Scalar, const N: usize, const I: usize>(
    integrated: &[usize; I],
    from: &State<T, N>,
    to: &State<T, N>,
    part: T,
) -> ([SVector<T, N>; 3], T) {
    let h = to.t - from.t;
    let [from_q, from_u, from_a] = [&from.q, &from.qd, &from.qdd].map(|vector| picked(vector, integrated));
    let [to_q, to_u, to_a] = [&to.q, &to.qd, &to.qdd].map(|vector| picked(vector, integrated));
    let mut values = [[T::ZERO; I]; 3];
    let [q, u, a] = &mut values;
    for k in 0..I {
        // Σ c_i s^i, s from 0 to 1
        let (v0, v1) = (h * from_u[k], h * to_u[k]);
        let (a0, a1) = (h * h * from_a[k], h * h * to_a[k]);
        let d = to_q[k] - from_q[k] - v0 - T::of(0.5) * a0;
        let (e, f) = (v1 - v0 - a0, a1 - a0);
        let c3 = T::of(10.0) * d - T::of(4.0) * e + T::of(0.5) * f;
        let c4 = T::of(-15.0) * d + T::of(7.0) * e - f;
        let c5 = T::of(6.0) * d - T::of(3.0) * e + T::of(0.5) * f;
        let s = part;
        q[k] = from_q[k] + s * (v0 + s * (T::of(0.5) * a0 + s * (c3 + s * (c4 + s * c5))));
        u[k] = (v0 + s * (a0 + s * (T::of(3.0) * c3 + s * (T::of(4.0) * c4 + s * T::of(5.0) * c5)))) / h;
        a[k] = (a0 + s * (T::of(6.0) * c3 + s * (T::of(12.0) * c4 + s * T::of(20.0) * c5))) / (h * h);
    }
    let mut vectors = [from.q, from.qd, from.qdd];
    for (vector, values) in vectors.iter_mut().zip(&values) {
        put(vector, integrated, values);
    }
    (vectors, from.t + part * h)
}
