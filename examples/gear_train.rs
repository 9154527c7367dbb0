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
use std::f64::consts::{PI, TAU};

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_examples::{Abscissa, Diagram, Ink, Plate, Scene, gear, largest_difference, meshing, polar, show, steps};

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
    println!("{}", picture(&mechanism, &motion).save("gear_train")?.display());
    // One turn of the motor, slow enough to be seen.
    let slow = Positioner { turns: TAU, ..mechanism };
    let motion: Vec<State> = slow.sweep(steps(0.0, 3.0, 120)).collect::<Result<_, _>>()?;
    let view = slow
        .view(motion)
        .trace("path of P", |state| slow.P(state).value)
        .plot("turret", "°", |state| state.turret().angle.to_degrees())
        .and("a ninth of the motor", |state| state.motor().angle.to_degrees() / 9.0)
        .plot("motor", "rpm", |state| state.motor().angular_velocity * 60.0 / TAU)
        .and("middle shaft", |state| state.middle().angular_velocity * 60.0 / TAU)
        .and("turret", |state| state.turret().angular_velocity * 60.0 / TAU);
    show("gear_train", &view)?;
    Ok(())
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

fn picture(m: &Positioner, motion: &[State]) -> Plate {
    let mut scene = Scene::new();
    draw(&mut scene, &motion[50]);
    scene.line(Ink::Trace, motion[..=50].iter().map(|state| m.P(state).value));
    let [a, b, c] = [motion[0].motor(), motion[0].middle(), motion[0].turret()].map(|body| body.position);
    scene.pivot(a).pivot(b).pivot(c).pin(m.P(&motion[50]).value);
    scene.name(a, "motor, 20", [-2.0, -50.0]).name(b, "60 and 18", [0.0, -56.0]).name(c, "turret, 54", [0.0, 28.0]);

    let over = |of: fn(&State) -> f64| motion.iter().map(move |state| (state.t, of(state)));
    let rpm = 60.0 / TAU;
    let speed = |of: fn(&State) -> f64| over(of).map(move |(t, rate)| (t, rate * rpm));
    Plate::new("Two-stage gear train", scene, Abscissa { name: "time in s", range: 0.0..3.0, step: 0.5 })
        .diagram(Diagram::new("turret in °").curve(Ink::Output, "", over(|state| state.turret().angle.to_degrees())))
        .diagram(
            Diagram::new("speeds in rpm")
                .curve(Ink::Input, "motor", speed(|state| state.motor().angular_velocity))
                .curve(Ink::Coupler, "middle", speed(|state| state.middle().angular_velocity))
                .curve(Ink::Output, "turret", speed(|state| state.turret().angular_velocity)),
        )
}

fn draw(scene: &mut Scene, state: &State) {
    let (motor, middle, turret) = (state.motor(), state.middle(), state.turret());
    let first = meshing(0.0, 20.0, 60.0, 0.0);
    let second = meshing(PI / 2.0, 18.0, 54.0, 0.0);
    scene.surface(Ink::Input, gear(motor.position, 20, MODULE, motor.angle));
    scene.surface(Ink::Coupler, gear(middle.position, 60, MODULE, middle.angle + first));
    scene.surface(Ink::Output, gear(turret.position, 54, MODULE, turret.angle + second));
    scene.surface(Ink::Coupler, gear(middle.position, 18, MODULE, middle.angle));
    scene.dashes(Ink::Output, turret.position, turret.position + polar(0.12, turret.angle));
}
