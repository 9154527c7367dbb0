//! A four-stroke engine: crank torque, pin forces and flywheel for a given gas pressure.
//!
//! ```text
//!       A            rod
//!      (o)───────────────────┐        ══════════════ cylinder
//! crank /                 [  B  ]◀── p A              p: a table over two turns
//!     (o)                             ══════════════
//!  ════O════ flywheel J               OA = r, AB = l
//! ```
//!
//! At constant speed the torque of the crank varies with the angle; its mean is the work of the gas over 4π. If the engine runs freely
//! against this mean as its load, its speed varies according to the energy balance,
//!
//! ```text
//! ½ J(φ) φ̇² + V(φ) = ½ J(0) φ̇(0)² + ∫ (torque of the gas − load) dφ      J: flywheel, rod and piston; V: the rod's weight
//! ```
//!
//! Its coefficient of fluctuation is (ω_max − ω_min) / ω = ΔE / (J ω²), if rod and piston are light compared with the flywheel. ΔE is the
//! largest excess work of the torque at constant speed over its mean, from the lowest point of its integral to the highest.
//!
//! Source: R. L. Norton, Design of Machinery, chapters 11 (flywheel) and 13 (gas force, pin forces); the table is that of an ideal cycle.

use std::error::Error;
use std::f64::consts::{PI, TAU};

use reuleaux::nalgebra::Vector2;
use reuleaux::picture::{Drawable, GROUND};
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::{gauss, largest_difference, place, rectangle, round, show, steps};

/// The engine with its cause of motion: a drive, or a freedom and a load.
macro_rules! engine {
    ($(#[$doc:meta])* $name:ident, $($motion:tt)*) => {
        mechanism! {
            $(#[$doc])*
            pub mechanism $name {
                param speed: AngularVelocity = 1500rpm;
                param flywheel: Inertia = 0.4kgm2;
                param load: Torque = 0Nm;

                gravity = (0, -9.81m_s2);
                let area = pi * (80mm)^2 / 4;
                let pressure = table(crank.angle, [
                    (0deg, 0.05bar), (30deg, -0.1bar), (90deg, -0.1bar), (150deg, -0.08bar), (180deg, -0.07bar), (210deg, -0.01bar),
                    (240deg, 0.19bar), (270deg, 0.74bar), (300deg, 2.33bar), (320deg, 5.2bar), (330deg, 7.8bar), (340deg, 11.5bar),
                    (350deg, 16.2bar), (360deg, 26.9bar), (370deg, 41.7bar), (380deg, 45.7bar), (390deg, 37.2bar), (400deg, 26.7bar),
                    (410deg, 19bar), (420deg, 13.9bar), (430deg, 10.6bar), (450deg, 6.8bar), (480deg, 4.3bar), (500deg, 3.5bar),
                    (520deg, 2.2bar), (540deg, 1.1bar), (560deg, 0.5bar), (590deg, 0.15bar), (630deg, 0.1bar), (690deg, 0.1bar),
                    (720deg, 0.05bar)
                ], periodic);

                ground { axis bore = (1, 0); }
                body crank  { point A = (45mm, 0mm);  mass = 8kg;  inertia = flywheel; }
                body rod    { point B = (150mm, 0mm);  mass = 0.6kg;  center = (50mm, 0mm);  inertia = 0.002kgm2; }
                body piston { mass = 0.5kg; }
                joint main = revolute(ground.position, crank.position);
                joint big_end = revolute(crank.A, rod.position);
                joint small_end = revolute(rod.B, piston.position);
                joint guide = translational(ground.bore, ground.position, piston.position);
                force gas = { at piston.position: (-pressure * area, 0N); }
                force brake = { on crank: -load; }
                $($motion)*

                output pressure = pressure;
            }
        }
    };
}

engine! {
    /// An engine at constant speed.
    #[picture]
    Driven, drive motor = drive_angle(crank, speed * t);
}
engine! {
    /// An engine driven by its gas.
    Free, freedom turn = crank.angle from 0deg at speed;
}

/// Length of crank and rod (m).
const R: f64 = 0.045;
const L: f64 = 0.15;
/// Mass of rod and piston (kg), inertia of the rod (kg m²), and the fraction of its length from A to its centre of mass.
const ROD: f64 = 0.6;
const PISTON: f64 = 0.5;
const INERTIA: f64 = 0.002;
const SHARE: f64 = 1.0 / 3.0;
const CRANK: f64 = 8.0;
const GRAVITY: f64 = 9.81;

/// Step of the crank in degrees; all angles in the table are multiples.
const STEP: u32 = 2;

/// Motion and forces in closed form at an angle, a speed and an acceleration of the crank.
struct Exact {
    /// J(φ) (kg m²).
    inertia: f64,
    /// Work of the gas per angle, −p A x′ (N m).
    gas: f64,
    /// Torque on the crank in addition to that of the gas (N m).
    torque: f64,
    /// Forces on the piston, on the rod at A, and on the crank at O (N).
    pins: [Vector2<f64>; 3],
}

/// Computed by virtual work and Newton's laws; `pressure` in Pa.
fn exact(flywheel: f64, pressure: f64, angle: f64, [speed, rise]: [f64; 2]) -> Exact {
    let (sin, cos) = angle.sin_cos();
    let (across, along) = (-R * sin / L, (1.0 - (R * sin / L).powi(2)).sqrt());
    // Derivatives by the crank angle of the rod's angle, of A, of B and of the rod's centre.
    let swing = -R * cos / (L * along);
    let swing2 = (R * sin / L + across * swing * swing) / along;
    let a = [place(-R * sin, R * cos), place(-R * cos, -R * sin)];
    let b = [a[0].x - L * across * swing, a[1].x - L * (along * swing * swing + across * swing2)];
    let g = [0, 1].map(|k| a[k] * (1.0 - SHARE) + place(b[k], 0.0) * SHARE);
    let inertia = flywheel + PISTON * b[0] * b[0] + ROD * g[0].norm_squared() + INERTIA * swing * swing;
    let growth = PISTON * b[0] * b[1] + ROD * g[0].dot(&g[1]) + INERTIA * swing * swing2;
    let gas = -pressure * PI * 0.0016 * b[0];
    let torque = inertia * rise + growth * speed * speed + ROD * GRAVITY * g[0].y - gas;

    let rate = |k: [f64; 2]| k[0] * rise + k[1] * speed * speed;
    let centre = place(rate([g[0].x, g[1].x]), rate([g[0].y, g[1].y]) + GRAVITY) * ROD;
    let thrust = PISTON * rate(b) + pressure * PI * 0.0016;
    let moment = INERTIA * rate([swing, swing2]) + place(along, across).perp(&centre) * L * SHARE;
    let small_end = place(thrust, (across * thrust - moment / L) / along);
    let big_end = centre + small_end;
    Exact { inertia, gas, torque, pins: [small_end, big_end, big_end + place(0.0, CRANK * GRAVITY)] }
}

/// The speed of a free engine (rad/s), found and in closed form.
struct Look {
    speed: f64,
    closed: f64,
}

/// A cycle at constant speed, with the cumulative work of gas and crank (J) at each step.
struct Cycle {
    gas: Vec<f64>,
    crank: Vec<f64>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let cycle = driven()?;
    let (gas, crank) = (cycle.gas[cycle.gas.len() - 1], cycle.crank[cycle.crank.len() - 1]);
    let load = gas / (2.0 * TAU);
    assert!((crank / gas - 1.0).abs() < 1e-13, "the crank gives {crank} J of {gas} J");
    println!("work of the gas {gas:.2} J a cycle, mean torque {load:.3} N m, ΔE {:.2} J\n", excess(&cycle, load));
    println!("J kg m²   slowest rpm   fastest rpm   fluctuation   ΔE/(J ω²)");
    let mut runs = Vec::new();
    for flywheel in [0.1, 0.2, 0.4, 0.8, 1.6] {
        let run = free(flywheel, load, &cycle)?;
        print!("{flywheel:7.1}");
        runs.push((flywheel, fluctuation(&run, excess(&cycle, load) / flywheel), run));
    }
    // The formula neglects rod and piston; its error decreases as 1/J.
    for pair in runs.windows(2) {
        let [light, heavy] = [&pair[0].1, &pair[1].1].map(|[found, formula]| (found / formula - 1.0).abs());
        assert!(heavy < 0.6 * light && heavy < 0.1, "{light} and {heavy} from the formula");
    }
    let m = Driven::default();
    let states = m.sweep(steps(0.0, 2.0 * TAU / m.speed, 720 / STEP)).collect::<Result<Vec<DrivenState<f64>>, _>>()?;
    let run = |number: usize, of: fn(&Look) -> f64| {
        let looks = &runs[number].2;
        move |state: &DrivenState<f64>| of(&looks[(state.crank().angle.to_degrees() / f64::from(STEP)).round() as usize]) * 60.0 / TAU
    };
    let view = m
        .view(states)
        .title("Engine and flywheel")
        .over("crank", "°", |state| state.crank().angle.to_degrees())
        .outline("crank", round(0.062))
        .outline("piston", rectangle(place(0.0, 0.0), 0.0, 0.05, 0.08))
        .outline(GROUND, rectangle(place(0.167, 0.042), 0.0, 0.136, 0.003))
        .outline(GROUND, rectangle(place(0.167, -0.042), 0.0, 0.136, 0.003))
        .outline(GROUND, rectangle(place(0.236, 0.0), 0.0, 0.003, 0.084))
        .plot("gas", "bar", |state| m.pressure(state).value / 1e5)
        .plot("torque", "N m", |state| -m.loads(state).motor().effort)
        .and("its mean, the load", |_| load)
        .against("virtual work", |state| -exact(m.flywheel, m.pressure(state).value, state.crank().angle, [m.speed, 0.0]).torque)
        .plot("small end", "kN", |state| m.loads(state).small_end().force.norm() / 1e3)
        .and("big end", |state| m.loads(state).big_end().force.norm() / 1e3)
        .plot("speed, J = 0.2 kg m²", "rpm", run(1, |look| look.speed))
        .and("0.4 kg m²", run(2, |look| look.speed))
        .and("0.8 kg m²", run(3, |look| look.speed))
        .against("energy", run(1, |look| look.closed))
        .against("energy", run(2, |look| look.closed))
        .against("energy", run(3, |look| look.closed));
    show("engine", &view, 200, &[])
}

/// A cycle at constant speed, sampled at Gauss points.
fn driven() -> Result<Cycle, Box<dyn Error>> {
    let m = Driven::default();
    let panels = (0..720 / STEP).map(|k| [k, k + 1].map(|k| f64::from(k * STEP).to_radians()));
    let places: Vec<(f64, f64)> = panels.flat_map(|[from, to]| gauss(from, to)).collect();
    let mut cycle = Cycle { gas: vec![0.0], crank: vec![0.0] };
    let (mut gas, mut crank) = (0.0, 0.0);
    for (k, state) in m.sweep(places.iter().map(|(angle, _)| angle / m.speed)).enumerate() {
        let state = state?;
        let (loads, pressure) = (m.loads(&state), m.pressure(&state).value);
        let pins = [loads.small_end(), loads.big_end(), loads.main()].map(|load| load.force);
        let exact = exact(m.flywheel, pressure, places[k].0, [m.speed, 0.0]);
        assert_forces(&exact, loads.motor().effort, &pins);
        gas += places[k].1 * exact.gas;
        crank -= places[k].1 * loads.motor().effort;
        if k % 5 == 4 {
            cycle.gas.push(gas);
            cycle.crank.push(crank);
        }
    }
    Ok(cycle)
}

/// Torque and pin forces are those of virtual work and Newton's laws.
fn assert_forces(exact: &Exact, torque: f64, pins: &[Vector2<f64>; 3]) {
    let off = largest_difference(pins.iter().zip(&exact.pins).map(|(pin, exact)| ((pin - exact).norm(), 0.0)));
    assert!(off < 1e-10 && (torque - exact.torque).abs() < 1e-10, "off by {off:e} N and {:e} N m", torque - exact.torque);
}

/// ΔE: difference of the extrema of the crank's cumulative work minus its mean (J).
fn excess(cycle: &Cycle, load: f64) -> f64 {
    let beyond = cycle.crank.iter().enumerate().map(|(k, work)| work - load * f64::from(k as u32 * STEP).to_radians());
    let (low, high) = beyond.fold((0.0_f64, 0.0_f64), |(low, high), work| (low.min(work), high.max(work)));
    high - low
}

/// A cycle against the load, sampled at every step of the crank.
fn free(flywheel: f64, load: f64, cycle: &Cycle) -> Result<Vec<Look>, Box<dyn Error>> {
    let m = Free { flywheel, load, ..Default::default() };
    let (mut state, mut integrator) = (m.initial_state()?, Integrator::new(1e-11));
    let start = 0.5 * exact(flywheel, 0.0, 0.0, [0.0; 2]).inertia * m.speed * m.speed;
    let mut looks = Vec::new();
    for (k, gas) in cycle.gas.iter().enumerate() {
        let angle = f64::from(k as u32 * STEP).to_radians();
        let until = state.t + 1.0;
        assert!(k == 0 || m.advance_until(&mut state, until, &mut integrator, |state| state.crank().angle - angle)?);
        let (crank, loads, pressure) = (state.crank(), m.loads(&state), m.pressure(&state).value);
        let pins = [loads.small_end(), loads.big_end(), loads.main()].map(|load| load.force);
        let exact = exact(flywheel, pressure, crank.angle, [crank.angular_velocity, crank.angular_acceleration]);
        assert_forces(&exact, -load, &pins);
        let kinetic = start + gas - load * angle - ROD * GRAVITY * (1.0 - SHARE) * R * angle.sin();
        let closed = (2.0 * kinetic / exact.inertia).sqrt();
        let off = crank.angular_velocity / closed - 1.0;
        assert!(off.abs() < 1e-10, "the speed is off by {off:e} at {angle} rad");
        looks.push(Look { speed: crank.angular_velocity, closed });
    }
    Ok(looks)
}

/// Coefficient of fluctuation of a run, and the textbook value for ΔE/J.
fn fluctuation(run: &[Look], share: f64) -> [f64; 2] {
    let (low, high) = run.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), look| (low.min(look.speed), high.max(look.speed)));
    let mean = (low + high) / 2.0;
    let both = [(high - low) / mean, share / (mean * mean)];
    println!("   {:11.1}   {:11.1}   {:11.5}   {:9.5}", low * 60.0 / TAU, high * 60.0 / TAU, both[0], both[1]);
    both
}
