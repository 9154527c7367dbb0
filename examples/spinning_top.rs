//! A heavy top: steady precession by Euler's equations, and nutation between two bounds in closed form.
//!
//! ```text
//! steady precession     I₁ Ω² cos θ − I₃ ω₃ Ω + m g l = 0      θ from the vertical, ω₃ about its axis
//! released at θ₀        nutates down to cos θ₁ = λ − √(λ² − 2 λ cos θ₀ + 1),   λ = I₃² ω₃² / (4 I₁ m g l)
//! ```
//!
//! Source: H. Goldstein, Classical Mechanics, the heavy symmetrical top with one point fixed.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::nalgebra::Vector3;
use reuleaux::picture::Drawable;
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::{rod, round, show, steps};

mechanism! {
    /// A top spinning on its tip.
    #[picture]
    pub mechanism Top in space {
        param lean: Angle = 30deg;
        /// Spin about its own axis.
        param spin: AngularVelocity = 2400rpm;
        /// Precession about the vertical.
        param precession: AngularVelocity = 0rad_s;

        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        body top {
            mass = 0.3kg;  center = (0mm, 0mm, 60mm);  inertia = (0.0002kgm2, 0.0002kgm2, 0.00025kgm2);
            start orientation = turn((1, 0, 0), lean);
        }
        joint tip = spherical((0mm, 0mm, 0mm), top.position);
        // The axis points along (0, -sin, cos).
        freedom turning = top.angular_velocity
            from (0rad_s, -(spin - precession * cos(lean)) * sin(lean), (spin - precession * cos(lean)) * cos(lean) + precession);
    }
}

type State = TopState<f64>;

/// Time, inclination and position of the top's centre.
type Moment = (f64, f64, Vector3<f64>);

/// I₁ about the tip, I₃ and m g l.
const NUMBERS: [f64; 3] = [0.0002 + 0.3 * 0.06 * 0.06, 0.00025, 0.3 * 9.81 * 0.06];

fn main() -> Result<(), Box<dyn Error>> {
    let [slow, fast] = steady(&Top::default());
    println!("precession rad/s   after one turn: lean °   short of a turn by °");
    for precession in [slow, fast] {
        let top = Top { precession, ..Top::default() };
        let mut state = top.initial_state()?;
        top.advance(&mut state, TAU / precession, &mut Integrator::new(1e-11))?;
        let [lean, azimuth] = axis(&state);
        println!("{precession:16.6}   {:22.9}   {azimuth:10.1e}", lean.to_degrees());
        assert!((lean - top.lean).abs() < 1e-9 && azimuth.abs() < 1e-8, "{lean} {azimuth}");
    }
    let (top, curve) = (Top::default(), nodding(&Top::default())?);
    let lowest = curve.iter().map(|(_, lean, _)| *lean).fold(0.0, f64::max);
    println!(
        "let go at {:.3}°, it nods down to {:.6}°, by the closed form {:.6}°",
        top.lean.to_degrees(),
        lowest.to_degrees(),
        bound(&top).to_degrees()
    );
    assert!((turning_point(&top)? - bound(&top)).abs() < 1e-9);
    let states: Vec<State> = top.sweep(steps(0.0, 1.0, 500), Integrator::new(1e-9)).collect::<Result<_, _>>()?;
    let view = top
        .view(states)
        .title("Spinning top")
        .outline("top", round(0.035).iter().map(|at| at.push(0.06)))
        .outline("top", rod(Vector3::z() * 0.096, Vector3::x() * 0.0012))
        .outline("top", rod(Vector3::z() * 0.096, Vector3::y() * 0.0012))
        .trace("path of the centre", |state| state.top().rotation.column(2) * 0.06)
        .plot("from the vertical", "°", |state| axis(state)[0].to_degrees())
        .against("closed form of the bounds", |_| bound(&top).to_degrees())
        .against("closed form of the bounds", |_| top.lean.to_degrees());
    show("spinning_top", &view, 0, &[])
}

/// The two speeds (rad/s) of steady precession.
fn steady(m: &Top) -> [f64; 2] {
    let [i1, i3, weight] = NUMBERS;
    let (a, b) = (i1 * m.lean.cos(), i3 * m.spin);
    let root = (b * b - 4.0 * a * weight).sqrt();
    [-1.0, 1.0].map(|sign| (b + sign * root) / (2.0 * a))
}

/// Largest angle (rad) from the vertical after a release with spin only.
fn bound(m: &Top) -> f64 {
    let [i1, i3, weight] = NUMBERS;
    let (lambda, start) = ((i3 * m.spin).powi(2) / (4.0 * i1 * weight), m.lean.cos());
    (lambda - (lambda * lambda - 2.0 * lambda * start + 1.0).sqrt()).acos()
}

/// Axis of the top: angle (rad) from the vertical, and angle about the vertical since the start.
fn axis(state: &State) -> [f64; 2] {
    let axis = state.top().rotation.column(2).into_owned();
    [axis.xy().norm().atan2(axis.z), axis.x.atan2(-axis.y)]
}

/// First turning point of the axis.
fn turning_point(m: &Top) -> Result<f64, Box<dyn Error>> {
    let mut state = m.initial_state()?;
    let mut integrator = Integrator::new(1e-11);
    // The release itself does not count.
    m.advance(&mut state, 0.01, &mut integrator)?;
    let sinks = |state: &State| state.top().angular_velocity.cross(&state.top().rotation.column(2).into_owned()).z;
    assert!(m.advance_until(&mut state, 1.0, &mut integrator, sinks)?);
    Ok(axis(&state)[0])
}

/// Time, inclination and position of the top's centre over one second.
fn nodding(m: &Top) -> Result<Vec<Moment>, Box<dyn Error>> {
    let (mut state, mut integrator) = (m.initial_state()?, Integrator::new(1e-9));
    let mut curve = Vec::new();
    for time in steps(0.0, 1.0, 500) {
        m.advance(&mut state, time, &mut integrator)?;
        curve.push((time, axis(&state)[0], state.top().rotation.column(2) * 0.06));
    }
    Ok(curve)
}
