//! A screw jack with a worm gear: three thousand turns of a motor raise a load by six hundred millimetres.
//!
//! ```text
//!           ║ load
//!     ┌─────╫─────┐
//!     │  wheel 30 │  = nut on the screw, lead 6 mm
//!     └─────╫─────┘
//!   ═══(≈≈≈≈≈≈)═══  worm, one start, below the wheel
//! ```
//!
//! The worm rotates about x, the wheel about z, and the screw, which cannot rotate, climbs in the wheel. Angles of joints in space are
//! never wrapped: every turn of the worm is a fifth of a millimetre.
//!
//! ```text
//! z = lead φ / (30 · 2π)
//! ```
//!
//! Source: the law of gearing; Dubbel, Taschenbuch für den Maschinenbau, on power screws.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux_examples::{figure, largest_difference, play, steps};

mechanism! {
    /// A screw jack on a worm gear.
    #[picture]
    pub mechanism ScrewJack in space {
        param turns: Angle = 3000turn;
        param duration: Time = 60s;
        param lead: Length = 6mm;
        /// Distance between the two axes.
        param distance: Length = 60mm;
        let teeth = 30;

        ground {
            point worm = (0mm, -distance, 0mm);
            axis x = (1, 0, 0);
            axis z = (0, 0, 1);
        }
        body worm  { axis x = (1, 0, 0);  start position = (0mm, -distance, 0mm); }
        body wheel { axis z = (0, 0, 1); }
        body screw { axis z = (0, 0, 1);  axis key = (0, 1, 0);  point head = (0mm, 0mm, 250mm); }

        joint worm_bearing = revolute(ground.worm, ground.x, worm.position, worm.x);
        joint wheel_bearing = revolute(ground.position, ground.z, wheel.position, wheel.z);
        joint mesh = gear_pair(worm_bearing.angle, wheel_bearing.angle, 1, teeth);
        joint thread = screw(wheel.position, wheel.z, screw.position, screw.z, lead);
        joint key = perpendicular_axes(ground.x, screw.key);
        drive motor = drive_rotation(worm_bearing, turns * polynomial_345(t / duration));

        output motor = worm_bearing.angle;
        output wheel = wheel_bearing.angle;
        output height = screw.position.z;
        output head = screw.head;
    }
}

type State = ScrewJackState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = ScrewJack::default();
    let motion: Vec<State> = mechanism.sweep(steps(0.0, 60.0, 240)).collect::<Result<_, _>>()?;

    assert_height(&mechanism, &motion);
    for turns in [1.0, -7.25, 3e4] {
        let mechanism = ScrewJack { turns: turns * TAU, ..Default::default() };
        let end = mechanism.sweep([0.0, mechanism.duration]).last().ok_or("no state")??;
        let rise = mechanism.height(&end).value;
        assert!((rise / (turns * mechanism.lead / 30.0) - 1.0).abs() < 8.0 * f64::EPSILON, "{rise} m after {turns} turns");
    }
    print(&mechanism, &motion);
    figure("worm_and_screw", &view(&mechanism, motion), 60, &[120, 240])?;
    // Few turns and a steep thread, so that both can be seen.
    let steep = ScrewJack { turns: 5.0 * TAU, lead: 0.36, duration: 4.0, ..mechanism };
    let motion: Vec<State> = steep.sweep(steps(0.0, 4.0, 120)).collect::<Result<_, _>>()?;
    play("worm_and_screw", &view(&steep, motion))
}

fn view(m: &ScrewJack, motion: Vec<State>) -> View<State> {
    m.view(motion)
        .title("Worm gear and screw")
        .plot("height", "mm", |state| m.height(state).value * 1e3)
        .against("closed form", |state| exact(m, state.t / m.duration)[0] * 1e3)
        .plot("motor", "turns", |state| m.motor(state).value / TAU)
        .plot("speed of the load", "mm/s", |state| m.height(state).rate * 1e3)
        .against("closed form", |state| exact(m, state.t / m.duration)[1] * 1e3)
}

/// Fraction of the stroke by the law 10u³ − 15u⁴ + 6u⁵, with its derivatives.
fn law(u: f64) -> [f64; 3] {
    let rest = 1.0 - u;
    [u.powi(3) * (10.0 - 15.0 * u + 6.0 * u * u), 30.0 * (u * rest).powi(2), 60.0 * u * rest * (1.0 - 2.0 * u)]
}

/// Height (m), speed and acceleration of the load after a fraction of the time.
fn exact(m: &ScrewJack, share: f64) -> [f64; 3] {
    let way = m.lead * m.turns / (30.0 * TAU);
    let mut order = 0;
    law(share).map(|part| {
        order += 1;
        way * part / m.duration.powi(order - 1)
    })
}

/// The load follows the law, neither leaves its axis nor rotates; worm and wheel keep their ratio.
fn assert_height(m: &ScrewJack, motion: &[State]) {
    for (order, exact_at_most) in exact(m, 0.5).into_iter().enumerate() {
        let scale = if order == 2 { exact(m, 0.21)[2] } else { exact_at_most };
        let solved = |state| [m.height(state).value, m.height(state).rate, m.height(state).acceleration][order];
        let error = largest_difference(motion.iter().map(|state| (solved(state) / scale, exact(m, state.t / m.duration)[order] / scale)));
        assert!(error < 4e-15, "derivative {order} of the height is {error:e} off");
    }
    for state in motion {
        let screw = state.screw();
        assert!(
            screw.position.xy().norm() < 1e-17 && (screw.rotation.trace() - 3.0).abs() < 1e-15 && screw.angular_velocity.norm() < 1e-12
        );
        assert!((state.wheel().angular_velocity.z * 30.0 + state.worm().angular_velocity.x).abs() < 1e-12);
    }
}

fn print(m: &ScrewJack, motion: &[State]) {
    println!("time s   turns of the motor   turns of the wheel   height mm   mm/s");
    for state in motion.iter().step_by(24) {
        let [motor, wheel] = [m.motor(state), m.wheel(state)].map(|angle| angle.value / TAU);
        println!(
            "{:6.1}   {motor:18.3}   {wheel:18.4}   {:9.3}   {:5.2}",
            state.t,
            m.height(state).value * 1e3,
            m.height(state).rate * 1e3
        );
    }
}
