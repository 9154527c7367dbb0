//! Motion that follows from forces: `cargo run --release -p reuleaux-benches --bin motion`.
//!
//! Out: accelerations and loads of a four-bar from ordinary declarations beside hand-written ones, and Andrews' mechanism at several
//! tolerances: its error, what it cost, and how long it took.

use std::error::Error;
use std::f64::consts::PI;
use std::hint::black_box;

use reuleaux::{Dynamics, Integrator, mechanism};
use reuleaux_benches::measured;

/// Ground 4, crank 1, coupler 3.5, rocker 3 m, of bars that weigh a kilogram a metre.
macro_rules! four_bar {
    ($name:ident, $($rest:tt)*) => {
        mechanism! {
            /// The four-bar with a crank that is free, or driven.
            pub mechanism $name {
                gravity = (0, -9.81m_s2);
                ground { point D = (4m, 0m); }
                body crank   { point B = (1m, 0m);    mass = 1kg;    center = (0.5m, 0m);   inertia = 1/12 * 1kgm2; }
                body coupler { point C = (3.5m, 0m);  mass = 3.5kg;  center = (1.75m, 0m);  inertia = 3.5^3 / 12 * 1kgm2;  start angle = 60deg; }
                body rocker  { point C = (3m, 0m);    mass = 3kg;    center = (1.5m, 0m);   inertia = 27/12 * 1kgm2;  start angle = 100deg; }
                joint a = revolute(ground.position, crank.position);
                joint b = revolute(crank.B, coupler.position);
                joint c = revolute(coupler.C, rocker.C);
                joint d = revolute(rocker.position, ground.D);
                $($rest)*
            }
        }
    };
}

four_bar!(FourBar, freedom swing = crank.angle from 0.3rad;);
four_bar!(Driven, drive motor = drive_angle(crank, 2rad_s * t););

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

/// Accelerations of the three angles as a person would write them: with the two loop equations, unit motion of the crank and one mass.
fn by_hand(angle: [f64; 3], rate: [f64; 3]) -> [f64; 3] {
    const LENGTHS: [f64; 3] = [1.0, 3.5, 3.0];
    const MASSES: [f64; 3] = [1.0, 3.5, 3.0];
    let [(s1, c1), (s2, c2), (s3, c3)] = angle.map(f64::sin_cos);
    let [l1, l2, l3] = LENGTHS;
    let [m1, m2, m3] = MASSES;
    let determinant = l2 * l3 * (s3 * c2 - c3 * s2);
    let solve = |x: f64, y: f64| [l3 * (x * c3 + y * s3) / determinant, l2 * (x * c2 + y * s2) / determinant];
    // Speeds of coupler and rocker for one of the crank, and their accelerations at rest of the crank's.
    let [u2, u3] = solve(l1 * s1, -l1 * c1);
    let (w1, w2, w3) = (rate[0] * rate[0], rate[1] * rate[1], rate[2] * rate[2]);
    let [p2, p3] = solve(l1 * c1 * w1 + l2 * c2 * w2 - l3 * c3 * w3, l1 * s1 * w1 + l2 * s2 * w2 - l3 * s3 * w3);
    let h = l2 / 2.0;
    // The centre of the coupler: v = (-l1 s1 - h s2 u2, l1 c1 + h c2 u2).
    let v = [-l1 * s1 - h * s2 * u2, l1 * c1 + h * c2 * u2];
    let a = [-l1 * c1 * w1 - h * (s2 * p2 + c2 * w2), -l1 * s1 * w1 + h * (c2 * p2 - s2 * w2)];
    let (j1, j2, j3) = (m1 * l1 * l1 / 3.0, m2 * l2 * l2 / 12.0, m3 * l3 * l3 / 3.0);
    let mass = j1 + m2 * (v[0] * v[0] + v[1] * v[1]) + j2 * u2 * u2 + j3 * u3 * u3;
    let weight = 9.81 * (m1 * l1 / 2.0 * c1 + m2 * v[1] + m3 * l3 / 2.0 * c3 * u3);
    let rest = m2 * (v[0] * a[0] + v[1] * a[1]) + j2 * u2 * p2 + j3 * u3 * p3;
    let crank = -(weight + rest) / mass;
    [crank, u2 * crank + p2, u3 * crank + p3]
}

/// Forces on crank, coupler, coupler and rocker at the four pins in order, and the torque, as a person would write them: moments of rocker
/// and coupler about their first pins give the force between them, and forces the rest.
fn loads_by_hand(angle: [f64; 3], rate: [f64; 3], turning: [f64; 3]) -> [f64; 9] {
    const L1: f64 = 1.0;
    const L2: f64 = 3.5;
    const L3: f64 = 3.0;
    let [(s1, c1), (s2, c2), (s3, c3)] = angle.map(f64::sin_cos);
    let inward = rate.map(|rate| rate * rate);
    // Acceleration of a point at unit distance, and of the centres less gravity.
    let unit = |s: f64, c: f64, k: usize| [-c * inward[k] - s * turning[k], -s * inward[k] + c * turning[k]];
    let [u1, u2, u3] = [unit(s1, c1, 0), unit(s2, c2, 1), unit(s3, c3, 2)];
    let inertial = |mass: f64, a: [f64; 2]| [mass * a[0], mass * (a[1] + 9.81)];
    let p1 = inertial(L1, u1.map(|u| 0.5 * L1 * u));
    let p2 = inertial(L2, [L1 * u1[0] + 0.5 * L2 * u2[0], L1 * u1[1] + 0.5 * L2 * u2[1]]);
    let p3 = inertial(L3, u3.map(|u| 0.5 * L3 * u));
    let about =
        |length: f64, s: f64, c: f64, p: [f64; 2], turning: f64| 0.5 * length * (c * p[1] - s * p[0]) + length.powi(3) / 12.0 * turning;
    let [of_coupler, of_rocker] = [about(L2, s2, c2, p2, turning[1]), about(L3, s3, c3, p3, turning[2])];
    // Force on the rocker: L3 × F = of_rocker, −L2 × F = of_coupler.
    let determinant = s2 * c3 - c2 * s3;
    let (x, y) = (of_rocker / L3, -of_coupler / L2);
    let [fx, fy] = [(x * c2 - y * c3) / determinant, (x * s2 - y * s3) / determinant];
    let at_b = [p2[0] + fx, p2[1] + fy];
    let at_a = [p1[0] + at_b[0], p1[1] + at_b[1]];
    let torque = about(L1, s1, c1, p1, turning[0]) + L1 * (c1 * at_b[1] - s1 * at_b[0]);
    [at_a[0], at_a[1], at_b[0], at_b[1], fx, fy, p3[0] - fx, p3[1] - fy, torque]
}

/// Poses of a turn.
const POSES: usize = 256;

fn loads() -> Result<(), Box<dyn Error>> {
    let mechanism = Driven::default();
    // A turn of the crank.
    let states: Vec<_> = mechanism
        .sweep((0..POSES).map(|k| PI * k as f64 / POSES as f64))
        .collect::<Result<_, _>>()
        .map_err(|failure| failure.to_string())?;
    let motion = |state: &DrivenState<f64>| [&state.q, &state.qd, &state.qdd].map(|vector| [vector[2], vector[5], vector[8]]);
    let motions: Vec<[[f64; 3]; 3]> = states.iter().map(motion).collect();
    for (state, &[angle, rate, turning]) in states.iter().zip(&motions) {
        let (hand, found) = (loads_by_hand(angle, rate, turning), mechanism.loads(state));
        let pins = [found.a(), found.b(), found.c(), found.d()].map(|load| load.force);
        let found: Vec<f64> = pins.iter().flat_map(|force| [force.x, force.y]).chain([found.motor().effort]).collect();
        for (found, hand) in found.iter().zip(hand) {
            assert!((found - hand).abs() < 1e-10, "{found} {hand}");
        }
    }
    let mut own = || {
        for state in &states {
            black_box(mechanism.loads(black_box(state)));
        }
    };
    let mut by_hand = || {
        for &motion in &motions {
            let [angle, rate, turning] = black_box(motion);
            black_box(loads_by_hand(angle, rate, turning));
        }
    };
    let times = measured(&mut [&mut own, &mut by_hand], 100);
    let times: Vec<f64> = times.into_iter().map(|time| time / POSES as f64).collect();
    println!("loads of a four-bar: {:.0} ns, by hand {:.0} ns: {:.2}\n", times[0], times[1], times[0] / times[1]);
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    accelerations()?;
    loads()?;
    andrews()
}

fn accelerations() -> Result<(), Box<dyn Error>> {
    let mechanism = FourBar::default();
    let mut state = mechanism.initial_state()?;
    mechanism.advance(&mut state, 0.7, &mut Integrator::new(1e-10))?;
    let [angle, rate] = [&state.q, &state.qd].map(|vector| [vector[2], vector[5], vector[8]]);
    let found = mechanism.accelerations(&state.q, &state.qd, state.t).ok_or("a pivot is small")?;
    let hand = by_hand(angle, rate);
    let off = found.iter().zip(hand).map(|(found, hand)| (found - hand).abs()).fold(0.0, f64::max);
    assert!(off < 1e-12, "{found} {hand:?}");
    let mut own = || {
        black_box(mechanism.accelerations(black_box(&state.q), black_box(&state.qd), 0.0));
    };
    let mut by_hand = || {
        black_box(by_hand(black_box(angle), black_box(rate)));
    };
    let times = measured(&mut [&mut own, &mut by_hand], 10_000);
    println!("accelerations of a four-bar: {:.0} ns, by hand {:.0} ns: {:.2}\n", times[0], times[1], times[0] / times[1]);
    Ok(())
}

/// β, γ, δ and ε at 0.03 s, of the problem with its parameters as doubles.
const EXACT: [f64; 4] = [15.810_771_195_153_71, 0.040_822_240_119_645_82, 0.524_409_965_879_954, 1.048_080_741_041_938];

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
