//! What single forces do, and loads that are computed alone.

use core::f64::consts::FRAC_PI_2;

use reuleaux::nalgebra::{Matrix2, Vector2, Vector3};
use reuleaux::{Integrator, mechanism};

mechanism! {
    /// A door with a closer, a hand and a brake, opened by a motor.
    pub(crate) mechanism Door {
        param stiffness: Stiffness = 500N_m;
        ground { point hinge = (0m, 0m);  point frame = (0m, -200mm); }
        body door {
            point hinge = (0m, 0m);  point arm = (300mm, 0mm);  point edge = (800mm, 0mm);
            mass = 30kg;  center = (400mm, 0mm);  inertia = 1.6kgm2;
        }
        slice joint hinge = revolute(ground.hinge, door.hinge);
        slice drive motor = drive_angle(door, 45deg * sin(90deg_s * t));
        slice force closer = spring_damper(ground.frame, door.arm, stiffness: stiffness, rest: 300mm, damping: 200Ns_m);
        force hand = { on door: -3Nms * door.angular_velocity;  at door.edge: (5N * cos(t * 1rad_s), 2N);  at ground.frame: (1N, 0N); }
    }
}

/// The law of the closer by hand; the powers of its damper and of the hand add up to the power of all forces.
#[test]
fn forces_are_given_by_their_names() {
    let door = Door::<f64> { stiffness: 700.0 };
    for time in [0.2_f64, 1.3, 2.9] {
        let state = door.solve(time).expect("a state");
        let (loads, body) = (door.loads(&state), state.door());
        let (sine, cosine) = body.angle.sin_cos();
        let arm = Vector2::new(0.3 * cosine, 0.3 * sine);
        let way = arm - Vector2::new(0.0, -0.2);
        let velocity = Vector2::new(-arm.y, arm.x) * body.angular_velocity;
        let along = way.normalize();
        let pull = 700.0 * (way.norm() - 0.3) + 200.0 * along.dot(&velocity);
        let pull = along * pull;
        let closer = loads.closer();
        let [on_frame, on_door] = closer.forces;
        assert!((on_door + pull).norm() < 1e-12 * pull.norm() && (on_frame - pull).norm() < 1e-12 * pull.norm(), "{on_door} for {pull}");
        assert!((closer.power + pull.dot(&velocity)).abs() < 1e-12 * pull.norm());
        let hand = loads.hand();
        assert_eq!(hand.torques, [-3.0 * body.angular_velocity]);
        assert_eq!(hand.forces, [Vector2::new(5.0 * time.cos(), 2.0), Vector2::new(1.0, 0.0)]);
        let edge = Vector2::new(-sine, cosine) * (0.8 * body.angular_velocity);
        let wanted = -3.0 * body.angular_velocity.powi(2) + hand.forces[0].dot(&edge);
        assert!((hand.power - wanted).abs() < 1e-12);
        // What the spring of the closer stores is no power.
        let lost = hand.power - 200.0 * along.dot(&velocity).powi(2);
        assert!((door.energy(&state).power - lost).abs() < 1e-12 * closer.power.abs().max(1.0));
    }
}

#[test]
fn a_load_alone_is_the_one_among_all() {
    let door = Door::<f64> { stiffness: 700.0 };
    for time in [0.0, 0.2, 1.3, 2.9] {
        let state = door.solve(time).expect("a state");
        let loads = door.loads(&state);
        assert_eq!(door.load_of_hinge(&state), loads.hinge());
        assert_eq!(door.load_of_motor(&state), loads.motor());
        assert_eq!(door.load_of_closer(&state), loads.closer());
    }
}

mechanism! {
    /// A falling four-bar with slices.
    pub(crate) mechanism Falling {
        param weight: Mass = 0.8kg;
        gravity = (0, -9.81m_s2);
        ground { point A = (0mm, 0mm);  point D = (350mm, 0mm); }
        body crank   { point B = (100mm, 0mm);  mass = weight;  center = (50mm, 0mm);   inertia = 0.002kgm2; }
        body coupler { point C = (300mm, 0mm);  mass = 1.5kg;  center = (150mm, 0mm);  inertia = 0.015kgm2; }
        body rocker  { point C = (250mm, 0mm);  mass = 1.2kg;  center = (125mm, 0mm);  inertia = 0.009kgm2;  start angle = 100deg; }
        slice joint a = revolute(ground.A, crank.position);
        joint b = revolute(crank.B, coupler.position);
        slice joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.position, ground.D);
        slice force bearing = { on crank: -0.02Nms * crank.angular_velocity; }
        freedom swing = crank.angle from 60deg;
    }
}

#[test]
fn a_load_alone_follows_motion_and_parameters() {
    let mut linkage = Falling::<f64>::default();
    let mut state = linkage.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-9);
    for frame in 1..=20 {
        linkage.advance(&mut state, 0.05 * f64::from(frame), &mut integrator).expect("a motion");
        let loads = linkage.loads(&state);
        assert_eq!(linkage.load_of_a(&state), loads.a());
        assert_eq!(linkage.load_of_c(&state), loads.c());
        assert_eq!(linkage.load_of_bearing(&state), loads.bearing());
    }
    linkage.weight = 2.0;
    assert_eq!(linkage.load_of_c(&state), linkage.loads(&state).c());
}

mechanism! {
    /// A parallelogram with a third crank: the loads of the joints on the coupler are not determined.
    pub(crate) mechanism Coupled {
        gravity = (0, -9.81m_s2);
        ground { point A = (0m, 0m);  point B = (2m, 0m);  point C = (1m, 0m); }
        body crank  { point P = (500mm, 0mm);  mass = 1kg; }
        body rod    { point Q = (2m, 0m);  point R = (1m, 0m);  mass = 3kg;  center = (0.7m, 0m); }
        body rocker { point P = (500mm, 0mm);  mass = 1kg; }
        body third  { point P = (500mm, 0mm);  mass = 1kg; }
        slice joint a = revolute(ground.A, crank.position);
        joint b = revolute(ground.B, rocker.position);
        joint c = revolute(crank.P, rod.position);
        joint d = revolute(rod.Q, rocker.P);
        joint e = revolute(ground.C, third.position);
        redundant joint f = revolute(rod.R, third.P);
        slice drive input = drive_angle(crank, 60deg + 10rpm * t);
        slice force push = spring(ground.B, rod.R, stiffness: 5N_m);
    }
}

#[test]
fn a_load_alone_beside_redundant_joints_is_the_one_of_least_norm() {
    let coupled = Coupled::<f64>::default();
    let state = coupled.solve(0.4).expect("a state");
    let loads = coupled.loads(&state);
    assert_eq!(coupled.load_of_a(&state), loads.a());
    assert_eq!(coupled.load_of_input(&state), loads.input());
    assert_eq!(coupled.load_of_push(&state), loads.push());
    assert!(!loads.a().is_unique && loads.input().is_unique);
}

mechanism! {
    /// An arm in space with a torsion spring, a wind and gears, driven at its shoulder.
    pub(crate) mechanism Windy in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { axis z = (0, 0, 1);  point far = (2m, 0m, 0m); }
        body arm  { axis z = (0, 0, 1);  axis y = (0, 1, 0);  point end = (1m, 0m, 0m);  mass = 2kg;  center = (0m, 0m, 0m);  inertia = rod(1m); }
        body fan  { axis y = (0, 1, 0);  point tip = (0m, 0m, 0.2m);  mass = 0.5kg;  inertia = ball(100mm); }
        slice joint shoulder = revolute(ground.position, ground.z, arm.position, arm.z);
        slice joint hub = revolute(arm.end, arm.y, fan.position, fan.y);
        slice joint mesh = gear_pair(shoulder.angle, hub.angle, 3, 1);
        slice drive motor = drive_rotation(shoulder, 1rad_s * t + 0.5rad_s2 * t^2);
        slice force wind = { at fan.tip: (3N, 1N, -2N) * (t / 1s);  on arm: (0Nm, 0Nm, 0.5Nm); }
        slice force rope = damper(ground.far, arm.end, damping: 4Ns_m);
    }
}

#[test]
fn loads_in_space_are_computed_alone() {
    let windy = Windy::<f64>::default();
    for time in [0.1_f64, 0.9] {
        let state = windy.solve(time).expect("a state");
        let loads = windy.loads(&state);
        assert_eq!(windy.load_of_shoulder(&state), loads.shoulder());
        assert_eq!(windy.load_of_hub(&state), loads.hub());
        assert_eq!(windy.load_of_mesh(&state), loads.mesh());
        assert_eq!(windy.load_of_motor(&state), loads.motor());
        assert_eq!(windy.load_of_rope(&state), loads.rope());
        let wind = windy.load_of_wind(&state);
        assert_eq!((wind.forces, wind.torques), ([Vector3::new(3.0, 1.0, -2.0) * time], [Vector3::new(0.0, 0.0, 0.5)]));
        let tip = state.fan().point(Vector3::new(0.0, 0.0, 0.2)).rate;
        let wanted = wind.forces[0].dot(&tip) + 0.5 * state.arm().angular_velocity.z;
        assert!((wind.power - wanted).abs() < 1e-12, "{} for {wanted}", wind.power);
        assert!((windy.energy(&state).power - wind.power - loads.rope().power).abs() < 1e-12);
    }
}

mechanism! {
    /// A block on a rail, between a gas spring and a spring of constant force.
    pub(crate) mechanism Gas {
        param pushed_in: Length = 60mm;
        param exponent: Number = 1;
        param pull: Force = 30N;
        param start: Velocity = 0m_s;
        body block { mass = 2kg; }
        joint rail = translational((1, 0), (0m, 0m), block.position);
        slice force gas = gas_spring((0m, 0m), block.position, force: 200N, length: 300mm, column: 120mm, exponent: exponent);
        slice force tape = constant_force(block.position, (0m, 0m), pull);
        freedom slide = block.x from 300mm - pushed_in at start;
    }
}

mechanism! {
    /// The same force between two balls in space, led by a drive.
    pub(crate) mechanism Strut in space {
        ground { point foot = (0.1m, -0.2m, 0.05m);  axis z = (0, 0, 1); }
        body hatch { axis z = (0, 0, 1); }
        joint upright = absolute_orientation(ground.z, hatch.z);
        joint x = absolute_x(hatch.position, 0.3m);
        joint z = absolute_z(hatch.position, 0.1m);
        drive lift = drive_y(hatch.position, 10mm + 20mm_s * t);
        slice force strut = gas_spring(ground.foot, hatch.position, 350N, 400mm, 210mm, exponent: 1.25);
    }
}

/// The work that it takes to push a gas spring of 200 N and a column of 120 mm in, from its extended length.
fn work_of_gas(pushed_in: f64, exponent: f64) -> f64 {
    let ratio = 0.12 / (0.12 - pushed_in);
    if exponent == 1.0 { 200.0 * 0.12 * ratio.ln() } else { 200.0 * 0.12 * (ratio.powf(exponent - 1.0) - 1.0) / (exponent - 1.0) }
}

/// What a gas spring gives back as speed is the closed form of its work, less what the spring of constant force takes.
#[test]
fn a_gas_spring_gives_back_its_work() {
    for (pushed_in, exponent, pull) in [(0.06, 1.0_f64, 30.0_f64), (0.09, 1.3, 0.0), (0.03, 1.4, -20.0), (0.1, 2.0, 55.0)] {
        let gas = Gas { pushed_in, exponent, pull, start: 0.0 };
        let mut state = gas.initial_state().expect("a state");
        let push: f64 = 200.0 * f64::powf(0.12 / (0.12 - pushed_in), exponent) - pull;
        assert!((state.block().acceleration.x - push / 2.0).abs() < 1e-12 * push.abs());
        let mut integrator = Integrator::new(1e-11);
        for frame in 1..=20 {
            gas.advance(&mut state, 2e-3 * f64::from(frame), &mut integrator).expect("it moves");
            let (x, speed) = (state.block().position.x, state.block().velocity.x);
            let work = work_of_gas(pushed_in, exponent) - work_of_gas(0.3 - x, exponent) - pull * (x - 0.3 + pushed_in);
            assert!((speed.powi(2) - work).abs() < 1e-9 * work.abs().max(1.0), "{speed} m/s and {work} J at {x} m");
        }
    }
}

/// Its force is the same at every length, and its power is that force times the speed.
#[test]
fn a_spring_of_constant_force_pulls_with_one_force() {
    let gas = Gas { pushed_in: 0.0, exponent: 1.0, pull: 30.0, start: 0.0 };
    let state = gas.initial_state().expect("a state");
    let tape = gas.load_of_tape(&state);
    assert_eq!(tape.forces, [Vector2::new(-30.0, 0.0), Vector2::new(30.0, 0.0)]);
    for (pushed_in, start) in [(0.1, 0.7_f64), (-0.2, -1.5)] {
        let gas = Gas { pushed_in, start, ..gas };
        let tape = gas.load_of_tape(&gas.initial_state().expect("a state"));
        assert!((tape.power + 30.0 * start).abs() < 1e-13, "{tape:?}");
    }
}

/// The force is along the line of the points, on both ends, and takes the power that its work has as a rate.
#[test]
fn a_gas_spring_pushes_two_points_of_space_apart() {
    let strut = Strut::default();
    for t in [0.0, 2.5, 9.0] {
        let state = strut.solve(t).expect("a state");
        let load = strut.load_of_strut(&state);
        let line = Vector3::new(0.2, 0.21 + 0.02 * t, 0.05);
        let push = 350.0 * (0.21 / (0.21 - (0.4 - line.norm()))).powf(1.25) * line.normalize();
        let [on_foot, on_hatch] = load.forces;
        assert!((on_hatch - push).norm() < 1e-12 * push.norm() && on_foot == -on_hatch, "{load:?}, not {push}");
        assert!((load.power - 0.02 * push.y).abs() < 1e-12 * push.norm());
        assert!((strut.loads(&state).lift().effort + push.y).abs() < 1e-12 * push.norm());
    }
}

mechanism! {
    /// A block is driven onto a gas spring, and on where there is no room left for the gas.
    pub(crate) mechanism Crushed {
        ground { axis u = (1, 0); }
        body block { mass = 1kg;  inertia = 1kgm2;  start x = 300mm; }
        joint rail = translational(ground.u, ground.position, block.position);
        drive press = drive_x(block.position, 300mm - 100mm_s * t);
        force gas = gas_spring(ground.position, block.position, 100N, 300mm, 150mm);
    }
}

#[test]
fn a_gas_spring_without_room_has_no_force() {
    let crushed = Crushed::default();
    let effort = |t: f64| crushed.loads(&crushed.solve(t).unwrap()).press().effort;
    assert!((effort(1.0) + 300.0).abs() < 1e-11, "{}", effort(1.0));
    assert!(effort(1.6).is_nan(), "{}", effort(1.6));
}

mechanism! {
    /// Two wheels on one axle, with a damper in the bearing of the first and one between both.
    pub(crate) mechanism Bearings {
        body fast { mass = 2kg; inertia = 0.3kgm2; }
        body slow { mass = 1kg; inertia = 0.7kgm2; }
        joint bearing = revolute(ground.position, fast.position);
        joint other = revolute(ground.position, slow.position);
        slice force friction = torsion_damper(ground, fast, 0.05Nms_rad);
        slice force clutch = torsion_damper(fast, slow, damping: 0.2Nms);
        freedom spin = fast.angle from 0 at 20rad_s;
        freedom drag = slow.angle - 30deg from -30deg at -3rad_s;
    }
}

mechanism! {
    /// The same wheels about an oblique axis in space.
    pub(crate) mechanism ObliqueBearings in space {
        ground { axis a = (1, 2, 2); }
        body fast { axis a = (0, 0, 1); mass = 2kg; inertia = (0.2kgm2, 0.2kgm2, 0.3kgm2); }
        body slow { axis a = (0, 0, 1); mass = 1kg; inertia = (0.4kgm2, 0.4kgm2, 0.7kgm2); }
        joint bearing = revolute(ground.position, ground.a, fast.position, fast.a);
        joint other = revolute(ground.position, ground.a, slow.position, slow.a);
        slice force friction = torsion_damper(ground.a, fast.a, 0.05Nms_rad);
        slice force clutch = torsion_damper(fast.a, slow.a, damping: 0.2Nms);
        freedom spin = bearing.angle from 0 at 20rad_s;
        freedom drag = other.angle from 0 at -3rad_s;
    }
}

/// The speeds obey M ω̇ = −C ω, of which the solution is a sum of two exponentials.
#[test]
fn torsion_dampers_slow_wheels_down() {
    let (plane, space) = (Bearings::default(), ObliqueBearings::default());
    let (mut flat, mut oblique) = (plane.initial_state().expect("a state"), space.initial_state().expect("a state"));
    let axis = Vector3::new(1.0, 2.0, 2.0) / 3.0;
    // ω̇ = A ω
    let rates: Matrix2<f64> = Matrix2::new(-0.25 / 0.3, 0.2 / 0.3, 0.2 / 0.7, -0.2 / 0.7);
    let (half, root) = (rates.trace() / 2.0, (rates.trace().powi(2) / 4.0 - rates.determinant()).sqrt());
    let mut integrator = Integrator::new(1e-11);
    let mut integrator_in_space = Integrator::new(1e-11);
    for time in [0.3_f64, 1.0, 2.5] {
        plane.advance(&mut flat, time, &mut integrator).expect("it moves");
        space.advance(&mut oblique, time, &mut integrator_in_space).expect("it moves");
        // exp(A t) = exp(h t) (cosh(r t) + sinh(r t) / r (A − h))
        let growth = Matrix2::identity() * (root * time).cosh() + (rates - Matrix2::identity() * half) * ((root * time).sinh() / root);
        let [fast, slow]: [f64; 2] = (growth * Vector2::new(20.0, -3.0) * (half * time).exp()).into();
        assert!((flat.fast().angular_velocity - fast).abs() < 1e-8 && (flat.slow().angular_velocity - slow).abs() < 1e-8);
        assert!(
            (oblique.fast().angular_velocity - axis * fast).norm() < 1e-8 && (oblique.slow().angular_velocity - axis * slow).norm() < 1e-8
        );
        let (friction, clutch) =
            (-0.05 * flat.fast().angular_velocity, -0.2 * (flat.slow().angular_velocity - flat.fast().angular_velocity));
        assert_eq!(plane.load_of_friction(&flat).torques.map(f64::abs), [friction.abs(); 2]);
        assert_eq!(plane.load_of_clutch(&flat).torques, [clutch, -clutch]);
        assert!((space.load_of_clutch(&oblique).torques[0] - axis * clutch).norm() < 1e-8);
        let lost = -0.05 * fast.powi(2) - 0.2 * (slow - fast).powi(2);
        assert!((plane.energy(&flat).power - lost).abs() < 1e-6 && (space.energy(&oblique).power - lost).abs() < 1e-6);
    }
}

mechanism! {
    /// A wheel in a bearing that turns on a rail, of which the accelerations are no closed form.
    pub(crate) mechanism Ridden {
        ground { axis along = (1, 0); }
        body cart { mass = 1kg; }
        body arm { mass = 1kg; center = (100mm, 0mm); point tip = (300mm, 0mm); }
        body wheel { mass = 1kg; inertia = 0.1kgm2; center = (20mm, 10mm); }
        joint rail = translational(ground.along, ground.position, cart.position);
        joint hinge = revolute(cart.position, arm.position);
        joint bearing = revolute(arm.tip, wheel.position);
        freedom way = cart.x at 1m_s;
        freedom swing = arm.angle at 2rad_s;
        freedom spin = wheel.angle at -1rad_s;
    }
}

/// A step that is no number is no lack of mass; the state stays as it is.
#[test]
fn a_step_that_is_no_number_is_said_to_be_none() {
    let ridden = Ridden::default();
    let mut state = ridden.initial_state().expect("a state");
    let before = state.q;
    for step in [f64::NAN, f64::INFINITY] {
        let said = ridden.step(&mut state, step).expect_err("no motion").to_string();
        assert!(said.ends_with("a number is infinite or not a number"), "{said}");
        assert_eq!(state.q, before);
    }
}

mechanism! {
    /// Two pendulums; the second is braked by the speed of the first, and a spring pulls at the difference.
    mechanism Named {
        gravity = (0, -9.81m_s2);
        body one { mass = 1kg;  center = (0m, -1m);  inertia = 0.1kgm2; }
        body two { mass = 1kg;  center = (0m, -1m);  inertia = 0.1kgm2; }
        joint a = revolute(ground.position, one.position);
        joint b = revolute((3m, 0m), two.position);
        freedom first = one.angle from 0.4rad at 2rad_s;
        freedom second = two.angle - first from 0.3rad;
        force brake = { on two: -0.5Nm / 1rad_s * rate(first) - 3Nm * second / 1rad; }
        output swing = first;
        output between = second;
        output speed = rate(first);
    }
}

/// The names of freedoms are those of their quantities.
#[test]
fn freedoms_are_quantities() {
    let named = Named::default();
    let state = named.initial_state().expect("a state");
    let (one, two) = (state.one(), state.two());
    assert_eq!(named.swing(&state).value, one.angle);
    assert_eq!(named.between(&state).value, two.angle - one.angle);
    assert_eq!(named.speed(&state).value, 2.0);
    // (m c² + I) φ̈ = −m g c sin φ + M
    let inertia = 1.1;
    let torque = -0.5 * 2.0 - 3.0 * 0.3;
    assert!((inertia * one.angular_acceleration + 9.81 * one.angle.sin()).abs() < 1e-13);
    assert!((inertia * two.angular_acceleration + 9.81 * two.angle.sin() - torque).abs() < 1e-13);
}

mechanism! {
    /// Springs of all kinds between ground and a body, with a damper, and a force with the potential of its constant part.
    mechanism Stored {
        body b { point P = (0.3m, 0.1m);  mass = 2kg;  inertia = 0.1kgm2;  start position = (1m, 0.5m);  start angle = 20deg; }
        freedom x = b.x at 0.4m_s;
        freedom y = b.y at -0.7m_s;
        freedom turn = b.angle at 3rad_s;
        force one = spring(ground.position, b.P, stiffness: 40N_m, rest: 0.2m);
        force two = spring_damper((0m, 2m), b.P, stiffness: 30N_m, rest: 0.5m, damping: 4Ns_m);
        force three = torsion_spring(ground, b, stiffness: 5Nm_rad, rest: 10deg);
        force four = torsion_spring_damper(ground, b, stiffness: 6Nm_rad, rest: -20deg, damping: 0.5Nms_rad);
        force tape = constant_force((3m, 0m), b.P, 7N);
        force own = { potential: 3N * b.y;  at b.position: (0, -3N) - 2Ns_m * rate(b.position); }
        output far = norm(b.P);
        output near = norm(b.P - (0m, 2m));
        output wound = norm(b.P - (3m, 0m));
    }
}

mechanism! {
    /// Springs about a hinge in space, whose bracket turns.
    mechanism Wound in space {
        body bracket { axis y = (0, 1, 0);  axis z = (0, 0, 1); }
        body arm { axis z = (0, 0, 1);  point P = (0.4m, 0m, 0m);  mass = 2kg;  inertia = (0.1kgm2, 0.2kgm2, 0.3kgm2); }
        joint turntable = revolute(ground.position, (0, 1, 0), bracket.position, bracket.y);
        joint hinge = revolute(bracket.position, bracket.z, arm.position, arm.z);
        drive motor = drive_rotation(turntable, 2rad_s * t);
        freedom swing = hinge.angle from 7rad at 3rad_s;
        force spiral = torsion_spring(hinge.a, hinge.b, stiffness: 5Nm_rad, rest: 90deg);
        force damped = torsion_spring_damper(hinge.a, hinge.b, stiffness: 6Nm_rad, rest: 0deg, damping: 0.5Nms_rad);
        force strut = spring((1m, 0m, 0m), arm.P, stiffness: 40N_m, rest: 0.2m);
        output length = norm(arm.P - (1m, 0m, 0m));
        output turned = swing;
    }
}

/// ½ k (l − l₀)² and the like are potentials; what dampers take is power.
#[test]
fn springs_store_energy() {
    let stored = Stored::default();
    let mut state = stored.initial_state().expect("a state");
    for step in 1..=20 {
        stored.advance(&mut state, 0.1 * f64::from(step), &mut Integrator::new(1e-9)).expect("a motion");
        let (b, of) = (state.b(), |k: f64, x: f64| 0.5 * k * x * x);
        let [far, near, wound] = [stored.far(&state), stored.near(&state), stored.wound(&state)];
        let springs = of(40.0, far.value - 0.2) + of(30.0, near.value - 0.5);
        let torsion = of(5.0, b.angle - 10_f64.to_radians()) + of(6.0, b.angle + 20_f64.to_radians());
        let potential = springs + torsion + 7.0 * wound.value + 3.0 * b.position.y;
        let lost = 4.0 * near.rate * near.rate + 0.5 * b.angular_velocity.powi(2) + 2.0 * b.velocity.norm_squared();
        let found = stored.energy(&state);
        assert!((found.potential - potential).abs() < 1e-14 * potential.abs().max(10.0), "{} for {potential}", found.potential);
        assert!((found.power + lost).abs() < 1e-13 * lost.max(100.0), "{} for {lost}", found.power);
        // Forces keep their power.
        let loads = stored.loads(&state);
        assert!((loads.one().power + 40.0 * (far.value - 0.2) * far.rate).abs() < 1e-12);
    }
}

/// An angle of seven rad is no other than that.
#[test]
fn springs_about_a_hinge_in_space_store_energy() {
    let wound = Wound::default();
    let mut state = wound.initial_state().expect("a state");
    for step in 1..=20 {
        let (found, turned, length) = (wound.energy(&state), wound.turned(&state), wound.length(&state).value);
        let spirals = 2.5 * (turned.value - FRAC_PI_2).powi(2) + 3.0 * turned.value.powi(2);
        let potential = spirals + 20.0 * (length - 0.2).powi(2);
        assert!((found.potential - potential).abs() < 1e-14 * potential, "{} for {potential}", found.potential);
        let lost = 0.5 * turned.rate * turned.rate;
        assert!((found.power + lost).abs() < 1e-14 * potential * turned.rate.abs().max(1.0), "{} for {lost}", found.power);
        wound.advance(&mut state, 0.05 * f64::from(step), &mut Integrator::new(1e-9)).expect("a motion");
    }
}
