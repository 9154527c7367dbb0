//! Functions in single precision without a double: on a processor with `f32` arithmetic only, each product of doubles is a call of some
//! hundred instructions. `libm` provides the other functions without doubles. Sine and cosine are free of branches too.
//!
//! ```text
//! x = (n + f) π/2,  |f| ≤ 1/2           n and f from x · 2/π in whole numbers, modulo four quarter turns
//! y = f π/2,  or x where |x| < π/4      sin y and cos y by polynomials, then the quarter turns n are put back
//! ```
//!
//! 2/π is known to as many bits as the largest `f32` needs, so that the reduction is right for all of them (Payne and Hanek: Radian
//! reduction for trigonometric functions, 1983).

/// 2/π to 192 bits, after four bytes of zero.
const TWO_OVER_PI: [u8; 28] = [
    0x00, 0x00, 0x00, 0x00, 0xA2, 0xF9, 0x83, 0x6E, 0x4E, 0x44, 0x15, 0x29, 0xFC, 0x27, 0x57, 0xD1, 0xF5, 0x34, 0xDD, 0xC0, 0xDB, 0x62,
    0x95, 0x99, 0x3C, 0x43, 0x90, 0x41,
];

/// ⌊2/π · 2⁸ⁱ⌋ modulo 2³².
const WORDS: [u32; 25] = {
    let mut words = [0; 25];
    let mut i = 0;
    while i < 25 {
        let bytes = &TWO_OVER_PI;
        words[i] = u32::from_be_bytes([bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]]);
        i += 1;
    }
    words
};

/// π/2 · 2³¹
const HALF_PI: u64 = 0xC90F_DAA2;

/// Coefficients of y³, y⁵ and y⁷ of the sine (Moshier: Methods and Programs for Mathematical Functions, 1989).
const SINE: [f32; 3] = [-1.666_665_5e-1, 8.332_161e-3, -1.951_529_6e-4];

/// Coefficients of y⁴, y⁶ and y⁸ of the cosine.
const COSINE: [f32; 3] = [4.166_664_6e-2, -1.388_731_6e-3, 2.443_315_7e-5];

/// (sin x, cos x), each with a relative error of 1.25 ε at most, also where it is nearly zero, at every `f32`; not numbers where x is not
/// finite.
#[inline(always)]
pub(crate) fn sin_cos(x: f32) -> (f32, f32) {
    let size = x.abs();
    let (quarter, reduced) = reduced(size);
    let is_small = size < core::f32::consts::FRAC_PI_4;
    let (n, y) = (if is_small { 0 } else { quarter }, if is_small { size } else { reduced });
    let z = y * y;
    let sine = y + (y * z) * (SINE[0] + z * (SINE[1] + z * SINE[2]));
    let cosine = (1.0 - 0.5 * z) + (z * z) * (COSINE[0] + z * (COSINE[1] + z * COSINE[2]));
    let (sine, cosine) = if n & 1 == 0 { (sine, cosine) } else { (cosine, sine) };
    // The third and fourth quarter turn change the sign of the sine, the second and third that of the cosine; the sign of x changes the
    // sine.
    let nothing = if size < f32::INFINITY { 0 } else { NOTHING };
    let of_sine = (x.to_bits() & SIGN) ^ ((n & 2) << 30);
    let of_cosine = ((n + 1) & 2) << 30;
    (signed(sine, of_sine, nothing), signed(cosine, of_cosine, nothing))
}

/// (sin x, cos x) of several angles.
#[inline(always)]
pub(crate) fn sin_cos_of_each<const K: usize>(angles: [f32; K]) -> [(f32, f32); K] {
    let mut turns = [(0.0, 1.0); K];
    for (turn, angle) in turns.iter_mut().zip(angles) {
        *turn = sin_cos(angle);
    }
    turns
}

/// The sign of a number.
const SIGN: u32 = 0x8000_0000;

/// Setting these bits gives NaN.
const NOTHING: u32 = 0x7FC0_0000;

#[inline(always)]
fn signed(value: f32, sign: u32, nothing: u32) -> f32 {
    f32::from_bits((value.to_bits() ^ sign) | nothing)
}

/// n modulo 4 and f π/2, for finite numbers not below 1/2; unspecified for others.
#[inline(always)]
fn reduced(x: f32) -> (u32, f32) {
    let bits = x.to_bits();
    // x = mantissa · 2^(exponent − 30); only those bits of 2/π matter that give less than four quarter turns.
    let exponent = (bits >> 23).clamp(120, 254) - 120;
    let mantissa = u64::from(((bits & 0x007F_FFFF) | 0x0080_0000) << (exponent & 7));
    let word = (exponent >> 3) as usize;
    let product = |word: usize| mantissa * u64::from(WORDS[word]);
    // x · 2/π · 2⁶² modulo 2⁶⁴
    let turns = (product(word) << 32).wrapping_add(product(word + 4)).wrapping_add(product(word + 8) >> 32);
    let n = turns.wrapping_add(1 << 61) >> 62;
    let fraction = turns.wrapping_sub(n << 62) as i64;
    // y to 32 bits, then rounded once.
    let size = fraction.unsigned_abs() | 1;
    let zeros = size.leading_zeros();
    let rounded = ((((size << zeros) >> 32) * HALF_PI) >> 32) as u32 as f32;
    let scale = f32::from_bits((98 - zeros) << 23);
    let y = rounded * scale;
    (n as u32, if fraction < 0 { -y } else { y })
}

/// tan x with a relative error of 3 ε at most.
#[inline]
pub(crate) fn tan(x: f32) -> f32 {
    let (sine, cosine) = sin_cos(x);
    sine / cosine
}

/// arcsin x with a relative error of 2 ε at most; not a number outside [−1, 1].
#[inline]
pub(crate) fn asin(x: f32) -> f32 {
    libm::atan2f(x, libm::sqrtf((1.0 - x) * (1.0 + x)))
}

#[cfg(test)]
mod tests {
    use super::{asin, sin_cos, tan};

    /// Step through the floats from 0 to infinity, in bit patterns; the binary `single` of the benches tests all of them.
    const STRIDE: usize = 4099;

    /// Error in ε of the exact value, which is known to twice as many digits.
    fn off(found: f32, exact: f64) -> f64 {
        if f64::from(found) == exact { 0.0 } else { ((f64::from(found) - exact) / exact).abs() / f64::from(f32::EPSILON) }
    }

    /// Floats of all sizes, and those next to multiples of π/4.
    fn floats() -> impl Iterator<Item = f32> {
        let strided = (f32::MIN_POSITIVE.to_bits()..f32::INFINITY.to_bits()).step_by(STRIDE).map(f32::from_bits);
        let multiples = (1..20_000).map(|n| (f64::from(n) * core::f64::consts::FRAC_PI_4) as f32);
        let beside = multiples.flat_map(|x| [-1_i32, 0, 1].map(|by| f32::from_bits(x.to_bits().wrapping_add_signed(by))));
        strided.chain(beside)
    }

    #[test]
    fn sine_and_cosine_are_right_at_floats_of_all_sizes() {
        for x in floats() {
            let (sine, cosine) = sin_cos(x);
            let exact = libm::sincos(f64::from(x));
            assert!(off(sine, exact.0) <= 1.25 && off(cosine, exact.1) <= 1.25, "{x:e}: {sine}, {cosine} for {exact:?}");
            assert_eq!(sin_cos(-x), (-sine, cosine), "{x:e}");
        }
    }

    #[test]
    fn tangent_and_arc_sine_are_right_at_floats_of_all_sizes() {
        for x in floats() {
            assert!(off(tan(x), libm::tan(f64::from(x))) <= 3.0, "{x:e}");
            assert!(x > 1.0 || off(asin(x), libm::asin(f64::from(x))) <= 2.0, "{x:e}");
        }
    }

    #[test]
    fn zeros_keep_their_sign_and_what_is_no_number_stays_none() {
        for zero in [0.0_f32, -0.0] {
            for (found, exact) in [(sin_cos(zero).0, zero), (sin_cos(zero).1, 1.0), (tan(zero), zero), (asin(zero), zero)] {
                assert_eq!(found.to_bits(), exact.to_bits());
            }
        }
        for x in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert!(sin_cos(x).0.is_nan() && sin_cos(x).1.is_nan() && tan(x).is_nan() && asin(x).is_nan());
        }
        assert!(asin(1.5).is_nan() && asin(-1.0e30).is_nan());
    }
}
