//! A mechanism that is moved as a whole has the same motion.

use proptest::prelude::*;
use reuleaux::nalgebra::{Rotation2, Vector2};
use reuleaux_tests::declared;
use reuleaux_tests::stress::FourBar;

use super::{cases, difference};

declared! {
    /// A crank with a slider on one guide and a follower arm at a fixed distance, moved and rotated as a whole.
    Carried (place_x: Length = 0, place_y: Length = 0, turn: Angle = 0, crank_length: Length = 0.1, speed: AngularVelocity = 3) {
        let c = cos(turn);
        let s = sin(turn);
        ground {
            point O = (place_x, place_y);
            point G = (place_x - 20mm * s, place_y + 20mm * c);
            axis guide = (c, s);
            point P = (place_x + 300mm * c + 400mm * s, place_y + 300mm * s - 400mm * c);
        }
        body crank  { point O = (0, 0);  point A = (crank_length, 0);  start angle = 0.5 + turn; }
        body rod    { point A = (0, 0);  point B = (0.35, 0);  point K = (0.2, 0.1);  start angle = -0.1 + turn; }
        body slider { point B = (0, 0);  start position = (place_x + 430mm * c, place_y + 430mm * s);  start angle = turn; }
        body arm    { point P = (0, 0);  point E = (0.25, 0);  start angle = 2.4 + turn; }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, rod.A);
        joint b = revolute(rod.B, slider.B);
        joint rail = translational(ground.guide, ground.G, slider.B, c: turn);
        joint p = revolute(ground.P, arm.P);
        joint tie = distance(rod.K, arm.E, 0.45);
        drive motor = drive_angle(crank, turn + 0.5 + speed * t);
    } outputs CarriedState {
        tip = [arm.E];
    }
}

/// A state after rotating the whole about the origin and then translating it.
fn carried<const N: usize>(state: &reuleaux::State<f64, N>, place: Vector2<f64>, turn: f64) -> reuleaux::State<f64, N> {
    let mut moved = state.clone();
    let rotation = Rotation2::new(turn);
    for body in (0..N).step_by(3) {
        let values = &mut *moved;
        for (vector, shift) in [(&mut values.q, place), (&mut values.qd, Vector2::zeros()), (&mut values.qdd, Vector2::zeros())] {
            let turned = rotation * Vector2::new(vector[body], vector[body + 1]) + shift;
            (vector[body], vector[body + 1]) = (turned.x, turned.y);
        }
        moved.q[body + 2] += turn;
    }
    moved
}

proptest! {
    #![proptest_config(cases(64))]

    /// The start is moved too, as the guess.
    #[test]
    fn a_mechanism_with_every_joint_moves_the_same_elsewhere(
        (x, y, turn) in (-3.0..3.0, -3.0..3.0, -3.0..3.0), crank_length in 0.05..0.12, speed in -4.0..4.0, t in 0.0..2.0
    ) {
        let here = Carried { crank_length, speed, ..Default::default() };
        let there = Carried { place_x: x, place_y: y, turn, ..here };
        let first = here.solve(0.0).unwrap();
        let origin = there.solve_near(0.0, &carried(&first, Vector2::new(x, y), turn).q).unwrap();
        let (moved, later) = (there.solve_from(t, &origin).unwrap(), here.solve_from(t, &first).unwrap());
        let expected = carried(&later, Vector2::new(x, y), turn);
        let difference = difference(&moved, &expected);
        // Positions of about 3 m are rounded by 4e-16 m, which is 4e-15 of the crank; accelerations are about 10 in these units.
        prop_assert!(difference <= 1e-12, "{difference:e}");
        prop_assert_eq!(moved.branch, expected.branch);
        let tip = there.tip(&moved);
        let expected = Rotation2::new(turn) * here.tip(&later).rate;
        prop_assert!((tip.rate - expected).amax() <= 1e-12);
    }

    #[test]
    fn a_four_bar_with_turned_ground_points_moves_the_same(
        (x, y, turn) in (-2.0..2.0, -2.0..2.0, -3.0..3.0), crank in 0.2..0.9, coupler in 2.0..2.6, rocker in 1.8..2.4, angle in -3.0..3.0
    ) {
        let base = 2.0;
        let links = FourBar { ground_D_x: base, crank_B_x: crank, coupler_C_x: coupler, rocker_C_x: rocker, ..Default::default() };
        let here = FourBar { c0: angle, c1: 1.5, ..links };
        let place = Vector2::new(x, y);
        let end = place + Rotation2::new(turn) * Vector2::new(base, 0.0);
        let there = FourBar { ground_A_x: x, ground_A_y: y, ground_D_x: end.x, ground_D_y: end.y, c0: angle + turn, ..here };
        let guess = closed(crank, coupler, rocker, base, angle);
        let state = here.solve_near(0.0, &guess).unwrap();
        let moved = there.solve_near(0.0, &carried(&state, place, turn).q).unwrap();
        let difference = difference(&moved, &carried(&state, place, turn));
        prop_assert!(difference <= 1e-12 * state.condition, "{difference:e}, condition {:e}", state.condition);
    }
}

/// The open assembly of a four-bar in closed form.
fn closed(crank: f64, coupler: f64, rocker: f64, base: f64, angle: f64) -> reuleaux::nalgebra::SVector<f64, 9> {
    let (bx, by) = (crank * angle.cos(), crank * angle.sin());
    let (dx, dy) = (base - bx, -by);
    let diagonal = dx.hypot(dy);
    let corner = ((coupler * coupler + diagonal * diagonal - rocker * rocker) / (2.0 * coupler * diagonal)).acos();
    let course = dy.atan2(dx) + corner;
    let (cx, cy) = (bx + coupler * course.cos(), by + coupler * course.sin());
    [0.0, 0.0, angle, bx, by, course, base, 0.0, cy.atan2(cx - base)].into()
}
