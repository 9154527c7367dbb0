//! Velocities in outputs in space.

use reuleaux::mechanism;
use reuleaux::nalgebra::Vector3;

use crate::near;

type Outcome = Result<(), Box<dyn std::error::Error>>;

mechanism! {
    /// A crank turns a slide that runs across its plane, by a rod with a ball at one end and a universal joint at the other.
    mechanism AcrossCrank in space {
        param torque: Torque = 4Nm;
        ground { point O = (0mm, 100mm, 120mm);  axis x = (1, 0, 0) from (0, 1, 0); }
        body crank { point O = (0mm, 0mm, 0mm);  axis x = (1, 0, 0) from (0, 1, 0);  point A = (0mm, 0mm, 80mm); }
        body rod   { point A = (0mm, 0mm, 0mm);  point B = (300mm, 0mm, 0mm);  axis y = (0, 1, 0);  start position = (0mm, 100mm, 200mm); }
        body slide { point B = (0mm, 0mm, 0mm);  axis x = (1, 0, 0);  axis z = (0, 0, 1);  start position = (200mm, 0mm, 0mm); }
        joint axle = revolute(ground.O, ground.x, crank.O, crank.x);
        joint ball = spherical(crank.A, rod.A);
        joint fork = universal(rod.B, rod.y, slide.B, slide.z);
        joint rail = translational(ground.position, ground.x, slide.B, slide.x);
        drive turn = drive_rotation(axle, 0.2rad + 3rad_s * t + 1rad_s2 * t * t);

        output stroke = slide.position.x;
        output middle = 0.5 * (rod.A + rod.B);
        slice output advantage = rate(slide.position.x) / rate(axle.angle);
        output spin = rod.angular_velocity;
        slice output spin_alone = rod.angular_velocity;
        output swing = rate(0.5 * (rod.A + rod.B));
        output power = torque * dot(ground.x, crank.angular_velocity);
        output across = cross(rod.angular_velocity, rod.B - rod.A);
    }
}

#[track_caller]
fn all_near(found: Vector3<f64>, expected: Vector3<f64>, tolerance: f64) {
    for axis in 0..3 {
        near(found[axis], expected[axis], tolerance);
    }
}

#[test]
fn angular_velocities_are_those_of_the_state() -> Outcome {
    let mechanism = AcrossCrank::default();
    let times = || (0..20).map(|step| 0.1 * f64::from(step));
    let slices = mechanism.solve_for_spin_alone();
    for (state, alone) in mechanism.sweep(times()).zip(slices.sweep(times())) {
        let (state, alone) = (state?, alone?.output());
        let (spin, rod) = (mechanism.spin(&state), state.rod());
        all_near(spin.value, rod.angular_velocity, 1e-13);
        all_near(spin.rate, rod.angular_acceleration, 1e-12);
        all_near(alone.value, rod.angular_velocity, 1e-13);
        all_near(alone.rate, rod.angular_acceleration, 1e-12);
        // ω × (r_B − r_A), and ω̇ × d + ω × (ω × d)
        let arm = rod.vector(Vector3::new(0.3, 0.0, 0.0));
        let across = mechanism.across(&state);
        all_near(across.value, arm.rate, 1e-13);
        all_near(across.rate, arm.acceleration, 1e-12);
    }
    Ok(())
}

#[test]
fn ratios_and_powers_are_those_of_the_drive() -> Outcome {
    let mechanism = AcrossCrank::default();
    let times = || (0..20).map(|step| 0.1 * f64::from(step));
    let slices = mechanism.solve_for_advantage();
    for (state, alone) in mechanism.sweep(times()).zip(slices.sweep(times())) {
        let (state, alone) = (state?, alone?.output());
        let (speed, acceleration) = (3.0 + 2.0 * state.t, 2.0);
        let stroke = mechanism.stroke(&state);
        let value = stroke.rate / speed;
        let rate = (stroke.acceleration - value * acceleration) / speed;
        for found in [mechanism.advantage(&state), alone] {
            near(found.value, value, 1e-13);
            near(found.rate, rate, 1e-12);
        }
        let power = mechanism.power(&state);
        near(power.value, 4.0 * speed, 1e-13);
        near(power.rate, 4.0 * acceleration, 1e-12);
        let (middle, swing) = (mechanism.middle(&state), mechanism.swing(&state));
        all_near(swing.value, middle.rate, 1e-14);
        all_near(swing.rate, middle.acceleration, 1e-13);
    }
    Ok(())
}

mechanism! {
    /// A top whose orientation is a quaternion.
    mechanism Top in space {
        body top { point P = (0m, 0m, 1m);  mass = 2kg;  center = (0m, 0m, 0m);  inertia = (1kgm2, 2kgm2, 2.5kgm2); }
        joint tip = spherical(ground.position, top.position);
        freedom spin = top.angular_velocity from (0.3rad_s, 0.2rad_s, 5rad_s);
        output omega = top.angular_velocity;
        output speed = rate(top.P);
    }
}

#[test]
fn velocities_of_a_free_body_follow_from_eulers_equations() -> Outcome {
    let top = Top::default();
    let state = top.initial_state()?;
    let omega = top.omega(&state);
    all_near(omega.value, Vector3::new(0.3, 0.2, 5.0), 1e-14);
    // J ω̇ = −ω × J ω, with the axes of ground at the start.
    let (j, w) = (Vector3::new(1.0, 2.0, 2.5), omega.value);
    let moment = -w.cross(&j.component_mul(&w));
    all_near(omega.rate, moment.component_div(&j), 1e-13);
    let speed = top.speed(&state);
    let arm = Vector3::z();
    all_near(speed.value, w.cross(&arm), 1e-14);
    all_near(speed.rate, omega.rate.cross(&arm) + w.cross(&w.cross(&arm)), 1e-13);
    Ok(())
}
