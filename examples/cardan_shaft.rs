//! A cardan shaft: one universal joint transmits the rotation unevenly, and a second one compensates if it is assembled correctly.
//!
//! ```text
//!                         ╔═══ output
//!                  β    ⟋  ψ₂
//!               ⟋ middle
//!  input ═══╗ ⟋
//!           ψ₁                  both outer shafts along x, the middle one at the angle β
//! ```
//!
//! With the angle φ₁ of the input, φ₂ of the middle shaft and φ₃ of the output
//!
//! ```text
//! tan φ₂ = cos β tan φ₁             dφ₂/dφ₁ = cos β / (1 − sin²β sin²φ₁)
//! tan (φ₂ + p) = cos β tan φ₃       p the angle between the two forks of the middle shaft
//! ```
//!
//! so that the output rotates with the input if the forks are parallel, p = 0, and is twice as uneven as the middle shaft if they are
//! offset by a quarter of a turn.
//!
//! Source: Dubbel, Taschenbuch für den Maschinenbau, on universal joints.

use std::error::Error;
use std::f64::consts::FRAC_PI_2;

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux_examples::{largest_difference, show, steps};

mechanism! {
    /// Two parallel shafts and one between them.
    #[picture]
    pub mechanism CardanShaft in space {
        /// Angle between the middle shaft and the others.
        param bend: Angle = 30deg;
        /// Phase angle between the forks of the middle shaft.
        param phase: Angle = 0deg in 0deg..=90deg;
        param speed: AngularVelocity = 60rpm;
        let length = 400mm;
        let way = (cos(bend), sin(bend), 0);

        ground {
            point bearing = (-200mm, 0mm, 0mm);
            axis x = (1, 0, 0) from (0, 0, 1);
            axis way = (cos(bend), sin(bend), 0) from (0, 0, 1);
            point end = (length * cos(bend), length * sin(bend), 0mm);
        }
        body input {
            point bearing = (-200mm, 0mm, 0mm);
            axis x = (1, 0, 0) from (0, 0, 1);
            axis arm = (0, 0, 1);
        }
        body middle {
            axis x = (1, 0, 0) from (0, 0, 1);
            axis arm = (0, 1, 0);
            point end = (length, 0mm, 0mm);
            axis far_arm = (0, cos(phase), sin(phase));
            start orientation = turn((0, 0, 1), bend);
        }
        body output {
            axis x = (1, 0, 0) from (0, 0, 1);
            axis arm = (0, 0, 1);
            start position = (length * cos(bend), length * sin(bend), 0mm);
            start orientation = turn((1, 0, 0), phase);
        }

        joint bearing = revolute(ground.bearing, ground.x, input.bearing, input.x);
        joint near = universal(input.position, input.arm, middle.position, middle.arm);
        joint far = universal(middle.end, middle.far_arm, output.position, output.arm);
        joint end = cylindrical(ground.end, ground.x, output.position, output.x);
        drive motor = drive_rotation(bearing, speed * t);

        output driven = bearing.angle;
        output between = joint_angle(ground.way, middle.x);
        output delivered = end.angle;
        output end = middle.end;
    }
}

type State = CardanShaftState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let [good, bad] = [0.0, FRAC_PI_2].map(|phase| CardanShaft { phase, ..Default::default() });
    let cured: Vec<State> = good.sweep(steps(0.0, 1.0, 180)).collect::<Result<_, _>>()?;
    let doubled: Vec<State> = bad.sweep(steps(0.0, 1.0, 180)).collect::<Result<_, _>>()?;
    let turns = [cured, doubled];

    for bend in [5_f64, 30.0, 60.0] {
        for phase in [0_f64, 35.0, 90.0] {
            assert_angles(&CardanShaft { bend: bend.to_radians(), phase: phase.to_radians(), ..Default::default() })?;
        }
    }
    assert_cure(&good, &turns[0]);
    print(&good, &bad, &turns);
    let [cured, doubled] = turns;
    let input = |state: &State| good.driven(state).value;
    let view = View::new("Cardan shaft", cured.into_iter().zip(doubled), |(state, _)| state.t, |(state, _)| good.scene(state))
        .over("input", "°", |(state, _)| input(state).to_degrees())
        .plot("middle shaft ahead", "°", |(state, _)| (good.between(state).value - input(state)).to_degrees())
        .and("output", |(state, _)| (good.delivered(state).value - input(state)).to_degrees())
        .and("output, a fork 90° off", |(_, state)| (bad.delivered(state).value - bad.phase - input(state)).to_degrees())
        .against("closed form", |(state, _)| (exact(&good, input(state))[0][0] - input(state)).to_degrees())
        .plot("speed of the middle shaft over the input's", "", |(state, _)| good.between(state).rate / good.speed)
        .and("of the output", |(state, _)| good.delivered(state).rate / good.speed)
        .and("of the output, a fork 90° off", |(_, state)| bad.delivered(state).rate / bad.speed)
        .against("closed form", |(state, _)| exact(&good, input(state))[0][1])
        .against("closed form", |(state, _)| exact(&bad, input(state))[1][1]);
    show("cardan_shaft", &view, 20, &[])
}

/// Lead (rad) of the angle behind a universal joint, whose tangent is `factor` times that of the angle before it.
fn ahead(angle: f64, factor: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    ((factor - 1.0) * sin * cos).atan2(cos * cos + factor * sin * sin)
}

/// Ratio of the speeds behind and before such a joint.
fn ratio(angle: f64, factor: f64) -> f64 {
    factor / (angle.cos().powi(2) + (factor * angle.sin()).powi(2))
}

/// Angles of the middle shaft and the output (rad), and their speeds relative to the input.
fn exact(m: &CardanShaft, input: f64) -> [[f64; 2]; 2] {
    let cos = m.bend.cos();
    let middle = input + ahead(input, cos);
    let fork = middle + m.phase;
    let speed = ratio(input, cos);
    [[middle, speed], [fork + ahead(fork, 1.0 / cos), speed * ratio(fork, 1.0 / cos)]]
}

/// Angles and speeds of both shafts over three turns.
fn assert_angles(m: &CardanShaft) -> Result<(), Box<dyn Error>> {
    for state in m.sweep(steps(0.0, 3.0, 200)) {
        let state = state?;
        let expected = exact(m, m.driven(&state).value);
        for (shaft, [angle, speed]) in [m.between(&state), m.delivered(&state)].into_iter().zip(expected) {
            let errors = [shaft.value - angle, shaft.rate / m.speed - speed];
            assert!(errors[0].abs() < 2e-14 && errors[1].abs() < 4e-14, "off by {errors:?} at {:?}", state.t);
        }
    }
    Ok(())
}

/// With parallel forks the output rotates exactly as the input, without acceleration.
fn assert_cure(m: &CardanShaft, turn: &[State]) {
    let angle = largest_difference(turn.iter().map(|state| (m.delivered(state).value, m.driven(state).value)));
    let uneven = largest_difference(turn.iter().map(|state| (m.delivered(state).acceleration / m.speed.powi(2), 0.0)));
    assert!(angle < 1e-14 && uneven < 1e-13, "off by {angle:e} and {uneven:e}");
}

fn print(good: &CardanShaft, bad: &CardanShaft, [cured, doubled]: &[Vec<State>; 2]) {
    println!("input °   middle °   output °   output ° with a fork a quarter off");
    for (one, two) in cured.iter().zip(doubled).step_by(15) {
        let angles = [good.driven(one), good.between(one), good.delivered(one), bad.delivered(two)].map(|angle| angle.value.to_degrees());
        println!("{:7.1}   {:8.3}   {:8.3}   {:8.3}", angles[0], angles[1], angles[2], angles[3] - 90.0);
    }
}
