//! Hinges and slides whose axes point against each other at the declared start.

use reuleaux::mechanism;
use reuleaux::nalgebra::{UnitQuaternion, Vector3};

mechanism! {
    /// A wheel turned over.
    mechanism TurnedOver in space {
        ground { axis z = (0, 0, 1); }
        body wheel { axis z = (0, 0, 1);  start orientation = turn((1, 0, 0), 180deg); }
        joint hinge = revolute(ground.position, ground.z, wheel.position, wheel.z);
        drive motor = drive_rotation(hinge, 0.5rad * t / 1s);
    }
}

mechanism! {
    /// A crank turned over, whose pin lies 50 mm below its bearing, and a slide on a line 250 mm below it.
    mechanism Below in space {
        ground { axis z = (0, 0, 1);  axis x = (1, 0, 0);  point G = (0mm, 0mm, -250mm); }
        body crank { axis z = (0, 0, 1);  point A = (100mm, 0mm, 50mm);  start orientation = turn((1, 0, 0), 180deg); }
        body slide { axis x = (1, 0, 0);  start position = (296mm, 0mm, -250mm); }
        joint bearing = revolute(ground.position, ground.z, crank.position, crank.z);
        joint guide = translational(ground.G, ground.x, slide.position, slide.x);
        joint rod = distance(crank.A, slide.position, 280mm);
        drive motor = drive_rotation(bearing, 0.5rad * t / 1s);
    }
}

mechanism! {
    /// A slide turned over about its way, and a plate welded to it that is turned over about an axis across.
    mechanism Slid in space {
        ground { axis x = (1, 0, 0); }
        body slide { axis x = (1, 0, 0);  axis z = (0, 0, 1);  start orientation = turn((1, 0, 0), 180deg); }
        body plate { axis z = (0, 0, 1);  start orientation = turn((0, 1, 0), 180deg); }
        joint guide = translational(ground.position, ground.x, slide.position, slide.x);
        joint bolts = weld(slide.position, slide.z, plate.position, plate.z);
        drive way = drive_translation(guide, 20mm_s * t);
    }
}

mechanism! {
    /// A hand turned over on a plate welded to an arm that turns about the same direction. Orientations of arm and plate are not declared.
    mechanism Chained in space {
        ground { axis z = (0, 0, 1); }
        body arm { axis z = (0, 0, 1); }
        body plate { axis z = (0, 0, 1);  point A = (200mm, 0mm, 0mm); }
        body hand { axis z = (0, 0, 1);  start orientation = turn((1, 0, 0), 180deg); }
        joint shoulder = revolute(ground.position, ground.z, arm.position, arm.z);
        joint bolts = weld(arm.position, arm.z, plate.position, plate.z);
        joint elbow = revolute(plate.A, plate.z, hand.position, hand.z);
        drive first = drive_rotation(shoulder, 0.5rad * t / 1s);
        drive second = drive_rotation(elbow, 0rad);
    }
}

mechanism! {
    /// A wheel whose axis points against that of ground, the second of the joint, begins at an angle of the joint.
    mechanism Begun in space {
        ground { axis z = (0, 0, 1) from (1, 0, 0); }
        body wheel { axis down = (0, 0, -1) from (1, 0, 0);  mass = 1kg;  inertia = (1kgm2, 1kgm2, 1kgm2);  start orientation = turn((0, 0, 1), 5deg); }
        joint hinge = revolute(wheel.position, wheel.down, ground.position, ground.z);
        start hinge.angle = 40deg;
        freedom spin = hinge.angle;
        output angle = hinge.angle;
    }
}

#[test]
fn a_declared_angle_is_that_of_the_joint_whichever_body_stands_first() {
    let begun = Begun::default();
    let state = begun.initial_state().expect("a state");
    // x turned by ψ about z: y_a · x_b = sin ψ about the axis that points down.
    let (angle, wanted) = (40_f64.to_radians(), UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 40_f64.to_radians()));
    assert!((begun.angle(&state).value - angle).abs() < 1e-15, "{}", begun.angle(&state).value);
    assert!((state.wheel().orientation().into_inner() - wanted.into_inner()).norm() < 1e-15, "{}", state.wheel().orientation());
}

mechanism! {
    /// A hand across an arm that is driven half a turn from ground, which its start does not say.
    mechanism Across in space {
        ground { axis z = (0, 0, 1); }
        body arm { axis z = (0, 0, 1);  axis y = (0, 1, 0);  point A = (200mm, 0mm, 0mm); }
        body hand { axis y = (0, 1, 0);  start orientation = turn((0, 0, 1), 180deg); }
        joint shoulder = revolute(ground.position, ground.z, arm.position, arm.z);
        joint elbow = revolute(arm.A, arm.y, hand.position, hand.y);
        drive first = drive_rotation(shoulder, 180deg + 0.5rad * t / 1s);
        drive second = drive_rotation(elbow, 0rad);
    }
}

/// A crank turned over with a hand, and the axes of the crank by their component in z.
macro_rules! overhead {
    ($name:ident, ($($z:tt)*)) => {
        mechanism! {
            /// A crank turned over, and a hand that is not.
            mechanism $name in space {
                gravity = (0, -9.81m_s2, 0);
                ground { axis z = (0, 0, 1); }
                body crank {
                    point A = (300mm, 40mm, 10mm);  axis z = (0, 0, $($z)*);
                    mass = 2kg;  center = (100mm, 10mm, 0mm);  inertia = (0.01kgm2, 0.02kgm2, 0.03kgm2);
                    start orientation = turn((1, 0, 0), 180deg);
                }
                body hand {
                    axis z = (0, 0, 1);
                    mass = 1kg;  center = (100mm, 0mm, 0mm);  inertia = (0.001kgm2, 0.002kgm2, 0.003kgm2);
                    start orientation = turn((0, 0, 1), 30deg);
                }
                joint shoulder = revolute(ground.position, ground.z, crank.position, crank.z);
                joint elbow = revolute(hand.position, hand.z, crank.A, crank.z);
                redundant joint whole = parallel_axes(ground.z, hand.z);
                force spring = torsion_spring(ground.z, crank.z, 5Nm_rad, 20deg);
                drive first = drive_rotation(shoulder, 0.4rad * t / 1s);
                drive second = drive_rotation(whole, 30deg + 0.3rad * t^2 / 1s^2);
                output between = elbow.angle;
            }
        }
    };
}

overhead!(Opposed, (1));
overhead!(Aligned, (-1));

#[test]
fn a_hinged_body_stays_turned_over() {
    for state in TurnedOver::default().sweep((0..20).map(f64::from)) {
        let state = state.expect("a state");
        let wanted = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.5 * state.t)
            * UnitQuaternion::from_axis_angle(&Vector3::x_axis(), core::f64::consts::PI);
        assert!(state.wheel().orientation().angle_to(&wanted) < 1e-14, "{}", state.t);
        assert!((state.wheel().angular_velocity - Vector3::new(0.0, 0.0, 0.5)).norm() < 1e-15);
    }
}

#[test]
fn an_axis_is_opposed_only_where_declared_orientations_say_so() {
    let (chained, across) = (Chained::default().solve(1.0).expect("a state"), Across::default().solve(1.0).expect("a state"));
    let about = |axis, angle| UnitQuaternion::from_axis_angle(&axis, angle);
    let turned = about(Vector3::z_axis(), 0.5);
    let half = core::f64::consts::PI;
    assert!(chained.hand().orientation().angle_to(&(turned * about(Vector3::x_axis(), half))) < 1e-14);
    assert!(across.hand().orientation().angle_to(&(turned * about(Vector3::z_axis(), half))) < 1e-14);
}

#[test]
fn a_loop_closes_with_the_crank_turned_over() {
    for state in Below::default().sweep((0..40).map(f64::from)) {
        let state = state.expect("a state");
        let (sine, cosine) = f64::sin_cos(0.5 * state.t);
        // A = (0.1 cos, 0.1 sin, −0.05), 0.2 above the line.
        let (across, along) = (0.01 * sine * sine + 0.04, 0.1 * cosine);
        let wanted = along + (0.28_f64.powi(2) - across).sqrt();
        assert!((state.slide().position.x - wanted).abs() < 1e-15, "{}: {}", state.t, state.slide().position.x);
    }
}

#[test]
fn a_slide_and_a_welded_plate_stay_turned_over() {
    let state = Slid::default().solve(2.0).expect("a state");
    let x = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), core::f64::consts::PI);
    let y = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), core::f64::consts::PI);
    assert!(state.slide().orientation().angle_to(&x) < 1e-15 && state.plate().orientation().angle_to(&y) < 1e-15);
    assert!((state.plate().position - Vector3::new(0.04, 0.0, 0.0)).norm() < 1e-16);
}

#[test]
fn motion_and_loads_are_those_with_axes_that_agree() {
    let (opposed, aligned) = (Opposed::default(), Aligned::default());
    for step in 0..30 {
        let t = 0.2 * f64::from(step);
        let (one, other) = (opposed.solve(t).expect("a state"), aligned.solve(t).expect("a state"));
        let (of_one, of_other) = (opposed.loads(&one), aligned.loads(&other));
        let near = |a: f64, b: f64| assert!((a - b).abs() <= 1e-13 * (1.0 + b.abs()), "{t}: {a} {b}");
        let motion = |hand: Vector3<f64>, turned: Vector3<f64>| hand.iter().chain(turned.iter()).copied().collect::<Vec<_>>();
        let (a, b) = (
            motion(one.hand().acceleration, one.hand().angular_acceleration),
            motion(other.hand().acceleration, other.hand().angular_acceleration),
        );
        a.iter().zip(&b).for_each(|(a, b)| near(*a, *b));
        near(opposed.between(&one).value, aligned.between(&other).value);
        near(opposed.between(&one).rate, 0.4 - 0.6 * t);
        near(of_one.first().effort, of_other.first().effort);
        near(of_one.second().effort, of_other.second().effort);
        assert!(of_one.second().effort.abs() > 1e-3 && of_one.first().effort.abs() > 1e-3);
        for k in 0..3 {
            near(of_one.elbow().force[k], of_other.elbow().force[k]);
            near(of_one.elbow().torque[k], of_other.elbow().torque[k]);
        }
    }
}
