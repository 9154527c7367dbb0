//! Three wheels of a locomotive and their coupling rod: one pin is redundant, and fits if the wheels are equal.
//!
//! ```text
//!      ___       ___       ___
//!     /   \     /   \     /   \        wheels of radius R, which roll on the rail
//!    |  o════════╪o════════╪o  |       rod over three crank pins at r, axles a apart
//!     \___/     \___/     \___/
//!   ───────────────────────────────
//! ```
//!
//! Each wheel rotates as it rolls, by −x/R. The first pin carries the rod, and a second one keeps it level; the third is redundant. It is
//! declared as redundant, and so is the second, of which only one equation is needed: the other equations are checked. So the rod moves
//! without rotating, and if a wheel is worn the solver reports by how much the pin misses its hole:
//!
//! ```text
//! |Δ| = 2 r sin(|φ₂ − φ₁| / 2)          φ₂ − φ₁ = x/R₁ − x/R₂
//! ```
//!
//! Real rods have play for that, and coupled wheels are turned on the lathe together.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::picture::Drawable;
use reuleaux::{Cause, mechanism};
use reuleaux_examples::{largest_difference, place, polar, show, steps};

mechanism! {
    /// A locomotive on three coupled axles.
    #[picture]
    pub mechanism CoupledWheels {
        param speed: Velocity = 5m_s;
        param throw: Length = 300mm;
        for i in 0..3 { param radius[i]: Length = 700mm; }

        ground { point O = (0mm, 700mm);  axis rail = (1, 0); }
        body engine { for i in 0..3 { point axle[i] = (i * 1.6m, 0m); } }
        body rod    { for i in 0..3 { point hole[i] = (i * 1.6m, 0m); } }
        for i in 0..3 { body wheel[i] { point pin = (throw, 0mm); } }

        joint track = translational(ground.rail, ground.O, engine.position);
        for i in 0..3 {
            joint axle[i] = revolute(engine.axle[i], wheel[i].position);
            joint rolling[i] = rack_pinion(wheel[i], engine.position, ground.rail, ground.O, radius[i]);
        }
        joint pin[0] = revolute(rod.hole[0], wheel[0].pin);
        for i in 1..3 { redundant joint pin[i] = revolute(rod.hole[i], wheel[i].pin); }
        drive run = drive_x(engine.position, speed * t);

        for i in 0..3 { output pin[i] = wheel[i].pin; }
        output rod = rod.hole[1];
    }
}

type State = CoupledWheelsState<f64>;

/// Reduction of a wheel's radius by wear, in m.
const WEAR: [f64; 3] = [0.2e-3, 0.5e-3, 1e-3];

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}\n", CoupledWheels::<f64>::PLAN);
    let mechanism = CoupledWheels::default();
    let turn = TAU * mechanism.radius[0] / mechanism.speed;
    let states: Vec<State> = mechanism.sweep(steps(0.0, turn, 180)).collect::<Result<_, _>>()?;
    assert_level(&mechanism, &states);
    let worn = WEAR.map(|wear| misses(&mechanism, wear, turn));
    println!("wear mm   after one turn the middle pin misses its hole by mm");
    for (wear, misses) in WEAR.iter().zip(&worn) {
        println!("{:7.1}   {:.3}", wear * 1e3, misses.last().map_or(f64::NAN, |(_, off)| off * 1e3));
    }
    // At the start the pin is in its hole.
    let off = |wheel: usize| {
        let worn = &worn[wheel];
        move |state: &State| worn.iter().rfind(|(t, _)| *t <= state.t).map_or(0.0, |(_, off)| off * 1e3)
    };
    let view = mechanism
        .view(states)
        .title("Coupled wheels")
        .over("path", "m", |state| state.engine().position.x)
        .trace("path of the rod", |state| mechanism.rod(state).value)
        .plot("speed of the rod", "m/s", |state| mechanism.rod(state).rate.norm())
        .against("trochoid", |state| speed(&mechanism, state))
        .plot("middle pin off, 0.2 mm worn", "mm", off(0))
        .and("0.5 mm", off(1))
        .and("1 mm", off(2));
    show("coupled_wheels", &view, 75, &[])
}

/// The rod stays level, and its points move as fast as the pins: on trochoids.
fn assert_level(m: &CoupledWheels, states: &[State]) {
    for state in states {
        let rod = state.rod();
        assert!(rod.angle.abs() < 1e-15 && rod.angular_velocity.abs() < 1e-13);
        assert!(state.wheel().iter().all(|wheel| (wheel.angle - state.wheel()[0].angle).abs() < 1e-15));
    }
    let error = largest_difference(states.iter().map(|state| (m.rod(state).rate.norm(), speed(m, state))));
    assert!(error < 1e-14, "the rod's speed is {error:e} m/s beside that of a trochoid");
}

/// v |1 − (r/R) e^{i (φ + 90°)}|, the speed (m/s) of a pin with its wheel at the angle φ.
fn speed(m: &CoupledWheels, state: &State) -> f64 {
    let share = polar(m.throw / m.radius[0], state.wheel()[0].angle);
    m.speed * (place(1.0, 0.0) + place(share.y, -share.x)).norm()
}

/// Distance (m) by which the middle pin misses its hole at times (s) of a turn, with a wheel worn by `wear` (m).
fn misses(whole: &CoupledWheels, wear: f64, turn: f64) -> Vec<(f64, f64)> {
    let mut worn = *whole;
    worn.radius[1] -= wear;
    let start = worn.solve(0.0).expect("at the start all pins are in their holes");
    let miss = |t: f64| {
        let x = whole.speed * t;
        let [first, middle] = [whole.radius[0], worn.radius[1]].map(|radius| polar(whole.throw, -x / radius));
        let failure = worn.solve_from(t, &start).expect_err("the wheels turn differently");
        let Cause::DoesNotHold { row, residual } = failure.cause else { panic!("{failure}") };
        // Of the two rows of the middle pin, the failure names the one with the larger residual in roundings.
        let off = first - middle;
        assert_eq!((row.joint, failure.time), ("pin[1]", t));
        assert!((residual - off[row.index - 1]).abs() < 1e-14, "{failure}");
        (t, off.norm())
    };
    let half = (whole.speed / whole.radius[0] - whole.speed / worn.radius[1]) / 2.0;
    let found: Vec<(f64, f64)> = steps(0.0, turn, 180).skip(1).map(miss).collect();
    assert!(largest_difference(found.iter().map(|(t, off)| (*off, 2.0 * whole.throw * (half * t).sin().abs()))) < 1e-14);
    found
}
