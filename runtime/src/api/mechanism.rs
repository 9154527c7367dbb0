//! The interface of a mechanism: solving, following, error bounds, derivatives.

use nalgebra::SVector;

use super::gradient::{self, Gradient};
use super::sweep::Sweep;
#[cfg(feature = "certify")]
use crate::enclosure::{self, Certificate, Doubt, Enclosure, ErrorBound};
use crate::explain::{Failure, verdict};
use crate::names::Cause;
use crate::number::{Float, Times};
use crate::path::{self, Unassembled};
use crate::solve::{Family, Followed, Stages};
use crate::state::{HasState, State};

/// A mechanism with as many equations as coordinates, which can be solved. Everything with [`Stages`] is one.
///
/// Methods that take a time return the state at that time, with q, q̇ and q̈ at the rounding limit.
/// They fail with the [`Cause`] and the last valid state, and never panic.
pub trait Mechanism<T: Float, const N: usize>: Stages<T, N> {
    /// The state at `t` (s) on the branch of the declared start: assembled at t = 0, then followed in time; the run time grows with
    /// `t`. Parameters that differ from the defaults are reached by continuation as well; if the branch ends before them,
    /// [`Failure::end`] gives this point.
    ///
    /// # Errors
    /// Any [`Cause`]. For many times in order, [`sweep`](Self::sweep) does not begin at zero again and again.
    fn solve(&self, t: T) -> Result<State<T, N>, Failure<T, N>>
    where
        Self: Sized,
    {
        let mut state = path::assemble(self).map_err(|Unassembled { cause, end, last }| {
            let time = T::of(0.0);
            Failure { mechanism: Self::NAME, cause, time, end, last }
        })?;
        if t != state.t {
            self.advance(&mut state, t)?;
        }
        Ok(state)
    }

    /// The state at `t` (s) that Newton's method finds from a rough `guess` of q (m, rad), on any branch.
    ///
    /// # Errors
    /// Any [`Cause`] but `BranchLost` and `TooManySteps`.
    fn solve_near(&self, t: T, guess: &SVector<T, N>) -> Result<State<T, N>, Failure<T, N>> {
        let fail = |cause| Failure { mechanism: Self::NAME, cause, time: t, end: None, last: None };
        path::assemble_near(self, t, guess).map_err(fail)
    }

    /// The state at `t` (s) on the branch of `from`, a state of this mechanism with these parameters.
    ///
    /// # Errors
    /// Any [`Cause`].
    fn solve_from(&self, t: T, from: &State<T, N>) -> Result<State<T, N>, Failure<T, N>> {
        self.validate().map_err(|parameter| {
            let cause = Cause::ParameterOutOfRange(parameter);
            Failure { mechanism: Self::NAME, cause, time: t, end: None, last: Some(from.clone()) }
        })?;
        let mut state = from.clone();
        self.advance(&mut state, t)?;
        Ok(state)
    }

    /// Takes a state of this mechanism to time `t` (s) in place: [`solve_from`](Self::solve_from) without a copy, for time-critical
    /// loops. If that fails, the state is unchanged.
    ///
    /// # Errors
    /// Any [`Cause`].
    #[inline]
    fn advance(&self, state: &mut State<T, N>, t: T) -> Result<(), Failure<T, N>> {
        // One step is the usual case.
        if path::step(self, state, t) {
            return Ok(());
        }
        by_steps(self, state, t)
    }

    /// Takes a state of this mechanism to time `t` (s) by one warm step: whether that was enough. If not, the state is unchanged.
    ///
    /// Where [`advance`](Self::advance) makes shorter steps, or looks for what follows a dead point, this gives up. Its time is bounded, and its
    /// code is a tenth as large, for programs on small machines that bring their first state along. A state that it reaches is the one that
    /// `advance` reaches.
    #[inline]
    fn advance_once(&self, state: &mut State<T, N>, t: T) -> bool {
        path::step(self, state, t)
    }

    /// Bounds of the distance of a state from the solution next to it, for each coordinate and its rates. The bounds are sharp to
    /// about ten digits.
    ///
    /// The solution meant is that of the declared equations with these parameters and this time, each number taken as the exact value of
    /// its double; if `T` is `f32`, the bound covers all errors of computing with `f32`. The solution is enclosed by interval arithmetic
    /// with centres of 32 digits ([`Enclosure`](crate::Enclosure)), which takes as long as some four hundred steps per call.
    ///
    /// ```
    /// use reuleaux::Mechanism;
    ///
    /// reuleaux::mechanism! {
    ///     /// Two bars between a pivot and a slider that is almost as far away as they can reach.
    ///     mechanism Toggle {
    ///         ground { point O = (0, 0);  axis rail = (1, 0); }
    ///         body near   { point O = (0, 0);  point A = (1m, 0);  start angle = 1mrad; }
    ///         body far    { point A = (0, 0);  point B = (1m, 0);  start angle = -1mrad; }
    ///         body slider { point B = (0, 0); }
    ///         joint o = revolute(ground.O, near.O);
    ///         joint a = revolute(near.A, far.A);
    ///         joint b = revolute(far.B, slider.B);
    ///         joint rail = translational(ground.rail, ground.O, slider.B);
    ///         drive push = drive_x(slider.B, 2m - 1um - 1m_s * t);
    ///     }
    /// }
    ///
    /// let toggle = Toggle::default();
    /// let mut state = toggle.solve(0.0)?;
    /// let before = toggle.error_bound(&state)?.qd.amax();
    /// assert!(before > 1e-10 && before < 1e-6);    // of 500 rad/s
    ///
    /// toggle.polish(&mut state.0)?;
    /// assert!(toggle.error_bound(&state)?.qd.amax() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If no solution can be proven to be near.
    #[cfg(feature = "certify")]
    fn error_bound(&self, state: &impl HasState<T, N>) -> Result<ErrorBound<T, N>, Doubt>
    where
        Self: Family<T>,
        Self::Over<Enclosure>: Stages<Enclosure, N>,
    {
        enclosure::error_bound(self, state.as_state())
    }

    /// Proves that there is exactly one solution within a radius of a state, and returns the radius.
    ///
    /// The proof is Krawczyk's: an operator that maps a box around the state into itself, block by block, in [interval
    /// arithmetic](crate::Enclosure) with all roundings counted. It holds for the declared equations, each number taken as the exact
    /// value of its double. Equations of redundant joints, which follow from the others, are checked but not proven.
    ///
    /// # Errors
    /// Why there is no proof. A state without a solution within the radius is never certified.
    #[cfg(feature = "certify")]
    fn certify(&self, state: &impl HasState<T, N>) -> Result<Certificate<T, N>, Doubt>
    where
        Self: Family<T>,
        Self::Over<Enclosure>: Stages<Enclosure, N>,
    {
        enclosure::certify(self, state.as_state())
    }

    /// Replaces a state by the rounded solution next to it: q, q̇ and q̈ as accurate as `T` allows, whatever the condition.
    ///
    /// Residuals are evaluated with twice the digits. The equations are those of [`error_bound`](Self::error_bound): time, parameters and
    /// literals have the exact values of their doubles. Polishing is worthwhile if the [condition](crate::Values::condition) exceeds
    /// about a hundred and rates or accelerations are needed to the last digits. The state stays on its branch: no other solution is as
    /// near.
    ///
    /// # Errors
    /// If this cannot be proven; the state is unchanged.
    #[cfg(feature = "certify")]
    fn polish(&self, state: &mut State<T, N>) -> Result<(), Doubt>
    where
        Self: Family<T>,
        Self::Over<Enclosure>: Stages<Enclosure, N>,
    {
        enclosure::polish(self, state)
    }

    /// A state with its derivatives by parameters: the mechanism and the state over [`Gradient`]s, so that outputs with
    /// their rates and accelerations, motions of points and bodies, loads and energies have exact derivatives too.
    ///
    /// * `state`: given, a state of this mechanism.
    /// * `by`: given, selects the parameters; derivatives are in this order.
    ///
    /// ```
    /// use reuleaux::{Mechanism, mechanism};
    /// mechanism! {
    ///     /// A slide on a rail, pushed by a rod of which it is the far end.
    ///     mechanism Slide {
    ///         param crank_length: Length = 50mm;
    ///         param rod_length: Length = 150mm;
    ///         ground { axis rail = (1, 0); }
    ///         body crank { point A = (crank_length, 0mm); }
    ///         body rod { point B = (rod_length, 0mm);  start angle = -10deg; }
    ///         body slide { start x = 200mm; }
    ///         joint o = revolute(ground.position, crank.position);
    ///         joint a = revolute(crank.A, rod.position);
    ///         joint b = revolute(rod.B, slide.position);
    ///         joint guide = translational(ground.rail, ground.position, slide.position);
    ///         drive turn = drive_angle(crank, 60rpm * t);
    ///         output stroke = slide.position.x;
    ///     }
    /// }
    /// let slide = Slide::default();
    /// let state = slide.solve(0.1)?;
    /// let (varied, state) = slide.derivatives(&state, |slide| [&mut slide.crank_length, &mut slide.rod_length])?;
    /// let [by_crank, by_rod] = varied.stroke(&SlideState(state)).value.by;
    /// // x = r cos θ + √(l² − r² sin² θ)
    /// let (sine, cosine) = (0.2 * std::f64::consts::PI).sin_cos();
    /// let root = (0.15f64.powi(2) - (0.05 * sine).powi(2)).sqrt();
    /// assert!((by_crank - (cosine - 0.05 * sine * sine / root)).abs() < 1e-15);
    /// assert!((by_rod - 0.15 / root).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Nothing is iterated: each parameter costs one more right-hand side for the Jacobian of the state, for q, q̇ and q̈. In loops
    /// [`update_derivatives`](Self::update_derivatives) saves moving the result. Where the derivative of an acceleration needs the
    /// third derivative of a Rust function, which is unknown, it is NaN.
    ///
    /// With [inputs](macro@crate::mechanism#input) the values and rates at hand are those of the mechanism, not those of the state: write
    /// `mechanism.with_inputs_of(&state).derivatives(…)`, and set `varied.inputs` before the next
    /// [`update_derivatives`](Self::update_derivatives). Other inputs are refused ([`Cause::OtherInputs`](crate::Cause::OtherInputs)).
    ///
    /// Near a dead point or a change point a derivative loses more digits than its quantity, by those of the condition κ of the Jacobian at
    /// this place: those of q are known to κ² ε, of q̇ to κ³ ε, of q̈ to κ⁴ ε.
    ///
    /// # Errors
    /// If the state does not belong to this mechanism, or Φ_q is singular there, or so nearly that those of q̈ have no digits: κ is ε^(−1/4) or more,
    /// 8192 (54 in single precision).
    #[allow(clippy::type_complexity, reason = "a mechanism and its state, over numbers with derivatives")]
    #[inline]
    fn derivatives<const P: usize>(
        &self,
        state: &impl HasState<T, N>,
        by: impl for<'a> FnOnce(&'a mut Self::Over<Gradient<T, P>>) -> [&'a mut Gradient<T, P>; P],
    ) -> Result<(Self::Over<Gradient<T, P>>, State<Gradient<T, P>, N>), Failure<T, N>>
    where
        Self: Family<T>,
        Self::Over<Gradient<T, P>>: Stages<Gradient<T, P>, N>,
    {
        gradient::derivatives(self, state.as_state(), by)
    }

    /// A state with its derivatives by any variables on which the parameters depend.
    ///
    /// * `state`: given, a state of this mechanism.
    /// * `varied`: given, this mechanism, each parameter with its derivatives by the variables: one length that several parameters
    ///   share, or an angle of which two coordinates are sine and cosine.
    ///
    /// # Errors
    /// As [`derivatives`](Self::derivatives).
    #[inline]
    fn derivatives_along<const P: usize>(
        &self,
        state: &impl HasState<T, N>,
        varied: &Self::Over<Gradient<T, P>>,
    ) -> Result<State<Gradient<T, P>, N>, Failure<T, N>>
    where
        Self: Family<T>,
        Self::Over<Gradient<T, P>>: Stages<Gradient<T, P>, N>,
    {
        gradient::derivatives_along(self, state.as_state(), varied)
    }

    /// The same in place, for loops: states with many derivatives are large, and moving one takes about as long as finding it.
    /// With twenty coordinates or more, four parameters at a time, for all states before the next four, take less time than many at once,
    /// whose code does not fit in the processor's nearest cache.
    ///
    /// * `state`, `varied`: given, as for [`derivatives_along`](Self::derivatives_along); [`derivatives`](Self::derivatives) gives a
    ///   `varied` for parameters by themselves, and the first of the states to be written over.
    /// * `there`: given, any state; returned, the state with its derivatives, unspecified after an error.
    ///
    /// # Errors
    /// As [`derivatives`](Self::derivatives).
    #[inline]
    fn update_derivatives<const P: usize>(
        &self,
        state: &impl HasState<T, N>,
        varied: &Self::Over<Gradient<T, P>>,
        there: &mut State<Gradient<T, P>, N>,
    ) -> Result<(), Failure<T, N>>
    where
        Self: Family<T>,
        Self::Over<Gradient<T, P>>: Stages<Gradient<T, P>, N>,
    {
        gradient::update_derivatives(self, state.as_state(), varied, there)
    }

    /// The states at these [`Times`] (s), such as `(0..=360).map(|i| f64::from(i) * 1e-3)` or a reference to a list: the first as by
    /// [`solve`](Self::solve), each further one from the one before.
    ///
    /// The iterator ends after the first failure. A change point on the way is passed on the smooth branch. A state at
    /// the change point itself is the limit of those around it: its equations hold to rounding, but no
    /// [certificate](Self::certify) is possible there, since there is another solution next to it.
    fn sweep<I: Times<T>>(&self, times: I) -> Sweep<'_, Self, I::IntoIter, T, N>
    where
        Self: Sized,
    {
        Sweep::new(self, times.into_iter())
    }
}

impl<T: Float, const N: usize, E: Stages<T, N> + ?Sized> Mechanism<T, N> for E {}

/// Takes a state to time `t` (s) where one warm step does not.
///
/// # Errors
/// Any [`Cause`].
#[cold]
#[inline(never)]
fn by_steps<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(mechanism: &E, state: &mut State<T, N>, t: T) -> Result<(), Failure<T, N>> {
    path::advance_by_steps(mechanism, state, t).map_err(|ended| verdict::of_continuation(&Followed::new(&mechanism), state, t, ended))
}
