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
use reuleaux::nalgebra::Vector3;
use reuleaux::picture::Drawable;
use reuleaux_examples::{Abscissa, Diagram, Ink, Plate, Scene, largest_difference, ring, seen, show, steps};

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
    println!("{}", picture(&good, &bad, &turns).save("cardan_shaft")?.display());
    let [cured, _] = turns;
    let view = good
        .view(cured)
        .plot("middle shaft ahead", "°", |state| (good.between(state).value - good.driven(state).value).to_degrees())
        .and("closed form", |state| (exact(&good, good.driven(state).value)[0][0] - good.driven(state).value).to_degrees())
        .and("output ahead", |state| (good.delivered(state).value - good.driven(state).value).to_degrees());
    show("cardan_shaft", &view)?;
    Ok(())
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

fn picture(good: &CardanShaft, bad: &CardanShaft, [cured, doubled]: &[Vec<State>; 2]) -> Plate {
    let mut scene = Scene::new();
    draw(&mut scene, good, &cured[20]);

    let degrees = |state: &State| good.driven(state).value.to_degrees();
    let lead = |m: &CardanShaft, state: &State, of: fn(&CardanShaft, &State) -> f64| (of(m, state) - m.driven(state).value).to_degrees();
    let middle: fn(&CardanShaft, &State) -> f64 = |m, state| m.between(state).value;
    let end: fn(&CardanShaft, &State) -> f64 = |m, state| m.delivered(state).value - m.phase;
    let circles = |m: CardanShaft, of: fn(&CardanShaft, f64) -> f64| {
        cured.iter().step_by(6).map(move |state| (degrees(state), of(&m, degrees(state).to_radians()))).collect::<Vec<_>>()
    };
    Plate::new("Cardan shaft", scene, Abscissa { name: "angle of the input in °", range: 0.0..360.0, step: 60.0 })
        .diagram(
            Diagram::new("ahead in °")
                .curve(Ink::Coupler, "middle", cured.iter().map(|state| (degrees(state), lead(good, state, middle))))
                .curve(Ink::Output, "output", cured.iter().map(|state| (degrees(state), lead(good, state, end))))
                .curve(Ink::Second, "output, a fork 90° off", doubled.iter().map(|state| (degrees(state), lead(bad, state, end))))
                .circles("closed form", circles(*good, |m, angle| (exact(m, angle)[0][0] - angle).to_degrees())),
        )
        .diagram(
            Diagram::new("speed over input")
                .curve(Ink::Coupler, "", cured.iter().map(|state| (degrees(state), good.between(state).rate / good.speed)))
                .curve(Ink::Output, "", cured.iter().map(|state| (degrees(state), good.delivered(state).rate / good.speed)))
                .curve(Ink::Second, "", doubled.iter().map(|state| (degrees(state), bad.delivered(state).rate / bad.speed)))
                .circles("", circles(*good, |m, angle| exact(m, angle)[0][1]))
                .circles("", circles(*bad, |m, angle| exact(m, angle)[1][1])),
        )
}

/// Shafts as links, forks as rings in the plane of their arms.
fn draw(scene: &mut Scene, m: &CardanShaft, state: &State) {
    let [near, far] = [Vector3::zeros(), m.end(state).value];
    let out = Vector3::x() * 0.2;
    for (ink, from, to) in [(Ink::Input, near - out, near), (Ink::Coupler, near, far), (Ink::Output, far, far + out)] {
        scene.link(ink, &[seen(&from), seen(&to)]);
    }
    let arm = |local: Vector3<f64>, body: reuleaux::SpatialBody<f64>| body.vector(local).value * 0.045;
    let (y, z) = (Vector3::y(), Vector3::z());
    for (ink, centre, arm) in [
        (Ink::Input, near, arm(z, state.input())),
        (Ink::Coupler, near, arm(y, state.middle())),
        (Ink::Coupler, far, arm(y, state.middle())),
        (Ink::Output, far, arm(z, state.output())),
    ] {
        scene.line(ink, [seen(&(centre - arm)), seen(&(centre + arm))]);
        scene.disc(ink, seen(&(centre - arm)), 0.008).disc(ink, seen(&(centre + arm)), 0.008);
    }
    for centre in [near - out * 0.8, far + out * 0.8] {
        scene.surface(Ink::Ground, ring(&centre, &Vector3::x(), 0.03));
    }
    scene.name(seen(&(near - out)), "input", [0.0, 18.0]).name(seen(&(far + out)), "output", [0.0, -18.0]);
}
