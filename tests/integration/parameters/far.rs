//! Far from the defaults the declared assembly is kept, or the end of its branch is reported.

use reuleaux::{Cause, Stages, mechanism};
use reuleaux_tests::samples;
use std::f64::consts::TAU;

mechanism! {
    /// A four-bar with the pin between coupler and rocker to the left of the line from the crank pin to the rocker's pivot.
    pub mechanism Left {
        param crank_length: Length = 100mm;
        param coupler_length: Length = 350mm;
        param rocker_length: Length = 300mm;
        param base: Length = 400mm;
        ground { point C = (base, 0mm); }
        body crank { point A = (crank_length, 0mm); }
        body coupler { point B = (coupler_length, 0mm); }
        body rocker { point B = (rocker_length, 0mm); start angle = 70deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(crank, 1turn * t / 1s);
        output pin = rocker.B;
    }
}

mechanism! {
    /// Its mirror image.
    pub mechanism Right {
        param crank_length: Length = 100mm;
        param coupler_length: Length = 350mm;
        param rocker_length: Length = 300mm;
        param base: Length = 400mm;
        ground { point C = (base, 0mm); }
        body crank { point A = (crank_length, 0mm); }
        body coupler { point B = (coupler_length, 0mm); }
        body rocker { point B = (rocker_length, 0mm); start angle = -70deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(crank, 1turn * t / 1s);
        output pin = rocker.B;
    }
}

/// Crank, coupler, rocker and base as declared.
const DECLARED: [f64; 4] = [0.1, 0.35, 0.3, 0.4];

/// Margin by which the triangle of coupler, rocker and the line between their pivots closes at a crank angle; negative if it does not
/// close.
fn margin([crank, coupler, rocker, base]: [f64; 4], angle: f64) -> f64 {
    let way = (base - crank * angle.cos()).hypot(crank * angle.sin());
    (coupler + rocker - way).min(way - (coupler - rocker).abs())
}

/// Lengths at a fraction of the line from the declared lengths.
fn between(lengths: [f64; 4], share: f64) -> [f64; 4] {
    core::array::from_fn(|i| DECLARED[i] + share * (lengths[i] - DECLARED[i]))
}

/// The pin as the intersection of two circles, to the left or right of the line from the crank pin to the rocker's pivot.
fn pin([crank, coupler, rocker, base]: [f64; 4], angle: f64, side: f64) -> [f64; 2] {
    let (ax, ay) = (crank * angle.cos(), crank * angle.sin());
    let (x, y) = (base - ax, -ay);
    let square = x * x + y * y;
    let along = (coupler * coupler - rocker * rocker + square) / (2.0 * square);
    let across = side * (coupler * coupler / square - along * along).sqrt();
    [ax + x * along - y * across, ay + y * along + x * across]
}

/// Fraction of the line at which the loop first opens.
fn opens(lengths: [f64; 4]) -> Option<f64> {
    let is_open = |share: f64| margin(between(lengths, share), 0.0) < 0.0;
    const STEPS: usize = 4000;
    let first = (0..=STEPS).map(|step| step as f64 / STEPS as f64).find(|share| is_open(*share))?;
    let (mut closed, mut open) = (first - 1.0 / STEPS as f64, first);
    for _ in 0..60 {
        let middle = 0.5 * (closed + open);
        if is_open(middle) { open = middle } else { closed = middle }
    }
    Some(closed)
}

/// Number of cases by outcome.
#[derive(Default, Debug)]
struct Count {
    followed: usize,
    found_beyond: usize,
    lost: usize,
    open: usize,
}

macro_rules! follows {
    ($mechanism:ident, $side:expr, $lengths:expr, $count:expr) => {{
        let (side, lengths, count): (f64, [f64; 4], &mut Count) = ($side, $lengths, $count);
        let [crank_length, coupler_length, rocker_length, base] = lengths;
        let mechanism = $mechanism { crank_length, coupler_length, rocker_length, base };
        let (end, closes) = (opens(lengths), margin(lengths, 0.0));
        match mechanism.solve(0.0) {
            Ok(state) => {
                let (found, expected) = (mechanism.pin(&state).value, pin(lengths, 0.0, side));
                let off = (found.x - expected[0]).hypot(found.y - expected[1]);
                // At a fold both assemblies coincide, and the effect of a rounding error is its square root.
                assert!(closes > -1e-12, "{lengths:?} closed by {closes}");
                assert!(off < 1e-12 / closes.abs().max(1e-12).sqrt(), "{lengths:?} is mirrored: {off}");
                if end.is_none() { count.followed += 1 } else { count.found_beyond += 1 }
            }
            Err(failure) => {
                let Some(at) = end else { panic!("{failure} though {lengths:?} can be followed") };
                let said = failure.end.unwrap_or_else(|| panic!("{failure} without an end"));
                assert!((said.lambda - at).abs() < 1e-6, "{failure}, it is {at}");
                assert!(["coupler", "rocker"].contains(&said.coordinate.body) && ["a", "b", "c"].contains(&said.row.joint));
                let there = mechanism.interpolated(said.lambda).expect("parameters between");
                assert!((there.base - between(lengths, said.lambda)[3]).abs() < 1e-15);
                let last = failure.last.as_ref().expect("the last state before the end");
                assert!(side * (last.q[8] - last.q[5]).sin() > 0.0 && last.condition > 1e3, "{failure} was left before");
                match failure.cause {
                    // One of two rows has at least 1/√2 of the gap.
                    Cause::DoesNotClose { gap, .. } => {
                        assert!(closes < 0.0 && gap > -0.7 * closes, "{failure}: it lacks {closes}");
                        count.open += 1;
                    }
                    Cause::BranchLost { .. } => count.lost += 1,
                    _ => assert!(closes.abs() < 1e-4, "{failure}: it lacks {closes}"),
                }
            }
        }
    }};
}

#[test]
fn lengths_of_a_third_to_three_times_keep_the_assembly_or_end_where_it_folds() {
    let mut random = fastrand::Rng::with_seed(21);
    let mut count = Count::default();
    for _ in 0..samples(60, 300) {
        let lengths = DECLARED.map(|length| length * 3f64.powf(2.0 * random.f64() - 1.0));
        follows!(Left, 1.0, lengths, &mut count);
        follows!(Right, -1.0, lengths, &mut count);
    }
    assert!(count.followed > samples(40, 200) && count.open > samples(10, 50), "{count:?}");
}

#[test]
fn a_crank_that_turns_no_more_ends_where_coupler_and_rocker_are_in_line() {
    // With the declared lengths the crank rotates fully; with a shorter coupler it oscillates.
    let swinging = [0.1, 0.15, 0.3, 0.4];
    let [crank_length, coupler_length, rocker_length, base] = swinging;
    assert!(margin(swinging, 0.0) > 0.0 && margin(swinging, TAU / 2.0) < 0.0);
    let reach = coupler_length + rocker_length;
    let angle = ((base * base + crank_length * crank_length - reach * reach) / (2.0 * base * crank_length)).acos();
    let failure = Left { crank_length, coupler_length, rocker_length, base }.solve(0.5).expect_err("it does not come to half a turn");
    assert!((failure.time - angle / TAU).abs() < 1e-7, "{failure}");
    assert_eq!(failure.end, None);
    assert!(matches!(failure.cause, Cause::Singular { .. }), "{failure}");
    let other = Right { crank_length, coupler_length, rocker_length, base }.solve(-0.5).expect_err("nor the other way");
    assert!((other.time + angle / TAU).abs() < 1e-7, "{other}");
}

#[test]
fn where_no_assembly_exists_it_is_said_by_how_much_and_since_when() {
    let failure = Left { rocker_length: 0.02, coupler_length: 0.2, ..Left::default() }.solve(0.0).expect_err("it is 80 mm short");
    let text = failure.to_string();
    assert!(text.starts_with("`Left` was not assembled at t = 0 s: where the search ended, joint `"), "{text}");
    // 0.65 - 0.43 s = 0.3
    assert!(text.contains("; on the way from its defaults to these parameters the branch ends at 81.3953 %, where joint `"), "{text}");
    assert!((failure.end.expect("the branch ends").lambda - 0.35 / 0.43).abs() < 1e-7);
}

#[test]
fn single_precision_ends_there_as_well() {
    let left = Left::<f32> { rocker_length: 0.02, coupler_length: 0.2, ..Left::with_defaults() };
    let end = left.solve(0.0).expect_err("it is 80 mm short").end.expect("the branch ends");
    assert!((end.lambda - 0.35 / 0.43).abs() < 2e-3, "{end:?}");
}

#[test]
fn each_way_there_leads_to_the_same_assembly() {
    // In one step, or in many steps that each start from the result of the one before.
    let mut random = fastrand::Rng::with_seed(5);
    for _ in 0..30 {
        let lengths = DECLARED.map(|length| length * 3f64.powf(2.0 * random.f64() - 1.0));
        if opens(lengths).is_some() {
            continue;
        }
        let mechanism = |share| {
            let [crank_length, coupler_length, rocker_length, base] = between(lengths, share);
            Left { crank_length, coupler_length, rocker_length, base }
        };
        let mut guess = mechanism(0.0).solve(0.0).expect("the defaults").q;
        for step in 1..=500 {
            guess = mechanism(f64::from(step) / 500.0).solve_near(0.0, &guess).expect("it closes everywhere").q;
        }
        let at_once = mechanism(1.0).solve(0.0).expect("it can be followed");
        assert!((at_once.q - guess).norm() < 1e-9, "{lengths:?}");
    }
}

mechanism! {
    /// A cart on a rail, held by a rod at a distance from a post beside the rail.
    pub mechanism Cart {
        param reach: Length = 100m;
        param aside: Length = 30m;
        body cart { start x = 90m; }
        joint rail = { cart.position.y == 0m; cart.angle == 0; }
        joint rod = distance((0m, aside), cart.position, reach);
    }
}

#[test]
fn what_nothing_ends_is_followed_however_far_it_goes() {
    for reach in [101.0, 1e3, 1e5, 1e7, 1e10, 1e12, 31.0, 30.01] {
        for aside in [30.0, 0.0, -30.0, 1.0] {
            let state = Cart { reach, aside }.solve(0.0).unwrap_or_else(|failure| panic!("{failure} at {reach} and {aside}"));
            let right = f64::sqrt((reach - aside) * (reach + aside));
            assert!((state.cart().position.x / right - 1.0).abs() < 1e-12, "{} for {right}", state.cart().position.x);
        }
    }
}

#[test]
fn a_linkage_of_any_size_is_the_declared_one_made_larger() {
    let mut random = fastrand::Rng::with_seed(3);
    for scale in [1e-9, 1e-4, 10.0, 1e4, 1e8] {
        for _ in 0..5 {
            let lengths = DECLARED.map(|length| scale * length * (1.0 + 0.05 * random.f64()));
            let [crank_length, coupler_length, rocker_length, base] = lengths;
            let mechanism = Left { crank_length, coupler_length, rocker_length, base };
            let state = mechanism.solve(0.0).unwrap_or_else(|failure| panic!("{failure} at {scale}"));
            let (found, right) = (mechanism.pin(&state).value, pin(lengths, 0.0, 1.0));
            assert!((found.x - right[0]).hypot(found.y - right[1]) < 1e-14 * scale, "{scale}");
        }
    }
}

mechanism! {
    /// A boom on a cylinder whose eye may be elsewhere.
    mechanism Boom {
        param eye: Length = 1m;
        ground { point base = (500mm, 0mm); }
        body boom { point rod = (eye, 0mm);  start angle = 60deg; }
        joint foot = revolute(ground.position, boom.position);
        drive lift = drive_distance(ground.base, boom.rod, 900mm + 1mm_s * t);
    }
}

/// Where the boom lies on the ground the cylinder has 2500 mm, so that 1600 mm are open; from d² − c² alone follows no more than √(2500² − 900²) mm.
#[test]
fn an_open_distance_is_stated_as_a_bound() {
    let said = Boom { eye: 3.0 }.solve(0.0).expect_err("the cylinder is too short").to_string();
    assert!(said.contains("joint `lift` (drive_distance, row 1 of 1) stays open by up to 2332 mm"), "{said}");
}

mechanism! {
    /// A slide on a ramp that ends: beyond its end nothing says how high the slide is.
    #[closure(off)]
    mechanism Ramp {
        param end: Angle = 60deg;
        body arm { }
        body slide { }
        joint pivot = revolute(ground.position, arm.position);
        joint rail = translational((0, 1), (0mm, 0mm), slide.position);
        joint ramp = { (if arm.angle < end { slide.y / 1m } else { 3 }) == 1 + arm.angle / 1rad; }
        drive motor = drive_angle(arm, 45deg);
    }
}

/// 3 − (1 + π/4) = 1.21, whatever the height of the slide.
#[test]
fn an_equation_that_no_coordinate_changes_is_off_by_its_residual() {
    let double = Ramp { end: 0.5 }.solve(0.0).expect_err("the ramp has ended").to_string();
    let single = Ramp::<f32> { end: 0.5 }.solve(0.0).expect_err("the ramp has ended").to_string();
    let off = 2.0 - std::f64::consts::FRAC_PI_4;
    for said in [double, single] {
        let right = format!("joint `ramp` (equation, row 1 of 1) is off by {off:.2e}, and no coordinate changes it there");
        assert!(said.contains(&right), "{said}");
    }
    let height = Ramp::default().solve(0.0).expect("the ramp goes on").slide().position.y;
    assert!((height - (3.0 - off)).abs() < 1e-15, "{height}");
}
