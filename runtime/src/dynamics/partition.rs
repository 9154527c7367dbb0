//! Dependent and independent speeds.

use nalgebra::{SMatrix, SVector};

use crate::number::Float;

/// A pivot below this fraction of its row counts as zero.
const DEPENDENT: f64 = 1e-10;

/// Rows J x = b solved for dependent unknowns, by Gauss-Jordan elimination with complete pivoting.
///
/// ```text
/// x_d = b' − R x_i
/// ```
pub(super) struct Partition<T, const M: usize, const I: usize> {
    /// Unknowns: the dependent ones in the order of the rows, then the independent ones.
    pub(super) order: [usize; I],
    /// Row that each pivot stands in.
    pub(super) rank: usize,
    /// The eliminated matrix, whose dependent columns are unit vectors.
    pub(super) matrix: SMatrix<T, M, I>,
    /// b'
    pub(super) side: SVector<T, M>,
}

impl<T: Float, const M: usize, const I: usize> Partition<T, M, I> {
    /// Eliminates rows.
    ///
    /// * `lengths`: given, for each unknown the number that makes it comparable with the others.
    /// * `takes_part`: given, true for each row that counts.
    ///
    /// # Errors
    /// The number of a row that depends on the others.
    pub(super) fn new(
        mut matrix: SMatrix<T, M, I>,
        mut side: SVector<T, M>,
        lengths: &[T; I],
        takes_part: impl Fn(usize) -> bool,
    ) -> Result<Self, usize> {
        let mut order: [usize; I] = core::array::from_fn(|k| k);
        let mut names: [usize; M] = core::array::from_fn(|k| k);
        let mut sizes = [T::ZERO; M];
        let mut count = 0;
        for row in 0..M {
            if !takes_part(row) {
                continue;
            }
            swap_rows(&mut matrix, &mut side, count, row);
            names[count] = row;
            for column in 0..I {
                sizes[count] = sizes[count].max((matrix[(count, column)] * lengths[column]).abs());
            }
            count += 1;
        }
        for rank in 0..count {
            let mut best = (T::ZERO, rank, rank);
            for row in rank..count {
                for column in rank..I {
                    let size = (matrix[(row, order[column])] * lengths[order[column]]).abs();
                    // Rows count by their own size.
                    if size * sizes[best.1] > best.0 * sizes[row] || best.0 == T::ZERO && size > T::ZERO {
                        best = (size, row, column);
                    }
                }
            }
            let (size, row, column) = best;
            let is_independent = size > T::of(DEPENDENT) * sizes[row];
            if rank >= I || !is_independent {
                return Err(names[row]);
            }
            swap_rows(&mut matrix, &mut side, rank, row);
            names.swap(rank, row);
            sizes.swap(rank, row);
            order.swap(rank, column);
            eliminate(&mut matrix, &mut side, (rank, count), &order);
        }
        Ok(Self { order, rank: count, matrix, side })
    }

    /// Unknowns, of which the independent ones are given by their place behind the dependent ones.
    pub(super) fn unknowns(&self, independent: impl Fn(usize) -> T) -> SVector<T, I> {
        let mut unknowns = SVector::from_element(T::ZERO);
        for (place, &unknown) in self.order[self.rank..].iter().enumerate() {
            unknowns[unknown] = independent(place);
        }
        for (row, &unknown) in self.order[..self.rank].iter().enumerate() {
            let mut value = self.side[row];
            for &other in &self.order[self.rank..] {
                value = value - self.matrix[(row, other)] * unknowns[other];
            }
            unknowns[unknown] = value;
        }
        unknowns
    }

    /// Speeds for a unit of the independent one at a place, with homogeneous rows.
    pub(super) fn unit(&self, place: usize) -> SVector<T, I> {
        let mut motion = SVector::from_element(T::ZERO);
        let own = self.order[self.rank + place];
        motion[own] = T::of(1.0);
        for (row, &unknown) in self.order[..self.rank].iter().enumerate() {
            motion[unknown] = -self.matrix[(row, own)];
        }
        motion
    }

    /// Number of independent unknowns.
    pub(super) fn independent(&self) -> usize {
        I - self.rank
    }
}

fn swap_rows<T: Float, const M: usize, const I: usize>(matrix: &mut SMatrix<T, M, I>, side: &mut SVector<T, M>, one: usize, two: usize) {
    if one != two {
        matrix.swap_rows(one, two);
        side.swap_rows(one, two);
    }
}

/// Makes the column of a pivot a unit vector.
fn eliminate<T: Float, const M: usize, const I: usize>(
    matrix: &mut SMatrix<T, M, I>,
    side: &mut SVector<T, M>,
    (rank, count): (usize, usize),
    order: &[usize; I],
) {
    let own = order[rank];
    let pivot = matrix[(rank, own)];
    for &other in &order[rank..] {
        matrix[(rank, other)] = matrix[(rank, other)] / pivot;
    }
    side[rank] = side[rank] / pivot;
    for row in (0..count).filter(|row| *row != rank) {
        let factor = matrix[(row, own)];
        if factor == T::ZERO {
            continue;
        }
        for &other in &order[rank..] {
            matrix[(row, other)] = matrix[(row, other)] - factor * matrix[(rank, other)];
        }
        side[row] = side[row] - factor * side[rank];
    }
}
