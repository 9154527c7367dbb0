//! Numbers of twice the digits of doubles, which the tests compare with.

use reuleaux::Real;
use reuleaux_tests::common::twofold::Twofold;

/// Compares the first 30 digits: the squarings in `exp` cost two.
fn is(found: Twofold, high: f64, low: f64) {
    let error = (found - Twofold { high, low }).high.abs();
    assert!(error <= 1e-30 * high.abs(), "{found:?} is off by {error:e}");
}

#[test]
fn known_constants_come_out() {
    // Doubles and their remainders.
    is(Twofold::of(2.0).sqrt(), std::f64::consts::SQRT_2, -9.667293313452913e-17);
    is(Twofold::of(1.0).exp(), std::f64::consts::E, 1.4456468917292502e-16);
    is(Twofold::of(2.0).ln(), std::f64::consts::LN_2, 2.3190468138462996e-17);
    is(Twofold::of(1.0).atan() * Twofold::of(2.0), std::f64::consts::FRAC_PI_2, 6.123233995736766e-17);
}

#[test]
fn squares_of_sine_and_cosine_add_up() {
    for n in -40..40 {
        let (sine, cosine) = Twofold::of(f64::from(n) * 0.37).sin_cos();
        is(sine * sine + cosine * cosine, 1.0, 0.0);
        assert!((sine.high - (f64::from(n) * 0.37).sin()).abs() <= 1e-15);
    }
}
