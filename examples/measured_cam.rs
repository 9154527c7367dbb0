//! A cam known by measurement only: the follower's lift at 24 angles, read to 0.01 mm.
//!
//! ```text
//!     ───┬───  flat follower           measured every 15°, h(ψ) to 0.01 mm
//!     ( cam )                          law behind it: 32 + 4 cos ψ + 0.6 cos 2ψ mm
//! ```
//!
//! Two followers ride on it. One uses a spline through the numbers, `table(…, periodic)`; the other a Rust function that returns value,
//! first and second derivative, here the first harmonics of the same numbers. Both reproduce the lift within the reading error. But the
//! spline's acceleration follows every rounding of the dial, while that of the harmonics is smooth.
//!
//! The exact law is known here, and both followers are checked against it.
//!
//! Source: R. L. Norton, Cam Design and Manufacturing Handbook, for the flat follower; the readings are invented.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};

use reuleaux::picture::Drawable;
use reuleaux::{Real, mechanism};
use reuleaux_examples::{largest_difference, show, steps};

/// The lift at 0°, 15°, … 345° as read, in mm.
const MEASURED: [f64; 24] = [
    36.60, 36.38, 35.76, 34.83, 33.70, 32.52, 31.40, 30.44, 29.70, 29.17, 28.84, 28.66, //
    28.60, 28.66, 28.84, 29.17, 29.70, 30.44, 31.40, 32.52, 33.70, 34.83, 35.76, 36.38,
];

/// Number of harmonics above the noise.
const HARMONICS: i32 = 3;

/// Lift (m) at ψ (rad) with its first and second derivative: the first harmonics of the numbers.
pub fn smoothed<T: Real>(psi: T) -> (T, T, T) {
    psi.map(harmonics)
}

fn harmonics(psi: f64) -> (f64, f64, f64) {
    let count = MEASURED.len() as f64;
    let mean = MEASURED.iter().sum::<f64>() / count;
    let mut lift = (mean * 1e-3, 0.0, 0.0);
    for k in (1..=HARMONICS).map(f64::from) {
        let angles = (0..24).map(|i| k * TAU * f64::from(i) / count);
        let (a, b) = MEASURED.iter().zip(angles).fold((0.0, 0.0), |(a, b), (y, angle)| (a + y * angle.cos(), b + y * angle.sin()));
        let (a, b, (sin, cos)) = (a * 2e-3 / count, b * 2e-3 / count, (k * psi).sin_cos());
        let wave = a * cos + b * sin;
        lift = (lift.0 + wave, lift.1 + k * (b * cos - a * sin), lift.2 - k * k * wave);
    }
    lift
}

mechanism! {
    /// One cam with two flat followers that use different laws.
    #[picture]
    pub mechanism MeasuredCam {
        param speed: AngularVelocity = 600rpm;

        function smooth(Angle) -> Length = crate::smoothed;
        function spline(psi: Angle) -> Length = 1mm * table(psi / 15deg, [
            (0, 36.60), (1, 36.38), (2, 35.76), (3, 34.83), (4, 33.70), (5, 32.52),
            (6, 31.40), (7, 30.44), (8, 29.70), (9, 29.17), (10, 28.84), (11, 28.66),
            (12, 28.60), (13, 28.66), (14, 28.84), (15, 29.17), (16, 29.70), (17, 30.44),
            (18, 31.40), (19, 32.52), (20, 33.70), (21, 34.83), (22, 35.76), (23, 36.38), (24, 36.60),
        ], periodic);

        ground {
            point O = (0mm, 0mm);
            axis up = (0, 1);
        }
        body cam { point O = (0mm, 0mm); }
        body a { point C = (0mm, 0mm);  axis n = (0, 1);  start position = (0mm, 35mm); }
        body b { point C = (0mm, 0mm);  axis n = (0, 1);  start position = (0mm, 35mm); }

        joint shaft = revolute(ground.O, cam.O);
        joint guide_a = translational(ground.up, ground.O, a.C);
        joint guide_b = translational(ground.up, ground.O, b.C);
        joint contact_a = cam_flat(cam.O, a.C, a.n, smooth);
        joint contact_b = cam_flat(cam.O, b.C, b.n, spline);
        drive motor = drive_angle(cam, speed * t);

        output smooth_lift = a.y;
        output spline_lift = b.y;
    }
}

type State = MeasuredCamState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = MeasuredCam::default();
    let turn: Vec<State> = mechanism.sweep(steps(0.0, 0.1, 360)).collect::<Result<_, _>>()?;

    assert_harmonics(&mechanism, &turn);
    print_errors(&mechanism, &turn);
    print(&mechanism, &turn);
    let view = mechanism
        .view(turn)
        .title("Measured cam with flat follower")
        .over("cam", "°", |state| state.cam().angle.to_degrees())
        .plot("lift by harmonics", "mm", |state| mechanism.smooth_lift(state).value * 1e3)
        .and("by a spline", |state| mechanism.spline_lift(state).value * 1e3)
        .against("as read", read)
        .plot("acceleration by harmonics", "m/s²", |state| mechanism.smooth_lift(state).acceleration)
        .and("by a spline", |state| mechanism.spline_lift(state).acceleration)
        .against("exact law", |state| law(&mechanism, seen(state)).1)
        .plot("error of the harmonics", "m/s²", |state| mechanism.smooth_lift(state).acceleration - law(&mechanism, seen(state)).1)
        .and("of the spline", |state| mechanism.spline_lift(state).acceleration - law(&mechanism, seen(state)).1);
    show("measured_cam", &view, 55, &[])
}

/// The reading of the dial (mm), at every 15° of the cam.
fn read(state: &State) -> f64 {
    let place = state.cam().angle.to_degrees() / 15.0;
    if (place - place.round()).abs() < 1e-6 { MEASURED[(30 - place.round() as usize) % 24] } else { f64::NAN }
}

/// Angle of the follower's normal in the cam (rad), which decreases as the cam rotates.
fn seen(state: &State) -> f64 {
    FRAC_PI_2 - state.cam().angle
}

/// Lift (m) and acceleration (m/s²) by the exact law.
fn law(m: &MeasuredCam, psi: f64) -> (f64, f64) {
    let lift = 32.0 + 4.0 * psi.cos() + 0.6 * (2.0 * psi).cos();
    let curvature = -4.0 * psi.cos() - 2.4 * (2.0 * psi).cos();
    (lift * 1e-3, curvature * 1e-3 * m.speed * m.speed)
}

/// The first follower moves according to the Rust function and its derivatives.
fn assert_harmonics(m: &MeasuredCam, turn: &[State]) {
    for state in turn {
        let (solved, (value, slope, curvature)) = (m.smooth_lift(state), harmonics(seen(state)));
        assert!((solved.value - value).abs() < 1e-15);
        assert!((solved.rate + slope * m.speed).abs() < 1e-14);
        assert!((solved.acceleration - curvature * m.speed * m.speed).abs() < 1e-11);
    }
}

/// Both lifts stay within half a division of the dial; the harmonics' acceleration is far more accurate.
fn print_errors(m: &MeasuredCam, turn: &[State]) {
    let lifts = |of: fn(&MeasuredCam, &State) -> f64| largest_difference(turn.iter().map(|state| (of(m, state), law(m, seen(state)).0)));
    let accelerations =
        |of: fn(&MeasuredCam, &State) -> f64| largest_difference(turn.iter().map(|state| (of(m, state), law(m, seen(state)).1)));
    let [smooth, spline] = [lifts(|m, state| m.smooth_lift(state).value), lifts(|m, state| m.spline_lift(state).value)];
    println!("            lift off by   acceleration off by");
    let noise = accelerations(|m, state| m.smooth_lift(state).acceleration);
    println!("harmonics   {:8.2} µm   {noise:14.2} m/s²", smooth * 1e6);
    let noisy = accelerations(|m, state| m.spline_lift(state).acceleration);
    println!("spline      {:8.2} µm   {noisy:14.2} m/s²\n", spline * 1e6);
    assert!(smooth < 5e-6 && spline < 8e-6);
    assert!(noise < 0.2 && noisy > 1.0);
}

fn print(m: &MeasuredCam, turn: &[State]) {
    println!("cam °   lift mm   speed m/s   acceleration m/s²: harmonics   spline    exact");
    for state in turn.iter().step_by(20) {
        let (smooth, spline, exact) = (m.smooth_lift(state), m.spline_lift(state), law(m, seen(state)).1);
        println!(
            "{:5.0}   {:7.3}   {:9.4}   {:28.2}   {:6.2}   {exact:6.2}",
            state.cam().angle.to_degrees(),
            smooth.value * 1e3,
            smooth.rate,
            smooth.acceleration,
            spline.acceleration
        );
    }
}
