//! Rows whose derivatives vanish at every configuration, and the sizes of those that do not.

use super::Numeric;
use super::samples::LOOKS;
use crate::expr::{Evaluator, Expr, Values, magnitudes};
use crate::system::Equation;
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

    pub(super) fn found_natural(&self) -> Vec<f64> {
        let system = self.system;
        let entries: Vec<Expr> = system.equations.iter().flat_map(|equation| equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
        let mut evaluator = Evaluator::new(&system.arena, &entries);
        let mut values = vec![f64::NAN; entries.len()];
        let mut largest = vec![0.0_f64; system.equations.len()];
        for look in 0..LOOKS {
            evaluator.run(&Values { coordinates: &self.anywhere(look), ..self.known }, &mut values);
            let mut rest = values.iter();
            for (largest, equation) in largest.iter_mut().zip(&system.equations) {
                for ((unknown, _), value) in equation.jacobian.iter().zip(&mut rest) {
                    // A row that cannot be evaluated there has the size of its dimension.
                    let size = if value.is_finite() { value.abs() * self.scale(*unknown) } else { f64::INFINITY };
                    *largest = largest.max(size);
                }
            }
        }
        let of_dimension = |equation: &Equation| self.size.powi(equation.dim.power_of_length().into());
        system.equations.iter().zip(largest).map(|(equation, largest)| largest.min(of_dimension(equation))).collect()
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
