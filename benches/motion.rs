//! Motions that follow from forces: `cargo run --release -p reuleaux-benches --bin motion`.
//!
//! Out: Andrews' mechanism at several tolerances: its error, its evaluations and its time; the same of Bricard's linkage and of a heavy top,
//! beside equations of motion written by hand, which the same integrator follows.

use std::error::Error;
use std::hint::black_box;

use reuleaux::{Integrator, mechanism};
use reuleaux_benches::measured;
use reuleaux_benches::released::{bricard, follow, top};

mechanism! {
    /// Andrews' squeezing mechanism.
    pub mechanism Andrews {
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
        force motor = { on of: 0.033Nm; }
        force spring = spring(ground.C, bde.D, stiffness: 4530N_m, rest: 77.85mm);
        freedom crank = of.angle from -0.0617138900142764496358948458001rad;
    }
}

/// β, γ, δ and ε at 0.03 s, of the problem with its parameters as doubles.
const EXACT: [f64; 4] = [15.810_771_195_153_71, 0.040_822_240_119_645_82, 0.524_409_965_879_954, 1.048_080_741_041_938];

fn main() -> Result<(), Box<dyn Error>> {
    andrews()?;
    println!("\n| | | tolerance | error | steps | evaluations | ms | ratio |\n| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |");
    beside(of_bricard()?);
    beside(of_top()?);
    Ok(())
}

fn andrews() -> Result<(), Box<dyn Error>> {
    let mechanism = Andrews::default();
    let start = mechanism.initial_state()?;
    println!("| tolerance | error | steps | evaluations | ms |\n| ---: | ---: | ---: | ---: | ---: |");
    for tolerance in [1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12] {
        let (mut state, mut integrator) = (start.clone(), Integrator::new(tolerance));
        mechanism.advance(&mut state, 0.03, &mut integrator)?;
        let angles = [state.of(), state.bde(), state.ag(), state.ah()].map(|body| body.angle);
        let error = angles.into_iter().zip(EXACT).map(|(found, exact)| ((found - exact) / exact).abs()).fold(0.0, f64::max);
        let mut run = || {
            let mut state = start.clone();
            let _ = black_box(mechanism.advance(black_box(&mut state), 0.03, &mut Integrator::new(tolerance)));
        };
        let time = measured(&mut [&mut run], 2)[0] / 1e6;
        println!("| {tolerance:e} | {error:.0e} | {} | {} | {time:.2} |", integrator.accepted, integrator.evaluations);
    }
    Ok(())
}

/// A motion to its end with an integrator, and its error there.
type Way = Box<dyn Fn(&mut Integrator) -> f64>;

/// A motion by hand and from its declaration.
type Ways = (&'static str, [Way; 2]);

fn of_bricard() -> Result<Ways, Box<dyn Error>> {
    let mechanism = bricard::Bricard::default();
    let start = mechanism.initial_state()?;
    let by_hand: Way = Box::new(|integrator| {
        let mut state = bricard::ByHand::start();
        follow(&bricard::ByHand, &mut state, bricard::DURATION, integrator);
        (state.q[0] - bricard::ANGLE).abs()
    });
    let declared: Way = Box::new(move |integrator| {
        let mut state = start.clone();
        mechanism.advance(&mut state, bricard::DURATION, integrator).unwrap_or_else(|stopped| panic!("{stopped}"));
        (mechanism.a(&state).value - bricard::ANGLE).abs()
    });
    Ok(("D5 Bricard's linkage", [by_hand, declared]))
}

fn of_top() -> Result<Ways, Box<dyn Error>> {
    let mechanism = top::Top::default();
    let start = mechanism.initial_state()?;
    let off = |q: [f64; 4]| top::center(q).iter().zip(top::CENTER).map(|(found, exact)| (found - exact).abs()).fold(0.0, f64::max);
    let by_hand: Way = Box::new(move |integrator| {
        let mut state = top::ByHand::start();
        follow(&top::ByHand, &mut state, top::DURATION, integrator);
        off(state.q.into())
    });
    let declared: Way = Box::new(move |integrator| {
        let mut state = start.clone();
        mechanism.advance(&mut state, top::DURATION, integrator).unwrap_or_else(|stopped| panic!("{stopped}"));
        off([3, 4, 5, 6].map(|k: usize| state.q[k]))
    });
    Ok(("D6 heavy top", [by_hand, declared]))
}

fn beside((name, ways): Ways) {
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let run = |way: &Way| {
            black_box(way(&mut Integrator::new(black_box(tolerance))));
        };
        let [mut by_hand, mut declared] = ways.each_ref().map(|way| move || run(way));
        let times = measured(&mut [&mut by_hand, &mut declared], 1);
        for ((who, way), time) in ["by hand", "reuleaux"].into_iter().zip(&ways).zip(&times) {
            let mut integrator = Integrator::new(tolerance);
            let error = way(&mut integrator);
            assert!(error < tolerance, "{name}, {who}, {tolerance:e}: off by {error:e}");
            let (steps, evaluations, ms, ratio) = (integrator.accepted, integrator.evaluations, time / 1e6, time / times[0]);
            println!("| {name} | {who} | {tolerance:e} | {error:.0e} | {steps} | {evaluations} | {ms:.3} | {ratio:.2} |");
        }
    }
}
