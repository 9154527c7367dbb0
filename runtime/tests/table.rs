//! Splines.

use reuleaux::{Ends, Real, Table};

/// x³ from −1 to 1 in two pieces.
const CUBE: Table = Table { knots: &[-1.0, 0.0, 1.0], coefficients: &[[-1.0, 3.0, -3.0, 1.0], [0.0, 0.0, 0.0, 1.0]], ends: Ends::Linear };

#[test]
fn inside_it_is_the_polynomial() {
    for x in [-1.0, -0.75, -0.0, 0.0, 0.5, 1.0_f64] {
        assert_eq!(x.table(&CUBE), (x * x * x, 3.0 * x * x, 6.0 * x));
    }
    assert_eq!(0.5_f32.table(&CUBE), (0.125, 0.75, 3.0));
}

#[test]
fn outside_it_goes_on_as_its_ends_say() {
    let hold = Table { ends: Ends::Hold, ..CUBE };
    let periodic = Table { ends: Ends::Periodic, ..CUBE };
    assert_eq!(CUBE.evaluate(3.0), (7.0, 3.0, 0.0));
    assert_eq!(CUBE.evaluate(-2.0), (-4.0, 3.0, 0.0));
    assert_eq!(hold.evaluate(3.0), (1.0, 0.0, 0.0));
    assert_eq!(hold.evaluate(f64::NEG_INFINITY), (-1.0, 0.0, 0.0));
    assert_eq!(periodic.evaluate(4.5), periodic.evaluate(0.5));
    assert_eq!(periodic.evaluate(-7.75), periodic.evaluate(0.25));
    assert!(periodic.evaluate(-1.0 - 1e-16).0.is_finite());
}

#[test]
fn without_an_answer_it_is_not_a_number() {
    for ends in [Ends::Linear, Ends::Hold, Ends::Periodic] {
        assert!(Table { ends, ..CUBE }.evaluate(f64::NAN).0.is_nan());
        for knots in [&[] as &[f64], &[0.0]] {
            assert!(Table { knots, coefficients: &[], ends }.evaluate(0.0).0.is_nan());
        }
    }
    assert!(Table { ends: Ends::Periodic, ..CUBE }.evaluate(f64::INFINITY).0.is_nan());
}

#[test]
fn numbers_do_what_they_say() {
    assert_eq!((Real::sign(-3.0), Real::sign(2.0_f32), Real::sign(0.0)), (-1.0, 1.0, 0.0));
    assert!(Real::sign(f64::NAN).is_nan());
    assert_eq!(f64::select_less(f64::NAN, 1.0, 2.0, 3.0), 3.0);
    assert_eq!((Real::max(1.0, 2.0), Real::max(2.0_f32, 1.0)), (2.0, 2.0));
    assert_eq!(2.0_f32.map(|x| (x * x, 2.0 * x, 2.0)), (4.0, 4.0, 2.0));
    assert_eq!(Real::sin_cos(0.7), libm::sincos(0.7));
}
