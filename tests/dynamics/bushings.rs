//! Bushings: by hand where their bodies are held, and what is kept where they fly.

use reuleaux::nalgebra::{Matrix3, Rotation3, Vector2, Vector3};
use reuleaux::{Differentiable, Integrator, mechanism};

mechanism! {
    /// Two plates that fly, with a bushing far from their origins, which also rub and strike each other.
    pub(crate) mechanism Plates {
        param damping: Mass / Time = 0;
        param twisting: Torque / AngularVelocity = 0;
        param normal: Force = 0N;
        body one {
            point P = (300mm, 100mm);  axis u = (3, 1);
            mass = 2kg;  inertia = 0.05kgm2;
        }
        body two {
            point Q = (-200mm, 50mm);
            mass = 1.5kg;  inertia = 0.03kgm2;  start position = (600mm, 200mm);  start angle = 30deg;
        }
        slice force bush = bushing(
            one.P, one.u, two.Q, stiffness_x: 800N_m, stiffness_y: 300N_m, torsion: 5Nm_rad,
            damping_x: damping, damping_y: 2 * damping, torsion_damping: twisting, rest: 20deg,
        );
        slice force pad = friction(one.P, one.u, two.Q, normal, 0.3, transition: 50mm_s);
        slice force buffer = stop_along(one.P, one.u, two.Q, 20mm, force: 40N, depth: 10mm);
        freedom x_one = one.x at 0.3m_s;
        freedom y_one = one.y at -0.2m_s;
        freedom turn_one = one.angle from 10deg at 2rad_s;
        freedom x_two = two.x at 0.5m_s;
        freedom y_two = two.y at 1m_s;
        freedom turn_two = two.angle at -3rad_s;
    }
}

mechanism! {
    /// The same of two stones in space.
    pub(crate) mechanism Stones in space {
        param damping: Mass / Time = 0;
        param twisting: Torque / AngularVelocity = 0;
        param normal: Force = 0N;
        body one {
            point P = (300mm, 100mm, -50mm);  axis a = (3, 1, 2) from (0, 0, 1);
            mass = 2kg;  inertia = (0.05kgm2, 0.06kgm2, 0.07kgm2);
        }
        body two {
            point Q = (-200mm, 50mm, 20mm);  axis b = (1, -2, 1) from (1, 0, 0);
            mass = 1.5kg;  inertia = (0.03kgm2, 0.05kgm2, 0.04kgm2);
            start position = (600mm, 200mm, 100mm);  start orientation = turn((2, -1, 1), 70deg);
        }
        slice force bush = bushing(
            one.P, one.a, two.Q, two.b, stiffness_x: 800N_m, stiffness_y: 300N_m, stiffness_z: 500N_m,
            torsion_x: 5Nm_rad, torsion_y: 2Nm_rad, torsion_z: 8Nm_rad, damping_x: damping, damping_z: 2 * damping,
            torsion_damping_x: twisting, torsion_damping_z: 3 * twisting,
        );
        slice force pad = friction(one.P, one.a, two.Q, normal, 0.3, transition: 50mm_s);
        slice force buffer = stop_along(one.P, one.a, two.Q, 20mm, force: 40N, depth: 10mm);
        freedom fly_one = rate(one.position) from (0.3m_s, -0.2m_s, 0.1m_s);
        freedom spin_one = one.angular_velocity from (1rad_s, 2rad_s, -1rad_s);
        freedom fly_two = rate(two.position) from (0.5m_s, 1m_s, -0.4m_s);
        freedom spin_two = two.angular_velocity from (-2rad_s, 1rad_s, 3rad_s);
    }
}

/// Momentum, and angular momentum about the origin of ground.
fn momenta_of_plates(state: &PlatesState) -> Vector3<f64> {
    let bodies = [(state.one().position, state.one().velocity, 2.0), (state.two().position, state.two().velocity, 1.5)];
    let momentum: Vector2<f64> = bodies.iter().map(|(_, velocity, mass)| velocity * *mass).sum();
    let orbital: f64 = bodies.iter().map(|(place, velocity, mass)| mass * place.perp(velocity)).sum();
    Vector3::new(momentum.x, momentum.y, orbital + 0.05 * state.one().angular_velocity + 0.03 * state.two().angular_velocity)
}

fn momenta_of_stones(state: &StonesState) -> [Vector3<f64>; 2] {
    let spin = |rotation: Matrix3<f64>, moments: [f64; 3], turning: Vector3<f64>| {
        rotation * Matrix3::from_diagonal(&Vector3::from(moments)) * rotation.transpose() * turning
    };
    let (one, two) = (state.one(), state.two());
    let orbital = one.position.cross(&one.velocity) * 2.0 + two.position.cross(&two.velocity) * 1.5;
    let spins = spin(one.rotation, [0.05, 0.06, 0.07], one.angular_velocity) + spin(two.rotation, [0.03, 0.05, 0.04], two.angular_velocity);
    [one.velocity * 2.0 + two.velocity * 1.5, orbital + spins]
}

/// The offset of the plates and its rate along the axes of the first one.
fn offset_of_plates(state: &PlatesState) -> [Vector2<f64>; 2] {
    let (p, q) = (state.one().point(Vector2::new(0.3, 0.1)), state.two().point(Vector2::new(-0.2, 0.05)));
    let (along, d) = (state.one().vector(Vector2::new(3.0, 1.0).normalize()).value, q.value - p.value);
    let across = Vector2::new(-along.y, along.x);
    let relative = q.rate - p.rate - Vector2::new(-d.y, d.x) * state.one().angular_velocity;
    [Vector2::new(along.dot(&d), across.dot(&d)), Vector2::new(along.dot(&relative), across.dot(&relative))]
}

/// Energy, momentum and angular momentum stay, although the offset of the bushing is large and the stop acts far from both centres of mass.
#[test]
fn plates_on_a_bushing_keep_energy_and_momenta() {
    let plates = Plates::default();
    let mut state = plates.initial_state().expect("a state");
    let (energy, momenta) = (plates.energy(&state), momenta_of_plates(&state));
    let mut integrator = Integrator::new(1e-12);
    let (mut farthest, mut pressed) = (0.0_f64, 0.0_f64);
    for frame in 1..=60 {
        plates.advance(&mut state, 0.05 * f64::from(frame), &mut integrator).expect("they fly");
        let now = plates.energy(&state);
        let change = now.kinetic + now.potential - energy.kinetic - energy.potential;
        assert!(change.abs() < 2e-8 && now.power.abs() < 1e-11, "{change:e} J, {:e} W after {} s", now.power, state.t);
        assert!((momenta_of_plates(&state) - momenta).norm() < 1e-9);
        let [d, _] = offset_of_plates(&state);
        // What is stored, by hand.
        let angle = state.two().angle - state.one().angle - 20_f64.to_radians();
        let stop = 40.0 * 0.01 / 2.5 * ((0.02 - d.x).max(0.0) / 0.01).powf(2.5);
        let stored = 400.0 * d.x.powi(2) + 150.0 * d.y.powi(2) + 2.5 * angle.powi(2) + stop;
        assert!((now.potential - stored).abs() < 1e-12 * stored.max(1.0), "{} J, not {stored}", now.potential);
        (farthest, pressed) = (farthest.max(d.norm()), pressed.max(0.02 - d.x));
    }
    assert!(farthest > 0.05 && pressed > 0.01, "{farthest} m, {pressed} m");
}

/// Dampers and friction take energy by their law, and neither momentum nor angular momentum.
#[test]
fn dampers_and_friction_between_plates_take_energy_alone() {
    let plates = Plates { damping: 4.0, twisting: 0.02, normal: 10.0 };
    let mut state = plates.initial_state().expect("a state");
    let momenta = momenta_of_plates(&state);
    let mut integrator = Integrator::new(1e-11);
    for frame in 1..=20 {
        plates.advance(&mut state, 0.05 * f64::from(frame), &mut integrator).expect("they fly");
        assert!((momenta_of_plates(&state) - momenta).norm() < 1e-9);
        let [_, rate] = offset_of_plates(&state);
        let turning = state.two().angular_velocity - state.one().angular_velocity;
        let friction = 0.3 * 10.0 * rate.x.powi(2) / rate.x.hypot(0.05);
        let lost = 4.0 * rate.x.powi(2) + 8.0 * rate.y.powi(2) + 0.02 * turning.powi(2) + friction;
        assert!((plates.energy(&state).power + lost).abs() < 1e-11 * lost.max(1.0), "{} W, not −{lost}", plates.energy(&state).power);
        assert!((plates.load_of_pad(&state).power + friction).abs() < 1e-12);
    }
}

/// x, y and z of an axis and its `from`.
fn triad(axis: [f64; 3], from: [f64; 3]) -> Matrix3<f64> {
    let (z, from) = (Vector3::from(axis).normalize(), Vector3::from(from));
    let x = (from - z * z.dot(&from)).normalize();
    Matrix3::from_columns(&[x, z.cross(&x), z])
}

/// The offset of the stones and its rate, and their rotation, along the axes of the first one.
fn offset_of_stones(state: &StonesState) -> ([Vector3<f64>; 2], Vector3<f64>) {
    let (one, two) = (state.one(), state.two());
    let (p, q) = (one.point(Vector3::new(0.3, 0.1, -0.05)), two.point(Vector3::new(-0.2, 0.05, 0.02)));
    let (axes, others) = (one.rotation * triad([3.0, 1.0, 2.0], [0.0, 0.0, 1.0]), two.rotation * triad([1.0, -2.0, 1.0], [1.0, 0.0, 0.0]));
    let d = q.value - p.value;
    let relative = q.rate - p.rate - one.angular_velocity.cross(&d);
    ([axes.tr_mul(&d), axes.tr_mul(&relative)], Rotation3::from_matrix_unchecked(axes.tr_mul(&others)).scaled_axis())
}

/// The same in space, where the bodies turn against each other by large angles about no common axis.
#[test]
fn stones_on_a_bushing_keep_energy_and_momenta() {
    let stones = Stones::default();
    let mut state = stones.initial_state().expect("a state");
    let (energy, momenta) = (stones.energy(&state), momenta_of_stones(&state));
    let mut integrator = Integrator::new(1e-12);
    let (mut widest, mut pressed) = (0.0_f64, 0.0_f64);
    for frame in 1..=60 {
        stones.advance(&mut state, 0.01 * f64::from(frame), &mut integrator).expect("they fly");
        let ([d, _], turned) = offset_of_stones(&state);
        assert!(turned.norm() < 3.0, "{} rad", turned.norm());
        let now = stones.energy(&state);
        let change = now.kinetic + now.potential - energy.kinetic - energy.potential;
        assert!(change.abs() < 1e-9 && now.power.abs() < 1e-10, "{change:e} J, {:e} W after {} s", now.power, state.t);
        for (kept, first) in momenta_of_stones(&state).iter().zip(&momenta) {
            assert!((kept - first).norm() < 1e-9);
        }
        let square = |stiffness: [f64; 3], way: &Vector3<f64>| 0.5 * Vector3::from(stiffness).dot(&way.component_mul(way));
        let stop = 40.0 * 0.01 / 2.5 * ((0.02 - d.z).max(0.0) / 0.01).powf(2.5);
        let stored = square([800.0, 300.0, 500.0], &d) + square([5.0, 2.0, 8.0], &turned) + stop;
        assert!((now.potential - stored).abs() < 1e-11 * stored.max(1.0), "{} J, not {stored}", now.potential);
        (widest, pressed) = (widest.max(turned.norm()), pressed.max(0.02 - d.z));
    }
    assert!(widest > 1.5 && pressed > 0.01, "{widest} rad, {pressed} m");
}

#[test]
fn dampers_and_friction_between_stones_take_energy_alone() {
    let stones = Stones { damping: 4.0, twisting: 0.02, normal: 10.0 };
    let mut state = stones.initial_state().expect("a state");
    let momenta = momenta_of_stones(&state);
    let mut integrator = Integrator::new(1e-11);
    for frame in 1..=10 {
        stones.advance(&mut state, 0.05 * f64::from(frame), &mut integrator).expect("they fly");
        for (kept, first) in momenta_of_stones(&state).iter().zip(&momenta) {
            assert!((kept - first).norm() < 1e-9);
        }
        let ([_, rate], _) = offset_of_stones(&state);
        let axes = state.one().rotation * triad([3.0, 1.0, 2.0], [0.0, 0.0, 1.0]);
        let turning = axes.tr_mul(&(state.two().angular_velocity - state.one().angular_velocity));
        let friction = 0.3 * 10.0 * rate.z.powi(2) / rate.z.hypot(0.05);
        let squares = |way: &Vector3<f64>| way.component_mul(way);
        let lost = Vector3::new(4.0, 4.0, 8.0).dot(&squares(&rate)) + Vector3::new(0.02, 0.02, 0.06).dot(&squares(&turning)) + friction;
        assert!((stones.energy(&state).power + lost).abs() < 1e-10 * lost.max(1.0), "{} W, not −{lost}", stones.energy(&state).power);
    }
}

mechanism! {
    /// A shaft that is turned in a bush about one axis of it, and yields in no other way.
    pub(crate) mechanism Twisted in space {
        ground { point P = (100mm, -50mm, 20mm);  axis a = (1, 2, 2) from (1, 0, 0); }
        body shaft { axis a = (0, 0, 1);  point Q = (0m, 0m, 80mm); }
        joint bearing = revolute(ground.position, ground.a, shaft.position, shaft.a);
        drive motor = drive_rotation(bearing, 1rad_s * t);
        slice force along = bushing(
            ground.P, ground.a, shaft.Q, shaft.a, stiffness_x: 70N_m, stiffness_z: 50N_m, torsion_x: 3Nm_rad, torsion_z: 5Nm_rad,
        );
    }
}

/// About one of its axes a bushing is a torsion spring, up to half a turn, and from angles so small that their squares are rounding.
#[test]
fn a_bushing_turned_about_one_axis_is_a_torsion_spring() {
    let twisted = Twisted::default();
    let axes = triad([1.0, 2.0, 2.0], [1.0, 0.0, 0.0]);
    for angle in [-3.1, -1.0, -0.021, -0.019, -1e-3, -1e-9, 0.0, 1e-12, 1e-5, 0.0199, 0.02, 0.0201, 0.3, 2.0, 3.1] {
        let load = twisted.load_of_along(&twisted.solve(angle).expect("a state"));
        let wanted = axes.column(2) * (-5.0 * angle);
        assert!((load.torques[0] - wanted).norm() < 1e-14 + 1e-12 * f64::abs(angle), "{} N m at {angle} rad", load.torques[0]);
        // The points stay apart: on both bodies the force acts at one place.
        let d = axes.column(2) * 0.08 - Vector3::new(0.1, -0.05, 0.02);
        let pull = axes * Vector3::new(70.0, 70.0, 50.0).component_mul(&axes.tr_mul(&d));
        assert!((load.forces[0] + pull).norm() < 1e-13 * pull.norm() && load.forces[1] == -load.forces[0]);
        assert!((load.torques[1] + load.torques[0] - d.cross(&pull)).norm() < 1e-13);
    }
}

/// Close to half a turn the axis of the rotation loses digits as its distance from it becomes small, and the angle loses none.
#[test]
fn a_bushing_close_to_half_a_turn_keeps_its_digits() {
    let twisted = Twisted::default();
    let axis = triad([1.0, 2.0, 2.0], [1.0, 0.0, 0.0]).column(2).into_owned();
    for left in [1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10] {
        for sense in [1.0, -1.0] {
            let angle = sense * (core::f64::consts::PI - left);
            let torque = twisted.load_of_along(&twisted.solve(angle).expect("a state")).torques[0];
            assert!((torque.dot(&axis) + 5.0 * angle).abs() < 1e-13 + (1e-15 / left).powi(2), "{torque} N m at {angle} rad");
            assert!((torque + axis * (5.0 * angle)).norm() < 1e-13 + 1e-14 / left, "{torque} N m at {angle} rad");
        }
    }
}

mechanism! {
    /// A wheel that swings on a bush.
    pub(crate) mechanism Swinging in space {
        param torsion: Torque / Angle = 5Nm_rad;
        ground { axis a = (1, 2, 2) from (1, 0, 0); }
        body wheel { axis a = (0, 0, 1);  mass = 1kg;  inertia = (0.2kgm2, 0.2kgm2, 0.2kgm2); }
        joint bearing = revolute(ground.position, ground.a, wheel.position, wheel.a);
        force bush = bushing(
            ground.position, ground.a, wheel.position, wheel.a, 1N_m, stiffness_z: 1N_m, torsion_x: 1Nm_rad, torsion_z: torsion,
        );
        freedom swing = bearing.angle from 0 at 10rad_s;
        output angle = bearing.angle;
    }
}

/// θ = θ̇₀ sin(ωt) / ω with ω² = torsion / I, and its derivative by the torsion, from a bush that is not twisted on, where its law is 0/0.
#[test]
fn a_wheel_on_a_bushing_swings_with_its_derivatives() {
    let swinging = Swinging::default().with_derivatives(|swinging| [&mut swinging.torsion]);
    let mut state = swinging.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-11.into());
    for time in [1e-3, 0.1, 0.3, 0.62832, 1.0] {
        swinging.advance(&mut state, time.into(), &mut integrator).expect("it swings");
        let found = swinging.angle(&state).value;
        let (sine, cosine) = (5.0 * time).sin_cos();
        let by_omega = 10.0 * (time * cosine / 5.0 - sine / 25.0);
        // ∂ω/∂torsion = 1 / (2 I ω)
        let wanted = [2.0 * sine, by_omega / (2.0 * 0.2 * 5.0)];
        assert!((found.value - wanted[0]).abs() < 1e-8 && (found.by[0] - wanted[1]).abs() < 1e-7, "{found:?}, not {wanted:?}");
    }
}
