//! Rows that are constant: sin² + cos² = 1, or the distance between two points of one body.
//!
//! In: a [`System`]. Out: a refusal of each joint with such a row. Rows without coordinates in their pattern have been refused before; the
//! derivatives of these rows consist of terms that cancel at every configuration.

use crate::diag::{Diag, EquationFact};
use crate::expr::{Expr, Leaf};
use crate::model::{Model, Said};
use crate::numeric::at_defaults;
use crate::syntax::ast::Closing;
use crate::system::System;

/// Refuses rows whose derivatives vanish at every configuration. In space such a row follows from the joints that its bodies were
/// reached by, if there are any, and is reported as redundant.
pub(super) fn rows_depend_on_positions(model: &Model, system: &System, diag: &mut Diag) -> Option<()> {
    if model.closing != Closing::Deny {
        // Placeholder defaults prove nothing.
        return Some(());
    }
    let resting = at_defaults(model, system, |numeric| numeric.resting().clone());
    let mut said = Said::default();
    for equation in resting.into_iter().map(|row| &system.equations[row]) {
        let joint = &model.joints[equation.joint];
        if system.loop_of(equation.joint).is_empty() && said.is_new(&joint.name) {
            let leaves = |(_, entry): &(usize, Expr)| system.arena.leaves(*entry);
            let at_defaults = equation.jacobian.iter().flat_map(leaves).any(|leaf| matches!(leaf, Leaf::Parameter(_)));
            let (row, of) = (equation.row + 1, joint.residuals.len());
            let fact = EquationFact::RowOfNothing { joint: joint.name.to_string(), row, of, at_defaults };
            diag.refuse::<()>(&joint.name, fact);
        }
    }
    diag.is_clean().then_some(())
}
