//! Which assembly the declared start of hinged bodies chooses.

use reuleaux::mechanism;

mechanism! {
    /// An arm on a cylinder, and a second one on the first; frames lie in the middle of the arms.
    mechanism Below in space {
        ground { axis z = (0, 0, 1);  point C = (1m, 0m, 0m);  point D = (2m, 0m, 0m); }
        body arm { axis z = (0, 0, 1);  point O = (-0.5m, 0m, 0m);  point A = (0.5m, 0m, 0m);  start position = (0.3m, -0.4m, 0m); }
        body hand { axis z = (0, 0, 1);  point A = (-0.5m, 0m, 0m);  point B = (0.5m, 0m, 0m);  start position = (1.0m, -0.4m, 0m); }
        joint shoulder = revolute(ground.position, ground.z, arm.O, arm.z);
        joint elbow = revolute(hand.A, hand.z, arm.A, arm.z);
        drive cylinder = drive_distance(ground.C, arm.A, 1.0m);
        drive other = drive_distance(ground.D, hand.B, 0.8m);
    }
}

mechanism! {
    #[allow(far_start)]
    /// The same arm, of which the orientation at the start is declared.
    mechanism Above in space {
        ground { axis z = (0, 0, 1);  point C = (1m, 0m, 0m); }
        body arm {
            axis z = (0, 0, 1);  point O = (-0.5m, 0m, 0m);  point A = (0.5m, 0m, 0m);
            start position = (0.3m, -0.4m, 0m);  start orientation = turn((0, 0, 1), 50deg);
        }
        joint shoulder = revolute(ground.position, ground.z, arm.O, arm.z);
        drive cylinder = drive_distance(ground.C, arm.A, 1.0m);
    }
}

mechanism! {
    #[allow(far_start)]
    /// The arm that is placed, and a hand whose orientation against ground is declared.
    mechanism Turned in space {
        ground { axis z = (0, 0, 1);  point C = (1m, 0m, 0m);  point D = (2m, 0m, 0m); }
        body arm { axis z = (0, 0, 1);  point O = (-0.5m, 0m, 0m);  point A = (0.5m, 0m, 0m);  start position = (0.3m, -0.4m, 0m); }
        body hand { axis z = (0, 0, 1);  point A = (-0.5m, 0m, 0m);  point B = (0.5m, 0m, 0m);  start orientation = turn((0, 0, 1), 60deg); }
        joint shoulder = revolute(ground.position, ground.z, arm.O, arm.z);
        joint elbow = revolute(arm.A, arm.z, hand.A, hand.z);
        drive cylinder = drive_distance(ground.C, arm.A, 1.0m);
        drive other = drive_distance(ground.D, hand.B, 0.8m);
    }
}

mechanism! {
    #[allow(far_start)]
    /// The hand on a bracket welded to a slide, which keep the orientation of the arm.
    mechanism Sliding in space {
        ground { axis z = (0, 0, 1);  point C = (1m, 0m, 0m);  point D = (2m, 0m, 0m); }
        body arm { axis x = (1, 0, 0);  axis z = (0, 0, 1);  point O = (-0.5m, 0m, 0m);  point A = (0.5m, 0m, 0m);  start position = (0.3m, -0.4m, 0m); }
        body slide { axis x = (1, 0, 0);  axis z = (0, 0, 1); }
        body bracket { axis z = (0, 0, 1); }
        body hand { axis z = (0, 0, 1);  point A = (-0.5m, 0m, 0m);  point B = (0.5m, 0m, 0m);  start orientation = turn((0, 0, 1), 60deg); }
        joint shoulder = revolute(ground.position, ground.z, arm.O, arm.z);
        joint guide = translational(arm.A, arm.x, slide.position, slide.x);
        joint bolts = weld(slide.position, slide.z, bracket.position, bracket.z);
        joint elbow = revolute(bracket.position, bracket.z, hand.A, hand.z);
        drive cylinder = drive_distance(ground.C, arm.A, 1.0m);
        drive sliding = drive_translation(guide, 0m);
        drive other = drive_distance(ground.D, hand.B, 0.8m);
    }
}

#[test]
fn a_hinged_body_starts_on_the_side_of_its_declared_position() {
    let state = Below::default().solve(0.0).unwrap();
    // The points O, C and A are 1 m apart.
    let [x, y, z] = state.arm().position.into();
    let (sine, cosine) = 60_f64.to_radians().sin_cos();
    assert!((x - 0.5 * cosine).abs() < 1e-14 && (y + 0.5 * sine).abs() < 1e-14 && z == 0.0, "{x} {y} {z}");
    // The hand's end is on the right of the line from A to D, where the declared position is.
    let hand: [f64; 3] = state.hand().position.into();
    let (to_d, to_hand) = ([2.0 - 2.0 * x, -2.0 * y], [hand[0] - 2.0 * x, hand[1] - 2.0 * y]);
    let declared = [1.0 - 2.0 * x, -0.4 - 2.0 * y];
    let side = |v: [f64; 2]| (to_d[0] * v[1] - to_d[1] * v[0]).signum();
    assert_eq!(side(to_hand), side(declared));
}

#[test]
fn a_declared_orientation_comes_before_the_position() {
    let state = Above::default().solve(0.0).unwrap();
    assert!(state.arm().position[1] > 0.0);
}

#[test]
fn a_declared_orientation_is_that_against_ground_on_a_placed_body_as_well() {
    // The hand lies to one side or the other of the line from A to D, which is √3 m long and rises by 30°.
    let side = ((1.0 + 3.0 - 0.64) / (2.0 * 3_f64.sqrt())).acos();
    let hinged = Turned::default().solve(0.0).unwrap().hand().orientation();
    let on_bracket = Sliding::default().solve(0.0).unwrap().hand().orientation();
    for orientation in [hinged, on_bracket] {
        let along = orientation * reuleaux::nalgebra::Vector3::x();
        let angle = along[1].atan2(along[0]);
        assert!((angle - (30_f64.to_radians() + side)).abs() < 1e-14, "{angle}");
    }
}

mechanism! {
    /// A shaft with two crosses and a sliding sleeve: some of its angles are zero at the start by symmetry.
    mechanism Shaft in space {
        let x = 1m;
        ground { point O = (x, -x, 0.5 * x);  axis a = (1, 0, 0.2) from (0, 1, 0);  point E = (x + 600mm, -x, 0.5 * x + 120mm + 50mm); }
        body input { axis a = (0, 0, 1) from (1, 0, 0);  point end = (0mm, 0mm, 200mm);  axis arm = (1, 0, 0); }
        body tube {
            start orientation = turn((0, 1, 0), -18deg);
            axis a = (1, 0, 0) from (0, 0, 1);  axis arm = (0, 0, 1);
        }
        body sleeve { axis a = (1, 0, 0) from (0, 0, 1);  point end = (200mm, 0mm, 0mm);  axis arm = (0, 0, 1); }
        body output { axis a = (1, 0, 0);  axis arm = (0, 1, 0); }
        joint b = revolute(ground.O, ground.a, input.position, input.a);
        joint u1 = universal(input.end, input.arm, tube.position, tube.arm);
        joint slip = translational(tube.position, tube.a, sleeve.position, sleeve.a);
        joint u2 = universal(sleeve.end, sleeve.arm, output.position, output.arm);
        joint e = revolute(ground.E, ground.a, output.position, output.a);
        drive motor = drive_rotation(b, 60rpm * t);
    }
}

#[test]
fn corrections_of_angles_that_are_zero_by_symmetry_settle() {
    let mechanism = Shaft::default();
    assert!(mechanism.solve(0.0).is_ok(), "{:?}", mechanism.solve(0.0).err());
    assert!(mechanism.sweep((0..20).map(|k| 0.05 * f64::from(k))).all(|state| state.is_ok()));
}

mechanism! {
    /// Sarrus' linkage: the place of the desk is declared, and none of the angles of the legs.
    mechanism Sarrus in space {
        ground {
            point A = (100mm, 0mm, 0mm);  axis y = (0, 1, 0) from (1, 0, 0);
            point B = (0mm, 100mm, 0mm);  axis x = (1, 0, 0) from (0, 1, 0);
        }
        body left        { axis y = (0, 1, 0) from (1, 0, 0);  point knee = (200mm, 0mm, 0mm); }
        body left_shank  { axis y = (0, 1, 0) from (1, 0, 0);  point end = (-200mm, 0mm, 0mm); }
        body right       { axis x = (1, 0, 0) from (0, 1, 0);  point knee = (0mm, 200mm, 0mm); }
        body right_shank { axis x = (1, 0, 0) from (0, 1, 0);  point end = (0mm, -200mm, 0mm); }
        body desk {
            point A = (100mm, 0mm, 0mm);  axis y = (0, 1, 0) from (1, 0, 0);
            point B = (0mm, 100mm, 0mm);  axis x = (1, 0, 0) from (0, 1, 0);
            start position = (0mm, 0mm, 250mm);
        }
        joint a = revolute(ground.A, ground.y, left.position, left.y);
        joint b = revolute(left.knee, left.y, left_shank.position, left_shank.y);
        joint c = revolute(left_shank.end, left_shank.y, desk.A, desk.y);
        joint d = revolute(ground.B, ground.x, right.position, right.x);
        joint e = revolute(right.knee, right.x, right_shank.position, right_shank.x);
        redundant joint f = revolute(right_shank.end, right_shank.x, desk.B, desk.x);
        drive lift = drive_z(desk.position, 250mm + 20mm_s * t);
        output knee = b.angle;
    }
}

#[test]
fn a_position_says_nothing_of_an_angle_at_a_hinge_that_could_be_anywhere() {
    let sarrus = Sarrus::default();
    let state = sarrus.solve(0.0).unwrap();
    // Upside down the desk would stand at the same place, with the axes of `f` against each other.
    assert!(state.desk().orientation().angle() < 1e-14, "{}", state.desk().orientation());
    // Both halves of a leg rise by half of 250 mm.
    assert!((sarrus.knee(&state).value - 2.0 * (0.125_f64 / 0.2).asin()).abs() < 1e-14, "{}", sarrus.knee(&state).value);
}
