//! A motor starts a gear train: speed over time, and loads of its teeth and bearings.
//!
//! ```text
//!   motor 20 ──── 60 ┐ one shaft
//!                 18 ┘──── 54 drum           i = (60/20) (54/18) = 9
//! ```
//!
//! Referred to the motor, every inertia is divided by the square of its ratio. With a motor torque that decreases linearly with speed,
//! and a constant load,
//!
//! ```text
//! J = J₁ + J₂/3² + J₃/9²          T = T₀ (1 − φ̇/ω₀) − T_L/9          φ̈ = T/J
//!
//! φ̇ = ω₀ (1 − T_L/9T₀) (1 − e^(−t/τ)),  τ = J ω₀/T₀
//! ```
//!
//! The tooth force follows by cutting the train at the mesh: N = (T₀ (1 − φ̇/ω₀) − J₁ φ̈) / r_b. The meshes are `involute_mesh`, which has
//! the geometry of involutes: a taut line unwinds from one base circle onto the other. The force acts along that line, at 20° to the
//! tangent of the pitch circles, and the bearings carry it. (`gear_pair` relates angles only and does not load the bearings.)
//!
//! Source: R. G. Budynas and J. K. Nisbett, Shigley's Mechanical Engineering Design, gears (force analysis), and the law of gearing.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::nalgebra::Vector2;
use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::{figure, gauss, gear, meshing, place, play, steps};

mechanism! {
    /// A hoist that is switched on.
    #[picture]
    pub mechanism Hoist {
        /// Torque of the motor at rest.
        param stall: Torque = 6Nm;
        /// Speed at zero torque.
        param idle: AngularVelocity = 1500rpm;
        /// Load torque on the drum.
        param load: Torque = 20Nm;
        let module = 4mm;

        ground {
            point A = (0mm, 0mm);
            point B = (module * 40, 0mm);
            point C = (module * 40, module * 36);
        }
        body motor  { mass = 2kg;  inertia = 0.006kgm2; }
        body middle { mass = 6kg;  inertia = 0.03kgm2; }
        body drum   { mass = 20kg;  inertia = 0.9kgm2; }

        joint a = revolute(ground.A, motor.position);
        joint b = revolute(ground.B, middle.position);
        joint c = revolute(ground.C, drum.position);
        joint first = involute_mesh(motor.position, middle.position, 10 * module, 30 * module, 0deg);
        joint second = involute_mesh(middle.position, drum.position, 9 * module, 27 * module, 90deg, side: -1);
        force current = { on motor: stall * (1 - motor.angular_velocity / idle); }
        force rope = { on drum: -load; }
        freedom start = motor.angle from 0deg;
    }
}

type State = HoistState<f64>;

/// Module (m) and pressure angle (rad).
const MODULE: f64 = 0.004;
const ALPHA: f64 = 20.0 / 360.0 * TAU;
/// Inertias of motor, middle shaft and drum (kg m²), and turns of the motor per turn of each.
const INERTIAS: [f64; 3] = [0.006, 0.03, 0.9];
const RATIOS: [f64; 3] = [1.0, 3.0, 9.0];

/// The start in closed form: angle, speed and acceleration of the motor, and the forces (N) of the teeth on the driven gears.
struct Exact {
    motor: [f64; 3],
    teeth: [Vector2<f64>; 2],
}

fn main() -> Result<(), Box<dyn Error>> {
    let m = Hoist::default();
    let start = run(&m)?;
    for state in &start {
        assert_motion(&m, state);
        assert_forces(&m, state);
    }
    print(&m, &start);
    figure("geared_start", &view(&m, start), 4, &[])?;
    // The first turns of the motor.
    let begin: Vec<State> = m.sweep(steps(0.0, 0.25, 120), Integrator::new(1e-11)).collect::<Result<_, _>>()?;
    play("geared_start", &view(&m, begin))
}

fn view(m: &Hoist, states: Vec<State>) -> View<State> {
    let wheel = |teeth, tooth| gear(place(0.0, 0.0), teeth, MODULE, tooth);
    m.view(states)
        .title("Start of a hoist")
        .outline("drum", wheel(54, meshing(TAU / 4.0, 18.0, 54.0, 0.0)))
        .outline("middle", wheel(60, meshing(0.0, 20.0, 60.0, 0.0)))
        .outline("middle", wheel(18, 0.0))
        .outline("motor", wheel(20, 0.0))
        .plot("motor", "rpm", |state| state.motor().angular_velocity * 60.0 / TAU)
        .and("middle shaft", |state| -state.middle().angular_velocity * 60.0 / TAU)
        .and("drum", |state| state.drum().angular_velocity * 60.0 / TAU)
        .against("closed form", |state| exact(m, state.t).motor[1] * 60.0 / TAU)
        .plot("teeth 20 : 60", "N", |state| m.loads(state).first().force.norm())
        .and("teeth 18 : 54", |state| m.loads(state).second().force.norm())
        .and("bearing of the middle shaft", |state| m.loads(state).b().force.norm())
        .against("train cut at the mesh", |state| exact(m, state.t).teeth[0].norm())
        .against("train cut at the mesh", |state| exact(m, state.t).teeth[1].norm())
        .against("train cut at the mesh", |state| (exact(m, state.t).teeth[1] - exact(m, state.t).teeth[0]).norm())
}

/// The start, with the work of motor and load compared with the kinetic energy.
fn run(m: &Hoist) -> Result<Vec<State>, Box<dyn Error>> {
    let (mut state, mut integrator) = (m.initial_state()?, Integrator::new(1e-11));
    let (mut states, mut work) = (vec![state.clone()], 0.0);
    let times: Vec<f64> = steps(0.0, 2.5, 100).collect();
    for panel in times.windows(2) {
        for (time, weight) in gauss(panel[0], panel[1]) {
            m.advance(&mut state, time, &mut integrator)?;
            work += weight * m.energy(&state).power;
        }
        m.advance(&mut state, panel[1], &mut integrator)?;
        let off = m.energy(&state).kinetic - work;
        assert!(off.abs() < 1e-10 * work, "the energy is {off:e} J off the work at {} s", state.t);
        states.push(state.clone());
    }
    Ok(states)
}

fn exact(m: &Hoist, t: f64) -> Exact {
    let inertia: f64 = INERTIAS.iter().zip(RATIOS).map(|(inertia, ratio)| inertia / (ratio * ratio)).sum();
    let (fast, slow) = (m.idle * (1.0 - m.load / (9.0 * m.stall)), inertia * m.idle / m.stall);
    let fade = (-t / slow).exp();
    let motor = [fast * (t - slow * (1.0 - fade)), fast * (1.0 - fade), fast * fade / slow];
    let (sin, cos) = ALPHA.sin_cos();
    // Cut at a mesh: motor torque available for the teeth, and torque that drum and load require, divided by the base radii.
    let first = (m.stall * (1.0 - motor[1] / m.idle) - INERTIAS[0] * motor[2]) / (10.0 * MODULE * cos);
    let second = (m.load + INERTIAS[2] * motor[2] / RATIOS[2]) / (27.0 * MODULE * cos);
    Exact { motor, teeth: [Vector2::new(sin, cos) * first, Vector2::new(cos, sin) * second] }
}

/// All shafts follow the closed form, in their ratios.
fn assert_motion(m: &Hoist, state: &State) {
    let exact = exact(m, state.t).motor;
    for (body, ratio) in [state.motor(), state.middle(), state.drum()].into_iter().zip([1.0, -3.0, 9.0]) {
        let found = [body.angle, body.angular_velocity, body.angular_acceleration].map(|value| value * ratio);
        let off = found.iter().zip(exact).map(|(found, exact)| (found - exact).abs()).fold(0.0, f64::max);
        assert!(off < 1e-8, "off by {off:e} at {} s", state.t);
    }
}

/// The forces of teeth and bearings balance each part of the train.
fn assert_forces(m: &Hoist, state: &State) {
    let (loads, [first, second]) = (m.loads(state), exact(m, state.t).teeth);
    let pairs = [
        (loads.first().force, first),
        (loads.second().force, second),
        (loads.a().force, first),
        (loads.b().force, second - first),
        (loads.c().force, -second),
    ];
    let off = pairs.iter().map(|(found, exact)| (found - exact).norm()).fold(0.0, f64::max);
    assert!(off < 1e-8 && first.norm() > 0.0 && second.norm() > 0.0, "off by {off:e} N at {} s", state.t);
}

fn print(m: &Hoist, start: &[State]) {
    println!("time s   motor rpm   exactly   drum rpm   teeth N   teeth N   bearings N");
    for state in start.iter().step_by(10) {
        let (loads, rpm) = (m.loads(state), |speed: f64| speed * 60.0 / TAU);
        let [first, second] = [loads.first(), loads.second()].map(|mesh| mesh.force.norm());
        let [a, b, c] = [loads.a(), loads.b(), loads.c()].map(|bearing| bearing.force.norm());
        let (motor, drum) = (rpm(state.motor().angular_velocity), rpm(state.drum().angular_velocity));
        let closed = rpm(exact(m, state.t).motor[1]);
        println!("{:6.2}   {motor:9.2}   {closed:7.2}   {drum:8.3}   {first:7.2}   {second:7.2}   {a:6.2} {b:6.2} {c:6.2}", state.t);
    }
}
