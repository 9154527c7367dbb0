//! Newton's method on all coordinates with nalgebra's LU, from q + h q̇ + h² q̈/2 or from q. Φ and its derivatives are the
//! generated ones, which nobody writes better.

use reuleaux::nalgebra::{Const, DMatrix, DVector, DimMin, Dyn, LU, SMatrix, SVector};
use reuleaux::{Equations, Mechanism, State};
use std::marker::PhantomData;

use crate::contender::{Contender, Output, Seen};

/// A way to factor a matrix.
pub trait Factor<const N: usize> {
    /// The factors.
    type Factors;

    /// L U of a matrix.
    fn factor(matrix: SMatrix<f64, N, N>) -> Self::Factors;

    /// x in A x = b.
    fn solve(factors: &Self::Factors, b: &SVector<f64, N>) -> Option<SVector<f64, N>>;
}

/// nalgebra's LU of a matrix whose size the compiler knows; it has none for more than 127 rows.
pub struct Static;

/// nalgebra's LU of a matrix on the heap.
pub struct Dynamic;

impl<const N: usize> Factor<N> for Static
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    type Factors = LU<f64, Const<N>, Const<N>>;

    fn factor(matrix: SMatrix<f64, N, N>) -> Self::Factors {
        matrix.lu()
    }

    fn solve(factors: &Self::Factors, b: &SVector<f64, N>) -> Option<SVector<f64, N>> {
        factors.solve(b)
    }
}

impl<const N: usize> Factor<N> for Dynamic {
    type Factors = LU<f64, Dyn, Dyn>;

    fn factor(matrix: SMatrix<f64, N, N>) -> Self::Factors {
        DMatrix::from_column_slice(N, N, matrix.as_slice()).lu()
    }

    fn solve(factors: &Self::Factors, b: &SVector<f64, N>) -> Option<SVector<f64, N>> {
        let x = factors.solve(&DVector::from_column_slice(b.as_slice()))?;
        Some(SVector::from_column_slice(x.as_slice()))
    }
}

/// The contender.
pub struct Absolute<F, E, const N: usize> {
    mechanism: E,
    output: Output<E, N>,
    is_predicted: bool,
    tolerance: f64,
    origin: State<f64, N>,
    state: State<f64, N>,
    factor: PhantomData<F>,
}

impl<F: Factor<N>, E: Mechanism<f64, N>, const N: usize> Absolute<F, E, N> {
    /// Newton's method that stops at this max|Φ|, with or without a predictor.
    ///
    /// # Panics
    /// If the mechanism cannot be assembled.
    pub fn new(mechanism: E, output: Output<E, N>, is_predicted: bool, tolerance: f64) -> Self {
        let origin = mechanism.solve(0.0).unwrap_or_else(|failure| panic!("{failure}"));
        Self { mechanism, output, is_predicted, tolerance, state: origin.clone(), origin, factor: PhantomData }
    }
}

impl<F: Factor<N>, E: Mechanism<f64, N> + Equations<f64, N, N>, const N: usize> Contender for Absolute<F, E, N> {
    fn restart(&mut self) {
        self.state.clone_from(&self.origin);
    }

    fn step(&mut self, t: f64) {
        let Self { mechanism, state, .. } = self;
        let h = if self.is_predicted { t - state.t } else { 0.0 };
        let mut q: SVector<f64, N> = state.q + (state.qd + state.qdd * (0.5 * h)) * h;
        loop {
            let (phi, jacobian) = mechanism.linearize(&q, t);
            let factors = F::factor(jacobian);
            let solve = |b: &SVector<f64, N>| F::solve(&factors, b).expect("a regular Jacobian");
            if phi.amax() <= self.tolerance {
                let qd = solve(&mechanism.nu(&q, t));
                let qdd = solve(&mechanism.gamma(&q, &qd, t));
                (state.t, state.q, state.qd, state.qdd) = (t, q, qd, qdd);
                return;
            }
            q -= solve(&phi);
        }
    }

    fn seen(&self) -> Seen {
        let motion = (self.output)(&self.mechanism, &self.state);
        Seen { place: motion.value.into(), acceleration: Some(motion.acceleration.into()) }
    }
}
