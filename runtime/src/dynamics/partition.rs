//! Dependent and independent unknowns.

use nalgebra::{SMatrix, SVector};

use crate::number::Float;

/// A pivot below this fraction of its row counts as zero.
const DEPENDENT: f64 = 1e-10;

/// Known pivots are taken again as long as none falls below this fraction of its size when they were chosen.
const WORSE: f64 = 0.1;

/// Rows J x = b solved for dependent unknowns, by Gauss-Jordan elimination.
///
/// ```text
/// x_d = b' − R x_i
/// ```
pub(super) struct Partition<T, const M: usize, const I: usize> {
    /// Number of dependent unknowns.
    pub(super) rank: usize,
    pub(super) pivots: Pivots<T, M, I>,
    /// The rows: a unit matrix, and R.
    rows: [[T; I]; M],
    /// b'
    side: [T; M],
}

/// An order of elimination.
#[derive(Clone, Copy)]
pub(super) struct Pivots<T, const M: usize, const I: usize> {
    /// Row of each pivot.
    rows: [usize; M],
    /// Unknowns: the dependent ones in the order of the pivots, then the independent ones.
    pub(super) unknowns: [usize; I],
    sizes: [T; M],
}

impl<T: Float, const M: usize, const I: usize> Partition<T, M, I> {
    /// Eliminates rows; each pivot is the largest entry of all, relative to its row.
    ///
    /// * `lengths`: given, for each unknown the number that makes it comparable with the others.
    /// * `takes_part`: given, true for each row that counts.
    ///
    /// # Errors
    /// The number of a row that depends on the others.
    pub(super) fn new(
        matrix: &SMatrix<T, M, I>,
        side: &SVector<T, M>,
        lengths: &[T; I],
        takes_part: impl Fn(usize) -> bool,
    ) -> Result<Self, usize> {
        let pivots = Pivots { rows: core::array::from_fn(|k| k), unknowns: core::array::from_fn(|k| k), sizes: [T::ZERO; M] };
        let mut this = Self { rank: 0, pivots, rows: [[T::ZERO; I]; M], side: [T::ZERO; M] };
        let mut sizes = [T::ZERO; M];
        let mut count = 0;
        for row in (0..M).filter(|row| takes_part(*row)) {
            this.rows[count] = core::array::from_fn(|column| matrix[(row, column)]);
            (this.side[count], this.pivots.rows[count]) = (side[row], row);
            sizes[count] = (0..I).fold(T::ZERO, |size, column| size.max((matrix[(row, column)] * lengths[column]).abs()));
            count += 1;
        }
        while this.rank < count {
            let (row, column) = this.largest(count, &sizes, lengths);
            let size = this.rows[row].get(column).map_or(T::ZERO, |entry| (*entry * lengths[this.pivots.unknowns[column]]).abs());
            let is_independent = size > T::of(DEPENDENT) * sizes[row];
            if !is_independent {
                return Err(this.pivots.rows[row]);
            }
            this.exchange(row, column, count);
            sizes.swap(this.rank, row);
            this.eliminate(count);
        }
        Ok(this)
    }

    /// Eliminates all rows in a known order; `None` if a pivot is much smaller than when it was chosen.
    pub(super) fn along(matrix: &SMatrix<T, M, I>, side: &SVector<T, M>, pivots: &Pivots<T, M, I>) -> Option<Self> {
        let rows = pivots.rows.map(|row| pivots.unknowns.map(|column| matrix[(row, column)]));
        let mut this = Self { rank: 0, pivots: *pivots, rows, side: pivots.rows.map(|row| side[row]) };
        for k in 0..M.min(I) {
            let size = this.rows[k][k].abs();
            let is_as_good = size >= T::of(WORSE) * pivots.sizes[k];
            if !is_as_good {
                return None;
            }
            this.eliminate(M);
        }
        this.pivots.sizes = pivots.sizes;
        Some(this)
    }

    /// Row and column of the largest entry that is left, relative to its row.
    fn largest(&self, count: usize, sizes: &[T; M], lengths: &[T; I]) -> (usize, usize) {
        let mut best = (T::ZERO, self.rank, self.rank);
        for row in self.rank..count {
            for column in self.rank..I {
                let size = (self.rows[row][column] * lengths[self.pivots.unknowns[column]]).abs();
                if size * sizes[best.1] > best.0 * sizes[row] || best.0 == T::ZERO && size > T::ZERO {
                    best = (size, row, column);
                }
            }
        }
        (best.1, best.2)
    }

    /// Puts an entry where the next pivot stands.
    fn exchange(&mut self, row: usize, column: usize, count: usize) {
        let k = self.rank;
        self.rows.swap(k, row);
        self.side.swap(k, row);
        self.pivots.rows.swap(k, row);
        self.pivots.unknowns.swap(k, column);
        for row in &mut self.rows[..count] {
            row.swap(k, column);
        }
    }

    /// Makes the column of the next pivot a unit vector.
    #[inline(always)]
    fn eliminate(&mut self, count: usize) {
        let k = self.rank;
        let (mut own, mut side) = (self.rows[k], self.side[k]);
        self.pivots.sizes[k] = own[k].abs();
        let inverse = T::of(1.0) / own[k];
        for entry in &mut own[k + 1..] {
            *entry = *entry * inverse;
        }
        side = side * inverse;
        for row in (0..count).filter(|row| *row != k) {
            let factor = self.rows[row][k];
            for (entry, own) in self.rows[row][k + 1..].iter_mut().zip(&own[k + 1..]) {
                *entry = *entry - factor * *own;
            }
            self.side[row] = self.side[row] - factor * side;
        }
        (self.rows[k], self.side[k]) = (own, side);
        self.rank += 1;
    }

    /// Unknowns, of which the independent ones are given by their place behind the dependent ones.
    pub(super) fn unknowns(&self, independent: impl Fn(usize) -> T) -> SVector<T, I> {
        let mut unknowns = SVector::from_element(T::ZERO);
        for (row, &unknown) in self.pivots.unknowns[..self.rank].iter().enumerate() {
            unknowns[unknown] = self.side[row];
        }
        for (place, &unknown) in self.pivots.unknowns[self.rank..].iter().enumerate() {
            let value = independent(place);
            unknowns[unknown] = value;
            for (row, &dependent) in self.pivots.unknowns[..self.rank].iter().enumerate() {
                unknowns[dependent] = unknowns[dependent] - self.rows[row][self.rank + place] * value;
            }
        }
        unknowns
    }

    /// Speeds for a unit of the independent one at a place, with homogeneous rows.
    pub(super) fn unit(&self, place: usize) -> SVector<T, I> {
        let mut motion = SVector::from_element(T::ZERO);
        let own = self.rank + place;
        motion[self.pivots.unknowns[own]] = T::of(1.0);
        for (row, &unknown) in self.pivots.unknowns[..self.rank].iter().enumerate() {
            motion[unknown] = -self.rows[row][own];
        }
        motion
    }

    /// The unknown that is the independent one at a place.
    pub(super) fn independent_at(&self, place: usize) -> usize {
        self.pivots.unknowns[self.rank + place]
    }

    /// Number of independent unknowns.
    pub(super) fn independent(&self) -> usize {
        I - self.rank
    }
}

/// True where two matrices, eliminated in the same order, have a pivot of different sign: between them a partition fails, or rank is lost.
pub(super) fn has_other_signs<T: Float, const M: usize, const I: usize>(
    one: &SMatrix<T, M, I>,
    two: &SMatrix<T, M, I>,
    pivots: &Pivots<T, M, I>,
) -> bool {
    let square = |matrix: &SMatrix<T, M, I>| {
        let columns: [usize; M] = core::array::from_fn(|k| pivots.unknowns.get(k).copied().unwrap_or(0));
        signs(pivots.rows.map(|row| columns.map(|column| matrix[(row, column)])))
    };
    M <= I && square(one) != square(two)
}

/// For each pivot whether it is above zero.
fn signs<T: Float, const M: usize>(mut matrix: [[T; M]; M]) -> [bool; M] {
    let mut signs = [true; M];
    for k in 0..M {
        let own = matrix[k];
        signs[k] = own[k] > T::ZERO;
        for row in &mut matrix[k + 1..] {
            let factor = row[k] / own[k];
            for (entry, own) in row[k..].iter_mut().zip(&own[k..]) {
                *entry = *entry - factor * *own;
            }
        }
    }
    signs
}

/// The row that depends most on the others, and what is left of it as a part of the row as it was elsewhere.
pub(super) fn weakest<T: Float, const M: usize, const I: usize>(
    matrix: &SMatrix<T, M, I>,
    elsewhere: &SMatrix<T, M, I>,
    lengths: &[T; I],
) -> (usize, T) {
    let size = |row: usize| (0..I).fold(T::ZERO, |size, k| size.max((elsewhere[(row, k)] * lengths[k]).abs()));
    match Partition::new(matrix, &SVector::from_element(T::ZERO), lengths, |_| true) {
        Ok(parts) => {
            let mut found = (0, T::of(1.0));
            for (k, &row) in parts.pivots.rows.iter().enumerate() {
                let left = parts.pivots.sizes[k] * lengths[parts.pivots.unknowns[k]] / size(row);
                found = if left < found.1 { (row, left) } else { found };
            }
            found
        }
        Err(row) => (row, T::ZERO),
    }
}
