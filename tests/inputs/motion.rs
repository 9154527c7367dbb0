//! States with inputs are those of laws of time with the same values, rates and accelerations.

use reuleaux::{Cause, Mechanism as _, Motion, mechanism};

mechanism! {
    /// A crank-rocker whose crank is measured.
    pub mechanism Measured {
        input theta: Angle = 40deg;
        param crank_length: Length = 100mm;
        ground { point O = (0mm, 0mm);  point C = (400mm, 0mm); }
        body crank   { point A = (crank_length, 0mm);  mass = 0.5kg;  center = (50mm, 0mm);  inertia = 0.001kgm2; }
        body coupler { point B = (350mm, 0mm);  point P = (175mm, 80mm);  mass = 1kg;  center = (150mm, 20mm);  inertia = 0.01kgm2; }
        body rocker  { point B = (300mm, 0mm);  mass = 0.8kg;  center = (150mm, 0mm);  inertia = 0.008kgm2;  start angle = 70deg; }
        joint o = revolute(ground.O, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive motor = drive_angle(crank, theta);
        output tip = coupler.P;
        output error = crank.angle - theta;
        output lead = rocker.angle + theta * theta;
    }
}

mechanism! {
    /// The same with a law of time.
    pub mechanism Driven {
        param crank_length: Length = 100mm;
        ground { point O = (0mm, 0mm);  point C = (400mm, 0mm); }
        body crank   { point A = (crank_length, 0mm);  mass = 0.5kg;  center = (50mm, 0mm);  inertia = 0.001kgm2; }
        body coupler { point B = (350mm, 0mm);  point P = (175mm, 80mm);  mass = 1kg;  center = (150mm, 20mm);  inertia = 0.01kgm2; }
        body rocker  { point B = (300mm, 0mm);  mass = 0.8kg;  center = (150mm, 0mm);  inertia = 0.008kgm2;  start angle = 70deg; }
        joint o = revolute(ground.O, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive motor = drive_angle(crank, 40deg + 5rad_s * t + 0.4rad * sin(t * 7rad_s));
        output tip = coupler.P;
    }
}

/// The law of [`Driven`].
fn law(t: f64) -> Motion<f64> {
    let (sine, cosine) = (7.0 * t).sin_cos();
    Motion::new(40f64.to_radians() + 5.0 * t + 0.4 * sine, 5.0 + 2.8 * cosine, -19.6 * sine)
}

#[test]
fn a_loop_with_inputs_follows_the_law_that_they_are_taken_from() {
    let (measured, driven) = (Measured::default(), Driven::default());
    let mut state = measured.solve(0.0, MeasuredInputs { theta: law(0.0) }).unwrap();
    let mut expected = driven.solve(0.0).unwrap();
    for step in 1..=3000 {
        let t = 1e-3 * f64::from(step);
        measured.advance(&mut state, t, MeasuredInputs { theta: law(t) }).unwrap();
        driven.advance(&mut expected, t).unwrap();
        for (found, expected, size) in [(&state.q, &expected.q, 20.0), (&state.qd, &expected.qd, 50.0), (&state.qdd, &expected.qdd, 500.0)]
        {
            assert!((found - expected).amax() < 1e-13 * size, "{t}: {}", (found - expected).amax());
        }
        assert_eq!(state.1, MeasuredInputs { theta: law(t) });
    }
}

#[test]
fn a_single_step_reaches_the_state_of_advance_or_changes_nothing() {
    let measured = Measured::default();
    let start = measured.solve(0.0, MeasuredInputs { theta: law(0.0) }).unwrap();
    let (mut once, mut expected) = (start.clone(), start.clone());
    for step in 1..=300 {
        let t = 2e-3 * f64::from(step);
        let inputs = MeasuredInputs { theta: law(t) };
        assert!(measured.advance_once(&mut once, t, inputs), "{t}");
        measured.advance(&mut expected, t, inputs).unwrap();
        assert_eq!(once, expected);
    }
    // A third of a turn at once is no warm step, and an angle that is no number has no state.
    for theta in [Motion::at(start.crank().angle + 2.1), Motion::at(f64::NAN)] {
        let mut same = start.clone();
        assert!(!measured.advance_once(&mut same, 2e-3, MeasuredInputs { theta }));
        assert_eq!(same, start);
    }
}

#[test]
fn a_single_step_by_laws_of_time_is_that_of_advance() {
    use reuleaux::Mechanism;
    let driven = Driven::default();
    let start = driven.solve(0.0).unwrap();
    let (mut once, mut expected) = (start.clone(), start.clone());
    for step in 1..=300 {
        let t = 2e-3 * f64::from(step);
        assert!(driven.advance_once(&mut once.0, t));
        driven.advance(&mut expected, t).unwrap();
        assert_eq!(once, expected);
    }
    let mut same = start.clone();
    assert!(!driven.advance_once(&mut same.0, 0.5) && !driven.advance_once(&mut same.0, f64::INFINITY));
    assert_eq!(same, start);
}

#[test]
fn loads_read_the_inputs_of_the_state() {
    let (measured, driven) = (Measured::default(), Driven::default());
    let t = 0.73;
    let state = measured.solve(t, MeasuredInputs { theta: law(t) }).unwrap();
    let expected = driven.loads(&driven.solve(t).unwrap());
    let loads = measured.loads(&state);
    assert!((loads.motor().effort - expected.motor().effort).abs() < 1e-12 * expected.motor().effort.abs());
    assert!((loads.motor().power - loads.motor().effort * law(t).rate).abs() < 1e-12 * loads.motor().power.abs());
    assert!((loads.c().force - expected.c().force).norm() < 1e-12 * expected.c().force.norm());
}

#[test]
fn outputs_read_the_inputs_of_the_state() {
    let mechanism = Measured::default();
    let theta = Motion::new(1.1, 3.0, -7.0);
    let state = mechanism.solve(0.0, MeasuredInputs { theta }).unwrap();
    let (error, lead, rocker) = (mechanism.error(&state), mechanism.lead(&state), state.rocker());
    assert!(error.value.abs() < 1e-15 && error.rate.abs() < 1e-14 && error.acceleration.abs() < 1e-13);
    let square = [1.1 * 1.1, 2.0 * 1.1 * 3.0, 2.0 * (3.0 * 3.0 - 1.1 * 7.0)];
    let found = [lead.value - rocker.angle, lead.rate - rocker.angular_velocity, lead.acceleration - rocker.angular_acceleration];
    assert!(found.iter().zip(square).all(|(found, expected)| (found - expected).abs() < 1e-12), "{found:?}");
    // The mechanism itself knows nothing of them until it is told.
    assert_eq!(mechanism.inputs.theta, Motion::at(40f64.to_radians()));
    assert!(mechanism.with_inputs_of(&state).phi(&state.q, 0.0).amax() < 1e-15);
    assert!(mechanism.phi(&state.q, 0.0).amax() > 0.1);
}

#[test]
fn derivatives_by_time_of_any_function_of_inputs_follow_the_chain_rule() {
    mechanism! {
        pub mechanism Functions {
            input theta: Angle;
            input reach: Length = 100mm in 50mm..=150mm;
            param gain: Number = 2;
            body arm   { axis u = (1, 0); }
            body slide { start x = 100mm; }
            body other { }
            joint axle = revolute(ground.position, arm.position);
            joint guide = translational(arm.u, arm.position, slide.position);
            joint second = revolute(ground.position, other.position);
            drive turn = { arm.angle == gain * theta + 10deg + 0.3rad * sin(t * 2rad_s); }
            drive push = drive_distance(arm.position, slide.position, reach);
            drive third = { other.angle == theta * reach / 100mm; }
        }
    }
    let mechanism = Functions { gain: 3.0, ..Default::default() };
    let inputs = FunctionsInputs { theta: Motion::new(0.4, 1.5, -2.0), reach: Motion::new(0.12, 0.05, 0.3) };
    let (t, state) = (0.8, mechanism.solve(0.8, inputs).unwrap());
    let (sine, cosine) = (2.0f64 * t).sin_cos();
    let arm = [3.0 * 0.4 + 10f64.to_radians() + 0.3 * sine, 4.5 + 0.6 * cosine, -6.0 - 1.2 * sine];
    let found = [state.arm().angle, state.arm().angular_velocity, state.arm().angular_acceleration];
    assert!(found.iter().zip(arm).all(|(found, expected)| (found - expected).abs() < 1e-14), "{found:?} {arm:?}");
    // In polar coordinates: a = (r̈ − r φ̇²) e_r + (r φ̈ + 2 ṙ φ̇) e_φ.
    let (sine, cosine) = arm[0].sin_cos();
    let [along, across] = [0.3 - 0.12 * arm[1] * arm[1], 0.12 * arm[2] + 2.0 * 0.05 * arm[1]];
    let slide = state.slide();
    assert!((slide.position.x - 0.12 * cosine).abs() < 1e-15 && (slide.velocity.y - (0.05 * sine + 0.12 * cosine * arm[1])).abs() < 1e-14);
    assert!((slide.acceleration.x - (along * cosine - across * sine)).abs() < 1e-13);
    let other = state.other();
    assert!((other.angular_acceleration - (-2.0 * 0.12 + 2.0 * 1.5 * 0.05 + 0.4 * 0.3) / 0.1).abs() < 1e-13);

    let outside = FunctionsInputs { reach: Motion::at(0.2), ..inputs };
    let refused = mechanism.solve_from(t, &state, outside).unwrap_err().to_string();
    assert_eq!(refused, "`Functions` cannot be solved with `reach` = 0.2 m: it must lie in 50 mm ..= 150 mm");
}

#[test]
fn derivatives_are_at_the_inputs_of_the_state_or_refused() {
    mechanism! {
        pub mechanism Pointer {
            input theta: Angle;
            param gain: Number = 2;
            param reach: Length = 300mm;
            body arm { point P = (reach, 0mm); }
            joint axle = revolute(ground.position, arm.position);
            drive turn = { arm.angle == gain * theta; }
            output tip = arm.P;
        }
    }
    let mechanism = Pointer::default();
    let (theta, rate) = (0.4, 1.5);
    let state = mechanism.solve(0.0, PointerInputs { theta: Motion::new(theta, rate, -2.0) }).unwrap();
    let (varied, there) = mechanism.with_inputs_of(&state).derivatives(&state, |m| [&mut m.gain]).unwrap();
    let tip = varied.tip(&PointerState(there, varied.inputs));
    // x = r cos gθ, ẋ = −r g θ̇ sin gθ
    let (sine, cosine) = (2.0f64 * theta).sin_cos();
    assert!((tip.value.x.by[0] + 0.3 * theta * sine).abs() < 1e-16);
    assert!((tip.rate.x.by[0] + 0.3 * rate * (sine + 2.0 * theta * cosine)).abs() < 4e-16);

    let others = [Motion::new(0.5, rate, -2.0), Motion::new(theta, 0.0, -2.0), Motion::new(theta, rate, 0.0)];
    for other in others {
        let mut told = mechanism.with_inputs_of(&state);
        told.inputs.theta = other;
        let failure = told.derivatives(&state, |m| [&mut m.gain]).expect_err("these are other inputs");
        assert_eq!(failure.cause, Cause::OtherInputs, "{other:?}");
    }
    let mut varied = varied;
    varied.inputs.theta.rate = 0.0.into();
    let failure = mechanism.with_inputs_of(&state).derivatives_along(&state, &varied).expect_err("these are other inputs");
    assert_eq!(failure.cause, Cause::OtherInputs);
    let sentence = "`Pointer` has other inputs or parameters than those with which this state at t = 0 s was solved: write \
                    `mechanism.with_inputs_of(&state)` instead of `mechanism`";
    assert_eq!(failure.to_string(), sentence);
}

#[test]
fn error_bounds_are_at_the_rates_of_inputs() {
    let measured = Measured::default();
    let theta = Motion::new(1.1, 3.0, -7.0);
    let state = measured.solve(0.0, MeasuredInputs { theta }).unwrap();
    let there = measured.with_inputs_of(&state);
    let bound = there.error_bound(&state).unwrap();
    assert!(bound.q.amax() < 1e-15 && bound.qd.amax() < 1e-14 && bound.qdd.amax() < 1e-13, "{bound:?}");
    assert_eq!(there.certify(&state).unwrap().within, bound);
    let mut polished = state.0.clone();
    there.polish(&mut polished).unwrap();
    assert!((polished.qd - state.qd).amax() < 1e-14 && (polished.qdd - state.qdd).amax() < 1e-13);

    // The same motion as a law of time has the same bounds to rounding of its angle.
    let driven = Driven::default();
    let state = driven.solve(0.73).unwrap();
    let told = Measured { inputs: MeasuredInputs { theta: law(0.73) }, ..measured };
    let bound = told.error_bound(&state.0).unwrap();
    assert!(bound.qd.amax() < 1e-14 && bound.qdd.amax() < 1e-13, "{bound:?}");
    // With another rate or acceleration of the input the crank is off by as much.
    let state = measured.solve(0.0, MeasuredInputs { theta }).unwrap();
    let bound = |theta| Measured { inputs: MeasuredInputs { theta }, ..measured }.error_bound(&state).unwrap();
    let [faster, harder] = [Motion::new(1.1, 2.0, -7.0), Motion::new(1.1, 3.0, -6.0)].map(bound);
    assert!(faster.qd.iter().any(|entry| (entry - 1.0).abs() < 1e-14), "{faster:?}");
    assert!(harder.qd.amax() < 1e-14 && harder.qdd.iter().any(|entry| (entry - 1.0).abs() < 1e-13), "{harder:?}");
}
