//! A disc cam designed by its motion: a slide that moves with constant velocity for a third of its rise, as beside a moving web.
//!
//! ```text
//!        │ │ slide, offset e          0° …  40°   from rest to the velocity of the web
//!        ( C ) roller, radius ρ      40° …  80°   constant velocity
//!       ╱  │  ╲                      80° … 120°   to rest
//!      │   O   │ cam                120° … 160°   dwell above
//!       ╲_____╱                     160° … 280°   return, modified sine
//!                                   280° … 360°   dwell below
//! ```
//!
//! The declaration says how the slide moves; the cam that moves it so is computed from the states: pitch curve, surface, pressure angle,
//! curvature, and the path of the milling cutter. The lift is checked against the same program in plain Rust, the pressure angle and the
//! radius of curvature against the formulas of handbooks, the surface against the roller, which touches it and nowhere enters it.
//!
//! ```text
//!   tan α = (s′ − e) / (s + √(R² − e²))
//!   r = ((R + s)² + s′²)^(3/2) / ((R + s)² + 2 s′² − (R + s) s″)          for e = 0
//! ```
//!
//! Source: R. L. Norton, Cam Design and Manufacturing Handbook, chapters 2, 3 and 7; H. Rothbart, Cam Design Handbook, chapter 2.

use std::error::Error;
use std::f64::consts::{PI, TAU};

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux_cam::{CamError, CurvePoint};
use reuleaux_examples::{Place, place, rectangle, round, show, steps};

/// Radii of the roller and of the cutter (m).
const ROLLER: f64 = 0.012;
const CUTTER: f64 = 0.010;

mechanism! {
    /// The slide of a packing machine.
    #[picture]
    pub mechanism SlideCam {
        param speed: AngularVelocity = 120rpm;
        /// Radius of the pitch curve at the lowest lift.
        param prime: Length = 52mm;
        param offset: Length = 8mm;
        param lift: Length = 24mm;

        function program(u: Angle) -> Length = segments(u, 0mm, [
            rise(lift / 4, 40deg, half_cycloidal_start),
            rise(lift / 2, 40deg, linear),
            rise(lift / 4, 40deg, half_cycloidal_end),
            dwell(40deg),
            fall(lift, 120deg, modified_sine),
            dwell(80deg),
        ], periodic);

        ground {
            point O = (0mm, 0mm);
            axis up = (0, 1);
        }
        body cam { point O = (0mm, 0mm); }
        body slide { point C = (0mm, 0mm);  start position = (offset, prime); }

        joint shaft = revolute(ground.O, cam.O);
        joint guide = translational(ground.up, (offset, 0mm), slide.C);
        joint contact = { slide.y == sqrt(prime^2 - offset^2) + program(cam.angle); }
        drive motor = drive_angle(cam, speed * t);

        output O = cam.O;
        output C = slide.C;
        output travel = slide.y with jerk;
    }
}

type State = SlideCamState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let offset = SlideCam::default();
    let central = SlideCam { offset: 0.0, ..offset };
    assert_lift(&offset)?;
    assert_pressure_angle(&offset)?;
    assert_curvature(&central)?;
    assert_surface(&offset)?;
    print_limits(&offset, &central)?;
    print_cutter(&offset)?;
    let outline = surface(&offset, &turn(&offset)?)?;
    let pitch_curve = turn(&offset)?.iter().map(|state| Ok(pitch(&offset, state)?.point)).collect::<Result<Vec<Place>, CamError>>()?;
    let states = turn(&offset)?.into_iter().zip(turn(&central)?).step_by(2);
    let view = View::new("Cam designed by segments", states, |(state, _)| state.t, |(state, _)| offset.scene(state))
        .over("cam", "°", |(state, _)| state.cam().angle.to_degrees())
        .outline("cam", outline.into_iter().step_by(6))
        .outline("cam", pitch_curve.into_iter().step_by(6))
        .outline("slide", round(ROLLER))
        .outline("slide", rectangle(place(0.0, 0.03), 0.0, 0.014, 0.06))
        .plot("lift", "mm", |(state, _)| (offset.travel(state).value - (offset.prime.powi(2) - offset.offset.powi(2)).sqrt()) * 1e3)
        .against("formula", |(state, _)| lift(&offset, state.cam().angle)[0] * 1e3)
        .plot("pressure angle", "°", |(state, _)| pressure_angle(&offset, state).map_or(f64::NAN, f64::to_degrees))
        .and("without offset", |(_, state)| pressure_angle(&central, state).map_or(f64::NAN, f64::to_degrees))
        .against("formula", |(state, _)| pressure_formula(&offset, state.cam().angle).to_degrees())
        .plot("curvature without offset", "1/mm", |(_, state)| pitch(&central, state).map_or(f64::NAN, |pitch| pitch.curvature * 1e-3))
        .against("formula", |(_, state)| 1e-3 / radius_formula(&central, state.cam().angle));
    show("cam_design", &view, 55, &[])
}

/// Lift (m) at the cam's angle (rad) with its first three derivatives by the angle.
fn lift(m: &SlideCam, angle: f64) -> [f64; 4] {
    let degrees = angle.to_degrees().rem_euclid(360.0);
    let (part, whole) = (40_f64.to_radians(), 120_f64.to_radians());
    let over = |height: f64, duration: f64, [s, v, a, j]: [f64; 4]| {
        [height * s, height * v / duration, height * a / (duration * duration), height * j / (duration * duration * duration)]
    };
    let half = |u: f64, sign: f64| {
        let (sine, cosine) = (PI * u).sin_cos();
        [u + sign * sine / PI, 1.0 + sign * cosine, -sign * PI * sine, -sign * PI * PI * cosine]
    };
    let raised = |above: f64, [s, v, a, j]: [f64; 4]| [above * m.lift + s, v, a, j];
    match degrees {
        d if d < 40.0 => over(m.lift / 4.0, part, half(d / 40.0, -1.0)),
        d if d < 80.0 => raised(0.25, over(m.lift / 2.0, part, [(d - 40.0) / 40.0, 1.0, 0.0, 0.0])),
        d if d < 120.0 => raised(0.75, over(m.lift / 4.0, part, half((d - 80.0) / 40.0, 1.0))),
        d if d < 160.0 => [m.lift, 0.0, 0.0, 0.0],
        d if d < 280.0 => raised(1.0, over(-m.lift, whole, modified_sine((d - 160.0) / 120.0))),
        _ => [0.0; 4],
    }
}

/// The modified sine as printed in handbooks.
fn modified_sine(u: f64) -> [f64; 4] {
    let a = PI / (4.0 + PI);
    match u {
        u if !(0.125..0.875).contains(&u) => {
            let (sine, cosine) = (4.0 * PI * u).sin_cos();
            let start = if u < 0.5 { 0.0 } else { 4.0 / (4.0 + PI) };
            [start + a * u - sine / (4.0 * (4.0 + PI)), a * (1.0 - cosine), 4.0 * PI * a * sine, 16.0 * PI * PI * a * cosine]
        }
        u => {
            let (sine, cosine) = (4.0 * PI * u / 3.0 + PI / 3.0).sin_cos();
            let jerk = 16.0 * PI * PI * a * cosine / 3.0;
            [2.0 / (4.0 + PI) + a * u - 9.0 * sine / (4.0 * (4.0 + PI)), a * (1.0 - 3.0 * cosine), 4.0 * PI * a * sine, jerk]
        }
    }
}

/// States of one turn, between the borders of the segments.
fn turn(m: &SlideCam) -> Result<Vec<State>, Box<dyn Error>> {
    let angles = steps(0.1, 359.6, 719).map(|degrees| degrees.to_radians() / m.speed);
    Ok(m.sweep(angles).collect::<Result<_, _>>()?)
}

/// Three turns of the cam against the program in Rust, derivatives up to the jerk included.
fn assert_lift(m: &SlideCam) -> Result<(), Box<dyn Error>> {
    let low = (m.prime * m.prime - m.offset * m.offset).sqrt();
    let of_turns = steps(0.0, 2.999, 997).map(|turns| turns * TAU / m.speed);
    for state in m.sweep(of_turns) {
        let state = state?;
        let (found, [s, v, a, j]) = (m.travel(&state), lift(m, state.cam().angle));
        assert!((found.value - low - s).abs() < 1e-15);
        assert!((found.rate - v * m.speed).abs() < 1e-12 && (found.acceleration - a * m.speed * m.speed).abs() < 1e-10);
        assert!((found.jerk - j * m.speed.powi(3)).abs() < 1e-8);
    }
    Ok(())
}

/// The point of the pitch curve at a state.
fn pitch(m: &SlideCam, state: &State) -> Result<CurvePoint, CamError> {
    CurvePoint::relative(&state.cam(), &m.C(state))
}

/// Angle from the guide to the normal (rad).
fn pressure_angle(m: &SlideCam, state: &State) -> Result<f64, CamError> {
    Ok(pitch(m, state)?.pressure_angle(CurvePoint::direction(&state.cam(), place(0.0, 1.0))))
}

fn pressure_formula(m: &SlideCam, angle: f64) -> f64 {
    let [s, slope, ..] = lift(m, angle);
    ((slope - m.offset) / (s + (m.prime * m.prime - m.offset * m.offset).sqrt())).atan()
}

fn assert_pressure_angle(m: &SlideCam) -> Result<(), Box<dyn Error>> {
    for state in turn(m)? {
        assert!((pressure_angle(m, &state)? - pressure_formula(m, state.cam().angle)).abs() < 1e-13);
    }
    Ok(())
}

/// Radius of curvature of the pitch curve of a follower without offset (m).
fn radius_formula(m: &SlideCam, angle: f64) -> f64 {
    let [s, slope, bend, _] = lift(m, angle);
    let r = m.prime + s;
    (r * r + slope * slope).powf(1.5) / (r * r + 2.0 * slope * slope - r * bend)
}

fn assert_curvature(m: &SlideCam) -> Result<(), Box<dyn Error>> {
    for state in turn(m)? {
        let (pitch, radius) = (pitch(m, &state)?, radius_formula(m, state.cam().angle));
        assert!((pitch.curvature * radius - 1.0).abs() < 1e-11);
        // The surface has the radius of the pitch curve less that of the roller.
        assert!((pitch.surface(ROLLER)?.radius_of_curvature() / (radius - ROLLER) - 1.0).abs() < 1e-9);
    }
    Ok(())
}

/// The roller touches the surface and nowhere enters it.
fn assert_surface(m: &SlideCam) -> Result<(), Box<dyn Error>> {
    let turn = turn(m)?;
    let surface = surface(m, &turn)?;
    for state in turn.iter().step_by(12) {
        let centre = pitch(m, state)?.point;
        let nearest = surface.iter().map(|point| (point - centre).norm()).fold(f64::INFINITY, f64::min);
        assert!((nearest - ROLLER).abs() < 1e-15);
    }
    Ok(())
}

fn surface(m: &SlideCam, turn: &[State]) -> Result<Vec<Place>, CamError> {
    turn.iter().map(|state| Ok(pitch(m, state)?.surface(ROLLER)?.point)).collect()
}

/// The largest pressure angles of the rise with and without offset, and the largest roller.
fn print_limits(offset: &SlideCam, central: &SlideCam) -> Result<(), Box<dyn Error>> {
    let worst = |m: &SlideCam| -> Result<f64, Box<dyn Error>> {
        let rising = turn(m)?.into_iter().filter(|state| state.cam().angle < TAU / 3.0);
        let angles: Vec<f64> = rising.map(|state| pressure_angle(m, &state)).collect::<Result<_, _>>()?;
        Ok(angles.into_iter().fold(0.0, f64::max).to_degrees())
    };
    let (with, without) = (worst(offset)?, worst(central)?);
    assert!(with < without - 5.0);
    let jerks = turn(offset)?.into_iter().map(|state| offset.travel(&state).jerk.abs());
    println!("largest jerk: {:.0} m/s³", jerks.fold(0.0, f64::max));
    println!("largest pressure angle of the rise: {without:.2}° over the cam's axis, {with:.2}° beside it");
    let points: Vec<CurvePoint> = turn(offset)?.iter().map(|state| pitch(offset, state)).collect::<Result<_, _>>()?;
    let sharpest = points.iter().filter(|point| point.curvature > 0.0).map(CurvePoint::radius_of_curvature).fold(f64::INFINITY, f64::min);
    let refused = points.iter().find_map(|point| point.surface(sharpest).err());
    let Some(refused @ CamError::Undercut { .. }) = refused else { return Err("a roller that undercuts is refused".into()) };
    println!("{refused}\n");
    Ok(())
}

/// The first lines of the file for the milling machine.
fn print_cutter(m: &SlideCam) -> Result<(), Box<dyn Error>> {
    println!("{}", CurvePoint::COLUMNS);
    for state in turn(m)?.iter().step_by(40) {
        println!("{}", pitch(m, state)?.surface(ROLLER)?.cutter(CUTTER)?);
    }
    println!();
    Ok(())
}
