//! Linear systems over any number type, which need not be comparable.

use crate::number::Real;

/// ε^(−1/4) in double precision.
const LOST: f64 = 8192.0;

/// ε^(−1/4) in single precision.
const LOST_OF_SINGLE: f64 = 53.8;

/// Third derivatives of the unknowns of a block, x with A x = b; not numbers from the condition κ = ε^(−1/4) on, where they have lost all digits.
///
/// * `condition`: given, κ of the state.
#[must_use]
pub fn third_derivatives<T: Real, const K: usize>(condition: T, a: [[T; K]; K], b: [T; K]) -> [T; K] {
    let one = T::of(1.0);
    // Zero in single precision.
    let small = (one + T::of(f64::EPSILON)) - one;
    let most = T::select_less(T::of(0.0), small, T::of(LOST), T::of(LOST_OF_SINGLE));
    solution_by_selection(a, b).map(|x| T::select_less(condition, most, x, T::of(f64::NAN)))
}

/// x with A x = b: Gaussian elimination, whose pivots are chosen by selection in place of comparison, so that it is the same for numbers,
/// SIMD registers and dual numbers.
///
/// Rows are scaled by their largest entries, as rows in m and rows in rad stand side by side, and the largest entry of a column is its pivot.
/// Not a number where A is singular.
///
/// * `a`: given, A by rows.
/// * `b`: given.
///
/// Source: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th edition, section 3.4.
fn solution_by_selection<T: Real, const K: usize>(a: [[T; K]; K], b: [T; K]) -> [T; K] {
    let (mut a, mut x) = (a, b);
    for (row, side) in a.iter_mut().zip(&mut x) {
        let largest = row.iter().fold(T::of(0.0), |largest, entry| largest.max(entry.abs()));
        row.iter_mut().for_each(|entry| *entry = *entry / largest);
        *side = *side / largest;
    }
    for k in 0..K {
        for i in k + 1..K {
            exchange_if_less(&mut a, &mut x, k, i);
        }
        let (pivots, below) = a.split_at_mut(k + 1);
        let (sides, sides_below) = x.split_at_mut(k + 1);
        for (row, side) in below.iter_mut().zip(sides_below) {
            let factor = row[k] / pivots[k][k];
            for (entry, above) in row[k + 1..].iter_mut().zip(&pivots[k][k + 1..]) {
                *entry = *entry - factor * *above;
            }
            *side = *side - factor * sides[k];
        }
    }
    for k in (0..K).rev() {
        let sum = a[k][k + 1..].iter().zip(&x[k + 1..]).fold(x[k], |sum, (entry, known)| sum - *entry * *known);
        x[k] = sum / a[k][k];
    }
    x
}

/// Exchanges row k and row i where the entry of row k in column k is the smaller one.
fn exchange_if_less<T: Real, const K: usize>(a: &mut [[T; K]; K], x: &mut [T; K], k: usize, i: usize) {
    let (here, there) = (a[k][k].abs(), a[i][k].abs());
    let chosen = |one: T, two: T| (T::select_less(here, there, two, one), T::select_less(here, there, one, two));
    let (above, below) = a.split_at_mut(i);
    for (one, two) in above[k][k..].iter_mut().zip(&mut below[0][k..]) {
        (*one, *two) = chosen(*one, *two);
    }
    (x[k], x[i]) = chosen(x[k], x[i]);
}
