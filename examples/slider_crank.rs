//! The offset slider-crank: an engine whose cylinder axis is offset from the crank axis.
//!
//! ```text
//!       A            rod
//!      (o)───────────────────┐        ══════════════ cylinder
//! crank /                 [  B  ]─▶ x                 e above O
//!     (o)                             ══════════════
//!  ════O════                          OA = r, AB = l
//! ```
//!
//! The piston is checked against x = r cos φ + √(l² − s²), s = e − r sin φ, and its first and second derivative; the
//! stroke against √((l + r)² − e²) − √((l − r)² − e²).
//!
//! Source of the lengths: P. E. Nikravesh, Planar Multibody Dynamics, example 5.1, with an offset.

use std::error::Error;

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_examples::{largest_difference, show, steps};

mechanism! {
    /// An engine with an offset cylinder.
    #[picture]
    pub mechanism Engine {
        param speed: AngularVelocity = 600rpm;
        param crank_length: Length = 120mm;
        param rod_length: Length = 260mm;
        param offset: Length = 40mm;

        ground {
            point O = (0mm, 0mm);
            point G = (0mm, offset);
            axis cylinder = (1, 0);
        }
        body crank  { point O = (0mm, 0mm);  point A = (crank_length, 0mm); }
        body rod    { point A = (0mm, 0mm);  point B = (rod_length, 0mm);  start angle = 0deg; }
        body piston { point B = (0mm, 0mm); }

        joint main = revolute(ground.O, crank.O);
        joint big_end = revolute(crank.A, rod.A);
        joint small_end = revolute(rod.B, piston.B);
        joint bore = translational(ground.cylinder, ground.G, piston.B);
        drive motor = drive_angle(crank, speed * t);

        output O = ground.O;
        output A = crank.A;
        output B = piston.B;
        output travel = piston.x;
    }
}

type State = EngineState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Engine::default();
    let turn: Vec<State> = mechanism.sweep(steps(0.0, 0.1, 180)).collect::<Result<_, _>>()?;

    assert_piston(&mechanism, &turn);
    assert_stroke(&mechanism)?;
    print(&mechanism, &turn);
    let view = mechanism
        .view(turn)
        .title("Offset slider-crank")
        .over("crank", "°", |state| state.crank().angle.to_degrees())
        .trace("path of A", |state| mechanism.A(state).value)
        .plot("travel", "mm", |state| mechanism.travel(state).value * 1e3)
        .against("closed form", |state| piston(&mechanism, state.crank().angle)[0] * 1e3)
        .plot("speed", "m/s", |state| mechanism.travel(state).rate)
        .against("closed form", |state| piston(&mechanism, state.crank().angle)[1])
        .plot("acceleration", "m/s²", |state| mechanism.travel(state).acceleration)
        .against("closed form", |state| piston(&mechanism, state.crank().angle)[2]);
    show("slider_crank", &view, 25, &[55, 85, 115, 145])
}

/// Travel (m), speed (m/s) and acceleration (m/s²) of the piston at the crank's angle φ (rad).
fn piston(m: &Engine, angle: f64) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    let (r, l) = (m.crank_length, m.rod_length);
    let s = m.offset - r * sin;
    let root = (l * l - s * s).sqrt();
    let slope = -r * sin + s * r * cos / root;
    let curvature = -r * cos - (r * r * cos * cos + s * r * sin) / root - (s * r * cos).powi(2) / root.powi(3);
    [r * cos + root, slope * m.speed, curvature * m.speed * m.speed]
}

fn assert_piston(m: &Engine, turn: &[State]) {
    for (order, unit) in [m.rod_length, m.crank_length * m.speed, m.crank_length * m.speed.powi(2)].into_iter().enumerate() {
        let solved = |state| [m.travel(state).value, m.travel(state).rate, m.travel(state).acceleration][order];
        let error = largest_difference(turn.iter().map(|state| (solved(state) / unit, piston(m, state.crank().angle)[order] / unit)));
        assert!(error < 1e-13, "derivative {order} of the travel is {error:e} off");
    }
}

/// At the dead centres crank and rod are in line, stretched or folded: there the piston is at rest, one stroke apart.
fn assert_stroke(m: &Engine) -> Result<(), Box<dyn Error>> {
    let (r, l, e) = (m.crank_length, m.rod_length, m.offset);
    let (outer, inner) = ((e / (l + r)).asin(), std::f64::consts::PI + (e / (l - r)).asin());
    let [far, near] = [m.solve(outer / m.speed)?, m.solve(inner / m.speed)?].map(|state| m.travel(&state));
    assert!(far.rate.abs().max(near.rate.abs()) < 1e-12);
    let stroke = ((l + r).powi(2) - e * e).sqrt() - ((l - r).powi(2) - e * e).sqrt();
    assert!((far.value - near.value - stroke).abs() < 1e-15);
    println!(
        "stroke {:.3} mm, in {:.2}° of the crank out and {:.2}° back\n",
        stroke * 1e3,
        360.0 - (inner - outer).to_degrees(),
        (inner - outer).to_degrees()
    );
    Ok(())
}

fn print(m: &Engine, turn: &[State]) {
    println!("crank °   travel mm   speed m/s   acceleration m/s²");
    for state in turn.iter().step_by(15) {
        let travel = m.travel(state);
        println!(
            "{:7.1}   {:9.3}   {:9.4}   {:17.2}",
            state.crank().angle.to_degrees(),
            travel.value * 1e3,
            travel.rate,
            travel.acceleration
        );
    }
}
