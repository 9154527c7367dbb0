//! Warnings about lengths without a unit, which count as metres.
//!
//! A bare number far longer than all lengths with units was probably not meant in metres.

use crate::diag::{Doubt, Range, Warning, quantity};
use crate::quantity::Dim;
use crate::syntax::ast::{Expression, ExpressionKind};
use std::collections::BTreeMap;

/// A bare length causes a warning if it exceeds the longest length with a unit by this factor.
const FAR: f64 = 30.0;

/// A bare length below this (m) causes none: `0.5` beside `3mm` is plausible in metres.
const LEAST: f64 = 5.0;

/// Lengths recorded while a mechanism is resolved.
#[derive(Default)]
pub(crate) struct Lengths {
    /// Longest length with a unit, in m.
    pub(crate) longest: f64,
    /// Numbers without a unit in place of a length, by their address in the tree, with the order of their occurrence.
    bare: BTreeMap<usize, (usize, Range, String)>,
}

impl Lengths {
    /// Records a number without a unit.
    pub(crate) fn note(&mut self, written: &Expression) {
        let number = if let ExpressionKind::Negative(inner) = &written.kind { inner.as_ref() } else { written };
        if let ExpressionKind::Number { digits, unit } = &number.kind
            && unit.is_empty()
        {
            // Instances of one item share their tree, so that each number is recorded once.
            let order = self.bare.len();
            self.bare.entry(std::ptr::from_ref(number).addr()).or_insert((order, number.range, digits.clone()));
        }
    }

    /// Warnings about numbers that are out of proportion.
    pub(crate) fn doubts(self) -> Vec<Warning> {
        let mut bare: Vec<(usize, Range, String)> = self.bare.into_values().collect();
        bare.sort_by_key(|(order, ..)| *order);
        let is_far = |digits: &str| digits.parse::<f64>().is_ok_and(|value| self.longest > 0.0 && value >= LEAST.max(FAR * self.longest));
        let far = bare.into_iter().filter(|(_, _, digits)| is_far(digits));
        let longest = quantity(self.longest, Dim::LENGTH);
        far.map(|(_, range, number)| Warning { doubt: Doubt::BareLength { number, longest: longest.clone() }, range }).collect()
    }
}
