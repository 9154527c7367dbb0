//! Rows in echelon form.

/// A row is dependent if elimination leaves less than this fraction of its largest entry.
const NOTHING: f64 = 1e-9;

/// Independent rows, each reduced by the rows before it, with the largest remaining entry as pivot.
pub(crate) struct Echelon {
    columns: usize,
    rows: Vec<Vec<f64>>,
    /// Column of each row's pivot.
    pivots: Vec<usize>,
}

impl Echelon {
    pub(crate) fn new(columns: usize) -> Echelon {
        Echelon { columns, rows: Vec::new(), pivots: Vec::new() }
    }

    /// Adds a row unless it depends on the rows before it; true if it was added.
    pub(crate) fn takes(&mut self, row: Vec<f64>) -> bool {
        self.takes_above(NOTHING, row)
    }

    /// The same for a row of which the rows before leave more than a share.
    pub(crate) fn takes_above(&mut self, share: f64, mut row: Vec<f64>) -> bool {
        let before = largest(&row, 0..self.columns).map_or(0.0, |column| row[column].abs());
        for (done, &pivot) in self.rows.iter().zip(&self.pivots) {
            let factor = row[pivot] / done[pivot];
            row.iter_mut().zip(done).for_each(|(entry, done)| *entry -= factor * done);
        }
        match largest(&row, self.free().into_iter()) {
            Some(pivot) if row[pivot].abs() > share * before => {
                self.rows.push(row);
                self.pivots.push(pivot);
                true
            }
            _ => false,
        }
    }

    /// Columns without a pivot, in ascending order.
    pub(crate) fn free(&self) -> Vec<usize> {
        (0..self.columns).filter(|column| !self.pivots.contains(column)).collect()
    }

    /// Basis of the null space: for each free column the vector with entry 1 there and 0 in the other free columns.
    pub(crate) fn null_space(&self) -> Vec<Vec<f64>> {
        let vector = |free: usize| {
            let mut vector = vec![0.0; self.columns];
            vector[free] = 1.0;
            for (row, &pivot) in self.rows.iter().zip(&self.pivots).rev() {
                let sum: f64 = row.iter().zip(&vector).map(|(entry, value)| entry * value).sum();
                vector[pivot] -= sum / row[pivot];
            }
            vector
        };
        self.free().into_iter().map(vector).collect()
    }
}

/// The column of the largest entry.
fn largest(row: &[f64], columns: impl Iterator<Item = usize>) -> Option<usize> {
    columns.max_by(|one, two| row[*one].abs().total_cmp(&row[*two].abs()))
}

#[cfg(test)]
mod tests {
    use super::Echelon;

    #[test]
    fn rows_that_follow_are_not_taken_and_the_null_space_is_orthogonal_to_all() {
        let rows = [[1.0, 2.0, 0.0, -1.0, 3.0], [0.5, 0.0, 4.0, 2.0, -1.0], [2.0, 2.0, 8.0, 3.0, 1.0], [0.0, 1.0, 1.0, 0.0, 2.0]];
        let mut echelon = Echelon::new(5);
        // The third row is the first plus twice the second.
        assert_eq!(rows.map(|row| echelon.takes(row.to_vec())), [true, true, false, true]);
        let null_space = echelon.null_space();
        assert_eq!((null_space.len(), echelon.free().len()), (2, 2));
        for vector in null_space {
            for row in rows {
                let product: f64 = row.iter().zip(&vector).map(|(entry, value)| entry * value).sum();
                assert!(product.abs() < 1e-14, "{product:e}");
            }
        }
    }

    #[test]
    fn a_row_of_zeros_is_never_taken() {
        assert!(!Echelon::new(3).takes(vec![0.0; 3]));
        assert!(!Echelon::new(0).takes(Vec::new()));
    }
}
