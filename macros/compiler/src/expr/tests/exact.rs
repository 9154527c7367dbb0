use std::f64::consts;

use super::random::Random;
use crate::expr::Exact;

const LARGE: i128 = (1 << 120) - 1;

#[test]
fn fractions_are_reduced_with_the_sign_above() {
    let half = Exact::ratio(-3, 6);
    assert_eq!(half, Exact::ratio(1, -2));
    assert_eq!(half.map(|e| (e.numerator(), e.denominator())), Some((-1, 2)));
    assert_eq!(Exact::ratio(0, -5), Some(Exact::ZERO));
    assert_eq!(Exact::ratio(1, 0), None);
    assert_eq!(Exact::ratio(i128::MIN, i128::MIN), Some(Exact::ONE));
}

#[test]
fn what_does_not_fit_is_none() {
    let large = Exact::ratio(LARGE, 1).unwrap();
    assert_eq!(Exact::ratio(LARGE + 1, 1), None);
    assert_eq!(Exact::ratio(i128::MIN, 1), None);
    assert_eq!(large.checked_add(Exact::ONE), None);
    assert_eq!(large.neg().checked_sub(Exact::ONE), None);
    assert_eq!(large.checked_mul(large), None);
    assert_eq!(Exact::ratio(1, LARGE).unwrap().checked_div(large), None);
    assert_eq!(Exact::ONE.checked_div(Exact::ZERO), None);
    assert_eq!(Exact::PI.checked_add(Exact::ONE), None);
    let powers = (0..127).try_fold(Exact::ONE, |power, _| power.checked_mul(Exact::PI)).unwrap();
    assert_eq!(powers.checked_mul(Exact::PI), None);
}

#[test]
fn operations_on_large_numbers_fit_when_the_result_does() {
    let large = Exact::ratio(LARGE, 7).unwrap();
    assert_eq!(large.checked_div(large), Some(Exact::ONE));
    assert_eq!(large.checked_sub(large), Some(Exact::ZERO));
    assert_eq!(large.checked_mul(Exact::ratio(7, LARGE).unwrap()), Some(Exact::ONE));
}

#[test]
fn zero_is_neutral_also_with_powers_of_pi() {
    assert_eq!(Exact::PI.checked_add(Exact::ZERO), Some(Exact::PI));
    assert_eq!(Exact::ZERO.checked_sub(Exact::PI), Some(Exact::PI.neg()));
    assert_eq!(Exact::PI.checked_mul(Exact::ZERO), Some(Exact::ZERO));
    assert_eq!(Exact::PI.checked_sub(Exact::PI), Some(Exact::ZERO));
}

#[test]
fn roots_are_taken_of_squares_only() {
    let pi_squared = Exact::PI.checked_mul(Exact::PI).unwrap();
    assert_eq!(Exact::ratio(9, 4).unwrap().checked_sqrt(), Exact::ratio(3, 2));
    assert_eq!(pi_squared.checked_sqrt(), Some(Exact::PI));
    assert_eq!(Exact::integer(2).checked_sqrt(), None);
    assert_eq!(Exact::integer(-4).checked_sqrt(), None);
    assert_eq!(Exact::PI.checked_sqrt(), None);
}

#[test]
fn decimals_are_read_exactly() {
    let ratio = |a, b| Exact::ratio(a, b);
    assert_eq!(Exact::decimal("12.5e-3"), ratio(1, 80));
    assert_eq!(Exact::decimal("1_000"), ratio(1000, 1));
    assert_eq!(Exact::decimal("0.1"), ratio(1, 10));
    assert_eq!(Exact::decimal("2."), ratio(2, 1));
    assert_eq!(Exact::decimal("3E+2"), ratio(300, 1));
    assert_eq!(Exact::decimal("0e999999999"), Some(Exact::ZERO));
    assert_eq!(Exact::decimal(&format!("1.{}", "0".repeat(500))), Some(Exact::ONE));
    assert_eq!(Exact::decimal(&format!("1{}e-500", "0".repeat(500))), Some(Exact::ONE));
}

/// The reference is the decimal parser of the standard library.
#[test]
fn digits_beyond_those_that_fit_are_rounded() {
    let metre = Exact::ONE;
    for (text, size) in [
        ("3.1415926535897932384626433832795028841971693993751", metre),
        ("0.1234567890123456789012345678901234567890123456789", metre),
        ("99999999999999999999.99999999999999999999999999999999999", metre),
        ("0.000123456789012345678901234567890123456789", metre),
    ] {
        assert_eq!(Exact::measured(text, size).map(Exact::to_f64), text.parse().ok(), "{text}");
    }
    let millimetre = Exact::ratio(1, 1000).expect("it fits");
    assert_eq!(Exact::measured("1000.0000000000000000000000000000000000000000000001", millimetre), Some(Exact::ONE));
    assert_eq!(Exact::measured("1e38", millimetre), Exact::decimal("1e35"));
    assert_eq!(Exact::measured("1.23456789012345678901e-20", metre), None);
    assert_eq!(Exact::measured("1e40", metre), None);
}

#[test]
fn what_is_no_decimal_or_does_not_fit_is_none() {
    for text in [
        "",
        ".",
        "e3",
        "1e",
        "1e1.5",
        "1.2.3",
        "-1",
        "x",
        "_1",
        "1e99999999999",
        "1e40",
        "1e-40",
        "1e2147483647",
        "1e-2147483648",
        "99999999999999999999999999999999999999999",
    ] {
        assert_eq!(Exact::decimal(text), None, "{text}");
    }
}

#[test]
fn decimals_are_rounded_as_rust_rounds_them() {
    let mut texts: Vec<String> =
        ["0.1", "120e-3", "25.4", "9007199254740993", "9007199254740995", "1e-30", "0.3", "1e23"].map(String::from).to_vec();
    let mut random = Random::new(1);
    for _ in 0..2000 {
        let (whole, part) = (random.below(1 << 40), random.below(1 << 50));
        let exponent = random.below(16) as i32 - 8;
        texts.push(format!("{whole}.{part}e{exponent}"));
    }
    for text in texts {
        let found = Exact::decimal(&text).unwrap().to_f64();
        assert_eq!(found, text.parse::<f64>().unwrap(), "{text}");
    }
}

#[test]
fn quotients_of_floats_are_rounded_as_the_machine_rounds_them() {
    let mut random = Random::new(2);
    for _ in 0..2000 {
        let (a, b) = (random.below(1 << 53) as i128, random.below(1 << 53) as i128 + 1);
        assert_eq!(Exact::ratio(a, b).unwrap().to_f64(), a as f64 / b as f64);
    }
}

#[test]
fn ties_go_to_even_and_anything_above_a_tie_goes_up() {
    let below = 1_i128 << 119;
    let tie = (1_i128 << 53) + 1;
    let scale = libm::ldexp(1.0, -119);
    let value = |above| Exact::ratio(above, below).unwrap().to_f64();
    assert_eq!(value(tie), libm::ldexp(1.0, 53) * scale);
    assert_eq!(value(tie + 2), (libm::ldexp(1.0, 53) + 4.0) * scale);
    let barely_more = Exact::ratio((tie << 60) + 1, 1 << 60).unwrap();
    assert_eq!(barely_more.to_f64(), libm::ldexp(1.0, 53) + 2.0);
    assert_eq!(Exact::ratio(LARGE, 1).unwrap().to_f64(), libm::ldexp(1.0, 120));
    assert_eq!(Exact::ratio(1, LARGE).unwrap().to_f64(), libm::ldexp(1.0, -120));
    assert_eq!(Exact::ratio(-1, 3).unwrap().to_f64(), -1.0 / 3.0);
}

#[test]
fn multiples_of_pi_are_rounded_once() {
    let times_pi = |a, b| Exact::ratio(a, b).unwrap().checked_mul(Exact::PI).unwrap().to_f64();
    assert_eq!(times_pi(1, 1), consts::PI);
    assert_eq!(times_pi(2, 1), consts::TAU);
    assert_eq!(times_pi(-1, 2), -consts::FRAC_PI_2);
    assert_eq!(times_pi(1, 3), consts::FRAC_PI_3);
    assert_eq!(times_pi(1, 4), consts::FRAC_PI_4);
    assert_eq!(times_pi(1, 6), consts::FRAC_PI_6);
    assert_eq!(times_pi(1, 8), consts::FRAC_PI_8);
    // One degree, and three, which 3.0 * PI / 180.0 misses by one unit in the last place.
    assert_eq!(times_pi(1, 180), 0.017_453_292_519_943_295);
    assert_eq!(times_pi(3, 180), 0.052_359_877_559_829_89);
    assert_eq!(times_pi(7, 180), 0.122_173_047_639_603_07);
    assert_eq!(times_pi(1000, 7), 448.798_950_512_827_6);
}

#[test]
fn powers_of_pi_are_rounded_once() {
    let inverse = Exact::ONE.checked_div(Exact::PI).unwrap();
    assert_eq!(inverse.to_f64(), consts::FRAC_1_PI);
    assert_eq!(Exact::integer(2).checked_mul(inverse).unwrap().to_f64(), consts::FRAC_2_PI);
    let squared = Exact::PI.checked_mul(Exact::PI).unwrap();
    assert_eq!(squared.to_f64(), 9.869_604_401_089_358);
    let hundredth = (0..100).try_fold(Exact::ONE, |power, _| power.checked_mul(Exact::PI));
    assert_eq!(hundredth.unwrap().to_f64(), 5.187_848_314_319_613e49);
    let large = Exact::ratio(LARGE, 1).unwrap().checked_mul(Exact::PI).unwrap();
    assert_eq!(large.to_f64(), libm::ldexp(consts::PI, 120));
}
