//! Errors of a state, from the same systems solved with twice the digits.

use reuleaux::nalgebra::{SMatrix, SVector};
use reuleaux::{CoordinateKind, Equations, Real, State};
use reuleaux_tests::common::twofold::Twofold;

/// Errors in units of condition × ε × size.
#[derive(Clone, Debug, Default)]
pub(super) struct Attained {
    /// Errors of q, q̇ and q̈.
    pub(super) errors: [f64; 3],
}

impl Attained {
    /// The larger error of each kind.
    pub(super) fn or(&self, other: &Self) -> Self {
        Self { errors: std::array::from_fn(|order| self.errors[order].max(other.errors[order])) }
    }
}

/// Solves all three systems with twice the digits and compares: q by Newton's method, q̇ and q̈ by elimination at the state's own q and
/// q̇, so that each error is that of its own system.
pub(super) fn compare<W: Equations<Twofold, N, N>, const N: usize>(exact: &W, state: &State<f64, N>) -> Attained {
    let t = Twofold::of(state.t);
    let mut q = state.q.map(Twofold::of);
    for _ in 0..4 {
        let (phi, jacobian) = exact.linearize(&q, t);
        let correction = solve(jacobian, phi);
        q = SVector::from_fn(|i, _| q[i] - correction[i]);
    }
    let (own_q, own_qd) = (state.q.map(Twofold::of), state.qd.map(Twofold::of));
    let jacobian = exact.jacobian(&own_q, t);
    let qd = solve(jacobian, exact.nu(&own_q, t));
    let qdd = solve(jacobian, exact.gamma(&own_q, &own_qd, t));
    let length = exact.characteristic_length().high;
    let error = |found: &SVector<f64, N>, exact: &SVector<Twofold, N>, least: f64| {
        let share = |i: usize| if W::COORDINATES[i].kind == CoordinateKind::Length { 1.0 / length } else { 1.0 };
        let size = (0..N).map(|i| exact[i].high.abs() * share(i)).fold(least, f64::max);
        let off = (0..N).map(|i| (Twofold::of(found[i]) - exact[i]).high.abs() * share(i)).fold(0.0, f64::max);
        off / (size * state.condition * f64::EPSILON)
    };
    Attained { errors: [error(&state.q, &q, 1.0), error(&state.qd, &qd, 0.0), error(&state.qdd, &qdd, 0.0)] }
}

/// A x = b by elimination with pivots from the column.
fn solve<const N: usize>(mut a: SMatrix<Twofold, N, N>, mut b: SVector<Twofold, N>) -> SVector<Twofold, N> {
    for k in 0..N {
        let pivot = (k..N).fold(k, |best, i| if a[(i, k)].high.abs() > a[(best, k)].high.abs() { i } else { best });
        a.swap_rows(k, pivot);
        b.swap_rows(k, pivot);
        for i in k + 1..N {
            let multiplier = a[(i, k)] / a[(k, k)];
            for j in k..N {
                a[(i, j)] = a[(i, j)] - multiplier * a[(k, j)];
            }
            b[i] = b[i] - multiplier * b[k];
        }
    }
    for k in (0..N).rev() {
        let known = (k + 1..N).fold(b[k], |rest, j| rest - a[(k, j)] * b[j]);
        b[k] = known / a[(k, k)];
    }
    b
}
