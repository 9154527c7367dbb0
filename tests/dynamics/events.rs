//! Instants of events, against closed forms: pairs close together, loose tolerances, and dead points to which a drive leads.

use reuleaux::{Integrator, Stopped, mechanism};
use reuleaux_tests::samples;

mechanism! {
    /// x = cos(2 t + phase)
    pub(crate) mechanism Swinging {
        param phase: Angle = 0rad;
        let there = 1m * cos(phase);
        let speed = -2m_s * sin(phase);
        body slide { mass = 1kg; }
        joint rail = translational((1, 0), (0m, 0m), slide.position);
        force spring = { at slide.position: (-4N_m * slide.x, 0N); }
        freedom stroke = slide.x from there at speed;
    }
}

/// Instants before `end` at which the slide is at `level`, in order.
fn instants(phase: f64, level: f64, end: f64) -> Vec<f64> {
    let (turn, half) = (core::f64::consts::TAU, level.acos());
    let near = (0..20).map(f64::from).flat_map(|k| [k * turn - half, k * turn + half]);
    near.map(|angle| (angle - phase) / 2.0).filter(|t| *t > 0.0 && *t < end).collect()
}

fn found(phase: f64, level: f64, end: f64, tolerance: f64) -> Vec<f64> {
    let mechanism = Swinging { phase };
    let mut state = mechanism.initial_state().expect("a state");
    let mut integrator = Integrator::new(tolerance);
    let mut found = Vec::new();
    while mechanism.advance_until(&mut state, end, &mut integrator, |state| state.slide().position.x - level).expect("a motion") {
        found.push(state.t);
        assert!(found.len() < 100, "an instant is found again: {found:?}");
    }
    found
}

/// The slide just passes a level and comes back, wherever in a step that is.
#[test]
fn an_event_that_comes_and_goes_at_once_is_found_twice() {
    for tolerance in [1e-4, 1e-6, 1e-9] {
        for number in (0..200).step_by(200 / samples(40, 200)) {
            let phase = 0.031 * f64::from(number);
            let depth = 30.0 * tolerance * (1.0 + f64::from(number % 7));
            let (wanted, found) = (instants(phase, 1.0 - depth, 9.0), found(phase, 1.0 - depth, 9.0, tolerance));
            assert_eq!(found.len(), wanted.len(), "{tolerance:e}, {phase}: {found:?} for {wanted:?}");
            // At 1 − d the slide moves at 2 √(2 d): the place is right within the tolerance.
            let speed = 2.0 * (2.0 * depth).sqrt();
            for (found, wanted) in found.iter().zip(&wanted) {
                assert!((found - wanted).abs() * speed < tolerance, "{tolerance:e}, {phase}: {found} for {wanted}");
            }
        }
    }
}

/// Interpolated within long steps, the event seems not to have passed zero at a look where it has.
#[test]
fn an_event_beside_a_look_is_found() {
    for number in -200..=200 {
        let level = -0.643_142_513_7 + 1e-7 * f64::from(number);
        let first = found(0.0, level, 2.0, 1e-4);
        assert!(first.len() == 1 && (first[0] - 0.5 * level.acos()).abs() < 1e-4, "{level}: {first:?}");
    }
}

mechanism! {
    /// A ball falls from 1 m and moves sideways.
    pub(crate) mechanism Bouncing {
        gravity = (0, -9.81m_s2);
        body ball { mass = 1kg;  inertia = 0.01kgm2;  start position = (0m, 1m); }
        freedom across = ball.x at 0.3m_s;
        freedom height = ball.y from 1m;
        freedom turn = ball.angle;
    }
}

/// Instants at which a ball that keeps nine tenths of its speed hits the floor at `level`: √(2 h / g), then 2 v / g more each time.
#[test]
fn a_ball_that_rebounds_leaves_the_floor() {
    for level in [0.0, -1e-3, 0.1, -10.0] {
        for tolerance in [1e-6, 1e-10] {
            let mechanism = Bouncing::default();
            let mut state = mechanism.initial_state().expect("a state");
            let mut integrator = Integrator::new(tolerance);
            let mut wanted = (2.0 * (1.0 - level) / 9.81_f64).sqrt();
            let mut speed = 9.81 * wanted;
            for _ in 0..40 {
                let hit = mechanism.advance_until(&mut state, 60.0, &mut integrator, |state| state.ball().position.y - level);
                assert!(hit.expect("a motion"), "no floor at {level}");
                assert!((state.t - wanted).abs() < 1e-11 * wanted.max(1.0), "{level}: {} for {wanted}", state.t);
                state.0.qd[1] *= -0.9;
                mechanism.accelerate(&mut state).expect("accelerations");
                speed *= 0.9;
                wanted += 2.0 * speed / 9.81;
            }
        }
    }
}

mechanism! {
    /// A crank that turns beside a slide at rest.
    pub(crate) mechanism Resting {
        body crank { point A = (1m, 0m); }
        body slide { mass = 1kg; }
        joint pin = revolute((0m, 0m), crank.position);
        joint rail = translational((1, 0), (0m, -2m), slide.position);
        force hold = { at slide.position: (-4N_m * (slide.x - 1m), 0N); }
        drive motor = drive_angle(crank, 1rad_s * t);
        freedom stroke = slide.x from 1m;
    }
}

/// Every passage is found, whenever the motion is asked for it, though nothing integrated moves.
#[test]
fn events_are_found_in_calls_of_any_length() {
    for call in [1e-3, 0.05, 0.35] {
        for number in (1..40).step_by(40 / samples(5, 40)) {
            let (resting, target) = (Resting::default(), 0.05 * f64::from(number));
            let mut state = resting.initial_state().expect("a state");
            let mut integrator = Integrator::new(1e-8);
            let mut found = 0;
            for step in 1..=(2.2 / call) as u32 {
                let until = call * f64::from(step);
                while resting.advance_until(&mut state, until, &mut integrator, |state| state.crank().angle - target).expect("a motion") {
                    found += 1;
                    assert!((state.t - target).abs() < 1e-12, "{target}: {}", state.t);
                }
            }
            assert_eq!(found, 1, "{target} in calls of {call} s");
        }
    }
}

/// Where a motion begins just above the floor it is stopped there, as soon as that can be told from rounding.
#[test]
fn an_event_just_after_the_beginning_is_found() {
    let mechanism = Bouncing::default();
    let start = mechanism.initial_state().expect("a state");
    for above in [1e-3, 1e-6, 1e-9, 1e-12] {
        let mut state = start.clone();
        let level = 1.0 - above;
        let hit = mechanism.advance_until(&mut state, 1.0, &mut Integrator::new(1e-10), |state| state.ball().position.y - level);
        assert!(hit.expect("a motion"), "{above:e}");
        let wanted = (2.0 * (1.0 - level) / 9.81_f64).sqrt();
        assert!((state.t - wanted).abs() < 1e-15 / wanted, "{above:e}: {} for {wanted}", state.t);
    }
}

mechanism! {
    /// A drive turns the arm to where coupler and rocker are in line; two pendulums hang on them.
    #[closure(allow)]
    pub(crate) mechanism Locking {
        gravity = (0, -9.81m_s2);
        ground { point D = (400mm, 0mm); }
        body arm      { point A = (300mm, 0mm);  mass = 1kg;  inertia = 0.02kgm2; }
        body coupler  { point B = (100mm, 0mm);  point H = (100mm, 50mm);  mass = 0.7kg;  inertia = 0.01kgm2; }
        body rocker   { point B = (350mm, 0mm);  mass = 0.6kg;  inertia = 0.01kgm2;  start angle = 1.9rad; }
        body first    { mass = 0.3kg;  center = (100mm, 20mm);  inertia = 0.004kgm2; }
        body second   { mass = 0.3kg;  center = (100mm, 20mm);  inertia = 0.004kgm2; }
        joint o = revolute(ground.position, arm.position);
        joint a = revolute(arm.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint d = revolute(rocker.position, ground.D);
        joint hook = revolute(coupler.H, first.position);
        joint ring = revolute(rocker.B, second.position);
        drive motor = drive_angle(arm, 1rad - 1rad_s * t);
        freedom one = first.angle from 0.3rad;
        freedom two = second.angle from 0.5rad;
    }
}

/// (350 − 100)² = 300² + 400² − 2 · 300 · 400 cos φ
#[test]
fn a_dead_point_is_named() {
    let mechanism = Locking::default();
    let dead = 1.0 - ((0.09_f64 + 0.16 - 0.0625) / 0.24).acos();
    for tolerance in [1e-6, 1e-9] {
        let mut state = mechanism.initial_state().expect("a state");
        let stopped = mechanism.advance(&mut state, 5.0, &mut Integrator::new(tolerance)).expect_err("a dead point");
        let Stopped::Singular { time, joint } = stopped else { panic!("{stopped}") };
        assert!((time - dead).abs() < 1e-12 && ["a", "b", "d"].contains(&joint), "{joint} at {time} for {dead}");
    }
}

mechanism! {
    /// A four-bar whose crank is driven by a torque that has no value beyond 1 rad.
    pub(crate) mechanism Ending {
        ground { point A = (0m, 0m);  point D = (4m, 0m); }
        body crank   { point B = (1m, 0m);  inertia = 1kgm2; }
        body coupler { point C = (3m, 0m);  mass = 1kg;  inertia = 1kgm2; }
        body rocker  { point C = (3.5m, 0m);  inertia = 1kgm2;  start angle = 100deg; }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(crank.B, coupler.position);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.position, ground.D);
        force push = { on crank: 1Nm * sqrt(1 - crank.angle / 1rad); }
        freedom swing = crank.angle from 0.5rad at 1rad_s;
    }
}

/// Where a force has no value its motion ends, and the joints, which are far from a place where they lock, are not to blame.
#[test]
fn a_force_without_a_value_is_not_taken_for_joints_that_lock() {
    let ending = Ending::default();
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let (mut plain, mut stiff) = (ending.initial_state().expect("a state"), ending.initial_state().expect("a state"));
        let stopped = [
            ending.advance(&mut plain, 2.0, &mut Integrator::new(tolerance)),
            ending.advance(&mut stiff, 2.0, &mut Integrator::stiff(tolerance)),
        ];
        for (state, stopped) in [plain, stiff].iter().zip(stopped) {
            assert!(matches!(stopped, Err(Stopped::NotFinite { .. } | Stopped::StepTooShort { .. })), "{tolerance:e}: {stopped:?}");
            assert!((state.crank().angle - 1.0).abs() < 1e-3, "{tolerance:e}: stopped at {} rad", state.crank().angle);
        }
    }
}

mechanism! {
    /// A weight whose force jumps at a place, and at a time.
    mechanism Switched {
        param place: Length = 0.1m;
        param time: Time = 0.3s;
        body one { mass = 1kg; }
        body two { mass = 1kg; }
        joint rail = translational((1, 0), (0m, 0m), one.position);
        joint other = translational((1, 0), (0m, 1m), two.position);
        force by_place = { at one.position: (if one.x < place { 1N } else { -2N }, 0N); }
        force by_time = { at two.position: (if t < time { 1N } else { -2N }, 0N); }
        freedom first = one.x from 0m at 1m_s;
        freedom second = two.x from 0m at 1m_s;
    }
}

/// Where a force jumps, the error of a motion is of the size of the tolerance, not of its root.
#[test]
fn a_force_may_jump() {
    for step in 0..10 {
        let (place, time) = (0.1 + 0.013 * f64::from(step), 0.3 + 0.017 * f64::from(step));
        let mechanism = Switched { place, time };
        for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
            let mut state = mechanism.initial_state().expect("a state");
            mechanism.advance(&mut state, 1.0, &mut Integrator::new(tolerance)).expect("a motion");
            // x = t + t²/2 up to the jump, then with −2 m/s².
            let at = |jump: f64| {
                let (start, speed, rest) = (jump + 0.5 * jump * jump, 1.0 + jump, 1.0 - jump);
                [start + speed * rest - rest * rest, speed - 2.0 * rest]
            };
            let jump = (1.0 + 2.0 * place).sqrt() - 1.0;
            for (body, [x, speed]) in [(state.one(), at(jump)), (state.two(), at(time))] {
                let error = (body.position.x - x).abs().max((body.velocity.x - speed).abs());
                assert!(error < 2.0 * tolerance, "{place} {tolerance:e}: {error:e}");
            }
        }
    }
}

mechanism! {
    /// A rod under gravity, held at one end.
    mechanism Rod {
        param fall: Acceleration = 9.81m_s2;
        gravity = (0, -fall);
        body rod { mass = 1kg;  center = (0.5m, 0m); }
        joint pin = revolute(ground.position, rod.position);
        freedom turn = rod.angle from 0rad;
    }
}

/// The rod strikes at −0.5 rad and rebounds with four fifths of its speed, until its flights are far shorter than a step.
#[test]
fn a_rod_rebounds_until_it_hardly_moves() {
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-11] {
        let mechanism = Rod::default();
        let (mut state, mut integrator) = (mechanism.initial_state().expect("a state"), Integrator::new(tolerance));
        let mut speed = f64::INFINITY;
        while speed > 1e-5 {
            let until = state.t + 2.0;
            let hit = mechanism.advance_until(&mut state, until, &mut integrator, |state| state.rod().angle + 0.5).expect("a motion");
            assert!(hit, "{tolerance:e}: missed after a rebound with {speed:e} rad/s");
            // Energy is kept between two strikes.
            let struck = -state.rod().angular_velocity;
            // Rounding of an angle of half a radian against the height of the last flights.
            let bound = if tolerance > 1e-7 { 1e-3 } else { 1e-4 };
            assert!(speed.is_infinite() || (struck / speed - 1.0).abs() < bound, "{tolerance:e}: {struck:e} after {speed:e}");
            speed = 0.8 * struck;
            state.0.qd[2] = speed;
            mechanism.accelerate(&mut state).expect("accelerations");
        }
    }
}

/// A first step need not be shorter than the time can tell.
#[test]
fn calls_may_be_short_against_the_time() {
    let in_single = Rod::<f32> { fall: 9.81 };
    let mut single = in_single.initial_state().expect("a state");
    for (time, short) in [(1.0, 1e-5), (10.0, 1e-4), (100.0, 1e-3)] {
        single.0.t = time;
        in_single.advance(&mut single, time + short, &mut Integrator::new(1e-5)).expect("a motion");
        assert_eq!(single.t, time + short);
    }
    let mut double = Rod::default().initial_state().expect("a state");
    for (time, short) in [(1.0, 1e-14), (100.0, 1e-12), (1e4, 1e-10)] {
        double.0.t = time;
        Rod::default().advance(&mut double, time + short, &mut Integrator::new(1e-10)).expect("a motion");
        assert_eq!(double.t, time + short);
    }
}
