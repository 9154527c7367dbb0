//! A body whose frame lies in its mass centre has an arm at each joint; with the frame in a joint it has one arm less.

use reuleaux::nalgebra::Vector3;
use reuleaux::{PlanStage, SpatialBody, mechanism};

mechanism! {
    /// A crank across the way of its slider. Frames lie in mass centres.
    mechanism Centered in space {
        ground { point axle = (0m, 0.1m, 0.12m);  axis x = (1, 0, 0) from (0, 0, 1); }
        body crank { axis x = (1, 0, 0) from (0, 0, 1);  point O = (0m, 0.01m, -0.04m);  point A = (0m, 0.01m, 0.04m); }
        body slider { axis x = (1, 0, 0) from (0, 0, 1);  start position = (0.2m, 0m, 0m); }
        body rod {
            axis y = (0, 1, 0);  point A = (-0.12m, 0m, 0.02m);  point B = (0.18m, 0m, 0.02m);
            start orientation = turn((1, 0, 0), -26deg) * turn((0, 1, 0), 48deg);
        }
        joint axle = revolute(ground.axle, ground.x, crank.O, crank.x);
        joint ball = spherical(crank.A, rod.A);
        joint cross_pin = universal(slider.position, slider.x, rod.B, rod.y);
        joint rail = translational(ground.position, ground.x, slider.position, slider.x);
        drive motor = drive_rotation(axle, 1turn * t / 1s);
    }
}

mechanism! {
    /// The same mechanism. The rod's frame lies in a joint.
    mechanism Jointed in space {
        ground { point axle = (0m, 0.1m, 0.12m);  axis x = (1, 0, 0) from (0, 0, 1); }
        body crank { axis x = (1, 0, 0) from (0, 0, 1);  point O = (0m, 0.01m, -0.04m);  point A = (0m, 0.01m, 0.04m); }
        body slider { axis x = (1, 0, 0) from (0, 0, 1);  start position = (0.2m, 0m, 0m); }
        body rod {
            axis y = (0, 1, 0);  point B = (0.3m, 0m, 0m);
            start orientation = turn((1, 0, 0), -26deg) * turn((0, 1, 0), 48deg);
        }
        joint axle = revolute(ground.axle, ground.x, crank.O, crank.x);
        joint ball = spherical(crank.A, rod.position);
        joint cross_pin = universal(slider.position, slider.x, rod.B, rod.y);
        joint rail = translational(ground.position, ground.x, slider.position, slider.x);
        drive motor = drive_rotation(axle, 1turn * t / 1s);
    }
}

/// Place, velocity and acceleration of a point of a body.
fn point(body: &SpatialBody<f64>, local: [f64; 3]) -> [Vector3<f64>; 3] {
    let arm = body.orientation() * Vector3::from(local);
    let (omega, alpha) = (body.angular_velocity, body.angular_acceleration);
    let velocity = omega.cross(&arm);
    [body.position + arm, body.velocity + velocity, body.acceleration + alpha.cross(&arm) + omega.cross(&velocity)]
}

#[test]
fn the_place_of_a_frame_in_its_body_changes_no_motion() {
    let times: Vec<f64> = (0..50).map(|step| f64::from(step) / 50.0).collect();
    let (centered, jointed) = (Centered::default(), Jointed::default());
    for (one, two) in centered.sweep(times.iter().copied()).zip(jointed.sweep(times.iter().copied())) {
        let (one, two) = (one.expect("it moves"), two.expect("it moves"));
        let pairs = [
            (point(&one.slider(), [0.0; 3]), point(&two.slider(), [0.0; 3])),
            (point(&one.crank(), [0.0; 3]), point(&two.crank(), [0.0; 3])),
            (point(&one.rod(), [-0.12, 0.0, 0.02]), point(&two.rod(), [0.0; 3])),
            (point(&one.rod(), [0.18, 0.3, 0.02]), point(&two.rod(), [0.3, 0.3, 0.0])),
        ];
        for (one, two) in pairs {
            for (order, (one, two)) in one.iter().zip(&two).enumerate() {
                // Lengths are below 1 m, ω is 2π: each derivative is larger by up to an order of magnitude.
                let bound = 1e-14 * 10_f64.powi(order as i32);
                assert!((one - two).norm() <= bound, "derivative {order}: {:e}", (one - two).norm());
            }
        }
    }
}

#[test]
fn a_step_of_newtons_method_has_one_arm_for_each_body() {
    let steps = |stages: &[PlanStage]| -> Vec<String> {
        let operations = |stage: &PlanStage| match stage {
            PlanStage::Iterated { unknowns, operations, .. } => Some(format!("{} unknowns, {operations:?}", unknowns.len())),
            PlanStage::Computed(_) | PlanStage::Checked(_) => None,
            other => panic!("{other:?} is no step of an arm"),
        };
        stages.iter().filter_map(operations).collect()
    };
    let centered = steps(Centered::<f64>::PLAN.stages);
    assert!(!centered.is_empty());
    assert_eq!(centered, steps(Jointed::<f64>::PLAN.stages));
}
