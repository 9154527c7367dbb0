//! Warnings about conversions of quantities that carry their units: `2 * pi * speed / 60 * t`, `sin(arm.angle * pi / 180)`.

use super::forms::as_factor;
use crate::diag::{Doubt, Warning};
use crate::quantity::{self, Dim};
use crate::syntax::ast::{Expression, ExpressionKind, FormalKind, Item, Operator, every_item};
use proc_macro2::Ident;
use std::collections::BTreeMap;

/// Names of parameters and inputs that are angles or angular velocities.
pub(super) struct Angular(BTreeMap<String, Dim>);

impl Angular {
    pub(super) fn of(items: &[Item]) -> Angular {
        let mut named = BTreeMap::new();
        // A name that means something else elsewhere tells nothing.
        let mut note = |name: &Ident, dim: Option<Dim>| {
            let dim = dim.filter(|dim| is_angular(*dim)).unwrap_or(Dim::NUMBER);
            named.entry(name.to_string()).and_modify(|known| *known = if *known == dim { dim } else { Dim::NUMBER }).or_insert(dim);
        };
        for item in every_item(items) {
            match item {
                Item::Parameter(quantity) | Item::Input(quantity) => note(&quantity.name, quantity.dimension.dim()),
                Item::Let(binding) => note(&binding.name, of_literal(&binding.value)),
                Item::Function(function) => function.argument.iter().for_each(|argument| note(argument, None)),
                Item::Component(component) => component.head.parameters.iter().for_each(|formal| match &formal.kind {
                    FormalKind::Scalar(dimension) => note(&formal.name, dimension.dim()),
                    _ => note(&formal.name, None),
                }),
                Item::For(repeated) => note(&repeated.variable, None),
                _ => {}
            }
        }
        Angular(named)
    }

    /// Warnings about the longest products in an expression.
    pub(super) fn doubts(&self, value: &Expression) -> Vec<Warning> {
        let mut found: Vec<Warning> = Vec::new();
        // A product is visited before its own factors.
        let mut factors = 0_usize;
        value.each(&mut |part| {
            if factors > 0 {
                factors -= 1;
            } else if let Some(warning) = self.doubt(part) {
                found.push(warning);
                part.each(&mut |_| factors += 1);
                factors -= 1;
            }
        });
        found
    }

    fn doubt(&self, value: &Expression) -> Option<Warning> {
        let mut product = Taken { angular: None, number: 1.0, pi: 0, kept: Vec::new(), is_plain: true };
        self.take(value, false, &mut product);
        let Taken { angular: Some(dim), number, pi, kept, is_plain: true } = product else { return None };
        let is = |wanted: f64| (number / wanted - 1.0).abs() < 1e-12;
        let is_speed = dim != Dim::ANGLE;
        let into = match pi {
            1 if is(1.0 / 180.0) || is_speed && (is(2.0) || is(1.0 / 30.0)) => "",
            -1 if kept.len() > 1 => return None,
            -1 if is(180.0) && !is_speed => " / 1deg",
            -1 if is(180.0) => " / 1deg_s",
            -1 if is(30.0) && is_speed => " / 1rpm",
            _ => return None,
        };
        let instead = format!("{}{into}", kept.join(" * "));
        Some(Warning { doubt: Doubt::ConvertedTwice { written: value.to_string(), instead }, range: value.range })
    }

    /// Takes the factors of a product apart.
    fn take(&self, value: &Expression, is_below: bool, product: &mut Taken) {
        match &value.kind {
            ExpressionKind::Binary(Operator::Mul, one, two) => [one, two].into_iter().for_each(|side| self.take(side, is_below, product)),
            ExpressionKind::Binary(Operator::Div, one, two) => {
                self.take(one, is_below, product);
                self.take(two, !is_below, product);
            }
            ExpressionKind::Number { digits, unit } if unit.is_empty() => {
                let number = digits.parse::<f64>().unwrap_or(f64::NAN);
                product.number *= if is_below { 1.0 / number } else { number };
            }
            ExpressionKind::Path(_) if value.name().is_some_and(|name| name == "pi") => product.pi += if is_below { -1 } else { 1 },
            _ => {
                let dim = self.dim(value);
                product.is_plain &= !is_below && (dim.is_none() || product.angular.is_none());
                product.angular = product.angular.or(dim);
                product.kept.push(as_factor(value));
            }
        }
    }

    /// The dimension of an angle or an angular velocity.
    fn dim(&self, value: &Expression) -> Option<Dim> {
        match &value.kind {
            ExpressionKind::Negative(inner) => self.dim(inner),
            ExpressionKind::Field(_, name) if name == "angle" => Some(Dim::ANGLE),
            ExpressionKind::Field(_, name) if name == "angular_velocity" => Some(Dim::ANGLE.per(Dim::TIME)),
            ExpressionKind::Path(_) => self.0.get(&value.name()?.to_string()).copied().filter(|dim| *dim != Dim::NUMBER),
            _ => of_literal(value),
        }
    }
}

/// True for angles and angular velocities.
fn is_angular(dim: Dim) -> bool {
    [Dim::ANGLE, Dim::ANGLE.per(Dim::TIME)].contains(&dim)
}

/// The dimension of `20deg` and `600rpm`; a number in radians may have been converted to them: `2 * pi * 1rad_s`.
fn of_literal(value: &Expression) -> Option<Dim> {
    match &value.kind {
        ExpressionKind::Negative(inner) => of_literal(inner),
        ExpressionKind::Number { unit, .. } if !["rad", "mrad", "rad_s"].contains(&unit.as_str()) => {
            quantity::unit(unit).map(|(_, dim)| dim).filter(|dim| is_angular(*dim))
        }
        _ => None,
    }
}

/// The factors of a product.
struct Taken {
    /// Dimension of the only angle or angular velocity.
    angular: Option<Dim>,
    /// Taken of the numbers without a unit.
    number: f64,
    /// Power of π.
    pi: i32,
    /// All other factors.
    kept: Vec<String>,
    /// True if they stand above, and one of them is an angle or an angular velocity.
    is_plain: bool,
}
