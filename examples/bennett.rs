//! Bennett's linkage: four bars and four hinges, no two of them parallel, and yet it moves.
//!
//! ```text
//!      b, β
//!   ○────────○         opposite bars are equal: lengths a and b, and twists α and β, the angles between
//!   │        │ a, α    the hinges at their ends
//!   ○────────○
//! ```
//!
//! In space four hinges leave a loop of four bars no freedom: 3 · 6 coordinates and 4 · 5 equations. Bennett found in 1903 that it has
//! one if a / sin α = b / sin β. Then three equations are redundant in every position, as `redundant joint` declares; they are checked,
//! and if a bar is slightly too long the solver reports the misfit. The angles θ and φ of the hinges at the ends of a bar with twist β
//! satisfy
//!
//! ```text
//! tan(θ/2) tan(φ/2) = sin((α + β)/2) / sin((α − β)/2)
//! ```
//!
//! and the angles of opposite hinges add up to a full turn.
//!
//! Source: G. T. Bennett, A new mechanism, Engineering 76 (1903); J. M. McCarthy, Geometric Design of Linkages.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::nalgebra::Vector3;
use reuleaux::picture::Drawable;
use reuleaux::{Cause, mechanism};
use reuleaux_examples::{Abscissa, Diagram, Ink, Plate, Scene, seen, show, steps};

mechanism! {
    /// Bennett's linkage with a hinge driven at constant speed.
    #[picture]
    pub mechanism Bennett in space {
        param length: Length = 100mm;
        param twist: Angle = 40deg;
        param other_twist: Angle = 70deg;
        /// Excess length of a bar.
        param excess: Length = 0mm;
        param speed: AngularVelocity = 60rpm;
        let other = length * sin(other_twist) / sin(twist);

        // The hinges of each bar: one at its origin along z, the other at its end. Angles are measured from the bar.
        ground {
            axis z = (0, 0, 1) from (1, 0, 0);
            point end = (length, 0mm, 0mm);
            axis end_z = (0, -sin(twist), cos(twist)) from (1, 0, 0);
        }
        body second {
            axis z = (0, 0, 1) from (1, 0, 0);
            point end = (other, 0mm, 0mm);
            axis end_z = (0, -sin(other_twist), cos(other_twist)) from (1, 0, 0);
        }
        body third {
            axis z = (0, 0, 1) from (1, 0, 0);
            point end = (length + excess, 0mm, 0mm);
            axis end_z = (0, -sin(twist), cos(twist)) from (1, 0, 0);
        }
        body fourth {
            axis z = (0, 0, 1) from (1, 0, 0);
            point end = (other, 0mm, 0mm);
            axis end_z = (0, -sin(other_twist), cos(other_twist)) from (1, 0, 0);
            start orientation = turn((0, 0, 1), -60deg) * turn((1, 0, 0), -other_twist);
        }

        joint one = revolute(ground.end, ground.end_z, second.position, second.z);
        joint two = revolute(second.end, second.end_z, third.position, third.z);
        joint three = revolute(third.end, third.end_z, fourth.position, fourth.z);
        redundant joint four = revolute(fourth.end, fourth.end_z, ground.position, ground.z);
        drive motor = drive_rotation(one, 60deg + speed * t);

        output driven = one.angle;
        output next = two.angle;
        output opposite = three.angle;
        output A = ground.end;
        output B = second.end;
        output C = third.end;
    }
}

type State = BennettState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Bennett::default();
    let turn: Vec<State> = mechanism.sweep(steps(0.0, 1.0, 181)).collect::<Result<_, _>>()?;

    for (twist, other_twist) in [(40_f64, 70_f64), (30.0, 110.0), (55.0, 80.0)] {
        let m = Bennett { twist: twist.to_radians(), other_twist: other_twist.to_radians(), ..mechanism };
        // Through the instants at which the linkage lies flat, too, where the rows that are solved are singular.
        for count in [181, 180] {
            assert_angles(&m, &m.sweep(steps(0.0, 1.0, count)).collect::<Result<Vec<State>, _>>()?);
        }
    }
    assert!(matches!(Bennett { excess: 1e-3, ..mechanism }.solve(0.0).map_err(|failure| failure.cause), Err(Cause::DoesNotHold { .. })));
    print(&mechanism, &turn);
    println!("{}", picture(&mechanism, &turn).save("bennett")?.display());
    let view = mechanism
        .view(turn)
        .trace("path of B", |state| mechanism.B(state).value)
        .trace("path of C", |state| mechanism.C(state).value)
        .plot("its speed over the drive's", "", |state| mechanism.next(state).rate / mechanism.speed)
        .and("Bennett's relation", |state| next(&mechanism, mechanism.driven(state).value)[1]);
    show("bennett", &view)?;
    Ok(())
}

/// The product of the tangents of half the angles of two neighbouring hinges.
fn product(m: &Bennett) -> f64 {
    ((m.other_twist + m.twist) / 2.0).sin() / ((m.twist - m.other_twist) / 2.0).sin()
}

/// Angle (rad) of the next hinge, and the ratio of its speed to that of the driven hinge.
fn next(m: &Bennett, angle: f64) -> [f64; 2] {
    let (sin, cos) = (angle / 2.0).sin_cos();
    let k = product(m);
    [2.0 * (k * cos).atan2(sin), -k / (sin * sin + k * k * cos * cos)]
}

/// Angles of opposite hinges add up to a turn, neighbours satisfy Bennett's relation. Angles are compared modulo whole turns.
fn assert_angles(m: &Bennett, turn: &[State]) {
    for state in turn {
        let [driven, after, opposite] = [m.driven(state), m.next(state), m.opposite(state)];
        let [angle, speed] = next(m, driven.value);
        // Rounding errors grow towards the flat position.
        let flat = driven.value.sin().abs().max(1e-3);
        let errors = [apart(after.value, angle), apart(opposite.value, -driven.value), after.rate / m.speed - speed];
        assert!(errors.iter().all(|error| error.abs() < 4e-14 / flat), "off by {errors:?} at t = {}", state.t);
    }
}

/// Difference of two angles, between −π and π.
fn apart(one: f64, two: f64) -> f64 {
    (one - two).sin().atan2((one - two).cos())
}

fn print(m: &Bennett, turn: &[State]) {
    println!("driven °   next hinge °   opposite °   tan(θ/2) tan(φ/2)");
    for state in turn.iter().step_by(13) {
        let [driven, after, opposite] = [m.driven(state), m.next(state), m.opposite(state)].map(|angle| angle.value);
        let product = (driven / 2.0).tan() * (after / 2.0).tan();
        println!("{:8.2}   {:12.3}   {:10.3}   {product:.12}", driven.to_degrees(), after.to_degrees(), opposite.to_degrees());
    }
    println!("sin((α + β)/2) / sin((α − β)/2) = {:.12}", product(m));
}

fn picture(m: &Bennett, turn: &[State]) -> Plate {
    let mut scene = Scene::new();
    for state in turn.iter().step_by(30).skip(1) {
        scene.faint(|scene| draw(scene, m, state));
    }
    for point in [Bennett::B, Bennett::C] {
        scene.line(Ink::Trace, turn.iter().map(|state| seen(&point(m, state).value)));
    }
    draw(&mut scene, m, &turn[8]);
    hinges(&mut scene, m, &turn[8]);

    let driven = |state: &State| m.driven(state).value.to_degrees();
    let dots =
        |part: usize, unit: f64| turn.iter().step_by(7).map(move |state| (driven(state), next(m, m.driven(state).value)[part] * unit));
    let degrees = 360.0 / TAU;
    Plate::new("Bennett's linkage", scene, Abscissa { name: "angle of the driven hinge in °", range: 60.0..420.0, step: 60.0 })
        .diagram(
            Diagram::new("next hinge in °")
                .curve(Ink::Output, "reuleaux", turn.iter().map(|state| (driven(state), m.next(state).value.to_degrees())))
                .circles("Bennett's relation", unwrapped(dots(0, degrees))),
        )
        .diagram(
            Diagram::new("its speed over the drive's")
                .curve(Ink::Output, "", turn.iter().map(|state| (driven(state), m.next(state).rate / m.speed)))
                .circles("", dots(1, 1.0)),
        )
}

/// Angles in degrees without jumps, starting below zero.
fn unwrapped(angles: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut last = -160.0;
    angles
        .map(|(at, angle)| {
            last = angle + 360.0 * ((last - angle) / 360.0).round();
            (at, last)
        })
        .collect()
}

/// The four bars.
fn draw(scene: &mut Scene, m: &Bennett, state: &State) {
    let corners = [Vector3::zeros(), m.A(state).value, m.B(state).value, m.C(state).value].map(|corner| seen(&corner));
    for (ink, [from, to]) in [(Ink::Ground, [0, 1]), (Ink::Coupler, [2, 3]), (Ink::Output, [3, 0]), (Ink::Input, [1, 2])] {
        scene.link(ink, &[corners[from], corners[to]]);
    }
}

/// The axes of the hinges.
fn hinges(scene: &mut Scene, m: &Bennett, state: &State) {
    let axes = [
        Vector3::z(),
        state.second().vector(Vector3::z()).value,
        state.third().vector(Vector3::z()).value,
        state.fourth().vector(Vector3::z()).value,
    ];
    let corners = [Vector3::zeros(), m.A(state).value, m.B(state).value, m.C(state).value];
    for (corner, axis) in corners.iter().zip(&axes) {
        scene.dashes(Ink::Ground, seen(&(corner - axis * 0.04)), seen(&(corner + axis * 0.04)));
    }
}
