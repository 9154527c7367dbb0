//! Change points, where two branches of a mechanism cross: it continues on the smooth branch.

use std::f64::consts::{PI, TAU};

use reuleaux::nalgebra::SVector;
use reuleaux::{Cause, Equations, Failure, Mechanism, Motion, State, mechanism};
use reuleaux_tests::samples;

mechanism! {
    /// A parallelogram; when its links are in line, the antiparallelogram crosses.
    mechanism Parallelogram {
        param start: Angle = 61deg;
        ground { point A = (0m, 0m);  point B = (2m, 0m); }
        body crank  { point P = (500mm, 0mm); }
        body rod    { point Q = (2m, 0m); }
        body rocker { point P = (500mm, 0mm); }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(ground.B, rocker.position);
        joint c = revolute(crank.P, rod.position);
        joint d = revolute(rod.Q, rocker.P);
        drive input = drive_angle(crank, start + 10rpm * t);
    }
}

mechanism! {
    /// A slider-crank with equal crank and rod; when the piston passes the axle, it could also stay there.
    mechanism Isosceles {
        ground { axis way = (1, 0); }
        body crank  { point A = (50mm, 0mm); }
        body rod    { point B = (50mm, 0mm); }
        body piston { start x = 80mm; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, rod.position);
        joint b = revolute(rod.B, piston.position);
        joint guide = translational(ground.way, ground.position, piston.position);
        drive input = drive_angle(crank, 31deg + 60deg_s * t);
    }
}

/// In any number of steps, and by `solve`, the motion is smooth at the crossing and beyond it.
fn passes<M: Mechanism<f64, 9>>(mechanism: &M, crossing: f64, end: f64, is_right: impl Fn(&State<f64, 9>) -> bool) {
    for steps in (2..=60).chain([200, 400, 1000, 2000, 5000]) {
        for state in mechanism.sweep((0..=steps).map(|step| end * f64::from(step) / f64::from(steps))) {
            let state = state.unwrap_or_else(|failure| panic!("{steps} steps: {failure}"));
            assert!(is_right(&state), "{steps} steps: {state:?}");
        }
    }
    let digits = (1..=15).flat_map(|digits| [-0.1f64.powi(digits), 0.1f64.powi(digits)]);
    for t in (0..=20).map(|step| crossing + (end - crossing) * f64::from(step) / 20.0).chain(digits.map(|off| crossing + off)) {
        let state = mechanism.solve(t).unwrap_or_else(|failure| panic!("{failure}"));
        assert!(is_right(&state), "{state:?}");
        let on = mechanism.solve_from(end, &state).unwrap_or_else(|failure| panic!("{failure}"));
        assert!(is_right(&on), "{on:?}");
        if (t - crossing).abs() > 1e-3 {
            let back = mechanism.solve_from(0.1, &state).unwrap_or_else(|failure| panic!("{failure}"));
            assert!(is_right(&back), "{back:?}");
        }
    }
}

/// The rod does not rotate, and the rocker turns with the crank.
#[test]
fn a_parallelogram_stays_one() {
    passes(&Parallelogram::default(), 119.0 / 60.0, 4.0, |state| {
        let lost = 4.0 * f64::EPSILON * state.condition;
        [5, 8].into_iter().zip([0, 2]).all(|(i, j)| {
            let [found, right] = [state.coordinate(i), state.coordinate(j)];
            let right = if j == 0 { Motion { value: 0.0, rate: 0.0, acceleration: 0.0 } } else { right };
            (found.value - right.value).abs() < lost
                && (found.rate - right.rate).abs() < lost * state.condition
                && (found.acceleration - right.acceleration).abs() < lost * state.condition * state.condition
        })
    });
}

/// The piston passes through, at 2 a cos φ.
#[test]
fn a_piston_passes_the_axle() {
    passes(&Isosceles::default(), 59.0 / 60.0, 2.0, |state| {
        let (piston, crank) = (state.coordinate(6), state.coordinate(2));
        let right = [0.1 * crank.value.cos(), -0.1 * crank.value.sin() * crank.rate, -0.1 * crank.value.cos() * crank.rate * crank.rate];
        let lost = f64::EPSILON * state.condition;
        (piston.value - right[0]).abs() < lost
            && (piston.rate - right[1]).abs() < lost * state.condition
            && (piston.acceleration - right[2]).abs() < lost * state.condition * state.condition
    });
}

/// At the crossing itself, accelerations keep ten digits.
#[test]
fn the_crossing_itself_is_a_state() {
    let parallelogram = Parallelogram { start: 60f64.to_radians() };
    let isosceles = Isosceles::default().solve(59.0 / 60.0).expect("it goes through");
    for t in [2.0, 2.0 - 1e-9, 2.0 + 1e-9, 2.0 - 1e-13] {
        let state = parallelogram.solve(t).expect("in line");
        let (rod, rocker, crank) = (state.coordinate(5), state.coordinate(8), state.coordinate(2));
        assert!(rod.value.abs() < 1e-13 && rod.rate.abs() < 1e-11 && rod.acceleration.abs() < 1e-9, "{rod:?}");
        assert!((rocker.value - crank.value).abs() < 1e-13 && (rocker.rate - crank.rate).abs() < 1e-11, "{rocker:?}");
    }
    let piston = isosceles.piston();
    assert!(piston.position.x.abs() < 1e-14 && (piston.velocity.x + 0.1 * 60f64.to_radians()).abs() < 1e-12, "{piston:?}");
    assert!(piston.acceleration.x.abs() < 1e-9, "{piston:?}");
}

/// Beside the crossing the condition κ grows beyond 1e5, where κ³ ε would leave no digit of an acceleration.
#[test]
fn beside_the_crossing_accelerations_keep_their_digits() {
    let (parallelogram, isosceles) = (Parallelogram::default(), Isosceles::default());
    let crossings = [119.0 / 60.0, 59.0 / 60.0];
    let off = |[found, right]: [Motion<f64>; 2], speed: f64| {
        let [rate, acceleration] = [found.rate - right.rate, found.acceleration - right.acceleration];
        ((rate / speed).abs()).max((acceleration / (speed * speed)).abs())
    };
    let of_parallelogram = |state: &State<f64, 9>| off([state.coordinate(8), state.coordinate(2)], state.coordinate(2).rate);
    let of_isosceles = |state: &State<f64, 9>| {
        let (rod, crank) = (state.coordinate(5), state.coordinate(2));
        off([rod, Motion { value: -crank.value, rate: -crank.rate, acceleration: -crank.acceleration }], crank.rate)
    };
    for digits in 4..=12 {
        for side in [-1.0, 1.0] {
            let beside = side * 0.3 * 0.1f64.powi(digits);
            let there = parallelogram.solve(crossings[0] + beside).expect("beside the crossing");
            assert!(of_parallelogram(&there) < 1e-3, "{beside:e}: {} at {:e}", of_parallelogram(&there), there.condition);
            let there = isosceles.solve(crossings[1] + beside).expect("beside the crossing");
            assert!(of_isosceles(&there) < 1e-3, "{beside:e}: {} at {:e}", of_isosceles(&there), there.condition);
        }
        // Steps that become short beside it, and steps that are short throughout.
        let (mut state, mut other) = (parallelogram.solve(crossings[0] - 0.1).expect("a start"), isosceles.solve(0.9).expect("a start"));
        let h = 0.1f64.powi(digits);
        for step in -20..=20 {
            parallelogram.advance(&mut state, crossings[0] + h * (f64::from(step) + 0.3)).expect("a step");
            assert!(of_parallelogram(&state) < 1e-3, "{h:e} {step}: {} at {:e}", of_parallelogram(&state), state.condition);
            isosceles.advance(&mut other, crossings[1] + h * (f64::from(step) + 0.3)).expect("a step");
            assert!(of_isosceles(&other) < 1e-3, "{h:e} {step}: {} at {:e}", of_isosceles(&other), other.condition);
        }
    }
}

/// At the crossing Φ_q is singular, and beside it the derivatives by parameters lose all digits before the state does.
#[test]
fn derivatives_are_refused_where_they_have_no_digits() {
    let parallelogram = Parallelogram { start: 60f64.to_radians() };
    let state = |t: f64| parallelogram.solve(t).expect("a state");
    for beside in [0.0, 1e-13, -1e-9, 1e-6, -1e-5] {
        let Err(failure) = parallelogram.derivatives(&state(2.0 + beside), |m| [&mut m.start]) else { panic!("{beside:e}") };
        assert!(matches!(failure.cause, Cause::Singular { .. }), "{failure}");
    }
    for away in [-0.5, -1e-2, 1e-2, 0.5] {
        let (_, found) = parallelogram.derivatives(&state(2.0 + away), |m| [&mut m.start]).expect("derivatives");
        let by = ParallelogramState(found).rocker().angle.by[0];
        assert!((by - 1.0).abs() < 1e-10, "{away}: {by}");
    }
}

mechanism! {
    /// Wheels in a row, each coupled to the next by a parallelogram.
    mechanism Wheels {
        let rods = 5;
        for i in 0..=rods {
            body wheel[i] { point P = (100mm, 0mm);  start angle = 45deg; }
            joint axle[i] = revolute((i * 400mm, 0mm), wheel[i].position);
        }
        for i in 0..rods {
            body rod[i] { point Q = (400mm, 0mm); }
            joint p[i] = revolute(wheel[i].P, rod[i].position);
            joint q[i] = revolute(rod[i].Q, wheel[i + 1].P);
        }
        drive input = drive_angle(wheel[0], 45deg + 60rpm * t);
    }
}

mechanism! {
    /// A scissor lift whose foot passes below its other foot: all arms are upright at once, and two signs change together.
    mechanism Scissors {
        param arm: Length = 800mm;
        let stages = 3;
        ground { axis floor = (1, 0); }
        for i in 0..stages {
            body rising[i]  { point m = (arm / 2, 0mm);  point b = (arm, 0mm);  start angle = 20deg; }
            body falling[i] { point m = (arm / 2, 0mm);  point b = (arm, 0mm);  start angle = -20deg; }
            joint mid[i] = revolute(rising[i].m, falling[i].m);
        }
        joint foot = revolute(ground.position, rising[0].position);
        joint roll = point_on_line(ground.position, ground.floor, falling[0].b);
        for i in 1..stages {
            joint l[i] = revolute(falling[i - 1].position, rising[i].position);
            joint r[i] = revolute(rising[i - 1].b, falling[i].b);
        }
        drive push = drive_distance(ground.position, falling[0].b, 750mm - 50mm_s * t);
    }
}

mechanism! {
    /// One stage of the lift.
    mechanism Scissor {
        ground { axis floor = (1, 0); }
        body rising  { point m = (400mm, 0mm);  point b = (800mm, 0mm);  start angle = 20deg; }
        body falling { point m = (400mm, 0mm);  point b = (800mm, 0mm);  start angle = -20deg; }
        joint mid = revolute(rising.m, falling.m);
        joint foot = revolute(ground.position, rising.position);
        joint roll = point_on_line(ground.position, ground.floor, falling.b);
        drive push = drive_distance(ground.position, falling.b, 750mm - 50mm_s * t);
    }
}

/// Around a crossing every equation of position holds to rounding, and those of velocity and acceleration as far as the condition allows.
fn holds_around<M, const N: usize>(mechanism: &M, crossing: f64)
where
    M: Mechanism<f64, N> + Equations<f64, N, N>,
{
    let digits = (3..=15).flat_map(|digits| [-0.1f64.powi(digits), 0.1f64.powi(digits)]);
    for t in digits.chain([0.0]).map(|off| crossing + off) {
        let state = mechanism.solve(t).unwrap_or_else(|failure| panic!("{failure}"));
        let (phi, jacobian) = mechanism.linearize(&state.q, t);
        assert!(phi.amax() < 1e-14, "{t}: {phi:?}");
        let rates = jacobian * state.qd - mechanism.nu(&state.q, t);
        let accelerations = jacobian * state.qdd - mechanism.gamma(&state.q, &state.qd, t);
        let (lost, speed) = (f64::EPSILON * state.condition, 1.0 + state.qd.amax());
        assert!(
            rates.amax() < (1e-11 + lost) * speed && accelerations.amax() < 1e-8,
            "{t}: {:e} {:e} at {:e}",
            rates.amax(),
            accelerations.amax(),
            state.condition
        );
    }
}

/// All wheels turn alike, next to the crossing as far from it: rounding of the fifth loop would turn the last wheel by itself.
#[test]
fn wheels_turn_alike_beside_the_crossing() {
    let wheels = Wheels::default();
    for beside in (2..=15).flat_map(|digits| [-0.1f64.powi(digits), 0.1f64.powi(digits)]) {
        let state = wheels.solve(0.375 + beside).unwrap_or_else(|failure| panic!("{failure}"));
        for wheel in state.wheel() {
            assert!((wheel.angular_velocity - TAU).abs() < 1e-7, "{beside:e}: {wheel:?} at {:e}", state.condition);
            assert!(wheel.angular_acceleration.abs() < 1e-2, "{beside:e}: {wheel:?} at {:e}", state.condition);
        }
    }
}

#[test]
fn equations_hold_around_crossings_of_several_blocks() {
    holds_around(&Wheels::default(), 0.375);
    holds_around(&Scissors::default(), 15.0);
    holds_around(&Scissor::default(), 15.0);
    holds_around(&Isosceles::default(), 59.0 / 60.0);
}

/// With any steps, the arms turn uniformly through the upright position: the distance from the foot to C changes its sign.
#[test]
fn a_scissor_passes_the_upright_in_however_many_steps() {
    for steps in [7, 10, 100, 1000, 1001] {
        for state in Scissor::default().sweep((0..=steps).map(|step| 20.0 * f64::from(step) / f64::from(steps))) {
            let state = state.unwrap_or_else(|failure| panic!("{steps} steps: {failure}"));
            let right = ((0.75 - 0.05 * state.t) / 0.8).acos();
            assert!((state.rising().angle - right).abs() < 1e-14 * state.condition, "{steps} steps: {state:?}");
        }
    }
}

mechanism! {
    /// Nearly a parallelogram, with a rocker slightly longer or shorter.
    mechanism Nearly {
        param more: Length = 0mm;
        ground { point A = (0m, 0m);  point B = (2m, 0m); }
        body crank  { point P = (500mm, 0mm); }
        body rod    { point Q = (2m, 0m); }
        body rocker { point P = (500mm + more, 0mm); }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(ground.B, rocker.position);
        joint c = revolute(crank.P, rod.position);
        joint d = revolute(rod.Q, rocker.P);
        drive input = drive_angle(crank, 61deg + 10rpm * t);
    }
}

/// Angle of the rocker of `Nearly` by plane geometry: from the triangle of its pivot, its pin and the crank pin, on the side on which the
/// rod crosses the line of the pivots.
fn crossed(crank: f64, more: f64) -> f64 {
    let (x, y) = (0.5 * crank.cos() - 2.0, 0.5 * crank.sin());
    let (distance, rocker) = (x.hypot(y), 0.5 + more);
    let inner = ((distance * distance + rocker * rocker - 4.0) / (2.0 * distance * rocker)).acos();
    y.atan2(x) - inner + TAU
}

/// If two branches come close but do not meet, the motion stays on its branch: with a longer crank it ends, with a shorter crank the
/// rocker turns back. A difference of four roundings of a length suffices.
#[test]
fn what_only_comes_near_is_no_crossing() {
    let (crossing, end) = (119.0 / 60.0, 4.0);
    for digits in (3..=14).rev().step_by(12 / samples(3, 12)) {
        let off = 0.1f64.powi(digits);
        for more in [off, -off] {
            let nearly = Nearly { more };
            let side = nearly.solve(0.0).unwrap().branch;
            for steps in [3, 10, 31, 100] {
                let mut last = Err("no state".to_owned());
                for state in nearly.sweep((0..=steps).map(|step| end * f64::from(step) / f64::from(steps))) {
                    last = state.map_err(|failure| failure.to_string());
                    let Ok(state) = &last else { break };
                    assert_eq!(state.branch, side, "{more:e}, {steps} steps: {state:?}");
                    assert!(nearly.phi(&state.q, state.t).amax() < 1e-14, "{more:e}, {steps} steps: {state:?}");
                }
                match last {
                    Ok(state) => {
                        let right = crossed(state.crank().angle, more);
                        assert!(more > 0.0 && (state.rocker().angle - right).abs() < 1e-13, "{more:e}, {steps} steps: {state:?}");
                    }
                    Err(_) => assert!(more < 0.0, "{more:e}, {steps} steps: {last:?}"),
                }
            }
            // In the opening, of size about √more, there is no state.
            let opening = off.sqrt();
            for place in (-20..=20).map(|place| crossing + opening * f64::from(place) / 10.0) {
                if let Ok(state) = nearly.solve(place) {
                    assert!(nearly.phi(&state.q, state.t).amax() < 1e-14, "{more:e} at {place}: {state:?}");
                    assert_eq!(state.branch, side, "{more:e} at {place}: {state:?}");
                }
            }
        }
    }
}

/// From any guess, and even from the crossing itself, where every equation holds.
#[test]
fn a_guess_at_the_crossing_finds_no_state() {
    let parallelogram = Parallelogram { start: 60f64.to_radians() };
    let straight = SVector::from([0.0, 0.0, PI, -0.5, 0.0, 0.0, 2.0, 0.0, PI]);
    let singular = |failure: Failure<f64, 9>| assert!(matches!(failure.cause, Cause::Singular { .. }), "{failure}");
    singular(parallelogram.solve_near(2.0, &straight).expect_err("in line"));
    for off in (0..16).map(|digits| 0.3 * 0.1f64.powi(digits)) {
        for sign in [-1.0, 1.0] {
            let aside = SVector::<f64, 9>::from_fn(|k, _| sign * off * (1.0 + k as f64 / 3.0).sin());
            singular(parallelogram.solve_near(2.0, &(straight + aside)).expect_err("in line"));
        }
    }
}

/// Also in single precision: the rod does not rotate, within the accuracy of seven digits.
#[test]
fn single_precision_passes_as_well() {
    let parallelogram = Parallelogram::<f32>::with_defaults();
    for steps in [3_u16, 7, 20, 100, 300] {
        for state in parallelogram.sweep((0..=steps).map(|step| 4.0 * f32::from(step) / f32::from(steps))) {
            let state = state.unwrap_or_else(|failure| panic!("{steps} steps: {failure}"));
            let lost = 4.0 * f32::EPSILON * state.condition.max(100.0);
            assert!(state.rod().angle.abs() < lost, "{steps} steps: {state:?}");
        }
    }
}
