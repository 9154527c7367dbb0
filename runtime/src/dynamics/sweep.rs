//! States at given times.

use super::dense::Dense;
use super::equations::Dynamics;
use super::explicit::Explicit;
use super::integrator::Integrator;
use super::method::Method;
use super::project::Reached;
use super::rank::is_sharp;
use super::stopped::Stopped;
use crate::number::{Scalar, Time};
use crate::state::State;

/// States of a motion at given times: steps are as long as the tolerance allows, and states between their ends are interpolated.
///
/// After an error there are no more states.
#[derive(Clone)]
pub struct MotionSweep<'a, S, T, X, const N: usize, const I: usize, const M: usize, const R: usize, K = Explicit> {
    mechanism: &'a S,
    times: X,
    /// The end of the last step; `None` after an error.
    state: Option<State<T, N>>,
    /// Why there is no state to begin with.
    stopped: Option<Stopped<T>>,
    /// The last step.
    step: Option<Dense<T, N, I>>,
    /// J at its end.
    reached: Option<Reached<T, M, I>>,
    integrator: Integrator<T, K>,
}

impl<'a, S, T, X, const N: usize, const I: usize, const M: usize, const R: usize, K: Method> MotionSweep<'a, S, T, X, N, I, M, R, K>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    /// Begins at a state.
    #[doc(hidden)]
    pub fn new(mechanism: &'a S, start: Result<State<T, N>, Stopped<T>>, times: X, integrator: Integrator<T, K>) -> Self {
        let (state, stopped) = match start {
            Ok(state) => (Some(state), None),
            Err(stopped) => (None, Some(stopped)),
        };
        Self { mechanism, times, state, stopped, step: None, reached: None, integrator }
    }

    /// The state at a time; afterwards `state` is the end of the step that holds it.
    fn reach(&mut self, state: &mut State<T, N>, t: T) -> Result<State<T, N>, Stopped<T>> {
        if !t.is_finite() {
            return Err(Stopped::NotFinite { time: t });
        }
        if self.step.is_none() {
            self.integrator.begin(self.mechanism, state, t)?;
        }
        let mut is_short = false;
        for _ in 0..self.integrator.most {
            if state.t == t {
                return match &self.reached {
                    Some(reached) => is_sharp(self.mechanism, t, reached).map(|()| state.clone()),
                    None => Ok(state.clone()),
                };
            }
            if let Some(step) = self.step.as_ref().filter(|step| step.contains(t)) {
                let tolerance = (self.integrator.tolerance, self.integrator.fastest);
                let found = step.at(self.mechanism, self.reached.as_ref().map(|reached| &reached.pivots), t, tolerance);
                match found {
                    Err(Stopped::NotFinite { .. }) | Ok(_) => return found,
                    Err(_) if is_short => return found,
                    Err(_) => {}
                }
                // Something moves within the step and is at rest at its ends: the steps to this time begin where it began.
                *state = step.beginning();
                (self.step, self.reached, is_short) = (None, None, true);
            }
            let whole = if t < state.t { T::of(f64::NEG_INFINITY) } else { T::of(f64::INFINITY) };
            // Steps that do not know their stages end at the times.
            let beyond = if K::IS_DENSE && !is_short { whole } else { t };
            let before = self.integrator;
            let (next, rates) = match self.integrator.next(self.mechanism, state, &mut self.reached, beyond) {
                Ok(found) => found,
                // A stop of the motion after this time does not matter.
                Err(_) => {
                    self.integrator = before;
                    self.integrator.next(self.mechanism, state, &mut self.reached, t)?
                }
            };
            // Derivatives jump where a force does, and no polynomial leads across: such a step ends at the time, on one side of the jump.
            let is_within = (t - state.t).abs() < (next.t - state.t).abs() && !is_short;
            if T::HAS_DERIVATIVES && is_within && before.may_hide_jump(next.t - state.t, self.integrator.rejected > before.rejected) {
                (self.integrator, self.step, self.reached, is_short) = (before, None, None, true);
                continue;
            }
            self.step = match rates {
                Some(rates) => Some(Dense::new(self.mechanism, state, &next, &rates)?),
                None => None,
            };
            *state = next;
        }
        Err(Stopped::TooManySteps { time: state.t })
    }
}

impl<S, T, X, const N: usize, const I: usize, const M: usize, const R: usize, K: Method> Iterator
    for MotionSweep<'_, S, T, X, N, I, M, R, K>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
    X: Iterator<Item: Time<T>>,
{
    type Item = Result<State<T, N>, Stopped<T>>;

    fn next(&mut self) -> Option<Self::Item> {
        let t = self.times.next()?.time();
        if let Some(stopped) = self.stopped.take() {
            return Some(Err(stopped));
        }
        let mut state = self.state.take()?;
        let found = self.reach(&mut state, t);
        if found.is_ok() {
            self.state = Some(state);
        }
        Some(found)
    }
}
