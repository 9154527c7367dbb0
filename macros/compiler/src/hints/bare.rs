//! Warnings about numbers without a unit, which count in SI.
//!
//! A bare length far longer than all lengths with units was probably not meant in metres, an angle of more than a turn not in radians, and an
//! angular velocity of a motor not in radians per second.

use super::angles::is_wave;
use crate::diag::{AngleOf, Doubt, Range, Warning, quantity};
use crate::quantity::Dim;
use crate::syntax::ast::{Expression, ExpressionKind, Operator};
use std::collections::BTreeMap;

/// A bare length, or a radius of gyration, causes a warning if it exceeds the longest length with a unit by this factor.
const FAR: f64 = 30.0;

/// A bare length, or a radius of gyration, below this (m) causes none: `0.5` beside `3mm` is plausible in metres.
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
    /// Bodies with their radii of gyration, in m, and the places of their inertias.
    gyrations: Vec<(String, f64, Range)>,
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
    /// Records the numbers without a unit in a place where a quantity of dimension `dim` is wanted: the value itself, its terms, the factors of
    /// waves and laws, and the values of a table.
    pub(crate) fn note(&mut self, written: &Expression, dim: Dim) {
        match &written.kind {
            ExpressionKind::Number { digits, unit } if unit.is_empty() => {
                // Instances of one item share their tree, so that each number is recorded once.
                let order = self.found.len();
                let bare = Bare { order, range: written.range, digits: digits.clone(), dim };
                self.found.entry(std::ptr::from_ref(written).addr()).or_insert(bare);
            }
            ExpressionKind::Negative(inner) => self.note(inner, dim),
            ExpressionKind::Binary(Operator::Add | Operator::Sub, one, two) => {
                self.note(one, dim);
                self.note(two, dim);
            }
            ExpressionKind::Binary(Operator::Mul, one, two) if is_wave(two) => self.note(one, dim),
            ExpressionKind::Binary(Operator::Mul, one, two) if is_wave(one) => self.note(two, dim),
            ExpressionKind::If { then, otherwise, .. } => {
                self.note(then, dim);
                self.note(otherwise, dim);
            }
            ExpressionKind::Call(function, arguments) if function.last == "table" => {
                if let Some(greatest) = arguments.get(1).and_then(greatest_value) {
                    self.note(greatest, dim);
                }
            }
            _ => {}
        }
    }

    /// Records the radius of gyration (m) of a body, whose inertia stands at `range`.
    pub(crate) fn note_gyration(&mut self, body: &str, radius: f64, range: Range) {
        // Instances of one item share it.
        if self.gyrations.iter().all(|(_, _, known)| known.first.start() != range.first.start()) {
            self.gyrations.push((body.to_owned(), radius, range));
        }
    }

    /// Warnings about numbers that are out of proportion.
    pub(crate) fn doubts(self) -> Vec<Warning> {
        let mut found: Vec<Bare> = self.found.into_values().collect();
        found.sort_by_key(|bare| bare.order);
        let longest = self.longest;
        let is_wide = |radius: f64| longest > 0.0 && radius > LEAST.max(FAR * longest);
        let wide = self.gyrations.into_iter().filter(|(_, radius, _)| is_wide(*radius)).map(|(body, radius, range)| {
            let about = format!("{radius:.2e}").parse().unwrap_or(radius);
            let [radius, longest] = [about, longest].map(|length| quantity(length, Dim::LENGTH));
            Warning { doubt: Doubt::WideInertia { body, radius, longest }, range }
        });
        let bare = found.into_iter().filter_map(|bare| Some(Warning { doubt: bare.doubt(longest)?, range: bare.range }));
        bare.chain(wide).collect()
    }
}

/// The second number of the pair with the greatest one.
fn greatest_value(pairs: &Expression) -> Option<&Expression> {
    let ExpressionKind::List(items) = &pairs.kind else { return None };
    let value = |number: &Expression| match &number.kind {
        ExpressionKind::Number { digits, .. } => digits.parse::<f64>().ok(),
        _ => None,
    };
    let seconds = items.iter().filter_map(|item| match &item.kind {
        ExpressionKind::Tuple(pair) => pair.get(1),
        _ => None,
    });
    seconds.filter_map(|number| Some((value(number)?, number))).max_by(|one, two| one.0.total_cmp(&two.0)).map(|(_, number)| number)
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
