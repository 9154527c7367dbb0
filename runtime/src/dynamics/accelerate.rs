//! Accelerations of the integrated coordinates, in closed form or by elimination of the dependent ones.
//!
//! ```text
//! u̇ = N a + p          J N = 0, J p = γ
//! (Nᵀ M N) a = −Nᵀ (f + M p)
//! ```

use nalgebra::{SMatrix, SVector};

use super::equations::{Balance, Dynamics};
use super::partition::{Partition, Pivots, Redundant, WORSE};
use super::places::{are_finite, moved};
use super::stopped::Stopped;
use crate::number::Scalar;

/// Times ε: a pivot of the mass matrix below this fraction of its diagonal entry counts as zero.
const MASSLESS: f64 = 500.0;

/// The accelerations of the integrated coordinates. `pivots` are taken if they are still good, and are replaced if not.
pub(super) fn accelerations<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (q, qd): (&SVector<T, N>, &SVector<T, N>),
    t: T,
    pivots: &mut Option<Pivots<T, M, I>>,
) -> Result<[T; I], Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    match mechanism.accelerations(q, qd, t) {
        Some(found) => Ok(found.data.0[0]),
        None => eliminated(mechanism, (q, qd), t, pivots),
    }
}

/// The same where they are not known in closed form.
#[inline(never)]
pub(super) fn eliminated<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (q, qd): (&SVector<T, N>, &SVector<T, N>),
    t: T,
    pivots: &mut Option<Pivots<T, M, I>>,
) -> Result<[T; I], Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let mut balance = Balance::zero();
    mechanism.balance(q, qd, t, &mut balance);
    let Balance { jacobian, gamma, mass, forces } = &mut balance;
    let lengths = lengths(mechanism);
    let mut parts = Partition::empty();
    let known = pivots.as_ref().map(|pivots| (pivots, T::of(WORSE)));
    parts
        .solve((jacobian, gamma), known, &lengths, &[true; M], &redundant(mechanism))
        .map_err(|row| if is_state_finite((q, qd), t) { singular::<T, S, N, I, M, R>(t, row) } else { Stopped::NotFinite { time: t } })?;
    *pivots = Some(parts.pivots);
    let count = parts.independent();
    // M p
    let at_rest = times(mass, &parts.unknowns(&[T::ZERO; I]));
    let side = moved(&forces.data.0[0], T::of(1.0), &at_rest);
    let mut right = [T::ZERO; I];
    // Nᵀ M N takes the place of the entries of M between independent speeds, which only zeros multiply once they are replaced.
    for (k, right) in right.iter_mut().enumerate().take(count) {
        let motion = parts.unit(k);
        let momentum = times(mass, &motion);
        for j in 0..=k {
            set(mass, [parts.independent_at(k), parts.independent_at(j)], dot(&momentum, &parts.unit(j)));
        }
        *right = -dot(&side, &motion);
    }
    solve(mass, &parts.order_of_independent(), &mut right, count).map_err(|k| {
        if !is_state_finite((q, qd), t) {
            return Stopped::NotFinite { time: t };
        }
        let unknown = S::INTEGRATED.get(parts.independent_at(k)).copied().unwrap_or(0);
        let (owner, coordinate) = S::COORDINATES.get(unknown).map_or(("", ""), |coordinate| (coordinate.body, coordinate.name));
        Stopped::Massless { time: t, owner, coordinate }
    })?;
    Ok(parts.unknowns(&right))
}

fn is_state_finite<T: Scalar, const N: usize>((q, qd): (&SVector<T, N>, &SVector<T, N>), t: T) -> bool {
    are_finite(q.as_slice()) && are_finite(qd.as_slice()) && t.is_finite()
}

/// The failure if a row depends on the others.
pub(super) fn singular<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(time: T, row: usize) -> Stopped<T>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    Stopped::Singular { time, joint: S::JOINTS.get(row).copied().unwrap_or_default() }
}

/// L for lengths, 1 for angles.
pub(super) fn lengths<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(mechanism: &S) -> [T; I]
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    where_lengths(&S::IS_LENGTH, mechanism.characteristic_length())
}

/// The rows of redundant joints, of the equations between integrated coordinates or of those at t = 0.
pub(super) fn redundant<T, S, const N: usize, const I: usize, const M: usize, const R: usize, const K: usize>(
    mechanism: &S,
) -> Redundant<T, K>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let length = if S::REDUNDANT > 0 { mechanism.characteristic_length() } else { T::of(1.0) };
    Redundant { count: S::REDUNDANT, sizes: powers(&S::POWERS, length) }
}

/// `length` for coordinates in m, 1 for the others.
fn where_lengths<T: Scalar, const I: usize>(is_length: &[bool; I], length: T) -> [T; I] {
    let mut lengths = [T::of(1.0); I];
    for (own, is_length) in lengths.iter_mut().zip(is_length) {
        if *is_length {
            *own = length;
        }
    }
    lengths
}

/// For each of the first rows its power of `length`.
fn powers<T: Scalar, const R: usize, const K: usize>(powers: &[u8; R], length: T) -> [T; K] {
    let mut sizes = [T::of(1.0); K];
    for (size, power) in sizes.iter_mut().zip(powers) {
        for _ in 0..*power {
            *size = *size * length;
        }
    }
    sizes
}

/// A product with a symmetric matrix, of which the lower triangle counts.
fn times<T: Scalar, const I: usize>(lower: &SMatrix<T, I, I>, vector: &[T; I]) -> [T; I] {
    let mut product = [T::ZERO; I];
    for (k, entries) in lower.data.0.iter().enumerate() {
        let mut own = product[k] + entries[k] * vector[k];
        for row in k + 1..I {
            product[row] = product[row] + entries[row] * vector[k];
            own = own + entries[row] * vector[row];
        }
        product[k] = own;
    }
    product
}

/// An entry of a symmetric matrix, of which the lower triangle counts.
#[inline(always)]
fn entry<T: Scalar, const I: usize>(lower: &SMatrix<T, I, I>, [one, two]: [usize; 2]) -> T {
    lower.data.0.get(one.min(two)).and_then(|column| column.get(one.max(two))).copied().unwrap_or(T::ZERO)
}

#[inline(always)]
fn set<T: Scalar, const I: usize>(lower: &mut SMatrix<T, I, I>, [one, two]: [usize; 2], value: T) {
    if let Some(entry) = lower.data.0.get_mut(one.min(two)).and_then(|column| column.get_mut(one.max(two))) {
        *entry = value;
    }
}

fn dot<T: Scalar, const I: usize>(one: &[T; I], two: &[T; I]) -> T {
    one.iter().zip(two).fold(T::ZERO, |sum, (one, two)| sum + *one * *two)
}

/// Solves a positive definite system in place, by L D Lᵀ.
///
/// * `matrix`: given, the lower triangle of a matrix, of which the rows and columns `order[..count]` count.
///
/// # Errors
/// The place of a row that depends on the rows before it, to rounding.
fn solve<T: Scalar, const I: usize>(
    matrix: &mut SMatrix<T, I, I>,
    order: &[usize; I],
    right: &mut [T; I],
    count: usize,
) -> Result<(), usize> {
    let place = |row: usize| order.get(row).copied().unwrap_or(I);
    let at = |row: usize, column: usize| [place(row), place(column)];
    let mut before = [T::ZERO; I];
    for (k, before) in before.iter_mut().enumerate() {
        *before = entry(matrix, at(k, k));
    }
    for k in 0..I {
        if k >= count {
            break;
        }
        // L is stored times D.
        for j in 0..k {
            let factor = entry(matrix, at(k, j)) / entry(matrix, at(j, j));
            for row in k..count {
                let rest = entry(matrix, at(row, k)) - factor * entry(matrix, at(row, j));
                set(matrix, at(row, k), rest);
            }
            right[k] = right[k] - factor * right[j];
        }
        let is_above_zero = entry(matrix, at(k, k)) > T::of(MASSLESS) * T::EPSILON * before[k];
        if !is_above_zero {
            return Err(k);
        }
    }
    for k in (0..I).rev() {
        if k >= count {
            continue;
        }
        for row in k + 1..count {
            right[k] = right[k] - entry(matrix, at(row, k)) * right.get(row).copied().unwrap_or(T::ZERO);
        }
        right[k] = right[k] / entry(matrix, at(k, k));
    }
    Ok(())
}
