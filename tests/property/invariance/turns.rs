//! Crank-rockers of all shapes return after whole turns.

use std::f64::consts::TAU;

use proptest::prelude::*;
use reuleaux::nalgebra::SVector;
use reuleaux_tests::stress::FourBar;

use super::{cases, difference};

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn three_turns_forward_and_back_return_to_the_start(
        crank in 0.1..0.8, (coupler, rocker, base) in (1.2..2.0, 1.2..2.0, 1.2..2.0),
        speed in prop_oneof![-9.0..-0.5, 0.5..9.0], steps in 1..40
    ) {
        // Grashof: the shortest link, the crank, plus the longest is shorter than the other two together.
        let longest = f64::max(coupler, f64::max(rocker, base));
        prop_assume!(crank + longest < 0.98 * (coupler + rocker + base - longest));
        let links = FourBar { ground_D_x: base, crank_B_x: crank, coupler_C_x: coupler, rocker_C_x: rocker, ..Default::default() };
        let four_bar = FourBar { c1: speed, ..links };
        let guess: SVector<f64, 9> = [0.0, 0.0, 0.9, 0.6 * crank, 0.8 * crank, 0.7, base, 0.0, 1.8].into();
        let start = four_bar.solve_near(0.0, &guess).unwrap();
        let whole = 3.0 * TAU / speed.abs();
        let mut state = start.clone();
        for step in 1..=steps {
            state = four_bar.solve_from(whole * f64::from(step) / f64::from(steps), &state).unwrap();
        }
        let mut unwound = state.clone();
        unwound.0.q[2] -= 3.0 * TAU * speed.signum();
        // 6π is rounded by 2e-15, which the joints amplify by the condition number.
        let allowed = 1e-13 * start.condition * (1.0 + speed * speed);
        prop_assert!(difference(&start, &unwound) <= allowed, "{:e} > {allowed:e}", difference(&start, &unwound));
        for step in (0..steps).rev() {
            state = four_bar.solve_from(whole * f64::from(step) / f64::from(steps), &state).unwrap();
        }
        prop_assert!(difference(&start, &state) <= allowed, "{:e} > {allowed:e}", difference(&start, &state));
        prop_assert_eq!(start.branch, state.branch);
    }
}
