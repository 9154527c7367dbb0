//! A body whose whole orientation follows a law.

use reuleaux::nalgebra::{UnitQuaternion, UnitVector3, Vector3};
use reuleaux::{Motion, mechanism};

mechanism! {
    /// A platform on a ball joint that turns over, and a camera that is aimed from it.
    pub mechanism Aimed in space {
        ground { axis z = (0, 0, 1); }
        body platform { axis z = (0, 0, 1);  point mast = (1m, 0.5m, 0.2m); }
        body camera { axis z = (0, 0, 1); }
        joint ball = spherical(ground.position, platform.position);
        joint mast = spherical(platform.mast, camera.position);
        drive rolling = drive_orientation(ground.z, platform.z, 20deg * sin(3rad_s * t), 1rad_s * t, 170deg - 2rad_s * t);
        drive aim = drive_orientation(platform.z, camera.z, 0deg, 30deg * sin(2rad_s * t), 60deg + 0.5rad_s * t);
    }
}

mechanism! {
    /// A body whose principal axes are those of its frame, turned about one of them after the other.
    pub mechanism Turned in space {
        param roll: Angle = 0deg;
        param pitch: Angle = 0deg;
        param yaw: Angle = 0deg;
        let law = sin(2rad_s * t);
        ground { axis z = (0, 0, 1); }
        body b { axis z = (0, 0, 1);  mass = 3kg;  inertia = (0.02kgm2, 0.05kgm2, 0.06kgm2); }
        joint ball = spherical(ground.position, b.position);
        drive turn = drive_orientation(ground.z, b.z, roll * law, pitch * law, yaw * law);
    }
}

mechanism! {
    /// A turn about a skew axis, half a turn away from the frames at the start.
    pub mechanism Skew in space {
        ground { axis a = (1, 2, -2); }
        body b { axis a = (1, 2, -2);  start orientation = turn((1, 2, -2), 160deg); }
        joint ball = spherical(ground.position, b.position);
        drive turn = drive_orientation(ground.a, b.a, roll: 0deg, pitch: 0deg, yaw: 180deg + 3rad_s * t);
    }
}

mechanism! {
    /// Half a turn away from the frames at the start, where no orientation is declared.
    pub mechanism Opposite in space {
        ground { axis z = (0, 0, 1); }
        body b { axis z = (0, 0, 1); }
        joint ball = spherical(ground.position, b.position);
        drive turn = drive_orientation(ground.z, b.z, roll: 0deg, pitch: 0deg, yaw: 180deg + 3rad_s * t);
    }
}

mechanism! {
    /// `Aimed` by equations of orientations, with a lens that is fixed askew in the camera.
    pub mechanism Written in space {
        body platform { point mast = (1m, 0.5m, 0.2m); }
        body camera {}
        body lens { axis view = (1, 0, 0); }
        joint ball = spherical(ground.position, platform.position);
        joint mast = spherical(platform.mast, camera.position);
        joint seat = spherical(camera.position, lens.position);
        joint thread = { lens.orientation == camera.orientation * turn((1, 2, -2), 40deg) * turn((0, 1, 0), 90deg); }
        drive rolling = {
            platform.orientation ==
                turn((0, 0, 1), 170deg - 2rad_s * t) * turn((0, 1, 0), 1rad_s * t) * turn((1, 0, 0), 20deg * sin(3rad_s * t));
        }
        drive aim = {
            platform.orientation * turn((0, 0, 1), 60deg + 0.5rad_s * t) * turn((0, 1, 0), 30deg * sin(2rad_s * t)) == camera.orientation;
        }
        output view = lens.orientation * (3, 0, 4);
        output back = turn((0, 0, 1), -1rad_s * t) * lens.view;
    }
}

mechanism! {
    /// Equations of orientations that contain an input and the angle of a hinge.
    pub mechanism Steered in space {
        param factor: Number = 2;
        input tilt: Angle = 10deg;
        ground { axis z = (0, 0, 1);  point m = (0.3m, 0.1m, 0m); }
        body arm { axis z = (0, 0, 1);  point tip = (0.5m, 0.1m, 0.2m); }
        body wrist { point end = (0.1m, 0.2m, -0.3m); }
        body tool {}
        joint hinge = revolute(ground.m, ground.z, arm.position, arm.z);
        joint ball = spherical(arm.tip, wrist.position);
        joint seat = spherical(wrist.end, tool.position);
        drive motor = drive_rotation(hinge, 1rad_s * t + 0.5rad * sin(2rad_s * t));
        joint thread = { wrist.orientation == arm.orientation * turn((1, 2, -1), factor * hinge.angle + 0.3rad); }
        drive aim = { turn((1, 0, 1), tilt + 0.2rad_s * t) * tool.orientation == wrist.orientation * turn((0, 1, 0), hinge.angle); }
    }
}

/// Value, rate and acceleration of an angle.
type Angle = [f64; 3];

/// Orientation, angular velocity and angular acceleration of roll, pitch and yaw, by the rule of moving frames.
fn exact([roll, pitch, yaw]: [Angle; 3]) -> (UnitQuaternion<f64>, Vector3<f64>, Vector3<f64>) {
    let first = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw[0]);
    let second = first * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), pitch[0]);
    let (z, y, x) = (Vector3::z(), first * Vector3::y(), second * Vector3::x());
    let outer = z * yaw[1] + y * pitch[1];
    let acceleration = z * yaw[2] + y * pitch[2] + x * roll[2] + (z * yaw[1]).cross(&(y * pitch[1])) + outer.cross(&(x * roll[1]));
    (UnitQuaternion::from_euler_angles(roll[0], pitch[0], yaw[0]), outer + x * roll[1], acceleration)
}

/// Value, rate and acceleration of `size · sin(ω t)`.
fn swing(size: f64, omega: f64, t: f64) -> Angle {
    let (sin, cos) = (omega * t).sin_cos();
    [size * sin, size * omega * cos, -size * omega * omega * sin]
}

fn off(found: UnitQuaternion<f64>, wanted: UnitQuaternion<f64>) -> f64 {
    (found.to_rotation_matrix().matrix() - wanted.to_rotation_matrix().matrix()).amax()
}

#[test]
fn a_body_has_the_orientation_that_is_prescribed() {
    let aimed = Aimed::default();
    for state in aimed.sweep((0..400).map(|step| f64::from(step) / 50.0)) {
        let state = state.expect("it moves");
        let t = state.t;
        let yaw = [170_f64.to_radians() - 2.0 * t, -2.0, 0.0];
        let (outer, omega, alpha) = exact([swing(20_f64.to_radians(), 3.0, t), [t, 1.0, 0.0], yaw]);
        let platform = state.platform();
        assert!(off(platform.orientation(), outer) < 2e-15, "{:e}", off(platform.orientation(), outer));
        assert!((platform.angular_velocity - omega).norm() < 2e-14 && (platform.angular_acceleration - alpha).norm() < 1e-13);
        let (inner, own, own_alpha) = exact([[0.0; 3], swing(30_f64.to_radians(), 2.0, t), [60_f64.to_radians() + 0.5 * t, 0.5, 0.0]]);
        let (own, own_alpha) = (outer * own, outer * own_alpha);
        let camera = state.camera();
        assert!(off(camera.orientation(), outer * inner) < 4e-15, "{:e}", off(camera.orientation(), outer * inner));
        assert!((camera.angular_velocity - omega - own).norm() < 2e-14);
        assert!((camera.angular_acceleration - alpha - own_alpha - omega.cross(&own)).norm() < 1e-13);
    }
}

/// About a principal axis the torque is that moment times the angular acceleration; of the whole law the power is that of Euler's equations.
#[test]
fn what_the_drive_does_is_the_torque_of_eulers_equations() {
    let moments = Vector3::new(0.02, 0.05, 0.06);
    for (roll, pitch, yaw) in [(0.8, 0.0, 0.0), (0.0, -1.3, 0.0), (0.0, 0.0, 2.9), (0.7, 0.4, -0.9)] {
        let turned = Turned { roll, pitch, yaw };
        for t in [0.0, 0.3, 1.1] {
            let state = turned.solve(t).expect("it moves");
            let (orientation, omega, alpha) = exact([roll, pitch, yaw].map(|size| swing(size, 2.0, t)));
            let own = |vector: Vector3<f64>| orientation.inverse() * vector;
            let momentum = moments.component_mul(&own(omega));
            let torque = orientation * (moments.component_mul(&own(alpha)) + own(omega).cross(&momentum));
            let loads = turned.loads(&state);
            assert!((loads.turn().effort - torque.x).abs() < 1e-14, "{:?}, not {torque}", loads.turn());
            assert!((loads.turn().power - torque.dot(&omega)).abs() < 1e-13);
            let multipliers = Vector3::from_fn(|row, _| loads.multipliers[3 + row]);
            assert!((multipliers + torque).norm() < 1e-14, "{multipliers}, not {torque}");
        }
    }
}

#[test]
fn a_turn_about_one_axis_goes_on_over_many_turns() {
    let skew = Skew::default();
    let axis = reuleaux::nalgebra::Unit::new_normalize(Vector3::new(1.0, 2.0, -2.0));
    for t in [0.0, 1.0, 9.7] {
        let b = skew.solve(t).expect("it turns").b();
        let wanted = UnitQuaternion::from_axis_angle(&axis, std::f64::consts::PI + 3.0 * t);
        assert!(off(b.orientation(), wanted) < 1e-14 && (b.angular_velocity - axis.into_inner() * 3.0).norm() < 1e-14);
    }
}

/// A quaternion and its opposite are one assembly.
#[test]
fn half_a_turn_is_one_assembly() {
    for t in [0.0, 2.2] {
        let b = Opposite::default().solve(t).expect("it turns").b();
        let wanted = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), std::f64::consts::PI + 3.0 * t);
        assert!(off(b.orientation(), wanted) < 1e-14 && (b.angular_velocity - Vector3::z() * 3.0).norm() < 1e-14);
    }
}

#[test]
fn orientations_are_equated_and_turn_vectors() {
    let (aimed, written) = (Aimed::default(), Written::default());
    let seat = UnitQuaternion::from_axis_angle(&UnitVector3::new_normalize(Vector3::new(1.0, 2.0, -2.0)), 40_f64.to_radians())
        * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), 90_f64.to_radians());
    for step in 0..200 {
        let t = f64::from(step) / 25.0;
        let (wanted, state) = (aimed.solve(t).expect("a state"), written.solve(t).expect("a state"));
        for (found, wanted) in [(state.platform(), wanted.platform()), (state.camera(), wanted.camera())] {
            assert!(off(found.orientation(), wanted.orientation()) < 8e-15, "{:e}", off(found.orientation(), wanted.orientation()));
            assert!((found.angular_velocity - wanted.angular_velocity).norm() < 4e-14);
            assert!((found.angular_acceleration - wanted.angular_acceleration).norm() < 4e-13);
        }
        let (camera, lens) = (wanted.camera(), state.lens());
        let orientation = camera.orientation() * seat;
        assert!(off(lens.orientation(), orientation) < 8e-15, "{:e}", off(lens.orientation(), orientation));
        let (view, rate) = (orientation * Vector3::new(3.0, 0.0, 4.0), camera.angular_velocity);
        let found = written.view(&state);
        assert!((found.value - view).norm() < 4e-14 && (found.rate - rate.cross(&view)).norm() < 4e-13, "{found:?}");
        let turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -t);
        let axis = orientation * Vector3::x();
        let found = written.back(&state);
        let wanted = turned * (rate.cross(&axis) - Vector3::z().cross(&axis));
        assert!((found.value - turned * axis).norm() < 1e-14 && (found.rate - wanted).norm() < 1e-13, "{found:?}");
    }
}

mechanism! {
    /// Two bodies that start far from where equations put them, and a third that is turned about an axis of an arm.
    #[allow(far_start)]
    mechanism Placed in space {
        param lead: Angle = 30deg;
        ground { axis z = (0, 0, 1); }
        body far   { start orientation = turn((0, 0, 1), 10deg); }
        body next  { start orientation = turn((1, 0, 0), 160deg); }
        body arm   { axis z = (0, 0, 1);  axis across = (1, 2, 2); }
        body blade {}
        joint ball = spherical(ground.position, far.position);
        joint end = spherical(ground.position, next.position);
        joint hub = spherical(arm.position, blade.position);
        joint hinge = revolute(ground.position, ground.z, arm.position, arm.z);
        joint held = { far.orientation == turn((0, 0, 1), 170deg); }
        joint kept = { next.orientation == far.orientation * turn((0, 1, 0), 20deg); }
        joint pitch = { blade.orientation == turn(arm.across, lead + 2 * hinge.angle) * arm.orientation; }
        drive motor = drive_rotation(hinge, 1rad_s * t);
        output tip = turn(arm.across, 90deg) * arm.z;
    }
}

#[test]
fn equal_orientations_are_no_half_turns_apart_wherever_bodies_start() {
    let state = Placed::default().solve(0.0).expect("a state");
    let far = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 170_f64.to_radians());
    assert!(off(state.far().orientation(), far) < 1e-15, "{}", state.far().orientation());
    let next = far * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), 20_f64.to_radians());
    assert!(off(state.next().orientation(), next) < 1e-15, "{}", state.next().orientation());
}

#[test]
fn turns_about_axes_of_bodies_move_with_them() {
    let (turned, across) = (Placed::default(), UnitVector3::new_normalize(Vector3::new(1.0, 2.0, 2.0)));
    for state in turned.sweep((0..50).map(|step| 0.1 * f64::from(step))) {
        let state = state.expect("a state");
        let arm = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), state.t);
        // A turn about a direction of the arm, in ground, and then that of the arm: turned in the arm first.
        let blade = arm * UnitQuaternion::from_axis_angle(&across, 30_f64.to_radians() + 2.0 * state.t);
        assert!(off(state.blade().orientation(), blade) < 1e-14, "{}", state.t);
        let spin = Vector3::z() + arm * across.into_inner() * 2.0;
        assert!((state.blade().angular_velocity - spin).norm() < 1e-13, "{}", state.t);
        // ω × of the part of the spin that turns with the arm.
        let growth = Vector3::z().cross(&(arm * across.into_inner() * 2.0));
        assert!((state.blade().angular_acceleration - growth).norm() < 1e-12, "{}", state.t);
        // a × z + a (a · z) for a right angle.
        let axis = arm * across.into_inner();
        let tip = axis.cross(&Vector3::z()) + axis * axis.z;
        assert!((turned.tip(&state).value - tip).norm() < 1e-15, "{}", state.t);
    }
}

/// Its equations come joint by joint, and read the input of the mechanism where there is no state.
#[test]
fn equations_of_orientations_contain_inputs_and_angles() {
    let turn = |axis: [f64; 3], angle: f64| UnitQuaternion::from_axis_angle(&UnitVector3::new_normalize(axis.into()), angle);
    let steered = Steered::default();
    for step in 0..100 {
        let t = f64::from(step) / 30.0;
        let tilt = swing(0.7, 1.3, t);
        let inputs = SteeredInputs { tilt: Motion::new(tilt[0], tilt[1], tilt[2]) };
        let state = steered.solve(t, inputs).expect("a state");
        let hinge = t + 0.5 * (2.0 * t).sin();
        let wrist = turn([0.0, 0.0, 1.0], hinge) * turn([1.0, 2.0, -1.0], 2.0 * hinge + 0.3);
        let tool = turn([1.0, 0.0, 1.0], -(tilt[0] + 0.2 * t)) * wrist * turn([0.0, 1.0, 0.0], hinge);
        for (found, wanted) in [(state.wrist(), wrist), (state.tool(), tool)] {
            assert!(off(found.orientation(), wanted) < 1e-14, "{t}: {:e}", off(found.orientation(), wanted));
        }
        // ω of the tool in ground: that of the wrist and of the turn about y, less the tilt, turned back.
        let about = |axis: [f64; 3]| Vector3::from(axis).normalize();
        let (rate, back) = (1.0 + (2.0 * t).cos(), turn([1.0, 0.0, 1.0], -(tilt[0] + 0.2 * t)));
        let arm = turn([0.0, 0.0, 1.0], hinge);
        let of_wrist = Vector3::z() * rate + arm * about([1.0, 2.0, -1.0]) * (2.0 * rate);
        let omega = back * (of_wrist + wrist * Vector3::y() * rate) - about([1.0, 0.0, 1.0]) * (tilt[1] + 0.2);
        assert!((state.wrist().angular_velocity - of_wrist).norm() < 1e-13, "{t}");
        assert!((state.tool().angular_velocity - omega).norm() < 1e-13, "{t}");
    }
}
