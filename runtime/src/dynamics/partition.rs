//! Dependent and independent unknowns.

use nalgebra::{SMatrix, SVector};

use crate::linear::unpermuted;
use crate::number::Scalar;
use crate::number::order::smaller;

/// Times √ε: a pivot below this fraction of its row counts as zero.
const DEPENDENT: f64 = 0.01;

/// Known pivots are taken again as long as none falls below this fraction of its size when they were chosen.
pub(super) const WORSE: f64 = 0.1;

/// The same for pivots kept from step to step: a projection moves dependent coordinates for good, and by small pivots it moves them far.
pub(super) const ABOUT_AS_GOOD: f64 = 0.5;

/// Rows of at most so many entries are subtracted as a whole, which costs less than to look for entries that are not zero.
const SHORT: usize = 12;

/// Longer rows are subtracted in blocks of so many entries; blocks of zeros are passed over.
const ABREAST: usize = 8;

/// Rows J x = b solved for dependent unknowns, by Gauss-Jordan elimination.
///
/// ```text
/// x_d = b' − R x_i
/// ```
pub(super) struct Partition<T, const M: usize, const I: usize> {
    /// Number of dependent unknowns.
    rank: usize,
    pub(super) pivots: Pivots<T, M, I>,
    /// The rows in the order of the pivots: a unit matrix, and R.
    rows: [[T; I]; M],
    /// b'
    side: [T; M],
}

/// Rows of redundant joints.
#[derive(Clone, Copy)]
pub(super) struct Redundant<T, const M: usize> {
    /// How many rows follow from the others.
    pub(super) count: usize,
    /// The natural size of each row, or 1 if there are none. A row may vanish on the way, so that its own size is no measure.
    pub(super) sizes: [T; M],
}

/// An order of elimination.
#[derive(Clone, Copy)]
pub(super) struct Pivots<T, const M: usize, const I: usize> {
    /// Row of each pivot.
    rows: [usize; M],
    /// Unknowns: the dependent ones in the order of the pivots, then the independent ones.
    unknowns: [usize; I],
    /// Size of each pivot when it was chosen.
    sizes: [T; M],
    /// The smallest pivot relative to its row when it was chosen.
    pub(super) weakest: T,
    /// For each pivot of the last elimination, whether it is above zero.
    signs: [bool; M],
    /// Number of pivots.
    count: usize,
}

impl<T, const M: usize, const I: usize> Pivots<T, M, I> {
    /// No pivots.
    #[inline(always)]
    pub(super) fn none() -> Self
    where
        T: Scalar,
    {
        Self { rows: [0; M], unknowns: [0; I], sizes: [T::ZERO; M], weakest: T::of(1.0), signs: [true; M], count: 0 }
    }

    /// Those of the rows that have a pivot.
    pub(super) fn among(&self, rows: &[bool; M]) -> [bool; M] {
        let mut among = [false; M];
        for row in self.rows.iter().take(self.count) {
            if let (Some(is_among), Some(is_one)) = (among.get_mut(*row), rows.get(*row)) {
                *is_among = *is_one;
            }
        }
        among
    }

    /// The smallest pivot relative to the natural size of its row.
    pub(super) fn smallest(&self, lengths: &[T; I], sizes: &[T; M]) -> T
    where
        T: Scalar,
    {
        let lengths = ordered(lengths, &self.unknowns, T::of(1.0));
        let pivots = self.sizes.iter().zip(&lengths).zip(ordered(sizes, &self.rows, T::of(1.0))).take(self.count);
        pivots.fold(T::of(1.0), |smallest, ((pivot, length), size)| smaller(smallest, *pivot * *length / size))
    }

    /// Whether the determinant is above zero; `None` if there are fewer pivots than unknowns.
    pub(super) fn sign(&self) -> Option<bool> {
        let is_odd = |order: &[usize]| {
            let inversions = order.iter().enumerate().map(|(place, one)| order.iter().skip(place).filter(|other| *other < one).count());
            inversions.sum::<usize>() % 2 == 1
        };
        let rows = self.rows.get(..I).filter(|_| self.count == I)?;
        let below = self.signs.iter().take(I).filter(|is_above| !**is_above).count();
        Some((below % 2 == 1) == (is_odd(rows) != is_odd(&self.unknowns)))
    }

    /// True if both have the same order, and pivots of the same signs.
    pub(super) fn agree_with(&self, other: &Self) -> bool {
        self.count == other.count && self.rows == other.rows && self.unknowns == other.unknowns && self.signs == other.signs
    }
}

/// A row of a matrix.
#[inline(always)]
fn row_of<T: Scalar, const M: usize, const I: usize>(matrix: &SMatrix<T, M, I>, row: usize) -> [T; I] {
    let mut entries = [T::ZERO; I];
    for (entry, column) in entries.iter_mut().zip(&matrix.data.0) {
        *entry = column.get(row).copied().unwrap_or(T::ZERO);
    }
    entries
}

/// Writes the rows of a matrix in the order of the pivots.
fn arrange<T: Scalar, const M: usize, const I: usize>(matrix: &SMatrix<T, M, I>, pivots: &Pivots<T, M, I>, rows: &mut [[T; I]; M]) {
    for (entries, row) in rows.iter_mut().zip(&pivots.rows) {
        *entries = ordered(&row_of(matrix, *row), &pivots.unknowns, T::ZERO);
    }
}

/// A row to be subtracted from others.
struct Subtrahend<'a, T, const I: usize> {
    row: &'a [T; I],
    /// For each block of a long row whether an entry is not zero.
    is_filled: [bool; I],
}

impl<'a, T: Scalar, const I: usize> Subtrahend<'a, T, I> {
    #[inline(always)]
    fn new(row: &'a [T; I]) -> Self {
        let mut is_filled = [true; I];
        if I > SHORT {
            for (is_filled, entries) in is_filled.iter_mut().zip(row.chunks(ABREAST)) {
                *is_filled = entries.iter().any(|entry| *entry != T::ZERO);
            }
        }
        Self { row, is_filled }
    }

    /// Subtracts the row times a factor.
    #[inline(always)]
    fn subtract(&self, factor: T, entries: &mut [T; I]) {
        if I <= SHORT {
            for (entry, own) in entries.iter_mut().zip(self.row) {
                *entry = *entry - factor * *own;
            }
        } else if factor != T::ZERO {
            let (blocks, rest) = entries.as_chunks_mut::<ABREAST>();
            let (own_blocks, own_rest) = self.row.as_chunks::<ABREAST>();
            for ((block, own), _) in blocks.iter_mut().zip(own_blocks).zip(&self.is_filled).filter(|(_, is_filled)| **is_filled) {
                for (entry, own) in block.iter_mut().zip(own) {
                    *entry = *entry - factor * *own;
                }
            }
            for (entry, own) in rest.iter_mut().zip(own_rest) {
                *entry = *entry - factor * *own;
            }
        }
    }
}

/// Some entries of a list, in another order.
fn ordered<X: Copy, const K: usize, const L: usize>(list: &[X; K], order: &[usize; L], otherwise: X) -> [X; L] {
    let mut entries = [otherwise; L];
    for (entry, place) in entries.iter_mut().zip(order) {
        *entry = list.get(*place).copied().unwrap_or(otherwise);
    }
    entries
}

fn exchange<X: Copy>(list: &mut [X], one: usize, two: usize) {
    let (Some(first), Some(second)) = (list.get(one).copied(), list.get(two).copied()) else { return };
    if let Some(entry) = list.get_mut(one) {
        *entry = second;
    }
    if let Some(entry) = list.get_mut(two) {
        *entry = first;
    }
}

/// Largest entry of a row, in comparable units.
fn size<T: Scalar, const I: usize>(row: &[T; I], lengths: &[T; I]) -> T {
    row.iter().zip(lengths).fold(T::ZERO, |size, (entry, length)| size.max((*entry * *length).abs()))
}

/// The largest entry of a row from a column on, in comparable units, and its column.
fn largest_of<T: Scalar, const I: usize>(row: &[T; I], lengths: &[T; I], first: usize) -> (T, usize) {
    let mut largest = (T::ZERO, first);
    for (column, (entry, length)) in row.iter().zip(lengths).enumerate().skip(first) {
        let entry = (*entry * *length).abs();
        largest = if entry > largest.0 { (entry, column) } else { largest };
    }
    largest
}

/// Rows to be eliminated: J and b.
pub(super) type Rows<'a, T, const M: usize, const I: usize> = (&'a SMatrix<T, M, I>, &'a SVector<T, M>);

// A partition fills the place that it is given: it is too large to be moved.
impl<T: Scalar, const M: usize, const I: usize> Partition<T, M, I> {
    /// No rows.
    #[inline(always)]
    pub(super) fn empty() -> Self {
        Self { rank: 0, pivots: Pivots::none(), rows: [[T::ZERO; I]; M], side: [T::ZERO; M] }
    }

    /// Eliminates rows in the order of `known` pivots if these are given and good, and otherwise by new ones.
    ///
    /// # Errors
    /// The number of a row that depends on the others.
    pub(super) fn solve(
        &mut self,
        rows: Rows<T, M, I>,
        known: Option<(&Pivots<T, M, I>, T)>,
        lengths: &[T; I],
        takes_part: &[bool; M],
        redundant: &Redundant<T, M>,
    ) -> Result<(), usize> {
        if known.is_some_and(|(pivots, fraction)| self.is_good_along(rows, pivots, fraction)) {
            return Ok(());
        }
        self.pivot(rows, lengths, takes_part, redundant)
    }

    /// Eliminates rows; each pivot is the largest entry of all, relative to its row.
    ///
    /// * `lengths`: given, for each unknown the number that makes it comparable with the others.
    /// * `takes_part`: given, true for each row that counts.
    /// * `redundant`: given, rows that follow from the others; the rows that depend most on the others are left out.
    ///
    /// # Errors
    /// The number of a row that depends on the others.
    #[inline(never)]
    pub(super) fn pivot(
        &mut self,
        (matrix, side): Rows<T, M, I>,
        lengths: &[T; I],
        takes_part: &[bool; M],
        redundant: &Redundant<T, M>,
    ) -> Result<(), usize> {
        let (mut sizes, mut lengths) = ([T::ZERO; M], *lengths);
        let mut count = 0_usize;
        self.rank = 0;
        self.pivots = Pivots { unknowns: unpermuted(), ..Pivots::none() };
        let mut open = self.rows.iter_mut().zip(&mut self.side).zip(&mut self.pivots.rows).zip(&mut sizes);
        for ((number, value), takes_part) in side.iter().enumerate().zip(takes_part) {
            if !takes_part {
                continue;
            }
            if let Some((((entries, side), name), own)) = open.next() {
                let in_general = redundant.sizes.get(number).filter(|_| redundant.count > 0);
                *entries = row_of(matrix, number);
                (*side, *name, *own) = (*value, number, in_general.copied().unwrap_or_else(|| size(entries, &lengths)));
                count += 1;
            }
        }
        self.pivots.count = count.saturating_sub(redundant.count);
        let mut largest = [(T::ZERO, 0); M];
        for (largest, row) in largest.iter_mut().zip(&self.rows).take(count) {
            *largest = largest_of(row, &lengths, 0);
        }
        while self.rank < self.pivots.count {
            let rank = self.rank;
            // A row without entries stays as it is.
            let mut best = (T::ZERO, T::of(1.0), rank, rank);
            for (row, ((entry, column), size)) in largest.iter().zip(&sizes).enumerate().take(count).skip(rank) {
                if *entry * best.1 > best.0 * *size {
                    best = (*entry, *size, row, *column);
                }
            }
            let (entry, size, row, column) = best;
            let is_independent = entry > T::of(DEPENDENT) * T::ROOT_EPSILON * size;
            if !is_independent {
                return Err(self.pivots.rows.get(row).copied().unwrap_or(0));
            }
            self.pivots.weakest = smaller(self.pivots.weakest, entry / size);
            exchange(&mut self.rows, rank, row);
            exchange(&mut self.side, rank, row);
            exchange(&mut self.pivots.rows, rank, row);
            exchange(&mut sizes, rank, row);
            exchange(&mut largest, rank, row);
            exchange(&mut self.pivots.unknowns, rank, column);
            exchange(&mut lengths, rank, column);
            for row in self.rows.iter_mut().take(count) {
                exchange(row, rank, column);
            }
            let mut changes = [false; M];
            for (changes, row) in changes.iter_mut().zip(&self.rows).take(count) {
                *changes = row.get(rank).is_some_and(|entry| *entry != T::ZERO);
            }
            self.eliminate(count);
            let others = self.rows.iter().zip(&mut largest).zip(changes).take(count).skip(rank + 1);
            for ((row, found), changes) in others {
                if changes {
                    *found = largest_of(row, &lengths, rank + 1);
                } else if found.1 == rank {
                    found.1 = column;
                }
            }
        }
        Ok(())
    }

    /// Eliminates all rows in a known order; false if a pivot is below a `fraction` of its size when it was chosen.
    #[inline(never)]
    fn is_good_along(&mut self, (matrix, side): Rows<T, M, I>, pivots: &Pivots<T, M, I>, fraction: T) -> bool {
        (self.rank, self.pivots) = (0, *pivots);
        arrange(matrix, pivots, &mut self.rows);
        self.side = ordered(&side.data.0[0], &pivots.rows, T::ZERO);
        for (k, before) in pivots.sizes.iter().enumerate().take(pivots.count) {
            let own = self.rows.get(k).and_then(|row| row.get(k)).map_or(T::ZERO, |own| own.abs());
            let is_as_good = own >= fraction * *before;
            if !is_as_good {
                return false;
            }
            self.eliminate(M);
        }
        self.pivots.sizes = pivots.sizes;
        true
    }

    /// Makes the column of the next pivot a unit vector.
    #[inline(always)]
    fn eliminate(&mut self, count: usize) {
        let k = self.rank;
        self.rank += 1;
        let (Some(&row), Some(&side)) = (self.rows.get(k), self.side.get(k)) else { return };
        let pivot = row.get(k).copied().unwrap_or(T::ZERO);
        let inverse = T::of(1.0) / pivot;
        let (mut own, side) = (row, side * inverse);
        own.iter_mut().for_each(|entry| *entry = *entry * inverse);
        let subtrahend = Subtrahend::new(&own);
        for (row, (entries, value)) in self.rows.iter_mut().zip(&mut self.side).enumerate().take(count) {
            if row == k {
                (*entries, *value) = (own, side);
                continue;
            }
            let factor = entries.get(k).copied().unwrap_or(T::ZERO);
            subtrahend.subtract(factor, entries);
            *value = *value - factor * side;
        }
        if let (Some(size), Some(sign)) = (self.pivots.sizes.get_mut(k), self.pivots.signs.get_mut(k)) {
            (*size, *sign) = (pivot.abs(), pivot > T::ZERO);
        }
    }

    /// Unknowns, of which the independent ones are given by their place behind the dependent ones.
    pub(super) fn unknowns(&self, independent: &[T; I]) -> [T; I] {
        let mut values = [T::ZERO; I];
        for (value, given) in values.iter_mut().skip(self.rank).zip(independent) {
            *value = *given;
        }
        let given = values;
        for ((value, row), side) in values.iter_mut().zip(&self.rows).zip(&self.side).take(self.rank) {
            *value = row.iter().zip(&given).skip(self.rank).fold(*side, |sum, (entry, given)| sum - *entry * *given);
        }
        self.in_order(&values)
    }

    /// Speeds for a unit of the independent one at a place, with homogeneous rows.
    pub(super) fn unit(&self, place: usize) -> [T; I] {
        let own = self.rank + place;
        let mut values = [T::ZERO; I];
        if let Some(value) = values.get_mut(own) {
            *value = T::of(1.0);
        }
        for (value, row) in values.iter_mut().zip(&self.rows).take(self.rank) {
            *value = -row.get(own).copied().unwrap_or(T::ZERO);
        }
        self.in_order(&values)
    }

    /// Values in the order of the pivots, in that of the unknowns.
    fn in_order(&self, values: &[T; I]) -> [T; I] {
        let mut unknowns = [T::ZERO; I];
        for (unknown, value) in self.pivots.unknowns.iter().zip(values) {
            if let Some(entry) = unknowns.get_mut(*unknown) {
                *entry = *value;
            }
        }
        unknowns
    }

    /// The unknown that is the independent one at a place.
    pub(super) fn independent_at(&self, place: usize) -> usize {
        self.pivots.unknowns.get(self.rank + place).copied().unwrap_or(0)
    }

    /// The independent unknowns, in their order; zeros follow.
    pub(super) fn order_of_independent(&self) -> [usize; I] {
        let mut order = [0; I];
        for (own, unknown) in order.iter_mut().zip(self.pivots.unknowns.iter().skip(self.rank)) {
            *own = *unknown;
        }
        order
    }

    /// The entries of the independent unknowns, by their places.
    pub(super) fn independent_of(&self, values: &[T; I]) -> [T; I] {
        ordered(values, &self.order_of_independent(), T::ZERO)
    }

    /// Number of independent unknowns.
    pub(super) fn independent(&self) -> usize {
        I.saturating_sub(self.rank)
    }
}

/// True where two matrices, eliminated in the same order, have a pivot of different sign: between them a partition fails, or rank is lost.
pub(super) fn has_other_signs<T: Scalar, const M: usize, const I: usize>(
    one: &SMatrix<T, M, I>,
    two: &SMatrix<T, M, I>,
    pivots: &Pivots<T, M, I>,
) -> bool {
    signs(one, pivots) != signs(two, pivots)
}

/// For each pivot whether it is above zero.
fn signs<T: Scalar, const M: usize, const I: usize>(matrix: &SMatrix<T, M, I>, pivots: &Pivots<T, M, I>) -> [bool; M] {
    let (mut rows, mut signs) = ([[T::ZERO; I]; M], [true; M]);
    arrange(matrix, pivots, &mut rows);
    for (k, sign) in signs.iter_mut().enumerate().take(pivots.count) {
        let own = rows[k];
        let pivot = own.get(k).copied().unwrap_or(T::ZERO);
        *sign = pivot > T::ZERO;
        let subtrahend = Subtrahend::new(&own);
        for row in rows.iter_mut().skip(k + 1) {
            let factor = row.get(k).copied().unwrap_or(T::ZERO) / pivot;
            subtrahend.subtract(factor, row);
        }
    }
    signs
}

/// The row that depends most on the others, and its remainder relative to the row at a regular state.
pub(super) fn weakest<T: Scalar, const M: usize, const I: usize>(
    matrix: &SMatrix<T, M, I>,
    elsewhere: &SMatrix<T, M, I>,
    lengths: &[T; I],
    takes_part: &[bool; M],
    redundant: &Redundant<T, M>,
) -> (usize, T) {
    let mut parts = Partition::empty();
    if let Err(row) = parts.pivot((matrix, &SVector::from_element(T::ZERO)), lengths, takes_part, redundant) {
        return (row, T::ZERO);
    }
    let Pivots { rows, unknowns, sizes, count, .. } = parts.pivots;
    let own = ordered(lengths, &unknowns, T::of(1.0));
    let mut found = (0, T::of(1.0));
    for ((row, left), length) in rows.iter().zip(&sizes).zip(&own).take(count) {
        let left = *left * *length / size(&row_of(elsewhere, *row), lengths);
        found = if left < found.1 { (*row, left) } else { found };
    }
    found
}
