//! A four-bar over full turns: closed paths close.

use std::f64::consts::TAU;

use reuleaux_tests::mechanisms::{FourBarCrankRocker, FourBarCrankRockerState};

/// A crank at one turn per second, without ripple.
fn steady() -> FourBarCrankRocker {
    FourBarCrankRocker { speed: TAU, ripple: 0.0, ..Default::default() }
}

/// Largest differences of q (minus `turns` turns of the crank), q̇ and q̈, relative to the largest entry.
fn differences(from: &FourBarCrankRockerState, to: &FourBarCrankRockerState, turns: f64) -> [f64; 3] {
    let mut q = to.q;
    q[2] -= turns * TAU;
    [(from.q, q), (from.qd, to.qd), (from.qdd, to.qdd)].map(|(from, to)| (to - from).amax() / from.amax())
}

#[test]
fn steps_of_a_full_turn_close_on_themselves() {
    let times = (0..=100).map(|step| f64::from(step) / 100.0);
    let states: Vec<FourBarCrankRockerState> = steady().sweep(times).collect::<Result<_, _>>().unwrap();
    assert_eq!(states.len(), 101);
    let differences = differences(&states[0], &states[100], 1.0);
    println!("after a turn in 100 steps: {differences:?}");
    // 2π + 0.5 is rounded by 4e-16 and 2π by 2e-16; the joints amplify these errors by about ten.
    assert!(differences[0] <= 1e-14 && differences[1] <= 2e-14 && differences[2] <= 1e-13, "{differences:?}");
    // The crank-rocker has moved between: its rocker swings by more than a radian.
    let angles = states.iter().map(|state| state.rocker().angle);
    assert!(angles.clone().fold(f64::MIN, f64::max) - angles.fold(f64::MAX, f64::min) > 1.0);
}

#[test]
fn three_turns_forward_and_back_end_where_they_began() {
    let mechanism = steady();
    let start = mechanism.solve(0.0).unwrap();
    let forward = (1..=180).map(|step| f64::from(step) / 60.0);
    let back = (0..180).rev().map(|step| f64::from(step) / 60.0);
    let mut state = start.clone();
    for t in forward {
        state = mechanism.solve_from(t, &state).unwrap();
    }
    let there = differences(&start, &state, 3.0);
    for t in back {
        state = mechanism.solve_from(t, &state).unwrap();
    }
    let back = differences(&start, &state, 0.0);
    println!("three turns forward {there:?} and back {back:?}");
    assert!(there[0] <= 2e-14 && there[1] <= 4e-14 && there[2] <= 2e-13, "{there:?}");
    assert!(back[0] <= 4e-15 && back[1] <= 1e-14 && back[2] <= 5e-14, "{back:?}");
}

#[test]
fn one_long_step_over_three_turns_is_the_same_as_many() {
    let mechanism = steady();
    let direct = mechanism.solve(3.1).unwrap();
    let stepped = mechanism.sweep((0..=310).map(|step| f64::from(step) / 100.0)).last().unwrap().unwrap();
    let differences = differences(&direct, &stepped, 0.0);
    assert!(differences[0] <= 1e-15 && differences[1] <= 1e-14 && differences[2] <= 5e-14, "{differences:?}");
}
