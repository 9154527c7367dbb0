//! A differential divides torque equally, however unequal the wheel loads are: one wheel on asphalt, the other on ice.
//!
//! ```text
//!            ┌──[10]──┐
//!   left ══[16]      [16]══ right        T on the cage, resistance b ω on each wheel
//!   b_L      └────────┘ cage  b_R
//! ```
//!
//! With wheel speeds ω, the cage has the speed (ω_L + ω_R)/2 and the planet on its pin i (ω_R − ω_L)/2, i = 16/10. By Lagrange's
//! equations
//!
//! ```text
//! (J_W + J_C/2) (ω̇_L + ω̇_R)    = T − b_L ω_L − b_R ω_R            J_W: a wheel; J_C: cage, and planet about the axle
//! (J_W + i² J_P/2) (ω̇_R − ω̇_L) = b_L ω_L − b_R ω_R                J_P: planet about its pin
//! ```
//!
//! The equations are linear, so that the speeds are a matrix exponential. The torques on the side gears differ by the torque that
//! accelerates the planet, i² J_P/2 (ω̇_R − ω̇_L), and tend to T/2 each: then speeds are proportional to 1/b, and the wheel on ice runs
//! away.
//!
//! Source of the terms: J. Y. Wong, Theory of Ground Vehicles, chapter 3; the equations are Lagrange's.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::nalgebra::{Matrix2, Vector2, Vector3};
use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux::{Integrator, SpatialBody, mechanism};
use reuleaux_examples::{differential, figure, gauss, play, ring, steps};

mechanism! {
    /// A differential between two wheels with resistance proportional to speed.
    #[picture]
    pub mechanism Loaded in space {
        param torque: Torque = 120Nm;
        param left_drag: Torque / AngularVelocity = 1.2Nm / 1rad_s;
        param right_drag: Torque / AngularVelocity = 0.4Nm / 1rad_s;

        ground { axis y = (0, 1, 0) from (1, 0, 0); }
        body cage   { axis y = (0, 1, 0) from (1, 0, 0);  axis pin = (1, 0, 0);  mass = 6kg;  inertia = (0.02kgm2, 0.03kgm2, 0.02kgm2); }
        body left   { axis y = (0, 1, 0) from (1, 0, 0);  mass = 20kg;  inertia = (0.5kgm2, 0.9kgm2, 0.5kgm2); }
        body right  { axis y = (0, 1, 0) from (1, 0, 0);  mass = 20kg;  inertia = (0.5kgm2, 0.9kgm2, 0.5kgm2); }
        body planet { axis pin = (1, 0, 0);  mass = 2kg;  center = (32mm, 0mm, 0mm);  inertia = (0.02kgm2, 0.012kgm2, 0.012kgm2); }

        joint bearing = revolute(ground.position, ground.y, cage.position, cage.y);
        joint left_shaft = revolute(cage.position, cage.y, left.position, left.y);
        joint right_shaft = revolute(cage.position, cage.y, right.position, right.y);
        joint pin = revolute(cage.position, cage.pin, planet.position, planet.pin);
        joint left_mesh = gear_pair(pin.angle, left_shaft.angle, 10, 16);
        joint right_mesh = gear_pair(pin.angle, right_shaft.angle, 10, -16);
        force engine = motor(ground.y, cage, torque);
        force left_road = motor(ground.y, left, -left_drag * rate(bearing.angle + left_shaft.angle));
        force right_road = motor(ground.y, right, -right_drag * rate(bearing.angle + right_shaft.angle));
        freedom going = bearing.angle;
        freedom parting = right_shaft.angle;
    }
}

type State = LoadedState<f64>;

/// Inertias (kg m²): wheel about its axle, cage with the planet about the axle, planet about its pin.
const WHEEL: f64 = 0.9;
const CAGE: f64 = 0.03 + 0.012 + 2.0 * 0.032 * 0.032;
const PLANET: f64 = 0.02;
/// Radii of the pitch circles of planet and side gears (m).
const RADII: [f64; 2] = [0.02, 0.032];
/// Turns of the planet on its pin per turn of a wheel relative to the cage.
const RATIO: f64 = 1.6;

fn main() -> Result<(), Box<dyn Error>> {
    let m = Loaded::default();
    let start = run(&m)?;
    for state in &start {
        assert_motion(&m, state);
        assert_shares(&m, state);
    }
    let rest = speeds(&m, 1e3);
    assert!((rest - Vector2::new(m.torque / (2.0 * m.left_drag), m.torque / (2.0 * m.right_drag))).norm() < 1e-10);
    print(&m, &start);
    figure("loaded_differential", &view(&m, start), 20, &[])?;
    // The first turn of the cage.
    let begin: Vec<State> = m.sweep(steps(0.0, 0.5, 120), Integrator::new(1e-11)).collect::<Result<_, _>>()?;
    play("loaded_differential", &view(&m, begin))
}

fn view(m: &Loaded, states: Vec<State>) -> View<State> {
    differential(m.view(states), RADII)
        .title("Differential under load")
        .outline("left", ring(&(Vector3::y() * 0.1), &Vector3::y(), 0.055))
        .outline("left", ring(&(Vector3::y() * 0.1), &Vector3::y(), 0.045))
        .outline("right", ring(&(-Vector3::y() * 0.1), &Vector3::y(), 0.055))
        .outline("right", ring(&(-Vector3::y() * 0.1), &Vector3::y(), 0.045))
        .plot("left, on asphalt", "rpm", |state| found(state)[0][0] * 60.0 / TAU)
        .and("right, on ice", |state| found(state)[0][1] * 60.0 / TAU)
        .and("cage", |state| found(state)[0][2] * 60.0 / TAU)
        .against("matrix exponential", |state| speeds(m, state.t).x * 60.0 / TAU)
        .against("matrix exponential", |state| speeds(m, state.t).y * 60.0 / TAU)
        .plot("share on the left", "N m", |state| shares(m, state)[0])
        .and("on the right", |state| shares(m, state)[1])
        .and("half of the engine's torque", |_| m.torque / 2.0)
        .against("wheel cut free", |state| needed(m, state.t)[0])
        .against("wheel cut free", |state| needed(m, state.t)[1])
}

/// Torques (N m) that accelerate the wheels, cut free, against their drags.
fn needed(m: &Loaded, t: f64) -> [f64; 2] {
    let (speeds, rise) = (speeds(m, t), accelerations(m, speeds(m, t)) * WHEEL);
    [rise.x + m.left_drag * speeds.x, rise.y + m.right_drag * speeds.y]
}

/// The motion from rest, with the work of engine and road compared with the kinetic energy.
fn run(m: &Loaded) -> Result<Vec<State>, Box<dyn Error>> {
    let (mut state, mut integrator) = (m.initial_state()?, Integrator::new(1e-11));
    let (mut states, mut work) = (vec![state.clone()], 0.0);
    let times: Vec<f64> = steps(0.0, 10.0, 100).collect();
    for panel in times.windows(2) {
        for (time, weight) in gauss(panel[0], panel[1]) {
            m.advance(&mut state, time, &mut integrator)?;
            work += weight * m.energy(&state).power;
        }
        m.advance(&mut state, panel[1], &mut integrator)?;
        let off = m.energy(&state).kinetic / work - 1.0;
        assert!(off.abs() < 1e-9, "the energy is {off:e} of the work off at {} s", state.t);
        states.push(state.clone());
    }
    Ok(states)
}

/// Mass matrix and resistances of ω_L and ω_R.
fn matrices(m: &Loaded) -> [Matrix2<f64>; 2] {
    let (together, apart) = (CAGE / 4.0, RATIO * RATIO * PLANET / 4.0);
    let mass = Matrix2::new(WHEEL + together + apart, together - apart, together - apart, WHEEL + together + apart);
    [mass, Matrix2::from_diagonal(&Vector2::new(m.left_drag, m.right_drag))]
}

/// Accelerations of the wheels at given speeds.
fn accelerations(m: &Loaded, speeds: Vector2<f64>) -> Vector2<f64> {
    let [mass, drag] = matrices(m);
    mass.try_inverse().unwrap_or_default() * (Vector2::repeat(m.torque / 2.0) - drag * speeds)
}

/// Speeds of the wheels: ω = (1 − e^(−M⁻¹ B t)) B⁻¹ T/2, with the exponential from the two rates of decay.
fn speeds(m: &Loaded, t: f64) -> Vector2<f64> {
    let [mass, drag] = matrices(m);
    let decay = mass.try_inverse().unwrap_or_default() * drag;
    let (half, spread) = (decay.trace() / 2.0, (decay.trace().powi(2) / 4.0 - decay.determinant()).sqrt());
    let [fast, slow] = [half + spread, half - spread].map(|rate| (-rate * t).exp());
    // Sylvester's formula: e^A from its eigenvalues.
    let fade = (decay - Matrix2::identity() * (half + spread)) * (slow / (-2.0 * spread))
        + (decay - Matrix2::identity() * (half - spread)) * (fast / (2.0 * spread));
    let rest = Vector2::new(m.torque / (2.0 * m.left_drag), m.torque / (2.0 * m.right_drag));
    rest - fade * rest
}

/// Speeds and accelerations about y of left wheel, right wheel and cage, and of the planet on its pin.
fn found(state: &State) -> [[f64; 4]; 2] {
    let spin = |of: fn(&SpatialBody<f64>) -> Vector3<f64>| {
        let [left, right, cage] = [state.left(), state.right(), state.cage()].map(|body| of(&body).y);
        [left, right, cage]
    };
    let pin = state.cage().vector(Vector3::x());
    let against = state.planet().angular_velocity - state.cage().angular_velocity;
    let rise = state.planet().angular_acceleration - state.cage().angular_acceleration;
    let ([l, r, c], [dl, dr, dc]) = (spin(|body| body.angular_velocity), spin(|body| body.angular_acceleration));
    [[l, r, c, against.dot(&pin.value)], [dl, dr, dc, rise.dot(&pin.value) + against.dot(&pin.rate)]]
}

/// The motion satisfies Lagrange's equations.
fn assert_motion(m: &Loaded, state: &State) {
    let closed = speeds(m, state.t);
    for (found, wheels) in found(state).into_iter().zip([closed, accelerations(m, closed)]) {
        let [left, right] = [wheels.x, wheels.y];
        let exact = [left, right, (left + right) / 2.0, RATIO * (right - left) / 2.0];
        let off = found.iter().zip(exact).map(|(found, exact)| (found - exact).abs()).fold(0.0, f64::max);
        assert!(off < 1e-8, "off by {off:e} at {} s", state.t);
    }
}

/// Torques (N m) of the meshes on the side gears: −λ of the last two equations times the coefficients of the gears' angles in them.
fn shares(m: &Loaded, state: &State) -> [f64; 2] {
    let multipliers = m.loads(state).multipliers;
    let last = multipliers.len() - 2;
    [-16.0 * multipliers[last], 16.0 * multipliers[last + 1]]
}

/// Each wheel receives the torque of its inertia and resistance; the two differ by the torque that accelerates the planet.
fn assert_shares(m: &Loaded, state: &State) {
    let [left, right] = shares(m, state);
    let closed = speeds(m, state.t);
    let (needed, rise) =
        (accelerations(m, closed) * WHEEL + Vector2::new(m.left_drag * closed.x, m.right_drag * closed.y), accelerations(m, closed));
    let planet = RATIO * RATIO * PLANET / 2.0 * (rise.y - rise.x);
    let off = [left - needed.x, right - needed.y, left - right - planet].into_iter().map(f64::abs).fold(0.0, f64::max);
    assert!(off < 1e-7, "off by {off:e} N m at {} s", state.t);
}

fn print(m: &Loaded, start: &[State]) {
    println!("time s   left rpm   right rpm   cage rpm   left N m   right N m");
    for state in start.iter().step_by(10) {
        let [speeds, _] = found(state);
        let ([left, right], rpm) = (shares(m, state), speeds.map(|speed| speed * 60.0 / TAU));
        println!("{:6.1}   {:8.2}   {:9.2}   {:8.2}   {left:8.3}   {right:9.3}", state.t, rpm[0], rpm[1], rpm[2]);
    }
}
