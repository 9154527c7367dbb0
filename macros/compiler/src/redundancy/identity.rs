//! Rows that hold or do not hold wherever the bodies are: sin² + cos² = 1, the distance of two points of one body.
//!
//! In: a [`System`]. Out: a refusal of each joint with such a row. Rows that say so by their pattern alone have been refused before;
//! these have derivatives whose terms cancel, whatever the coordinates.

use crate::diag::{Diag, EquationFact};
use crate::expr::{Evaluator, Expr, Leaf, Values, magnitudes};
use crate::model::{Model, Said};
use crate::numeric::at_defaults;
use crate::numeric::samples::LOOKS;
use crate::syntax::ast::Closing;
use crate::system::System;

/// What is left of terms that cancel is at most this share of them.
const ROUNDING: f64 = 1e-12;

/// Derivatives above this, in m and rad, do not vanish.
const SMALL: f64 = 1e-6;

/// Refuses rows whose derivatives vanish wherever the bodies are.
pub(super) fn rows_depend_on_positions(model: &Model, system: &System, diag: &mut Diag) -> Option<()> {
    if model.closing != Closing::Deny {
        // Numbers that are placeholders tell nothing.
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
            // Most rows are seen to depend on something at once.
            let is_small = |row: &usize| ends[*row].iter().all(|value| value.abs() < SMALL * numeric.size.min(1.0));
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
