//! Bennett's linkage: four bars, four hinges, no two of them parallel, and still it moves.
//!
//! ```text
//!      b, β
//!   ○────────○         opposite bars are alike: lengths a and b, and twists α and β, the angles between
//!   │        │ a, α    the hinges at their ends
//!   ○────────○
//! ```
//!
//! In space four hinges leave a loop of four bars no freedom at all: 3 · 6 coordinates, and 4 · 5 equations. Bennett found in 1903 that
//! there is one if a / sin α = b / sin β. Then three equations are too many in every position, which `redundant joint` says; they are
//! checked, and with a bar that is a little too long the solver says by how much it does not fit. The angles θ and φ of neighbouring
//! hinges keep to
//!
//! ```text
//! tan(θ/2) tan(φ/2) = sin((β + α)/2) / sin((β − α)/2)
//! ```
//!
//! and those of opposite hinges add up to a turn.
//!
//! Source: G. T. Bennett, A new mechanism, Engineering 76 (1903); J. M. McCarthy, Geometric Design of Linkages.

use std::error::Error;
use std::f64::consts::{PI, TAU};

use reuleaux::mechanism;
use reuleaux_examples::{Abscissa, Diagram, Ink, Plate, Scene, largest_difference, seen, steps};

mechanism! {
    /// Bennett's linkage with a hinge driven at constant speed.
    pub mechanism Bennett in space {
        param length: Length = 100mm;
        param twist: Angle = 40deg;
        param other_twist: Angle = 70deg;
        /// By which a bar is too long.
        param excess: Length = 0mm;
        param speed: AngularVelocity = 60rpm;
        let other = length * sin(other_twist) / sin(twist);

        // The hinges of each bar: one at its origin along z, the other at its end. Angles count from along the bar.
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

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Bennett::<f64>::PLAN);
    let m = Bennett::default();
    for state in m.sweep(steps(0.0, 1.0, 12)) {
        let state = state?;
        println!("{:?} {:?} {:?}", m.driven(&state).value, m.next(&state), m.opposite(&state));
    }
    println!("{:?}", Bennett { excess: 1e-3, ..m }.solve(0.0).map_err(|e| e.to_string()));
    let _ = (PI, TAU, Abscissa { name: "", range: 0.0..1.0, step: 1.0 }, Diagram::new(""), Ink::Ground, Scene::new(), largest_difference([]), seen);
    let _: Option<Plate> = None;
    Ok(())
}
