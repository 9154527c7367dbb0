//! Redundant joints: solved as far as needed, and checked for the remaining rows.

use std::f64::consts::FRAC_PI_3;

use reuleaux::{Cause, Mechanism, PlanStage};
use reuleaux_wide::{F64x4, Lockstep};

reuleaux::mechanism! {
    /// A parallelogram with a third crank in the middle.
    pub mechanism Coupled {
        param middle: Length = 500mm;
        param speed: AngularVelocity = 2rad_s;
        ground { point A = (0m, 0m);  point B = (2m, 0m);  point C = (0.8m, 0m); }
        body crank  { point P = (500mm, 0mm); }
        body rod    { point Q = (2m, 0m);  point R = (0.8m, 0m); }
        body rocker { point P = (500mm, 0mm); }
        body third  { point P = (middle, 0mm); }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(ground.B, rocker.position);
        joint c = revolute(crank.P, rod.position);
        joint d = revolute(rod.Q, rocker.P);
        joint e = revolute(ground.C, third.position);
        redundant joint f = revolute(rod.R, third.P);
        drive input = drive_angle(crank, 60deg + speed * t);
        slice output pin = rod.Q;
        slice output lean = third.angle;
    }
}

reuleaux::mechanism! {
    /// A Scott Russell straight-line linkage, and a wall along the line that also holds the head: a checked coordinate that is zero.
    pub mechanism Straight {
        param length: Length = 300mm;
        ground { axis way = (1, 0); }
        body crank { point M = (length, 0mm); }
        body rod   { point M = (length, 0mm);  point T = (2 * length, 0mm);  start angle = 150deg; }
        body head  { }
        joint o = revolute(ground.position, crank.position);
        joint m = revolute(crank.M, rod.M);
        joint slide = point_on_line(ground.position, ground.way, rod.position);
        joint tip = revolute(rod.T, head.position);
        joint level = absolute_angle(head, 0rad);
        redundant joint wall = absolute_x(head.position, 0mm);
        drive input = drive_angle(crank, 30deg + 20deg * sin(1rad_s * t));
    }
}

/// The rod stays level, and all cranks turn together.
#[test]
fn a_third_crank_turns_with_the_others() {
    let mechanism = Coupled::default();
    assert_eq!((Coupled::<f64>::COORDINATES, Coupled::<f64>::EQUATIONS), (12, 13));
    let times = || (0..200).map(|k| f64::from(k) * 0.0025);
    for state in mechanism.sweep(times()) {
        let state = state.expect("a third crank as long as the others");
        let angle = FRAC_PI_3 + 2.0 * state.t;
        let [rod, third, rocker] = [state.rod(), state.third(), state.rocker()];
        for body in [third, rocker] {
            assert!((body.angle - angle).abs() < 1e-14, "{body:?}");
            assert!((body.angular_velocity - 2.0).abs() < 2e-14);
            assert!(body.angular_acceleration.abs() < 1e-13);
        }
        assert!(rod.angle.abs() < 1e-14 && rod.angular_velocity.abs() < 1e-14 && rod.angular_acceleration.abs() < 1e-13);
        assert!((rod.position.x - 0.5 * angle.cos()).abs() < 1e-15);
        // All rows hold, including the checked one.
        assert!(mechanism.phi(&state.q, state.t).amax() < 1e-14);
    }
}

#[test]
fn the_plan_says_what_is_checked() {
    let checked: Vec<&str> = Coupled::<f64>::PLAN
        .stages
        .iter()
        .filter_map(|stage| if let PlanStage::Checked(name) = stage { Some(*name) } else { None })
        .collect();
    assert_eq!(checked, ["f (2 of 2)"]);
    assert!(Coupled::<f64>::PLAN.to_string().contains("\ncheck    f (2 of 2)\n"));
}

/// With x of the rod's pin solved, the third crank is at arccos(x / r); the misfit appears in y.
#[test]
fn what_does_not_fit_is_named_with_its_row_and_by_how_much() {
    let mechanism = Coupled { middle: 0.501, ..Coupled::default() };
    let failure = mechanism.solve(0.25).expect_err("too long a crank");
    let Cause::DoesNotHold { row, residual } = failure.cause else { panic!("{failure}") };
    assert_eq!((row.joint, row.kind, row.index, row.unit), ("f", "revolute", 2, "m"));
    let off = |angle: f64| 0.5 * angle.sin() - (0.501_f64.powi(2) - (0.5 * angle.cos()).powi(2)).sqrt();
    assert!((residual - off(FRAC_PI_3 + 2.0 * failure.time)).abs() < 1e-15, "{residual}");
    assert_eq!(failure.to_string(), "`Coupled` does not fit at t = 0 s: joint `f` (revolute, row 2 of 2) is redundant and off by 1.15 mm");
    // Also away from the start, and in place.
    let mut state = Coupled::default().solve(0.0).expect("it fits");
    let before = state.clone();
    let failure = mechanism.advance(&mut state, 0.01).expect_err("too long a crank");
    assert!(matches!(failure.cause, Cause::DoesNotHold { .. }), "{failure}");
    assert_eq!((state, failure.time), (before, 0.01));
    let guess = Coupled::default().start();
    assert!(matches!(mechanism.solve_near(0.0, &guess).expect_err("too long").cause, Cause::DoesNotHold { .. }));
}

/// A misfit of a nanometre is detected; a rounding error is not a misfit.
#[test]
fn the_bound_is_that_of_rounding_errors() {
    let nearly = Coupled { middle: 0.5 + 1e-12, ..Coupled::default() };
    assert!(matches!(nearly.solve(0.1).expect_err("1e-12 m too long").cause, Cause::DoesNotHold { .. }));
    let rounded = Coupled { middle: 0.5 + f64::EPSILON, ..Coupled::default() };
    assert!(rounded.solve(0.1).is_ok());
}

#[test]
fn single_precision_has_its_own_roundings() {
    let mechanism = Coupled::<f32>::with_defaults();
    let mut last = 0;
    for state in mechanism.sweep((0..100).map(|k| k as f32 * 0.01)) {
        let state = state.expect("a third crank as long as the others");
        assert!((state.third().angle - (FRAC_PI_3 as f32 + 2.0 * state.t)).abs() < 2e-6);
        last += 1;
    }
    assert_eq!(last, 100);
    let off = Coupled { middle: 0.51_f32, ..mechanism };
    assert!(matches!(off.solve(0.1).expect_err("too long a crank").cause, Cause::DoesNotHold { .. }));
}

/// Equations that are not upstream of an output are neither solved nor checked.
#[test]
fn a_slice_checks_what_is_upstream_of_it() {
    let mechanism = Coupled { middle: 0.6, ..Coupled::default() };
    let pin = mechanism.solve_for_pin().solve(0.25).expect("the third crank is not upstream of the pin").output();
    let angle = FRAC_PI_3 + 0.5;
    assert!((pin.value.y - 0.5 * angle.sin()).abs() < 1e-15);
    let failure = mechanism.solve_for_lean().solve(0.25).expect_err("the third crank does not fit");
    assert!(matches!(failure.cause, Cause::DoesNotHold { .. }), "{failure}");
    let lean = Coupled::default().solve_for_lean().solve(0.25).expect("it fits").output();
    assert!((lean.value - angle).abs() < 1e-14);
}

#[test]
fn prepared_mechanisms_check_as_well() {
    let mechanism = Coupled::default().prepared();
    let mut state = mechanism.solve(0.0).expect("it fits");
    mechanism.advance(&mut state, 0.01).expect("it fits");
    assert!(Coupled { middle: 0.4, ..Coupled::default() }.prepared().solve(0.0).is_err());
}

#[test]
fn one_lane_that_does_not_fit_stays_alone() {
    let each = [0.5, 0.5, 0.501, 0.5].map(|middle| Coupled { middle, ..Coupled::default() });
    let mut four = Lockstep::<_, F64x4, 4, 12>::new(each, [0.0; 4]);
    for step in 1..=20 {
        four.advance([f64::from(step) * 0.01; 4]);
    }
    for lane in [0, 1, 3] {
        let state = four.lane(lane).expect("it fits");
        assert!((state.q[11] - (FRAC_PI_3 + 0.4)).abs() < 1e-14);
    }
    assert!(matches!(four.lane(2).expect_err("too long a crank").cause, Cause::DoesNotHold { .. }));
}

reuleaux::mechanism! {
    /// A row of coupled cranks on one shaft, each with a third crank: too many to be solved together.
    pub mechanism Row {
        let sets = 12;
        ground { for i in 0..sets { point A[i] = (i * 3m, 0m);  point B[i] = (i * 3m + 2m, 0m);  point C[i] = (i * 3m + 1m, 0m); } }
        body shaft { }
        joint bearing = revolute(ground.position, shaft.position);
        drive motor = drive_angle(shaft, 60deg + 1rad_s * t);
        for i in 0..sets { part set[i] = Set(ground.A[i], ground.B[i], ground.C[i], shaft); }
        component Set(A: Point, B: Point, C: Point, shaft: Body) {
            param middle: Length = 500mm;
            body crank  { point P = (500mm, 0mm);  start angle = 60deg; }
            body rod    { point Q = (2m, 0m);  point R = (1m, 0m);  start angle = 0deg; }
            body rocker { point P = (500mm, 0mm);  start angle = 60deg; }
            body third  { point P = (middle, 0mm);  start angle = 60deg; }
            joint a = revolute(A, crank.position);
            joint b = revolute(B, rocker.position);
            joint c = revolute(crank.P, rod.position);
            joint d = revolute(rod.Q, rocker.P);
            joint e = revolute(C, third.position);
            joint turn = parallel(shaft, crank);
            redundant joint f = revolute(rod.R, third.P);
        }
    }
}

/// With shared code, each part is checked by itself.
#[test]
fn many_parts_are_checked_one_by_one() {
    assert_eq!(Row::<f64>::EQUATIONS - Row::<f64>::COORDINATES, 12);
    let mut row = Row::default();
    let state = row.solve(0.5).expect("it fits");
    for set in state.set() {
        assert!((set.third().angle - (FRAC_PI_3 + 0.5)).abs() < 1e-14);
    }
    let mut moving = row.solve(0.0).expect("it fits");
    for step in 1..=50 {
        row.advance(&mut moving, f64::from(step) * 0.01).expect("it fits");
    }
    assert!((moving.q - state.q).amax() < 1e-13);
    row.set[7].middle = 0.499;
    assert!(matches!(row.advance(&mut moving, 0.51).expect_err("one crank is too short").cause, Cause::DoesNotHold { .. }));
    let failure = row.solve(0.5).expect_err("one crank is too short");
    let Cause::DoesNotHold { row, .. } = failure.cause else { panic!("{failure}") };
    assert_eq!(row.joint, "set[7].f");
}

reuleaux::mechanism! {
    /// A table on two columns, one of which is redundant, beside a rotating crank: the checked equations are at rest.
    pub mechanism Table {
        param right: Length = 700mm;
        ground { point L = (0m, 0m);  point R = (1m, 0m); }
        body left  { point top = (0mm, 700mm);  start angle = 0; }
        body top   { point L = (0mm, 0mm);  point R = (1m, 0mm);  start angle = 0; }
        body crank { }
        joint foot = weld(ground.L, left.position);
        joint head = weld(left.top, top.L);
        redundant joint column = distance(ground.R, top.R, right);
        joint axle = revolute(ground.L, crank.position);
        drive motor = drive_angle(crank, 1rad_s * t);
        output end = top.R;
    }
}

#[test]
fn what_rests_is_checked_where_it_begins() {
    assert!(Table::default().solve(1.0).is_ok());
    let failure = Table { right: 0.69 }.solve(1.0).expect_err("a short column");
    let Cause::DoesNotHold { row, residual } = failure.cause else { panic!("{failure}") };
    assert_eq!((row.joint, row.unit), ("column", "m²"));
    assert!((residual - (0.49 - 0.69_f64 * 0.69)).abs() < 1e-15);
}

reuleaux::mechanism! {
    /// A slide on a jib on two stays, with a redundant guide: moving coordinates are checked against coordinates at rest.
    pub mechanism Jib {
        param offset: Length = 100mm;
        ground { point L = (0m, 0m);  point R = (2m, 0m); }
        body left  { point top = (1.2m, 0mm);  start angle = 60deg; }
        body right { point top = (1.1m, 0mm);  start angle = 120deg; }
        body jib   { point L = (0mm, 0mm);  point R = (1m, 0mm);  point Q = (0mm, 100mm);  axis way = (1, 0);  start angle = 0; }
        body slide { point S = (0mm, offset);  start x = 1m; }
        body crank { }
        joint a = revolute(ground.L, left.position);
        joint b = revolute(ground.R, right.position);
        joint c = revolute(left.top, jib.L);
        joint d = revolute(right.top, jib.R);
        joint stay = distance(ground.R, jib.L, 1.7m);
        joint guide = translational(jib.way, jib.L, slide.position);
        redundant joint second = point_on_line(jib.Q, jib.way, slide.S);
        drive push = drive_along(guide, 400mm + 100mm * sin(2rad_s * t));
        joint axle = revolute(ground.L, crank.position);
        drive motor = drive_angle(crank, 1rad_s * t);
    }
}

#[test]
fn what_moves_is_checked_against_what_rests() {
    let mechanism = Jib::default();
    let whole: Vec<_> = mechanism.sweep((0..50).map(|k| f64::from(k) * 0.02)).collect::<Result<_, _>>().expect("it fits");
    let mut state = mechanism.solve(0.0).expect("it fits");
    for expected in &whole {
        mechanism.advance(&mut state, expected.t).expect("it fits");
        assert!((state.q - expected.q).amax() < 1e-14);
        assert!(mechanism.phi(&state.q, state.t).amax() < 1e-14);
    }
    let off = Jib { offset: 0.1 + 1e-9 };
    assert!(matches!(off.solve(0.5).expect_err("the guides are not alike").cause, Cause::DoesNotHold { .. }));
    assert!(matches!(off.advance(&mut state, 1.0).expect_err("the guides are not alike").cause, Cause::DoesNotHold { .. }));
}

/// Generic code needs no special case.
#[test]
fn it_is_a_mechanism_like_any_other() {
    fn ends<M: Mechanism<f64, N>, const N: usize>(mechanism: &M) -> usize {
        mechanism.sweep([0.0, 0.1, 0.2]).filter(Result::is_ok).count()
    }
    assert_eq!((ends(&Coupled::default()), ends(&Table::default())), (3, 3));
}

/// The checked coordinate is near zero, and the coordinates that it is computed from have rounding errors of lengths.
#[test]
fn a_place_that_is_zero_is_held() {
    for length in [0.1, 0.3, 0.37, 1.0, 1.3, 7e-6, 3e5] {
        let mechanism = Straight { length };
        for state in mechanism.sweep((0..1000).map(|k| f64::from(k) * 0.01)) {
            let state = state.expect("a head that is where the wall is");
            assert!(state.head().position.x.abs() <= 1e-14 * length);
        }
        assert!(mechanism.solve(5.0).is_ok());
    }
}

reuleaux::mechanism! {
    /// A parallelogram of three cranks that is lifted at its coupler, near the top.
    mechanism Lift {
        ground { point A = (0m, 0m);  point B = (2m, 0m);  point C = (1m, 0m); }
        body crank { point P = (500mm, 0mm);  start angle = 60deg; }
        body rod { point Q = (2m, 0m);  point R = (1m, 0m); }
        body rocker { point P = (500mm, 0mm);  start angle = 60deg; }
        body third { point P = (500mm, 0mm);  start angle = 60deg; }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(ground.B, rocker.position);
        joint c = revolute(crank.P, rod.position);
        joint d = revolute(rod.Q, rocker.P);
        joint e = revolute(ground.C, third.position);
        redundant joint f = revolute(rod.R, third.P);
        drive lift = drive_y(rod.position, 433.0127mm + 1mm_s * t);
    }
}

reuleaux::mechanism! {
    /// A door whose edge is driven to 10 mm before its end, and a body beside it.
    mechanism Beside {
        body door { point tip = (300mm, 0mm);  start angle = 45deg; }
        joint h = revolute((0m, 0m), door.position);
        drive d = drive_y(door.tip, 290mm + 1mm_s * t);
        ground { point H = (1m, 0m); }
        body other { point A = (100mm, 0mm);  point B = (0mm, 200mm); }
        joint k = revolute(ground.H, other.position);
        redundant joint r = distance(other.A, ground.H, 100mm);
        drive e = drive_x(other.B, 1.02m);
    }
}

/// sin φ = y / 500 mm, and sin φ = y / 300 mm; the other body turns to where 200 mm sin φ = −20 mm.
#[test]
fn redundant_joints_are_accepted_near_the_end_of_a_drive() {
    let lift = Lift::default();
    for t in [0.0, 1.0, 60.0] {
        let state = lift.solve(t).expect("a state");
        let wanted = ((0.433_012_7 + 1e-3 * t) / 0.5_f64).asin();
        assert!((state.crank().angle - wanted).abs() < 1e-13 && (state.third().angle - wanted).abs() < 1e-13);
    }
    let beside = Beside::default();
    for t in [0.0, 1.0, 9.0] {
        let state = beside.solve(t).expect("a state");
        assert!((state.door().angle - ((0.29 + 1e-3 * t) / 0.3_f64).asin()).abs() < 1e-13);
        assert!((state.other().angle.sin() + 0.1).abs() < 1e-14);
    }
}
