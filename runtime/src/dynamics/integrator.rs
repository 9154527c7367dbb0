//! Integration in time.

use nalgebra::{SMatrix, SVector};

use super::accelerate::{accelerations, lengths};
use super::equations::Dynamics;
use super::partition::{Pivots, has_other_signs, weakest};
use super::project::{initial_state, project, refresh};
use super::stopped::Stopped;
use super::tableau::{FIFTH, NODES, STAGES, STEPS, THIRD, WEIGHTS};
use crate::number::Float;
use crate::state::State;

/// Steps of a motion: their tolerance, their size, and what they cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integrator<T = f64> {
    /// Error aimed at, relative to the largest length, angle and speed; motions that amplify errors end with larger ones.
    pub tolerance: T,
    /// Longest step, in s; infinite unless set.
    pub longest: T,
    /// Most steps of one call.
    pub most: usize,
    /// Size of the next step in s; 0 before the first one.
    pub step: T,
    /// Largest speed so far, in L/s and rad/s, which errors of speeds are compared with.
    pub fastest: T,
    /// Number of accepted steps.
    pub accepted: usize,
    /// Number of rejected steps.
    pub rejected: usize,
    /// Number of times that accelerations were computed.
    pub evaluations: usize,
}

/// Positions and speeds that are integrated.
type Phase<T, const I: usize> = [SVector<T, I>; 2];

impl<T: Float> Integrator<T> {
    /// Steps with this relative error, from 1e-4 to 1e-13.
    #[must_use]
    pub fn new(tolerance: T) -> Self {
        let longest = T::of(f64::INFINITY);
        let (step, fastest) = (T::ZERO, T::ZERO);
        Self { tolerance, longest, most: 1_000_000, step, fastest, accepted: 0, rejected: 0, evaluations: 0 }
    }

    /// The state at t = 0 with the initial values of the freedoms.
    ///
    /// # Errors
    /// Why there is none.
    #[doc(hidden)]
    pub fn initial_state<S, const N: usize, const I: usize, const M: usize, const R: usize>(
        mechanism: &S,
    ) -> Result<State<T, N>, Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        initial_state(mechanism)
    }

    /// Makes the accelerations of a state those of its positions and speeds, which have to fulfil the equations.
    ///
    /// # Errors
    /// Why there are none.
    #[doc(hidden)]
    pub fn refresh<S, const N: usize, const I: usize, const M: usize, const R: usize>(
        mechanism: &S,
        state: &mut State<T, N>,
    ) -> Result<(), Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        refresh(mechanism, state)
    }

    /// One step of fixed size, without an estimate of its error.
    ///
    /// # Errors
    /// Why there is no state after it; the state stays as it is.
    #[doc(hidden)]
    pub fn fixed_step<S, const N: usize, const I: usize, const M: usize, const R: usize>(
        mechanism: &S,
        state: &mut State<T, N>,
        h: T,
    ) -> Result<(), Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        let stages = stages(mechanism, state, h)?;
        let (next, reached) = after(mechanism, state, &stages, h)?;
        keeps_rank(mechanism, state, &next, &reached)?;
        *state = next;
        Ok(())
    }

    /// Takes a state to time `t`, forwards or backwards.
    ///
    /// # Errors
    /// Why the motion stops; the state is the last one reached.
    #[doc(hidden)]
    pub fn advance<S, const N: usize, const I: usize, const M: usize, const R: usize>(
        &mut self,
        mechanism: &S,
        state: &mut State<T, N>,
        t: T,
    ) -> Result<(), Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        for _ in 0..self.most {
            if state.t == t {
                return Ok(());
            }
            *state = self.next(mechanism, state, t)?;
        }
        Err(Stopped::TooManySteps { time: state.t })
    }

    /// Takes a state to the first instant before `t` at which `event` changes its sign, located to rounding, or to `t`. True if there is
    /// such an instant; an event at the beginning does not count.
    ///
    /// # Errors
    /// Why the motion stops; the state is the last one reached.
    #[doc(hidden)]
    pub fn advance_until<S, const N: usize, const I: usize, const M: usize, const R: usize>(
        &mut self,
        mechanism: &S,
        state: &mut State<T, N>,
        t: T,
        event: impl Fn(&State<T, N>) -> T,
    ) -> Result<bool, Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        let mut before = event(state);
        for _ in 0..self.most {
            if state.t == t {
                return Ok(false);
            }
            let next = self.next(mechanism, state, t)?;
            let after = event(&next);
            if before * after < T::ZERO || after == T::ZERO && before != T::ZERO {
                *state = locate(mechanism, state, next, (before, after), &event)?;
                return Ok(true);
            }
            (*state, before) = (next, after);
        }
        Err(Stopped::TooManySteps { time: state.t })
    }

    /// The state after the next accepted step, at `t` at the latest.
    fn next<S, const N: usize, const I: usize, const M: usize, const R: usize>(
        &mut self,
        mechanism: &S,
        state: &State<T, N>,
        t: T,
    ) -> Result<State<T, N>, Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        let rest = t - state.t;
        if !rest.is_finite() {
            return Err(Stopped::NotFinite { time: state.t });
        }
        let direction = if rest < T::ZERO { T::of(-1.0) } else { T::of(1.0) };
        if self.step == T::ZERO {
            self.step = first_step(mechanism, state);
        }
        loop {
            let wanted = least(self.step.abs(), self.longest);
            let is_last = wanted * T::of(1.0 + 1e-6) >= rest.abs();
            let h = if is_last { rest } else { direction * wanted };
            if h.abs() <= T::of(4.0) * T::of(f64::EPSILON) * state.t.abs() && !is_last || h.abs() < T::of(1e-290) {
                return Err(Stopped::StepTooShort { time: state.t });
            }
            let tried = stages(mechanism, state, h);
            self.evaluations += STAGES;
            let (error, fastest) = match &tried {
                Ok(stages) => error(mechanism, state, stages, h, (self.tolerance, self.fastest)),
                // A trial beyond what the joints allow is a step that is too long.
                Err(_) => (T::of(f64::INFINITY), self.fastest),
            };
            if error <= T::of(1.0) {
                let (mut next, reached) = after(mechanism, state, &tried?, h)?;
                keeps_rank(mechanism, state, &next, &reached)?;
                (self.accepted, self.fastest) = (self.accepted + 1, fastest);
                let grown = wanted * factor(error, 6.0);
                // A last step that was cut says nothing of the next one, unless it allows more.
                self.step = if is_last { self.step.abs().max(h.abs() * factor(error, 6.0)) } else { grown };
                if is_last {
                    next.t = t;
                }
                return Ok(next);
            }
            self.rejected += 1;
            self.step = h.abs() * factor(error, 1.0);
            if self.step <= T::of(4.0) * T::of(f64::EPSILON) * state.t.abs() || self.step < T::of(1e-290) {
                return Err(tried.err().unwrap_or(Stopped::StepTooShort { time: state.t }));
            }
        }
    }
}

/// Change of the step size for an error relative to the tolerance: its eighth root, with reserve.
fn factor<T: Float>(error: T, most: f64) -> T {
    if !error.is_finite() {
        return T::of(0.2);
    }
    let root = error.max(T::of(1e-12)).sqrt().sqrt().sqrt();
    least((T::of(0.9) / root).max(T::of(0.2)), T::of(most))
}

fn least<T: Float>(one: T, two: T) -> T {
    if two < one { two } else { one }
}

/// A step in which no coordinate moves by more than a hundredth of its scale.
fn first_step<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(mechanism: &S, state: &State<T, N>) -> T
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let (mut speed, mut acceleration) = (T::ZERO, T::ZERO);
    for (k, &place) in S::INTEGRATED.iter().enumerate() {
        speed = speed.max((state.qd[place] / lengths[k]).abs());
        acceleration = acceleration.max((state.qdd[place] / lengths[k]).abs());
    }
    let hundredth = T::of(0.01);
    let by_acceleration = (hundredth / acceleration.max(T::of(1e-8))).sqrt();
    least(hundredth / speed.max(T::of(1e-8)), by_acceleration)
}

/// Rates of the phase in each stage of a step.
fn stages<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    h: T,
) -> Result<[Phase<T, I>; STAGES], Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let pick = |vector: &SVector<T, N>| SVector::<T, I>::from_fn(|k, _| vector[S::INTEGRATED[k]]);
    let zero = SVector::from_element(T::ZERO);
    let mut rates = [[zero; 2]; STAGES];
    rates[0] = [pick(&state.qd), pick(&state.qdd)];
    let (mut q, mut qd, mut pivots) = (state.q, state.qd, None);
    for stage in 1..STAGES {
        let at = phase::<T, S, N, I, M, R>(state, &rates, STEPS[stage], h);
        for (k, &place) in S::INTEGRATED.iter().enumerate() {
            (q[place], qd[place]) = (at[0][k], at[1][k]);
        }
        let t = state.t + T::of(NODES[stage]) * h;
        rates[stage] = [at[1], accelerations(mechanism, (&q, &qd), t, &mut pivots)?];
    }
    Ok(rates)
}

/// y + h Σ a_j k_j
fn phase<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    state: &State<T, N>,
    rates: &[Phase<T, I>; STAGES],
    weights: &[(usize, f64)],
    h: T,
) -> Phase<T, I>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let sum = |part: usize, k: usize| weights.iter().fold(T::ZERO, |sum, (stage, weight)| sum + T::of(*weight) * rates[*stage][part][k]);
    let of = |vector: &SVector<T, N>, part: usize| SVector::from_fn(|k, _| vector[S::INTEGRATED[k]] + h * sum(part, k));
    [of(&state.q, 0), of(&state.qd, 1)]
}

/// Positions and speeds at the end of a step.
fn integrated<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    state: &State<T, N>,
    rates: &[Phase<T, I>; STAGES],
    h: T,
) -> (SVector<T, N>, SVector<T, N>)
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let at = phase::<T, S, N, I, M, R>(state, rates, &WEIGHTS, h);
    let (mut q, mut qd) = (state.q, state.qd);
    for (k, &place) in S::INTEGRATED.iter().enumerate() {
        (q[place], qd[place]) = (at[0][k], at[1][k]);
    }
    (q, qd)
}

/// The state after a step, brought back to where the equations hold.
fn after<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    rates: &[Phase<T, I>; STAGES],
    h: T,
) -> Result<(State<T, N>, Reached<T, M, I>), Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let ((mut q, mut qd), t) = (integrated::<T, S, N, I, M, R>(state, rates, h), state.t + h);
    let is_finite = |vector: &SVector<T, N>| vector.iter().all(|value| value.is_finite());
    if !(is_finite(&q) && is_finite(&qd)) {
        return Err(Stopped::NotFinite { time: t });
    }
    let reached = project(mechanism, (&mut q, &mut qd), |q| mechanism.constraints(q, t), |row| S::LEVELS[row])
        .map_err(|(row, _)| Stopped::Singular { time: t, joint: S::JOINTS.get(row).copied().unwrap_or_default() })?;
    let mut next = State::new(t, q, qd, state.qdd);
    refresh(mechanism, &mut next)?;
    Ok((next, reached))
}

/// J at the end of a step, with an order of its elimination.
type Reached<T, const M: usize, const I: usize> = (SMatrix<T, M, I>, Pivots<T, M, I>);

/// Below this part of its row an equation depends on the others.
const LOST: f64 = 1e-4;

/// Checks that the equations stay independent over a step.
///
/// # Errors
/// When they do not, and a joint whose equations depend on the others there.
fn keeps_rank<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    to: &State<T, N>,
    (jacobian, pivots): &Reached<T, M, I>,
) -> Result<(), Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let start = mechanism.constraints(&from.q, from.t).jacobian;
    if !has_other_signs(&start, jacobian, pivots) {
        return Ok(());
    }
    // Either these pivots are bad somewhere on the way, or all are.
    let (mut low, mut high, mut last) = (T::ZERO, to.t - from.t, start);
    for _ in 0..SEARCH {
        let h = (low + high) * T::of(0.5);
        // Near the instant a projection may lead to another branch: these places are those integrated.
        let there = stages(mechanism, from, h).map(|stages| {
            let (q, _) = integrated::<T, S, N, I, M, R>(from, &stages, h);
            mechanism.constraints(&q, from.t + h).jacobian
        });
        match there {
            Ok(there) if !has_other_signs(&start, &there, pivots) => (low, last) = (h, there),
            _ => high = h,
        }
        if (high - low).abs() <= T::of(f64::EPSILON) * (from.t.abs() + high.abs()) {
            break;
        }
    }
    let (row, left) = weakest(&last, &start, &lengths);
    if left > T::of(LOST) {
        return Ok(());
    }
    Err(Stopped::Singular { time: from.t + high, joint: S::JOINTS.get(row).copied().unwrap_or_default() })
}

/// Errors of steps add up: each may have this fraction of the tolerance.
const EACH: f64 = 0.02;

/// Estimated error of a step, relative to the tolerance, and the largest speed so far.
fn error<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    rates: &[Phase<T, I>; STAGES],
    h: T,
    (tolerance, mut fastest): (T, T),
) -> (T, T)
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let end = phase::<T, S, N, I, M, R>(state, rates, &WEIGHTS, h);
    for (k, &place) in S::INTEGRATED.iter().enumerate() {
        fastest = fastest.max((state.qd[place] / lengths[k]).abs()).max((end[1][k] / lengths[k]).abs());
    }
    let (mut fifth, mut third, allowed) = (T::ZERO, T::ZERO, T::of(EACH) * tolerance);
    for (k, &place) in S::INTEGRATED.iter().enumerate() {
        let value = (state.q[place] / lengths[k]).abs().max((end[0][k] / lengths[k]).abs()).max(T::of(1.0));
        let scales = [lengths[k] * value, lengths[k] * fastest.max(T::of(1e-30))];
        for (part, scale) in scales.into_iter().enumerate() {
            let sum = |weights: &[(usize, f64)]| {
                weights.iter().fold(T::ZERO, |sum, (stage, weight)| sum + T::of(*weight) * rates[*stage][part][k]) / (allowed * scale)
            };
            let (five, three) = (sum(&FIFTH), sum(&THIRD));
            fifth = fifth + five * five;
            third = third + three * three;
        }
    }
    if fifth == T::ZERO && third == T::ZERO {
        return (T::ZERO, fastest);
    }
    let count = T::of(2.0 * I as f64);
    let bound = fifth + T::of(0.01) * third;
    (h.abs() * fifth / (bound * count).sqrt(), fastest)
}

/// Most steps of the search for an event.
const SEARCH: usize = 60;

/// The state at which an event has the value zero, between two states.
fn locate<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    to: State<T, N>,
    values: (T, T),
    event: &impl Fn(&State<T, N>) -> T,
) -> Result<State<T, N>, Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    // Regula falsi with halved weights (Illinois), on the length of one step from the same state.
    let (mut low, mut high, mut found) = ((T::ZERO, values.0), (to.t - from.t, values.1), to);
    let mut last = T::ZERO;
    for _ in 0..SEARCH {
        if high.1 == T::ZERO || (high.0 - low.0).abs() <= T::of(f64::EPSILON) * (from.t.abs() + high.0.abs()) {
            break;
        }
        let h = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
        let stages = stages(mechanism, from, h)?;
        let (state, _) = after(mechanism, from, &stages, h)?;
        let value = event(&state);
        if value * high.1 > T::ZERO || value == T::ZERO {
            high = (h, value);
            found = state;
            low.1 = if last > T::ZERO { low.1 * T::of(0.5) } else { low.1 };
            last = T::of(1.0);
        } else {
            low = (h, value);
            high.1 = if last < T::ZERO { high.1 * T::of(0.5) } else { high.1 };
            last = T::of(-1.0);
        }
    }
    Ok(found)
}
