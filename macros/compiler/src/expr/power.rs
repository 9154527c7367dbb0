//! Powers with real exponents.

use super::{Arena, Exact, Expr, Node, Unary};

impl Arena {
    /// A power, also of a base that is zero.
    pub(crate) fn real_power(&mut self, base: Expr, exponent: Expr) -> Expr {
        let constant = self.as_constant(exponent).map(Exact::to_f64);
        let may_vanish_at_zero = constant.is_none_or(|exponent| exponent > 0.0 && exponent.fract() != 0.0);
        if let Some(inner) = self.inside_positive_part(base).filter(|_| may_vanish_at_zero) {
            return self.power_of_positive_part(inner, exponent, constant.is_some());
        }
        let expr = self.by_formula(base, exponent);
        let is_smooth_at_zero = constant.is_some_and(|exponent| exponent > 2.0 && exponent.fract() != 0.0);
        if is_smooth_at_zero && self.as_constant(base).is_none() { self.with_zero(base, expr) } else { expr }
    }

    /// Multiplications for a whole exponent, a power of the square root for a half-integer, exp and ln otherwise.
    fn by_formula(&mut self, base: Expr, exponent: Expr) -> Expr {
        let twice = self.as_constant(exponent).map(|exponent| 2.0 * exponent.to_f64());
        let halves = twice.filter(|value| value.fract() == 0.0 && value.abs() <= f64::from(i32::MAX)).map(|value| value as i32);
        match halves {
            Some(halves) if halves % 2 == 0 => self.power(base, halves / 2),
            Some(halves) => {
                let root = self.sqrt(base);
                self.power(root, halves)
            }
            None => {
                let logarithm = self.unary(Unary::Ln, base);
                let product = self.mul(exponent, logarithm);
                self.unary(Unary::Exp, product)
            }
        }
    }

    /// Extends a fractional power above the second to the base 0. There it vanishes with its first two derivatives, but its formula
    /// with roots or logarithms is singular. Below 0 neither it nor its first three derivatives have a value: acos −2 is none.
    fn with_zero(&mut self, base: Expr, power: Expr) -> Expr {
        let (zero, sign, cube) = (self.integer(0), self.unary(Unary::Sign, base), self.power(base, 3));
        let twice = self.add(sign, sign);
        let angle = self.unary(Unary::Acos, twice);
        let otherwise = self.mul(cube, angle);
        self.select(zero, base, power, otherwise)
    }

    /// x of `max(x, 0)` and `max(0, x)`.
    fn inside_positive_part(&self, base: Expr) -> Option<Expr> {
        let Node::Select { lhs, rhs, then, otherwise } = *self.node(base) else { return None };
        let is_zero = |expr: Expr| self.as_constant(expr).is_some_and(|value| value.is_zero());
        let is_max = (lhs, rhs) == (otherwise, then);
        match is_max {
            true if is_zero(rhs) => Some(lhs),
            true if is_zero(lhs) => Some(rhs),
            _ => None,
        }
    }

    /// max(x, 0)ⁿ: for x ≤ 0 it vanishes with all derivatives, which its formula does not tell. With an exponent that is not positive it has no
    /// value there.
    fn power_of_positive_part(&mut self, inner: Expr, exponent: Expr, is_positive: bool) -> Expr {
        let (zero, power) = (self.integer(0), self.by_formula(inner, exponent));
        let otherwise = if is_positive { zero } else { self.select(zero, exponent, zero, power) };
        self.select(zero, inner, power, otherwise)
    }
}
