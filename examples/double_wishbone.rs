//! A double wishbone suspension: how a front wheel leans and steers as it rises and falls.
//!
//! ```text
//!    ═══o────o C            the upright hangs on two ball joints, B and C, at the ends of the wishbones, and
//!            ║ ┌┐           is kept from turning about them by the tie rod to T, whose other end S the steering
//!            ╠═││ W         holds still
//!    ══o─────o B└┘
//! ```
//!
//! Every place follows in closed form from the angle of the lower wishbone: C is where the circle that it describes about the upper
//! hinge meets the sphere about B, T is where three spheres meet, about B, C and S, and the upright is where B, C and T are.
//!
//! Coordinates are those of the car as it stands: x forward, y to the left, z up. Camber is the angle by which the wheel leans outward at
//! its top, toe the angle by which its front points inward.
//!
//! Source of the terms: W. F. Milliken and D. L. Milliken, Race Car Vehicle Dynamics, chapter 17.

use std::error::Error;

use reuleaux::mechanism;
use reuleaux::nalgebra::{Matrix3, Vector3};
use reuleaux_examples::{Abscissa, Diagram, Ink, Plate, Scene, ring, seen, steps};

mechanism! {
    /// The left front wheel of a car, moved up and down by a test bench.
    pub mechanism Wishbones in space {
        /// By which the wheel moves up and down.
        param travel: Length = 80mm;
        /// Height of the inner end of the tie rod.
        param rack_height: Length = 206mm;

        ground {
            point lower = (120mm, 400mm, 180mm);
            axis lower_hinge = (-280, 0, 10);
            point upper = (80mm, 450mm, 425mm);
            axis upper_hinge = (-180, 0, -15);
            point S = (-120mm, 420mm, rack_height);
            axis x = (1, 0, 0);
            axis y = (0, 1, 0);
            axis z = (0, 0, 1);
        }
        // All frames lie in that of the car as it stands.
        body lower {
            point hinge = (120mm, 400mm, 180mm);
            axis hinge_line = (-280, 0, 10);
            point B = (5mm, 750mm, 170mm);
        }
        body upper {
            point hinge = (80mm, 450mm, 425mm);
            axis hinge_line = (-180, 0, -15);
            point C = (-15mm, 715mm, 450mm);
        }
        body upright {
            point B = (5mm, 750mm, 170mm);
            point C = (-15mm, 715mm, 450mm);
            point T = (-110mm, 735mm, 200mm);
            point W = (0mm, 780mm, 300mm);
            axis spindle = (0, 1, 0);
        }

        joint lower_hinge = revolute(ground.lower, ground.lower_hinge, lower.hinge, lower.hinge_line);
        joint upper_hinge = revolute(ground.upper, ground.upper_hinge, upper.hinge, upper.hinge_line);
        joint lower_ball = spherical(lower.B, upright.B);
        joint upper_ball = spherical(upper.C, upright.C);
        joint tie_rod = distance(ground.S, upright.T, sqrt((10mm)^2 + (315mm)^2 + (206mm - 200mm)^2));
        drive bench = drive_z(upright.W, 300mm + travel * sin(1rad_s * t));

        output rise = upright.W.z - 300mm;
        output camber = -asin(dot(upright.spindle, ground.z));
        output toe = atan2(dot(upright.spindle, ground.x), dot(upright.spindle, ground.y));
        output lower_angle = lower_hinge.angle;
        output B = upright.B;
        output C = upright.C;
        output T = upright.T;
        output W = upright.W;
        output contact = upright.W.y;
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Wishbones::<f64>::PLAN);
    let m = Wishbones::default();
    for state in m.sweep(steps(-1.5, 1.5, 12)) {
        let state = state?;
        println!("{:?} {:?} {:?}", m.rise(&state).value, m.camber(&state).value.to_degrees(), m.toe(&state).value.to_degrees());
    }
    let _ = (Matrix3::<f64>::zeros(), Vector3::<f64>::zeros(), Abscissa { name: "", range: 0.0..1.0, step: 1.0 }, Diagram::new(""), Ink::Ground, Scene::new(), ring, seen);
    let _: Option<Plate> = None;
    Ok(())
}
