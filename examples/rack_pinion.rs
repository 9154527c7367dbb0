//! A windscreen wiper: a crank moves a rack to and fro, and the rack turns the wiper's pinion.
//!
//! ```text
//!                          │ wiper
//!       A                  │
//! crank(o)──rod──[B]▁▁▁▁▁▁▁│▁▁▁▁▁▁▁ rack     OA = r, AB = l
//!   (o)═══════════════    (o) pinion, radius R
//!    O
//! ```
//!
//! The rack travels 2 r, so the wiper swings through 2 r/R. Its angle is checked against (l − x)/R with the slider-crank's
//! x = r cos φ + √(l² − r² sin² φ); at their contact, pinion and rack have the same velocity.
//!
//! Source: E. J. Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 3.4, for the row.

use std::error::Error;
use std::f64::consts::PI;

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_examples::{largest_difference, show, steps};

mechanism! {
    /// A wiper that is upright in the middle of the stroke.
    #[picture]
    pub mechanism Wiper {
        param speed: AngularVelocity = 60rpm;
        param crank_length: Length = 25mm;
        param rod_length: Length = 90mm;
        /// Pitch radius of the pinion.
        param radius: Length = 25mm;

        ground {
            point O = (0mm, 0mm);
            point D = (rod_length + 80mm, -radius);
            axis way = (1, 0);
        }
        body crank { point O = (0mm, 0mm);  point A = (crank_length, 0mm); }
        body rod   { point A = (0mm, 0mm);  point B = (rod_length, 0mm);  start angle = 0deg; }
        body rack  { point B = (0mm, 0mm); }
        body wiper { point D = (0mm, 0mm);  point W = (0mm, 130mm); }

        joint main = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, rod.A);
        joint b = revolute(rod.B, rack.B);
        joint way = translational(ground.way, ground.O, rack.B);
        joint d = revolute(ground.D, wiper.D);
        joint teeth = rack_pinion(wiper, rack.B, ground.way, ground.O, radius, c: rod_length);
        drive motor = drive_angle(crank, speed * t);

        output O = ground.O;
        output A = crank.A;
        output B = rack.B;
        output D = wiper.D;
        output W = wiper.W;
    }
}

type State = WiperState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Wiper::default();
    let turn: Vec<State> = mechanism.sweep(steps(0.0, 1.0, 180)).collect::<Result<_, _>>()?;

    assert_swing(&mechanism, &turn)?;
    assert_rolling(&mechanism, &turn);
    print(&turn);
    let view = mechanism
        .view(turn)
        .title("Rack and pinion of a wiper")
        .over("crank", "°", |state| state.crank().angle.to_degrees())
        .trace("path of W", |state| mechanism.W(state).value)
        .plot("wiper", "°", |state| state.wiper().angle.to_degrees())
        .against("closed form", |state| closed_form(&mechanism, state.crank().angle).to_degrees())
        .plot("velocity of the wiper", "rad/s", |state| state.wiper().angular_velocity)
        .plot("acceleration of the wiper", "rad/s²", |state| state.wiper().angular_acceleration);
    show("rack_pinion", &view, 22, &[0, 60, 90])
}

/// The wiper's angle (rad) at the crank's angle φ (rad).
fn closed_form(m: &Wiper, crank: f64) -> f64 {
    let (sin, cos) = crank.sin_cos();
    let travel = m.crank_length * cos + (m.rod_length.powi(2) - (m.crank_length * sin).powi(2)).sqrt();
    (m.rod_length - travel) / m.radius
}

fn assert_swing(m: &Wiper, turn: &[State]) -> Result<(), Box<dyn Error>> {
    let error = largest_difference(turn.iter().map(|state| (state.wiper().angle, closed_form(m, state.crank().angle))));
    assert!(error < 1e-14, "the wiper is {error:e} rad off");
    let [right, left] = [m.solve(0.0)?, m.solve(PI / m.speed)?].map(|state| state.wiper());
    let swing = left.angle - right.angle;
    assert!((swing - 2.0 * m.crank_length / m.radius).abs() < 1e-14);
    println!("swings through {:.2}°\n", swing.to_degrees());
    Ok(())
}

fn assert_rolling(m: &Wiper, turn: &[State]) {
    let velocities = |state: &State| (state.wiper().angular_velocity * m.radius, -m.B(state).rate.x);
    assert!(largest_difference(turn.iter().map(velocities)) < 1e-15);
}

fn print(turn: &[State]) {
    println!("crank °   rack mm   wiper °   wiper rad/s   wiper rad/s²");
    for state in turn.iter().step_by(15) {
        let (crank, rack, wiper) = (state.crank(), state.rack(), state.wiper());
        println!(
            "{:7.1}   {:7.3}   {:7.3}   {:11.4}   {:12.3}",
            crank.angle.to_degrees(),
            rack.position.x * 1e3,
            wiper.angle.to_degrees(),
            wiper.angular_velocity,
            wiper.angular_acceleration
        );
    }
}
