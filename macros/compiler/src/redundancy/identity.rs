//! Rows that are constant: sin² + cos² = 1, or the distance between two points of one body.
//!
//! In: a [`System`]. Out: a refusal of each joint with such a row. Rows without coordinates in their pattern have been refused before; the
//! derivatives of these rows consist of terms that cancel at every configuration.

use crate::diag::{Diag, EquationFact};
use crate::expr::{Evaluator, Expr, Leaf, Values, magnitudes};
use crate::model::{Model, Said};
use crate::numeric::at_defaults;
use crate::numeric::samples::LOOKS;
use crate::syntax::ast::Closing;
use crate::system::System;

/// Cancelling terms leave at most this fraction of their magnitude.
const ROUNDING: f64 = 1e-12;

/// Derivatives above this, in m and rad, are not zero.
const NEGLIGIBLE: f64 = 1e-6;

/// Refuses rows whose derivatives vanish at every configuration.
pub(super) fn rows_depend_on_positions(model: &Model, system: &System, diag: &mut Diag) -> Option<()> {
    if model.closing != Closing::Deny {
        // Placeholder defaults prove nothing.
        return Some(());
    }
    let rows: Vec<Vec<Expr>> =
        system.equations.iter().map(|equation| equation.jacobian.iter().map(|(_, entry)| *entry).collect()).collect();
    let entries: Vec<Expr> = rows.concat();
    let resting = at_defaults(model, system, |numeric| {
        let mut evaluator = Evaluator::new(&system.arena, &entries);
        let mut values = vec![f64::NAN; entries.len()];
        let mut resting: Vec<usize> = (0..rows.len()).collect();
        for look in 0..LOOKS {
            let known = Values { coordinates: &numeric.anywhere(look), ..numeric.known };
            evaluator.run(&known, &mut values);
            let mut rest = values.as_slice();
            let ends: Vec<&[f64]> = rows.iter().map(|row| rest.split_off(..row.len()).unwrap_or_default()).collect();
            // This test excludes most rows at once.
            let is_small = |row: &usize| ends[*row].iter().all(|value| value.abs() < NEGLIGIBLE * numeric.size.min(1.0));
            let cancels = |row: &usize| {
                let sizes = magnitudes(&system.arena, &rows[*row], &known);
                ends[*row].iter().zip(sizes).all(|(value, size)| value.abs() <= ROUNDING * size)
            };
            resting.retain(|row| is_small(row) && cancels(row));
        }
        resting
    });
    let mut said = Said::default();
    for equation in resting.into_iter().map(|row| &system.equations[row]) {
        let joint = &model.joints[equation.joint];
        if said.is_new(&joint.name) {
            let leaves = |(_, entry): &(usize, Expr)| system.arena.leaves(*entry);
            let at_defaults = equation.jacobian.iter().flat_map(leaves).any(|leaf| matches!(leaf, Leaf::Parameter(_)));
            let (row, of) = (equation.row + 1, joint.residuals.len());
            let fact = EquationFact::RowOfNothing { joint: joint.name.to_string(), row, of, at_defaults };
            diag.refuse::<()>(&joint.name, fact);
        }
    }
    diag.is_clean().then_some(())
}
