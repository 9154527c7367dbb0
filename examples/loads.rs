//! Loads of a four-bar: motor torque, bearing forces, and counterweights that halve the shaking force.
//!
//! ```text
//!              coupler      B
//!        A ────────────────(o)
//!       (o)                 │ rocker        each link with its mass
//! crank /                   │
//!     (o)                  (o)
//!  ════O════════════════════C════
//! ```
//!
//! The sum of the bearing forces from ground, minus the weight, is the shaking force. By Berkof and Lowen it vanishes if the coupler is
//! replaced by two masses at its pins and each of the other links is balanced with its share: 0.233 kg on the crank and 0.45 kg on the
//! rocker. It is linear in both weights, so that half of them halve it. The work of the motor over a turn is zero, since there are no
//! losses.
//!
//! Source: R. L. Norton, Design of Machinery, balancing; R. S. Berkof and G. G. Lowen, A new method for completely force balancing simple
//! linkages, 1969.

use std::error::Error;

use reuleaux::mechanism;
use reuleaux::nalgebra::Vector2;
use reuleaux::picture::Drawable;
use reuleaux_examples::{largest_difference, round, show, steps};

mechanism! {
    /// A crank-rocker whose links have masses.
    #[picture]
    pub mechanism Loaded {
        param speed: AngularVelocity = 300rpm;
        /// Counterweight on the crank, opposite to its pin.
        param crank_weight: Mass = 0kg;
        /// Counterweight on the rocker, opposite to its pin.
        param rocker_weight: Mass = 0kg;

        gravity = (0, -9.81m_s2);
        ground { point O = (0mm, 0mm);  point C = (100mm, 0mm); }
        body crank   { point O = (0mm, 0mm);  point A = (40mm, 0mm);  point W = (-30mm, 0mm);  mass = 0.1kg;   center = (20mm, 0mm);  inertia = 0.00002kgm2; }
        body coupler { point A = (0mm, 0mm);  point B = (120mm, 0mm);  mass = 0.25kg;  center = (60mm, 0mm);  inertia = 0.0004kgm2; }
        body rocker  { point C = (0mm, 0mm);  point B = (80mm, 0mm);  point W = (-40mm, 0mm);  mass = 0.2kg;   center = (40mm, 0mm);  inertia = 0.00015kgm2;  start angle = 60deg; }
        body on_crank  { mass = crank_weight; }
        body on_rocker { mass = rocker_weight; }

        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        joint bolt = weld(crank.W, on_crank.position);
        joint screw = weld(rocker.W, on_rocker.position);
        drive motor = drive_angle(crank, speed * t);

        output A = crank.A;
        output B = rocker.B;
    }
}

type State = LoadedState<f64>;

/// Weights (kg) on crank and rocker that cancel the shaking force.
const WEIGHTS: [f64; 2] = [(0.1 * 20.0 + 0.125 * 40.0) / 30.0, (0.2 * 40.0 + 0.125 * 80.0) / 40.0];

/// A turn of the crank: loads at each of these angles (°).
struct Turn {
    shaking: Vec<(f64, Vector2<f64>)>,
    torque: Vec<(f64, f64)>,
    power: Vec<f64>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let [plain, half, balanced] = [0.0, 0.5, 1.0].map(turn);
    let (plain, half, balanced) = (plain?, half?, balanced?);
    let size = largest(&plain);
    let halves = plain.shaking.iter().zip(&half.shaking).map(|(plain, half)| ((plain.1 / 2.0 - half.1).norm() / size, 0.0));
    assert!(largest_difference(halves) < 1e-13, "half the weights leave half the shaking force");
    assert!(largest(&balanced) < 1e-13 * size, "the weights balance the linkage: {:e} N", largest(&balanced));
    for turn in [&plain, &half, &balanced] {
        let (work, most) = (turn.power.iter().sum::<f64>(), turn.power.iter().fold(0.0, |most: f64, power| most.max(power.abs())));
        assert!(work.abs() < 1e-10 * most * turn.power.len() as f64, "the work of a turn is {work} of {most}");
    }
    println!("crank °   torque N m   shaking force N: without weights, with half, with all");
    for (k, (angle, torque)) in plain.torque.iter().enumerate().step_by(30) {
        let force = |turn: &Turn| turn.shaking[k].1.norm();
        println!("{angle:7.1}   {torque:10.4}   {:8.3}   {:8.3}   {:8.1e}", force(&plain), force(&half), force(&balanced));
    }
    let mechanism = Loaded { crank_weight: WEIGHTS[0], rocker_weight: WEIGHTS[1], ..Default::default() };
    let states = mechanism.sweep(steps(0.0, 0.2, 360)).collect::<Result<Vec<LoadedState<f64>>, _>>()?;
    let at = |state: &State| state.crank().angle.to_degrees().round() as usize % 360;
    let view = mechanism
        .view(states)
        .title("Loads of a four-bar")
        .over("crank", "°", |state| state.crank().angle.to_degrees())
        .outline("on_crank", round(0.008))
        .outline("on_rocker", round(0.011))
        .trace("path of A", |state| mechanism.A(state).value)
        .plot("shaking force, plain", "N", |state| plain.shaking[at(state)].1.norm())
        .and("with half the weights", |state| half.shaking[at(state)].1.norm())
        .and("balanced", |state| balanced.shaking[at(state)].1.norm())
        .plot("motor torque, plain", "N m", |state| plain.torque[at(state)].1)
        .and("with half the weights", |state| half.torque[at(state)].1)
        .and("balanced", |state| mechanism.loads(state).motor().effort)
        .plot("bearing O, balanced", "N", |state| mechanism.loads(state).o().force.norm())
        .and("bearing C", |state| mechanism.loads(state).c().force.norm());
    show("loads", &view, 54, &[])
}

/// A turn with this share of the balancing weights.
fn turn(share: f64) -> Result<Turn, Box<dyn Error>> {
    let mechanism = Loaded { crank_weight: share * WEIGHTS[0], rocker_weight: share * WEIGHTS[1], ..Default::default() };
    let mass = 0.1 + 0.25 + 0.2 + share * (WEIGHTS[0] + WEIGHTS[1]);
    let mut turn = Turn { shaking: Vec::new(), torque: Vec::new(), power: Vec::new() };
    // The turn closes: its last angle equals the first and is omitted.
    for state in mechanism.sweep(steps(0.0, 0.2, 360).take(360)) {
        let state = state?;
        let (loads, angle) = (mechanism.loads(&state), state.crank().angle.to_degrees());
        turn.shaking.push((angle, loads.o().force + loads.c().force - Vector2::new(0.0, 9.81 * mass)));
        turn.torque.push((angle, loads.motor().effort));
        turn.power.push(loads.motor().power);
    }
    Ok(turn)
}

/// Largest shaking force, in N.
fn largest(turn: &Turn) -> f64 {
    turn.shaking.iter().map(|(_, force)| force.norm()).fold(0.0, f64::max)
}
