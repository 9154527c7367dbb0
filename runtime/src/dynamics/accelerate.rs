//! Accelerations.
//!
//! ```text
//! u̇ = N a + p          J N = 0, J p = γ
//! (Nᵀ M N) a = −Nᵀ (f + M p)
//! ```

use nalgebra::{SMatrix, SVector};

use super::equations::{Balance, Dynamics};
use super::partition::{Partition, Pivots};
use super::stopped::Stopped;
use crate::number::Float;

/// A pivot of the mass matrix below this fraction of the largest one counts as zero.
const MASSLESS: f64 = 1e-13;

/// The accelerations of the integrated coordinates. `pivots` are taken if they are still good, and are replaced if not.
pub(super) fn accelerations<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (q, qd): (&SVector<T, N>, &SVector<T, N>),
    t: T,
    pivots: &mut Option<Pivots<T, M, I>>,
) -> Result<SVector<T, I>, Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    if let Some(found) = mechanism.accelerations(q, qd, t) {
        return Ok(found);
    }
    let Balance { jacobian, gamma, mass, forces } = mechanism.balance(q, qd, t);
    let lengths = lengths(mechanism);
    let parts = match pivots.as_ref().and_then(|pivots| Partition::along(&jacobian, &gamma, pivots)) {
        Some(parts) => parts,
        None => Partition::new(&jacobian, &gamma, &lengths, |_| true)
            .map_err(|row| Stopped::Singular { time: t, joint: S::JOINTS.get(row).copied().unwrap_or_default() })?,
    };
    *pivots = Some(parts.pivots);
    let count = parts.independent();
    let rest = parts.unknowns(|_| T::ZERO);
    let moved = times(&mass, &rest);
    let side = SVector::<T, I>::from_fn(|k, _| forces[k] + moved[k]);
    // Columns N, and M N below the ones that are done.
    let mut motions = SMatrix::<T, I, I>::from_element(T::ZERO);
    let mut reduced = SMatrix::<T, I, I>::from_element(T::ZERO);
    let mut right = SVector::<T, I>::from_element(T::ZERO);
    for k in 0..count {
        let motion = parts.unit(k);
        let momentum = times(&mass, &motion);
        motions.set_column(k, &motion);
        for j in 0..=k {
            reduced[(k, j)] = dot(&momentum, |i| motions[(i, j)]);
        }
        right[k] = -dot(&side, |i| motion[i]);
    }
    let found = solve(&mut reduced, &mut right, count, |k| lengths[parts.independent_at(k)]);
    if let Err(k) = found {
        let unknown = S::INTEGRATED[parts.independent_at(k)];
        let (owner, coordinate) = S::COORDINATES.get(unknown).map_or(("", ""), |coordinate| (coordinate.body, coordinate.name));
        return Err(Stopped::Massless { time: t, owner, coordinate });
    }
    Ok(parts.unknowns(|place| right[place]))
}

/// L for lengths, 1 for angles.
pub(super) fn lengths<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(mechanism: &S) -> [T; I]
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let length = mechanism.characteristic_length();
    S::IS_LENGTH.map(|is_length| if is_length { length } else { T::of(1.0) })
}

fn times<T: Float, const I: usize>(lower: &SMatrix<T, I, I>, vector: &SVector<T, I>) -> SVector<T, I> {
    SVector::from_fn(|row, _| dot(vector, |k| if k <= row { lower[(row, k)] } else { lower[(k, row)] }))
}

fn dot<T: Float, const I: usize>(vector: &SVector<T, I>, other: impl Fn(usize) -> T) -> T {
    (0..I).fold(T::ZERO, |sum, k| sum + vector[k] * other(k))
}

/// Solves a positive definite system of the first `count` rows in place, by L D Lᵀ.
///
/// # Errors
/// The number of a row whose pivot is not above zero.
fn solve<T: Float, const I: usize>(
    matrix: &mut SMatrix<T, I, I>,
    right: &mut SVector<T, I>,
    count: usize,
    length: impl Fn(usize) -> T,
) -> Result<(), usize> {
    let mut largest = T::ZERO;
    for k in 0..count {
        largest = largest.max(matrix[(k, k)] * length(k) * length(k));
    }
    for k in 0..count {
        let own = matrix[(k, k)];
        let mut pivot = own;
        for j in 0..k {
            let factor = matrix[(k, j)];
            pivot = pivot - factor * factor * matrix[(j, j)];
        }
        let is_above_zero = pivot * length(k) * length(k) > T::of(MASSLESS) * largest;
        if !is_above_zero {
            return Err(k);
        }
        matrix[(k, k)] = pivot;
        for i in k + 1..count {
            let mut entry = matrix[(i, k)];
            for j in 0..k {
                entry = entry - matrix[(i, j)] * matrix[(j, j)] * matrix[(k, j)];
            }
            matrix[(i, k)] = entry / pivot;
        }
    }
    for k in 0..count {
        for j in 0..k {
            right[k] = right[k] - matrix[(k, j)] * right[j];
        }
    }
    for k in 0..count {
        right[k] = right[k] / matrix[(k, k)];
    }
    for k in (0..count).rev() {
        for i in k + 1..count {
            right[k] = right[k] - matrix[(i, k)] * right[i];
        }
    }
    Ok(())
}
