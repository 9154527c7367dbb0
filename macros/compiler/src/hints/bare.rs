//! Warnings about numbers without a unit, which count in SI.
//!
//! A bare length far longer than all lengths with units was probably not meant in metres, an angle of more than a turn not in radians, and an
//! angular velocity of a motor not in radians per second.

use crate::diag::{AngleOf, Doubt, Range, Warning, quantity};
use crate::quantity::Dim;
use crate::syntax::ast::{Expression, ExpressionKind};
use std::collections::BTreeMap;

/// A bare length causes a warning if it exceeds the longest length with a unit by this factor.
const FAR: f64 = 30.0;

/// A bare length below this (m) causes none: `0.5` beside `3mm` is plausible in metres.
const LEAST: f64 = 5.0;

/// A bare angular velocity causes a warning from here on (rad/s): motors are told in rpm.
const FAST: f64 = 500.0;

/// Numbers without units recorded while a mechanism is resolved.
#[derive(Default)]
pub(crate) struct BareNumbers {
    /// Longest length with a unit, in m.
    pub(crate) longest: f64,
    /// The numbers, by their address in the tree.
    found: BTreeMap<usize, Bare>,
}

/// A number without a unit in the place of a quantity.
struct Bare {
    /// Order of their occurrence.
    order: usize,
    range: Range,
    digits: String,
    dim: Dim,
}

impl BareNumbers {
    /// Records a number without a unit in a place where one of dimension `dim` is wanted.
    pub(crate) fn note(&mut self, written: &Expression, dim: Dim) {
        let number = if let ExpressionKind::Negative(inner) = &written.kind { inner.as_ref() } else { written };
        if let ExpressionKind::Number { digits, unit } = &number.kind
            && unit.is_empty()
        {
            // Instances of one item share their tree, so that each number is recorded once.
            let order = self.found.len();
            let bare = Bare { order, range: number.range, digits: digits.clone(), dim };
            self.found.entry(std::ptr::from_ref(number).addr()).or_insert(bare);
        }
    }

    /// Warnings about numbers that are out of proportion.
    pub(crate) fn doubts(self) -> Vec<Warning> {
        let mut found: Vec<Bare> = self.found.into_values().collect();
        found.sort_by_key(|bare| bare.order);
        let longest = self.longest;
        found.into_iter().filter_map(|bare| Some(Warning { doubt: bare.doubt(longest)?, range: bare.range })).collect()
    }
}

impl Bare {
    fn doubt(&self, longest: f64) -> Option<Doubt> {
        let (value, number) = (self.digits.parse::<f64>().ok()?, self.digits.clone());
        match self.dim {
            Dim::LENGTH if longest > 0.0 && value >= LEAST.max(FAR * longest) => {
                Some(Doubt::BareLength { number, longest: quantity(longest, Dim::LENGTH) })
            }
            Dim::ANGLE if value > std::f64::consts::TAU => Some(Doubt::BareAngle { of: AngleOf::Part, number }),
            dim if dim == Dim::ANGLE.per(Dim::TIME) && value >= FAST => Some(Doubt::BareSpeed { number }),
            _ => None,
        }
    }
}
