//! Rows of numbers, entry by entry, two at a time where the processor adds and multiplies two at a time.
//!
//! LLVM vectorises only short code by itself. In a mechanism over numbers with many derivatives, which is thousands of lines long, it
//! forms pairs in one place and splits them in the next.

use super::Float;

/// Two numbers in one register.
pub trait Pair<T>: Copy {
    /// Two numbers.
    fn of(first: T, second: T) -> Self;
    /// The two numbers.
    fn both(self) -> [T; 2];
    /// Entrywise sum.
    #[must_use]
    fn plus(self, other: Self) -> Self;
    /// Entrywise difference.
    #[must_use]
    fn minus(self, other: Self) -> Self;
    /// Entrywise product.
    #[must_use]
    fn times(self, other: Self) -> Self;
}

/// A row computed entry by entry from two rows.
#[inline(always)]
fn zip<T: Float, const P: usize>(x: &[T; P], y: &[T; P], pairs: impl Fn(T::Pair, T::Pair) -> T::Pair, last: impl Fn(T, T) -> T) -> [T; P] {
    let mut row = [T::ZERO; P];
    let mut k = 0;
    while k + 1 < P {
        [row[k], row[k + 1]] = pairs(T::Pair::of(x[k], x[k + 1]), T::Pair::of(y[k], y[k + 1])).both();
        k += 2;
    }
    if k < P {
        row[k] = last(x[k], y[k]);
    }
    row
}

/// x + y
#[inline(always)]
pub(crate) fn sum<T: Float, const P: usize>(x: &[T; P], y: &[T; P]) -> [T; P] {
    zip(x, y, |x, y| x.plus(y), |x, y| x + y)
}

/// x − y
#[inline(always)]
pub(crate) fn difference<T: Float, const P: usize>(x: &[T; P], y: &[T; P]) -> [T; P] {
    zip(x, y, |x, y| x.minus(y), |x, y| x - y)
}

/// −x
#[inline(always)]
pub(crate) fn negated<T: Float, const P: usize>(x: &[T; P]) -> [T; P] {
    scaled(T::of(-1.0), x)
}

/// a x
#[inline(always)]
pub(crate) fn scaled<T: Float, const P: usize>(a: T, x: &[T; P]) -> [T; P] {
    let both = T::Pair::of(a, a);
    zip(x, x, |x, _| both.times(x), |x, _| a * x)
}

/// a x + b y
#[inline(always)]
pub(crate) fn combined<T: Float, const P: usize>(a: T, b: T, x: &[T; P], y: &[T; P]) -> [T; P] {
    let (each, other) = (T::Pair::of(a, a), T::Pair::of(b, b));
    zip(x, y, |x, y| each.times(x).plus(other.times(y)), |x, y| a * x + b * y)
}

/// x − a y
#[inline(always)]
pub(crate) fn less<T: Float, const P: usize>(a: T, x: &[T; P], y: &[T; P]) -> [T; P] {
    let both = T::Pair::of(a, a);
    zip(x, y, |x, y| x.minus(both.times(y)), |x, y| x - a * y)
}

/// Fallback for processors without a type of register pairs.
impl<T: Float> Pair<T> for [T; 2] {
    #[inline(always)]
    fn of(first: T, second: T) -> Self {
        [first, second]
    }
    #[inline(always)]
    fn both(self) -> [T; 2] {
        self
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        [self[0] + other[0], self[1] + other[1]]
    }
    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        [self[0] - other[0], self[1] - other[1]]
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        [self[0] * other[0], self[1] * other[1]]
    }
}

#[cfg(feature = "pairs")]
impl Pair<f64> for wide::f64x2 {
    #[inline(always)]
    fn of(first: f64, second: f64) -> Self {
        Self::new([first, second])
    }
    #[inline(always)]
    fn both(self) -> [f64; 2] {
        self.to_array()
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        self + other
    }
    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        self - other
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        self * other
    }
}
