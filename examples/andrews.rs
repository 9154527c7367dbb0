//! Andrews' squeezing mechanism: seven bodies driven by a constant torque, compared with the published state.
//!
//! Its closed loops and its speed, up to 11,000 rpm after 30 ms, made it a benchmark for multibody programs. The declaration follows its
//! drawing: seven bodies, ten hinges, a spring and a motor. The seven angles are integrated; after each step the loops hold to rounding.
//!
//! Source: W. Schiehlen, Multibody Systems Handbook, 1990; E. Hairer and G. Wanner, Solving Ordinary Differential Equations II; F. Mazzia and
//! C. Magherini, Test Set for Initial Value Problem Solvers, which prints the state at 0.03 s.

use std::error::Error;

use reuleaux::picture::Drawable;
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::{place, show, steps};

mechanism! {
    /// Andrews' squeezing mechanism, with each body's frame at its centre of mass.
    #[picture]
    pub mechanism Andrews {
        param torque: Torque = 0.033Nm;
        ground {
            point O = (0mm, 0mm);  point A = (-69.34mm, -2.27mm);
            point B = (-36.35mm, 32.73mm);  point C = (14mm, 72mm);
        }
        body of  { point O = (-0.92mm, 0mm);  point F = (6.08mm, 0mm);  mass = 43.25g;  inertia = 2.194e-6kgm2;  start angle = -0.0617rad; }
        body ef  { point F = (11.5mm, 0mm);  point E = (-16.5mm, 0mm);  mass = 3.65g;  inertia = 4.41e-7kgm2;  start angle = -0.0617rad; }
        body bde { point B = (-10.43mm, 18.74mm);  point D = (9.57mm, 0.74mm);  point E = (-10.43mm, -16.26mm);  mass = 23.73g;  inertia = 5.255e-6kgm2;  start angle = 0.455rad; }
        body ge  { point G = (0mm, 5.79mm);  point E = (0mm, -14.21mm);  mass = 7.06g;  inertia = 5.667e-7kgm2;  start angle = 0.71rad; }
        body ag  { point A = (-23.08mm, -9.16mm);  point G = (16.92mm, -9.16mm);  mass = 70.5g;  inertia = 1.169e-5kgm2;  start angle = 0.487rad; }
        body he  { point H = (-5.79mm, 0mm);  point E = (14.21mm, 0mm);  mass = 7.06g;  inertia = 5.667e-7kgm2;  start angle = 1.008rad; }
        body ah  { point A = (4.49mm, 12.28mm);  point H = (4.49mm, -27.72mm);  mass = 54.98g;  inertia = 1.912e-5kgm2;  start angle = 1.23rad; }

        joint o = revolute(ground.O, of.O);
        joint f = revolute(of.F, ef.F);
        joint e = revolute(ef.E, bde.E);
        joint b = revolute(ground.B, bde.B);
        joint e_of_ge = revolute(ef.E, ge.E);
        joint g = revolute(ge.G, ag.G);
        joint a_of_ag = revolute(ground.A, ag.A);
        joint e_of_he = revolute(ef.E, he.E);
        joint h = revolute(he.H, ah.H);
        joint a_of_ah = revolute(ground.A, ah.A);
        force motor = { on of: torque; }
        force spring = spring(ground.C, bde.D, stiffness: 4530N_m, rest: 77.85mm);
        freedom crank = of.angle from -0.0617138900142764496358948458001rad;
    }
}

type State = AndrewsState<f64>;

/// β, γ, δ and ε at 0.03 s as printed, with about ten correct digits.
const PUBLISHED: [f64; 4] = [15.810_771_196_299_04, 0.040_822_240_130_731_01, 0.524_409_965_880_530_4, 1.048_080_741_042_263];

fn angles(state: &State) -> [f64; 4] {
    [state.of(), state.bde(), state.ag(), state.ah()].map(|body| body.angle)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Andrews::default();
    println!("tolerance   steps   evaluations   off the printed state   N at the crank's bearing");
    let mut errors = Vec::new();
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let (mut state, mut integrator) = (mechanism.initial_state()?, Integrator::new(tolerance));
        mechanism.advance(&mut state, 0.03, &mut integrator)?;
        let off = angles(&state).into_iter().zip(PUBLISHED).map(|(found, printed)| ((found - printed) / printed).abs()).fold(0.0, f64::max);
        let force = mechanism.loads(&state).o().force.norm();
        println!("{tolerance:9.0e}   {:5}   {:11}   {off:21.1e}   {force:10.6}", integrator.accepted, integrator.evaluations);
        errors.push((tolerance, off));
    }
    // The printed digits end at 1e-9.
    assert!(errors.iter().all(|(tolerance, off)| *off < 10.0 * tolerance.max(1e-9)), "{errors:?}");
    let motion = motion(&mechanism)?;
    let view = mechanism
        .view(motion)
        .title("Andrews' squeezing mechanism")
        .over("t", "ms", |state| 1e3 * state.t)
        .trace("path of E", |state| state.ef().point(place(-0.0165, 0.0)).value)
        .trace("path of H", |state| state.he().point(place(-0.00579, 0.0)).value)
        .plot("γ", "°", |state| state.bde().angle.to_degrees())
        .and("δ", |state| state.ag().angle.to_degrees())
        .and("ε", |state| state.ah().angle.to_degrees())
        .against("as printed", |state| printed(state, 1))
        .against("as printed", |state| printed(state, 2))
        .against("as printed", |state| printed(state, 3))
        .plot("bearing of the crank", "N", |state| mechanism.loads(state).o().force.norm());
    show("andrews", &view, 0, &[75, 150, 225])
}

/// A published angle (°) at the end of the motion.
fn printed(state: &State, angle: usize) -> f64 {
    if state.t < 0.03 { f64::NAN } else { PUBLISHED[angle].to_degrees() }
}

fn motion(m: &Andrews) -> Result<Vec<State>, Box<dyn Error>> {
    let (mut state, mut integrator) = (m.initial_state()?, Integrator::new(1e-9));
    let mut motion = vec![state.clone()];
    for time in steps(0.0, 0.03, 300).skip(1) {
        m.advance(&mut state, time, &mut integrator)?;
        motion.push(state.clone());
    }
    Ok(motion)
}
