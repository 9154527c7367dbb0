//! Integration in time.

use nalgebra::{SMatrix, SVector};

use super::accelerate::{accelerations, lengths, singular};
use super::equations::Dynamics;
use super::partition::{Pivots, has_other_signs, weakest};
use super::places::{largest, picked, put};
use super::project::{initial_state, levels, project, refresh};
use super::stopped::Stopped;
use super::tableau::{STAGES, errors, node, stage, step};
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

/// Rates of positions and of speeds, of each integrated coordinate in all stages.
type Rates<T, const I: usize> = [[[T; STAGES]; I]; 2];

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
        // Parameters may have changed since the accelerations were computed.
        let mut start = state.clone();
        refresh(mechanism, &mut start)?;
        let stages = stages(mechanism, &start, h)?;
        let (next, reached) = after(mechanism, &start, &stages, h)?;
        keeps_rank(mechanism, &start, &next, &reached)?;
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
        self.begin(mechanism, state, t)?;
        for _ in 0..self.most {
            if state.t == t {
                return Ok(());
            }
            *state = self.next(mechanism, state, t)?;
        }
        if state.t == t { Ok(()) } else { Err(Stopped::TooManySteps { time: state.t }) }
    }

    /// Checks the time that is asked for, and computes the accelerations of the state: parameters may have changed since.
    fn begin<S, const N: usize, const I: usize, const M: usize, const R: usize>(
        &mut self,
        mechanism: &S,
        state: &mut State<T, N>,
        t: T,
    ) -> Result<(), Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        let rest = t - state.t;
        if !rest.is_finite() {
            return Err(Stopped::NotFinite { time: t });
        }
        if rest == T::ZERO {
            return Ok(());
        }
        refresh(mechanism, state)?;
        if self.step == T::ZERO {
            // A pulse that comes later is not to be stepped over from rest.
            self.step = least(first_step(mechanism, state), T::of(FIRST) * rest.abs());
        }
        Ok(())
    }

    /// Takes a state to the first instant before `t` at which `event` changes its sign, located to rounding, or to `t`. True if there is
    /// such an instant; an event at the beginning does not count. The event is looked at eight times a step: where it changes its sign
    /// twice in between, `longest` has to be shorter.
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
        self.begin(mechanism, state, t)?;
        for _ in 0..self.most {
            if state.t == t {
                return Ok(false);
            }
            let next = self.next(mechanism, state, t)?;
            if let Some(found) = first_event(mechanism, state, &next, &event)? {
                *state = found;
                return Ok(true);
            }
            *state = next;
        }
        if state.t == t { Ok(false) } else { Err(Stopped::TooManySteps { time: state.t }) }
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
        let direction = if rest < T::ZERO { T::of(-1.0) } else { T::of(1.0) };
        loop {
            let wanted = least(self.step.abs(), self.longest.abs());
            let is_last = wanted * T::of(1.0 + 1e-6) >= rest.abs();
            let h = if is_last { rest } else { direction * wanted };
            if h.abs() <= T::of(4.0) * T::EPSILON * state.t.abs() && !is_last || h.abs() < T::of(SHORTEST) {
                return Err(Stopped::StepTooShort { time: state.t });
            }
            self.evaluations += STAGES;
            // A trial beyond what the joints allow is a step that is too long.
            let mut error_and_speed = (T::of(f64::INFINITY), self.fastest);
            let tried = stages(mechanism, state, h).and_then(|stages| {
                error_and_speed = error(mechanism, state, &stages, h, (self.tolerance, self.fastest));
                if error_and_speed.0 <= T::of(1.0) { after(mechanism, state, &stages, h).map(Some) } else { Ok(None) }
            });
            let (error, fastest) = error_and_speed;
            if let Ok(Some((mut next, reached))) = tried {
                keeps_rank(mechanism, state, &next, &reached)?;
                (self.accepted, self.fastest) = (self.accepted + 1, fastest);
                let grown = wanted * factor(error, 6.0);
                // A last step that was cut says nothing of the next one, unless it allows more.
                self.step = if is_last { self.step.abs().max(h.abs() * factor(error, 6.0)) } else { grown };
                if is_last {
                    next.values.t = t;
                }
                return Ok(next);
            }
            self.rejected += 1;
            let shorter = if tried.is_err() { T::of(0.2) } else { factor(error, 1.0) };
            self.step = h.abs() * shorter;
            if self.step <= T::of(4.0) * T::EPSILON * state.t.abs() || self.step < T::of(SHORTEST) {
                return Err(tried.err().unwrap_or(Stopped::StepTooShort { time: state.t }));
            }
        }
    }
}

/// Part of the way that the first step is at most.
const FIRST: f64 = 0.01;

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
    let [speed, acceleration] = [&state.qd, &state.qdd].map(|vector| largest(&picked(vector, &S::INTEGRATED), &lengths));
    let hundredth = T::of(0.01);
    let by_acceleration = (hundredth / acceleration.max(T::of(1e-8))).sqrt();
    least(hundredth / speed.max(T::of(1e-8)), by_acceleration)
}

/// Rates in each stage of a step.
fn stages<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    h: T,
) -> Result<Rates<T, I>, Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let [q, u, a] = [&state.q, &state.qd, &state.qdd].map(|vector| picked(vector, &S::INTEGRATED));
    let mut rates = [[[T::ZERO; STAGES]; I]; 2];
    let enter = |rates: &mut Rates<T, I>, stage: usize, found: [&[T; I]; 2]| {
        for (of, found) in rates.iter_mut().zip(found) {
            for (of, found) in of.iter_mut().zip(found) {
                if let Some(rate) = of.get_mut(stage) {
                    *rate = *found;
                }
            }
        }
    };
    enter(&mut rates, 0, [&u, &a]);
    let (mut there, mut moving, mut pivots) = (state.q, state.qd, None);
    for number in 1..STAGES {
        let at: [T; I] = core::array::from_fn(|k| q[k] + h * stage(number, &rates[0][k]));
        let speeds: [T; I] = core::array::from_fn(|k| u[k] + h * stage(number, &rates[1][k]));
        put(&mut there, &S::INTEGRATED, &at);
        put(&mut moving, &S::INTEGRATED, &speeds);
        let found = accelerations(mechanism, (&there, &moving), state.t + node::<T>(number) * h, &mut pivots)?;
        enter(&mut rates, number, [&speeds, &found]);
    }
    Ok(rates)
}

/// Positions and speeds at the end of a step.
fn integrated<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    state: &State<T, N>,
    rates: &Rates<T, I>,
    h: T,
) -> (SVector<T, N>, SVector<T, N>)
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let (mut q, mut qd) = (state.q, state.qd);
    for (vector, rates) in [&mut q, &mut qd].into_iter().zip(rates) {
        let before = picked(vector, &S::INTEGRATED);
        put(vector, &S::INTEGRATED, &core::array::from_fn(|k| before[k] + h * step(&rates[k])));
    }
    (q, qd)
}

/// The state after a step, brought back to where the equations hold.
fn after<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    rates: &Rates<T, I>,
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
    let reached = project(mechanism, (&mut q, &mut qd), |q| mechanism.constraints(q, t), levels::<T, S, N, I, M, R>)
        .map_err(|open| singular::<T, S, N, I, M, R>(t, open.row()))?;
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
        if (high - low).abs() <= T::EPSILON * (from.t.abs() + high.abs()) {
            break;
        }
    }
    // Where rank is lost rows may vanish: they are compared with what they are where the mechanism is assembled.
    let assembled = mechanism.constraints(&mechanism.start(), from.t).jacobian;
    let (row, left) = weakest(&last, &assembled, &lengths);
    if left > T::of(LOST) {
        return Ok(());
    }
    Err(singular::<T, S, N, I, M, R>(from.t + high, row))
}

/// No step is shorter, in s.
const SHORTEST: f64 = 1e-35;

/// A speed counts as none if it takes a thousand steps for a radian, or for L.
const SLOW: f64 = 1e-3;

/// Errors of steps add up: each may have this fraction of the tolerance.
const EACH: f64 = 0.02;

/// Estimated error of a step, relative to the tolerance, and the largest speed so far.
fn error<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    rates: &Rates<T, I>,
    h: T,
    (tolerance, mut fastest): (T, T),
) -> (T, T)
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let (end, moving) = integrated::<T, S, N, I, M, R>(state, rates, h);
    for vector in [&state.qd, &moving] {
        fastest = fastest.max(largest(&picked(vector, &S::INTEGRATED), &lengths));
    }
    let [before, after] = [&state.q, &end].map(|vector| picked(vector, &S::INTEGRATED));
    let (mut fifth, mut third, allowed) = (T::ZERO, T::ZERO, T::of(EACH) * tolerance);
    for k in 0..I {
        let value = (before[k] / lengths[k]).abs().max((after[k] / lengths[k]).abs()).max(T::of(1.0));
        for (rates, scale) in rates.iter().zip([value, fastest.max(T::of(SLOW) / h.abs())]) {
            let [five, three] = errors(&rates[k]).map(|error| error / (allowed * scale * lengths[k]));
            (fifth, third) = (fifth + five * five, third + three * three);
        }
    }
    if fifth == T::ZERO && third == T::ZERO {
        return (T::ZERO, fastest);
    }
    let count = T::of(2.0) * (0..I).fold(T::ZERO, |count, _| count + T::of(1.0));
    let bound = fifth + T::of(0.01) * third;
    (h.abs() * fifth / (bound * count).sqrt(), fastest)
}

/// Most steps of the search for an instant.
const SEARCH: usize = 60;

/// How often an event is looked at in a step.
const LOOKS: usize = 8;

/// The first state between two others at which an event changes its sign; none if it does not.
fn first_event<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    to: &State<T, N>,
    event: &impl Fn(&State<T, N>) -> T,
) -> Result<Option<State<T, N>>, Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let whole = to.t - from.t;
    let is_other = |one: T, two: T| one < T::ZERO && two >= T::ZERO || one > T::ZERO && two <= T::ZERO;
    let (mut low, mut part) = ((T::ZERO, event(from)), T::ZERO);
    for look in 1..=LOOKS {
        part = part + T::of(1.0 / LOOKS as f64);
        let value = if look == LOOKS { event(to) } else { event(&between(mechanism, from, to, part)) };
        if !(low.1.is_finite() && value.is_finite()) {
            return Err(Stopped::NotFinite { time: from.t + part * whole });
        }
        let high = (part * whole, value);
        if is_other(low.1, high.1) {
            let found = locate(mechanism, from, (low, high), event)?;
            if found.is_some() {
                return Ok(found);
            }
        }
        low = high;
    }
    Ok(None)
}

/// A state on the way between two others, by the polynomials of degree five through their positions, speeds and accelerations.
fn between<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    to: &State<T, N>,
    part: T,
) -> State<T, N>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let h = to.t - from.t;
    let [from_q, from_u, from_a] = [&from.q, &from.qd, &from.qdd].map(|vector| picked(vector, &S::INTEGRATED));
    let [to_q, to_u, to_a] = [&to.q, &to.qd, &to.qdd].map(|vector| picked(vector, &S::INTEGRATED));
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
        put(vector, &S::INTEGRATED, values);
    }
    let t = from.t + part * h;
    let [q, qd, qdd] = mechanism.complete(&vectors[0], &vectors[1], &vectors[2], t);
    State::new(t, q, qd, qdd)
}

/// The state at which an event has the value zero, by steps from the same state; none if its values there do not differ in sign.
fn locate<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    (low, high): ((T, T), (T, T)),
    event: &impl Fn(&State<T, N>) -> T,
) -> Result<Option<State<T, N>>, Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let at = |h: T| {
        let stages = stages(mechanism, from, h)?;
        after(mechanism, from, &stages, h).map(|(state, _)| (h, event(&state), state))
    };
    let mut found = at(high.0)?;
    let mut high = (high.0, found.1);
    let mut low = if low.0 == T::ZERO { low } else { at(low.0).map(|(h, value, _)| (h, value))? };
    if low.1 < T::ZERO && high.1 < T::ZERO || low.1 > T::ZERO && high.1 > T::ZERO {
        return Ok(None);
    }
    // Regula falsi with halved weights (Illinois).
    let mut last = T::ZERO;
    for _ in 0..SEARCH {
        if high.1 == T::ZERO || (high.0 - low.0).abs() <= T::EPSILON * (from.t.abs() + high.0.abs()) {
            break;
        }
        let here = at((low.0 * high.1 - high.0 * low.1) / (high.1 - low.1))?;
        let is_like_high = here.1 == T::ZERO || (here.1 > T::ZERO) == (high.1 > T::ZERO);
        if is_like_high {
            high = (here.0, here.1);
            found = here;
            low.1 = if last > T::ZERO { low.1 * T::of(0.5) } else { low.1 };
            last = T::of(1.0);
        } else {
            low = (here.0, here.1);
            high.1 = if last < T::ZERO { high.1 * T::of(0.5) } else { high.1 };
            last = T::of(-1.0);
        }
    }
    Ok(Some(found.2))
}
