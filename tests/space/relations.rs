//! Belts, differentials and planetary trains between the hinges of bodies in space.

use reuleaux::mechanism;
use std::f64::consts::TAU;

mechanism! {
    /// A planetary train about an inclined axis; its arm drives a pulley, and that one another one by a crossed belt.
    pub mechanism Train in space {
        param tilt: Angle = 20deg;
        param sun_teeth: Number = 20;
        param ring_teeth: Number = 60;
        param phase: Angle = 0rad;
        ground { axis a = (0, sin(tilt), cos(tilt)) from (1, 0, 0);  point near = (100mm, 0mm, 0mm);  point far = (300mm, 0mm, 0mm); }
        body sun  { axis a = (0, 0, 1) from (1, 0, 0); }
        body ring { axis a = (0, 0, 1) from (1, 0, 0); }
        body arm  { axis a = (0, 0, 1) from (1, 0, 0); }
        body open { axis a = (0, 0, 1) from (1, 0, 0); }
        body crossed { axis a = (0, 0, 1) from (1, 0, 0); }
        joint sun_axle = revolute(ground.position, ground.a, sun.position, sun.a);
        joint ring_axle = revolute(ground.position, ground.a, ring.position, ring.a);
        joint arm_axle = revolute(ground.position, ground.a, arm.position, arm.a);
        joint open_axle = revolute(ground.near, ground.a, open.position, open.a);
        joint crossed_axle = revolute(ground.far, ground.a, crossed.position, crossed.a);
        joint train = planetary(sun_axle, ring_axle, arm_axle, sun_teeth, ring_teeth);
        joint strap = belt(arm_axle, open_axle, 20mm, 50mm, c: phase * 20mm);
        joint chain = belt(open_axle, crossed_axle, 12, -18);
        drive motor = drive_rotation(sun_axle, 300rpm * t);
        drive brake = drive_rotation(ring_axle, -45rpm * t);
        output arm = arm_axle.angle;
        output open = open_axle.angle;
        output crossed = crossed_axle.angle;
    }
}

mechanism! {
    /// A train whose ring rests in its case.
    pub mechanism Reducer in space {
        ground { axis x = (1, 0, 0); }
        body sun { axis x = (1, 0, 0); }
        body arm { axis x = (1, 0, 0); }
        joint sun_axle = revolute(ground.position, ground.x, sun.position, sun.x);
        joint arm_axle = revolute(ground.position, ground.x, arm.position, arm.x);
        joint train = planetary(sun_axle, 0, arm_axle, 20, 60);
        drive motor = drive_rotation(sun_axle, 300rpm * t);
        output arm = arm_axle.angle;
    }
}

mechanism! {
    /// An axle that swings; one differential counts its shafts against the axle, the other one against the housing.
    pub mechanism Axle in space {
        param ratio: Number = 1;
        ground { axis x = (1, 0, 0); }
        body axle    { axis x = (1, 0, 0);  axis y = (0, 1, 0); }
        body housing { axis y = (0, 1, 0); }
        body left    { axis y = (0, 1, 0); }
        body right   { axis y = (0, 1, 0); }
        body one     { axis y = (0, 1, 0); }
        body two     { axis y = (0, 1, 0); }
        joint swing = revolute(ground.position, ground.x, axle.position, axle.x);
        joint cage = revolute(axle.position, axle.y, housing.position, housing.y);
        joint left_axle = revolute(axle.position, axle.y, left.position, left.y);
        joint right_axle = revolute(axle.position, axle.y, right.position, right.y);
        joint one_axle = revolute(housing.position, housing.y, one.position, one.y);
        joint two_axle = revolute(housing.position, housing.y, two.position, two.y);
        joint outer = differential(left_axle, right_axle, cage, ratio, c: 10deg);
        joint inner = differential(one_axle, two_axle);
        drive rocking = drive_rotation(swing, 20deg * sin(3rad_s * t));
        drive engine = drive_rotation(cage, 60rpm * t);
        drive left_wheel = drive_rotation(left_axle, 50rpm * t);
        drive slip = drive_rotation(one_axle, 7rpm * t);
        output right = right_axle.angle;
        output two = cage.angle + two_axle.angle;
    }
}

mechanism! {
    /// Two friction wheels of which the radii are known.
    pub mechanism Friction in space {
        ground { axis z = (0, 0, 1);  point far = (70mm, 0mm, 0mm); }
        body one { axis z = (0, 0, 1); }
        body two { axis z = (0, 0, 1); }
        joint one_axle = revolute(ground.position, ground.z, one.position, one.z);
        joint two_axle = revolute(ground.far, ground.z, two.position, two.z);
        joint contact = gear_pair(one_axle, two_axle, 20mm, 50mm, c: 50mm * 30deg);
        drive motor = drive_rotation(one_axle, 60rpm * t);
        output two = two_axle.angle;
    }
}

/// Revolutions, of angles that are counted over whole turns.
fn turns(angle: f64) -> f64 {
    angle / TAU
}

#[test]
fn willis_equation_holds_over_many_turns_about_any_axis() {
    for (tilt, sun_teeth, ring_teeth) in [(0.35_f64, 20.0, 60.0), (1.2, 18.0, 72.0), (-0.6, 31.0, -25.0)] {
        let train = Train { tilt, sun_teeth, ring_teeth, phase: 0.3 };
        for t in [0.0, 0.7, 13.3, 40.0] {
            let state = train.solve(t).expect("it turns");
            let [arm, open, crossed] = [train.arm(&state), train.open(&state), train.crossed(&state)];
            let speed = (sun_teeth * 5.0 - ring_teeth * 0.75) / (sun_teeth + ring_teeth);
            // An open belt turns both the same way, a crossed one against each other.
            let wanted = [speed * t, 0.4 * (speed * t - turns(0.3)), -0.4 * 12.0 / 18.0 * (speed * t - turns(0.3))];
            for (found, wanted) in [arm, open, crossed].iter().zip(wanted) {
                assert!((turns(found.value) - wanted).abs() < 1e-14 * (5.0 * t).max(1.0), "{found:?}, not {wanted} turns");
            }
            assert!((turns(arm.rate) - speed).abs() < 1e-13 && (turns(crossed.rate) + 0.4 * 12.0 / 18.0 * speed).abs() < 1e-13);
        }
    }
}

#[test]
fn a_ring_that_rests_has_the_angle_zero() {
    let reducer = Reducer::default();
    for t in [0.3, 11.1] {
        let arm = reducer.arm(&reducer.solve(t).expect("it turns"));
        assert!((turns(arm.value) - 5.0 * t / 4.0).abs() < 1e-13 && (turns(arm.rate) - 1.25).abs() < 1e-14, "{arm:?}");
    }
}

#[test]
fn a_differential_divides_the_turns_of_its_housing() {
    for ratio in [1.0, 2.5, -0.75] {
        let axle = Axle { ratio };
        for t in [0.0, 1.7, 31.0] {
            let state = axle.solve(t).expect("it turns");
            let (right, two) = (axle.right(&state), axle.two(&state));
            let wanted = t + (10.0 / 360.0 - (50.0 / 60.0 - 1.0) * t) / ratio;
            assert!((turns(right.value) - wanted).abs() < 1e-14 * t.max(1.0), "{right:?}, not {wanted} turns");
            assert!((turns(right.rate) - (1.0 + (1.0 / 6.0) / ratio)).abs() < 1e-13);
            assert!((turns(two.value) - (1.0 - 7.0 / 60.0) * t).abs() < 1e-14 * t.max(1.0), "{two:?}");
        }
    }
}

#[test]
fn wheels_may_be_given_by_their_radii() {
    let wheels = Friction::default();
    for t in [0.0, 2.3] {
        let two = wheels.two(&wheels.solve(t).expect("it turns"));
        assert!((turns(two.value) - (1.0 / 12.0 - 0.4 * t)).abs() < 1e-14, "{two:?}");
    }
}
