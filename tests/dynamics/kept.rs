//! Energy and momenta of free motions over many steps.

use super::plane::{DoublePendulum, DoublePendulumState};
use super::space::{FreeBody, FreeBodyState, SteadyTop, SteadyTopState};
use reuleaux::nalgebra::{Matrix3, Vector3};

/// Steps of a run that is done on request, and in every run of the tests.
const MANY: usize = 100_000;
const FEW: usize = 2_000;

/// Ten times the smallest tolerance of the integrator.
const DRIFT: f64 = 10.0 * 1e-12;

/// Makes steps of a size, and asserts that the numbers which `kept` gives of each state stay what they were, relative to `sizes`.
macro_rules! keeps {
    ($mechanism:expr, $steps:expr, $h:expr, $kept:expr) => {{
        let mechanism = $mechanism;
        let mut state = mechanism.initial_state().expect("a state");
        let kept = $kept;
        let start: Vec<[f64; 2]> = kept(&mechanism, &state);
        let mut worst = 0.0_f64;
        for number in 0..$steps {
            mechanism.step(&mut state, $h).expect("a step");
            // At every hundredth step: numbers drift, they do not jump.
            if number % 100 == 99 {
                for ([value, size], [first, _]) in kept(&mechanism, &state).into_iter().zip(&start) {
                    worst = worst.max((value - first).abs() / size);
                }
            }
        }
        println!("{} steps: {worst:.1e}", $steps);
        assert!(worst < DRIFT, "{worst:e}");
    }};
}

/// Energy, momentum less the impulse of the weight, and angular momentum about the centre of mass; each with its size.
fn of_free_body(mechanism: &FreeBody, state: &FreeBodyState) -> Vec<[f64; 2]> {
    let body = state.body();
    let inertia = Matrix3::from_diagonal(&Vector3::new(0.02, 0.035, 0.05));
    let spin = body.rotation * inertia * body.rotation.transpose() * body.angular_velocity;
    let momentum = (body.velocity + Vector3::new(0.0, 0.0, 9.81 * state.t)) * 0.8;
    let energy = mechanism.energy(state);
    let size = energy.kinetic.abs().max(energy.potential.abs());
    // The weight makes the body fast: roundings are those of its momentum then.
    let weight = (0.8 * 9.81 * state.t).max(momentum.norm());
    let momenta = momentum.iter().map(|part| [*part, weight]).chain(spin.iter().map(|part| [*part, spin.norm()]));
    [[energy.kinetic + energy.potential, size]].into_iter().chain(momenta).collect()
}

/// Energy, angular momentum about the vertical through the pin and about the top's own axis, which is one of symmetry.
fn of_top(mechanism: &SteadyTop, state: &SteadyTopState) -> Vec<[f64; 2]> {
    let body = state.top();
    let about_pin = 0.004 + 1.3 * 0.11 * 0.11;
    let inertia = Matrix3::from_diagonal(&Vector3::new(about_pin, about_pin, 0.0017));
    let spin = body.rotation * inertia * body.rotation.transpose() * body.angular_velocity;
    let energy = mechanism.energy(state);
    let axis = body.rotation.column(2).into_owned();
    vec![[energy.kinetic + energy.potential, energy.kinetic], [spin.z, spin.norm()], [spin.dot(&axis), spin.norm()]]
}

/// Energy, which is at most that of both links at full height.
fn of_double_pendulum(mechanism: &DoublePendulum, state: &DoublePendulumState) -> Vec<[f64; 2]> {
    let energy = mechanism.energy(state);
    vec![[energy.kinetic + energy.potential, 9.81 * (1.0 * 0.25 + 0.8 * 0.7)]]
}

#[test]
fn a_free_body_keeps_its_energy_and_momenta() {
    keeps!(FreeBody::default(), FEW, 0.02, of_free_body);
}

#[test]
fn a_top_keeps_its_energy_and_two_angular_momenta() {
    keeps!(SteadyTop::default(), FEW, 0.0005, of_top);
}

#[test]
fn a_double_pendulum_keeps_its_energy() {
    keeps!(DoublePendulum::default(), FEW, 0.002, of_double_pendulum);
}

/// `cargo test --release -p reuleaux-tests --test dynamics -- --ignored`
#[test]
#[ignore = "a minute without optimisation"]
fn a_free_body_keeps_its_energy_and_momenta_over_a_hundred_thousand_steps() {
    keeps!(FreeBody::default(), MANY, 0.02, of_free_body);
}

/// `cargo test --release -p reuleaux-tests --test dynamics -- --ignored`
#[test]
#[ignore = "a minute without optimisation"]
fn a_top_keeps_its_energy_and_two_angular_momenta_over_a_hundred_thousand_steps() {
    keeps!(SteadyTop::default(), MANY, 0.0005, of_top);
}

/// `cargo test --release -p reuleaux-tests --test dynamics -- --ignored`
#[test]
#[ignore = "a minute without optimisation"]
fn a_double_pendulum_keeps_its_energy_over_a_hundred_thousand_steps() {
    keeps!(DoublePendulum::default(), MANY, 0.002, of_double_pendulum);
}
