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

use reuleaux::picture::Drawable;
use reuleaux::{Cause, mechanism};
use reuleaux_examples::{show, steps};

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
        }

        joint one = revolute(ground.end, ground.end_z, second.position, second.z);
        joint two = revolute(second.end, second.end_z, third.position, third.z);
        joint three = revolute(third.end, third.end_z, fourth.position, fourth.z);
        redundant joint four = revolute(fourth.end, fourth.end_z, ground.position, ground.z);
        start three.angle = -60deg;
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
    let view = mechanism
        .view(turn)
        .title("Bennett's linkage")
        .over("driven hinge", "°", |state| mechanism.driven(state).value.to_degrees())
        .trace("path of B", |state| mechanism.B(state).value)
        .trace("path of C", |state| mechanism.C(state).value)
        .plot("next hinge", "°", |state| mechanism.next(state).value.to_degrees())
        .against("Bennett's relation", |state| {
            // The relation gives an angle within one turn.
            let (found, exact) = (mechanism.next(state).value, next(&mechanism, mechanism.driven(state).value)[0]);
            (exact + TAU * ((found - exact) / TAU).round()).to_degrees()
        })
        .plot("its speed over the drive's", "", |state| mechanism.next(state).rate / mechanism.speed)
        .against("Bennett's relation", |state| next(&mechanism, mechanism.driven(state).value)[1]);
    show("bennett", &view, 8, &[30, 60, 90, 120, 150])
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
