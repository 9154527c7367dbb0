//! Lengths times a factor: positions scale by the factor, angles stay.

use proptest::prelude::*;
use reuleaux::State;
use reuleaux_tests::mechanisms::HydraulicLoader;
use reuleaux_tests::stress::{FourBar, InLineSliderCrank};

use super::{cases, difference};

/// A state with all lengths multiplied.
fn scaled<const N: usize>(state: &State<f64, N>, factor: f64) -> State<f64, N> {
    let mut scaled = state.clone();
    let values = &mut *scaled;
    for vector in [&mut values.q, &mut values.qd, &mut values.qdd] {
        for (index, entry) in vector.iter_mut().enumerate() {
            *entry *= if index % 3 == 2 { 1.0 } else { factor };
        }
    }
    scaled
}

fn four_bar(factor: f64, angle: f64, speed: f64) -> FourBar {
    let [base, crank, coupler, rocker] = [0.2, 0.1, 0.25, 0.2].map(|length: f64| length * factor);
    FourBar { ground_D_x: base, crank_B_x: crank, coupler_C_x: coupler, rocker_C_x: rocker, c0: angle, c1: speed, ..Default::default() }
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn a_four_bar_of_any_size_has_the_same_angles(factor in 1e-3..1e3, angle in -3.0..3.0, speed in -3.0..3.0) {
        let small = four_bar(1.0, angle, speed).solve_near(0.0, &four_bar(1.0, 0.0, 0.0).start()).unwrap();
        let large = four_bar(factor, angle, speed).solve_near(0.0, &scaled(&small, factor).q).unwrap();
        let back = scaled(&large, 1.0 / factor);
        prop_assert!(difference(&small, &back) <= 1e-14 * small.condition, "{:e}", difference(&small, &back));
    }

    /// Multiplication by a power of two is exact, and so are all results.
    #[test]
    fn a_slider_crank_of_twice_the_size_has_the_same_bits(power in -20..20, angle in 0.1..3.0, rod in 1.2..4.0, speed in -3.0..3.0) {
        let factor = f64::from(power).exp2();
        let small = InLineSliderCrank { rod_B_x: rod, c0: angle, c1: speed, ..Default::default() };
        let large = InLineSliderCrank { crank_A_x: factor, rod_B_x: rod * factor, ..small };
        let guess = small.start();
        let one = small.solve_near(0.0, &guess).unwrap();
        let two = large.solve_near(0.0, &scaled(&one, factor).q).unwrap();
        let again = small.solve_near(0.0, &one.q).unwrap();
        prop_assert_eq!(scaled(&again, factor).q, two.q);
        prop_assert_eq!(scaled(&again, factor).qd, two.qd);
        prop_assert_eq!(scaled(&again, factor).qdd, two.qdd);
    }

    /// Time scales as well: twice the speed gives twice the rates and four times the accelerations, at half the time.
    #[test]
    fn speed_scales_rates_and_accelerations(angle in -3.0..3.0, speed in 0.1..3.0, t in 0.0..2.0) {
        let (slow, fast) = (four_bar(1.0, angle, speed), four_bar(1.0, angle, 2.0 * speed));
        let start = slow.solve_near(0.0, &four_bar(1.0, 0.0, 0.0).start()).unwrap();
        let slow = slow.solve_from(t, &start).unwrap();
        let origin = fast.solve_near(0.0, &start.q).unwrap();
        let mut fast = fast.solve_from(t / 2.0, &origin).unwrap();
        fast.0.qd /= 2.0;
        fast.0.qdd /= 4.0;
        prop_assert!(difference(&slow, &fast) <= 1e-13 * slow.condition, "{:e}", difference(&slow, &fast));
    }
}

#[test]
fn lengths_in_parameters_are_in_metres_whatever_the_declaration_says() {
    let loader = HydraulicLoader::default();
    assert_eq!([loader.lift, loader.lift_stroke, loader.tilt, loader.tilt_stroke], [1.55, 0.3, 1.35, 0.12]);
}
