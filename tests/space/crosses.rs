//! The two angles of a universal joint, and the place of a planar joint.

use reuleaux::nalgebra::{Rotation3, Vector3};
use std::f64::consts::TAU;

use reuleaux::{Coordinate, Description, State, mechanism};

mechanism! {
    /// A head on a cross, turned by both angles of it.
    mechanism Head in space {
        ground { axis a = (1, 0, 0) from (0, 1, 0); }
        body head { axis b = (0, 1, 0) from (1, 0, 0);  point E = (0.1m, 0.2m, 0.3m); }
        joint hook = universal(ground.position, ground.a, head.position, head.b);
        drive pan = drive_rotation(hook.angle_a, 0.2rad + 1.5rad_s * t);
        drive tilt = drive_rotation(hook.angle_b, -0.3rad + 0.7rad_s * t);
        output end = head.E;
        output across = hook.angle_a;
    }
}

mechanism! {
    /// A puck on a table, moved by its place and its angle.
    mechanism Puck in space {
        ground { axis up = (0, 0, 1) from (0, 1, 0);  point O = (1m, 2m, 3m); }
        body puck { axis up = (0, 0, 1) from (1, 0, 0); }
        joint bed = planar(ground.O, ground.up, puck.position, puck.up, 0.5m);
        drive one = { bed.x == 0.3m + 2m_s * t; }
        drive other = { bed.y == 0.4m - 1m_s * t; }
        drive turn = drive_rotation(bed.angle, 3rad_s * t);
        output place = puck.position;
    }
}

mechanism! {
    /// A shaft bent by a cross: its angles are those of a right spherical triangle.
    mechanism Cardan in space {
        param bend: Angle = 30deg;
        ground { axis x = (1, 0, 0) from (0, 0, 1);  axis way = (cos(bend), sin(bend), 0) from (0, 0, 1); }
        body input  { axis x = (1, 0, 0) from (0, 0, 1);  axis arm = (0, 0, 1) from (0, 1, 0); }
        body output { axis x = (1, 0, 0) from (0, 0, 1);  axis arm = (0, 1, 0) from (0, 0, 1); }
        joint bearing = revolute(ground.position, ground.x, input.position, input.x);
        joint cross_pin = universal(input.position, input.arm, output.position, output.arm);
        joint far = parallel_axes(ground.way, output.x);
        drive motor = drive_rotation(bearing, 60rpm * t);
        output swing = cross_pin.angle_a;
        output nod = cross_pin.angle_b;
    }
}

/// R = turn(x, α) turn(y, β), ω = α̇ x + β̇ turn(x, α) y
#[test]
fn both_angles_of_a_cross_turn_a_head() {
    let head = Head::default();
    for state in head.sweep((0..=20).map(|k| 0.05 * f64::from(k))) {
        let state = state.expect("a state");
        let (alpha, beta) = (0.2 + 1.5 * state.t, -0.3 + 0.7 * state.t);
        let first = Rotation3::from_axis_angle(&Vector3::x_axis(), alpha);
        let at = first * Rotation3::from_axis_angle(&Vector3::y_axis(), beta) * Vector3::new(0.1, 0.2, 0.3);
        let omega = Vector3::x() * 1.5 + first * Vector3::y() * 0.7;
        let end = head.end(&state);
        assert!((end.value - at).norm() < 1e-15, "t = {}: {} for {at}", state.t, end.value);
        assert!((end.rate - omega.cross(&at)).norm() < 1e-14, "t = {}", state.t);
        let across = head.across(&state);
        assert!((across.value - alpha).abs() < 2e-15 && (across.rate - 1.5).abs() < 1e-14 && across.acceleration.abs() < 1e-13);
    }
}

/// x of the table is y of ground, and y of the table −x.
#[test]
fn a_puck_has_its_place_on_the_table() {
    let puck = Puck::default();
    for state in puck.sweep([0.0, 0.3, 1.0]) {
        let state = state.expect("a state");
        let wanted = Vector3::new(1.0 - (0.4 - state.t), 2.0 + 0.3 + 2.0 * state.t, 3.5);
        let place = puck.place(&state);
        assert!((place.value - wanted).norm() < 1e-15 * wanted.norm(), "{}", place.value);
        assert!((place.rate - Vector3::new(1.0, 2.0, 0.0)).norm() < 1e-14);
    }
}

/// The arms stay perpendicular. With the input at φ the arm of the input is (0, −sin φ, cos φ), that of the output is perpendicular to it and to
/// the shaft: their angles against the shafts are tan a = tan β cos φ, sin b = sin β sin φ, but for signs.
#[test]
fn a_bent_shaft_swings_and_nods() {
    let cardan = Cardan::default();
    let bend = 30_f64.to_radians();
    for state in cardan.sweep((0..=60).map(|k| f64::from(k) / 60.0)) {
        let state = state.expect("a state");
        let phi = core::f64::consts::TAU * state.t;
        let (swing, nod) = (cardan.swing(&state).value, cardan.nod(&state).value);
        assert!((swing.tan() - bend.tan() * phi.cos()).abs() < 1e-14, "φ = {phi}: {swing}");
        assert!((nod.sin().abs() - (bend.sin() * phi.sin()).abs()).abs() < 1e-14, "φ = {phi}: {nod}");
    }
}

mechanism! {
    /// A cross whose arm in ground is oblique; the head is named first.
    #[allow(far_start)]
    mechanism HeadFirst in space {
        ground { axis a = (0, 0.6, 0.8) from (0, 1, 0); }
        body head { axis b = (1, 0, 0) from (0, 1, 1); }
        joint hook = universal(head.position, head.b, ground.position, ground.a);
        drive pan = drive_rotation(hook.angle_a, 0.45rad);
        drive tilt = drive_rotation(hook.angle_b, 0.55rad + 1rad_s * t);
        output pan_angle = hook.angle_a;
        output tilt_angle = hook.angle_b;
    }
}

mechanism! {
    /// Hinges named from the door and from the frame, with axes that point against each other.
    mechanism Doors in space {
        ground { axis z = (0, 0, 1); }
        body one { axis z = (0, 0, 1); start orientation = turn((1, 0, 0), 180deg); }
        body two { axis z = (0, 0, 1); start orientation = turn((1, 0, 0), 180deg); }
        joint from_door = revolute(one.position, one.z, ground.position, ground.z);
        joint from_frame = revolute(ground.position, ground.z, two.position, two.z);
        drive first = drive_rotation(from_door, 30deg + 2rad_s * t);
        drive second = drive_rotation(from_frame, 40deg + 3rad_s * t);
    }
}

/// The coordinate of this name and its rate.
fn named<M: Description<f64, N>, const N: usize>(_: &M, state: &State<f64, N>, joint: &str, name: &str) -> [f64; 2] {
    let is_named = |coordinate: &Coordinate| coordinate.body == joint && coordinate.name == name;
    let index = M::COORDINATES.iter().position(is_named).expect("a coordinate of this name");
    [state.q[index], state.qd[index]]
}

#[test]
fn coordinates_named_like_angles_of_joints_hold_them() {
    let (head, t) = (Head::default(), 0.4);
    let state = head.solve(t).expect("a state");
    let found = [named(&head, &state, "hook", "angle_a"), named(&head, &state, "hook", "angle_b")].concat();
    let wanted = [0.2 + 1.5 * t, 1.5, -0.3 + 0.7 * t, 0.7];
    assert!(found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-14), "{found:?}, not {wanted:?}");

    let first = HeadFirst::default();
    let state = first.solve(t).expect("a state");
    let found = [named(&first, &state, "hook", "angle_a"), named(&first, &state, "hook", "angle_b")].concat();
    let wanted = [0.45, 0.0, 0.95, 1.0];
    assert!(found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-14), "{found:?}, not {wanted:?}");
    assert!((first.pan_angle(&state).value - 0.45).abs() < 1e-14 && (first.tilt_angle(&state).value - 0.95).abs() < 1e-14);

    let doors = Doors::default();
    let state = doors.solve(t).expect("a state");
    let found = [named(&doors, &state, "from_door", "angle"), named(&doors, &state, "from_frame", "angle")].concat();
    let wanted = [30_f64.to_radians() + 0.8, 2.0, 40_f64.to_radians() + 1.2, 3.0];
    assert!(found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-14), "{found:?}, not {wanted:?}");
}

mechanism! {
    /// A shaft in bearings behind a cross that is bent far: it swings through half a turn at once, and rests before and after it.
    mechanism Bent in space {
        param bend: Angle = 89deg;
        ground {
            axis x = (1, 0, 0) from (0, 0, 1);
            axis way = (cos(bend), sin(bend), 0) from (0, 0, 1);
            point F = (1m * cos(bend), 1m * sin(bend), 0m);
        }
        body input  { axis x = (1, 0, 0) from (0, 0, 1);  axis arm = (0, 0, 1) from (0, 1, 0); }
        body output { axis x = (1, 0, 0) from (0, 0, 1);  axis arm = (0, 1, 0) from (0, 0, 1);  point E = (1m, 0m, 0m); }
        joint bearing = revolute(ground.position, ground.x, input.position, input.x);
        joint far = revolute(ground.F, ground.way, output.E, output.x);
        joint cross_pin = perpendicular_axes(input.arm, output.arm);
        drive motor = drive_rotation(bearing, 1rad_s * t);
        output turn = far.angle;
    }
}

/// tan β = tan α cos δ
#[test]
fn no_turn_is_lost_behind_a_cross_that_is_bent_far() {
    for bend in [80.0_f64, 89.0, 89.9] {
        let bent = Bent { bend: bend.to_radians() };
        for k in 0..64 {
            let t = 0.013 + 0.31 * f64::from(k);
            let found = bent.turn(&bent.solve(t).expect("a state")).value;
            let within = (t.sin() * bent.bend.cos()).atan2(t.cos());
            let wanted = within + TAU * ((t - within) / TAU).round();
            assert!((found - wanted).abs() < 1e-9, "{bend}° at t = {t}: {found}, not {wanted}");
        }
    }
}

mechanism! {
    /// One joint with two rows of perpendicular axes, for two bodies.
    mechanism Twofold in space {
        ground { axis z = (0, 0, 1) from (1, 0, 0); }
        body b { axis n = (1, 0, 0) from (0, 1, 0); }
        body c { axis n = (1, 0, 0) from (0, 1, 0); }
        joint own = {
            ground.position == b.position;
            ground.position == c.position;
            dot(z_axis(ground.z), z_axis(b.n)) == 0;
            dot(z_axis(ground.z), z_axis(c.n)) == 0;
        }
        drive one = { dot(x_axis(ground.z), x_axis(b.n)) == 0.1 * sin(1rad_s * t); }
        drive two = { dot(z_axis(ground.z), x_axis(b.n)) == 0.3 * sin(1rad_s * t); }
        drive three = { dot(x_axis(ground.z), x_axis(c.n)) == 0.2 * sin(1rad_s * t); }
        drive four = { dot(z_axis(ground.z), x_axis(c.n)) == 0.2 * sin(2rad_s * t); }
    }
}

mechanism! {
    /// A hinge by two rows of one joint, which hold one axis across two others.
    mechanism Crossed in space {
        ground { axis u = (1, 0, 0);  axis v = (0, 1, 0); }
        body b { axis z = (0, 0, 1);  axis u = (1, 0, 0); }
        joint hinge = {
            ground.position == b.position;
            dot(z_axis(ground.u), z_axis(b.z)) == 0;
            dot(z_axis(ground.v), z_axis(b.z)) == 0;
        }
        drive turn = { dot(z_axis(ground.v), z_axis(b.u)) == 0.5 * sin(1rad_s * t); }
    }
}

#[test]
fn a_joint_may_hold_several_pairs_of_axes_perpendicular() {
    let t = 0.3_f64;
    let state = Twofold::default().solve(t).expect("a state");
    let [b, c] = [state.b().rotation, state.c().rotation];
    // Columns 0 and 1 are n and the direction that it is declared with.
    let found = [b[(2, 0)], c[(2, 0)], b[(0, 1)], b[(2, 1)], c[(0, 1)], c[(2, 1)]];
    let wanted = [0.0, 0.0, 0.1 * t.sin(), 0.3 * t.sin(), 0.2 * t.sin(), 0.2 * (2.0 * t).sin()];
    assert!(found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-14), "{found:?}, not {wanted:?}");

    let rotation = Crossed::default().solve(t).expect("a state").b().rotation;
    let turned = Rotation3::from_axis_angle(&Vector3::z_axis(), (0.5 * t.sin()).asin());
    assert!((rotation - turned.matrix()).norm() < 1e-14, "{rotation}");
}

mechanism! {
    /// A parallelogram in space, one of whose cranks is solved for alone.
    mechanism Parallelogram in space {
        ground { axis z = (0, 0, 1);  point C = (1m, 0m, 0m); }
        body crank { axis z = (0, 0, 1);  point P = (200mm, 0mm, 0mm); }
        body rocker { axis z = (0, 0, 1);  point P = (200mm, 0mm, 0mm);  start orientation = turn((0, 0, 1), -60deg); }
        joint near = revolute(ground.position, ground.z, crank.position, crank.z);
        joint far = revolute(ground.C, ground.z, rocker.position, rocker.z);
        joint rod = distance(crank.P, rocker.P, 1m);
        drive motor = drive_rotation(near, -60deg + 1rad_s * t);
        slice output alone = rocker;
    }
}

/// At a change point and beside it both cranks turn alike.
#[test]
fn a_body_solved_for_alone_keeps_its_angular_velocity_at_a_change_point() {
    let parallelogram = Parallelogram::default();
    for off in [0.0, -1e-7, 1e-6] {
        let state = parallelogram.solve_for_alone().solve(60_f64.to_radians() + off).expect("a state");
        let found = parallelogram.alone(&state).angular_velocity;
        assert!((found - Vector3::z()).norm() < 1e-6, "{off:e}: {found}");
    }
}
