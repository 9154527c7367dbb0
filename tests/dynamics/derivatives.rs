//! Derivatives by parameters of loads, energies and motions: against closed forms, and against differences between motions.

use reuleaux::{Differentiable, Gradient, Integrator, Mechanism, mechanism};

mechanism! {
    /// A bar turned about its end.
    pub(crate) mechanism Turned {
        param length: Length = 0.6m;
        param weight: Mass = 2kg;
        param speed: AngularVelocity = 3rad_s;
        param growth: AngularAcceleration = 0.4rad_s2;
        gravity = (0, -9.81m_s2);
        body bar { mass = weight;  center = (length / 2, 0m);  inertia = weight * length^2 / 12; }
        joint pivot = revolute(ground.position, bar.position);
        drive motor = drive_angle(bar, speed * t + growth * t^2 / 2);
    }
}

mechanism! {
    /// A crank-rocker with masses.
    pub(crate) mechanism Rocker {
        param crank_length: Length = 0.1m;
        param coupler_length: Length = 0.3m;
        param heavy: Mass = 1.5kg;
        param speed: AngularVelocity = 12rad_s;
        gravity = (0, -9.81m_s2);
        ground { point A = (0m, 0m);  point D = (0.35m, 0m); }
        body crank   { point B = (crank_length, 0m);  mass = 0.8kg;  inertia = 0.002kgm2;  center = (0.05m, 0m); }
        body coupler { point C = (coupler_length, 0m);  mass = heavy;  inertia = 0.015kgm2;  center = (0.16m, 0.05m);  start angle = 0.759rad; }
        body rocker  { point D = (-0.125m, 0m);  point C = (0.125m, 0m);  mass = 1.2kg;  inertia = 0.009kgm2;  start angle = 1.73rad; }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(crank.B, coupler.position);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.D, ground.D);
        slice drive motor = drive_relative_angle(ground, crank, 0.4rad + speed * t);
    }
}

mechanism! {
    /// A weight on two supports at the same place, which share its load.
    pub(crate) mechanism Shared {
        param weight: Mass = 3kg;
        gravity = (0, -9.81m_s2);
        ground { point O = (0m, 0m); }
        body bar { point O = (0m, 0m);  mass = weight;  center = (0.2m, 0m);  inertia = 0.05kgm2; }
        joint first = revolute(ground.O, bar.O);
        redundant joint second = revolute(ground.O, bar.O);
        drive motor = drive_angle(bar, 2rad_s * t);
    }
}

mechanism! {
    /// A crank-rocker that falls.
    pub(crate) mechanism Falling {
        param crank_length: Length = 1m;
        param rocker_length: Length = 3.5m;
        param heavy: Mass = 3.5kg;
        param released: Angle = 0.3rad;
        gravity = (0, -9.81m_s2);
        ground { point A = (0m, 0m);  point D = (4m, 0m); }
        body crank   { point B = (crank_length, 0m);  mass = 1kg;  inertia = 0.083kgm2;  center = (0.5m, 0m); }
        body coupler { point C = (3.5m, 0m);  mass = heavy;  inertia = 3.57kgm2;  center = (1.75m, 0m); }
        body rocker  { point C = (rocker_length, 0m);  mass = 3kg;  inertia = 2.25kgm2;  center = (1.5m, 0m);  start angle = 90deg; }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(crank.B, coupler.position);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.position, ground.D);
        freedom swing = crank.angle from released at 0rad_s;
        output tip = coupler.C;
    }
}

mechanism! {
    /// A top on a ball, free to turn.
    pub(crate) mechanism Top in space {
        param high: Length = 0.3m;
        param spin: AngularVelocity = 90rad_s;
        gravity = (0, 0, -9.81m_s2);
        body top {
            mass = 1.5kg;  center = (0m, 0m, high);  inertia = (0.02kgm2, 0.02kgm2, 0.01kgm2);
            point end = (0m, 0m, 0.5m);
            start orientation = turn((1, 0, 0), 0.4rad);
        }
        joint tip = spherical(ground.position, top.position);
        freedom motion = top.angular_velocity from (0rad_s, -sin(0.4rad) * spin, cos(0.4rad) * spin);
        output end = top.end;
    }
}

mechanism! {
    /// A ball thrown upwards.
    pub(crate) mechanism Thrown {
        param rise: Velocity = 5m_s;
        param fall: Acceleration = 9.81m_s2;
        gravity = (0, -fall);
        ground { point O = (0m, 0m);  axis up = (0, 1); }
        body ball { mass = 1kg;  inertia = 0.01kgm2; }
        joint guide = translational(ground.up, ground.O, ball.position);
        freedom height = ball.position.y from 0m at rise;
    }
}

mechanism! {
    /// A weight that falls through air from rest.
    pub(crate) mechanism Dropped {
        param thick: Mass / Length = 0.3kg / 1m;
        param weight: Mass = 2kg;
        gravity = (0, -9.81m_s2);
        ground { point O = (0m, 0m);  axis up = (0, 1); }
        body ball { mass = weight; }
        joint guide = translational(ground.up, ground.O, ball.position);
        force air = drag(ball.position, thick);
        freedom height = ball.position.y;
    }
}

/// The derivative of f at 0 by central differences of order 6 with step `h`.
fn difference(h: f64, f: impl Fn(f64) -> f64) -> f64 {
    let pair = |k: f64| f(k * h) - f(-k * h);
    (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * h)
}

#[test]
fn functions_of_numbers_with_derivatives_have_those_of_calculus() {
    let x = Gradient { value: 0.4, by: [1.0] };
    let (sine, cosine) = 0.4f64.sin_cos();
    let root = (1.0 - 0.16f64).sqrt();
    let found = [
        (x.sin(), sine, cosine),
        (x.cos(), cosine, -sine),
        (x.tan(), sine / cosine, 1.0 / (cosine * cosine)),
        (x.asin(), 0.4f64.asin(), 1.0 / root),
        (x.acos(), 0.4f64.acos(), -1.0 / root),
        (x.atan(), 0.4f64.atan(), 1.0 / 1.16),
        (x.atan2(2.0 * x + 0.2), 0.4f64.atan(), 0.2 / 1.16),
        (x.exp(), 0.4f64.exp(), 0.4f64.exp()),
        (x.ln(), 0.4f64.ln(), 2.5),
        (x.sqrt(), 0.4f64.sqrt(), 0.5 / 0.4f64.sqrt()),
        ((-x).abs(), 0.4, 1.0),
        (3.0 / x - x / 4.0, 7.4, -18.75 - 0.25),
        ((1.0 - x) * (x * 2.0 - 3.0), -1.32, 2.2 + 1.2),
        (Gradient::norm(&[3.0 * x, 4.0 * x].into()), 2.0, 5.0),
    ];
    for (number, (found, value, slope)) in found.into_iter().enumerate() {
        assert!((found.value - value).abs() < 1e-15 * value.abs().max(1.0) * 4.0, "{number}: {found:?}");
        assert!((found.by[0] - slope).abs() < 1e-14 * slope.abs().max(1.0), "{number}: {found:?} {slope}");
    }
}

#[test]
fn the_torque_on_a_turned_bar_has_the_derivatives_of_its_closed_form() {
    let bar = Turned::default();
    for t in [0.0, 0.3, 1.7] {
        let state = bar.solve(t).expect("a state");
        let (varied, there) =
            bar.derivatives(&state, |m| [&mut m.length, &mut m.weight, &mut m.speed, &mut m.growth]).expect("derivatives");
        let there = TurnedState(there);
        let found = varied.loads(&there).motor();
        // τ = m l²/3 θ̈ + m g l/2 cos θ
        let (l, m, g, a) = (0.6, 2.0, 9.81, 0.4);
        let angle: f64 = 3.0 * t + 0.2 * t * t;
        let (sine, cosine) = angle.sin_cos();
        let torque = m * l * l / 3.0 * a + m * g * l / 2.0 * cosine;
        let turning = -m * g * l / 2.0 * sine;
        let wanted = [2.0 * m * l / 3.0 * a + m * g / 2.0 * cosine, torque / m, turning * t, m * l * l / 3.0 + turning * t * t / 2.0];
        assert!((found.effort.value - torque).abs() < 1e-14 * m * g * l);
        for (found, wanted) in found.effort.by.into_iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-13, "{t}: {found} {wanted}");
        }
        // P = τ θ̇
        let rate = 3.0 + 0.4 * t;
        let wanted = [wanted[0] * rate, wanted[1] * rate, wanted[2] * rate + torque, wanted[3] * rate + torque * t];
        for (found, wanted) in found.power.by.into_iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-12, "{t}: {found} {wanted}");
        }
        // E = m l²/6 θ̇² + m g l/2 sin θ
        let energy = varied.energy(&there);
        assert!((energy.kinetic.by[0] - m * l / 3.0 * rate * rate).abs() < 1e-13);
        assert!((energy.potential.by[2] - m * g * l / 2.0 * cosine * t).abs() < 1e-13);
    }
}

#[test]
fn loads_of_a_loop_have_the_derivatives_of_differences() {
    let rocker = Rocker::default();
    for t in [0.01, 0.13, 0.31] {
        let state = rocker.solve(t).expect("a state");
        let (varied, there) =
            rocker.derivatives(&state, |m| [&mut m.crank_length, &mut m.coupler_length, &mut m.heavy, &mut m.speed]).expect("derivatives");
        let there = RockerState(there);
        let loads = varied.loads(&there);
        assert_eq!(loads.motor(), varied.load_of_motor(&there));
        let numbers = |m: &Rocker| {
            let loads = m.loads(&m.solve(t).expect("a state"));
            [loads.motor().effort, loads.motor().power, loads.b().force.x, loads.c().force.y, loads.multipliers[5]]
        };
        let found = [loads.motor().effort, loads.motor().power, loads.b().force.x, loads.c().force.y, loads.multipliers[5]];
        for (number, found) in found.iter().enumerate() {
            let wanted = [
                difference(2e-4, |h| numbers(&Rocker { crank_length: 0.1 + h, ..rocker })[number]),
                difference(2e-4, |h| numbers(&Rocker { coupler_length: 0.3 + h, ..rocker })[number]),
                difference(1e-2, |h| numbers(&Rocker { heavy: 1.5 + h, ..rocker })[number]),
                difference(1e-2, |h| numbers(&Rocker { speed: 12.0 + h, ..rocker })[number]),
            ];
            let size = wanted.iter().fold(1.0, |size: f64, wanted| size.max(wanted.abs()));
            for (found, wanted) in found.by.into_iter().zip(wanted) {
                assert!((found - wanted).abs() < 1e-8 * size, "{t}, {number}: {found} {wanted}");
            }
        }
    }
}

#[test]
fn redundant_joints_share_the_derivatives_of_their_load() {
    let shared = Shared::default();
    let state = shared.solve(0.4).expect("a state");
    let (varied, there) = shared.derivatives(&state, |m| [&mut m.weight]).expect("derivatives");
    let loads = varied.loads(&SharedState(there));
    // Both carry half of m (a + g), which grows with the mass.
    let (sine, cosine) = 0.8f64.sin_cos();
    let (x, y) = (-0.2 * 4.0 * cosine, -0.2 * 4.0 * sine + 9.81);
    for joint in [loads.first(), loads.second()] {
        assert!(!joint.is_unique);
        assert!((joint.force.x.by[0] - x / 2.0).abs() < 1e-13, "{} {x}", joint.force.x.by[0]);
        assert!((joint.force.y.by[0] - y / 2.0).abs() < 1e-13, "{} {y}", joint.force.y.by[0]);
    }
}

#[test]
fn a_motion_of_a_loop_has_the_derivatives_of_differences() {
    const TIME: f64 = 1.3;
    let falling = Falling::default();
    let varied = falling.with_derivatives(|m| [&mut m.crank_length, &mut m.rocker_length, &mut m.heavy, &mut m.released]);
    let mut state = varied.initial_state().expect("a state");
    let before = varied.energy(&state);
    varied.advance(&mut state, TIME.into(), &mut Integrator::new(1e-12.into())).expect("a motion");
    let found = varied.tip(&state);
    let tip = |m: Falling| {
        let mut state = m.initial_state().expect("a state");
        m.advance(&mut state, TIME, &mut Integrator::new(1e-13)).expect("a motion");
        let tip = m.tip(&state);
        [tip.value.y, tip.rate.x, tip.acceleration.y]
    };
    let found = [found.value.y, found.rate.x, found.acceleration.y];
    for (number, found) in found.iter().enumerate() {
        let wanted = [
            difference(1e-3, |h| tip(Falling { crank_length: 1.0 + h, ..falling })[number]),
            difference(1e-3, |h| tip(Falling { rocker_length: 3.5 + h, ..falling })[number]),
            difference(1e-2, |h| tip(Falling { heavy: 3.5 + h, ..falling })[number]),
            difference(1e-3, |h| tip(Falling { released: 0.3 + h, ..falling })[number]),
        ];
        let size = wanted.iter().fold(1.0, |size: f64, wanted| size.max(wanted.abs()));
        for (found, wanted) in found.by.into_iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-7 * size, "{number}: {found} {wanted}");
        }
    }
    // Energy is conserved, and so are its derivatives.
    let after = varied.energy(&state);
    for k in 0..4 {
        let [before, after] = [before, after].map(|energy| energy.kinetic.by[k] + energy.potential.by[k]);
        assert!((after - before).abs() < 1e-9 * before.abs().max(1.0), "{before} {after}");
    }
}

#[test]
fn a_top_has_the_derivatives_of_differences() {
    const TIME: f64 = 0.4;
    let top = Top::default();
    let varied = top.with_derivatives(|m| [&mut m.high, &mut m.spin]);
    let mut state = varied.initial_state().expect("a state");
    varied.advance(&mut state, TIME.into(), &mut Integrator::new(1e-12.into())).expect("a motion");
    let end = |m: Top| {
        let mut state = m.initial_state().expect("a state");
        m.advance(&mut state, TIME, &mut Integrator::new(1e-13)).expect("a motion");
        m.end(&state).value
    };
    let found = varied.end(&state).value;
    for axis in 0..3 {
        let wanted =
            [difference(1e-3, |h| end(Top { high: 0.3 + h, ..top })[axis]), difference(1e-2, |h| end(Top { spin: 90.0 + h, ..top })[axis])];
        for (found, wanted) in found[axis].by.into_iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-8, "{axis}: {found} {wanted}");
        }
    }
    let (reaction, energy) = (varied.loads(&state).tip().force, varied.energy(&state));
    assert!(reaction.iter().all(|force| force.by.iter().all(|by| by.is_finite())));
    // E = m g h cos θ + C ω²/2 as at the beginning, for θ = 0.4 rad.
    assert!((energy.kinetic.by[0] + energy.potential.by[0] - 1.5 * 9.81 * 0.4f64.cos()).abs() < 1e-9);
    assert!((energy.kinetic.by[1] + energy.potential.by[1] - 0.01 * 90.0).abs() < 1e-9);
}

#[test]
fn the_instant_of_an_event_depends_on_parameters() {
    let varied = Thrown::default().with_derivatives(|m| [&mut m.rise, &mut m.fall]);
    let mut state = varied.initial_state().expect("a state");
    let mut integrator = Integrator::new(Gradient::from(1e-10));
    let event = |state: &ThrownState<Gradient<f64, 2>>| state.ball().velocity.y;
    let is_found = varied.advance_until(&mut state, 1.0.into(), &mut integrator, event).expect("a motion");
    assert!(is_found);
    // At the top: t = v/g, h = v²/2g.
    let (v, g) = (5.0, 9.81);
    let [by_rise, by_fall] = state.t.by;
    assert!((state.t.value - v / g).abs() < 1e-14);
    assert!((by_rise - 1.0 / g).abs() < 1e-13 && (by_fall + v / (g * g)).abs() < 1e-13, "{by_rise} {by_fall}");
    let [by_rise, by_fall] = state.ball().position.y.by;
    assert!((by_rise - v / g).abs() < 1e-13 && (by_fall + v * v / (2.0 * g * g)).abs() < 1e-13, "{by_rise} {by_fall}");
}

#[test]
fn drag_has_derivatives_at_rest() {
    let dropped = Dropped::default();
    let varied = dropped.with_derivatives(|m| [&mut m.thick, &mut m.weight]);
    let mut state = varied.initial_state().expect("a state");
    assert_eq!(state.ball().acceleration.y.by, [0.0; 2]);
    assert_eq!(varied.loads(&state).air().power.by, [0.0; 2]);
    varied.advance(&mut state, 1.0.into(), &mut Integrator::new(1e-12.into())).expect("a motion");
    // y = −m/c ln cosh(√(g c/m) t) and its derivatives by c and m, by mpmath with 40 digits.
    let (height, by) = (-4.030_648_649_706_75, [2.146_097_263_649_474, -0.321_914_589_547_421_2]);
    let found = state.ball().position.y;
    assert!((found.value - height).abs() < 1e-11, "{found:?}");
    assert!((found.by[0] - by[0]).abs() < 1e-10 && (found.by[1] - by[1]).abs() < 1e-10, "{found:?}");
}

mechanism! {
    /// A slide that runs against a spring.
    pub(crate) mechanism Bumped {
        param speed: Velocity = 1m_s;
        param stiffness: Stiffness = 100N_m;
        body slide { mass = 1kg; }
        joint rail = translational((1, 0), (0m, 0m), slide.position);
        force stop = { at slide.position: (-stiffness * max(slide.x, 0m), 0N); }
        freedom stroke = slide.x from -100mm at speed;
    }
}

#[test]
fn a_kink_of_a_force_leaves_derivatives_their_digits() {
    // From the contact at 0.1 m / v on, x = v/ω sin ω(t − 0.1 m / v), ω = √k
    let (t, v, k) = (0.25, 1.0, 100.0_f64);
    let (omega, contact) = (k.sqrt(), 0.1 / v);
    let (sine, cosine) = (omega * (t - contact)).sin_cos();
    let by_speed = sine / omega + contact / v * cosine;
    let by_stiffness = (v * (t - contact) * cosine / omega - v * sine / (omega * omega)) / (2.0 * omega);
    for (tolerance, most) in [(1e-4, 1e-4), (1e-6, 1e-6), (1e-9, 1e-9)] {
        let varied = Bumped::default().with_derivatives(|bumped| [&mut bumped.speed, &mut bumped.stiffness]);
        let mut state = varied.initial_state().expect("a state");
        varied.advance(&mut state, t.into(), &mut Integrator::new(tolerance.into())).expect("the motion goes on");
        let [found_by_speed, found_by_stiffness] = state.slide().position.x.by;
        assert!((found_by_speed / by_speed - 1.0).abs() < most, "{tolerance}: {found_by_speed} for {by_speed}");
        assert!((found_by_stiffness / by_stiffness - 1.0).abs() < most, "{tolerance}: {found_by_stiffness} for {by_stiffness}");
    }
}

mechanism! {
    /// A pendulum whose motion does not depend on its mass.
    pub(crate) mechanism Massive {
        param heavy: Mass = 1.3kg;
        param released: Angle = 40deg;
        param springy: Stiffness = 0N_m;
        gravity = (0, -9.81m_s2);
        body bob { mass = heavy;  center = (0.4m, 0m);  inertia = heavy * (0.02m)^2; }
        joint pivot = revolute(ground.position, bob.position);
        force pull = spring((0m, 1m), bob.position, stiffness: springy, rest: 0.5m);
        freedom swing = bob.angle from released;
    }
}

#[test]
fn a_derivative_that_cancels_does_not_shorten_steps() {
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let mut alone = Integrator::new(tolerance);
        let plain = Massive::default();
        let mut state = plain.initial_state().expect("a state");
        plain.advance(&mut state, 2.0, &mut alone).expect("the motion goes on");
        let varied = plain.with_derivatives(|massive| [&mut massive.heavy, &mut massive.springy, &mut massive.released]);
        let (mut state, mut integrator) = (varied.initial_state().expect("a state"), Integrator::new(tolerance.into()));
        varied.advance(&mut state, 2.0.into(), &mut integrator).expect("the motion goes on");
        let [by_mass, by_spring, by_release] = state.bob().angle.by;
        assert!(by_mass.abs() < 1e-10 && by_spring.abs() < 1e-10 && by_release.abs() > 0.1, "{by_mass} {by_spring} {by_release}");
        let (steps, tried) = (alone.accepted + alone.rejected, integrator.accepted + integrator.rejected);
        assert!(tried <= 2 * steps, "{tolerance}: {tried} steps for {steps}");
    }
}

mechanism! {
    /// A slide that runs against a ball.
    pub(crate) mechanism Hertzian {
        param speed: Velocity = 1m_s;
        body slide { mass = 1kg; }
        joint rail = translational((1, 0), (0m, 0m), slide.position);
        force contact = { at slide.position: (-1000N * (max(slide.x, 0m) / 1m) ^ 2.5, 0N); }
        freedom stroke = slide.x from -100mm at speed;
    }
}

mechanism! {
    /// A ball that falls onto a ground by the law of Hertz.
    pub(crate) mechanism Hopper {
        param stiffness: Force = 1e5N;
        param exponent: Number = 1.5;
        param height: Length = 100mm;
        gravity = (0m_s2, -9.81m_s2);
        body ball { mass = 1kg; }
        joint rail = translational((0, 1), (0m, 0m), ball.position);
        force contact = { at ball.position: (0N, stiffness * max(-ball.y / 1m, 0) ^ exponent); }
        freedom fall = ball.y from height;
    }
}

#[test]
fn a_contact_by_the_law_of_hertz_has_the_derivatives_of_differences() {
    let after = |[stiffness, exponent, height]: [f64; 3]| {
        let hopper = Hopper { stiffness, exponent, height };
        let mut state = hopper.initial_state().expect("a state");
        hopper.advance(&mut state, 0.3, &mut Integrator::new(1e-13)).expect("a motion");
        state.ball().position.y
    };
    let varied = Hopper::default().with_derivatives(|hopper| [&mut hopper.stiffness, &mut hopper.exponent, &mut hopper.height]);
    let mut state = varied.initial_state().expect("a state");
    assert!(state.ball().acceleration.y.by.iter().all(|by| by.is_finite()));
    varied.advance(&mut state, 0.3.into(), &mut Integrator::new(1e-12.into())).expect("a motion");
    let middle = [1e5, 1.5, 0.1];
    for (k, h) in [100.0, 1e-4, 1e-5].into_iter().enumerate() {
        let at = |change: f64| {
            let mut values = middle;
            values[k] += change;
            after(values)
        };
        let right = (at(h) - at(-h)) / (2.0 * h);
        let found = state.ball().position.y.by[k];
        assert!((found / right - 1.0).abs() < 1e-4, "{k}: {found}, not {right}");
    }
}

#[test]
fn a_power_that_rests_at_zero_has_derivatives() {
    let varied = Hertzian::default().with_derivatives(|hertzian| [&mut hertzian.speed]);
    let mut state = varied.initial_state().expect("a state");
    varied.advance(&mut state, 0.05.into(), &mut Integrator::new(1e-9.into())).expect("the motion goes on");
    // x = v t − 0.1 m before the contact
    let [by_speed] = state.slide().position.x.by;
    assert!((by_speed - 0.05).abs() < 1e-14, "{by_speed}");
}
