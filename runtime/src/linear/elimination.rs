//! Gaussian elimination in an order that is fixed when the mechanism is compiled.
//!
//! In: the entries of A that are not identically zero. Out: those of L and U, and the numbers from which their stability is judged.
//! The order is data ([`Order`]); the provided functions loop over it, and emitted code unrolls them where the result is short.

use core::marker::PhantomData;

use crate::number::{Float, Real, row};

/// The pattern of a matrix of K rows and the order of its elimination.
///
/// ```text
/// A(rows[i], columns[j]) = Σ_k L(i, k) U(k, j)        L has the diagonal 1
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Order<const K: usize, const ENTRIES: usize, const FACTORS: usize> {
    /// Row and column of each entry of A that is stored.
    pub pattern: [(usize, usize); ENTRIES],
    /// The row of A in which each pivot stands.
    pub rows: [usize; K],
    /// The column of A in which each pivot stands.
    pub columns: [usize; K],
    /// Row and column of each entry of L (below the diagonal) and U, row by row, by number of the pivot. They include every entry
    /// of A and the fill-in.
    pub factors: [(usize, usize); FACTORS],
}

/// The result of an elimination.
#[derive(Clone, Copy, Debug)]
pub struct Eliminated<T, const K: usize, const FACTORS: usize> {
    /// L and U; the reciprocals of the pivots on the diagonal.
    pub lu: [T; FACTORS],
    /// |U(i, i)| c_i by pivot
    pub pivots: [T; K],
    /// The rows of |L| |U| c by pivot.
    pub grown: [T; K],
    /// The rows of |A| c by pivot.
    pub sizes: [T; K],
}

/// The elimination of one block's Jacobian.
pub trait Elimination<T: Real, const K: usize, const ENTRIES: usize, const FACTORS: usize>: 'static {
    /// The pattern and the order.
    const ORDER: Order<K, ENTRIES, FACTORS>;

    /// Columns of the quaternions for which [`Turning`](super::Turning) has their norm and three turns.
    const QUATERNIONS: &'static [[usize; 4]] = &[];

    /// L and U of A. They are not finite where a pivot is zero.
    ///
    /// * `a`: given, the stored entries of A.
    /// * `c`: given, the scale of each unknown.
    fn eliminate(a: &[T; ENTRIES], c: &[T; K]) -> Eliminated<T, K, FACTORS> {
        eliminate(&Self::ORDER, &const { Places::of(&Self::ORDER) }, a, c)
    }

    /// x of A x = b by the factors of A.
    ///
    /// * `put`: given, computes y_i of L y = b from b_i and Σ L(i, k) y_k: their difference, unless the caller changes it.
    fn substitute(lu: &[T; FACTORS], b: &[T; K], put: impl Fn(T, T) -> T) -> [T; K] {
        substitute(&Self::ORDER, &const { Places::of(&Self::ORDER) }, lu, b, put)
    }

    /// A x
    fn product(a: &[T; ENTRIES], x: &[T; K]) -> [T; K] {
        let mut product = [T::of(0.0); K];
        for (&entry, &(i, j)) in a.iter().zip(&Self::ORDER.pattern) {
            product[i] = product[i] + entry * x[j];
        }
        product
    }
}

/// The order of `E`, an elimination of matrices of `G`, for matrices of other numbers.
#[derive(Clone, Copy, Debug)]
pub struct InOrder<E, G>(PhantomData<(E, G)>);

impl<T, E, G, const K: usize, const ENTRIES: usize, const FACTORS: usize> Elimination<T, K, ENTRIES, FACTORS> for InOrder<E, G>
where
    T: Real,
    G: Real,
    E: Elimination<G, K, ENTRIES, FACTORS>,
{
    const ORDER: Order<K, ENTRIES, FACTORS> = E::ORDER;
}

/// L y = b, U z = y, and x is z in the order of columns, for each column of B.
pub(super) fn substitute_rows<T, E, const K: usize, const ENTRIES: usize, const FACTORS: usize, const P: usize>(
    lu: &[T; FACTORS],
    b: &[[T; P]; K],
) -> [[T; P]; K]
where
    T: Float,
    E: Elimination<T, K, ENTRIES, FACTORS>,
{
    let (order, places) = (&E::ORDER, &const { Places::of(&E::ORDER) });
    let (mut y, mut x) = ([[T::ZERO; P]; K], [[T::ZERO; P]; K]);
    for i in 0..K {
        let known = |rest, place: usize| row::less(lu[place], &rest, &y[order.factors[place].1]);
        y[i] = (places.rows[i]..places.pivots[i]).fold(b[order.rows[i]], known);
    }
    for i in (0..K).rev() {
        let known = |rest, place: usize| row::less(lu[place], &rest, &y[order.factors[place].1]);
        let rest = (places.pivots[i] + 1..places.ends[i]).fold(y[i], known);
        y[i] = row::scaled(lu[places.pivots[i]], &rest);
        x[order.columns[i]] = y[i];
    }
    x
}

/// Positions in the arrays.
#[derive(Clone, Copy, Debug)]
struct Places<const K: usize, const ENTRIES: usize> {
    /// Index of each entry of A among the factors.
    entries: [usize; ENTRIES],
    /// Index of the first entry of each row of the factors.
    rows: [usize; K],
    /// Index of the diagonal entry of each row.
    pivots: [usize; K],
    /// Index of the first entry of the next row.
    ends: [usize; K],
}

impl<const K: usize, const ENTRIES: usize> Places<K, ENTRIES> {
    /// Evaluated at compile time; an incomplete order is a compile error.
    const fn of<const FACTORS: usize>(order: &Order<K, ENTRIES, FACTORS>) -> Self {
        let mut places = Self { entries: [0; ENTRIES], rows: [0; K], pivots: order.pivots(), ends: [FACTORS; K] };
        let (mut row_of, mut column_of) = ([0; K], [0; K]);
        let mut i = 0;
        while i < K {
            row_of[order.rows[i]] = i;
            column_of[order.columns[i]] = i;
            places.rows[i] = order.find(i, 0, true);
            if i > 0 {
                places.ends[i - 1] = places.rows[i];
            }
            i += 1;
        }
        let mut n = 0;
        while n < ENTRIES {
            let (row, column) = order.pattern[n];
            places.entries[n] = order.find(row_of[row], column_of[column], false);
            n += 1;
        }
        places
    }
}

impl<const K: usize, const ENTRIES: usize, const FACTORS: usize> Order<K, ENTRIES, FACTORS> {
    /// Index of an entry among the factors, or of the first entry of its row.
    const fn find(&self, row: usize, column: usize, is_first: bool) -> usize {
        let mut place = 0;
        while self.factors[place].0 != row || (!is_first && self.factors[place].1 != column) {
            place += 1;
        }
        place
    }

    /// Index of each pivot among the factors.
    pub(super) const fn pivots(&self) -> [usize; K] {
        let mut pivots = [0; K];
        let mut i = 0;
        while i < K {
            pivots[i] = self.find(i, i, false);
            i += 1;
        }
        pivots
    }

    /// Whether the exchanges of rows and columns change the sign of the determinant.
    pub(super) const fn is_odd(&self) -> bool {
        is_odd(&self.rows) != is_odd(&self.columns)
    }
}

/// Whether a permutation has an odd number of inversions.
const fn is_odd<const K: usize>(permutation: &[usize; K]) -> bool {
    let mut odd = false;
    let mut i = 0;
    while i < K {
        let mut j = i + 1;
        while j < K {
            odd ^= permutation[i] > permutation[j];
            j += 1;
        }
        i += 1;
    }
    odd
}

/// Row by row, using the rows before it (Duff, Erisman, Reid: Direct Methods for Sparse Matrices, 5.7).
fn eliminate<T: Real, const K: usize, const ENTRIES: usize, const FACTORS: usize>(
    order: &Order<K, ENTRIES, FACTORS>,
    places: &Places<K, ENTRIES>,
    a: &[T; ENTRIES],
    c: &[T; K],
) -> Eliminated<T, K, FACTORS> {
    let zero = T::of(0.0);
    let mut found = Eliminated { lu: [zero; FACTORS], pivots: [zero; K], grown: [zero; K], sizes: [zero; K] };
    for (&entry, &place) in a.iter().zip(&places.entries) {
        found.lu[place] = entry;
    }
    // |U| c by row, and the index of each column in the current row.
    let (mut upper, mut at) = ([zero; K], [0; K]);
    for i in 0..K {
        for place in places.rows[i]..places.ends[i] {
            let j = order.factors[place].1;
            at[j] = place;
            found.sizes[i] = found.sizes[i] + found.lu[place].abs() * c[order.columns[j]];
        }
        for place in places.rows[i]..places.pivots[i] {
            let k = order.factors[place].1;
            let multiplier = found.lu[place] * found.lu[places.pivots[k]];
            found.lu[place] = multiplier;
            found.grown[i] = found.grown[i] + multiplier.abs() * upper[k];
            for source in places.pivots[k] + 1..places.ends[k] {
                let target = at[order.factors[source].1];
                found.lu[target] = found.lu[target] - multiplier * found.lu[source];
            }
        }
        for place in places.pivots[i]..places.ends[i] {
            upper[i] = upper[i] + found.lu[place].abs() * c[order.columns[order.factors[place].1]];
        }
        let pivot = &mut found.lu[places.pivots[i]];
        found.pivots[i] = pivot.abs() * c[order.columns[i]];
        *pivot = T::of(1.0) / *pivot;
        found.grown[i] = found.grown[i] + upper[i];
    }
    found
}

/// L y = b, U z = y, and x is z in the order of columns.
fn substitute<T: Real, const K: usize, const ENTRIES: usize, const FACTORS: usize>(
    order: &Order<K, ENTRIES, FACTORS>,
    places: &Places<K, ENTRIES>,
    lu: &[T; FACTORS],
    b: &[T; K],
    put: impl Fn(T, T) -> T,
) -> [T; K] {
    let zero = T::of(0.0);
    let (mut y, mut x) = ([zero; K], [zero; K]);
    for i in 0..K {
        let known = (places.rows[i]..places.pivots[i]).fold(zero, |sum, place| sum + lu[place] * y[order.factors[place].1]);
        y[i] = put(b[order.rows[i]], known);
    }
    for i in (0..K).rev() {
        let rest = (places.pivots[i] + 1..places.ends[i]).fold(y[i], |rest, place| rest - lu[place] * y[order.factors[place].1]);
        y[i] = rest * lu[places.pivots[i]];
        x[order.columns[i]] = y[i];
    }
    x
}
