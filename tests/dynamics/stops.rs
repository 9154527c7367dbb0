//! Stops and friction along a guide and in a hinge, against closed forms.

use reuleaux::{Differentiable, Integrator, mechanism};

mechanism! {
    /// A block on a guide runs into a buffer at each end: one between points, one along the guide.
    pub(crate) mechanism Buffers {
        param start: Velocity = 2m_s;
        param exponent: Number = 1.5;
        param damping: Time / Length = 0;
        ground { point far = (500mm, 0mm);  axis u = (1, 0); }
        body block { mass = 3kg; }
        joint guide = translational(ground.u, ground.position, block.position);
        slice force right = stop(ground.far, block.position, 300mm, force: 400N, depth: 5mm, exponent: exponent, damping: damping);
        slice force left = stop_along(ground.position, ground.u, block.position, -100mm, 400N, 5mm, exponent, damping);
        freedom slide = block.x from 100mm at start;
    }
}

mechanism! {
    /// The same along an oblique line in space.
    pub(crate) mechanism ObliqueBuffers in space {
        param start: Velocity = 2m_s;
        param exponent: Number = 1.5;
        param damping: Time / Length = 0;
        let w = (1, 2, 2) / 3;
        ground { point far = 500mm * w;  axis a = w; }
        body block { axis a = (0, 0, 1);  mass = 3kg; }
        joint guide = translational(ground.position, ground.a, block.position, block.a);
        slice force right = stop(ground.far, block.position, 300mm, force: 400N, depth: 5mm, exponent: exponent, damping: damping);
        slice force left = stop_along(ground.position, ground.a, block.position, -100mm, 400N, 5mm, exponent, damping);
        freedom slide = guide.displacement from 100mm at start;
    }
}

mechanism! {
    /// A wheel between the ends of its hinge.
    pub(crate) mechanism Ends {
        param start: AngularVelocity = 2rad_s;
        param exponent: Number = 1.5;
        param damping: Time / Angle = 0;
        body wheel { mass = 3kg;  inertia = 0.5kgm2; }
        joint axle = revolute(ground.position, wheel.position);
        slice force ends = torsion_stop(ground, wheel, -20deg, 40deg, 30Nm, 2deg, exponent, damping);
        freedom turn = wheel.angle from 10deg at start;
    }
}

mechanism! {
    /// The same about an oblique axis in space.
    pub(crate) mechanism ObliqueEnds in space {
        param start: AngularVelocity = 2rad_s;
        param exponent: Number = 1.5;
        param damping: Time / Angle = 0;
        ground { axis a = (1, 2, 2); }
        body wheel { axis a = (1, 2, 2);  mass = 3kg;  inertia = (0.5kgm2, 0.5kgm2, 0.5kgm2); }
        joint axle = revolute(ground.position, ground.a, wheel.position, wheel.a);
        slice force ends = torsion_stop(axle.a, axle.b, -20deg, 40deg, 30Nm, 2deg, exponent: exponent, damping: damping);
        freedom turn = axle.angle from 10deg at start;
    }
}

/// A wheel turns back from the angle at which the work of its stop is its energy, and comes back as fast as it came.
#[test]
fn a_stop_of_a_hinge_gives_back_its_work() {
    for (speed, exponent) in [(2.0_f64, 1.5_f64), (-0.7, 1.5), (1.0, 1.0), (-3.0, 2.5)] {
        let (ends, oblique) = (Ends { start: speed, exponent, damping: 0.0 }, ObliqueEnds { start: speed, exponent, damping: 0.0 });
        let mut state = ends.initial_state().expect("a state");
        let mut integrator = Integrator::new(1e-11);
        let turned = ends.advance_until(&mut state, 1.0, &mut integrator, |state| state.wheel().angular_velocity);
        assert_eq!(turned, Ok(true));
        // ½ J ω² = torque · depth / (exponent + 1) · (δ / depth)^(exponent + 1)
        let depth = 2_f64.to_radians();
        let pressed = depth * (0.25 * speed * speed * (exponent + 1.0) / (30.0 * depth)).powf(1.0 / (exponent + 1.0));
        let wanted = if speed > 0.0 { 40_f64.to_radians() + pressed } else { -20_f64.to_radians() - pressed };
        assert!((state.wheel().angle - wanted).abs() < 1e-9, "{} rad, not {wanted}", state.wheel().angle);
        let torque = ends.load_of_ends(&state).torques[0];
        let push = 30.0 * (pressed / depth).powf(exponent);
        assert!((torque.abs() - push).abs() < 1e-6 * push, "{torque} N m, not {push}");
        ends.advance_until(&mut state, 1.0, &mut integrator, |state| state.wheel().angle - 10_f64.to_radians()).expect("it comes back");
        assert!((state.wheel().angular_velocity + speed).abs() < 1e-8, "{} rad/s after {speed}", state.wheel().angular_velocity);
        let mut other = oblique.initial_state().expect("a state");
        oblique.advance(&mut other, state.t, &mut Integrator::new(1e-11)).expect("it moves");
        // The axis has three thirds: (1, 2, 2) / 3.
        let spin = other.wheel().angular_velocity.x * 3.0;
        assert!((spin + speed).abs() < 1e-7, "{spin} rad/s after {speed}");
    }
}

/// The law of rebounds of the stops below, with ω, J and s/rad.
#[test]
fn a_damped_stop_of_a_hinge_throws_back_by_the_law_of_hunt_and_crossley() {
    let work = |v: f64, c: f64| v / c - (c * v).ln_1p() / (c * c);
    for (speed, damping) in [(2.0_f64, 0.3_f64), (-2.0, 0.05), (-0.8, 4.0)] {
        let ends = Ends { start: speed, exponent: 1.5, damping };
        let mut state = ends.initial_state().expect("a state");
        ends.advance(&mut state, if speed > 0.0 { 0.5 } else { 1.2 / speed.abs() }, &mut Integrator::new(1e-11)).expect("it moves");
        let rebound = -state.wheel().angular_velocity * speed.signum();
        assert!(rebound > 0.0 && rebound < speed.abs(), "{rebound} rad/s after {speed}");
        let (before, after) = (work(speed.abs(), damping), work(-rebound, damping));
        assert!((before - after).abs() < 1e-7 * before, "{rebound} rad/s after {speed}: {before}, {after}");
    }
}

/// Without damping the block comes back as fast as it came, from the depth at which the work of the stop is its energy.
#[test]
fn a_stop_without_damping_gives_back_its_work() {
    for (speed, exponent) in [(2.0_f64, 1.5_f64), (-0.7, 1.5), (1.0, 1.0), (-3.0, 2.5)] {
        let buffers = Buffers { start: speed, exponent, damping: 0.0 };
        let mut state = buffers.initial_state().expect("a state");
        let mut integrator = Integrator::new(1e-11);
        let turned = buffers.advance_until(&mut state, 1.0, &mut integrator, |state| state.block().velocity.x);
        assert_eq!(turned, Ok(true));
        // ½ m v² = force · depth / (exponent + 1) · (δ / depth)^(exponent + 1)
        let depth = 0.005 * (1.5 * speed * speed * (exponent + 1.0) / (400.0 * 0.005)).powf(1.0 / (exponent + 1.0));
        let wanted = if speed > 0.0 { 0.2 + depth } else { -0.1 - depth };
        assert!((state.block().position.x - wanted).abs() < 1e-9, "{} m, not {wanted}", state.block().position.x);
        let push = 400.0 * (depth / 0.005).powf(exponent);
        let [right, left] = [buffers.load_of_right(&state).forces[1].x, buffers.load_of_left(&state).forces[0].x];
        assert!((right + left + push.copysign(speed)).abs() < 1e-6 * push && (right == 0.0) != (left == 0.0), "{right} N, {left} N");
        buffers.advance_until(&mut state, 1.0, &mut integrator, |state| state.block().position.x - 0.1).expect("it comes back");
        assert!((state.block().velocity.x + speed).abs() < 1e-8, "{} m/s after {speed}", state.block().velocity.x);
    }
}

/// v/c − ln(1 + c v)/c² of the speeds before and after a rebound, the one counted backwards, is the same: the work over the mass of what the stop
/// stores at its deepest. It does not depend on the exponent. The stop never pulls.
#[test]
fn a_damped_stop_throws_back_by_the_law_of_hunt_and_crossley() {
    let work = |v: f64, c: f64| v / c - (c * v).ln_1p() / (c * c);
    for (speed, exponent, damping) in [(2.0_f64, 1.5, 0.3_f64), (-2.0, 1.5, 0.05), (0.5, 1.0, 1.0), (-1.0, 3.0, 4.0)] {
        let buffers = Buffers { start: speed, exponent, damping };
        let oblique = ObliqueBuffers { start: speed, exponent, damping };
        let (mut state, mut other) = (buffers.initial_state().expect("a state"), oblique.initial_state().expect("a state"));
        let (mut integrator, mut second) = (Integrator::new(1e-11), Integrator::new(1e-11));
        for frame in 1..=100 {
            buffers.advance(&mut state, 2.5e-3 * f64::from(frame), &mut integrator).expect("it moves");
            let push = [-buffers.load_of_right(&state).forces[1].x, buffers.load_of_left(&state).forces[0].x];
            assert!(push.iter().all(|push| *push >= 0.0), "{push:?} N");
        }
        oblique.advance(&mut other, state.t, &mut second).expect("it moves");
        let rebound = -state.block().velocity.x * speed.signum();
        assert!(rebound > 0.0 && rebound < speed.abs());
        let (before, after) = (work(speed.abs(), damping), work(-rebound, damping));
        assert!((before - after).abs() < 1e-7 * before, "{rebound} m/s after {speed}: {before}, {after}");
        assert!((other.block().velocity.norm() - rebound).abs() < 1e-7, "{} m/s in space", other.block().velocity.norm());
    }
}

mechanism! {
    /// A block slows down on a plane, and a box lies on a slope.
    pub(crate) mechanism Slides {
        param transition: Velocity = 10mm_s;
        gravity = (0, -10m_s2);
        ground { axis u = (1, 0);  axis down = (4, -3);  point high = (0m, 5m); }
        body block { mass = 3kg; }
        body bin { mass = 2kg;  start position = (0m, 5m); }
        joint level = translational(ground.u, ground.position, block.position);
        joint slope = translational(ground.down, ground.high, bin.position);
        slice force rough = friction(ground.position, ground.u, block.position, normal: 30N, coefficient: 0.4, transition: transition);
        slice force rougher = friction(ground.high, ground.down, bin.position, normal: 16N, coefficient: 1, transition: transition);
        freedom slide = block.x from 0 at 3m_s;
        freedom creep = bin.x from 0;
    }
}

/// From m v̇ = −μ N v / √(v² + ε²): the time from speed v to rest is without end, that from v to w is the difference of
/// (√(v² + ε²) − ε arsinh(ε / v)) m / μN, and the way is that of ½ (v √(v² + ε²) + ε² arsinh(v / ε)) m / μN.
fn time_and_way(v: f64, epsilon: f64, slowing: f64) -> [f64; 2] {
    let root = v.hypot(epsilon);
    [(root - epsilon * (epsilon / v).asinh()) / slowing, 0.5 * (v * root + epsilon * epsilon * (v / epsilon).asinh()) / slowing]
}

#[test]
fn friction_slows_a_block_down_by_its_law() {
    for (transition, tolerance) in [(0.5, 1e-11), (0.01, 1e-11), (1e-4, 1e-10)] {
        let slides = Slides { transition };
        let mut state = slides.initial_state().expect("a state");
        let mut integrator = Integrator::new(tolerance);
        for time in [0.2, 0.5, 0.7, 0.74] {
            slides.advance(&mut state, time, &mut integrator).expect("it moves");
            let speed = state.block().velocity.x;
            let [[from, way_from], [to, way_to]] = [3.0, speed].map(|speed| time_and_way(speed, transition, 4.0));
            assert!((from - to - time).abs() < 1e-8, "{} s, not {time}", from - to);
            assert!((way_from - way_to - state.block().position.x).abs() < 1e-8);
            let load = slides.load_of_rough(&state);
            let wanted = -12.0 * speed / speed.hypot(transition);
            assert!((load.forces[0].x - wanted).abs() < 1e-12 && (load.power - wanted * speed).abs() < 1e-11, "{load:?}");
        }
    }
}

/// The block stops after the whole way of its law, and stays there: a stiff motion, since the creep dies down within milliseconds.
#[test]
fn friction_stops_a_block() {
    for transition in [1e-3, 1e-4, 1e-5, 1e-6] {
        let slides = Slides::<f64> { transition };
        let mut state = slides.initial_state().expect("a state");
        let mut integrator = Integrator::stiff(1e-7);
        slides.advance(&mut state, 1.5, &mut integrator).expect("it stops");
        let [_, way] = time_and_way(3.0, transition, 4.0);
        let place = state.block().position.x;
        assert!((place - way).abs() < 1e-7 && (way - 9.0 / 8.0).abs() < 2e-6, "{place} m, not {way}");
        assert!(state.block().velocity.x.abs() < 1e-9, "{} m/s", state.block().velocity.x);
        assert!(integrator.accepted < 1000, "{} steps at {transition} m/s", integrator.accepted);
    }
}

mechanism! {
    /// Pads that are lifted off within a second.
    mechanism Lifted {
        body block { mass = 3kg;  inertia = 1kgm2; }
        body wheel { mass = 1kg;  inertia = 0.3kgm2; }
        joint level = translational((1, 0), ground.position, block.position);
        joint bearing = revolute(ground.position, wheel.position);
        force rough = friction(ground.position, (1, 0), block.position, 30N * (1 - t / 1s), coefficient: 0.4, transition: 1mm_s);
        force dry = torsion_friction(ground, wheel, 3Nm * (1 - t / 1s), transition: 0.01rad_s);
        freedom slide = block.x at 5m_s;
        freedom spin = wheel.angle at 30rad_s;
    }
}

/// While a pad presses it takes F/2 · 1 s of the momentum, but for what is lost below the speed of transition; then nothing.
#[test]
fn pads_that_are_lifted_do_not_drive() {
    let lifted = Lifted::default();
    let mut state = lifted.initial_state().expect("a state");
    for time in [1.0, 2.0, 3.0] {
        lifted.advance(&mut state, time, &mut Integrator::new(1e-10)).expect("it moves");
        assert!((state.block().velocity.x - (5.0 - 0.4 * 30.0 / 2.0 / 3.0)).abs() < 1e-6, "{}", state.block().velocity.x);
        assert!((state.wheel().angular_velocity - (30.0 - 3.0 / 2.0 / 0.3)).abs() < 1e-6, "{}", state.wheel().angular_velocity);
    }
}

/// Down a slope of 3 in 4, m g sin = 12 N, friction of at most 16 N holds at the speed ε · 12 / √(16² − 12²).
#[test]
fn friction_creeps_where_it_would_stick() {
    let slides = Slides::<f64> { transition: 0.01 };
    let mut state = slides.initial_state().expect("a state");
    slides.advance(&mut state, 0.2, &mut Integrator::new(1e-10)).expect("it creeps");
    let wanted = 0.01 * 12.0 / 112_f64.sqrt();
    assert!((state.bin().velocity.norm() - wanted).abs() < 1e-10, "{} m/s, not {wanted}", state.bin().velocity.norm());
    let load = slides.load_of_rougher(&state);
    assert!((load.forces[0].norm() - 12.0).abs() < 1e-6 && load.forces[0] == -load.forces[1], "{load:?}");
}

mechanism! {
    /// A wheel in a bearing with dry friction.
    pub(crate) mechanism DryBearing {
        body wheel { mass = 1kg;  inertia = 0.3kgm2; }
        joint bearing = revolute(ground.position, wheel.position);
        slice force friction = torsion_friction(ground, wheel, torque: 1.2Nm, transition: 0.5rad_s);
        freedom spin = wheel.angle at 30rad_s;
    }
}

mechanism! {
    /// The same about an oblique axis in space.
    pub(crate) mechanism ObliqueDryBearing in space {
        ground { axis a = (1, 2, 2); }
        body wheel { axis a = (0, 0, 1);  mass = 1kg;  inertia = (0.2kgm2, 0.2kgm2, 0.3kgm2); }
        joint bearing = revolute(ground.position, ground.a, wheel.position, wheel.a);
        slice force friction = torsion_friction(ground.a, wheel.a, torque: 1.2Nm, transition: 0.5rad_s);
        freedom spin = bearing.angle from 0 at 30rad_s;
    }
}

#[test]
fn friction_in_a_hinge_slows_a_wheel_down_by_its_law() {
    let (plane, space) = (DryBearing::default(), ObliqueDryBearing::default());
    let (mut flat, mut oblique) = (plane.initial_state().expect("a state"), space.initial_state().expect("a state"));
    let (mut integrator, mut second) = (Integrator::new(1e-11), Integrator::new(1e-11));
    for time in [1.0, 5.0, 7.4, 8.0] {
        plane.advance(&mut flat, time, &mut integrator).expect("it turns");
        space.advance(&mut oblique, time, &mut second).expect("it turns");
        let speed = flat.wheel().angular_velocity;
        let [[from, way_from], [to, way_to]] = [30.0, speed].map(|speed| time_and_way(speed, 0.5, 4.0));
        assert!((from - to - time).abs() < 1e-8 && (way_from - way_to - flat.wheel().angle).abs() < 1e-7, "{} s, not {time}", from - to);
        assert!((oblique.wheel().angular_velocity.norm() - speed).abs() < 1e-8);
        let wanted = 1.2 * speed / speed.hypot(0.5);
        assert!((plane.load_of_friction(&flat).torques[0] + wanted).abs() < 1e-12);
        assert!((space.load_of_friction(&oblique).torques[1].norm() - wanted).abs() < 1e-8);
    }
}

/// With f(v, c) = v/c − ln(1 + c v)/c² the rebound w obeys f(v, c) = f(−w, c), of which ∂w/∂c follows: ∂f/∂v = v / (1 + c v).
#[test]
fn the_speed_after_a_rebound_has_its_derivative_by_the_damping() {
    let (v, c) = (2.0_f64, 0.3_f64);
    let by_damping = |v: f64| -v / (c * c) + 2.0 * (c * v).ln_1p() / c.powi(3) - v / (1.0 + c * v) / (c * c);
    let buffers = Buffers { start: v, exponent: 1.5, damping: c }.with_derivatives(|buffers| [&mut buffers.damping]);
    let mut state = buffers.initial_state().expect("a state");
    buffers.advance(&mut state, 0.1.into(), &mut Integrator::new(1e-11.into())).expect("it moves");
    let end = state.block().velocity.x;
    let w = -end.value;
    let wanted = (by_damping(-w) - by_damping(v)) * (1.0 - c * w) / w;
    assert!((end.by[0] - wanted).abs() < 1e-6 * wanted.abs(), "{end:?}, not {wanted}");
}

mechanism! {
    /// A ball that falls onto an elastic stop and rebounds.
    pub(crate) mechanism Rebounding {
        param exponent: Number = 1.5;
        param stiff: Force = 3000N;
        gravity = (0, -9.81m_s2);
        ground { axis up = (0, 1); }
        body ball { mass = 1kg;  start y = 300mm; }
        joint guide = translational(ground.up, ground.position, ball.position);
        force stop = stop_along(ground.position, ground.up, ball.position, 0m, force: stiff, depth: 2mm, exponent: exponent);
        freedom height = ball.y from 300mm;
    }
}

/// A step that ends behind the contact sees its kink in some of its stages only.
#[test]
fn the_energy_of_a_rebound_is_kept_within_the_tolerance_wherever_steps_end() {
    for exponent in [1.0, 1.5, 2.5] {
        for tolerance in [1e-6, 1e-8, 1e-10] {
            for number in 0..8 {
                let ball = Rebounding { exponent, stiff: 3000.0 * (1.0 + 0.11 * f64::from(number)) };
                let mut state = ball.initial_state().expect("a state");
                let before = ball.energy(&state).total();
                ball.advance(&mut state, 0.4, &mut Integrator::new(tolerance)).expect("it rebounds");
                let change = (ball.energy(&state).total() - before).abs() / before;
                assert!(state.ball().velocity.y > 0.9 && change < 2.0 * tolerance, "{exponent}, {tolerance:e}, {number}: {change:e}");
            }
        }
    }
}
