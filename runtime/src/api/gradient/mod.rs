//! Derivatives by parameters: the emitted code is run over numbers that carry them along.
//!
//! In: a mechanism, a state of it, and the selected parameters. Out: the same state over [`Gradient`]s. A block is not
//! iterated: its Jacobian is factorised once at the state, and each parameter is one more right-hand side:
//!
//! ```text
//! Φ_q ∂q/∂p = −Φ_p                                position
//! Φ_q ∂q̇/∂p = d(ν − Φ_q q̇)/dp with q̇ fixed         velocity
//! Φ_q ∂q̈/∂p = d(γ − Φ_q q̈)/dp with q̈ fixed         acceleration
//! ```
//!
//! Haug: Computer Aided Kinematics and Dynamics of Mechanical Systems, 3.6 (direct differentiation).

mod factors;
mod number;

use core::cell::Cell;

use nalgebra::SVector;

use crate::explain::Failure;
use crate::linear::{Elimination, FactorReal, Factors, InOrder, Linear, Small, Sparse};
use crate::names::{self, Cause, Coordinate, CoordinateKind, Culprit, Description};
use crate::newton::{Block, Evaluate, Iterate, Scale, Solved, StepError};
use crate::number::order::greater;
use crate::number::{Float, Real, row};
use crate::solve::{ColdStart, Family, Solver, SolverReal, Stages, lengths_of};
use crate::state::{State, Values};

use factors::{GradientFactors, Pattern, Whole};
pub use number::Gradient;

/// A state with a larger correction than this, as a fraction of the unknown plus its scale, is not a solution.
const OFF: f64 = 1e-3;

impl<T: Float, const P: usize> FactorReal for Gradient<T, P> {
    type Small<const K: usize> = GradientFactors<T, Small<T, K>, Whole, P, K>;
    type Sparse<E, const K: usize, const ENTRIES: usize, const FACTORS: usize>
        = GradientFactors<T, Sparse<T, InOrder<E, Self>, K, ENTRIES, FACTORS>, Pattern<E, ENTRIES, FACTORS>, P, K>
    where
        E: Elimination<Self, K, ENTRIES, FACTORS>;
    type Dense<const K: usize> = GradientFactors<T, Factors<T, K>, Whole, P, K>;
}

impl<T: Float, const P: usize> SolverReal for Gradient<T, P> {
    type Cold<'a, const N: usize> = Differentiation<'a, T, N>;
}

/// A mechanism whose parameters may carry derivatives. Every mechanism with numeric parameters is one.
pub trait Differentiable<T: Float>: Family<T> {
    /// This mechanism over [`Gradient`]s, which carry derivatives by the selected parameters, in this order.
    ///
    /// Where a motion follows from forces, everything computed with it has derivatives too: the initial state, accelerations, loads, energies and
    /// the motion itself, with its outputs. Times are constants, `20.0.into()`. The tolerance of an integrator is that of the values;
    /// derivatives are mostly a digit or two less accurate. Steps are shortened where their errors are larger than that, as where a force has a
    /// kink. Where a force jumps, `if t < off { push } else { 0N }`, derivatives do not know that the instant of the jump moves.
    ///
    /// ```
    /// use reuleaux::{Differentiable, Integrator, mechanism};
    /// mechanism! {
    ///     /// A mass on a spring, released where the spring is long by `drawn`.
    ///     mechanism Oscillator {
    ///         param stiffness: Stiffness = 400N_m;
    ///         param drawn: Length = 20mm;
    ///         ground { point O = (0mm, 0mm);  axis rail = (1, 0); }
    ///         body slide { mass = 4kg;  inertia = 0.01kgm2; }
    ///         joint guide = translational(ground.rail, ground.O, slide.position);
    ///         force spring = { at slide.position: (-stiffness * slide.position.x, 0N); }
    ///         freedom stroke = slide.position.x from drawn at 0m_s;
    ///     }
    /// }
    /// let varied = Oscillator::default().with_derivatives(|m| [&mut m.stiffness, &mut m.drawn]);
    /// let mut state = varied.initial_state()?;
    /// varied.advance(&mut state, 0.3.into(), &mut Integrator::new(1e-12.into()))?;
    /// let [by_stiffness, by_drawn] = state.slide().position.x.by;
    /// // x = a cos ωt, ω = √(k/m) = 10 rad/s, ∂ω/∂k = ω/2k
    /// assert!((by_stiffness + 0.02 * 0.3 * 10.0 / 800.0 * 3f64.sin()).abs() < 1e-12);
    /// assert!((by_drawn - 3f64.cos()).abs() < 1e-10);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[inline(always)]
    fn with_derivatives<const P: usize>(
        &self,
        by: impl for<'a> FnOnce(&'a mut Self::Over<Gradient<T, P>>) -> [&'a mut Gradient<T, P>; P],
    ) -> Self::Over<Gradient<T, P>> {
        let mut varied = Self::gather([self], |[parameter]| Gradient::constant(parameter));
        for (parameter, k) in by(&mut varied).into_iter().zip(0..P) {
            parameter.by[k] = T::of(1.0);
        }
        varied
    }
}

impl<T: Float, E: Family<T>> Differentiable<T> for E {}

/// The derivatives of all blocks at a state that is given.
pub struct Differentiation<'a, T: Float, const N: usize> {
    q: &'a SVector<T, N>,
    /// L and 1/L.
    lengths: (T, T),
    coordinates: &'static [Coordinate],
    /// Of the state.
    condition: T,
    /// An equation and an unknown of a block that is too nearly singular.
    lost: Cell<Option<[usize; 2]>>,
}

impl<T: Float, const N: usize> Differentiation<'_, T, N> {
    /// True if a block is so nearly singular that derivatives have lost their digits: second ones amplify rounding by κ⁴.
    #[cold]
    #[inline(never)]
    fn loses<L: Linear<Gradient<T, P>, K>, const P: usize, const K: usize>(
        &self,
        block: &Block<K>,
        sizes: [Gradient<T, P>; K],
        factors: &L,
    ) -> bool {
        let lengths = (Gradient::constant(self.lengths.0), Gradient::constant(self.lengths.1));
        let scale = Scale::by_kind(lengths.0, lengths.1, &block.kinds);
        let is_lost = factors.error_amplification(&SVector::from(sizes), &scale.reciprocal).value >= lost();
        if let (true, Some(row), Some(unknown)) = (is_lost, block.equations.first(), block.unknowns.first()) {
            self.lost.set(Some([*row, *unknown]));
        }
        is_lost
    }
}

/// The condition κ = ε^(−1/4), from which on second derivatives have no digits.
fn lost<T: Float>() -> T {
    T::of(1.0) / T::ROOT_EPSILON.sqrt()
}

impl<T: Float, const P: usize, const N: usize> ColdStart<Gradient<T, P>, N> for Differentiation<'_, T, N> {
    #[inline(always)]
    fn lengths(&self) -> (Gradient<T, P>, Gradient<T, P>) {
        (Gradient::constant(self.lengths.0), Gradient::constant(self.lengths.1))
    }

    /// The derivatives of a block's unknowns, whose values are those of the state.
    ///
    /// Compiled into the code of the block, where of the first evaluation only the residuals are left and of the second only the
    /// matrix.
    ///
    /// # Errors
    /// If the values fulfil no equations, or the Jacobian is singular.
    #[inline(always)]
    fn solve_block<L: Linear<Gradient<T, P>, K>, const K: usize>(
        &self,
        block: &Block<K>,
        sizes: [Gradient<T, P>; K],
        evaluate: &Evaluate<'_, Gradient<T, P>, L, K>,
    ) -> Result<Solved<Gradient<T, P>, L, K>, StepError<Gradient<T, P>>> {
        let first = names::coordinate(self.coordinates, block.unknowns.first().copied().unwrap_or(0));
        let bad = || StepError::NotFinite(Culprit::Coordinate(first));
        let values = SVector::from_fn(|k, _| self.q.get(block.unknowns[k]).copied().unwrap_or(T::of(f64::NAN)));
        let here = Iterate::at(values, &block.needs_sin_cos);
        let mut place = Iterate { x: SVector::from_element(Gradient::of(0.0)), sin_cos: [(Gradient::of(0.0), Gradient::of(0.0)); K] };
        for k in 0..K {
            let (sine, cosine) = here.sin_cos[k];
            place.x[k] = Gradient::constant(here.x[k]);
            place.sin_cos[k] = (Gradient::constant(sine), Gradient::constant(cosine));
        }
        let (phi, matrix) = evaluate(&place);
        let factors = L::factor(&matrix).map_err(|_| bad())?;
        if !factors.is_regular() {
            self.lost.set(block.equations.first().zip(block.unknowns.first()).map(|(row, unknown)| [*row, *unknown]));
        }
        if !factors.is_regular() || self.condition >= lost() && self.loses(block, sizes, &factors) {
            return Err(bad());
        }
        let off = factors.solve_as_constant(&phi);
        let mut is_near = true;
        for k in 0..K {
            let size = if block.kinds[k] == CoordinateKind::Length { self.lengths.0 } else { T::of(1.0) };
            is_near &= off[k].value.abs() <= T::of(OFF) * (size + here.x[k].abs());
        }
        if !is_near {
            return Err(StepError::Far);
        }
        for k in 0..K {
            let (sine, cosine) = here.sin_cos[k];
            let x = Gradient { value: here.x[k], by: row::negated(&off[k].by) };
            place.x[k] = x;
            place.sin_cos[k] = (x.chain(sine, cosine), x.chain(cosine, -sine));
        }
        let factors = factors.with_derivatives_of(&evaluate(&place).1).map_err(|_| bad())?;
        Ok(Solved { x: place.x.data.0[0], sin_cos: place.sin_cos, factors })
    }

    /// The state is verified already.
    #[inline(always)]
    fn check(&self, _: usize, _: Gradient<T, P>, _: Gradient<T, P>) {}
}

/// [`Mechanism::derivatives`](crate::Mechanism::derivatives)
#[inline(always)]
pub(crate) fn derivatives<T, E, const P: usize, const N: usize>(
    mechanism: &E,
    state: &State<T, N>,
    by: impl for<'a> FnOnce(&'a mut E::Over<Gradient<T, P>>) -> [&'a mut Gradient<T, P>; P],
) -> Result<Derived<T, E, P, N>, Failure<T, N>>
where
    T: Float,
    E: Family<T> + Description<T, N>,
    E::Over<Gradient<T, P>>: Stages<Gradient<T, P>, N>,
{
    let varied = mechanism.with_derivatives(by);
    // Written where it is returned: moving it takes about as long as finding it.
    let mut found = Ok((varied, still(state)));
    if let Ok((varied, there)) = &mut found
        && let Err(cause) = differentiate(mechanism, state, varied, there)
    {
        found = Err(failure::<T, E, N>(state, cause));
    }
    found
}

/// [`Mechanism::derivatives_along`](crate::Mechanism::derivatives_along)
#[inline(always)]
pub(crate) fn derivatives_along<T, E, const P: usize, const N: usize>(
    mechanism: &E,
    state: &State<T, N>,
    varied: &E::Over<Gradient<T, P>>,
) -> Result<State<Gradient<T, P>, N>, Failure<T, N>>
where
    T: Float,
    E: Family<T> + Description<T, N>,
    E::Over<Gradient<T, P>>: Stages<Gradient<T, P>, N>,
{
    let mut found = Ok(still(state));
    if let Ok(there) = &mut found
        && let Err(cause) = differentiate(mechanism, state, varied, there)
    {
        found = Err(failure::<T, E, N>(state, cause));
    }
    found
}

/// A state that depends on no parameter, with coordinates to be filled in.
#[inline(always)]
fn still<T: Float, const P: usize, const N: usize>(state: &State<T, N>) -> State<Gradient<T, P>, N> {
    let zero = SVector::from_element(Gradient::constant(T::ZERO));
    let values = Values {
        t: Gradient::constant(state.t),
        q: zero,
        qd: zero,
        qdd: zero,
        branch: state.branch,
        condition: Gradient::constant(state.condition),
        iterations: state.iterations,
    };
    State::solved(values, 0)
}

#[cold]
#[inline(never)]
fn failure<T: Float, E: Description<T, N>, const N: usize>(state: &State<T, N>, cause: Cause<T>) -> Failure<T, N> {
    Failure { mechanism: E::NAME, cause, time: state.t, end: None, last: Some(state.clone()) }
}

/// [`Mechanism::update_derivatives`](crate::Mechanism::update_derivatives)
#[inline(always)]
pub(crate) fn update_derivatives<T, E, const P: usize, const N: usize>(
    mechanism: &E,
    state: &State<T, N>,
    varied: &E::Over<Gradient<T, P>>,
    there: &mut State<Gradient<T, P>, N>,
) -> Result<(), Failure<T, N>>
where
    T: Float,
    E: Family<T> + Description<T, N>,
    E::Over<Gradient<T, P>>: Stages<Gradient<T, P>, N>,
{
    there.t = Gradient::constant(state.t);
    there.branch = state.branch;
    there.condition = Gradient::constant(state.condition);
    there.iterations = state.iterations;
    differentiate(mechanism, state, varied, there).map_err(|cause| failure::<T, E, N>(state, cause))
}

/// Fills in the coordinates with their derivatives.
#[inline]
fn differentiate<T, E, const P: usize, const N: usize>(
    mechanism: &E,
    state: &State<T, N>,
    varied: &E::Over<Gradient<T, P>>,
    there: &mut State<Gradient<T, P>, N>,
) -> Result<(), Cause<T>>
where
    T: Float,
    E: Family<T> + Description<T, N>,
    E::Over<Gradient<T, P>>: Stages<Gradient<T, P>, N>,
{
    mechanism.validate().map_err(Cause::ParameterOutOfRange)?;
    let differentiation = Differentiation {
        q: &state.q,
        lengths: lengths_of(mechanism.characteristic_length()),
        coordinates: E::COORDINATES,
        condition: state.condition,
        lost: Cell::new(None),
    };
    let there = &mut there.values;
    match varied.stages(Gradient::constant(state.t), &mut Solver::cold(&differentiation)) {
        Ok(found) => (there.q, there.qd, there.qdd) = (found.q, found.qd, found.qdd),
        Err(StepError::NotFinite(of)) => {
            return Err(match differentiation.lost.get() {
                Some([row, unknown]) => Cause::Singular {
                    row: names::row(E::ROWS, row),
                    coordinate: names::coordinate(E::COORDINATES, unknown),
                    condition: state.condition,
                },
                None => Cause::NotFinite { of },
            });
        }
        Err(StepError::Far | StepError::Open(_)) if E::HAS_INPUTS => return Err(Cause::OtherInputs),
        Err(StepError::Far | StepError::Open(_)) => return Err(Cause::NoConvergence { correction: T::of(OFF), iterations: 0 }),
    }
    let is_finite = |entry: Option<&Gradient<T, P>>| entry.is_some_and(|entry| entry.value.is_finite());
    let is_good = |&index: &usize| [&there.q, &there.qd, &there.qdd].iter().all(|entries| is_finite(entries.get(index)));
    let bad = match <E::Over<Gradient<T, P>>>::MAY_BE_NON_FINITE {
        Some(some) => some.iter().copied().find(|index| !is_good(index)),
        None => (0..N).find(|index| !is_good(index)),
    };
    match bad {
        Some(index) => Err(Cause::NotFinite { of: Culprit::Coordinate(names::coordinate(E::COORDINATES, index)) }),
        None if E::HAS_INPUTS && !has_values_of(there, state, &differentiation) => Err(Cause::OtherInputs),
        None => Ok(()),
    }
}

/// Whether the values of q, q̇ and q̈ are those of a state, up to its rounding errors: with other inputs they are not.
///
/// ```text
/// |Δq| ≤ η (1 + |q|)      |Δq̇| ≤ η |q̇|      |Δq̈| ≤ κ η (|q̈| + |q̇|²)      η = √ε + 64 κ ε
/// ```
///
/// with the largest scaled entries of each vector.
#[inline(never)]
fn has_values_of<T: Float, const P: usize, const N: usize>(
    there: &Values<Gradient<T, P>, N>,
    state: &State<T, N>,
    of: &Differentiation<'_, T, N>,
) -> bool {
    let scale = |k: usize| if names::coordinate(of.coordinates, k).kind == CoordinateKind::Length { of.lengths.1 } else { T::of(1.0) };
    let largest = |entry: &dyn Fn(usize) -> T| (0..N).fold(T::of(0.0), |largest, k| greater(largest, entry(k).abs() * scale(k)));
    let off = |found: &SVector<Gradient<T, P>, N>, known: &SVector<T, N>| largest(&|k| found[k].value - known[k]);
    let [place, speed, acceleration] = [&state.q, &state.qd, &state.qdd].map(|known| largest(&|k| known[k]));
    let share = T::ROOT_EPSILON + T::of(64.0) * state.condition * T::EPSILON;
    off(&there.q, &state.q) <= share * (T::of(1.0) + place)
        && off(&there.qd, &state.qd) <= share * speed
        && off(&there.qdd, &state.qdd) <= share * state.condition * (acceleration + speed * speed)
}

/// A mechanism and its state over gradients.
pub(crate) type Derived<T, E, const P: usize, const N: usize> = (<E as Family<T>>::Over<Gradient<T, P>>, State<Gradient<T, P>, N>);
