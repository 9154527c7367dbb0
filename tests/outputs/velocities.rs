//! Velocities in outputs in the plane, against closed forms.

use reuleaux::{Mechanism, Motion, ValueAndRate, mechanism};

use crate::near;

type Outcome = Result<(), Box<dyn std::error::Error>>;

mechanism! {
    /// A crank-rocker whose crank gains speed.
    mechanism CrankRocker {
        param torque: Torque = 3Nm;
        param mass: Mass = 2kg;
        param gain: AngularAcceleration = 2rad_s2;
        ground { point O = (0mm, 0mm);  point C = (400mm, 0mm); }
        body crank   { point O = (0mm, 0mm);  point A = (100mm, 0mm); }
        body coupler { point A = (0mm, 0mm);  point B = (350mm, 0mm);  point P = (175mm, 80mm);  axis e = (0, 1); }
        body rocker  { point C = (0mm, 0mm);  point B = (300mm, 0mm);  start angle = 70deg; }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive input = drive_angle(crank, 0.3rad + 3rad_s * t + 0.5 * gain * t * t);

        let swing = rate(rocker.angle);
        slice output ratio = swing / rate(crank.angle);
        output tip = coupler.P;
        output way = rate(coupler.P);
        slice output course = rate(coupler.P);
        output power = torque * crank.angular_velocity;
        output energy = 0.5 * mass * dot(rate(coupler.P), rate(coupler.P));
        output along = dot(coupler.e, rate(coupler.P - crank.A));
        output profile = rate(table(crank.angle, [(-1rad, 0mm), (1rad, 10mm), (3rad, 5mm), (5rad, 30mm), (9rad, 10mm)]));
        output lift = table(crank.angle, [(-1rad, 0mm), (1rad, 10mm), (3rad, 5mm), (5rad, 30mm), (9rad, 10mm)]);
        output faster = max(abs(rocker.angular_velocity), coupler.angular_velocity);
    }
}

/// ω₄/ω₂ = a sin(θ₃ − θ₂)/(c sin(θ₃ − θ₄)), and its derivative along the motion.
fn ratio(state: &CrankRockerState) -> ValueAndRate<f64> {
    let (two, three, four) = (state.crank(), state.coupler(), state.rocker());
    let (above, below) = (0.1 * (three.angle - two.angle).sin(), 0.3 * (three.angle - four.angle).sin());
    let above_rate = 0.1 * (three.angle - two.angle).cos() * (three.angular_velocity - two.angular_velocity);
    let below_rate = 0.3 * (three.angle - four.angle).cos() * (three.angular_velocity - four.angular_velocity);
    let value = above / below;
    ValueAndRate { value, rate: (above_rate - value * below_rate) / below }
}

#[test]
fn the_ratio_of_a_four_bar_is_that_of_its_sines() -> Outcome {
    let mechanism = CrankRocker::default();
    for state in mechanism.sweep((0..40).map(|step| 0.05 * f64::from(step))) {
        let state = state?;
        let (found, expected) = (mechanism.ratio(&state), ratio(&state));
        near(found.value, expected.value, 1e-13);
        near(found.rate, expected.rate, 1e-12);
    }
    Ok(())
}

#[test]
fn a_slice_gives_the_same() -> Outcome {
    let mechanism = CrankRocker::default();
    let (ratios, courses) = (mechanism.solve_for_ratio(), mechanism.solve_for_course());
    let times = || (0..40).map(|step| 0.05 * f64::from(step));
    for ((whole, ratio), course) in mechanism.sweep(times()).zip(ratios.sweep(times())).zip(courses.sweep(times())) {
        let (whole, ratio, course) = (whole?, ratio?.output(), course?.output());
        let expected = mechanism.ratio(&whole);
        near(ratio.value, expected.value, 1e-13);
        near(ratio.rate, expected.rate, 1e-12);
        let expected = mechanism.course(&whole);
        for axis in 0..2 {
            near(course.value[axis], expected.value[axis], 1e-13);
            near(course.rate[axis], expected.rate[axis], 1e-12);
        }
    }
    Ok(())
}

#[test]
fn a_slice_of_a_velocity_solves_only_what_is_upstream() {
    assert!(CrankRockerForRatio::<f64>::PLAN.stages.len() < CrankRocker::<f64>::PLAN.stages.len());
}

#[test]
fn rates_of_points_are_their_velocities() -> Outcome {
    let mechanism = CrankRocker { torque: 5.0, mass: 0.7, ..Default::default() };
    for state in mechanism.sweep([0.0, 0.31, 0.7, 1.9]) {
        let state = state?;
        let Motion { rate, acceleration, .. } = mechanism.tip(&state);
        let way = mechanism.way(&state);
        assert_eq!((way.value, way.rate), (rate, acceleration));
        // P = τ ω, Ṗ = τ ω̇
        let power = mechanism.power(&state);
        near(power.value, 5.0 * (3.0 + 2.0 * state.t), 1e-14);
        near(power.rate, 5.0 * 2.0, 1e-14);
        // T = m v²/2, Ṫ = m v · a
        let energy = mechanism.energy(&state);
        near(energy.value, 0.35 * rate.dot(&rate), 1e-14);
        near(energy.rate, 0.7 * rate.dot(&acceleration), 1e-14);
        // e · (B s φ̇) = s_x φ̇ for s = (175 mm, 80 mm) and e = (0, 1)
        let along = mechanism.along(&state);
        near(along.value, 0.175 * state.coupler().angular_velocity, 1e-13);
        near(along.rate, 0.175 * state.coupler().angular_acceleration, 1e-12);
        let (profile, lift) = (mechanism.profile(&state), mechanism.lift(&state));
        assert_eq!((profile.value, profile.rate), (lift.rate, lift.acceleration));
        let (rocker, coupler) = (state.rocker(), state.coupler());
        let faster = mechanism.faster(&state);
        let of_rocker = rocker.angular_velocity.abs() >= coupler.angular_velocity;
        let sign = rocker.angular_velocity.signum();
        let expected = if of_rocker { sign * rocker.angular_acceleration } else { coupler.angular_acceleration };
        assert_eq!(faster.value, rocker.angular_velocity.abs().max(coupler.angular_velocity));
        assert_eq!(faster.rate, expected);
    }
    Ok(())
}

#[test]
fn ratios_have_derivatives_by_parameters() -> Outcome {
    let mechanism = CrankRocker::default();
    let state = mechanism.solve(0.4)?;
    let (varied, varied_state) = mechanism.derivatives(&state, |mechanism| [&mut mechanism.gain])?;
    let by = varied.power(&CrankRockerState(varied_state)).value.by[0];
    near(by, 3.0 * 0.4, 1e-13);
    Ok(())
}

mechanism! {
    /// A pendulum: its accelerations follow from forces.
    mechanism Pendulum {
        gravity = (0m_s2, -9.81m_s2);
        body bob { point P = (2m, 0m);  mass = 3kg;  center = (2m, 0m);  inertia = 0kgm2; }
        joint pivot = revolute(ground.position, bob.position);
        freedom swing = bob.angle from 0.2rad at 0.5rad_s;
        output momentum = 3kg * 4 * 1m^2 * bob.angular_velocity;
        output fall = rate(bob.P.y);
    }
}

#[test]
fn rates_of_velocities_follow_from_forces() -> Outcome {
    let pendulum = Pendulum::default();
    let state = pendulum.initial_state()?;
    let momentum = pendulum.momentum(&state);
    near(momentum.value, 12.0 * 0.5, 1e-13);
    near(momentum.rate, -3.0 * 9.81 * 2.0 * 0.2_f64.cos(), 1e-13);
    let fall = pendulum.fall(&state);
    near(fall.value, 2.0 * 0.5 * 0.2_f64.cos(), 1e-13);
    let angular = -9.81 / 2.0 * 0.2_f64.cos();
    near(fall.rate, 2.0 * (angular * 0.2_f64.cos() - 0.25 * 0.2_f64.sin()), 1e-13);
    Ok(())
}

mechanism! {
    /// A disk on a floor, whose angle is integrated from its velocity.
    #[integrated]
    mechanism Disk {
        body disk { point rim = (0m, 0.5m);  start position = (0m, 0.5m); }
        joint height = { disk.y == 0.5m; }
        joint rolling = { rate(disk.x) * (1 + disk.x / 1m) + 0.5m * disk.angular_velocity / 1rad == 0m_s; }
        drive pull = { rate(disk.x) == 2m_s * (1 + t / 1s); }
        output spin = disk.angular_velocity;
    }
}

#[test]
fn rates_of_velocities_of_integrated_mechanisms_follow_from_rows() -> Outcome {
    let disk = Disk::default();
    let state = disk.initial_state()?;
    // ω = −2 ẋ (1 + x),  ω̇ = −2 ẍ (1 + x) − 2 ẋ²
    let spin = disk.spin(&state);
    near(spin.value, -4.0, 1e-14);
    near(spin.rate, -4.0 - 8.0, 1e-14);
    Ok(())
}

mechanism! {
    /// A wheel at an input's angle.
    mechanism Wheel {
        input theta: Angle;
        param torque: Torque = 2Nm;
        body wheel { }
        joint axle = revolute(ground.position, wheel.position);
        drive command = drive_angle(wheel, 2 * theta);
        output power = torque * wheel.angular_velocity;
        output commanded = torque * rate(theta);
    }
}

#[test]
fn inputs_have_rates() -> Outcome {
    let wheel = Wheel::default();
    let state = wheel.solve(0.0, WheelInputs { theta: Motion::new(0.3, 0.7, -0.4) })?;
    assert_eq!(wheel.commanded(&state), ValueAndRate { value: 2.0 * 0.7, rate: -2.0 * 0.4 });
    assert_eq!(wheel.power(&state), ValueAndRate { value: 4.0 * 0.7, rate: -4.0 * 0.4 });
    Ok(())
}

mechanism! {
    /// Gears in a row, as parts and as an array: their outputs are computed by one routine.
    mechanism Gears {
        param speed: AngularVelocity = 3rad_s;
        component Gear(teeth: Number) {
            body wheel { point P = (0.1m, 0m); }
            joint axle = revolute(ground.position, wheel.position);
            output turning = wheel.angular_velocity / speed;
            drive motor = drive_angle(wheel, teeth * speed * t);
        }
        for i in 0..6 {
            part gear[i] = Gear(i + 1);
            slice output slip[i] = rate(gear[i].wheel.P);
        }
    }
}

#[test]
fn arrays_of_velocities_are_arrays() -> Outcome {
    let gears = Gears::default();
    let (state, slice) = (gears.solve(0.2)?, gears.solve_for_slip().solve(0.2)?);
    let (turning, slip, alone): ([ValueAndRate<f64>; 6], _, _) = (gears.gear_turning(&state), gears.slip(&state), slice.output());
    for (i, (turning, (slip, alone))) in turning.into_iter().zip(slip.into_iter().zip(alone)).enumerate() {
        let speed = 3.0 * (i + 1) as f64;
        near(turning.value, speed / 3.0, 1e-14);
        near(turning.rate, 0.0, 1e-14);
        let angle = 0.2 * speed;
        for velocity in [slip, alone] {
            near(velocity.value[0], -0.1 * speed * angle.sin(), 1e-14);
            near(velocity.rate[1], -0.1 * speed * speed * angle.sin(), 1e-14);
        }
    }
    Ok(())
}
