//! Stiff motions.

use reuleaux::{Integrator, Real, mechanism};

mechanism! {
    /// A sledge on a spring with a damper that lets it creep only.
    mechanism Sledge {
        param stiffness: Stiffness = 1000N_m;
        param damping: Damping = 100000Ns_m;
        ground { point P = (0m, 0m);  axis line = (1, 0); }
        body sledge { point Q = (0m, 0m);  mass = 0.1kg; }
        joint rail = translational(ground.line, ground.P, sledge.Q);
        force support = spring_damper(ground.P, sledge.Q, stiffness, rest: 500mm, damping: damping);
        freedom slide = sledge.x from 600mm;
    }
}

mechanism! {
    /// A four-bar that falls against a stiff buffer of its crank.
    mechanism Buffered {
        gravity = (0, -9.81m_s2);
        ground { point D = (4m, 0m); }
        body crank   { point B = (1m, 0m);    mass = 1kg;    center = (0.5m, 0m);   inertia = 1/12 * 1kgm2; }
        body coupler { point C = (3.5m, 0m);  mass = 3.5kg;  center = (1.75m, 0m);  inertia = 3.5^3 / 12 * 1kgm2;  start angle = 60deg; }
        body rocker  { point C = (3m, 0m);    mass = 3kg;    center = (1.5m, 0m);   inertia = 27/12 * 1kgm2;  start angle = 100deg; }
        joint a = revolute(ground.position, crank.position);
        joint b = revolute(crank.B, coupler.position);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.position, ground.D);
        force buffer = { on crank: -20000Nm / 1rad * (crank.angle - 0.2rad) - 3000Nm / 1rad_s * crank.angular_velocity; };
        freedom swing = crank.angle from 0.3rad;
    }
}

/// Exact elongation and speed of the sledge.
fn creeping(sledge: &Sledge, t: f64) -> [f64; 2] {
    let (m, c, k) = (0.1, sledge.damping, sledge.stiffness);
    let root = (c * c - 4.0 * m * k).sqrt();
    let fast = -(c + root) / (2.0 * m);
    let slow = k / (m * fast);
    let share = |rate: f64, other: f64| 0.1 * other / (other - rate);
    let terms = [(slow, share(slow, fast)), (fast, share(fast, slow))].map(|(rate, size)| (size * (rate * t).exp(), rate));
    [terms.iter().map(|(term, _)| term).sum(), terms.iter().map(|(term, rate)| term * rate).sum()]
}

#[test]
fn a_creeping_sledge_takes_few_steps() {
    let sledge = Sledge::default();
    for tolerance in [1e-4, 1e-6, 1e-8] {
        let (mut state, mut integrator) = (sledge.initial_state().expect("a state"), Integrator::stiff(tolerance));
        for t in [0.001, 1.0, 100.0, 300.0] {
            sledge.advance(&mut state, t, &mut integrator).expect("a motion");
            let [x, v] = creeping(&sledge, t);
            let body = state.sledge();
            assert!((body.position.x - 0.5 - x).abs() < tolerance && (body.velocity.x - v).abs() < tolerance, "{tolerance:e} at {t}");
        }
        // The damper forgets a million times a second.
        assert!(integrator.accepted < 600, "{}", integrator.accepted);
    }
}

#[test]
fn explicit_steps_are_shorter_than_the_fastest_decay() {
    let (sledge, mut integrator) = (Sledge { damping: 1e3, ..Sledge::default() }, Integrator::new(1e-6));
    let mut state = sledge.initial_state().expect("a state");
    sledge.advance(&mut state, 1.0, &mut integrator).expect("a motion");
    let (mut other, mut stiff) = (sledge.initial_state().expect("a state"), Integrator::stiff(1e-6));
    sledge.advance(&mut other, 1.0, &mut stiff).expect("a motion");
    assert!(integrator.accepted > 1000 && stiff.accepted < 200, "{} {}", integrator.accepted, stiff.accepted);
    assert!((state.sledge().position.x - other.sledge().position.x).abs() < 1e-7);
}

#[test]
fn both_methods_follow_the_same_motion_of_a_loop() {
    let linkage = Buffered::default();
    let exact: Vec<f64> =
        linkage.sweep([0.05, 0.5, 2.0], Integrator::new(1e-12)).map(|state| state.expect("a state").crank().angle).collect();
    for tolerance in [1e-3, 1e-5, 1e-7] {
        let mut integrator = Integrator::stiff(tolerance);
        let mut state = linkage.initial_state().expect("a state");
        for (t, exact) in [0.05, 0.5, 2.0].into_iter().zip(&exact) {
            linkage.advance(&mut state, t, &mut integrator).expect("a motion");
            assert!((state.crank().angle - exact).abs() < tolerance, "{tolerance:e} at {t}: {:e}", state.crank().angle - exact);
        }
        let swept = linkage.sweep([0.05, 0.5, 2.0], Integrator::stiff(tolerance));
        for (state, exact) in swept.zip(&exact) {
            assert!((state.expect("a state").crank().angle - exact).abs() < tolerance);
        }
    }
}

#[test]
fn events_are_located_in_stiff_steps() {
    let sledge = Sledge::default();
    let (mut state, mut integrator) = (sledge.initial_state().expect("a state"), Integrator::stiff(1e-8));
    let is_there = sledge.advance_until(&mut state, 1e3, &mut integrator, |state| state.sledge().position.x - 0.55);
    assert_eq!(is_there, Ok(true));
    let [x, _] = creeping(&sledge, state.t);
    assert!((state.sledge().position.x - 0.55).abs() < 1e-12 && (x - 0.05).abs() < 1e-8, "{x}");
}

mechanism! {
    /// A block between two springs that are pressed together, slowed down so much that it creeps.
    mechanism Preloaded {
        param away: Length = 0m;
        body block { mass = 1kg; }
        joint rail = translational((1, 0), ground.position, block.position);
        force left = spring_damper((-1m, 0m), block.position, 1e6N_m, rest: 1.1m, damping: 1e5Ns_m);
        force right = spring((1m, 0m), block.position, 1e6N_m, rest: 1.1m);
        freedom slide = block.x from away;
    }
}

/// The forces of 100 kN cancel; what is left of their rounding neither moves the block nor shortens the steps. Released a millimetre away it
/// returns by the slow one of both exponentials of ẍ + 10⁵ ẋ + 2·10⁶ x = 0.
#[test]
fn preloaded_springs_do_not_shorten_steps() {
    let slow = -(1e5 - (1e10_f64 - 8e6).sqrt()) / 2.0;
    for away in [0.0, 1e-3] {
        let preloaded = Preloaded::<f64> { away };
        let (mut state, mut integrator) = (preloaded.initial_state().expect("a state"), Integrator::stiff(1e-8));
        let steps = [1.0, 10.0, 1e4].map(|time| {
            preloaded.advance(&mut state, time, &mut integrator).expect("it creeps");
            let exact = away * (slow * time).exp() * (1.0 - slow / (-1e5 - slow)).recip();
            assert!((state.block().position.x - exact).abs() < 1e-9, "{} m, not {exact} m", state.block().position.x);
            integrator.accepted
        });
        assert!(steps[1] - steps[0] < 50, "{} steps at rest", steps[1] - steps[0]);
        assert!(steps[2] - steps[1] < 50, "{} steps at rest", steps[2] - steps[1]);
    }
}

mechanism! {
    /// A block on a rail that starts where the forces on it jump: at a place, and at rest where what moves it or brakes it depends on its direction.
    mechanism Edge {
        param ahead: Force = 0N;
        param pushed: Force = 0N;
        param moving: Force = 0N;
        param friction: Force = 0N;
        param speed: Velocity = 0m_s;
        body block { mass = 1kg; }
        joint rail = translational((1, 0), ground.position, block.position);
        force by_place = { at block.position: (if block.x > 0 { ahead } else { 0N }, 0N); }
        force by_speed = { at block.position: (if rate(block.x) > 0 { moving } else { 0N }, 0N); }
        force push = { at block.position: (pushed, 0N); }
        force brake = { at block.position: (if rate(block.x) > 0 { -friction } else { friction }, 0N); }
        freedom slide = block.x from 0m at speed;
    }
}

/// With v + a t behind the edge, in explicit and in implicit steps. Differences across a jump are no derivatives, and the first step is as exact as
/// all others.
#[test]
fn a_motion_that_starts_on_the_edge_of_a_jump_is_as_exact_as_any() {
    let edges = [
        (Edge { ahead: 10.0, speed: 1.0, ..Edge::default() }, 10.0),
        (Edge { ahead: 10.0, speed: 1e-9, ..Edge::default() }, 10.0),
        (Edge { pushed: 1.0, moving: 10.0, ..Edge::default() }, 11.0),
        (Edge { pushed: 5.0, friction: 2.0, ..Edge::default() }, 3.0),
        (Edge { pushed: -5.0, friction: 2.0, ..Edge::default() }, -3.0),
    ];
    for (edge, acceleration) in edges {
        for tolerance in [1e-3, 1e-6, 1e-9] {
            let [mut explicit, mut implicit] = [(); 2].map(|()| edge.initial_state().expect("a state"));
            edge.advance(&mut explicit, 1.0, &mut Integrator::new(tolerance)).expect("it slides");
            edge.advance(&mut implicit, 1.0, &mut Integrator::stiff(tolerance)).expect("it slides");
            for state in [explicit, implicit] {
                let place = state.block().position.x - (edge.speed + acceleration / 2.0);
                let speed = state.block().velocity.x - (edge.speed + acceleration);
                assert!(place.abs().max(speed.abs()) < tolerance, "{tolerance}: {place} m, {speed} m/s of {edge:?}");
            }
        }
    }
}

mechanism! {
    /// A block that a force pushes out of rest against friction, which has its size from a speed on that is hardly one.
    mechanism Rubbed {
        param transition: Velocity = 1mm_s;
        param rise: Force / Time = 0N / 1s;
        param push: Force = 5N;
        ground { axis u = (1, 0); }
        body block { mass = 1kg; }
        joint rail = translational(ground.u, ground.position, block.position);
        force rub = friction(ground.position, ground.u, block.position, normal: 10N, coefficient: 0.2, transition: transition);
        force pull = { at block.position: (push + rise * t, 0N); }
        freedom slide = block.x from 0m;
    }
}

/// Slopes of friction at rest are no slopes of a block that slides. With F − R, and from the instant on at which the force exceeds the friction.
#[test]
fn friction_with_a_steep_transition_takes_no_time() {
    for transition in [1e-6, 1e-8, 1e-12] {
        for tolerance in [1e-3, 1e-6, 1e-8] {
            let pushed = Rubbed { transition, ..Rubbed::default() };
            let pulled = Rubbed { transition, push: 0.0, rise: 10.0 };
            for (rubbed, speed) in [(pushed, 3.0), (pulled, 3.2)] {
                let mut state = rubbed.initial_state().expect("a state");
                rubbed.advance(&mut state, 1.0, &mut Integrator::stiff(tolerance)).expect("it slides");
                let off = state.block().velocity.x - speed;
                assert!(off.abs() < 10.0 * tolerance + 50.0 * transition, "{off} m/s at {tolerance}, {transition}");
            }
        }
    }
}

/// 10 N for positive speeds.
fn relay<T: Real>(speed: T) -> (T, T, T) {
    (T::select_less(T::of(0.0), speed, T::of(10.0), T::of(0.0)), T::of(0.0), T::of(0.0))
}

mechanism! {
    /// A block on which a function of Rust acts that jumps where the block starts.
    mechanism Switched {
        function law(Velocity) -> Force = relay;
        body block { mass = 1kg; }
        joint rail = translational((1, 0), ground.position, block.position);
        force push = { at block.position: (1N + law(rate(block.x)), 0N); }
        freedom slide = block.x from 0m;
    }
}

/// Nothing is known of the function but its values.
#[test]
fn a_function_of_rust_may_jump_at_the_start() {
    for tolerance in [1e-3, 1e-6, 1e-8] {
        let switched = Switched::default();
        let mut state = switched.initial_state().expect("a state");
        switched.advance(&mut state, 1.0, &mut Integrator::stiff(tolerance)).expect("it slides");
        assert!((state.block().position.x - 5.5).abs() < tolerance.max(1e-9) * 10.0, "{} m", state.block().position.x);
    }
}
