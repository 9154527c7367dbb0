//! A two-stage gear train: nine turns of the motor give one turn of the turret.
//!
//! ```text
//!   motor 20 ──── 60 ┐ one shaft
//!                 18 ┘──── 54 turret         i = (60/20) (54/18) = 9
//! ```
//!
//! A law with smooth ends rotates the motor by `turns`; the turret stops after a ninth of that angle, for any number of turns, since
//! angles are never wrapped. Each stage reverses the sense of rotation, so that two restore it.
//!
//! The ratio is checked after nine million turns, and the meshes by the speeds of both pitch circles at their contact.
//! Source: the law of gearing; module 4 mm.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux_examples::{figure, largest_difference, play, steps};

mechanism! {
    /// A positioning drive.
    #[picture]
    pub mechanism Positioner {
        param turns: Angle = 9turn;
        param duration: Time = 3s;
        let module = 4mm;

        ground {
            point A = (0mm, 0mm);
            point B = (module * (20 + 60) / 2, 0mm);
            point C = (module * (20 + 60) / 2, module * (18 + 54) / 2);
        }
        body motor  { point A = (0mm, 0mm); }
        body middle { point B = (0mm, 0mm); }
        body turret { point C = (0mm, 0mm);  point P = (120mm, 0mm); }

        joint a = revolute(ground.A, motor.A);
        joint b = revolute(ground.B, middle.B);
        joint c = revolute(ground.C, turret.C);
        joint first = gear_pair(motor, middle, 20, 60);
        joint second = gear_pair(middle, turret, 18, 54);
        drive control = drive_angle(motor, turns * polynomial_345(t / duration));

        output P = turret.P;
    }
}

type State = PositionerState<f64>;

/// Module (m).
const MODULE: f64 = 0.004;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Positioner::default();
    let motion: Vec<State> = mechanism.sweep(steps(0.0, 3.0, 150)).collect::<Result<_, _>>()?;

    assert_ratio()?;
    assert_rolling(&motion);
    print(&motion);
    figure("gear_train", &view(&mechanism, motion), 50, &[])?;
    // One turn of the motor, slow enough to be seen.
    let slow = Positioner { turns: TAU, ..mechanism };
    let motion: Vec<State> = slow.sweep(steps(0.0, 3.0, 120)).collect::<Result<_, _>>()?;
    play("gear_train", &view(&slow, motion))
}

fn view(m: &Positioner, motion: Vec<State>) -> View<State> {
    m.view(motion)
        .title("Two-stage gear train")
        .trace("path of P", |state| m.P(state).value)
        .plot("turret", "°", |state| state.turret().angle.to_degrees())
        .against("a ninth of the motor", |state| state.motor().angle.to_degrees() / 9.0)
        .plot("motor", "rpm", |state| state.motor().angular_velocity * 60.0 / TAU)
        .and("middle shaft", |state| state.middle().angular_velocity * 60.0 / TAU)
        .and("turret", |state| state.turret().angular_velocity * 60.0 / TAU)
}

/// The turret rotates by a ninth, to the last bit.
fn assert_ratio() -> Result<(), Box<dyn Error>> {
    for turns in [1.0, 9.0, 9e6] {
        let mechanism = Positioner { turns: turns * TAU, ..Default::default() };
        let mut states = mechanism.sweep([0.0, mechanism.duration]);
        let end = states.by_ref().last().ok_or("no state")??;
        assert!((end.turret().angle * 9.0 / end.motor().angle - 1.0).abs() < 4.0 * f64::EPSILON);
        assert!(end.motor().angle == turns * TAU && end.motor().angular_velocity == 0.0);
    }
    Ok(())
}

/// Where two pitch circles touch, they have the same velocity.
fn assert_rolling(motion: &[State]) {
    let speed = |teeth: f64, angular_velocity: f64| teeth * MODULE / 2.0 * angular_velocity;
    let rates = |s: &State| [s.motor(), s.middle(), s.turret()].map(|body| body.angular_velocity);
    let pairs = motion
        .iter()
        .map(rates)
        .flat_map(|[motor, middle, turret]| [(speed(20.0, motor), -speed(60.0, middle)), (speed(18.0, middle), -speed(54.0, turret))]);
    assert!(largest_difference(pairs) < 1e-15);
}

fn print(motion: &[State]) {
    println!("time s   motor turns   turret °   motor rpm   middle rpm   turret rpm");
    let rpm = |rate: f64| rate * 60.0 / TAU;
    for s in motion.iter().step_by(15) {
        let (motor, middle, turret) = (s.motor(), s.middle(), s.turret());
        let speeds = [motor, middle, turret].map(|body| rpm(body.angular_velocity));
        println!(
            "{:6.1}   {:11.4}   {:8.2}   {:9.2}   {:10.2}   {:10.2}",
            s.t,
            motor.angle / TAU,
            turret.angle.to_degrees(),
            speeds[0],
            speeds[1],
            speeds[2]
        );
    }
}
