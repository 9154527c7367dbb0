//! Rows whose derivatives vanish at every configuration.

use super::Numeric;
use super::samples::LOOKS;
use crate::expr::{Evaluator, Expr, Values, magnitudes};
use std::collections::BTreeSet;

/// Cancelling terms leave at most this fraction of their magnitude.
const ROUNDING: f64 = 1e-12;

/// Derivatives above this, in m and rad, are not zero.
const NEGLIGIBLE: f64 = 1e-6;

impl Numeric<'_> {
    /// The rows whose derivatives consist of terms that cancel at every configuration.
    pub(crate) fn resting(&self) -> &BTreeSet<usize> {
        self.resting.get_or_init(|| self.found_resting())
    }

    fn found_resting(&self) -> BTreeSet<usize> {
        let system = self.system;
        let rows: Vec<Vec<Expr>> =
            system.equations.iter().map(|equation| equation.jacobian.iter().map(|(_, entry)| *entry).collect()).collect();
        let entries: Vec<Expr> = rows.concat();
        let mut evaluator = Evaluator::new(&system.arena, &entries);
        let mut values = vec![f64::NAN; entries.len()];
        let mut resting: BTreeSet<usize> = (0..rows.len()).collect();
        for look in 0..LOOKS {
            let known = Values { coordinates: &self.anywhere(look), ..self.known };
            evaluator.run(&known, &mut values);
            let mut rest = values.as_slice();
            let ends: Vec<&[f64]> = rows.iter().map(|row| rest.split_off(..row.len()).unwrap_or_default()).collect();
            // This test excludes most rows at once.
            let is_small = |row: &usize| ends[*row].iter().all(|value| value.abs() < NEGLIGIBLE * self.size.min(1.0));
            let cancels = |row: &usize| {
                let sizes = magnitudes(&system.arena, &rows[*row], &known);
                ends[*row].iter().zip(sizes).all(|(value, size)| value.abs() <= ROUNDING * size)
            };
            resting.retain(|row| is_small(row) && cancels(row));
        }
        resting
    }
}
