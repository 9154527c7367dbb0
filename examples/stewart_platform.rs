//! A Stewart platform: six legs with driven lengths give a platform any position and tilt.
//!
//! ```text
//!      p────p          platform
//!     ╱╲    ╱╲
//!    ╱  ╲  ╱  ╲        six legs
//!   b────b────b        base
//! ```
//!
//! The lengths for a wanted motion follow in closed form: |c + R p − b| for each leg. The mechanism is given these lengths as functions
//! of time only, and must reproduce the motion: six equations in six unknowns, with forty assemblies. The platform moves on a circle,
//! rises and falls, and rotates about a skew axis; position, orientation, velocities and accelerations are checked.
//!
//! Source: D. Stewart, A platform with six degrees of freedom, Proc. Inst. Mech. Eng. 180 (1965); the lengths are invented.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::mechanism;
use reuleaux::nalgebra::{Rotation3, Unit, Vector3};
use reuleaux::picture::Drawable;
use reuleaux_examples::{show, steps};

mechanism! {
    /// A platform on six cylinders.
    #[picture]
    pub mechanism StewartPlatform in space {
        let base = 600mm;
        let top = 350mm;
        // The wanted motion: position of the centre, and the angle about an axis.
        let phase = 1turn * t / 4s;
        let place = (60mm * sin(phase), 60mm * (1 - cos(phase)), 700mm + 50mm * sin(2 * phase));
        let roll = 15deg * sin(phase);
        let n = unit((1, 2, 2));

        ground {
            for k in 0..3 {
                point B[2 * k] = (base * cos(120deg * k - 20deg), base * sin(120deg * k - 20deg), 0mm);
                point B[2 * k + 1] = (base * cos(120deg * k + 20deg), base * sin(120deg * k + 20deg), 0mm);
            }
        }
        body platform {
            for k in 0..3 {
                point P[2 * k] = (top * cos(120deg * k - 45deg), top * sin(120deg * k - 45deg), -50mm);
                point P[2 * k + 1] = (top * cos(120deg * k + 45deg), top * sin(120deg * k + 45deg), -50mm);
            }
            start position = (0mm, 0mm, 700mm);
        }

        for k in 0..3 {
            let p[2 * k] = (top * cos(120deg * k - 45deg), top * sin(120deg * k - 45deg), -50mm);
            let p[2 * k + 1] = (top * cos(120deg * k + 45deg), top * sin(120deg * k + 45deg), -50mm);
        }
        for i in 0..6 {
            let end[i] = place + p[i] * cos(roll) + cross(n, p[i]) * sin(roll) + n * dot(n, p[i]) * (1 - cos(roll));
            drive leg[i] = drive_distance(ground.B[i], platform.P[i], norm(end[i] - ground.B[i]));
        }

        output middle = platform.position;
        for i in 0..6 { output length[i] = norm(platform.P[i] - ground.B[i]); }
        for i in 0..6 { output P[i] = platform.P[i]; }
        for i in 0..6 { output B[i] = ground.B[i]; }
    }
}

type State = StewartPlatformState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}\n", StewartPlatform::<f64>::PLAN);
    let mechanism = StewartPlatform::default();
    let motion: Vec<State> = mechanism.sweep(steps(0.0, 4.0, 200)).collect::<Result<_, _>>()?;

    motion.iter().for_each(assert_motion);
    print(&mechanism, &motion);
    let view = mechanism.view(motion).title("Stewart platform").trace("path of the centre", |state| mechanism.middle(state).value).plot(
        "leg 1",
        "mm",
        |state| mechanism.length(state)[0].value * 1e3,
    );
    let view = (1..6).fold(view, |view, k| view.and(&(k + 1).to_string(), |state| mechanism.length(state)[k].value * 1e3));
    let view = view
        .plot("height", "mm", |state| mechanism.middle(state).value.z * 1e3)
        .against("wanted", |state| wanted(state.t)[0].0.z * 1e3)
        .plot("tilt", "°", |state| ((state.platform().rotation.trace() - 1.0) / 2.0).clamp(-1.0, 1.0).acos().to_degrees())
        .against("wanted", |state| wanted(state.t)[0].1.abs().to_degrees());
    show("stewart_platform", &view, 30, &[130])
}

/// Wanted position (m) and angle (rad) at a time, with their first and second derivatives.
fn wanted(t: f64) -> [(Vector3<f64>, f64); 3] {
    let speed = TAU / 4.0;
    let ((sin, cos), (sin2, cos2)) = ((speed * t).sin_cos(), (2.0 * speed * t).sin_cos());
    let roll = 15_f64.to_radians();
    [
        (Vector3::new(0.06 * sin, 0.06 * (1.0 - cos), 0.7 + 0.05 * sin2), roll * sin),
        (Vector3::new(0.06 * cos, 0.06 * sin, 0.1 * cos2) * speed, roll * cos * speed),
        (Vector3::new(-0.06 * sin, 0.06 * cos, -0.2 * sin2) * speed.powi(2), -roll * sin * speed.powi(2)),
    ]
}

/// The platform performs the wanted motion.
fn assert_motion(state: &State) {
    let platform = state.platform();
    let axis = Unit::new_normalize(Vector3::new(1.0, 2.0, 2.0));
    let [(place, roll), (velocity, rate), (acceleration, change)] = wanted(state.t);
    let off = [
        (platform.position - place).norm(),
        (platform.rotation - Rotation3::from_axis_angle(&axis, roll).matrix()).norm(),
        (platform.velocity - velocity).norm(),
        (platform.angular_velocity - *axis * rate).norm(),
        (platform.acceleration - acceleration).norm(),
        (platform.angular_acceleration - *axis * change).norm(),
    ];
    assert!(off.iter().zip([1e-14, 2e-14, 4e-14, 4e-14, 2e-13, 2e-13]).all(|(off, bound)| *off < bound), "off by {off:?} at {}", state.t);
}

fn print(m: &StewartPlatform, motion: &[State]) {
    println!("time s   x mm      y mm      z mm      lengths mm");
    for state in motion.iter().step_by(20) {
        let middle = m.middle(state).value * 1e3;
        let lengths = m.length(state).map(|length| format!("{:7.2}", length.value * 1e3));
        println!("{:6.2}   {:7.2}   {:7.2}   {:7.2}   {}", state.t, middle.x, middle.y, middle.z, lengths.join(" "));
    }
}
