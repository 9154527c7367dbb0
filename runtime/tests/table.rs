//! Splines.

use reuleaux::{Ends, Real, Single, Table};

const KNOTS: [f64; 3] = [-1.0, 0.0, 1.0];
const COEFFICIENTS: [[f64; 4]; 2] = [[-1.0, 3.0, -3.0, 1.0], [0.0, 0.0, 0.0, 1.0]];

/// x³ from −1 to 1 in two pieces.
const CUBE: Table = Table {
    knots: &KNOTS,
    coefficients: &COEFFICIENTS,
    ends: Ends::Linear,
    single: Single { knots: &Single::knots(&KNOTS), coefficients: &Single::coefficients(&COEFFICIENTS), period: Single::period(&KNOTS) },
};

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
fn outside_it_goes_on_so_in_single_precision() {
    let hold = Table { ends: Ends::Hold, ..CUBE };
    let periodic = Table { ends: Ends::Periodic, ..CUBE };
    assert_eq!(3_f32.table(&CUBE), (7.0, 3.0, 0.0));
    assert_eq!((-2_f32).table(&CUBE), (-4.0, 3.0, 0.0));
    assert_eq!(3_f32.table(&hold), (1.0, 0.0, 0.0));
    assert_eq!(f32::NEG_INFINITY.table(&hold), (-1.0, 0.0, 0.0));
    assert_eq!(4.5_f32.table(&periodic), 0.5_f32.table(&periodic));
    assert_eq!((-7.75_f32).table(&periodic), 0.25_f32.table(&periodic));
    // After four million periods, where neighbouring numbers are at least half a period apart.
    assert_eq!(8_388_609_f32.table(&periodic), 1_f32.table(&periodic));
}

#[test]
fn knots_are_kept_to_the_digits_of_a_double() {
    for knot in [0.1, -1e9 / 3.0, 1e-30, 2.5, 0.0] {
        let [[high, low]] = Single::knots(&[knot]);
        assert!((f64::from(high) + f64::from(low) - knot).abs() <= 1e-14 * knot.abs(), "{knot}");
    }
    // A number too large for `f32` has no remainder either.
    assert_eq!(Single::knots(&[1e300]), [[f32::INFINITY, 0.0]]);
    assert_eq!(Single::period(&[0.25, 1.0, 2.75]), [2.5, 0.0]);
}

#[test]
fn without_an_answer_it_is_not_a_number() {
    for ends in [Ends::Linear, Ends::Hold, Ends::Periodic] {
        assert!(Table { ends, ..CUBE }.evaluate(f64::NAN).0.is_nan());
        for knots in [&[] as &[f64], &[0.0]] {
            assert!(Table { knots, coefficients: &[], ends, ..CUBE }.evaluate(0.0).0.is_nan());
        }
        assert!(f32::NAN.table(&Table { ends, ..CUBE }).0.is_nan());
        for knots in [&[] as &[[f32; 2]], &[[0.0; 2]]] {
            let nothing = Table { ends, single: Single { knots, coefficients: &[], period: [0.0; 2] }, ..CUBE };
            assert!(0_f32.table(&nothing).0.is_nan());
        }
    }
    assert!(Table { ends: Ends::Periodic, ..CUBE }.evaluate(f64::INFINITY).0.is_nan());
    assert!(f32::INFINITY.table(&Table { ends: Ends::Periodic, ..CUBE }).0.is_nan());
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
