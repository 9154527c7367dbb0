//! Lengths that are written without a unit, which makes them metres.
//!
//! A bare number far longer than all lengths with units was hardly meant in metres.

use crate::diag::{Doubt, Range, Warning, quantity};
use crate::quantity::Dim;
use crate::syntax::ast::{Expression, ExpressionKind};
use std::collections::BTreeMap;

/// A bare length is doubted if it is longer than this many times the longest one with a unit.
const FAR: f64 = 30.0;

/// A shorter one is a length in metres as people write it: `0.5` beside `3mm`.
const LEAST: f64 = 5.0;

/// What was found of lengths while a mechanism is resolved.
#[derive(Default)]
pub(crate) struct Lengths {
    /// The longest length with a unit, in m.
    pub(crate) longest: f64,
    /// Numbers without a unit where a length is wanted, by their place in the tree, in the order found.
    bare: BTreeMap<usize, (usize, Range, String)>,
}

impl Lengths {
    /// Keeps a number without a unit.
    pub(crate) fn note(&mut self, written: &Expression) {
        let number = if let ExpressionKind::Negative(inner) = &written.kind { inner.as_ref() } else { written };
        if let ExpressionKind::Number { digits, unit } = &number.kind
            && unit.is_empty()
        {
            // An item that stands many times is one place: it is shared, not copied.
            let order = self.bare.len();
            self.bare.entry(std::ptr::from_ref(number).addr()).or_insert((order, number.range, digits.clone()));
        }
    }

    /// Warnings of numbers that are out of proportion.
    pub(crate) fn doubts(self) -> Vec<Warning> {
        let mut bare: Vec<(usize, Range, String)> = self.bare.into_values().collect();
        bare.sort_by_key(|(order, ..)| *order);
        let is_far = |digits: &str| digits.parse::<f64>().is_ok_and(|value| self.longest > 0.0 && value >= LEAST.max(FAR * self.longest));
        let far = bare.into_iter().filter(|(_, _, digits)| is_far(digits));
        let longest = quantity(self.longest, Dim::LENGTH);
        far.map(|(_, range, number)| Warning { doubt: Doubt::BareLength { number, longest: longest.clone() }, range }).collect()
    }
}
