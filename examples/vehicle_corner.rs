//! The corner of a car: it bounces on its spring, and its wheel passes over a bump.
//!
//! ```text
//!           ┌────o U─────o C
//!   car ────┤    /        ║ ┌┐        the car moves vertically, at the height h;
//!           │   ▒ k, c    ╠═││        W stays on the road
//!           └──o L──/────o B││
//!                           └┘ W
//! ```
//!
//! Everything is a function of one coordinate, the height h of the car above the road. By virtual work the spring, of length l and
//! stiffness k, carries the weights G with the force F = Σ G (dy/dh) / (dl/dh), and near this equilibrium
//!
//! ```text
//! m_eff = Σ m (dr/dh)² + I (dφ/dh)²      k_eff = k (dl/dh)² − F d²l/dh² + Σ G d²y/dh²      c_eff = c (dl/dh)²
//!
//! ω = √(k_eff / m_eff)                   ζ = c_eff / (2 √(k_eff m_eff))
//! ```
//!
//! Source: W. F. Milliken and D. L. Milliken, Race Car Vehicle Dynamics, chapters 16 and 17 (installation ratio, ride rate).

use std::error::Error;
use std::f64::consts::PI;

use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::{Place, apex, carried, gauss, on, place, rectangle, show, steps};

mechanism! {
    /// A quarter of a car on a double wishbone, seen from the front.
    #[picture]
    pub mechanism Corner {
        /// Free length of the spring.
        param rest: Length = 480mm;
        param damping: Mass / Time = 3000Ns_m;
        /// Height from which the car is released.
        param lift: Length = 0mm;
        /// Height of the bump.
        param bump: Length = 0mm;

        gravity = (0, -9.81m_s2);
        body car {
            point L = (0mm, 180mm);  point U = (60mm, 420mm);  point S = (150mm, 620mm);
            mass = 320kg;
        }
        body lower { point B = (350mm, -10mm);  point S = (250mm, 0mm);  mass = 5kg;  center = (180mm, 0mm);  inertia = 0.06kgm2; }
        body upper { point C = (255mm, 20mm);  mass = 3kg;  center = (130mm, 10mm);  inertia = 0.02kgm2; }
        body upright {
            point C = (-35mm, 270mm);  point W = (110mm, -170mm);
            mass = 30kg;  center = (80mm, 130mm);  inertia = 0.9kgm2;
            start position = (350mm, 170mm);
        }

        joint straight = absolute_x(car.position, 0mm);
        joint level = absolute_angle(car, 0);
        joint l = revolute(car.L, lower.position);
        joint u = revolute(car.U, upper.position);
        joint b = revolute(lower.B, upright.position);
        joint c = revolute(upper.C, upright.C);
        drive road = drive_y(upright.W, bump * (cycloidal(t / 0.1s - 1) - cycloidal(t / 0.1s - 2)));
        freedom bounce = car.y from lift;
        energy spring = 0.5 * 40kN_m * (norm(car.S - lower.S) - rest)^2;
        force damper = damper(car.S, lower.S, damping: damping);

        output spring = norm(car.S - lower.S);
    }
}

type State = CornerState<f64>;

/// Outline of the car in its frame (m).
const BODY: [[f64; 2]; 8] = [[-0.12, 0.1], [0.03, 0.1], [0.03, 0.36], [0.09, 0.4], [0.09, 0.55], [0.2, 0.58], [0.2, 0.68], [-0.12, 0.68]];

const GRAVITY: f64 = 9.81;
const STIFFNESS: f64 = 40e3;
/// Mass (kg), centre (m) in its own frame and inertia (kg m²) of lower arm, upper arm and upright.
const PARTS: [(f64, Place, f64); 3] =
    [(5.0, Place::new(0.18, 0.0), 0.06), (3.0, Place::new(0.13, 0.01), 0.02), (30.0, Place::new(0.08, 0.13), 0.9)];

/// The corner in closed form at an angle of the lower arm (rad): height of the car, length of the spring, centres and angles of the
/// parts.
struct Pose {
    height: f64,
    spring: f64,
    parts: [(Place, f64); 3],
}

/// The equilibrium: spring force (N); and mass (kg), damping (N s/m) and stiffness (N/m) of small motions about it.
struct Linear {
    force: f64,
    mass: f64,
    damping: f64,
    stiffness: f64,
}

impl Linear {
    /// Rates of decay and of oscillation (rad/s).
    fn rates(&self) -> [f64; 2] {
        let decay = self.damping / (2.0 * self.mass);
        [decay, (self.stiffness / self.mass - decay * decay).sqrt()]
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let linear = linear(Corner::<f64>::default().damping);
    let still = Corner { rest: pose(0.0).spring + linear.force / STIFFNESS, ..Default::default() };
    let state = still.initial_state()?;
    assert!(state.car().acceleration.norm() < 1e-8, "it rests where virtual work says");
    assert!((still.loads(&state).road().effort - 358.0 * GRAVITY).abs() < 1e-8);
    println!("the car rests on {:.1} N of its spring; natural frequency {:.5} Hz\n", linear.force, natural(&linear) / (2.0 * PI));
    println!("lift mm   frequency Hz, of small motion   damping, of small motion");
    let mut errors = Vec::new();
    for lift in [5e-2, 5e-3, 5e-4, 5e-5] {
        errors.push(compare(&Corner { lift, ..still }, &linear)?);
    }
    assert!(errors.windows(2).all(|pair| pair[1] < 0.2 * pair[0]) && errors[3] < 2e-6, "{errors:?}");
    let on_bump = Corner { bump: 0.04, ..still };
    let (bumped, released) = (drive(&on_bump)?, drive(&Corner { lift: 5e-3, ..still })?);
    let [decay, rate] = linear.rates();
    let small = |t: f64| 5.0 * (-decay * t).exp() * ((rate * t).cos() + decay / rate * (rate * t).sin());
    let states = bumped.into_iter().zip(released).step_by(2);
    let view = View::new("Corner of a car", states, |(state, _)| state.t, |(state, _)| on_bump.scene(state))
        .outline("car", BODY.map(|[x, y]| place(x, y)))
        .outline("upright", rectangle(place(0.11, 0.13), 0.0, 0.18, 0.6))
        .spring("spring", ("car", place(0.15, 0.62)), ("lower", place(0.25, 0.0)))
        .plot("road", "mm", |(state, _)| on(&state.upright(), place(0.11, -0.17)).y * 1e3)
        .and("car", |(state, _)| state.car().position.y * 1e3)
        .plot("wheel load", "kN", |(state, _)| on_bump.loads(state).road().effort / 1e3)
        .plot("released car", "mm", |(_, state)| state.car().position.y * 1e3)
        .against("small motion, by virtual work", |(_, state)| small(state.t));
    show("vehicle_corner", &view, 0, &[])
}

/// Two triangles, in the frame of the car.
fn pose(angle: f64) -> Pose {
    let (l, u, s) = (place(0.0, 0.18), place(0.06, 0.42), place(0.15, 0.62));
    let (arm, joint, ball) = (place(0.35, -0.01), place(0.255, 0.02), place(-0.035, 0.27));
    let from = |origin: Place, local: Place| carried(local, origin, place(1.0, 0.0), origin + place(angle.cos(), angle.sin()));
    let b = from(l, arm);
    let c = apex(u, b, joint.norm(), ball.norm());
    let turn = |seen: Place, local: Place| seen.y.atan2(seen.x) - local.y.atan2(local.x);
    let parts = [
        (from(l, PARTS[0].1), angle),
        (carried(PARTS[1].1, u, joint, c), turn(c - u, joint)),
        (carried(PARTS[2].1, b, ball, c), turn(c - b, ball)),
    ];
    Pose { height: -carried(place(0.11, -0.17), b, ball, c).y, spring: (s - from(l, place(0.25, 0.0))).norm(), parts }
}

/// First and second derivative of a quantity by the car's height, with the lower arm level: differences over five poses.
fn slopes(of: &dyn Fn(&Pose) -> f64) -> [f64; 2] {
    let e = 1e-3;
    let by_angle = |of: &dyn Fn(&Pose) -> f64| {
        let [a, b, c, d, f] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| of(&pose(k * e)));
        [(8.0 * (d - b) - (f - a)) / (12.0 * e), (16.0 * (b + d) - 30.0 * c - a - f) / (12.0 * e * e)]
    };
    let ([f1, f2], [h1, h2]) = (by_angle(of), by_angle(&|pose| pose.height));
    [f1 / h1, (f2 * h1 - f1 * h2) / h1.powi(3)]
}

/// Virtual work about the equilibrium of the car.
fn linear(damping: f64) -> Linear {
    let spring = slopes(&|pose| pose.spring);
    let (mut mass, mut lifted) = (320.0, [320.0 * GRAVITY, 0.0]);
    for (k, (own, _, inertia)) in PARTS.into_iter().enumerate() {
        let part = |of: fn(&(Place, f64)) -> f64| slopes(&move |pose| of(&pose.parts[k]));
        let (x, y, turn) = (part(|part| part.0.x), part(|part| part.0.y), part(|part| part.1));
        mass += own * (x[0].powi(2) + (1.0 + y[0]).powi(2)) + inertia * turn[0].powi(2);
        lifted = [lifted[0] + own * GRAVITY * (1.0 + y[0]), lifted[1] + own * GRAVITY * y[1]];
    }
    let force = lifted[0] / spring[0];
    let stiffness = STIFFNESS * spring[0] * spring[0] - force * spring[1] + lifted[1];
    Linear { force, mass, damping: damping * spring[0] * spring[0], stiffness }
}

fn natural(linear: &Linear) -> f64 {
    (linear.stiffness / linear.mass).sqrt()
}

/// Releases the car and waits for its next maximum: period and decrement agree with those of the small motion; returns the largest error.
fn compare(m: &Corner, linear: &Linear) -> Result<f64, Box<dyn Error>> {
    let (mut state, mut integrator) = (m.initial_state()?, Integrator::new(1e-13));
    for _ in 0..2 {
        let until = state.t + 2.0;
        assert!(m.advance_until(&mut state, until, &mut integrator, |state| state.car().velocity.y)?);
    }
    let ([decay, rate], height) = (linear.rates(), state.car().position.y);
    let found = [(m.lift / height).ln() / state.t, 2.0 * PI / state.t];
    let ratio = |decay: f64, rate: f64| decay / decay.hypot(rate);
    let (damping, small) = (ratio(found[0], found[1]), ratio(decay, rate));
    println!("{:7.2}   {:12.6}   {:15.6}   {damping:7.5}   {small:15.5}", m.lift * 1e3, found[1] / (2.0 * PI), rate / (2.0 * PI));
    Ok((found[1] / rate - 1.0).abs().max((damping / small - 1.0).abs()))
}

/// Two seconds of motion, with the work of road and damper compared with kinetic and potential energy.
fn drive(m: &Corner) -> Result<Vec<State>, Box<dyn Error>> {
    let (mut state, mut integrator) = (m.initial_state()?, Integrator::new(1e-11));
    let total = |state: &State| m.energy(state).total();
    let (mut states, mut work, start) = (vec![state.clone()], 0.0, total(&state));
    let times: Vec<f64> = steps(0.0, 2.0, 500).collect();
    for panel in times.windows(2) {
        for (time, weight) in gauss(panel[0], panel[1]) {
            m.advance(&mut state, time, &mut integrator)?;
            work += weight * (m.loads(&state).road().power + m.energy(&state).power);
        }
        m.advance(&mut state, panel[1], &mut integrator)?;
        let off = total(&state) - start - work;
        assert!(off.abs() < 1e-9, "{off:e} J are missing at {} s", state.t);
        states.push(state.clone());
    }
    Ok(states)
}
