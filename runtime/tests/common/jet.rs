//! A number with its first and second derivative along a line: the second number type, after the floats, that is a `Real`.

use core::ops::{Add, Div, Mul, Neg, Sub};

use reuleaux::{Real, Table};

/// x(s), x'(s), x"(s) at s = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<T>(pub T, pub T, pub T);

impl<T: Real> Jet<T> {
    /// f(x) from f, f' and f" at the value of x.
    fn chain(self, f: T, f1: T, f2: T) -> Self {
        Self(f, f1 * self.1, f1 * self.2 + f2 * self.1 * self.1)
    }
}

impl<T: Real> Add for Jet<T> {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self(self.0 + b.0, self.1 + b.1, self.2 + b.2)
    }
}

impl<T: Real> Sub for Jet<T> {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        Self(self.0 - b.0, self.1 - b.1, self.2 - b.2)
    }
}

impl<T: Real> Mul for Jet<T> {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        Self(self.0 * b.0, self.1 * b.0 + self.0 * b.1, self.2 * b.0 + T::of(2.0) * self.1 * b.1 + self.0 * b.2)
    }
}

impl<T: Real> Div for Jet<T> {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        let r = T::of(1.0) / b.0;
        self * b.chain(r, -(r * r), T::of(2.0) * r * r * r)
    }
}

impl<T: Real> Neg for Jet<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0, -self.1, -self.2)
    }
}

impl<T: Real> Real for Jet<T> {
    fn of(value: f64) -> Self {
        Self(T::of(value), T::of(0.0), T::of(0.0))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.0.sin_cos();
        (self.chain(s, c, -s), self.chain(c, -s, -c))
    }
    fn sqrt(self) -> Self {
        let root = self.0.sqrt();
        let slope = T::of(0.5) / root;
        self.chain(root, slope, -slope / (T::of(2.0) * self.0))
    }
    fn tan(self) -> Self {
        let (s, c) = self.sin_cos();
        s / c
    }
    fn asin(self) -> Self {
        let cosine = (T::of(1.0) - self.0 * self.0).sqrt();
        self.chain(self.0.asin(), T::of(1.0) / cosine, self.0 / (cosine * cosine * cosine))
    }
    fn acos(self) -> Self {
        Self::of(core::f64::consts::FRAC_PI_2) - self.asin()
    }
    fn atan(self) -> Self {
        self.atan2(Self::of(1.0))
    }
    fn atan2(self, x: Self) -> Self {
        let (y, r) = (self, self.0 * self.0 + x.0 * x.0);
        let first = (x.0 * y.1 - y.0 * x.1) / r;
        let second = (x.0 * y.2 - y.0 * x.2) / r - T::of(2.0) * first * (x.0 * x.1 + y.0 * y.1) / r;
        Self(y.0.atan2(x.0), first, second)
    }
    fn exp(self) -> Self {
        let e = self.0.exp();
        self.chain(e, e, e)
    }
    fn ln(self) -> Self {
        let r = T::of(1.0) / self.0;
        self.chain(self.0.ln(), r, -(r * r))
    }
    fn abs(self) -> Self {
        self * self.sign()
    }
    fn sign(self) -> Self {
        Self(self.0.sign(), T::of(0.0), T::of(0.0))
    }
    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        let pick = |a, b| T::select_less(lhs.0, rhs.0, a, b);
        Self(pick(then.0, otherwise.0), pick(then.1, otherwise.1), pick(then.2, otherwise.2))
    }
    fn table(self, table: &Table) -> (Self, Self, Self) {
        let (f, f1, f2) = self.0.table(table);
        let zero = T::of(0.0);
        (self.chain(f, f1, f2), self.chain(f1, f2, zero), self.chain(f2, zero, zero))
    }
    fn map(self, function: fn(f64) -> (f64, f64, f64)) -> (Self, Self, Self) {
        let (f, f1, f2) = self.0.map(function);
        let zero = T::of(0.0);
        (self.chain(f, f1, f2), self.chain(f1, f2, zero), self.chain(f2, zero, zero))
    }
}
