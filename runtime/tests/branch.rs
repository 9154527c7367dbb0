//! Following a branch in time.

mod common;

use common::error;
use common::four_bar::{CRANK_ROCKER, FourBar};
use reuleaux::{Mechanism, Stages, State};

fn turn(steps: u32) -> impl Iterator<Item = f64> {
    (0..=steps).map(move |k| f64::from(k) / f64::from(steps))
}

fn last(mechanism: &FourBar, times: impl Iterator<Item = f64>) -> State<f64, 9> {
    mechanism.sweep(times).map(Result::unwrap).last().unwrap()
}

#[test]
fn full_turn_closes_on_itself_to_rounding() {
    let states: Vec<_> = CRANK_ROCKER.sweep(turn(200)).map(Result::unwrap).collect();
    let (first, last) = (&states[0], &states[200]);
    let mut q = first.q;
    q[2] += core::f64::consts::TAU;
    assert!(error(last.q.as_slice(), q.as_slice()) <= 1e-15);
    assert!(error(last.qd.as_slice(), first.qd.as_slice()) <= 1e-14);
    assert!(error(last.qdd.as_slice(), first.qdd.as_slice()) <= 1e-13);

    let iterations: Vec<_> = states[1..].iter().map(|state| state.iterations).collect();
    let mean = iterations.iter().sum::<usize>() as f64 / 200.0;
    println!("factorisations per warm-started step: {mean}, at most {:?}", iterations.iter().max());
    assert!(mean <= 3.0);
}

#[test]
fn coarse_steps_stay_on_the_branch_of_fine_ones() {
    for start in [[0.3, 0.8, 1.5], [0.3, -1.4, -2.0]] {
        let mechanism = FourBar { start, ..CRANK_ROCKER };
        let fine = last(&mechanism, turn(1000));
        for steps in 1..=12 {
            for (coarse, time) in mechanism.sweep(turn(steps)).zip(turn(steps)) {
                let coarse = coarse.unwrap();
                assert_eq!(coarse.branch[0], fine.branch[0]);
                let direct = mechanism.solve(time).unwrap();
                assert!(error(coarse.q.as_slice(), direct.q.as_slice()) <= 1e-15);
            }
            let coarse = last(&mechanism, turn(steps));
            assert!(error(coarse.q.as_slice(), fine.q.as_slice()) <= 1e-15, "{steps} steps");
        }
    }
}

#[test]
fn the_two_assemblies_have_different_orientations() {
    let other = FourBar { start: [0.3, -1.4, -2.0], ..CRANK_ROCKER };
    assert_ne!(CRANK_ROCKER.solve(0.0).unwrap().branch[0], other.solve(0.0).unwrap().branch[0]);
}

#[test]
fn time_runs_backwards_too() {
    let there = CRANK_ROCKER.solve(-3.7).unwrap();
    let back = CRANK_ROCKER.solve_from(0.0, &there).unwrap();
    assert!(error(back.q.as_slice(), CRANK_ROCKER.solve(0.0).unwrap().q.as_slice()) <= 1e-15);
}

#[test]
fn solve_from_a_state_to_its_own_time_is_that_state() {
    let state = CRANK_ROCKER.solve(0.4).unwrap();
    let again = CRANK_ROCKER.solve_from(0.4, &state).unwrap();
    assert!(error(again.q.as_slice(), state.q.as_slice()) <= 1e-15);
}

#[test]
fn velocity_and_acceleration_are_derivatives() {
    let h = 1e-4;
    let [before, now, after] = [0.37 - h, 0.37, 0.37 + h].map(|t| CRANK_ROCKER.solve(t).unwrap());
    let rate = (after.q - before.q) / (2.0 * h);
    let acceleration = (after.qd - before.qd) / (2.0 * h);
    assert!(error(rate.as_slice(), now.qd.as_slice()) <= 1e-6);
    assert!(error(acceleration.as_slice(), now.qdd.as_slice()) <= 1e-6);
    let rocker = now.planar_body(6);
    assert_eq!((rocker.angle, rocker.angular_velocity, rocker.position.x), (now.q[8], now.qd[8], now.q[6]));
    assert_eq!(now.coordinate(5).acceleration, now.qdd[5]);
    assert!(now.coordinate(9).value.is_nan() && now.planar_body(usize::MAX).angle.is_nan());
}

#[test]
fn single_precision_is_at_its_own_rounding_limit() {
    for (single, double) in CRANK_ROCKER.sweep((0..=50_u8).map(|k| f32::from(k) / 64.0)).zip((0..=50).map(|k| f64::from(k) / 64.0)) {
        let (single, double) = (single.unwrap(), CRANK_ROCKER.solve(double).unwrap());
        assert!(error(single.q.map(f64::from).as_slice(), double.q.as_slice()) <= 1e-6);
        assert!(error(single.qd.map(f64::from).as_slice(), double.qd.as_slice()) <= 5e-6);
        assert!(error(single.qdd.map(f64::from).as_slice(), double.qdd.as_slice()) <= 5e-5);
    }
}

#[test]
fn generic_code_takes_any_mechanism() {
    fn rows<E: Stages<f64, N>, const N: usize>(mechanism: &E) -> (usize, usize) {
        (mechanism.solve(0.1).unwrap().iterations, E::ROWS.len())
    }
    assert_eq!(rows(&CRANK_ROCKER).1, 9);
}
