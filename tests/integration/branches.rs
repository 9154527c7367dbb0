//! The declared assembly is kept, however far times and parameters are from the start.

use reuleaux::{Cause, mechanism};
use reuleaux_tests::branches::families::{Cylinders, Family, Fourth, Platform, Stephenson};
use reuleaux_tests::branches::{Tally, try_steps};
use reuleaux_tests::samples;
use std::f64::consts::TAU;

mechanism! {
    /// A crank-rocker whose rocker turns a wheel three times as fast: a wrong turn of the rocker would show in the wheel.
    pub mechanism Geared {
        param crank_length: Length = 100mm;
        param coupler_length: Length = 350mm;
        param rocker_length: Length = 300mm;
        param base: Length = 400mm;
        ground { point O = (0mm, 0mm); point C = (base, 0mm); point W = (600mm, 0mm); }
        body crank { point O = (0mm, 0mm); point A = (crank_length, 0mm); start angle = 0deg; }
        body coupler { point A = (0mm, 0mm); point B = (coupler_length, 0mm); }
        body rocker { point C = (0mm, 0mm); point B = (rocker_length, 0mm); start angle = 70deg; }
        body wheel { point W = (0mm, 0mm); point rim = (50mm, 0mm); }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        joint w = revolute(ground.W, wheel.W);
        joint mesh = gear_pair(rocker, wheel, 3, 1);
        drive input = drive_angle(crank, 1turn * t / 1s);
        output rim = wheel.rim;
    }
}

/// The rocker's angle in closed form, with B to the left of the way from A to C.
fn rocker_angle(m: &Geared, crank: f64) -> f64 {
    let (x, y) = (m.base - m.crank_length * crank.cos(), -m.crank_length * crank.sin());
    let square = x * x + y * y;
    let along = (m.coupler_length.powi(2) - m.rocker_length.powi(2) + square) / (2.0 * square);
    let across = (m.coupler_length.powi(2) / square - along * along).sqrt();
    let (bx, by) = (x * along - y * across - x, y * along + x * across - y);
    by.atan2(bx)
}

#[test]
fn long_steps_come_to_the_same_turn() {
    let mechanism = Geared::default();
    let mut random = fastrand::Rng::with_seed(7);
    let mut state = mechanism.solve(0.0).expect("an assembly");
    for _ in 0..samples(40, 300) {
        // Up to a hundred turns forwards or backwards, and exact numbers of turns, at which the crank seems not to have moved.
        let t = if random.bool() { random.f64() * 200.0 - 100.0 } else { f64::from(random.i32(-100..100)) };
        state = mechanism.solve_from(t, &state).expect("a Grashof crank turns for ever");
        let angle = rocker_angle(&mechanism, TAU * t);
        assert!((state.rocker().angle - angle).abs() < 1e-11, "rocker at {} for {angle} at {t} s", state.rocker().angle);
        let rim = mechanism.rim(&state).value;
        let expected = (0.6 + 0.05 * (3.0 * angle).cos(), -0.05 * (3.0 * angle).sin());
        assert!((rim.x - expected.0).abs() < 1e-11 && (rim.y - expected.1).abs() < 1e-11, "rim at {t} s");
    }
}

#[test]
fn a_state_serves_parameters_that_are_near_and_no_others() {
    let declared = Geared::default();
    let state = declared.solve(0.1).expect("an assembly");
    let near = Geared { rocker_length: declared.rocker_length + 1e-3, ..declared };
    let angle = near.solve_from(0.1, &state).expect("an assembly next to it").rocker().angle;
    assert!((angle - rocker_angle(&near, 0.1 * TAU)).abs() < 1e-11, "rocker at {angle}");
    let far = Geared { rocker_length: declared.rocker_length - 70e-3, ..declared };
    for t in [0.1, 0.10001] {
        let failure = far.solve_from(t, &state).expect_err("no assembly is near");
        let Cause::StateTooFar { coordinate, jump } = failure.cause else { panic!("{failure}") };
        assert!(["coupler", "rocker"].contains(&coordinate.body) && (0.1..0.5).contains(&jump.abs()), "{failure}");
        assert!(
            failure.to_string().starts_with(&format!("`Geared` has no state at t = {t} s near the given one, from which ")),
            "{failure}"
        );
    }
    assert!((far.solve(0.1).expect("it closes").rocker().angle - rocker_angle(&far, 0.1 * TAU)).abs() < 1e-11);
}

#[test]
fn one_long_step_is_many_short_ones() {
    let mechanism = Geared::default();
    for turns in [19, 150, 300] {
        let angle = mechanism.solve(f64::from(turns)).expect("a Grashof crank turns for ever").rocker().angle;
        assert!((angle - rocker_angle(&mechanism, 0.0)).abs() < 1e-11, "{angle} after {turns} turns");
    }
}

#[test]
fn other_lengths_keep_the_declared_assembly() {
    let mut random = fastrand::Rng::with_seed(11);
    let mut solved = 0;
    for _ in 0..2000 {
        let mut length = |least: f64, most: f64| least + (most - least) * random.f64();
        let (crank_length, coupler_length) = (length(0.02, 0.3), length(0.05, 1.0));
        let mechanism = Geared { crank_length, coupler_length, rocker_length: length(0.05, 1.0), base: length(0.05, 1.0) };
        let reach = (mechanism.base - crank_length).abs();
        let closes =
            reach < 0.999 * (coupler_length + mechanism.rocker_length) && reach > 1.001 * (coupler_length - mechanism.rocker_length).abs();
        // If the base is shorter than the crank, the path of parameters leads through a fold or around it.
        if !closes || mechanism.base < crank_length {
            continue;
        }
        let state = mechanism.solve(0.0).unwrap_or_else(|failure| panic!("{failure} with {mechanism:?}"));
        let off = (state.rocker().angle - rocker_angle(&mechanism, 0.0)).rem_euclid(TAU);
        assert!(off.min(TAU - off) < 1e-6, "mirrored with {mechanism:?}");
        solved += 1;
    }
    assert!(solved > 500, "{solved} of the random linkages close");
}

/// A few steps on loops with several assemblies of each sign; `benches/branches.rs` takes many.
fn no_step_leaves_its_branch<M: Family<N>, const N: usize>() {
    let mut tally = Tally::default();
    try_steps::<M, N>(&mut fastrand::Rng::with_seed(23), 160, &mut tally);
    assert!(tally.is_good(1000) && 2 * tally.right > tally.steps, "{tally:#?}");
}

#[test]
fn no_step_of_a_plate_on_cylinders_leaves_its_branch() {
    no_step_leaves_its_branch::<Cylinders, _>();
}

#[test]
fn no_step_of_a_platform_leaves_its_branch() {
    no_step_leaves_its_branch::<Platform, _>();
}

#[test]
fn no_step_of_a_six_bar_driven_from_afar_leaves_its_branch() {
    no_step_leaves_its_branch::<Stephenson, _>();
}

#[test]
fn no_step_of_a_group_of_the_fourth_class_leaves_its_branch() {
    no_step_leaves_its_branch::<Fourth, _>();
}

mechanism! {
    /// A crank-rocker.
    pub mechanism Rocking {
        param coupler: Length = 350mm;
        body crank { point A = (100mm, 0mm); }
        body rod { point B = (coupler, 0mm); }
        body rocker { point B = (300mm, 0mm);  start angle = 120deg; }
        joint first = revolute(ground.position, crank.position);
        joint second = revolute(crank.A, rod.position);
        joint third = revolute(rod.B, rocker.B);
        joint fourth = revolute((400mm, 0mm), rocker.position);
        drive motor = drive_angle(crank, 1rad_s * t);
        slice output swing = rocker.angle;
    }
}

/// With the new length the rocker is 15 degrees away from the given state. The output is no unknown, whatever its unit.
#[test]
fn a_slice_from_a_state_too_far_names_the_unknown_that_would_jump() {
    let rocking = Rocking::default();
    let (mut whole, mut slice) = (rocking.solve(0.1).unwrap(), rocking.solve_for_swing().solve(0.1).unwrap());
    let shorter = Rocking { coupler: 0.28 };
    let failure = shorter.solve_for_swing().advance(&mut slice, 0.1).unwrap_err();
    assert!(matches!(failure.cause, Cause::StateTooFar { .. }) && failure.last.is_none(), "{failure}");
    let failure = failure.to_string();
    assert_eq!(failure, shorter.advance(&mut whole, 0.1).unwrap_err().to_string());
    let there = shorter.solve(0.1).unwrap();
    let turned = [there.rod().angle - whole.rod().angle, there.rocker().angle - whole.rocker().angle].map(f64::to_degrees);
    let names_jump = |(body, turned): (&str, f64)| failure.contains(&format!("`{body}.angle` would jump by {:.1}°", turned.abs()));
    assert!(["rod", "rocker"].into_iter().zip(turned).any(names_jump), "{failure} {turned:?}");
}
