//! Six mechanisms against 60-digit references.

mod common;

use common::error;
use common::planar::Reference;
use common::reference::*;
use reuleaux::nalgebra::SVector;
use reuleaux::{DetSign, Mechanism, State};

/// Asserts that q, q̇ and q̈ are at the rounding limit and returns their errors, relative to the largest entry.
fn assert_state<const N: usize>(state: &State<f64, N>, reference: &Reference<N>, index: usize) -> [f64; 3] {
    let (_, q, qd, qdd) = &reference.states[index];
    let errors = [error(state.q.as_slice(), q), error(state.qd.as_slice(), qd), error(state.qdd.as_slice(), qdd)];
    assert!(errors[0] <= 1e-14 && errors[1] <= 2e-14 && errors[2] <= 2e-13, "state {index}: {errors:?}");
    assert_eq!(state.branch[0] == DetSign::Positive, reference.orientation > 0.0);
    errors
}

fn check<const N: usize>(name: &str, reference: &Reference<N>) {
    let mut worst = [0.0_f64; 3];
    let mut note = |errors: [f64; 3]| worst = core::array::from_fn(|i| worst[i].max(errors[i]));

    for (index, state) in reference.sweep(reference.states.iter().map(|state| state.0)).enumerate() {
        note(assert_state(&state.unwrap(), reference, index));
    }
    for (index, expected) in reference.states.iter().enumerate() {
        note(assert_state(&reference.solve(expected.0).unwrap(), reference, index));
    }
    for rough in reference.rough {
        let state = reference.solve_near(reference.states[0].0, &SVector::from(*rough)).unwrap();
        note(assert_state(&state, reference, 0));
    }
    println!("{name}: largest errors of q, q̇, q̈ {worst:?}");
}

#[test]
fn four_bar_crank_rocker_is_at_the_rounding_limit() {
    check("four-bar", &FOUR_BAR_CRANK_ROCKER);
}

#[test]
fn slider_crank_is_at_the_rounding_limit() {
    check("slider-crank", &SLIDER_CRANK);
}

#[test]
fn quick_return_is_at_the_rounding_limit() {
    check("quick return", &QUICK_RETURN);
}

#[test]
fn theo_jansen_leg_is_at_the_rounding_limit() {
    check("Theo Jansen leg", &THEO_JANSEN_LEG);
}

#[test]
fn hydraulic_loader_is_at_the_rounding_limit() {
    check("hydraulic loader", &HYDRAULIC_LOADER);
}

#[test]
fn two_stage_gear_train_is_at_the_rounding_limit() {
    check("gear train", &TWO_STAGE_GEAR_TRAIN);
}
