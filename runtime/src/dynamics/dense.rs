//! States between the ends of a step.
//!
//! ```text
//! y(t + s h) = y₀ + s (F₀ + (1 − s) (F₁ + s (F₂ + (1 − s) (F₃ + s (F₄ + (1 − s) (F₅ + s F₆))))))
//! ```
//!
//! A polynomial of order 7 with the values and rates at both ends (Hairer, Nørsett, Wanner, II.6); where it leads, positions and speeds are
//! brought back to where the equations hold.

use super::accelerate::{accelerations, singular};
use super::equations::Dynamics;
use super::partition::Pivots;
use super::places::{picked, put};
use super::project::{Reached, project, refresh};
use super::rank::{is_sharp, too_short};
use super::step::is_near;
use super::stopped::Stopped;
use super::tableau::Rates;
use super::tableau::{DENSE, STAGES, dense, dense_node, dense_stage};
use crate::number::Scalar;
use crate::state::State;

/// The polynomial may leave the equations by so many times the tolerance of a step.
const COARSER: f64 = 10.0;

/// A step that states are asked of.
#[derive(Clone)]
pub(super) struct Dense<T, const N: usize, const I: usize> {
    /// Where it begins.
    from: State<T, N>,
    /// Its size, in s.
    h: T,
    /// y₀, then F, of positions and of speeds.
    coefficients: [[[T; 8]; I]; 2],
}

impl<T: Scalar, const N: usize, const I: usize> Dense<T, N, I> {
    /// The polynomials of a step.
    ///
    /// # Errors
    /// Why there are no accelerations on the way.
    pub(super) fn new<S, const M: usize, const R: usize>(
        mechanism: &S,
        from: &State<T, N>,
        to: &State<T, N>,
        rates: &Rates<T, I>,
    ) -> Result<Self, Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        let h = to.t - from.t;
        let [q, u] = [&from.q, &from.qd].map(|vector| picked(vector, &S::INTEGRATED));
        let ends = [&to.q, &to.qd].map(|vector| picked(vector, &S::INTEGRATED));
        let rates_there = [&to.qd, &to.qdd].map(|vector| picked(vector, &S::INTEGRATED));
        let mut all = [[[T::ZERO; DENSE]; I]; 2];
        for (part, (all, there)) in all.iter_mut().zip(&rates_there).enumerate() {
            for (k, (all, there)) in all.iter_mut().zip(there).enumerate() {
                all.iter_mut().zip(rates.iter().map(|stage| &stage[part][k]).chain([there])).for_each(|(to, rate)| *to = *rate);
            }
        }
        let (mut there, mut moving, mut pivots) = (from.q, from.qd, None);
        for number in STAGES + 1..DENSE {
            let at: [T; I] = core::array::from_fn(|k| q[k] + h * dense_stage(number, &all[0][k]));
            let speeds: [T; I] = core::array::from_fn(|k| u[k] + h * dense_stage(number, &all[1][k]));
            put(&mut there, &S::INTEGRATED, &at);
            put(&mut moving, &S::INTEGRATED, &speeds);
            let found = accelerations(mechanism, (&there, &moving), from.t + dense_node::<T>(number) * h, &mut pivots)?;
            for (all, rates) in all.iter_mut().zip([&speeds, &found]) {
                for (all, rate) in all.iter_mut().zip(rates) {
                    if let Some(entry) = all.get_mut(number) {
                        *entry = *rate;
                    }
                }
            }
        }
        let coefficients = |part: usize, before: [T; I]| {
            core::array::from_fn(|k| {
                let (k0, k1, change) = (all[part][k][0], all[part][k][STAGES], ends[part][k] - before[k]);
                let [a, b, c, d] = dense(&all[part][k]).map(|value| h * value);
                [before[k], change, h * k0 - change, change + change - h * (k0 + k1), a, b, c, d]
            })
        };
        Ok(Self { from: from.clone(), h, coefficients: [coefficients(0, q), coefficients(1, u)] })
    }

    /// Where it begins.
    pub(super) fn beginning(&self) -> State<T, N> {
        self.from.clone()
    }

    /// True for a time in the step.
    pub(super) fn contains(&self, t: T) -> bool {
        let part = (t - self.from.t) / self.h;
        part >= T::ZERO && part <= T::of(1.0)
    }

    /// The state at a time.
    ///
    /// * `known`: given, pivots at the end of the step.
    /// * `tolerance`, `fastest`: given, those of the step, as for [`land`](super::step::land).
    ///
    /// # Errors
    /// Why there is none.
    pub(super) fn at<S, const M: usize, const R: usize>(
        &self,
        mechanism: &S,
        known: Option<&Pivots<T, M, I>>,
        t: T,
        (tolerance, fastest): (T, T),
    ) -> Result<State<T, N>, Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        let part = (t - self.from.t) / self.h;
        let rest = T::of(1.0) - part;
        let value = |f: &[T; 8]| {
            let inner = f[4] + part * (f[5] + rest * (f[6] + part * f[7]));
            f[0] + part * (f[1] + rest * (f[2] + part * (f[3] + rest * inner)))
        };
        let (mut q, mut qd) = (self.from.q, self.from.qd);
        for (vector, coefficients) in [&mut q, &mut qd].into_iter().zip(&self.coefficients) {
            put(vector, &S::INTEGRATED, &core::array::from_fn(|k| value(&coefficients[k])));
        }
        let before = [q, qd];
        let mut reached = Reached::empty();
        project(mechanism, known, (&mut q, &mut qd), t, &mut reached).map_err(|open| singular::<T, S, N, I, M, R>(t, open.row()))?;
        let mut state = State::new(t, q, qd, self.from.qdd);
        if !is_near(mechanism, before.each_ref(), [&q, &qd], (T::of(COARSER) * tolerance, fastest)) {
            return Err(too_short(mechanism, &state));
        }
        is_sharp(mechanism, t, &reached)?;
        refresh(mechanism, &mut state)?;
        Ok(state)
    }
}
