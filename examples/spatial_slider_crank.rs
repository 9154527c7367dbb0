//! A slider-crank in space: the crank rotates in a plane across the direction of the slider, and a rod connects them by a ball joint at
//! one end and a universal joint at the other.
//!
//! ```text
//!     ╭─○ A  crank about an axis along x, at (b, c) beside the slider's line
//!     ╰o ╲
//!         ╲  rod l
//!   ───────[B]───── x
//! ```
//!
//! With the crank's angle θ from z
//!
//! ```text
//! A = (0, b − r sin θ, c + r cos θ)          x² = l² − A_y² − A_z²
//! ```
//!
//! and speed and acceleration of the slider follow by differentiation.
//!
//! Source of the lengths: E. J. Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 10.2.

use std::error::Error;

use reuleaux::mechanism;
use reuleaux::nalgebra::Vector3;
use reuleaux::picture::Drawable;
use reuleaux_examples::{largest_difference, show, steps};

mechanism! {
    /// A crank whose axis is parallel to the line of its slider.
    #[picture]
    pub mechanism SpatialSliderCrank in space {
        param speed: AngularVelocity = 60rpm;
        param crank_length: Length = 80mm;
        param rod_length: Length = 300mm;

        ground {
            point axle = (0mm, 100mm, 120mm);
            axis axle_line = (1, 0, 0) from (0, 0, 1);
            axis way = (1, 0, 0) from (0, 1, 0);
        }
        body crank {
            axis line = (1, 0, 0) from (0, 0, 1);
            point A = (0mm, 0mm, crank_length);
        }
        body rod {
            point B = (rod_length, 0mm, 0mm);
            axis cross = (0, 1, 0);
        }
        body slider {
            axis cross = (0, 0, 1);
            axis way = (1, 0, 0) from (0, 1, 0);
            start position = (200mm, 0mm, 0mm);
        }

        joint axle = revolute(ground.axle, ground.axle_line, crank.position, crank.line);
        joint ball = spherical(crank.A, rod.position);
        joint hooke = universal(rod.B, rod.cross, slider.position, slider.cross);
        joint rail = translational(ground.position, ground.way, slider.position, slider.way);
        drive motor = drive_rotation(axle, speed * t);

        output angle = axle.angle;
        output travel = rail.displacement;
        output A = crank.A;
        output B = rod.B;
    }
}

type State = SpatialSliderCrankState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = SpatialSliderCrank::default();
    let turn: Vec<State> = mechanism.sweep(steps(0.0, 1.0, 180)).collect::<Result<_, _>>()?;

    assert_travel(&mechanism, &turn);
    assert_rod(&mechanism, &turn);
    print(&mechanism, &turn);
    let view = mechanism
        .view(turn)
        .title("Slider-crank in space")
        .over("crank", "°", |state| mechanism.angle(state).value.to_degrees())
        .trace("path of A", |state| mechanism.A(state).value)
        .plot("travel", "mm", |state| mechanism.travel(state).value * 1e3)
        .against("closed form", |state| travel(&mechanism, mechanism.angle(state).value)[0] * 1e3)
        .plot("speed", "m/s", |state| mechanism.travel(state).rate)
        .against("closed form", |state| travel(&mechanism, mechanism.angle(state).value)[1])
        .plot("acceleration", "m/s²", |state| mechanism.travel(state).acceleration)
        .against("closed form", |state| travel(&mechanism, mechanism.angle(state).value)[2]);
    show("spatial_slider_crank", &view, 20, &[50, 80, 110, 140])
}

/// Travel (m), speed and acceleration of the slider at the crank's angle θ (rad).
fn travel(m: &SpatialSliderCrank, angle: f64) -> [f64; 3] {
    let ((sin, cos), r) = (angle.sin_cos(), m.crank_length);
    let (y, z) = (0.1 - r * sin, 0.12 + r * cos);
    let x = (m.rod_length.powi(2) - y * y - z * z).sqrt();
    // x x' = −(y y' + z z'), and its derivative.
    let slope = (y * r * cos + z * r * sin) / x;
    let curvature = (-y * r * sin + z * r * cos - r * r - slope * slope) / x;
    [x, slope * m.speed, curvature * m.speed.powi(2)]
}

fn assert_travel(m: &SpatialSliderCrank, turn: &[State]) {
    for (order, unit) in [1.0, m.speed, m.speed.powi(2)].into_iter().map(|factor| factor * m.crank_length).enumerate() {
        let solved = |state| [m.travel(state).value, m.travel(state).rate, m.travel(state).acceleration][order];
        let error = largest_difference(turn.iter().map(|state| (solved(state) / unit, travel(m, m.angle(state).value)[order] / unit)));
        assert!(error < 4e-14, "derivative {order} of the travel is {error:e} off");
    }
}

/// The rod keeps its length, the speeds of its ends along it agree, and its universal joint keeps a right angle.
fn assert_rod(m: &SpatialSliderCrank, turn: &[State]) {
    for state in turn {
        let (a, b) = (m.A(state), m.B(state));
        let rod = b.value - a.value;
        assert!((rod.norm() - m.rod_length).abs() < 1e-15);
        assert!((rod.dot(&(b.rate - a.rate)) / (m.rod_length * m.crank_length * m.speed)).abs() < 1e-14);
        assert!(state.rod().vector(Vector3::y()).value.z.abs() < 1e-15);
    }
}

fn print(m: &SpatialSliderCrank, turn: &[State]) {
    println!("crank °   travel mm   speed m/s   acceleration m/s²   rod's angular velocity rad/s");
    for state in turn.iter().step_by(15) {
        let (travel, omega) = (m.travel(state), state.rod().angular_velocity);
        println!(
            "{:7.1}   {:9.3}   {:9.4}   {:17.3}   {:7.3} {:7.3} {:7.3}",
            m.angle(state).value.to_degrees(),
            travel.value * 1e3,
            travel.rate,
            travel.acceleration,
            omega.x,
            omega.y,
            omega.z
        );
    }
}
