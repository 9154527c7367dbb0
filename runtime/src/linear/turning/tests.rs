use nalgebra::{SMatrix, SVector};

use super::{AtIterate, Turning};
use crate::linear::sparse::tests::Numbers;
use crate::linear::{Elimination, Entries, Factors, Linear, Order, Sparse};

/// Two lengths and a quaternion, of which the norm is the last row.
struct Body;

/// A matrix of six rows in which the row of the norm has one entry.
const PATTERN: [(usize, usize); 26] = {
    let mut places = [(5, 2); 26];
    let mut n = 0;
    while n < 25 {
        let column = n % 5;
        places[n] = (n / 5, if column < 2 { column } else { column + 1 });
        n += 1;
    }
    places
};

impl Elimination<f64, 6, 26, 26> for Body {
    const ORDER: Order<6, 26, 26> = Order { pattern: PATTERN, rows: [0, 1, 2, 3, 4, 5], columns: [0, 1, 3, 4, 5, 2], factors: in_order() };

    const QUATERNIONS: &'static [[usize; 4]] = &[[2, 3, 4, 5]];
}

const fn in_order() -> [(usize, usize); 26] {
    let mut places = [(5, 5); 26];
    let mut n = 0;
    while n < 25 {
        places[n] = (n / 5, n % 5);
        n += 1;
    }
    places
}

type ByTurns = Turning<f64, Sparse<f64, Body, 6, 26, 26>, Body, 6, 26, 26>;

#[test]
fn solutions_by_turns_are_those_of_the_matrix_by_components() {
    let mut numbers = Numbers(3);
    for _ in 0..10_000 {
        let mut values: [f64; 26] = core::array::from_fn(|_| numbers.next());
        values[25] = 1.0;
        let x = SVector::from_fn(|_, _| numbers.next());
        let of = AtIterate { matrix: Entries { values, columns: [1.0; 6] }, x };
        let matrix: SMatrix<f64, 6, 6> = ByTurns::dense(&of);
        // The row of the norm is its gradient.
        for k in 0..4 {
            assert_eq!(matrix[(5, 2 + k)], 2.0 * x[2 + k]);
        }
        let (factors, known) = (ByTurns::factor(&of).unwrap(), Factors::factor(&matrix).unwrap());
        let (ones, zeros) = (SVector::from_element(1.0), SVector::from_element(0.0));
        let condition = known.error_amplification_by(&zeros, &ones, &ones);
        assert_eq!(factors.det_sign(), known.det_sign());
        let b = SVector::from_fn(|_, _| numbers.next());
        let (solution, exact) = (factors.solve_refined(&b), known.solve_refined(&b));
        let error = (solution - exact).amax() / exact.amax();
        assert!(error <= 32.0 * condition * f64::EPSILON, "{error:e} with a condition of {condition:e}");
    }
}

#[test]
fn small_residuals_are_rounding_errors_only_where_the_matrix_says_so() {
    let mut numbers = Numbers(5);
    let mut values: [f64; 26] = core::array::from_fn(|_| numbers.next());
    values[25] = 1.0;
    let of = AtIterate { matrix: Entries { values, columns: [1.0; 6] }, x: SVector::from([0.0, 0.0, 1.0, 0.0, 0.0, 0.0]) };
    let factors = ByTurns::factor(&of).unwrap();
    let row: f64 = (0..5).map(|k| values[k].abs()).sum();
    let (terms, mut b) = (SVector::from_element(0.0), SVector::from_element(0.0));
    for (multiple, is_rounding) in [(1.9, true), (2.1, false)] {
        b[0] = multiple * f64::EPSILON * row;
        assert_eq!(factors.is_rounding(&b, &terms, 2.0), is_rounding);
    }
    // A row with larger terms has larger rounding errors.
    assert!(factors.is_rounding(&b, &SVector::from_element(2.0 * row), 2.0));
}
