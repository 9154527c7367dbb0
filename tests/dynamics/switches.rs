//! Forces and driven accelerations that jump: derivatives of the motion by parameters on which the instant of the jump depends, and events there.

use reuleaux::{Differentiable, Gradient, Integrator, mechanism};

mechanism! {
    /// A slide that is braked from a place on, and from a time on.
    pub(crate) mechanism Braked {
        param speed: Velocity = 2m_s;
        param brake: Force = 3N;
        param edge: Length = 1m;
        param when: Time = 10s;
        body b { mass = 1kg; }
        joint rail = translational((1, 0), (0m, 0m), b.position);
        force by_place = { at b.position: (if b.x > edge { -brake } else { 0N }, 0N); }
        force by_time = { at b.position: (if t > when { -brake } else { 0N }, 0N); }
        freedom stroke = b.x from 0m at speed;
    }
}

/// x = e + v τ − f τ²/2 with the time τ = t − e/v behind the edge.
fn braked([v, f, e]: [f64; 3], t: f64) -> ([f64; 3], [f64; 3]) {
    let tau = t - e / v;
    let (by_v, by_e) = (e / (v * v), -1.0 / v);
    let speed = v - f * tau;
    ([tau + speed * by_v, -tau * tau / 2.0, 1.0 + speed * by_e], [1.0 - f * by_v, -tau, -f * by_e])
}

#[track_caller]
fn are_near(found: [f64; 3], right: [f64; 3], allowed: f64) {
    assert!(found.iter().zip(&right).all(|(found, right)| (found - right).abs() < allowed), "{found:?}, not {right:?}");
}

#[test]
fn a_force_that_jumps_at_a_place_has_the_derivatives_of_its_closed_form() {
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let varied = Braked::default().with_derivatives(|m| [&mut m.speed, &mut m.brake, &mut m.edge]);
        let mut state = varied.initial_state().expect("a state");
        varied.advance(&mut state, 1.0.into(), &mut Integrator::new(tolerance.into())).expect("a motion");
        let (position, speed) = braked([2.0, 3.0, 1.0], 1.0);
        are_near(state.b().position.x.by, position, 1e-8);
        are_near(state.b().velocity.x.by, speed, 1e-8);
    }
}

#[test]
fn a_force_that_jumps_at_a_time_has_the_derivatives_of_its_closed_form() {
    let varied = Braked { when: 0.3, edge: 9.0, ..Default::default() }.with_derivatives(|m| [&mut m.speed, &mut m.brake, &mut m.when]);
    let mut state = varied.initial_state().expect("a state");
    varied.advance(&mut state, 1.0.into(), &mut Integrator::new(1e-10.into())).expect("a motion");
    // x = v t − f (t − w)²/2
    are_near(state.b().position.x.by, [1.0, -0.245, 3.0 * 0.7], 1e-8);
    are_near(state.b().velocity.x.by, [1.0, -0.7, 3.0], 1e-8);
}

/// At a loose tolerance, from t = 0 on, a small force, a late instant: the jump is found in steps of any size.
#[test]
fn derivatives_do_not_depend_on_the_size_of_steps() {
    for (brake, when, tolerance) in [(3.0, 1e-3, 1e-4), (0.005, 1e-3, 1e-4), (0.005, 0.3, 1e-4), (3.0, 60.0, 1e-9)] {
        let varied =
            Braked { brake, when, edge: 1e3, ..Default::default() }.with_derivatives(|m| [&mut m.speed, &mut m.brake, &mut m.when]);
        let mut state = varied.initial_state().expect("a state");
        let end = when + 0.7;
        varied.advance(&mut state, end.into(), &mut Integrator::new(tolerance.into())).expect("a motion");
        are_near(state.b().position.x.by, [end, -0.245, brake * 0.7], 1e-7 * end.max(1.0));
        are_near(state.b().velocity.x.by, [1.0, -0.7, brake], 1e-7);
    }
}

/// By implicit steps, and at the times of a sweep.
#[test]
fn stiff_steps_and_sweeps_follow_derivatives_across_a_jump() {
    let varied = Braked::default().with_derivatives(|m| [&mut m.speed, &mut m.brake, &mut m.edge]);
    let (position, speed) = braked([2.0, 3.0, 1.0], 1.0);
    let mut state = varied.initial_state().expect("a state");
    varied.advance(&mut state, 1.0.into(), &mut Integrator::stiff(1e-9.into())).expect("a motion");
    are_near(state.b().position.x.by, position, 1e-8);
    are_near(state.b().velocity.x.by, speed, 1e-8);
    let times = [0.25, 0.5, 0.75, 1.0].map(Gradient::from);
    let last = varied.sweep(times, Integrator::new(1e-9.into())).last().expect("states").expect("a motion");
    are_near(last.b().position.x.by, position, 1e-8);
    are_near(last.b().velocity.x.by, speed, 1e-8);
}

/// Backwards in time the force that acted ends.
#[test]
fn derivatives_are_followed_backwards_across_a_jump() {
    let varied = Braked { when: 0.3, edge: 9.0, ..Default::default() }.with_derivatives(|m| [&mut m.speed, &mut m.brake, &mut m.when]);
    let mut state = varied.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-10.into());
    varied.advance(&mut state, 1.0.into(), &mut integrator).expect("a motion");
    varied.advance(&mut state, 0.0.into(), &mut integrator).expect("a motion");
    are_near(state.b().position.x.by, [0.0, 0.0, 0.0], 1e-8);
    are_near(state.b().velocity.x.by, [1.0, 0.0, 0.0], 1e-8);
}

/// The state at the jump depends on the parameters as the place does; what follows does as without a stop.
#[test]
fn an_event_at_the_jump_of_a_force_has_derivatives() {
    let varied = Braked::default().with_derivatives(|m| [&mut m.speed, &mut m.brake, &mut m.edge]);
    let mut state = varied.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-10.into());
    let event = |state: &BrakedState<Gradient<f64, 3>>| state.b().position.x - varied.edge;
    assert!(varied.advance_until(&mut state, 1.0.into(), &mut integrator, event).expect("an event"));
    // t = e/v
    assert!((state.t.value - 0.5).abs() < 1e-14);
    are_near(state.t.by, [-0.25, 0.0, 0.5], 1e-8);
    are_near(state.b().position.x.by, [0.0, 0.0, 1.0], 1e-8);
    are_near(state.b().velocity.x.by, [1.0, 0.0, 0.0], 1e-8);
    varied.advance(&mut state, 1.0.into(), &mut integrator).expect("a motion");
    let (position, speed) = braked([2.0, 3.0, 1.0], 1.0);
    are_near(state.b().position.x.by, position, 1e-8);
    are_near(state.b().velocity.x.by, speed, 1e-8);
}

mechanism! {
    /// A crane whose car is moved within a given time, by a law with an acceleration that jumps at its end.
    pub(crate) mechanism Crane {
        param duration: Time = 2s;
        param way: Length = 3m;
        gravity = (0m_s2, -9.81m_s2);
        body car { }
        body load { mass = 1kg;  center = (0m, -2m); }
        joint rail = translational((1, 0), (0m, 0m), car.position);
        joint pin = revolute(car.position, load.position);
        drive move_it = drive_x(car.position, way * harmonic(t / duration));
        freedom swing = load.angle from 0deg;
    }
}

#[test]
fn a_motion_behind_the_end_of_a_law_depends_on_its_duration() {
    let swing = |duration: f64, way: f64| {
        let crane = Crane { duration, way };
        let mut state = crane.initial_state().expect("a state");
        crane.advance(&mut state, 3.0, &mut Integrator::new(1e-13)).expect("a motion");
        state.load().angle
    };
    let varied = Crane::default().with_derivatives(|m| [&mut m.duration, &mut m.way]);
    let mut state = varied.initial_state().expect("a state");
    varied.advance(&mut state, 3.0.into(), &mut Integrator::new(1e-11.into())).expect("a motion");
    let h = 1e-4;
    let differences =
        [swing(2.0 + h, 3.0) - swing(2.0 - h, 3.0), swing(2.0, 3.0 + h) - swing(2.0, 3.0 - h)].map(|change| change / (2.0 * h));
    let found = state.load().angle.by;
    assert!(found.iter().zip(&differences).all(|(found, right)| (found - right).abs() < 1e-6), "{found:?}, not {differences:?}");
}

mechanism! {
    /// A crank with a torque that jumps at an angle, before a rocker.
    pub(crate) mechanism Pushed {
        param torque: Torque = 2Nm;
        param until: Angle = 1.5rad;
        param heavy: Mass = 2kg;
        ground { point C = (400mm, 0mm); }
        body crank { point A = (100mm, 0mm);  mass = 1kg;  inertia = 0.02kgm2; }
        body coupler { point B = (350mm, 0mm);  mass = heavy;  center = (175mm, 0mm);  inertia = 0.02kgm2; }
        body rocker { point B = (300mm, 0mm);  mass = 1kg;  inertia = 0.03kgm2;  start angle = 115deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        force push = { on crank: if crank.angle > until { -torque } else { torque }; }
        freedom turn = crank.angle from 0.5rad at 4rad_s;
    }
}

#[test]
fn a_jump_beside_loops_has_the_derivatives_of_differences() {
    let angle = |[torque, until, heavy]: [f64; 3]| {
        let pushed = Pushed { torque, until, heavy };
        let mut state = pushed.initial_state().expect("a state");
        pushed.advance(&mut state, 0.5, &mut Integrator::new(1e-13)).expect("a motion");
        state.rocker().angle
    };
    let varied = Pushed::default().with_derivatives(|m| [&mut m.torque, &mut m.until, &mut m.heavy]);
    let mut state = varied.initial_state().expect("a state");
    varied.advance(&mut state, 0.5.into(), &mut Integrator::new(1e-11.into())).expect("a motion");
    let (middle, h) = ([2.0, 1.5, 2.0], 1e-4);
    let differences = [0, 1, 2].map(|k| {
        let at = |change: f64| {
            let mut values = middle;
            values[k] += change;
            angle(values)
        };
        (at(h) - at(-h)) / (2.0 * h)
    });
    assert!(differences[1].abs() > 0.01, "the place matters: {differences:?}");
    are_near(state.rocker().angle.by, differences, 1e-6);
}

/// A call may begin just before an event.
#[test]
fn an_event_just_after_the_beginning_has_derivatives() {
    for before in [1e-3, 1e-7, 1e-9, 1e-12] {
        let varied = Braked { edge: 9.0, ..Default::default() }.with_derivatives(|m| [&mut m.speed, &mut m.brake, &mut m.edge]);
        let mut state = varied.initial_state().expect("a state");
        let mut integrator = Integrator::new(1e-10.into());
        varied.advance(&mut state, (0.5 - before).into(), &mut integrator).expect("a motion");
        let event = |state: &BrakedState<Gradient<f64, 3>>| state.b().position.x - Gradient::from(1.0);
        assert!(varied.advance_until(&mut state, 1.0.into(), &mut integrator, event).expect("an event"), "{before}");
        // t = 1 m / v
        assert!((state.t.value - 0.5).abs() < 1e-14, "{before}: {:?}", state.t);
        are_near(state.t.by, [-0.25, 0.0, 0.0], 1e-12);
    }
}

/// An event may be an acceleration, which the motion does not carry along.
#[test]
fn an_event_of_an_acceleration_has_derivatives() {
    let varied = Crane::default().with_derivatives(|m| [&mut m.duration, &mut m.way]);
    let mut state = varied.initial_state().expect("a state");
    let event = |state: &CraneState<Gradient<f64, 2>>| state.car().acceleration.x;
    assert!(varied.advance_until(&mut state, 1.5.into(), &mut Integrator::new(1e-10.into()), event).expect("an event"));
    // s (1 − cos(π t / T)) / 2 has no acceleration at T/2.
    assert!((state.t.value - 1.0).abs() < 1e-12, "{:?}", state.t);
    assert!((state.t.by[0] - 0.5).abs() < 1e-9 && state.t.by[1].abs() < 1e-9, "{:?}", state.t);
}

mechanism! {
    /// A ball that falls.
    pub(crate) mechanism Falling {
        param height: Length = 5m;
        gravity = (0m_s2, -10m_s2);
        body b { mass = 1kg;  inertia = 0.01kgm2; }
        freedom place = b.position from (0m, height);
        freedom turn = b.angle;
    }
}

/// 4 m are fallen after √(2 · 4 m / 10 m/s²); what is zero from there on became so then.
#[test]
fn an_event_that_stays_zero_is_found_where_it_became_so() {
    let events: [fn(&FallingState<f64>) -> f64; 3] = [
        |state| (state.b().position.y - 1.0).max(0.0),
        |state| if state.b().position.y > 1.0 { 1.0 } else { 0.0 },
        |state| state.b().position.y - 1.0,
    ];
    for (number, event) in events.into_iter().enumerate() {
        let falling = Falling::default();
        let mut state = falling.initial_state().expect("a state");
        let is_found = falling.advance_until(&mut state, 3.0, &mut Integrator::new(1e-9), event).expect("a motion");
        assert!(is_found && (state.t - 0.8_f64.sqrt()).abs() < 1e-14, "{number}: {}", state.t);
    }
}

/// t = √(2 (h − 1 m)/g)
#[test]
fn an_event_that_stays_zero_depends_on_parameters_as_it_becomes_so() {
    let varied = Falling::default().with_derivatives(|m| [&mut m.height]);
    let mut state = varied.initial_state().expect("a state");
    let event = |state: &FallingState<Gradient<f64, 1>>| {
        let above = state.b().position.y - Gradient::from(1.0);
        if above.value > 0.0 { above } else { Gradient::from(0.0) }
    };
    assert!(varied.advance_until(&mut state, 3.0.into(), &mut Integrator::new(1e-10.into()), event).expect("a motion"));
    let t = 0.8_f64.sqrt();
    assert!((state.t.value - t).abs() < 1e-13 && (state.t.by[0] - 0.1 / t).abs() < 1e-7, "{:?}", state.t);
}

/// Of two numbers neither tells how the instant depends on the height.
#[test]
fn an_event_without_a_slope_has_no_derivatives() {
    let varied = Falling::default().with_derivatives(|m| [&mut m.height]);
    let mut state = varied.initial_state().expect("a state");
    let event = |state: &FallingState<Gradient<f64, 1>>| Gradient::from(if state.b().position.y.value > 1.0 { 1.0 } else { -1.0 });
    varied.advance_until(&mut state, 3.0.into(), &mut Integrator::new(1e-10.into()), event).expect_err("no slope");
}

mechanism! {
    /// A top that is braked from the instant on at which a point of it passes a plane.
    pub(crate) mechanism Spun in space {
        param w: AngularVelocity = 1rad_s;
        body top { point P = (100mm, 50mm, 30mm);  mass = 1kg;  inertia = (0.01kgm2, 0.01kgm2, 0.01kgm2); }
        joint ball = spherical(ground.position, top.position);
        freedom spin = top.angular_velocity from (0rad_s, 0rad_s, w);
        force kick = { on top: (0Nm, 0Nm, if top.P.x < 0 { -0.1Nm } else { 0Nm }); }
    }
}

/// tan(w t) = 2, dt/dw = −t/w
#[test]
fn an_event_in_space_where_a_force_jumps_has_the_derivative_of_its_instant() {
    let varied = Spun::default().with_derivatives(|m| [&mut m.w]);
    let mut state = varied.initial_state().expect("a state");
    let point = [0.1, 0.05, 0.03].map(Gradient::from).into();
    let event = |state: &SpunState<Gradient<f64, 1>>| state.top().point(point).value.x;
    assert!(varied.advance_until(&mut state, 5.0.into(), &mut Integrator::new(1e-12.into()), event).expect("a motion"));
    let t = 2_f64.atan();
    assert!((state.t.value - t).abs() < 1e-12 && (state.t.by[0] + t).abs() < 1e-9, "{:?}, not {t}", state.t);
    let turn = state.top().angular_velocity.z;
    assert!((turn.value - 1.0).abs() < 1e-12 && (turn.by[0] - 1.0).abs() < 1e-9, "{turn:?}");
}

mechanism! {
    /// A driven place that is chosen by another one, which is driven by a later item, beside a freedom.
    pub(crate) mechanism Reading {
        body reading { mass = 1kg; }
        body read { mass = 1kg; }
        body wheel { mass = 1kg;  inertia = 0.1kgm2; }
        joint turned = absolute_angle(reading, 0);
        joint turned_too = absolute_angle(read, 0);
        joint height = absolute_y(reading.position, 0m);
        joint height_too = absolute_y(read.position, 0m);
        joint bearing = revolute((0m, 0m), wheel.position);
        drive law = drive_x(reading.position, if read.x < 1m { 0.5m } else { 0.5m + 0.1m_s * (t - 1s) });
        drive other = drive_x(read.position, 1m_s * t);
        freedom spin = wheel.angle from 0.2rad at 1rad_s;
    }
}

#[test]
fn a_driven_place_is_chosen_by_the_state_at_hand() {
    let reading = Reading::default();
    let mut state = reading.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-9);
    for (t, wanted) in [(0.5, [0.5, 0.0]), (1.1, [0.51, 0.1]), (1.5, [0.55, 0.1])] {
        reading.advance(&mut state, t, &mut integrator).expect("a motion");
        let found = state.reading();
        assert!((found.position.x - wanted[0]).abs() < 1e-12 && (found.velocity.x - wanted[1]).abs() < 1e-12, "t = {t}: {found:?}");
    }
}

mechanism! {
    /// A block that is braked to rest by a force and by dry friction.
    mechanism Halted {
        param friction: Force = 2N;
        param force: Force = 20N;
        param speed: Velocity = 1m_s;
        body b { mass = 1kg; }
        joint rail = translational((1, 0), (0m, 0m), b.position);
        force brake = { at b.position: (-force - if rate(b.x) > 0 { friction } else { -friction }, 0N); }
        freedom stroke = b.x from 0m at speed;
    }
}

/// It stops at v/(F + R), where the friction turns over; then it is pushed back by F − R.
#[test]
fn an_event_where_a_force_jumps_has_the_derivatives_of_its_instant() {
    for (friction, force, speed) in [(2.0, 20.0, 1.0), (0.3, 7.0, 2.5), (5.0, 6.0, 0.1)] {
        for tolerance in [1e-5, 1e-7, 1e-9, 1e-11] {
            let halted = Halted { friction, force, speed }.with_derivatives(|m| [&mut m.friction, &mut m.force, &mut m.speed]);
            let mut state = halted.initial_state().expect("a state");
            let mut integrator = Integrator::new(tolerance.into());
            halted.advance_until(&mut state, 10.0.into(), &mut integrator, |state| state.b().velocity.x).expect("a motion");
            let sum = force + friction;
            let by_force = -speed / (sum * sum);
            are_near(state.t.by, [by_force, by_force, 1.0 / sum], 1e-8 + tolerance);
            // x = v²/(2 (F + R)) − (F − R) τ²/2 with τ = 1 s
            let end = state.t + Gradient::from(1.0);
            halted.advance(&mut state, end, &mut integrator).expect("a motion");
            let place = -speed * speed / (2.0 * sum * sum);
            are_near(state.b().position.x.by, [place + 0.5, place - 0.5, speed / sum], 1e-7 + 10.0 * tolerance);
        }
    }
}

mechanism! {
    /// A pendulum on a slide that a law moves, which begins and ends with a jump of its acceleration.
    mechanism Carried {
        param begin: Time = 0.3s;
        gravity = (0, -9.81m_s2);
        body slide { }
        body bob { mass = 1kg; center = (0m, -1m); }
        joint rail = translational((1, 0), (0m, 0m), slide.position);
        joint pivot = revolute(slide.position, bob.position);
        drive push = drive_x(slide.position, 0.1m * harmonic((t - begin) / 0.2s));
        freedom swing = bob.angle from 0.1rad;
    }
}

/// The speed of the bob has derivatives by the beginning that jump with the acceleration: at the instant itself they are those of one side.
#[test]
fn a_sweep_to_the_instant_of_a_jump_has_the_derivatives_of_one_side() {
    let carried = Carried::default().with_derivatives(|m| [&mut m.begin]);
    let states = |times: &[f64], tolerance: f64| {
        let times: Vec<Gradient<f64, 1>> = times.iter().map(|time| (*time).into()).collect();
        carried.sweep(times, Integrator::new(tolerance.into())).map(|state| state.expect("a state")).collect::<Vec<_>>()
    };
    let at =
        |times: &[f64], tolerance| states(times, tolerance).iter().map(|state| state.bob().angular_velocity.by[0]).collect::<Vec<f64>>();
    let sides = at(&[0.5 - 1e-6, 0.5 + 1e-6], 1e-9);
    // The slide had −0.1 m/2 (π/0.2 s)² before, and its rod is 1 m long.
    let tilt = states(&[0.5], 1e-9)[0].bob().angle.value.cos();
    let jump = 0.05 * (std::f64::consts::PI / 0.2).powi(2) * tilt;
    assert!((sides[1] - sides[0] - jump).abs() < 1e-3, "{sides:?} without {jump}");
    for tolerance in [1e-5, 1e-7, 1e-9] {
        for times in [&[0.2, 0.5, 0.51][..], &[0.1, 0.3, 0.5], &[0.25, 0.5], &[0.5]] {
            let found = at(times, tolerance)[times.iter().position(|time| *time == 0.5).expect("the instant")];
            let off = sides.iter().fold(f64::INFINITY, |least, side| least.min((side - found).abs()));
            assert!(off < 1e-3, "{found} is none of {sides:?} at {tolerance} with {times:?}");
        }
    }
}

mechanism! {
    /// A trolley on a spring behind a carriage that a law moves out of rest.
    mechanism Trailing {
        param begin: Time = 0.3s;
        param height: Length = 0.1m;
        body carriage { mass = 1kg; }
        body trolley { mass = 1kg; }
        joint front = translational((1, 0), (0m, 0m), carriage.position);
        joint rear = translational((1, 0), (0m, 0m), trolley.position);
        drive push = drive_x(carriage.position, height * harmonic((t - begin) / 0.2s));
        force spring = {
            at trolley.position: (-100N_m * (trolley.x - carriage.x), 0N);
            at carriage.position: (100N_m * (trolley.x - carriage.x), 0N);
        }
        freedom follow = trolley.x from 0m;
    }
}

/// All is at rest before the law begins, and what moves first is smaller than any tolerance. With the time τ since then
///
/// ```text
/// x = h/2 (1 − cos ωτ) − h/2 ω²/(ω² − Ω²) (cos Ωτ − cos ωτ)        ω² = 100/s², Ω = π/0.2 s
/// ```
#[test]
fn derivatives_begin_with_a_law_in_explicit_and_in_implicit_steps() {
    let (natural, driven) = (10.0, std::f64::consts::PI / 0.2);
    for (begin, height) in [(0.3, 0.1), (0.317, 0.05)] {
        let (end, factor) = (0.45, natural * natural / (natural * natural - driven * driven));
        let (slow, fast) = ((natural * (end - begin)).sin_cos(), (driven * (end - begin)).sin_cos());
        let by_height = 0.5 * (1.0 - slow.1) - 0.5 * factor * (fast.1 - slow.1);
        let speed = 0.5 * height * (natural * slow.0 + factor * (driven * fast.0 - natural * slow.0));
        let varied = Trailing { begin, height }.with_derivatives(|m| [&mut m.begin, &mut m.height]);
        for tolerance in [1e-3, 1e-5, 1e-7] {
            let [mut explicit, mut implicit] = [(); 2].map(|()| varied.initial_state().expect("a state"));
            let (mut long, mut stiff) = (Integrator::new(tolerance.into()), Integrator::stiff(tolerance.into()));
            varied.advance(&mut explicit, end.into(), &mut long).expect("a motion");
            varied.advance(&mut implicit, end.into(), &mut stiff).expect("a motion");
            assert!(long.accepted < 100 && stiff.accepted < 1000, "{} and {} steps at {tolerance}", long.accepted, stiff.accepted);
            for state in [explicit, implicit] {
                let [found, by] = state.trolley().position.x.by;
                assert!((found + speed).abs().max((by - by_height).abs()) < 1e-9 + tolerance, "{found}, {by} at {tolerance}");
            }
        }
    }
}

mechanism! {
    /// A block on a spring.
    mechanism Swung {
        param stiffness: Stiffness = 4N_m;
        param away: Length = 0.5m;
        body b { mass = 1kg; }
        joint rail = translational((1, 0), (0m, 0m), b.position);
        force spring = spring((0m, 0m), b.position, stiffness: stiffness);
        freedom stroke = b.x from away;
    }
}

/// It passes the middle at π/(2 √k), where its acceleration passes through zero without a jump.
#[test]
fn an_event_where_an_acceleration_vanishes_has_the_derivatives_of_its_instant() {
    let swung = Swung::default().with_derivatives(|m| [&mut m.stiffness, &mut m.away]);
    for tolerance in [1e-5, 1e-8, 1e-11] {
        let mut state = swung.initial_state().expect("a state");
        swung
            .advance_until(&mut state, 2.0.into(), &mut Integrator::new(tolerance.into()), |state| state.b().acceleration.x)
            .expect("a motion");
        let by_stiffness = -std::f64::consts::PI / 4.0 * 4_f64.powf(-1.5);
        assert!(
            (state.t.by[0] - by_stiffness).abs() < 1e-8 + 10.0 * tolerance && state.t.by[1].abs() < 1e-8 + 10.0 * tolerance,
            "{:?}",
            state.t
        );
    }
}
