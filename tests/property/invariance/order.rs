//! The order of items has no effect.

use fastrand::Rng;
use proptest::prelude::*;
use reuleaux_tests::common::declared::Instant;
use reuleaux_tests::common::interpreter::Interpreter;

use super::cases;
use super::loader::{BODIES, JOINTS, declaration, items, values};
use crate::random::instant;

/// Position of each of these items in the other list.
fn places(of: &[&str], list: &[&str]) -> Vec<usize> {
    of.iter().filter_map(|item| list.iter().position(|known| known == item)).collect()
}

/// The coordinates in another order of the bodies.
fn bodies_in<T: Copy>(order: &[usize], of: &[T]) -> Vec<T> {
    order.iter().flat_map(|body| of[3 * body..3 * body + 3].to_vec()).collect()
}

/// Rows of each joint of the loader.
fn rows_of_joints() -> Vec<Vec<usize>> {
    let mut next = 0;
    let rows = JOINTS.map(|joint| {
        let count = if joint.contains("revolute(") || joint.contains("translational(") { 2 } else { 1 };
        next += count;
        (next - count..next).collect()
    });
    rows.into()
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| value.to_bits()).collect()
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn order_of_items_changes_nothing(seed: u64) {
        let mut rng = Rng::with_seed(seed);
        let mut mixed = items();
        rng.shuffle(&mut mixed);
        let (bodies, joints) = (places(&mixed, &BODIES), places(&mixed, &JOINTS));
        let (mut one, mut two) = (Interpreter::of(&declaration(&items())), Interpreter::of(&declaration(&mixed)));
        let (first, second) = (values(&one.parameters), values(&two.parameters));
        let at = instant(&mut rng, 12);
        let [q, qd, qdd] = [&at.q, &at.qd, &at.qdd].map(|vector| bodies_in(&bodies, vector));
        let permuted = Instant { t: at.t, q, qd, qdd };
        let (here, there) = (one.rows(&first, &at, &[]), two.rows(&second, &permuted, &[]));
        let rows = rows_of_joints();
        for (row, before) in joints.iter().flat_map(|joint| rows[*joint].clone()).enumerate() {
            let left = bits(&[here.phi[before], here.nu[before], here.gamma[before]]);
            prop_assert_eq!(left, bits(&[there.phi[row], there.nu[row], there.gamma[row]]), "row {}", row);
            prop_assert_eq!(bits(&bodies_in(&bodies, &here.jacobian[before])), bits(&there.jacobian[row]), "row {}", row);
        }
        prop_assert_eq!(one.outputs(&first, &at, &[]), two.outputs(&second, &permuted, &[]));
        for (x, y) in bodies_in(&bodies, &one.start).iter().zip(&two.start) {
            prop_assert!((x - y).abs() <= 1e-14, "{} {}", x, y);
        }
    }
}
