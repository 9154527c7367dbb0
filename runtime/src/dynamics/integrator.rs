//! Integration in time.

use core::marker::PhantomData;

use super::changed::accelerate;
use super::equations::Dynamics;
use super::event::first_event;
use super::explicit::Explicit;
use super::jump::no_speed_jumps;
use super::method::Method;
use super::project::Reached;
use super::rank::{is_sharp, is_sharp_at, keeps_rank, too_short};
use super::step::{INSTANT, error, first_step, is_instant, land};
use super::stiff::Stiff;
use super::stopped::Stopped;
use super::switch::with_derivatives_of_instant;
use super::tableau::Rates;
use crate::number::Scalar;
use crate::number::order::smaller;
use crate::state::State;

/// Steps of a motion: their tolerance, size, and counts of evaluations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integrator<T = f64, K = Explicit> {
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
    /// Longest step of all calls so far, in s.
    #[doc(hidden)]
    pub longest_made: T,
    /// Number of steps in a row, up to the last one, that were as short as the instant of a jump.
    #[doc(hidden)]
    pub instants: usize,
    /// Time and value of the event that stopped the motion last.
    #[doc(hidden)]
    pub stopped: Option<(T, T)>,
    /// How steps are made.
    #[doc(hidden)]
    pub method: PhantomData<K>,
}

impl<T: Scalar> Integrator<T> {
    /// Steps with this relative error, from 1e-4 to 1e-13: explicit, of order 8 (Dormand and Prince).
    #[must_use]
    pub fn new(tolerance: T) -> Self {
        let longest = T::of(f64::INFINITY);
        let (step, fastest) = (T::ZERO, T::ZERO);
        Self {
            tolerance,
            longest,
            most: 1_000_000,
            step,
            fastest,
            accepted: 0,
            rejected: 0,
            evaluations: 0,
            longest_made: T::ZERO,
            instants: 0,
            stopped: None,
            method: PhantomData,
        }
    }
}

impl<T: Scalar> Integrator<T, Stiff> {
    /// Steps for stiff motions with this relative error, from 1e-2 to 1e-8: linearly implicit, of order 4, and L-stable (Hairer and Wanner's
    /// RODAS). Springs and dampers whose oscillations have died out do not bound their length.
    #[must_use]
    pub fn stiff(tolerance: T) -> Self {
        let Integrator { longest, most, step, fastest, accepted, rejected, evaluations, longest_made, instants, .. } =
            Integrator::new(tolerance);
        Self {
            tolerance,
            longest,
            most,
            step,
            fastest,
            accepted,
            rejected,
            evaluations,
            longest_made,
            instants,
            stopped: None,
            method: PhantomData,
        }
    }
}

impl<T: Scalar, K: Method> Integrator<T, K> {
    /// Takes a state to time `t`, forwards or backwards, as long as `goes_on` says so of the state after each step. True if the time is
    /// reached.
    ///
    /// # Errors
    /// Why the motion stops; the state is the last one reached.
    #[doc(hidden)]
    pub fn advance_while<S, const N: usize, const I: usize, const M: usize, const R: usize>(
        &mut self,
        mechanism: &S,
        state: &mut State<T, N>,
        t: T,
        mut goes_on: impl FnMut(&State<T, N>) -> bool,
    ) -> Result<bool, Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        self.begin(mechanism, state, t)?;
        let mut reached = None;
        for _ in 0..self.most {
            if state.t == t {
                return Ok(true);
            }
            let next = self.next(mechanism, state, &mut reached, t)?.0;
            if let Some(reached) = reached.as_ref().filter(|_| next.t == t) {
                is_sharp(mechanism, t, reached)?;
            }
            *state = next;
            if !goes_on(state) {
                return Ok(state.t == t);
            }
        }
        if state.t == t { Ok(true) } else { Err(Stopped::TooManySteps { time: state.t }) }
    }

    /// Checks the time that is asked for, and computes the accelerations of the state: parameters may have changed since.
    pub(super) fn begin<S, const N: usize, const I: usize, const M: usize, const R: usize>(
        &mut self,
        mechanism: &S,
        state: &mut State<T, N>,
        t: T,
    ) -> Result<(), Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        let has_tolerance = self.tolerance > T::ZERO && self.tolerance.is_finite();
        for (field, value, is_good) in [
            ("tolerance", self.tolerance, has_tolerance),
            ("longest", self.longest, self.longest > T::ZERO),
            ("step", self.step, self.step.is_finite()),
            ("fastest", self.fastest, self.fastest.is_finite()),
        ] {
            if !is_good {
                return Err(Stopped::BadIntegrator { field, value });
            }
        }
        let rest = t - state.t;
        if !rest.is_finite() {
            return Err(Stopped::NotFinite { time: t });
        }
        accelerate(mechanism, state)?;
        if self.step == T::ZERO && rest != T::ZERO {
            // From rest a long first step would miss a pulse that comes later; one that rounds to no time makes no way.
            let first = smaller(first_step(mechanism, state), T::of(FIRST) * rest.abs());
            self.step = first.max(T::of(INSTANT) * T::EPSILON * state.t.abs()).without_derivatives();
        }
        Ok(())
    }

    /// Takes a state to the first instant before `t` at which `event` changes its sign, located to rounding, or to `t`. True if there is
    /// such an instant; an event at the beginning does not count, nor one at which the same integrator stopped. The event is looked at eight
    /// times a step, and more closely where it turns back near zero. It has to be smooth on the scale of a step; otherwise `longest` has to be
    /// shorter.
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
        let (mut reached, mut end, mut approaches, mut locked) = (None, t, 0, None);
        for _ in 0..self.most {
            if state.t == t {
                return Ok(false);
            }
            let (next, _, jumps) = match self.stepped(mechanism, state, &mut reached, end) {
                // An event before joints lock is found.
                Err(stopped @ Stopped::Singular { time, .. }) if approaches < APPROACHES => {
                    end = state.t + T::of(NEARLY) * (time - state.t);
                    if end == state.t {
                        return Err(locked.unwrap_or(stopped));
                    }
                    (approaches, locked) = (approaches + 1, Some(stopped));
                    continue;
                }
                // The place is known best from the last step that led across it.
                stepped => stepped.map_err(|stopped| locked.unwrap_or(stopped))?,
            };
            end = t;
            let (between, tolerance) = ((&*state, &next, self.stopped), (self.tolerance, self.fastest));
            let found = first_event::<K, T, S, N, I, M, R>(mechanism, between, &event, tolerance)?;
            // An event before speeds jump is found.
            let is_after = |jump: &Stopped<T>, found: &State<T, N>| match jump {
                Stopped::SpeedJumps { time, .. } => (found.t - state.t).abs() >= (*time - state.t).abs(),
                _ => true,
            };
            match (found, jumps) {
                (None, jumps) => jumps?,
                (Some(found), Err(jump)) if is_after(&jump, &found) => return Err(jump),
                (Some(found), _) => {
                    is_sharp_at(mechanism, &found.q, found.t)?;
                    self.stopped = Some((found.t, event(&found)));
                    *state = found;
                    return Ok(true);
                }
            }
            if let Some(reached) = reached.as_ref().filter(|_| next.t == t) {
                is_sharp(mechanism, t, reached)?;
            }
            *state = next;
        }
        if state.t == t { Ok(false) } else { Err(Stopped::TooManySteps { time: state.t }) }
    }

    /// The state after the next accepted step, within which no speed jumps, at `t` at the latest, and the rates in the stages of an explicit step.
    #[allow(clippy::type_complexity)] // A state and rates.
    pub(super) fn next<S, const N: usize, const I: usize, const M: usize, const R: usize>(
        &mut self,
        mechanism: &S,
        state: &State<T, N>,
        reached: &mut Option<Reached<T, M, I>>,
        t: T,
    ) -> Result<(State<T, N>, Option<Rates<T, I>>), Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        let (next, rates, jumps) = self.stepped(mechanism, state, reached, t)?;
        jumps.map(|()| (next, rates))
    }

    /// True if a force may jump within a step: longer ones were tried, or were made before.
    pub(super) fn may_hide_jump(&self, h: T, is_shortened: bool) -> bool {
        is_shortened || h.abs() <= T::of(SHORTENED) * self.longest_made
    }

    /// The state after the next accepted step, the rates in its stages, and separately whether a speed jumps within it.
    ///
    /// * `reached`: given, the equations at the end of the step before, if there is one; returned, those at the end of this step.
    #[allow(clippy::type_complexity)] // A state and rates.
    fn stepped<S, const N: usize, const I: usize, const M: usize, const R: usize>(
        &mut self,
        mechanism: &S,
        state: &State<T, N>,
        reached: &mut Option<Reached<T, M, I>>,
        t: T,
    ) -> Result<(State<T, N>, Option<Rates<T, I>>, Result<(), Stopped<T>>), Stopped<T>>
    where
        S: Dynamics<T, N, I, M, R>,
    {
        let rest = t - state.t;
        let direction = if rest < T::ZERO { T::of(-1.0) } else { T::of(1.0) };
        let mut there = Reached::empty();
        let (mut is_shortened, mut longest) = (false, self.longest_made);
        loop {
            let wanted = smaller(self.step.abs(), self.longest.abs());
            let is_last = wanted * T::of(1.0 + 1e-6) >= rest.abs();
            let h = if is_last { rest } else { direction * wanted };
            // Before the first step it is the longest one tried: what counts as a slow speed does not depend on rejections.
            longest = if longest == T::ZERO { h.without_derivatives().abs() } else { longest };
            if h.abs() <= T::of(4.0) * T::EPSILON * state.t.abs() && !is_last || h.abs() < T::of(SHORTEST) {
                return Err(too_short(mechanism, state));
            }
            self.evaluations += K::evaluations(I);
            // If the joints do not allow the trial state, the step is too long.
            let mut error_and_speed = (T::of(f64::INFINITY), self.fastest);
            let tried = K::trial(mechanism, state, h).and_then(|trial| {
                error_and_speed =
                    error(mechanism, state, &trial, h, (self.tolerance, self.fastest), (longest, is_shortened && self.instants < INSTANTS));
                let is_accepted = error_and_speed.0 <= T::of(1.0);
                if is_accepted {
                    let tolerance = (self.tolerance, self.fastest);
                    land(mechanism, (state, reached.as_ref()), &trial, h, tolerance, &mut there).map(|next| Some((next, trial.rates)))
                } else {
                    Ok(None)
                }
            });
            let (error, fastest) = error_and_speed;
            if let Ok(Some((mut next, rates))) = tried {
                keeps_rank::<K, T, S, N, I, M, R>(mechanism, (state, reached.as_ref()), (&next, &there))?;
                if T::HAS_DERIVATIVES && self.may_hide_jump(h, is_shortened) {
                    with_derivatives_of_instant(mechanism, (state, self.longest_made), &mut next, &mut there)?;
                }
                *reached = Some(there);
                (self.accepted, self.fastest) = (self.accepted + 1, fastest);
                self.longest_made = self.longest_made.max(h.without_derivatives().abs());
                self.instants = if is_instant(h, state.t) && !is_last { self.instants + 1 } else { 0 };
                let grown = wanted * factor::<T, K>(error, 6.0);
                // A last step, which was cut to end at `t`, may lengthen the next one, but not shorten it.
                self.step = if is_last { self.step.abs().max(h.without_derivatives().abs() * factor::<T, K>(error, 6.0)) } else { grown };
                if is_last {
                    next.values.t = t;
                }
                let jumps = no_speed_jumps(mechanism, state, &next);
                return Ok((next, rates, jumps));
            }
            self.rejected += 1;
            is_shortened = true;
            let shorter = if tried.is_err() { T::of(0.2) } else { factor::<T, K>(error, 1.0) };
            // A driven speed may jump: a step as short as an instant is tried before none is short enough.
            let least = if M == I + S::REDUNDANT && !is_instant(h, state.t) { T::of(0.75 * INSTANT) } else { T::ZERO };
            self.step = (h.abs() * shorter).max(least * T::EPSILON * state.t.abs()).without_derivatives();
            if self.step <= T::of(4.0) * T::EPSILON * state.t.abs() || self.step < T::of(SHORTEST) {
                return Err(tried.err().unwrap_or_else(|| too_short(mechanism, state)));
            }
        }
    }
}

/// Most steps to the place where joints lock, and the part of the way that each makes.
const APPROACHES: usize = 8;
const NEARLY: f64 = 0.9;

/// Longest first step, as a fraction of the time to be covered.
const FIRST: f64 = 0.01;

/// A force that jumps shortens steps to less than this part of the longest one.
const SHORTENED: f64 = 1e-3;

/// Change of the step size for an error relative to the tolerance: its eighth or fourth root, with reserve.
fn factor<T: Scalar, K: Method>(error: T, most: f64) -> T {
    let error = error.without_derivatives();
    if !error.is_finite() {
        return T::of(0.2);
    }
    let root = (0..K::ROOTS).fold(error.max(T::of(1e-12)), |root, _| root.sqrt());
    smaller((T::of(0.9) / root).max(T::of(0.2)), T::of(most))
}

/// Most steps in a row in which a force may jump. Towards an infinite force there would be ever more.
const INSTANTS: usize = 4;

/// No step is shorter, in s.
const SHORTEST: f64 = 1e-35;
