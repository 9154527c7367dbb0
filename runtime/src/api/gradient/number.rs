//! Numbers with their derivatives, and the operations on them that the solver requires.

use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::SVector;

use crate::number::{DetSign, Float, Real, Scalar, SimdReal, Table, row};

/// A number and its partial derivatives by `P` parameters: the number type of [`derivatives`](crate::Mechanism::derivatives).
///
/// Two of them are equal if their derivatives are too; the order is that of the values. Of equal values with other derivatives neither is
/// the greater. `{}` writes the value, `{:?}` the derivatives too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient<T, const P: usize> {
    /// The number.
    pub value: T,
    /// Its derivative by each parameter, in the order in which the parameters were selected.
    pub by: [T; P],
}

impl<T: Float, const P: usize> Gradient<T, P> {
    /// A constant, which depends on no parameter.
    #[must_use]
    #[inline(always)]
    pub fn constant(value: T) -> Self {
        Self { value, by: [T::of(0.0); P] }
    }

    /// f(x) from its value and slope at x.
    #[inline(always)]
    pub(super) fn chain(self, value: T, slope: T) -> Self {
        Self { value, by: row::scaled(slope, &self.by) }
    }

    /// f(a, b) from its value and its two slopes.
    #[inline(always)]
    fn chain_of_two(self, other: Self, value: T, [own, others]: [T; 2]) -> Self {
        Self { value, by: row::combined(own, others, &self.by, &other.by) }
    }

    /// A function with its value and three derivatives; the third is used only where x depends on a parameter.
    fn derived(self, [value, first, second, third]: [T; 4]) -> (Self, Self, Self) {
        let zero = T::of(0.0);
        let of_second = |by: T| if by == zero { zero } else { third * by };
        (self.chain(value, first), self.chain(first, second), Self { value: second, by: self.by.map(of_second) })
    }
}

/// Functions of the trait [`Real`], without its import.
macro_rules! functions {
    ($($(#[doc = $page:literal])* $name:ident($($argument:ident)?);)*) => {
        impl<T: Float, const P: usize> Gradient<T, P> {
            $($(#[doc = $page])*
            #[must_use]
            #[inline(always)]
            pub fn $name(self $(, $argument: Self)?) -> Self {
                Real::$name(self $(, $argument)?)
            })*
        }
    };
}

functions! {
    /// Square root; not a number below zero.
    sqrt();
    /// Tangent of an angle in radians.
    tan();
    /// Arc sine in radians, from −π/2 to π/2; not a number outside [−1, 1].
    asin();
    /// Arc cosine in radians, from 0 to π; not a number outside [−1, 1].
    acos();
    /// Arc tangent in radians, from −π/2 to π/2.
    atan();
    /// Angle in radians, from −π to π, of the vector (`x`, `self`): `self` is y.
    atan2(x);
    /// e to the power `self`.
    exp();
    /// Natural logarithm; not a number below zero.
    ln();
    /// Absolute value.
    abs();
}

impl<T: Float, const P: usize> Gradient<T, P> {
    /// Sine of an angle in radians.
    #[must_use]
    #[inline(always)]
    pub fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// Cosine of an angle in radians.
    #[must_use]
    #[inline(always)]
    pub fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// The length of a vector, √Σ x²: of the force in a bearing, say. Where it is 0 it has no derivatives; they are NaN.
    #[must_use]
    pub fn norm<const D: usize>(vector: &SVector<Self, D>) -> Self {
        vector.iter().fold(Self::constant(T::ZERO), |sum, part| sum + *part * *part).sqrt()
    }
}

/// Operations with a constant on the right.
macro_rules! with_constant {
    ($($operation:ident $name:ident),*) => {
        $(impl<T: Float, const P: usize> $operation<T> for Gradient<T, P> {
            type Output = Self;
            #[inline(always)]
            fn $name(self, constant: T) -> Self {
                $operation::$name(self, Self::constant(constant))
            }
        })*
    };
}

with_constant!(Add add, Sub sub, Mul mul, Div div);

/// Operations with a constant on the left.
macro_rules! with_constant_first {
    ($float:ident: $($operation:ident $name:ident),*) => {
        $(impl<const P: usize> $operation<Gradient<$float, P>> for $float {
            type Output = Gradient<$float, P>;
            #[inline(always)]
            fn $name(self, other: Gradient<$float, P>) -> Gradient<$float, P> {
                $operation::$name(Gradient::constant(self), other)
            }
        })*
    };
}

with_constant_first!(f64: Add add, Sub sub, Mul mul, Div div);
with_constant_first!(f32: Add add, Sub sub, Mul mul, Div div);

impl<T: Float, const P: usize> Add for Gradient<T, P> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, by: row::sum(&self.by, &other.by) }
    }
}

impl<T: Float, const P: usize> Sub for Gradient<T, P> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, by: row::difference(&self.by, &other.by) }
    }
}

impl<T: Float, const P: usize> Mul for Gradient<T, P> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.chain_of_two(other, self.value * other.value, [other.value, self.value])
    }
}

impl<T: Float, const P: usize> Div for Gradient<T, P> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let reciprocal = T::of(1.0) / other.value;
        let quotient = self.value / other.value;
        self.chain_of_two(other, quotient, [reciprocal, -(quotient * reciprocal)])
    }
}

impl<T: Float, const P: usize> Neg for Gradient<T, P> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, by: row::negated(&self.by) }
    }
}

impl<T: Float, const P: usize> Real for Gradient<T, P> {
    #[inline(always)]
    fn of(value: f64) -> Self {
        Self::constant(T::of(value))
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, T::of(0.5) / root)
    }

    fn tan(self) -> Self {
        let tangent = self.value.tan();
        self.chain(tangent, T::of(1.0) + tangent * tangent)
    }

    fn asin(self) -> Self {
        self.chain(self.value.asin(), T::of(1.0) / leg(self.value))
    }

    fn acos(self) -> Self {
        self.chain(self.value.acos(), T::of(-1.0) / leg(self.value))
    }

    fn atan(self) -> Self {
        self.chain(self.value.atan(), T::of(1.0) / (T::of(1.0) + self.value * self.value))
    }

    fn atan2(self, x: Self) -> Self {
        let square = x.value * x.value + self.value * self.value;
        self.chain_of_two(x, self.value.atan2(x.value), [x.value / square, -self.value / square])
    }

    fn exp(self) -> Self {
        let power = self.value.exp();
        self.chain(power, power)
    }

    fn ln(self) -> Self {
        self.chain(self.value.ln(), T::of(1.0) / self.value)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // Without a branch, so that the optimiser can remove an unused result.
        let slope = T::select_less(self.value, T::ZERO, T::of(-1.0), T::of(1.0));
        self.chain(slope * self.value, slope)
    }

    fn sign(self) -> Self {
        Self::constant(self.value.sign())
    }

    #[inline(always)]
    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        if lhs.value < rhs.value { then } else { otherwise }
    }

    #[inline(always)]
    fn is_less(lhs: Self, rhs: Self) -> Option<bool> {
        Some(lhs.value < rhs.value)
    }

    fn table(self, table: &Table) -> (Self, Self, Self) {
        let (value, first, second) = self.value.table(table);
        self.derived([value, first, second, T::of(table.third_derivative(self.value.to_f64()))])
    }

    /// The third derivative of a Rust function is unknown: where its argument depends on a parameter, results that need it are NaN.
    fn map(self, function: fn(f64) -> (f64, f64, f64)) -> (Self, Self, Self) {
        let (value, first, second) = self.value.map(function);
        self.derived([value, first, second, T::of(f64::NAN)])
    }
}

impl<T: Float, const P: usize> PartialOrd for Gradient<T, P> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.value.partial_cmp(&other.value) {
            Some(Ordering::Equal) if self.by != other.by => None,
            order => order,
        }
    }
    #[inline(always)]
    fn lt(&self, other: &Self) -> bool {
        self.value < other.value
    }
    #[inline(always)]
    fn gt(&self, other: &Self) -> bool {
        self.value > other.value
    }
}

/// Its value, without derivatives.
impl<T: fmt::Display, const P: usize> fmt::Display for Gradient<T, P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value.fmt(f)
    }
}

/// A constant, which depends on no parameter.
impl<T: Float, const P: usize> From<T> for Gradient<T, P> {
    fn from(value: T) -> Self {
        Self::constant(value)
    }
}

impl<T: Float, const P: usize> Scalar for Gradient<T, P> {
    const ZERO: Self = Self { value: T::ZERO, by: [T::ZERO; P] };
    const HAS_DERIVATIVES: bool = P > 0;

    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }

    fn bits(self) -> u64 {
        self.by.iter().fold(self.value.bits(), |bits, by| bits.rotate_left(7) ^ by.bits())
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        self.value.is_finite()
    }

    #[inline(always)]
    fn without_derivatives(self) -> Self {
        Self::constant(self.value)
    }

    #[inline(always)]
    fn derivative(self, parameter: usize) -> Option<Self> {
        self.by.get(parameter).map(|by| Self::constant(*by))
    }

    #[inline(always)]
    fn with_derivative(mut self, parameter: usize, by: Self) -> Self {
        if let Some(own) = self.by.get_mut(parameter) {
            *own = by.value;
        }
        self
    }
}

/// √(1 − x²)
fn leg<T: Float>(x: T) -> T {
    ((T::of(1.0) - x) * (T::of(1.0) + x)).sqrt()
}

/// Comparisons use the values only, not their derivatives.
impl<T: Float, const P: usize> SimdReal for Gradient<T, P> {
    type Mask = bool;
    type Signs = DetSign;

    const EPSILON: Self = Self { value: T::EPSILON, by: [T::ZERO; P] };
    const ROOT_EPSILON: Self = Self { value: T::ROOT_EPSILON, by: [T::ZERO; P] };

    #[inline(always)]
    fn at_most(self, bound: Self) -> bool {
        self.value <= bound.value
    }

    #[inline(always)]
    fn pick(mask: bool, then: Self, otherwise: Self) -> Self {
        if mask { then } else { otherwise }
    }

    fn signs(self) -> DetSign {
        self.value.signs()
    }

    fn same_signs(a: DetSign, b: DetSign) -> bool {
        a == b
    }

    #[inline(always)]
    fn fast_sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.fast_sin_cos();
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }
}
