//! Hyper-dual numbers as a number type of the runtime: exact first and second derivatives by evaluation.

use num_dual::{DualNum, HyperDual64};
use reuleaux::{Real, Table};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// a + b ε₁ + c ε₂ + d ε₁ε₂
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hyper(pub(crate) HyperDual64);

impl Hyper {
    /// x with given derivatives along the first and the second direction.
    pub(crate) fn new(x: f64, first: f64, second: f64) -> Self {
        Self(HyperDual64::new(x, first, second, 0.0))
    }

    /// x along a motion with a given rate and acceleration.
    pub(crate) fn moving(x: f64, rate: f64, acceleration: f64) -> Self {
        Self(HyperDual64::new(x, rate, rate, acceleration))
    }

    /// f(x), where f, f' and f" are known at x.
    fn chain(self, (value, first, second): (f64, f64, f64)) -> Self {
        let HyperDual64 { eps1, eps2, eps1eps2, .. } = self.0;
        Self(HyperDual64::new(value, first * eps1, first * eps2, first * eps1eps2 + second * eps1 * eps2))
    }

    /// f, f' and f" at x; only the value of f" is valid.
    fn jet(self, jet: (f64, f64, f64)) -> (Self, Self, Self) {
        (self.chain(jet), self.chain((jet.1, jet.2, f64::NAN)), self.chain((jet.2, f64::NAN, f64::NAN)))
    }
}

macro_rules! operators {
    ($($trait:ident $function:ident)*) => {
        $(impl $trait for Hyper {
            type Output = Self;
            fn $function(self, other: Self) -> Self {
                Self(self.0.$function(other.0))
            }
        })*
    };
}

operators!(Add add Sub sub Mul mul Div div);

impl Neg for Hyper {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Hyper {
    fn of(value: f64) -> Self {
        Self(HyperDual64::from_re(value))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self(sine), Self(cosine))
    }
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    fn tan(self) -> Self {
        Self(self.0.tan())
    }
    fn asin(self) -> Self {
        Self(self.0.asin())
    }
    fn acos(self) -> Self {
        Self(self.0.acos())
    }
    fn atan(self) -> Self {
        Self(self.0.atan())
    }
    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0))
    }
    fn exp(self) -> Self {
        Self(self.0.exp())
    }
    fn ln(self) -> Self {
        Self(self.0.ln())
    }
    fn abs(self) -> Self {
        if self.0.re < 0.0 { -self } else { self }
    }
    fn sign(self) -> Self {
        Self::of(self.0.re.sign())
    }
    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        if lhs.0.re < rhs.0.re { then } else { otherwise }
    }
    fn table(self, table: &Table) -> (Self, Self, Self) {
        self.jet(table.evaluate(self.0.re))
    }
    fn map(self, function: fn(f64) -> (f64, f64, f64)) -> (Self, Self, Self) {
        self.jet(function(self.0.re))
    }
}
