//! An industrial robot in forward and inverse kinematics: a UR5 with its six hinges driven, and the same arm with its tool on a circle.
//!
//! ```text
//!        ○═══════○           six hinges in a row; frames and lengths after Denavit and Hartenberg:
//!        ║       ║ ○═○       link i stands on link i − 1 by Rz(θ) Tz(d) Tx(a) Rx(α)
//!        ○       ○═╝ ╚▷
//!     ═══╩═══
//! ```
//!
//! The forward kinematics need no iteration. The position of the tool follows from the product of the six transformations, its velocity
//! and acceleration from sums over the hinges,
//!
//! ```text
//! ω = Σ θ̇ z          ω̇ = Σ (θ̈ z + θ̇ ω′ × z)          v = Σ θ̇ z × (p − o)
//! ```
//!
//! In the inverse kinematics, drives prescribe the tool: three its position, and a joint its orientation. The six angles are solved
//! together; the product of the transformations gives the wanted position again.
//!
//! Source of the lengths: Universal Robots, DH parameters of the UR5.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};

use reuleaux::nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use reuleaux::picture::Drawable;
use reuleaux::{Motion, SpatialBody, mechanism};
use reuleaux_examples::{show, steps};

mechanism! {
    /// A UR5 with a motor in each hinge.
    pub mechanism Robot in space {
        ground { axis z = (0, 0, 1) from (1, 0, 0); }

        part arm[0] = Link(ground.position, ground.z, 0mm, 89.159mm, 90deg);
        part arm[1] = Link(arm[0].link.position, arm[0].link.z, -425mm, 0mm, 0deg);
        part arm[2] = Link(arm[1].link.position, arm[1].link.z, -392.25mm, 0mm, 0deg);
        part arm[3] = Link(arm[2].link.position, arm[2].link.z, 0mm, 109.15mm, 90deg);
        part arm[4] = Link(arm[3].link.position, arm[3].link.z, 0mm, 94.65mm, -90deg);
        part arm[5] = Link(arm[4].link.position, arm[4].link.z, 0mm, 82.3mm, 0deg);

        /// A link on its hinge: offset `d` along the axis of the hinge, then `a` outwards, with the next axis rotated by `twist`.
        component Link(foot: Point, z: Axis, a: Length, d: Length, twist: Angle) {
            body link {
                point foot = (-a, -d * sin(twist), -d * cos(twist));
                axis foot_z = (0, sin(twist), cos(twist)) from (1, 0, 0);
                axis z = (0, 0, 1) from (1, 0, 0);
            }
            joint hinge = revolute(foot, z, link.foot, link.foot_z);
            output angle = hinge.angle;
        }

        drive one = drive_rotation(arm[0].hinge, 0.3 + 0.8 * sin(1.5rad_s * t));
        drive two = drive_rotation(arm[1].hinge, -1.2 + 0.5 * sin(2rad_s * t));
        drive three = drive_rotation(arm[2].hinge, 1 + 0.6 * sin(1.7rad_s * t));
        drive four = drive_rotation(arm[3].hinge, -0.5 + 0.9 * sin(2.5rad_s * t));
        drive five = drive_rotation(arm[4].hinge, 1.2 + 0.5 * sin(3rad_s * t));
        drive six = drive_rotation(arm[5].hinge, 2rad_s * t);

        output tool = arm[5].link;
    }
}

mechanism! {
    /// The same arm with its tool prescribed, pointing down throughout.
    #[picture]
    pub mechanism LedRobot in space {
        let turn = 1turn * t / 4s;

        ground {
            axis z = (0, 0, 1) from (1, 0, 0);
            axis down = (0, 0, -1) from (0, -1, 0);
        }

        // Of the eight solutions, the one with the elbow above.
        part arm[0] = Link(ground.position, ground.z, 0mm, 89.159mm, 90deg, 0mm, 0mm, 90mm);
        part arm[1] = Link(arm[0].link.position, arm[0].link.z, -425mm, 0mm, 0deg, 140mm, 50mm, 490mm);
        part arm[2] = Link(arm[1].link.position, arm[1].link.z, -392.25mm, 0mm, 0deg, 460mm, 170mm, 290mm);
        part arm[3] = Link(arm[2].link.position, arm[2].link.z, 0mm, 109.15mm, 90deg, 490mm, 60mm, 290mm);
        part arm[4] = Link(arm[3].link.position, arm[3].link.z, 0mm, 94.65mm, -90deg, 580mm, 100mm, 290mm);
        part arm[5] = Link(arm[4].link.position, arm[4].link.z, 0mm, 82.3mm, 0deg, 580mm, 100mm, 210mm);

        /// A link as above, with the approximate position of its origin.
        component Link(foot: Point, z: Axis, a: Length, d: Length, twist: Angle, x: Length, y: Length, height: Length) {
            body link {
                point foot = (-a, -d * sin(twist), -d * cos(twist));
                axis foot_z = (0, sin(twist), cos(twist)) from (1, 0, 0);
                axis z = (0, 0, 1) from (1, 0, 0);
                start position = (x, y, height);
            }
            joint hinge = revolute(foot, z, link.foot, link.foot_z);
            output angle = hinge.angle;
        }

        drive x = drive_x(arm[5].link.position, 500mm + 120mm * cos(turn));
        drive y = drive_y(arm[5].link.position, 100mm + 120mm * sin(turn));
        drive z = drive_z(arm[5].link.position, 200mm + 30mm * sin(2 * turn));
        joint level = absolute_orientation(ground.down, arm[5].link.z);

        output tool = arm[5].link;
    }
}

/// a, d (m) and α (rad) of each link.
const LINKS: [[f64; 3]; 6] = [
    [0.0, 0.089159, FRAC_PI_2],
    [-0.425, 0.0, 0.0],
    [-0.39225, 0.0, 0.0],
    [0.0, 0.10915, FRAC_PI_2],
    [0.0, 0.09465, -FRAC_PI_2],
    [0.0, 0.0823, 0.0],
];

type Turn = Motion<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let robot = Robot::default();
    for state in robot.sweep(steps(0.0, 10.0, 400)) {
        let state = state?;
        assert_forwards(&robot.arm_angle(&state), &robot.tool(&state));
    }

    let led = LedRobot::default();
    let circle: Vec<LedRobotState<f64>> = led.sweep(steps(0.0, 4.0, 200)).collect::<Result<_, _>>()?;
    for state in &circle {
        assert_backwards(&led.arm_angle(state), state.t);
        assert_forwards(&led.arm_angle(state), &led.tool(state));
    }
    print(&led, &circle);
    let view = led.view(circle).title("Robot arm, led by its tool").trace("path of the tool", |state| led.tool(state).position);
    let view = view.plot("hinge 1", "°", |state| led.arm_angle(state)[0].value.to_degrees());
    let view = (1..6).fold(view, |view, k| view.and(&(k + 1).to_string(), |state| led.arm_angle(state)[k].value.to_degrees()));
    let view = view.plot("speed of hinge 1", "rad/s", |state| led.arm_angle(state)[0].rate);
    let view = (1..6).fold(view, |view, k| view.and(&(k + 1).to_string(), |state| led.arm_angle(state)[k].rate));
    let view =
        view.plot("x of the tool", "mm", |state| led.tool(state).position.x * 1e3).against("wanted", |state| wanted(state.t)[0].x * 1e3);
    show("robot_arm", &view, 20, &[80, 140])
}

/// The six frames by the product of the transformations, from the angles.
fn frames(angles: &[Turn; 6]) -> [Isometry3<f64>; 6] {
    let mut frame = Isometry3::identity();
    let (x, z) = (Vector3::x_axis(), Vector3::z_axis());
    std::array::from_fn(|i| {
        let [a, d, twist] = LINKS[i];
        let turned = UnitQuaternion::from_axis_angle(&z, angles[i].value);
        let tilted = UnitQuaternion::from_axis_angle(&x, twist);
        frame *= Isometry3::from_parts(Translation3::from(turned * Vector3::new(a, 0.0, d)), turned * tilted);
        frame
    })
}

/// Angular velocity and velocity of the tool, and their rates, by sums over the hinges.
fn twist(angles: &[Turn; 6]) -> [Vector3<f64>; 4] {
    let frames = frames(angles);
    let [mut omega, mut alpha, mut velocity, mut acceleration] = [Vector3::zeros(); 4];
    let (mut foot, mut axis) = (Vector3::zeros(), Vector3::z());
    for (angle, frame) in angles.iter().zip(frames) {
        alpha += axis * angle.acceleration + omega.cross(&axis) * angle.rate;
        omega += axis * angle.rate;
        let arm = frame.translation.vector - foot;
        velocity += omega.cross(&arm);
        acceleration += alpha.cross(&arm) + omega.cross(&omega.cross(&arm));
        (foot, axis) = (frame.translation.vector, frame.rotation * Vector3::z());
    }
    [omega, velocity, alpha, acceleration]
}

/// Position and motion of the tool agree with the angles of the hinges.
fn assert_forwards(angles: &[Turn; 6], tool: &SpatialBody<f64>) {
    let end = frames(angles)[5];
    let [omega, velocity, alpha, acceleration] = twist(angles);
    let off = [
        (tool.position - end.translation.vector).norm(),
        (tool.rotation - end.rotation.to_rotation_matrix().matrix()).norm(),
        (tool.angular_velocity - omega).norm(),
        (tool.velocity - velocity).norm(),
        (tool.angular_acceleration - alpha).norm(),
        (tool.acceleration - acceleration).norm(),
    ];
    assert!(off.iter().zip([2e-15, 4e-15, 2e-14, 2e-14, 1e-13, 1e-13]).all(|(off, bound)| off < &bound), "off by {off:?}");
}

/// Wanted position of the tool (m), its velocity and its acceleration.
fn wanted(t: f64) -> [Vector3<f64>; 3] {
    let speed = TAU / 4.0;
    let ((sin, cos), (sin2, cos2)) = ((speed * t).sin_cos(), (2.0 * speed * t).sin_cos());
    [
        Vector3::new(0.5 + 0.12 * cos, 0.1 + 0.12 * sin, 0.2 + 0.03 * sin2),
        Vector3::new(-0.12 * sin, 0.12 * cos, 0.06 * cos2) * speed,
        Vector3::new(-0.12 * cos, -0.12 * sin, -0.12 * sin2) * speed.powi(2),
    ]
}

/// The solved angles lead to the wanted position, with the tool pointing down and not rotating.
fn assert_backwards(angles: &[Turn; 6], t: f64) {
    let end = frames(angles)[5];
    let [place, velocity, acceleration] = wanted(t);
    let [omega, found_velocity, alpha, found_acceleration] = twist(angles);
    let down = end.rotation * Vector3::z() + Vector3::z();
    let aside = end.rotation * Vector3::x() + Vector3::y();
    let off = [
        (end.translation.vector - place).norm(),
        down.norm().max(aside.norm()),
        (found_velocity - velocity).norm().max(omega.norm()),
        (found_acceleration - acceleration).norm().max(alpha.norm()),
    ];
    assert!(off.iter().zip([4e-15, 4e-15, 1e-14, 4e-14]).all(|(off, bound)| off < &bound), "off by {off:?} at t = {t}");
}

fn print(m: &LedRobot, circle: &[LedRobotState<f64>]) {
    println!("time s   angles of the hinges in °");
    for state in circle.iter().step_by(20) {
        let angles = m.arm_angle(state).map(|angle| format!("{:8.3}", angle.value.to_degrees()));
        println!("{:6.2}   {}", state.t, angles.join("  "));
    }
}
