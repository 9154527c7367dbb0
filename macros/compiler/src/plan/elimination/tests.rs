use super::order::{Pivot, PivotCandidate, in_order};
use super::{Elimination, filled};
use std::collections::BTreeSet;

/// Entries with their values at one pose.
fn entries(rows: &[&[f64]]) -> Vec<PivotCandidate> {
    in_poses(&[rows])
}

/// Entries with their values at several poses; a value that is zero at all of them is not an entry.
fn in_poses(poses: &[&[&[f64]]]) -> Vec<PivotCandidate> {
    let size = poses[0].len();
    let places = (0..size).flat_map(|i| (0..size).map(move |j| (i, j)));
    let entry =
        |(i, j): (usize, usize)| PivotCandidate { place: (i, j), values: poses.iter().map(|pose| pose[i][j]).collect(), is_unit: false };
    places.map(entry).filter(|entry| entry.values.iter().any(|value| *value != 0.0)).collect()
}

/// Random numbers in [−1, 1), by Knuth's linear congruential generator.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A random matrix with a full diagonal and one in `rarity` of the other entries.
fn random(size: usize, rarity: u64, numbers: &mut Numbers) -> Vec<PivotCandidate> {
    let mut found = Vec::new();
    for place in (0..size).flat_map(|i| (0..size).map(move |j| (i, j))) {
        let value = numbers.next();
        if place.0 == place.1 || (numbers.0 >> 33).is_multiple_of(rarity) {
            found.push(PivotCandidate { place, values: vec![value], is_unit: false });
        }
    }
    found
}

/// Number of entries of L and U without reordering.
fn as_it_stands(size: usize, entries: &[PivotCandidate]) -> usize {
    let pattern: Vec<(usize, usize)> = entries.iter().map(|entry| entry.place).collect();
    let order: Vec<usize> = (0..size).collect();
    filled(&pattern, &order, &order).len()
}

#[test]
fn an_arrow_is_eliminated_from_its_tip() {
    let matrix: [&[f64]; 4] = [&[2.0, 1.0, 1.0, 1.0], &[1.0, 2.0, 0.0, 0.0], &[1.0, 0.0, 2.0, 0.0], &[1.0, 0.0, 0.0, 2.0]];
    let entries = entries(&matrix);
    let elimination = Elimination::new(4, &entries);
    assert_eq!(elimination.factors.len(), entries.len());
    assert_eq!(as_it_stands(4, &entries), 16);
}

#[test]
fn a_triangle_is_not_filled_however_it_is_turned() {
    let matrix: [&[f64]; 4] = [&[1.5, 0.0, 0.5, 2.0], &[0.0, 0.0, 0.0, 3.0], &[2.5, 1.0, 0.5, 1.0], &[0.7, 0.0, 0.0, 0.5]];
    assert_eq!(Elimination::new(4, &entries(&matrix)).factors.len(), 10);
}

#[test]
fn every_row_and_column_has_one_pivot() {
    let mut numbers = Numbers(1);
    for _ in 0..200 {
        let size = 4 + (numbers.0 >> 60) as usize;
        let elimination = Elimination::new(size, &random(size, 4, &mut numbers));
        let all: BTreeSet<usize> = (0..size).collect();
        assert_eq!(elimination.rows.iter().copied().collect::<BTreeSet<_>>(), all);
        assert_eq!(elimination.columns.iter().copied().collect::<BTreeSet<_>>(), all);
        assert!(elimination.factors.is_sorted());
    }
}

#[test]
fn fill_is_seldom_more_than_without_an_order() {
    let mut numbers = Numbers(2);
    let (mut ours, mut theirs, mut worse) = (0, 0, 0);
    for _ in 0..300 {
        let entries = random(10, 6, &mut numbers);
        let (chosen, given) = (Elimination::new(10, &entries).factors.len(), as_it_stands(10, &entries));
        (ours, theirs, worse) = (ours + chosen, theirs + given, worse + usize::from(chosen > given));
    }
    assert!(ours < theirs && worse < 15, "{ours} entries for {theirs}, more in {worse} of 300");
}

#[test]
fn ones_come_first() {
    let matrix: [&[f64]; 4] = [&[4.0, 1.0, 2.0, 3.0], &[5.0, 3.0, 0.0, 6.0], &[3.0, 2.0, 1.0, 4.0], &[4.0, 0.0, 7.0, 2.0]];
    let mut entries = entries(&matrix);
    entries.iter_mut().filter(|entry| entry.values == [1.0]).for_each(|entry| entry.is_unit = true);
    let elimination = Elimination::new(4, &entries);
    assert!(elimination.is_unit[0]);
    assert!([(0, 1), (2, 2)].contains(&(elimination.rows[0], elimination.columns[0])));
    // The second unit is either changed by the first pivot, or unchanged and then the next pivot.
    assert_eq!(elimination.cost.divisions, 4 - elimination.is_unit.iter().filter(|unit| **unit).count());
}

#[test]
fn a_one_that_elimination_changes_is_one_no_longer() {
    let matrix: [&[f64]; 4] = [&[1.0, 2.0, 3.0, 4.0], &[2.0, 1.0, 3.0, 5.0], &[3.0, 3.0, 1.0, 6.0], &[2.0, 4.0, 5.0, 1.0]];
    let mut entries = entries(&matrix);
    entries.iter_mut().filter(|entry| entry.values == [1.0]).for_each(|entry| entry.is_unit = true);
    let units = in_order(4, &entries).iter().filter(|pivot| pivot.is_unit).count();
    assert!(units <= 1);
}

#[test]
fn a_pivot_that_vanishes_in_one_pose_is_no_pivot() {
    let usual: [&[f64]; 4] = [&[2.0, 1.0, 0.0, 0.0], &[0.0, 2.0, 1.0, 0.0], &[0.0, 0.0, 2.0, 1.0], &[1.0, 0.0, 0.0, 2.0]];
    let special: [&[f64]; 4] = [&[0.0, 1.0, 0.0, 0.0], &[0.0, 1e-15, 1.0, 0.0], &[0.0, 0.0, 2.0, 1.0], &[1.0, 0.0, 0.0, 2.0]];
    let pivots = in_order(4, &in_poses(&[&usual, &special]));
    let is_bad = |pivot: &Pivot| pivot.place == (0, 0) || pivot.place == (1, 1);
    assert!(!pivots.iter().any(is_bad), "{pivots:?}");
}

#[test]
fn numbers_that_are_not_known_do_not_decide() {
    let known: [&[f64]; 4] = [&[2.0, 1.0, 0.0, 0.5], &[0.5, 2.0, 1.0, 0.0], &[0.0, 0.5, 2.0, 1.0], &[1.0, 0.0, 0.5, 2.0]];
    let mut with_unknown = entries(&known);
    with_unknown[2].values[0] = f64::NAN;
    assert_eq!(in_order(4, &with_unknown).len(), 4);
}

#[test]
fn the_factors_multiply_to_the_matrix() {
    let mut numbers = Numbers(5);
    for _ in 0..100 {
        let entries = random(8, 3, &mut numbers);
        let elimination = Elimination::new(8, &entries);
        let mut matrix = vec![vec![0.0; 8]; 8];
        for entry in &entries {
            let (i, j) = elimination.place_of(entry.place).expect("a pivot for every row and column");
            matrix[i][j] = entry.values[0];
        }
        let is_entry = |i: usize, j: usize| elimination.factors.binary_search(&(i, j)).is_ok();
        let mut lu = matrix.clone();
        for i in 0..8 {
            for k in (0..i).filter(|k| is_entry(i, *k)) {
                lu[i][k] /= lu[k][k];
                for j in (k + 1..8).filter(|j| is_entry(k, *j)) {
                    assert!(is_entry(i, j), "({i}, {j}) has no place");
                    lu[i][j] -= lu[i][k] * lu[k][j];
                }
            }
        }
        for (i, row) in matrix.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                let lower = |k: usize| if k == i { 1.0 } else { lu[i][k] };
                let terms = (0..=i.min(j)).filter(|k| is_entry(i, *k) && is_entry(*k, j)).map(|k| lower(k) * lu[k][j]);
                let (sum, size): (f64, f64) = terms.fold((0.0, 1.0), |(sum, size), term| (sum + term, size + term.abs()));
                assert!((sum - entry).abs() <= 1e-13 * size, "{sum} is not {entry}");
            }
        }
    }
}
