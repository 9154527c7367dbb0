use nalgebra::{SMatrix, SVector};

use super::{Entries, Sparse};
use crate::linear::{Elimination, Factors, Linear, Order};
use crate::number::DetSign;

/// A loop of four: each row has two neighbours, and elimination fills two entries.
struct Ring;

impl Elimination<f64, 4, 8, 10> for Ring {
    const ORDER: Order<4, 8, 10> = Order {
        pattern: [(0, 0), (0, 1), (1, 1), (1, 2), (2, 2), (2, 3), (3, 0), (3, 3)],
        rows: [0, 1, 2, 3],
        columns: [0, 1, 2, 3],
        factors: [(0, 0), (0, 1), (1, 1), (1, 2), (2, 2), (2, 3), (3, 0), (3, 1), (3, 2), (3, 3)],
    };
}

/// No zeros, and pivots neither in the order of rows nor in that of columns: the first is at (2, 1).
struct Full;

impl Elimination<f64, 4, 16, 16> for Full {
    const ORDER: Order<4, 16, 16> = Order { pattern: full(), rows: [2, 0, 3, 1], columns: [1, 0, 2, 3], factors: full() };
}

const fn full() -> [(usize, usize); 16] {
    let mut places = [(0, 0); 16];
    let mut n = 0;
    while n < 16 {
        places[n] = (n / 4, n % 4);
        n += 1;
    }
    places
}

/// Numbers between −1 and 1 (Knuth's linear congruences).
pub(in crate::linear) struct Numbers(pub(in crate::linear) u64);

impl Numbers {
    pub(in crate::linear) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

fn ring(values: [f64; 8]) -> Result<Sparse<f64, Ring, 4, 8, 10>, usize> {
    Linear::factor(&Entries { values, columns: [1.0; 4] })
}

fn full_of(values: [f64; 16]) -> Result<Sparse<f64, Full, 4, 16, 16>, usize> {
    Linear::factor(&Entries { values, columns: [1.0; 4] })
}

/// Asserts that x is as accurate as by the pivoted factorisation, refined or not, and that both report the same about the matrix.
fn agrees<E: Elimination<f64, 4, A, F>, const A: usize, const F: usize>(sparse: &Sparse<f64, E, 4, A, F>, b: [f64; 4]) {
    let matrix: SMatrix<f64, 4, 4> = Sparse::<f64, E, 4, A, F>::dense(&sparse.matrix);
    let pivoted = Factors::factor(&matrix).unwrap();
    let b = SVector::from(b);
    let ones = SVector::from_element(1.0);
    let sizes = SVector::from_element(0.0);
    assert_eq!(sparse.det_sign(), pivoted.det_sign());
    assert!(sparse.is_regular());
    let (condition, reference) = (sparse.condition(&sizes, &ones), pivoted.error_amplification_by(&sizes, &ones, &ones));
    // Both are estimates from below: of random matrices, one in a hundred by more than 4 and one in ten thousand by more than 16.
    assert!(condition <= 256.0 * reference && reference <= 256.0 * condition, "{condition} is not about {reference}");
    let condition = condition.max(reference);
    let (x, known) = (sparse.solve_refined(&b), pivoted.solve_refined(&b));
    let error = (x - known).amax() / known.amax();
    assert!(error <= 8.0 * condition * f64::EPSILON, "{error:e} with a condition of {condition:e}");
    // Stable factors give the same without tests.
    let (untested, sign) = Sparse::<f64, E, 4, A, F>::correction(&sparse.matrix, &b).unwrap();
    assert!(!sparse.is_stable || (untested, sign) == (sparse.solve(&b), pivoted.det_sign()));
    let rough = (sparse.solve(&b) - known).amax() / known.amax();
    assert!(rough <= 4.0 * 8192.0 * condition * f64::EPSILON, "{rough:e} with a condition of {condition:e}");
}

#[test]
fn random_matrices_are_solved_as_with_pivoting() {
    let mut numbers = Numbers(1);
    let mut fallen_back = 0;
    for _ in 0..20_000 {
        let b = core::array::from_fn(|_| numbers.next());
        agrees(&ring(core::array::from_fn(|_| numbers.next())).unwrap(), b);
        let sparse = full_of(core::array::from_fn(|_| numbers.next())).unwrap();
        fallen_back += u32::from(!sparse.is_stable);
        agrees(&sparse, b);
    }
    assert!((1..400).contains(&fallen_back), "{fallen_back} of 20000 orders were bad");
}

#[test]
fn a_pivot_that_vanishes_is_seen_and_costs_no_accuracy() {
    // det = a c e h − b d f g; the matrix is regular without its first entry.
    for pivot in [0.0, 1e-300, 1e-15, -1e-15, 1e-9, 1e-5] {
        let sparse = ring([pivot, 1.0, 0.5, -2.0, 1.5, 3.0, -1.0, 0.25]).unwrap();
        assert!(!sparse.is_stable);
        agrees(&sparse, [1.0, -2.0, 0.5, 3.0]);
    }
    let sparse = ring([0.1, 1.0, 0.5, -2.0, 1.5, 3.0, -1.0, 0.25]).unwrap();
    assert!(sparse.is_stable);
    agrees(&sparse, [1.0, -2.0, 0.5, 3.0]);
}

#[test]
fn a_pivot_that_cancels_is_seen() {
    // The second pivot is 2 · 0.5 − 1 · (1 + δ).
    let mut values: [f64; 16] =
        core::array::from_fn(|n| [3.0, -1.0, 0.5, 2.0, 1.5, -0.7, 0.9, 1.1, 0.4, -2.5, 0.8, 1.3, 2.2, 0.6, -1.9, 0.3][n]);
    for delta in [0.0, 1e-15, 1e-12, 1e-6] {
        // Row 2, column 1 is the first pivot, row 0, column 0 the second.
        (values[9], values[8], values[1]) = (2.0, 1.0, 1.0 + delta);
        values[0] = 0.5;
        let sparse = full_of(values).unwrap();
        assert!(!sparse.is_stable, "{delta}");
        agrees(&sparse, [1.0, 2.0, -3.0, 0.5]);
    }
}

#[test]
fn units_of_rows_and_unknowns_do_not_matter() {
    let mut numbers = Numbers(7);
    for _ in 0..2000 {
        let values: [f64; 8] = core::array::from_fn(|_| numbers.next());
        let (rows, columns) = ([1e-9, 1e6, 1.0, 1e3].map(f64::abs), [1e-6, 1.0, 1e-6, 1.0]);
        let scaled = core::array::from_fn(|n| values[n] * rows[Ring::ORDER.pattern[n].0] / columns[Ring::ORDER.pattern[n].1]);
        let sparse: Sparse<f64, Ring, 4, 8, 10> = Linear::factor(&Entries { values: scaled, columns }).unwrap();
        assert_eq!(sparse.is_stable, ring(values).unwrap().is_stable);
    }
}

#[test]
fn a_singular_matrix_is_not_regular_and_has_a_basic_solution() {
    // a c e h = b d f g
    let sparse = ring([1.0, 2.0, 3.0, 1.0, 1.0, -3.0, 1.0, -2.0]).unwrap();
    let b = SVector::from([1.0, 1.0, 1.0, 0.0]);
    assert!(!sparse.is_regular());
    assert!(sparse.condition(&b, &b).is_infinite());
    assert!(sparse.solve(&b).iter().all(|entry| entry.is_finite()));
}

#[test]
fn near_singular_matrices_are_left_to_pivoting() {
    for delta in [1e-15, 1e-12, 1e-9] {
        let sparse = ring([1.0, 2.0, 3.0, 1.0, 1.0, -3.0, 1.0, -2.0 * (1.0 + delta)]).unwrap();
        assert!(!sparse.is_stable);
        let condition = sparse.condition(&SVector::from_element(0.0), &SVector::from_element(1.0));
        assert!(condition > 0.01 / delta);
    }
}

#[test]
fn a_row_that_is_not_finite_is_named() {
    for wrong in [f64::NAN, f64::INFINITY] {
        for place in 0..8 {
            let mut values = [1.0, 2.0, 3.0, 1.0, 1.0, -3.0, 1.0, 2.0];
            values[place] = wrong;
            assert_eq!(ring(values).err(), Some(Ring::ORDER.pattern[place].0));
        }
    }
}

#[test]
fn the_sign_of_the_determinant_counts_the_exchanges() {
    // The identity, eliminated by rows 2, 0, 3, 1 and columns 1, 0, 2, 3, has zero pivots; a full matrix near a permutation has none.
    let at =
        |places: [(usize, usize); 4]| -> [f64; 16] { core::array::from_fn(|n| if places.contains(&(n / 4, n % 4)) { 4.0 } else { 0.5 }) };
    let sparse = full_of(at([(2, 1), (0, 0), (3, 2), (1, 3)])).unwrap();
    assert!(sparse.is_stable);
    // Columns 0, 3, 1, 2 by row: two inversions.
    assert_eq!(sparse.det_sign(), DetSign::Positive);
    let sparse = full_of(at([(2, 1), (0, 0), (3, 3), (1, 2)])).unwrap();
    assert_eq!(sparse.det_sign(), DetSign::Negative);
}
