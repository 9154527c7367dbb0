//! Sine and cosine together without a branch, for the loops of the solver.
//!
//! x = n π/2 + y, |y| ≤ π/4, with π/2 in three parts (Cody and Waite, 1980); sin y and cos y by the polynomials of Sun's fdlibm, with
//! errors below 2⁻⁵⁸; then the rotation by n quarter turns. No instruction waits for a comparison, so that several angles are processed
//! in parallel. There are two versions: one for registers with an angle in each lane, and one for a single angle, with sine and cosine in
//! two lanes.

use super::Real;

/// Up to here n has 20 bits, so that the products of n with the first two parts of π/2, of 33 bits each, are exact.
pub const LARGEST: f64 = 1.0e6;

/// The first 33 bits of π/2, the next 33, and the rest.
const HALF_PI: [f64; 3] =
    [f64::from_bits(0x3FF9_21FB_5440_0000), f64::from_bits(0x3DD0_B461_1A60_0000), f64::from_bits(0x3BA3_198A_2E03_7073)];

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

/// (sin x, cos x) of a number of lanes of `f64`, |x| < [`LARGEST`] in each, with a relative error of 2 ε at most.
#[inline(always)]
pub fn within_range<T: Real>(x: T) -> (T, T) {
    let whole = |x: T| (x + T::of(ROUNDER)) - T::of(ROUNDER);
    let n = whole(x * T::of(core::f64::consts::FRAC_2_PI));
    let y = ((x - n * T::of(HALF_PI[0])) - n * T::of(HALF_PI[1])) - n * T::of(HALF_PI[2]);
    let z = y * y;
    let zz = z * z;
    let tail = |c: [f64; 6]| {
        let [low, middle, high] = [0, 2, 4].map(|k| T::of(c[k]) + z * T::of(c[k + 1]));
        (low + zz * middle) + (zz * zz) * high
    };
    let sine = y + (y * z) * tail(SINE);
    let cosine = (T::of(1.0) - T::of(0.5) * z) + zz * tail(COSINE);
    // n modulo 4, between −2 and 2, and the sine and cosine of n quarter turns.
    let m = n - T::of(4.0) * whole(n * T::of(0.25));
    let (a, b) = (m * (T::of(2.0) - m.abs()), T::of(1.0) - m.abs());
    (sine * b + cosine * a, cosine * b - sine * a)
}

/// (sin x, cos x).
#[inline(always)]
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    if x.abs() < LARGEST { near(x) } else { far(x) }
}

/// (sin x, cos x) of several angles.
#[inline(always)]
pub(crate) fn sin_cos_of_each<const K: usize>(angles: [f64; K]) -> [(f64, f64); K] {
    let mut turns = [(0.0, 1.0); K];
    for k in 0..K {
        turns[k] = sin_cos(angles[k]);
    }
    turns
}

/// Cosine and sine of n quarter turns, each twice with the signs of the addition theorems.
const QUARTERS: [[[f64; 2]; 2]; 4] =
    [[[1.0, 1.0], [0.0, 0.0]], [[0.0, 0.0], [1.0, -1.0]], [[-1.0, -1.0], [0.0, 0.0]], [[0.0, 0.0], [-1.0, 1.0]]];

/// (sin x, cos x) for |x| < [`LARGEST`], each with a relative error of 2 ε at most, also where it is nearly zero.
///
/// The polynomials of sine and cosine are evaluated in parallel. The rotation by quarter turns, which is known long before, is a product
/// with 1, 0 and −1.
#[inline(always)]
fn near(x: f64) -> (f64, f64) {
    let shifted = x * core::f64::consts::FRAC_2_PI + ROUNDER;
    let n = shifted - ROUNDER;
    let [cosines, sines] = QUARTERS[(shifted.to_bits() & 3) as usize];
    let y = ((x - n * HALF_PI[0]) - n * HALF_PI[1]) - n * HALF_PI[2];
    let z = y * y;
    let zz = z * z;
    let pair = |k: usize| [SINE[k] + z * SINE[k + 1], COSINE[k] + z * COSINE[k + 1]];
    let [low, middle, high] = [pair(0), pair(2), pair(4)];
    let fourth = zz * zz;
    let tail = both(|i| (low[i] + zz * middle[i]) + fourth * high[i]);
    let (first, factor) = ([y, 1.0 - 0.5 * z], [y * z, zz]);
    let turn = both(|i| first[i] + factor[i] * tail[i]);
    let [sine, cosine] = both(|i| turn[i] * cosines[i] + turn[1 - i] * sines[i]);
    (sine, cosine)
}

/// Two entries of one form, which LLVM compiles to one instruction.
#[inline(always)]
fn both(entry: impl Fn(usize) -> f64) -> [f64; 2] {
    [entry(0), entry(1)]
}

/// Very large angles, infinity and NaN.
#[cold]
#[inline(never)]
fn far(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

#[cfg(test)]
mod tests {
    use super::{sin_cos, sin_cos_of_each, within_range};

    fn within_two_roundings(x: f64, found: (f64, f64)) {
        let exact = libm::sincos(x);
        for (found, exact) in [(found.0, exact.0), (found.1, exact.1)] {
            assert!((found - exact).abs() <= 2.0 * f64::EPSILON * exact.abs(), "{x}: {found} for {exact}");
        }
    }

    #[test]
    fn it_is_within_two_roundings_of_the_last_place() {
        let mut x = -1.0e6;
        while x < 1.0e6 {
            within_two_roundings(x, sin_cos(x));
            within_two_roundings(x, within_range(x));
            x += 0.6 + 1e-3 * x.abs() * 1e-3;
        }
    }

    #[test]
    fn quarter_turns_are_right() {
        for n in -9..=9 {
            let x = f64::from(n) * core::f64::consts::FRAC_PI_2;
            within_two_roundings(x, sin_cos(x));
            within_two_roundings(x, within_range(x));
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
