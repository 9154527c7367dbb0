//! Steps for stiff motions: the Rosenbrock method RODAS of order 4, stiffly accurate, with an error estimate of order 3.
//!
//! Coefficients: E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*, 2nd edition, Springer 1996, IV.7. With U = (Q, V) for
//! positions and speeds, each stage solves
//!
//! ```text
//! Q/(γh) − V            = r_q      r: rates where the stage stands, and Σ c_ij U_j / h
//! V/(γh) − A_q Q − A_u V = r_v
//! ```
//!
//! so that one matrix of the size of the speeds, 1/(γh) − A_u − γh A_q, is factored a step. A_q and A_u are the derivatives of the
//! accelerations, by differences.

use super::accelerate::{accelerations, lengths};
use super::equations::Dynamics;
use super::method::{Method, Trial};
use super::partition::Pivots;
use super::places::{largest, picked, put};
use super::stopped::Stopped;
use crate::linear::unpermuted;
use crate::number::Scalar;
use crate::number::order::smaller;
use crate::state::State;

const STAGES: usize = 6;

/// A speed is changed by at least this times ε h lengths. Accelerations whose terms are up to a hundredth of it, in lengths/s², are rounded to ε of
/// them, which changes h ∂a/∂v by a hundredth at most. In single precision it is √ε h lengths. In no step do lengths change by more than √ε, so that
/// friction keeps its direction within the increment.
const SLOPED: f64 = 1e7;

/// γ
const GAMMA: f64 = 0.25;

/// Sum of the stages so far for one number.
type Found<T> = [T; STAGES];

/// Σ of weighted results.
macro_rules! sum {
    ($k:ident: $($stage:literal => $weight:literal),*) => { T::of(0.0) $(+ T::of($weight) * $k[$stage])* };
}

/// Σ a_ij U_j; the last stage begins where the fifth ends.
#[inline(always)]
fn place<T: Scalar>(stage: usize, k: &Found<T>) -> T {
    match stage {
        1 => sum!(k: 0 => 1.544),
        2 => sum!(k: 0 => 0.9466785280815826, 1 => 0.2557011698983284),
        3 => sum!(k: 0 => 3.314825187068521, 1 => 2.896124015972201, 2 => 0.9986419139977817),
        4 => sum!(k: 0 => 1.221224509226641, 1 => 6.019134481288629, 2 => 12.53708332932087, 3 => -0.687886036105895),
        5 => sum!(k: 0 => 1.221224509226641, 1 => 6.019134481288629, 2 => 12.53708332932087, 3 => -0.687886036105895, 4 => 1.0),
        _ => T::of(0.0),
    }
}

/// Σ c_ij U_j
#[inline(always)]
fn coupling<T: Scalar>(stage: usize, k: &Found<T>) -> T {
    match stage {
        1 => sum!(k: 0 => -5.6688),
        2 => sum!(k: 0 => -2.430093356833875, 1 => -0.2063599157091915),
        3 => sum!(k: 0 => -0.1073529058151375, 1 => -9.594562251023355, 2 => -20.47028614809616),
        4 => sum!(k: 0 => 7.496443313967647, 1 => -10.24680431464352, 2 => -33.99990352819905, 3 => 11.7089089320616),
        5 => {
            sum!(k: 0 => 8.083246795921522, 1 => -7.981132988064893, 2 => -31.52159432874371, 3 => 16.31930543123136, 4 => -6.058818238834054)
        }
        _ => T::of(0.0),
    }
}

/// Time of a stage, and its part of the derivative by time.
#[inline(always)]
fn times<T: Scalar>(stage: usize) -> [T; 2] {
    match stage {
        0 => [T::of(0.0), T::of(0.25)],
        1 => [T::of(0.386), T::of(-0.1043)],
        2 => [T::of(0.21), T::of(0.1035)],
        3 => [T::of(0.63), T::of(-0.03620000000000023)],
        _ => [T::of(1.0), T::of(0.0)],
    }
}

/// Linearly implicit steps (Rosenbrock), of order 4, for stiff motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stiff;

impl Method for Stiff {
    const ROOTS: usize = 2;
    const IS_DENSE: bool = false;

    fn evaluations(coordinates: usize) -> usize {
        // Derivatives by positions, speeds and time, the stages but the first, and the end.
        2 * coordinates + STAGES + 1
    }

    fn trial<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
        mechanism: &S,
        state: &State<T, N>,
        h: T,
    ) -> Result<Trial<T, N, I>, Stopped<T>>
    where
        T: Scalar,
        S: Dynamics<T, N, I, M, R>,
    {
        let [q, u, a] = [&state.q, &state.qd, &state.qdd].map(|vector| picked(vector, &S::INTEGRATED));
        let mut motion = MotionAt { mechanism, vectors: [state.q, state.qd], pivots: None };
        let [by_position, by_speed] = motion.slopes([&q, &u], &a, state.t, h)?;
        let by_time = motion.slope_by_time([&q, &u], &a, state.t, h)?;
        let part = T::of(GAMMA) * h;
        let mut matrix = [[T::ZERO; I]; I];
        for row in 0..I {
            for column in 0..I {
                let unit = if row == column { T::of(1.0) / part } else { T::ZERO };
                matrix[row][column] = unit - by_speed[row][column] - part * by_position[row][column];
            }
        }
        let factors = Factors::new(matrix);
        // By positions and speeds, coordinate and stage.
        let mut found = [[[T::ZERO; STAGES]; I]; 2];
        let (mut end, mut there) = ([q, u], a);
        for stage in 0..STAGES {
            let [node, of_time] = times::<T>(stage);
            let at: [T; I] = core::array::from_fn(|k| q[k] + place(stage, &found[0][k]));
            let moving: [T; I] = core::array::from_fn(|k| u[k] + place(stage, &found[1][k]));
            let rates = if stage == 0 { a } else { motion.at([&at, &moving], state.t + node * h)? };
            let right: [T; I] = core::array::from_fn(|k| moving[k] + coupling(stage, &found[0][k]) / h);
            let mut side: [T; I] = core::array::from_fn(|k| {
                let coupled = rates[k] + coupling(stage, &found[1][k]) / h + h * of_time * by_time[k];
                (0..I).fold(coupled, |sum, column| sum + part * by_position[k][column] * right[column])
            });
            factors.solve(&mut side);
            for k in 0..I {
                found[0][k][stage] = part * (right[k] + side[k]);
                found[1][k][stage] = side[k];
            }
            (end, there) = ([at, moving], rates);
        }
        // The last stage is the difference between the steps of order 4 and 3.
        let last = found.map(|part| part.map(|stages| stages[STAGES - 1]));
        let mut vectors = [state.q, state.qd];
        for ((vector, end), last) in vectors.iter_mut().zip(&end).zip(&last) {
            put(vector, &S::INTEGRATED, &core::array::from_fn(|k| end[k] + last[k]));
        }
        let mut errors = last.map(|part| part.map(|error| [error, T::ZERO]));
        let change: [[T; I]; 2] = [[q, end[0]], [u, end[1]]].map(|[from, to]| core::array::from_fn(|k| to[k] - from[k]));
        let slopes = Slope { by_position, by_speed, by_time, h };
        let bent = slopes.bent([&q, &u], &change, (&a, &there), &lengths(mechanism));
        errors[1].iter_mut().zip(&bent).for_each(|(error, bent)| error[0] = error[0].abs() + bent.without_derivatives().abs());
        Ok(Trial { end: vectors, errors, rates: None })
    }
}

/// Slopes are those of the whole step if accelerations at its end are what they tell but for this part.
const STRAIGHT: f64 = 0.1;

/// An acceleration is rounded by less than this many ε times the sum of its terms.
const ROUNDED: f64 = 16.0;

/// Derivatives of the accelerations at the beginning of a step of the size `h`.
struct Slope<T, const I: usize> {
    by_position: Slopes<T, I>,
    by_speed: Slopes<T, I>,
    by_time: [T; I],
    h: T,
}

impl<T: Scalar, const I: usize> Slope<T, I> {
    /// Errors of speeds that steep slopes hide, as those of friction within its transition: where they end within a step, the step and its estimate
    /// are both made by slopes that hold no longer.
    ///
    /// * `positions`, `speeds`, `change`: given, those at the beginning, and their change in the step.
    /// * `a`, `there`: given, accelerations at the beginning and at the end.
    fn bent(&self, [positions, speeds]: [&[T; I]; 2], change: &[[T; I]; 2], (a, there): (&[T; I], &[T; I]), lengths: &[T; I]) -> [T; I] {
        let part = T::of(GAMMA) * self.h;
        let [of_positions, of_speeds] = change;
        let told = |k: usize| {
            let terms = self.by_position[k].iter().zip(of_positions).chain(self.by_speed[k].iter().zip(of_speeds));
            terms.fold(self.h * self.by_time[k], |told, (slope, change)| told + *slope * *change)
        };
        let told: [T; I] = core::array::from_fn(told);
        let missing: [T; I] = core::array::from_fn(|k| there[k] - a[k] - told[k]);
        let sizes = [a, there, &told].map(|vector| largest(vector, lengths));
        let greatest = sizes[0].max(sizes[1]).max(sizes[2]);
        if largest(&missing, lengths) <= T::of(STRAIGHT) * greatest {
            return [T::ZERO; I];
        }
        core::array::from_fn(|k| {
            let (mut steep, mut terms) = (T::ZERO, T::ZERO);
            for column in 0..I {
                let (of_position, of_speed) = (self.by_position[k][column].abs(), self.by_speed[k][column].abs());
                steep = steep + part.abs() * (of_speed + part.abs() * of_position) * lengths[column] / lengths[k];
                // Forces of springs that are pressed together may be those of whole lengths.
                terms = terms
                    + of_position * lengths[column].max(positions[column].abs())
                    + of_speed * (speeds[column].abs() + of_speeds[column].abs());
            }
            let is_rounded = missing[k].abs() <= T::of(ROUNDED) * T::EPSILON * terms;
            if is_rounded { T::ZERO } else { part * missing[k] * steep / (T::of(1.0) + steep) }
        })
    }
}

/// Accelerations at other positions and speeds than those of a state.
struct MotionAt<'a, T, S, const N: usize, const I: usize, const M: usize> {
    mechanism: &'a S,
    vectors: [nalgebra::SVector<T, N>; 2],
    pivots: Option<Pivots<T, M, I>>,
}

/// Derivatives of each acceleration, by row.
type Slopes<T, const I: usize> = [[T; I]; I];

impl<T: Scalar, S, const N: usize, const I: usize, const M: usize> MotionAt<'_, T, S, N, I, M> {
    fn at<const R: usize>(&mut self, motion: [&[T; I]; 2], t: T) -> Result<[T; I], Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        for (vector, values) in self.vectors.iter_mut().zip(motion) {
            put(vector, &S::INTEGRATED, values);
        }
        let [q, qd] = &self.vectors;
        accelerations(self.mechanism, (q, qd), t, &mut self.pivots)
    }

    /// The sides of all jumps and kinks of forces on which a motion is.
    fn sides<const R: usize>(&mut self, motion: [&[T; I]; 2], t: T) -> u64
    where
        S: Dynamics<T, N, I, M, R>,
    {
        for (vector, values) in self.vectors.iter_mut().zip(motion) {
            put(vector, &S::INTEGRATED, values);
        }
        let [q, qd] = &self.vectors;
        self.mechanism.sides_of_forces(q, qd, t)
    }

    /// Derivatives of the accelerations by positions and by speeds, on the side of a jump or a kink on which the motion is.
    fn slopes<const R: usize>(&mut self, motion: [&[T; I]; 2], here: &[T; I], t: T, h: T) -> Result<[Slopes<T, I>; 2], Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        let lengths = lengths(self.mechanism);
        // Increments of speeds are small against the speeds before and after the step: within more, friction may change its direction.
        let [speed, change] = [motion[1], here].map(|rates| largest(rates, &lengths));
        let fastest = speed.max(change * h.abs());
        let sloped = smaller(T::of(SLOPED) * T::EPSILON, T::ROOT_EPSILON);
        let smallest = smaller(sloped * h.abs(), T::ROOT_EPSILON / h.abs());
        let mut slopes = [[[T::ZERO; I]; I]; 2];
        let sides = if S::FORCES_HAVE_KINKS { self.sides(motion, t) } else { 0 };
        for (part, slopes) in slopes.iter_mut().enumerate() {
            for column in 0..I {
                let mut moved = motion.map(|values| *values);
                let length = lengths[column];
                let (scale, at_least) = if part == 0 { (length, T::ZERO) } else { (length * fastest, length * smallest) };
                let before = moved[part][column];
                let increment = (T::ROOT_EPSILON * before.abs().max(scale)).max(at_least);
                let mut after = before + increment;
                moved[part][column] = after;
                if S::FORCES_HAVE_KINKS && self.sides([&moved[0], &moved[1]], t) != sides {
                    after = before - increment;
                    moved[part][column] = after;
                    // Where forces jump on both sides of the motion, the step takes their size alone.
                    if self.sides([&moved[0], &moved[1]], t) != sides {
                        continue;
                    }
                }
                let there = self.at([&moved[0], &moved[1]], t)?;
                for (row, (there, here)) in slopes.iter_mut().zip(there.iter().zip(here)) {
                    row[column] = (*there - *here) / (after - before);
                }
            }
        }
        Ok(slopes)
    }

    fn slope_by_time<const R: usize>(&mut self, motion: [&[T; I]; 2], here: &[T; I], t: T, h: T) -> Result<[T; I], Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        let increment = T::ROOT_EPSILON * t.abs().max(h.abs());
        let mut after = t + increment;
        if S::FORCES_HAVE_KINKS {
            let sides = self.sides(motion, t);
            if self.sides(motion, after) != sides {
                after = t - increment;
                if self.sides(motion, after) != sides {
                    return Ok([T::ZERO; I]);
                }
            }
        }
        let there = self.at(motion, after)?;
        Ok(core::array::from_fn(|k| (there[k] - here[k]) / (after - t)))
    }
}

/// Factors of a matrix, with row pivoting.
struct Factors<T, const I: usize> {
    rows: [[T; I]; I],
    order: [usize; I],
}

impl<T: Scalar, const I: usize> Factors<T, I> {
    fn new(mut rows: [[T; I]; I]) -> Self {
        let mut order: [usize; I] = unpermuted();
        for k in 0..I {
            let mut best = k;
            for row in k..I {
                best = if rows[row][k].abs() > rows[best][k].abs() { row } else { best };
            }
            rows.swap(k, best);
            order.swap(k, best);
            let own = rows[k];
            for row in rows.iter_mut().skip(k + 1) {
                let factor = row[k] / own[k];
                row[k] = factor;
                for (entry, own) in row.iter_mut().zip(&own).skip(k + 1) {
                    *entry = *entry - factor * *own;
                }
            }
        }
        Self { rows, order }
    }

    fn solve(&self, side: &mut [T; I]) {
        let given = *side;
        for k in 0..I {
            let before = given.get(self.order[k]).copied().unwrap_or(T::ZERO);
            side[k] = (0..k).fold(before, |sum, column| sum - self.rows[k][column] * side[column]);
        }
        for k in (0..I).rev() {
            let sum = (k + 1..I).fold(side[k], |sum, column| sum - self.rows[k][column] * side[column]);
            side[k] = sum / self.rows[k][k];
        }
    }
}
