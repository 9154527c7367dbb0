//! Sine and cosine together without a branch, for the loops of the solver.
//!
//! x = n π/2 + y, |y| ≤ π/4, with π/2 in two parts (Cody and Waite, 1980); sin y and cos y by the polynomials of Sun's fdlibm,
//! whose errors are below 2⁻⁵⁸; then the quarter turn n is put back. Nothing waits for a comparison, and it is written over
//! [`Several`] numbers side by side, because two angles in one SSE2 register take as long as one.

use core::ops::{Add, Mul, Sub};

/// Up to here n has 20 bits, so that n times the first part of π/2, which has 33, is exact; n times the rest is to 2⁻⁶⁷.
pub(crate) const LARGEST: f64 = 1.0e6;

/// The first 33 bits of π/2, and the rest.
const HALF_PI: [f64; 2] = [f64::from_bits(0x3FF9_21FB_5440_0000), f64::from_bits(0x3DD0_B461_1A62_6331)];

/// 1.5 · 2⁵²: adding and subtracting it rounds to the nearest whole number.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// Coefficients of y³, y⁵ … of the sine.
const SINE: [f64; 6] = [
    f64::from_bits(0xBFC5_5555_5555_5549),
    f64::from_bits(0x3F81_1111_1110_F8A6),
    f64::from_bits(0xBF2A_01A0_19C1_61D5),
    f64::from_bits(0x3EC7_1DE3_57B1_FE7D),
    f64::from_bits(0xBE5A_E5E6_8A2B_9CEB),
    f64::from_bits(0x3DE5_D93A_5ACF_D57C),
];

/// Coefficients of y⁴, y⁶ … of the cosine.
const COSINE: [f64; 6] = [
    f64::from_bits(0x3FA5_5555_5555_554C),
    f64::from_bits(0xBF56_C16C_16C1_5177),
    f64::from_bits(0x3EFA_01A0_19CB_1590),
    f64::from_bits(0xBE92_7E4F_809C_52AD),
    f64::from_bits(0x3E21_EE9E_BDB4_B1C4),
    f64::from_bits(0xBDA8_FAE9_BE88_38D4),
];

/// Doubles that are computed with side by side.
pub(crate) trait Several: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// The same number in every place.
    fn of(value: f64) -> Self;

    /// Sine and cosine of an angle that is n quarter turns larger; the low bits of `shifted` are those of n.
    ///
    /// An odd n exchanges the two, the second bit of n turns the sign of the sine, that of n + 1 the cosine's.
    fn quarters(shifted: Self, sine: Self, cosine: Self) -> (Self, Self);
}

/// (sin x, cos x) for |x| < [`LARGEST`], each within one unit of its last place, or 2⁻⁶⁶ if that is more, which is where it is
/// nearly zero.
#[inline(always)]
pub(crate) fn within_range<S: Several>(x: S) -> (S, S) {
    let shifted = x * S::of(core::f64::consts::FRAC_2_PI) + S::of(ROUNDER);
    let n = shifted - S::of(ROUNDER);
    let y = (x - n * S::of(HALF_PI[0])) - n * S::of(HALF_PI[1]);
    let z = y * y;
    let zz = z * z;
    let [s0, s1, s2, s3, s4, s5] = SINE.map(S::of);
    let tail = (s0 + z * s1) + zz * ((s2 + z * s3) + zz * (s4 + z * s5));
    let sine = y + (y * z) * tail;
    let [c0, c1, c2, c3, c4, c5] = COSINE.map(S::of);
    let tail = (c0 + z * c1) + zz * ((c2 + z * c3) + zz * (c4 + z * c5));
    // What is taken from 1 is at most 0.3, so that its rounding is a quarter of that of the difference.
    let cosine = S::of(1.0) - (S::of(0.5) * z - zz * tail);
    S::quarters(shifted, sine, cosine)
}

/// (sin x, cos x).
#[inline(always)]
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    if x.abs() < LARGEST { near(x) } else { far(x) }
}

/// (sin x, cos x) of several angles.
#[inline(always)]
pub(crate) fn sin_cos_of_each<const K: usize>(angles: [f64; K]) -> [(f64, f64); K] {
    angles.map(sin_cos)
}

/// Cosine and sine of n quarter turns, twice each and one of them negative, as the sum of angles needs them.
const QUARTERS: [[[f64; 2]; 2]; 4] =
    [[[1.0, 1.0], [0.0, 0.0]], [[0.0, 0.0], [1.0, -1.0]], [[-1.0, -1.0], [0.0, 0.0]], [[0.0, 0.0], [-1.0, 1.0]]];

/// [`within_range`] for one angle: the polynomials of sine and cosine side by side, and products with 1, 0 and −1 for the quarter
/// turns, which are known long before.
#[inline(always)]
fn near(x: f64) -> (f64, f64) {
    let shifted = x * core::f64::consts::FRAC_2_PI + ROUNDER;
    let n = shifted - ROUNDER;
    let [cosines, sines] = QUARTERS[(shifted.to_bits() & 3) as usize];
    let y = (x - n * HALF_PI[0]) - n * HALF_PI[1];
    let z = y * y;
    let zz = z * z;
    let pair = |k: usize| [SINE[k] + z * SINE[k + 1], COSINE[k] + z * COSINE[k + 1]];
    let [low, middle, high] = [pair(0), pair(2), pair(4)];
    let tail = both(|i| low[i] + zz * (middle[i] + zz * high[i]));
    let (first, factor, less) = ([y, 1.0], [y * z, zz], [0.0, 0.5 * z]);
    let turn = both(|i| first[i] + (factor[i] * tail[i] - less[i]));
    let [sine, cosine] = both(|i| turn[i] * cosines[i] + turn[1 - i] * sines[i]);
    (sine, cosine)
}

/// Twice the same, which LLVM makes one instruction of.
#[inline(always)]
fn both(entry: impl Fn(usize) -> f64) -> [f64; 2] {
    [entry(0), entry(1)]
}

/// (sin x, cos x) of several angles, one after the other.
#[inline(always)]
pub(crate) fn each<const K: usize>(angles: [f32; K]) -> [(f32, f32); K] {
    angles.map(libm::sincosf)
}

/// Angles of many turns, and what is no number.
#[cold]
#[inline(never)]
fn far(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

impl Several for f64 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn quarters(shifted: Self, sine: Self, cosine: Self) -> (Self, Self) {
        let (n, sine, cosine) = (shifted.to_bits(), sine.to_bits(), cosine.to_bits());
        let exchange = (sine ^ cosine) & 0_u64.wrapping_sub(n & 1);
        let (sine_sign, cosine_sign) = ((n & 2) << 62, (n.wrapping_add(1) & 2) << 62);
        (Self::from_bits(sine ^ exchange ^ sine_sign), Self::from_bits(cosine ^ exchange ^ cosine_sign))
    }
}

/// Two doubles, which LLVM keeps in one register of 128 bits.
#[derive(Clone, Copy)]
struct Pair([f64; 2]);

impl Add for Pair {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self([self.0[0] + other.0[0], self.0[1] + other.0[1]])
    }
}

impl Sub for Pair {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self([self.0[0] - other.0[0], self.0[1] - other.0[1]])
    }
}

impl Mul for Pair {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self([self.0[0] * other.0[0], self.0[1] * other.0[1]])
    }
}

impl Several for Pair {
    #[inline(always)]
    fn of(value: f64) -> Self {
        Self([value; 2])
    }
    #[inline(always)]
    fn quarters(shifted: Self, sine: Self, cosine: Self) -> (Self, Self) {
        let (a, b) = (f64::quarters(shifted.0[0], sine.0[0], cosine.0[0]), f64::quarters(shifted.0[1], sine.0[1], cosine.0[1]));
        (Self([a.0, b.0]), Self([a.1, b.1]))
    }
}

#[cfg(test)]
mod tests {
    use super::{sin_cos, sin_cos_of_each};

    fn within_one_unit(x: f64, found: (f64, f64)) {
        let exact = libm::sincos(x);
        for (found, exact) in [(found.0, exact.0), (found.1, exact.1)] {
            assert!((found - exact).abs() <= (f64::EPSILON * exact.abs()).max(1.4e-20), "{x}: {found} for {exact}");
        }
    }

    #[test]
    fn it_is_within_one_unit_of_the_last_place() {
        let mut x = -1.0e6;
        while x < 1.0e6 {
            within_one_unit(x, sin_cos(x));
            x += 0.6 + 1e-3 * x.abs() * 1e-3;
        }
    }

    #[test]
    fn quarter_turns_are_right() {
        for n in -9..=9 {
            let x = f64::from(n) * core::f64::consts::FRAC_PI_2;
            within_one_unit(x, sin_cos(x));
        }
    }

    #[test]
    fn several_angles_are_as_one_by_one() {
        for n in -50..50 {
            let angles = [0.1, 0.7, 1.3].map(|step| f64::from(n) * step);
            assert_eq!(sin_cos_of_each(angles), angles.map(sin_cos));
        }
        let angles = [1.0e300, 0.5, 0.25];
        assert_eq!(sin_cos_of_each(angles), angles.map(sin_cos));
    }

    #[test]
    fn what_is_too_large_or_no_number_is_left_to_libm() {
        assert_eq!(sin_cos(1.0e300), libm::sincos(1.0e300));
        assert!(sin_cos(f64::NAN).0.is_nan() && sin_cos(f64::INFINITY).1.is_nan());
    }
}
