//! The power of drives and forces is the rate of kinetic and potential energy, in every example that has masses.
//!
//! ```text
//! Σ drives + Σ forces = d/dt Σ (½ m v² + ½ ω·I ω) + d/dt V      the rate from places, speeds and accelerations of the bodies
//! ```
//!
//! Masses, inertias and springs are written here once more.

#![allow(dead_code, unreachable_pub)] // Each example is a program with a `main`.

use std::f64::consts::TAU;

use reuleaux::nalgebra::{Matrix3, Vector2, Vector3};
use reuleaux::{Energy, Integrator, Motion, PlanarBody, SpatialBody};

#[path = "../andrews.rs"]
mod andrews;
#[path = "../bricard.rs"]
mod bricard;
#[path = "../engine.rs"]
mod engine;
#[path = "../four_bar_balance.rs"]
mod four_bar_balance;
#[path = "../geared_start.rs"]
mod geared_start;
#[path = "../governor.rs"]
mod governor;
#[path = "../loaded_differential.rs"]
mod loaded_differential;
#[path = "../loads.rs"]
mod loads;
#[path = "../pendulums.rs"]
mod pendulums;
#[path = "../rolling_coin.rs"]
mod rolling_coin;
#[path = "../spinning_top.rs"]
mod spinning_top;
#[path = "../vehicle_corner.rs"]
mod vehicle_corner;

/// Of the largest term.
const BOUND: f64 = 1e-12;
/// States of each mechanism.
const STATES: u32 = 12;

/// What energies and their rates are made of, in J and in W.
struct Ledger {
    gravity: Vector3<f64>,
    kinetic: f64,
    potential: f64,
    rates: Vec<f64>,
}

impl Ledger {
    fn new(gravity: Vector3<f64>) -> Self {
        Self { gravity, kinetic: 0.0, potential: 0.0, rates: Vec::new() }
    }

    fn plane() -> Self {
        Self::new(Vector3::new(0.0, -9.81, 0.0))
    }

    fn space() -> Self {
        Self::new(Vector3::new(0.0, 0.0, -9.81))
    }

    fn mass(&mut self, mass: f64, centre: &Motion<Vector3<f64>>) {
        self.kinetic += 0.5 * mass * centre.rate.norm_squared();
        self.potential -= mass * self.gravity.dot(&centre.value);
        self.rates.extend((centre.rate.component_mul(&centre.acceleration) * mass).iter());
        self.rates.push(-mass * self.gravity.dot(&centre.rate));
    }

    /// A body in the plane with its mass (kg), centre (m, in its frame) and inertia (kg m²).
    fn planar(mut self, body: &PlanarBody<f64>, mass: f64, centre: [f64; 2], inertia: f64) -> Self {
        let raised = |vector: Vector2<f64>| Vector3::new(vector.x, vector.y, 0.0);
        let Motion { value, rate, acceleration } = body.point(centre.into());
        self.mass(mass, &Motion { value: raised(value), rate: raised(rate), acceleration: raised(acceleration) });
        self.kinetic += 0.5 * inertia * body.angular_velocity.powi(2);
        self.rates.push(inertia * body.angular_velocity * body.angular_acceleration);
        self
    }

    /// A body in space with its mass (kg), centre (m) and principal moments of inertia (kg m²), both in its frame.
    fn spatial(mut self, body: &SpatialBody<f64>, mass: f64, centre: [f64; 3], inertia: [f64; 3]) -> Self {
        self.mass(mass, &body.point(centre.into()));
        let inertia = body.rotation * Matrix3::from_diagonal(&inertia.into()) * body.rotation.transpose();
        let spin = body.angular_velocity;
        self.kinetic += 0.5 * spin.dot(&(inertia * spin));
        self.rates.extend(spin.component_mul(&(inertia * body.angular_acceleration)).iter());
        self
    }

    /// A spring (N/m) of this length, and its length without load (m).
    fn spring(mut self, stiffness: f64, length: &Motion<f64>, rest: f64) -> Self {
        self.potential += 0.5 * stiffness * (length.value - rest).powi(2);
        self.rates.push(stiffness * (length.value - rest) * length.rate);
        self
    }

    /// Energies are those of the mechanism, and their rate is the power of its drives and forces.
    fn assert(&self, name: &str, energy: Energy<f64>, drives: &[f64]) {
        let size = self.kinetic.abs().max(self.potential.abs());
        let off = (energy.kinetic - self.kinetic).abs().max((energy.potential - self.potential).abs());
        assert!(off <= BOUND * size, "{name}: energies are off by {off:e} of {size} J");
        let powers: Vec<f64> = drives.iter().copied().chain([energy.power]).chain(self.rates.iter().map(|rate| -rate)).collect();
        let largest = powers.iter().map(|power| power.abs()).fold(0.0, f64::max);
        let missing = powers.iter().sum::<f64>();
        assert!(largest > 0.0 && missing.abs() <= BOUND * largest, "{name}: {missing:e} of {largest} W are missing");
    }
}

/// Numbers between 0 and 1 that follow no pattern: multiples of roots, their fractions.
fn share(number: u32, of: u32) -> f64 {
    (f64::from(number + 1) * [2.0_f64, 3.0, 5.0, 7.0][of as usize].sqrt()).fract()
}

/// The state of a motion at a time.
/// Distance of a point of a body from one of ground.
fn apart(body: &PlanarBody<f64>, local: Vector2<f64>, fixed: Vector2<f64>) -> Motion<f64> {
    let Motion { value, rate, acceleration } = body.point(local);
    let (line, way) = (value - fixed, (value - fixed).normalize());
    let across = rate.norm_squared() - way.dot(&rate).powi(2);
    Motion { value: line.norm(), rate: way.dot(&rate), acceleration: way.dot(&acceleration) + across / line.norm() }
}

macro_rules! moved {
    ($mechanism:expr, $time:expr) => {{
        let mut state = $mechanism.initial_state().expect("a state");
        $mechanism.advance(&mut state, $time, &mut Integrator::new(1e-9)).expect("a motion");
        state
    }};
}

#[test]
fn a_driven_four_bar_with_a_counterweight() {
    for k in 0..STATES {
        let m = four_bar_balance::Balanced { speed: 10.0 + 40.0 * share(k, 0), weight: share(k, 1) };
        let state = m.solve(share(k, 2)).expect("a state");
        Ledger::plane()
            .planar(&state.crank(), 0.5, [0.025, 0.0], 0.5 * 0.05 * 0.05 / 12.0)
            .planar(&state.coupler(), 0.4, [0.08, 0.0], 0.4 * 0.2 * 0.2 / 12.0)
            .planar(&state.rocker(), 0.3, [0.075, 0.0], 0.3 * 0.15 * 0.15 / 12.0)
            .planar(&state.disc(), m.weight, [0.0; 2], 0.0)
            .assert("four_bar_balance", m.energy(&state), &[m.loads(&state).motor().power]);
    }
}

#[test]
fn a_driven_four_bar_with_two_weights() {
    for k in 0..STATES {
        let m = loads::Loaded { speed: 10.0 + 40.0 * share(k, 0), crank_weight: share(k, 1), rocker_weight: share(k, 2) };
        let state = m.solve(share(k, 3)).expect("a state");
        Ledger::plane()
            .planar(&state.crank(), 0.1, [0.02, 0.0], 2e-5)
            .planar(&state.coupler(), 0.25, [0.06, 0.0], 4e-4)
            .planar(&state.rocker(), 0.2, [0.04, 0.0], 1.5e-4)
            .planar(&state.on_crank(), m.crank_weight, [0.0; 2], 0.0)
            .planar(&state.on_rocker(), m.rocker_weight, [0.0; 2], 0.0)
            .assert("loads", m.energy(&state), &[m.loads(&state).motor().power]);
    }
}

#[test]
fn an_engine_that_is_driven_or_runs() {
    let ledger = |crank: &PlanarBody<f64>, rod: &PlanarBody<f64>, piston: &PlanarBody<f64>, flywheel: f64| {
        Ledger::plane().planar(crank, 8.0, [0.0; 2], flywheel).planar(rod, 0.6, [0.05, 0.0], 0.002).planar(piston, 0.5, [0.0; 2], 0.0)
    };
    for k in 0..STATES {
        let (speed, flywheel, load) = (50.0 + 200.0 * share(k, 0), 0.1 + share(k, 1), 80.0 * share(k, 2));
        let m = engine::Driven { speed, flywheel, load };
        let state = m.solve(0.1 * share(k, 3)).expect("a state");
        let power = m.loads(&state).motor().power;
        ledger(&state.crank(), &state.rod(), &state.piston(), flywheel).assert("engine", m.energy(&state), &[power]);
        let m = engine::Free { speed, flywheel, load };
        let state = moved!(m, 0.1 * share(k, 3));
        ledger(&state.crank(), &state.rod(), &state.piston(), flywheel).assert("engine", m.energy(&state), &[]);
    }
}

#[test]
fn a_hoist_that_is_switched_on() {
    for k in 0..STATES {
        let m = geared_start::Hoist { stall: 3.0 + 6.0 * share(k, 0), load: 20.0 * share(k, 1), ..geared_start::Hoist::default() };
        let state = moved!(m, 2.0 * share(k, 2));
        Ledger::new(Vector3::zeros())
            .planar(&state.motor(), 2.0, [0.0; 2], 0.006)
            .planar(&state.middle(), 6.0, [0.0; 2], 0.03)
            .planar(&state.drum(), 20.0, [0.0; 2], 0.9)
            .assert("geared_start", m.energy(&state), &[]);
    }
}

#[test]
fn pendulums_far_from_rest() {
    for k in 0..STATES {
        let m = pendulums::Double { first: 3.0 * share(k, 0), second: -2.0 * share(k, 1), ..pendulums::Double::default() };
        let state = moved!(m, 0.1 + 0.5 * share(k, 2));
        Ledger::plane().planar(&state.upper(), 1.0, [0.0, -m.length], 0.0).planar(&state.lower(), 1.0, [0.0, -m.length], 0.0).assert(
            "pendulums",
            m.energy(&state),
            &[],
        );
    }
}

#[test]
fn andrews_mechanism() {
    for k in 0..STATES {
        let m = andrews::Andrews { torque: 0.01 + 0.05 * share(k, 0) };
        let state = moved!(m, 0.02 * share(k, 1));
        Ledger::new(Vector3::zeros())
            .planar(&state.of(), 0.04325, [0.0; 2], 2.194e-6)
            .planar(&state.ef(), 0.00365, [0.0; 2], 4.41e-7)
            .planar(&state.bde(), 0.02373, [0.0; 2], 5.255e-6)
            .planar(&state.ge(), 0.00706, [0.0; 2], 5.667e-7)
            .planar(&state.ag(), 0.0705, [0.0; 2], 1.169e-5)
            .planar(&state.he(), 0.00706, [0.0; 2], 5.667e-7)
            .planar(&state.ah(), 0.05498, [0.0; 2], 1.912e-5)
            .spring(4530.0, &apart(&state.bde(), Vector2::new(0.00957, 0.00074), Vector2::new(0.014, 0.072)), 0.07785)
            .assert("andrews", m.energy(&state), &[]);
    }
}

#[test]
fn the_corner_of_a_car_over_a_bump() {
    for k in 0..STATES {
        let m = vehicle_corner::Corner {
            lift: 0.03 * share(k, 0),
            bump: 0.04 * share(k, 1),
            damping: 4000.0 * share(k, 2),
            ..vehicle_corner::Corner::default()
        };
        let state = moved!(m, 0.1 + 0.3 * share(k, 3));
        Ledger::plane()
            .planar(&state.car(), 320.0, [0.0; 2], 0.0)
            .planar(&state.lower(), 5.0, [0.18, 0.0], 0.06)
            .planar(&state.upper(), 3.0, [0.13, 0.01], 0.02)
            .planar(&state.upright(), 30.0, [0.08, 0.13], 0.9)
            .spring(40e3, &m.spring(&state), m.rest)
            .assert("vehicle_corner", m.energy(&state), &[m.loads(&state).road().power]);
    }
}

#[test]
fn a_governor_that_settles() {
    for k in 0..STATES {
        let m = governor::Governor { speed: TAU * (1.5 + share(k, 0)), load: share(k, 1), ..governor::Governor::default() };
        let state = moved!(m, 0.5 * share(k, 2));
        let ball = [0.0, 0.0, -m.arm];
        Ledger::space()
            .spatial(&state.left(), m.ball, ball, [0.0; 3])
            .spatial(&state.right(), m.ball, ball, [0.0; 3])
            .spatial(&state.sleeve(), m.load, [0.0; 3], [0.0; 3])
            .assert("governor", m.energy(&state), &[m.loads(&state).engine().power]);
    }
}

#[test]
fn a_differential_under_load() {
    for k in 0..STATES {
        let m = loaded_differential::Loaded {
            torque: 100.0 * share(k, 0) + 20.0,
            right_drag: share(k, 1),
            ..loaded_differential::Loaded::default()
        };
        let state = moved!(m, 5.0 * share(k, 2));
        let wheel = [0.5, 0.9, 0.5];
        Ledger::new(Vector3::zeros())
            .spatial(&state.cage(), 6.0, [0.0; 3], [0.02, 0.03, 0.02])
            .spatial(&state.left(), 20.0, [0.0; 3], wheel)
            .spatial(&state.right(), 20.0, [0.0; 3], wheel)
            .spatial(&state.planet(), 2.0, [0.032, 0.0, 0.0], [0.02, 0.012, 0.012])
            .assert("loaded_differential", m.energy(&state), &[]);
    }
}

#[test]
fn a_top() {
    for k in 0..STATES {
        let m = spinning_top::Top { lean: 0.2 + share(k, 0), spin: 300.0 * share(k, 1), precession: 4.0 * share(k, 2) };
        let state = moved!(m, 0.3 * share(k, 3));
        Ledger::space().spatial(&state.top(), 0.3, [0.0, 0.0, 0.06], [2e-4, 2e-4, 2.5e-4]).assert("spinning_top", m.energy(&state), &[]);
    }
}

#[test]
fn a_coin_that_rolls() {
    for k in 0..STATES {
        let m = rolling_coin::Coin {
            lean: 0.6 + 0.6 * share(k, 0),
            spin_x: -8.0 * share(k, 1),
            spin_y: share(k, 2),
            spin_z: -4.0 * share(k, 3),
            ..rolling_coin::Coin::default()
        };
        let state = moved!(m, 0.05 + 0.1 * share(k, 3));
        let disk = 0.4 * m.radius * m.radius / 4.0;
        Ledger::space().spatial(&state.coin(), 0.4, [0.0; 3], [disk, disk, 2.0 * disk]).assert("rolling_coin", m.energy(&state), &[]);
    }
}

#[test]
fn bricards_linkage() {
    let (along, across) = (1.0 / 600.0, 1.01 / 12.0);
    for k in 0..STATES {
        let m = bricard::Bricard::default();
        let state = moved!(m, 10.0 * share(k, 0));
        Ledger::plane()
            .spatial(&state.first(), 1.0, [0.5, 0.0, 0.0], [along, across, across])
            .spatial(&state.second(), 1.0, [0.0, -0.5, 0.0], [across, along, across])
            .spatial(&state.third(), 1.0, [0.0, 0.0, 0.5], [across, across, along])
            .spatial(&state.fourth(), 1.0, [-0.5, 0.0, 0.0], [along, across, across])
            .spatial(&state.fifth(), 1.0, [0.0, 0.5, 0.0], [across, along, across])
            .assert("bricard", m.energy(&state), &[]);
    }
}

/// An example with masses has its test above.
#[test]
fn no_example_is_left_out() {
    let own = include_str!("power.rs");
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut with_masses = 0;
    for entry in std::fs::read_dir(folder).expect("the examples") {
        let path = entry.expect("an entry").path();
        let Some(name) = path.file_name().and_then(|name| name.to_str()?.strip_suffix(".rs").map(str::to_owned)) else { continue };
        let text = std::fs::read_to_string(&path).expect("a program");
        if text.contains("mass = ") {
            with_masses += 1;
            assert!(own.contains(&format!("{name}::")), "{name} has no balance of power");
        }
    }
    assert_eq!(with_masses, 12);
}
