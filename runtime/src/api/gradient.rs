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

use core::array;
use core::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::{SMatrix, SVector};

use crate::explain::Failure;
use crate::linear::{FactorReal, Factors, Linear};
use crate::names::{self, Cause, Coordinate, CoordinateKind, Culprit, Description};
use crate::newton::{Block, Evaluate, Iterate, Solved, StepError};
use crate::number::{DetSign, Float, Real, SimdReal, Table};
use crate::solve::{ColdStart, Family, Solver, SolverReal, Stages, lengths_of};
use crate::state::{State, Values};

/// A number and its partial derivatives by `P` parameters: the number type of [`derivatives`](crate::Mechanism::derivatives).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient<T, const P: usize> {
    /// The number.
    pub value: T,
    /// Its derivative by each parameter, in the order in which these were asked for.
    pub by: [T; P],
}

/// A state with a larger correction than this, as a fraction of the unknown plus its scale, is not a solution.
const OFF: f64 = 1e-3;

impl<T: Float, const P: usize> Gradient<T, P> {
    /// A constant, which depends on no parameter.
    #[must_use]
    #[inline(always)]
    pub fn constant(value: T) -> Self {
        Self { value, by: [T::of(0.0); P] }
    }

    /// f(x) by its value and slope at x.
    #[inline(always)]
    fn chain(self, value: T, slope: T) -> Self {
        Self { value, by: self.by.map(|by| slope * by) }
    }

    /// f(a, b) by its value and its slopes.
    #[inline(always)]
    fn chain_of_two(self, other: Self, value: T, [own, others]: [T; 2]) -> Self {
        Self { value, by: array::from_fn(|k| own * at(&self.by, k) + others * at(&other.by, k)) }
    }

    /// A function with its value and three derivatives; the third is used only where x depends on a parameter.
    fn derived(self, [value, first, second, third]: [T; 4]) -> (Self, Self, Self) {
        let zero = T::of(0.0);
        let of_second = |by: T| if by == zero { zero } else { third * by };
        (self.chain(value, first), self.chain(first, second), Self { value: second, by: self.by.map(of_second) })
    }
}

/// The entry at an index, which is in range.
#[inline(always)]
fn at<T: Float, const P: usize>(by: &[T; P], index: usize) -> T {
    by.get(index).copied().unwrap_or(T::of(f64::NAN))
}

impl<T: Float, const P: usize> Add for Gradient<T, P> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, by: array::from_fn(|k| at(&self.by, k) + at(&other.by, k)) }
    }
}

impl<T: Float, const P: usize> Sub for Gradient<T, P> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, by: array::from_fn(|k| at(&self.by, k) - at(&other.by, k)) }
    }
}

impl<T: Float, const P: usize> Mul for Gradient<T, P> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.chain_of_two(other, self.value * other.value, [other.value, self.value])
    }
}

impl<T: Float, const P: usize> Div for Gradient<T, P> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let reciprocal = T::of(1.0) / other.value;
        let quotient = self.value / other.value;
        self.chain_of_two(other, quotient, [reciprocal, -(quotient * reciprocal)])
    }
}

impl<T: Float, const P: usize> Neg for Gradient<T, P> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, by: self.by.map(|by| -by) }
    }
}

impl<T: Float, const P: usize> Real for Gradient<T, P> {
    #[inline(always)]
    fn of(value: f64) -> Self {
        Self::constant(T::of(value))
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, T::of(0.5) / root)
    }

    fn tan(self) -> Self {
        let tangent = self.value.tan();
        self.chain(tangent, T::of(1.0) + tangent * tangent)
    }

    fn asin(self) -> Self {
        self.chain(self.value.asin(), T::of(1.0) / leg(self.value))
    }

    fn acos(self) -> Self {
        self.chain(self.value.acos(), T::of(-1.0) / leg(self.value))
    }

    fn atan(self) -> Self {
        self.chain(self.value.atan(), T::of(1.0) / (T::of(1.0) + self.value * self.value))
    }

    fn atan2(self, x: Self) -> Self {
        let square = x.value * x.value + self.value * self.value;
        self.chain_of_two(x, self.value.atan2(x.value), [x.value / square, -self.value / square])
    }

    fn exp(self) -> Self {
        let power = self.value.exp();
        self.chain(power, power)
    }

    fn ln(self) -> Self {
        self.chain(self.value.ln(), T::of(1.0) / self.value)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        if self.value < T::of(0.0) { -self } else { self }
    }

    fn sign(self) -> Self {
        Self::constant(self.value.sign())
    }

    #[inline(always)]
    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        if lhs.value < rhs.value { then } else { otherwise }
    }

    fn table(self, table: &Table) -> (Self, Self, Self) {
        let (value, first, second) = self.value.table(table);
        self.derived([value, first, second, T::of(table.third_derivative(self.value.to_f64()))])
    }

    /// The third derivative of a Rust function is unknown: where its argument depends on a parameter, results that need it are NaN.
    fn map(self, function: fn(f64) -> (f64, f64, f64)) -> (Self, Self, Self) {
        let (value, first, second) = self.value.map(function);
        self.derived([value, first, second, T::of(f64::NAN)])
    }
}

/// √(1 − x²)
fn leg<T: Float>(x: T) -> T {
    ((T::of(1.0) - x) * (T::of(1.0) + x)).sqrt()
}

/// Comparisons look at the numbers and not at their derivatives.
impl<T: Float, const P: usize> SimdReal for Gradient<T, P> {
    type Mask = bool;
    type Signs = DetSign;

    const EPSILON: Self = Self { value: T::EPSILON, by: [T::ZERO; P] };
    const ROOT_EPSILON: Self = Self { value: T::ROOT_EPSILON, by: [T::ZERO; P] };

    #[inline(always)]
    fn at_most(self, bound: Self) -> bool {
        self.value <= bound.value
    }

    #[inline(always)]
    fn pick(mask: bool, then: Self, otherwise: Self) -> Self {
        if mask { then } else { otherwise }
    }

    fn signs(self) -> DetSign {
        self.value.signs()
    }

    fn same_signs(a: DetSign, b: DetSign) -> bool {
        a == b
    }

    #[inline(always)]
    fn fast_sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.fast_sin_cos();
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }
}

impl<T: Float, const P: usize> FactorReal for Gradient<T, P> {
    type Dense<const K: usize> = DenseGradient<T, P, K>;
}

impl<T: Float, const P: usize> SolverReal for Gradient<T, P> {
    type Cold<'a, const N: usize> = Differentiation<'a, T, P, N>;
}

/// The derivatives of all blocks at a state that is given.
pub struct Differentiation<'a, T: Float, const P: usize, const N: usize> {
    q: &'a SVector<Gradient<T, P>, N>,
    /// L and 1/L.
    lengths: (Gradient<T, P>, Gradient<T, P>),
    coordinates: &'static [Coordinate],
}

impl<T: Float, const P: usize, const N: usize> ColdStart<Gradient<T, P>, N> for Differentiation<'_, T, P, N> {
    fn lengths(&self) -> (Gradient<T, P>, Gradient<T, P>) {
        self.lengths
    }

    /// The derivatives of a block's unknowns, whose values are those of the state.
    ///
    /// # Errors
    /// If the values fulfil no equations, or the Jacobian is singular.
    #[inline]
    fn solve_block<L: Linear<Gradient<T, P>, K>, const K: usize>(
        &self,
        block: &Block<K>,
        _: [Gradient<T, P>; K],
        evaluate: &Evaluate<'_, Gradient<T, P>, L, K>,
    ) -> Result<Solved<Gradient<T, P>, L, K>, StepError<Gradient<T, P>>> {
        let first = names::coordinate(self.coordinates, block.unknowns.first().copied().unwrap_or(0));
        let bad = || StepError::NotFinite(Culprit::Coordinate(first));
        let x = SVector::from_fn(|k, _| self.q.get(block.unknowns[k]).copied().unwrap_or(Gradient::of(f64::NAN)));
        let still = Iterate::at(x, &block.needs_sin_cos);
        let (phi, matrix) = evaluate(&still);
        let factors = L::factor(&matrix).map_err(|_| bad())?;
        if !factors.is_regular() {
            return Err(bad());
        }
        let off = factors.solve_refined(&phi);
        let length = self.lengths.0.value;
        let is_near = |k: usize| {
            let size = if block.kinds[k] == CoordinateKind::Length { length } else { T::of(1.0) };
            off[k].value.abs() <= T::of(OFF) * (size + x[k].value.abs())
        };
        if !(0..K).all(is_near) {
            return Err(StepError::Far);
        }
        let x = SVector::<Gradient<T, P>, K>::from_fn(|k, _| Gradient { value: x[k].value, by: off[k].by.map(|by| -by) });
        let sin_cos = array::from_fn(|k| {
            let (sine, cosine) = (still.sin_cos[k].0.value, still.sin_cos[k].1.value);
            (x[k].chain(sine, cosine), x[k].chain(cosine, -sine))
        });
        let there = Iterate { x, sin_cos };
        let factors = L::factor(&evaluate(&there).1).map_err(|_| bad())?;
        Ok(Solved { x: there.x.data.0[0], sin_cos, factors })
    }

    /// The state is verified already.
    fn check(&self, _: usize, _: Gradient<T, P>, _: Gradient<T, P>) {}
}

/// Factors of a matrix of numbers, with the derivatives of its entries.
#[derive(Clone, Copy, Debug)]
pub struct DenseGradient<T, const P: usize, const K: usize> {
    factors: Factors<T, K>,
    matrix: SMatrix<Gradient<T, P>, K, K>,
}

impl<T: Float, const P: usize, const K: usize> Linear<Gradient<T, P>, K> for DenseGradient<T, P, K> {
    type Matrix = SMatrix<Gradient<T, P>, K, K>;

    fn factor(matrix: &Self::Matrix) -> Result<Self, usize> {
        Ok(Self { factors: Factors::factor(&matrix.map(|entry| entry.value))?, matrix: *matrix })
    }

    fn dense(matrix: &Self::Matrix) -> Self::Matrix {
        *matrix
    }

    /// A ∂x = ∂b − ∂A x
    fn solve_regular(&self, b: &SVector<Gradient<T, P>, K>) -> SVector<Gradient<T, P>, K> {
        let x = self.factors.solve_refined(&b.map(|entry| entry.value));
        let mut solution = x.map(Gradient::constant);
        for p in 0..P {
            let rest = |i: usize| (0..K).fold(at(&b[i].by, p), |rest, j| rest - at(&self.matrix[(i, j)].by, p) * x[j]);
            let by = self.factors.solve_refined(&SVector::from_fn(|i, _| rest(i)));
            for (entry, &by) in solution.iter_mut().zip(by.iter()) {
                if let Some(there) = entry.by.get_mut(p) {
                    *there = by;
                }
            }
        }
        solution
    }

    fn solve(&self, b: &SVector<Gradient<T, P>, K>) -> SVector<Gradient<T, P>, K> {
        self.solve_regular(b)
    }

    fn solve_refined(&self, b: &SVector<Gradient<T, P>, K>) -> SVector<Gradient<T, P>, K> {
        self.solve_regular(b)
    }

    fn error_amplification(&self, sizes: &SVector<Gradient<T, P>, K>, reciprocals: &SVector<Gradient<T, P>, K>) -> Gradient<T, P> {
        Gradient::constant(self.factors.error_amplification(&sizes.map(|size| size.value), &reciprocals.map(|reciprocal| reciprocal.value)))
    }

    fn det_sign(&self) -> DetSign {
        self.factors.det_sign()
    }

    fn is_regular(&self) -> bool {
        self.factors.is_regular()
    }
}

/// [`Mechanism::derivatives`](crate::Mechanism::derivatives)
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
    let mut varied = E::gather([mechanism], |[parameter]| Gradient::constant(parameter));
    for (k, parameter) in by(&mut varied).into_iter().enumerate() {
        parameter.by = array::from_fn(|other| T::of(if other == k { 1.0 } else { 0.0 }));
    }
    let state = derivatives_along(mechanism, state, &varied)?;
    Ok((varied, state))
}

/// [`Mechanism::derivatives_along`](crate::Mechanism::derivatives_along)
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
    let fail = |cause| Failure { mechanism: E::NAME, cause, time: state.t, end: None, last: Some(state.clone()) };
    mechanism.validate().map_err(|parameter| fail(Cause::ParameterOutOfRange(parameter)))?;
    let q = state.q.map(Gradient::constant);
    let differentiation = Differentiation { q: &q, lengths: lengths_of(varied), coordinates: E::COORDINATES };
    let found = varied.stages(Gradient::constant(state.t), &mut Solver::cold(&differentiation)).map_err(|error| match error {
        StepError::NotFinite(of) => fail(Cause::NotFinite { of }),
        StepError::Far | StepError::Open(_) => fail(Cause::NoConvergence { correction: T::of(OFF), iterations: 0 }),
    })?;
    let is_finite = |entry: &Gradient<T, P>| entry.value.is_finite();
    if let Some(index) = (0..N).find(|&i| ![&found.q, &found.qd, &found.qdd].iter().all(|entries| is_finite(&entries[i]))) {
        return Err(fail(Cause::NotFinite { of: Culprit::Coordinate(names::coordinate(E::COORDINATES, index)) }));
    }
    let values = Values {
        t: Gradient::constant(state.t),
        q: found.q,
        qd: found.qd,
        qdd: found.qdd,
        branch: state.branch,
        condition: Gradient::constant(state.condition),
        iterations: state.iterations,
    };
    Ok(State::solved(values, 0))
}

/// A mechanism and its state over gradients.
pub(crate) type Derived<T, E, const P: usize, const N: usize> = (<E as Family<T>>::Over<Gradient<T, P>>, State<Gradient<T, P>, N>);
