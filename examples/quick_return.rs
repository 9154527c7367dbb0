//! The quick return of a shaper: a crank moves a slotted bar, which pushes the cutter slowly and pulls it back fast.
//!
//! ```text
//!   T ═[cutter]══════════════
//!        \  link
//!         \      E
//!   crank  \____/
//!  C (o)──[K]  /          OC = d, CK = r, OE = bar
//!          |  / slotted bar
//!          | /
//!         (o) O
//! ```
//!
//! The bar reverses where crank and bar are perpendicular, at sin φ = −r/d. So the cutter advances during π + 2 asin(r/d) of the crank
//! and returns during π − 2 asin(r/d): the time ratio is their quotient.
//!
//! Source of the lengths: E. J. Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, quick-return mechanism.

use std::error::Error;
use std::f64::consts::PI;

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_examples::{largest_difference, place, polar, show, steps};

mechanism! {
    /// A shaper that cuts to the left.
    #[picture]
    pub mechanism Shaper {
        param speed: AngularVelocity = 60rpm;
        param crank_length: Length = 150mm;
        param height: Length = 200mm;
        param bar_length: Length = 400mm;
        param link_length: Length = 252.98mm;

        ground {
            point O = (0mm, 0mm);
            point C = (0mm, height);
            point T = (0mm, bar_length);
            axis way = (1, 0);
        }
        body crank  { point C = (0mm, 0mm);  point K = (crank_length, 0mm); }
        body bar    { point O = (0mm, 0mm);  point E = (bar_length, 0mm);  axis slot = (1, 0);  start angle = 50deg; }
        body key    { point K = (0mm, 0mm); }
        body cutter { point T = (0mm, 0mm);  start position = (0mm, bar_length); }

        joint c = revolute(ground.C, crank.C);
        joint o = revolute(ground.O, bar.O);
        joint k = revolute(crank.K, key.K);
        joint slot = translational(bar.slot, bar.O, key.K);
        joint way = translational(ground.way, ground.T, cutter.T);
        joint link = distance(bar.E, cutter.T, link_length);
        drive motor = drive_angle(crank, speed * t);

        output O = ground.O;
        output C = ground.C;
        output K = key.K;
        output E = bar.E;
        output T = cutter.T;
        output travel = cutter.x;
    }
}

type State = ShaperState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Shaper::default();
    let turn: Vec<State> = mechanism.sweep(steps(0.0, 1.0, 180)).collect::<Result<_, _>>()?;

    assert_travel(&mechanism, &turn);
    assert_time_ratio(&mechanism)?;
    print(&mechanism, &turn);
    let view = mechanism
        .view(turn)
        .title("Quick return of a shaper")
        .over("crank", "°", |state| state.crank().angle.to_degrees())
        .trace("path of E", |state| mechanism.E(state).value)
        .plot("travel", "mm", |state| mechanism.travel(state).value * 1e3)
        .against("closed form", |state| closed_form(&mechanism, state.crank().angle).1 * 1e3)
        .plot("cutter", "m/s", |state| mechanism.travel(state).rate);
    show("quick_return", &view, 10, &[60, 90, 120])
}

/// Angle of the bar (rad) and travel of the cutter (m) at the crank's angle φ (rad).
fn closed_form(m: &Shaper, crank: f64) -> (f64, f64) {
    let key = place(0.0, m.height) + polar(m.crank_length, crank);
    let bar = key.y.atan2(key.x);
    let end = polar(m.bar_length, bar);
    (bar, end.x - (m.link_length.powi(2) - (m.bar_length - end.y).powi(2)).sqrt())
}

fn assert_travel(m: &Shaper, turn: &[State]) {
    let bar = largest_difference(turn.iter().map(|state| (state.bar().angle, closed_form(m, state.crank().angle).0)));
    let travel = largest_difference(turn.iter().map(|state| (m.travel(state).value, closed_form(m, state.crank().angle).1)));
    assert!(bar < 1e-14 && travel < 1e-15, "{bar:e} rad, {travel:e} m");
}

/// Bar and cutter are at rest at sin φ = −r/d, and nowhere between: the time ratio follows from the geometry.
fn assert_time_ratio(m: &Shaper) -> Result<(), Box<dyn Error>> {
    let lag = (m.crank_length / m.height).asin();
    for turning in [PI + lag, 2.0 * PI - lag] {
        let state = m.solve(turning / m.speed)?;
        assert!(state.bar().angular_velocity.abs() < 1e-13 && m.travel(&state).rate.abs() < 1e-13);
    }
    let directions = |first: f64, last: f64| m.sweep(steps(first, last, 100).skip(1).take(99).map(|angle| angle / m.speed));
    assert!(directions(-lag, PI + lag).all(|state| state.is_ok_and(|state| m.travel(&state).rate < 0.0)));
    assert!(directions(PI + lag, 2.0 * PI - lag).all(|state| state.is_ok_and(|state| m.travel(&state).rate > 0.0)));
    let (advance, back) = ((PI + 2.0 * lag).to_degrees(), (PI - 2.0 * lag).to_degrees());
    println!("advances during {advance:.2}° of the crank, returns during {back:.2}°: time ratio {:.3}\n", advance / back);
    Ok(())
}

fn print(m: &Shaper, turn: &[State]) {
    println!("crank °     bar °   travel mm   cutter m/s");
    for state in turn.iter().step_by(15) {
        let (crank, bar, travel) = (state.crank().angle, state.bar().angle, m.travel(state));
        println!("{:7.1}   {:7.3}   {:9.3}   {:10.4}", crank.to_degrees(), bar.to_degrees(), travel.value * 1e3, travel.rate);
    }
}
