//! A disc cam with a roller follower that dwells above and below: rise, dwell, return, dwell.
//!
//! ```text
//!       │ │ follower
//!       ( C ) roller, radius ρ          0° … 120°   rise, cycloidal
//!      ╱     ╲                        120° … 180°   dwell above
//!     │   O   │ cam                   180° … 300°   return, 3-4-5 polynomial
//!      ╲_____╱                        300° … 360°   dwell below
//! ```
//!
//! The law is a function of the cam's angle u, wrapped to one turn by the arc tangent of its own sine and cosine. The lift is checked
//! against the same law in plain Rust, the peaks against tabulated values: velocity 2 and acceleration 2π of the cycloid, 15/8 and 10/√3
//! of the polynomial.
//!
//! Source: R. L. Norton, Cam Design and Manufacturing Handbook, chapters 2, 3 and 7.

use std::error::Error;
use std::f64::consts::{PI, TAU};

use reuleaux::picture::Drawable;
use reuleaux::{Motion, mechanism};
use reuleaux_examples::{largest_difference, show, steps};

mechanism! {
    /// A valve gear, slow enough to watch.
    #[picture]
    pub mechanism RollerCam {
        param speed: AngularVelocity = 60rpm;
        param base: Length = 30mm;
        param roller: Length = 10mm;
        param lift: Length = 15mm;

        // The angle wrapped to one turn, from −30° to 330°: it jumps in the middle of the lower dwell.
        function turn(u: Angle) -> Angle = 5 * pi / 6 + atan2(sin(u - 5 * pi / 6), cos(u - 5 * pi / 6));
        function law(u: Angle) -> Length =
            lift * (cycloidal(turn(u) / 120deg) - polynomial_345((turn(u) - 180deg) / 120deg));
        // Relative to the cam, the follower moves backwards, starting at a quarter of a turn.
        function outline(psi: Angle) -> Length = base + law(90deg - psi);

        ground {
            point O = (0mm, 0mm);
            axis up = (0, 1);
        }
        body cam { point O = (0mm, 0mm); }
        body follower { point C = (0mm, 0mm);  start position = (0mm, base + roller); }

        joint shaft = revolute(ground.O, cam.O);
        joint guide = translational(ground.up, ground.O, follower.C);
        joint contact = cam_roller(cam.O, follower.C, roller, outline);
        drive motor = drive_angle(cam, speed * t);

        output O = cam.O;
        output C = follower.C;
        output travel = follower.y;
    }
}

type State = RollerCamState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = RollerCam::default();
    let turn: Vec<State> = mechanism.sweep(steps(0.0, 1.0, 360)).collect::<Result<_, _>>()?;

    assert_lift(&mechanism)?;
    assert_peaks(&mechanism)?;
    print(&mechanism, &turn);
    let view = mechanism
        .view(turn)
        .title("Disc cam with roller follower")
        .over("cam", "°", |state| state.cam().angle.to_degrees())
        .plot("lift", "mm", |state| (mechanism.travel(state).value - mechanism.base - mechanism.roller) * 1e3)
        .against("closed form", |state| lift(&mechanism, state.cam().angle) * 1e3)
        .plot("velocity", "m/s", |state| mechanism.travel(state).rate)
        .plot("acceleration", "m/s²", |state| mechanism.travel(state).acceleration);
    show("cam_roller", &view, 75, &[])
}

/// Lift (m) at the cam's angle (rad), over any number of turns.
fn lift(m: &RollerCam, angle: f64) -> f64 {
    let degrees = angle.to_degrees().rem_euclid(360.0);
    m.lift
        * match degrees {
            d if d < 120.0 => d / 120.0 - (TAU * d / 120.0).sin() / TAU,
            d if d < 180.0 => 1.0,
            d if d < 300.0 => {
                let u = (d - 180.0) / 120.0;
                1.0 - u.powi(3) * (10.0 - 15.0 * u + 6.0 * u * u)
            }
            _ => 0.0,
        }
}

/// Three turns of the cam; the last is as accurate as the first.
fn assert_lift(m: &RollerCam) -> Result<(), Box<dyn Error>> {
    for state in m.sweep(steps(0.0, 3.0, 1000)) {
        let state = state?;
        let expected = m.base + m.roller + lift(m, state.cam().angle);
        assert!((m.travel(&state).value - expected).abs() < 1e-15);
    }
    Ok(())
}

/// Velocity is largest in the middle of a stroke; acceleration at a quarter of the cycloid, and at (1 − 1/√3)/2 of the polynomial.
fn assert_peaks(m: &RollerCam) -> Result<(), Box<dyn Error>> {
    let stroke = TAU / 3.0;
    let (velocity, acceleration) = (m.lift * m.speed / stroke, m.lift * (m.speed / stroke).powi(2));
    let at = |angle: f64| -> Result<Motion<f64>, Box<dyn Error>> { Ok(m.travel(&m.solve(angle / m.speed)?)) };
    let early = (1.0 - 1.0 / 3_f64.sqrt()) / 2.0;
    let velocities = [(at(stroke / 2.0)?.rate, 2.0 * velocity), (at(PI + stroke / 2.0)?.rate, -15.0 / 8.0 * velocity)];
    let accelerations = [
        (at(stroke / 4.0)?.acceleration, TAU * acceleration),
        (at(PI + stroke * early)?.acceleration, -10.0 / 3_f64.sqrt() * acceleration),
    ];
    assert!(largest_difference(velocities) < 1e-15 && largest_difference(accelerations) < 1e-13);
    println!(
        "peaks: {:.1} mm/s and {:.1} mm/s up, {:.1} mm/s and {:.1} mm/s² down\n",
        velocities[0].0 * 1e3,
        accelerations[0].0 * 1e3,
        velocities[1].0 * 1e3,
        accelerations[1].0 * 1e3
    );
    Ok(())
}

fn print(m: &RollerCam, turn: &[State]) {
    println!("cam °   lift mm   velocity mm/s   acceleration mm/s²");
    for state in turn.iter().step_by(20) {
        let (angle, travel) = (state.cam().angle.to_degrees(), m.travel(state));
        let lift = travel.value - m.base - m.roller;
        println!("{angle:5.0}   {:7.3}   {:13.2}   {:18.1}", lift * 1e3, travel.rate * 1e3, travel.acceleration * 1e3);
    }
}
