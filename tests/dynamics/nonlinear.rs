//! Springs whose force is a law of length or angle: a formula, a table, a Rust function.

use reuleaux::nalgebra::{Vector2, Vector3};
use reuleaux::{Integrator, Real, mechanism};

/// The force (N) of a spring that stiffens, over its length (m), with two derivatives.
pub(crate) fn stiffening<T: Real>(length: T) -> (T, T, T) {
    let s = length - T::of(0.25);
    let (linear, cubic) = (T::of(400.0), T::of(9000.0));
    (linear * s + cubic * s * s * s, linear + T::of(3.0) * cubic * s * s, T::of(6.0) * cubic * s)
}

mechanism! {
    /// Two blocks on a rail, with springs of one law that is written in two ways.
    pub(crate) mechanism Blocks {
        function written(l: Length) -> Force = 400N_m * (l - 250mm) + 9000N * ((l - 250mm) / 1m)^3;
        function called(Length) -> Force = stiffening;
        body one { mass = 2kg; }
        body two { mass = 3kg;  start x = 400mm; }
        joint rail = translational((1, 0), (0m, 0m), one.position);
        joint other = translational((1, 0), (0m, 0m), two.position);
        slice force formula = nonlinear_spring(one.position, two.position, written);
        slice force code = nonlinear_spring(one.position, two.position, law: called);
        freedom x = one.x from 0 at 0.5m_s;
        freedom y = two.x from 400mm;
    }
}

/// Momentum, and the energy 400 s²/2 + 9000 s⁴/4 of each spring, by hand, s = l − 250 mm; the work of the springs is in the power.
#[test]
fn springs_by_a_law_keep_energy_and_momentum() {
    let blocks = Blocks::default();
    let mut state = blocks.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-11);
    let kept = |state: &BlocksState| {
        let [(x, v), (y, w)] = [state.one(), state.two()].map(|block| (block.position.x, block.velocity.x));
        let s = y - x - 0.25;
        [v * v + 1.5 * w * w + 2.0 * (200.0 * s * s + 2250.0 * s.powi(4)), 2.0 * v + 3.0 * w]
    };
    let start = kept(&state);
    let mut shortest = f64::INFINITY;
    for frame in 1..=50 {
        blocks.advance(&mut state, 0.02 * f64::from(frame), &mut integrator).expect("they move");
        let now = kept(&state);
        assert!((now[0] - start[0]).abs() < 1e-8 && (now[1] - start[1]).abs() < 1e-10, "{now:?} after {} s, first {start:?}", state.t);
        let (formula, code) = (blocks.load_of_formula(&state), blocks.load_of_code(&state));
        let s = state.two().position.x - state.one().position.x - 0.25;
        assert!((formula.forces[0].x - 400.0 * s - 9000.0 * s.powi(3)).abs() < 1e-11, "{formula:?} at {s} m");
        assert!((formula.forces[0] - code.forces[0]).norm() < 1e-11 && code.forces[1] == -code.forces[0]);
        let speed = state.two().velocity.x - state.one().velocity.x;
        assert!((blocks.energy(&state).power + 2.0 * formula.forces[0].x * speed).abs() < 1e-10);
        shortest = shortest.min(s);
    }
    assert!(shortest < -0.1, "{shortest} m");
}

mechanism! {
    /// A gas spring whose pressures were measured, between ground and a hatch that is led past them.
    pub(crate) mechanism Measured in space {
        param area: Area = 2cm2;
        function gas(l: Length) -> Force = -area * table(l, [(180mm, 61bar), (220mm, 45bar), (260mm, 36bar), (300mm, 30bar)], linear);
        ground { point foot = (0m, 0m, 40mm);  axis z = (0, 0, 1); }
        body hatch { axis z = (0, 0, 1); }
        joint upright = absolute_orientation(ground.z, hatch.z);
        joint x = absolute_x(hatch.position, 0m);
        joint z = absolute_z(hatch.position, 40mm);
        drive lift = drive_y(hatch.position, 180mm + 40mm_s * t);
        slice force strut = nonlinear_spring(ground.foot, hatch.position, gas);
    }
}

/// The force is area times pressure, pushes, and its power is that of the drive.
#[test]
fn a_gas_spring_by_a_table_pushes_by_its_pressures() {
    for area in [2e-4, 5e-4] {
        let measured = Measured { area };
        for (t, bar) in [(0.0, 61.0), (1.0, 45.0), (2.0, 36.0), (3.0, 30.0)] {
            let state = measured.solve(t).expect("a state");
            let load = measured.load_of_strut(&state);
            let push = Vector3::new(0.0, area * bar * 1e5, 0.0);
            assert!((load.forces[1] - push).norm() < 1e-11 * push.norm() && load.forces[0] == -load.forces[1], "{load:?}, not {push}");
            assert!((load.power - 0.04 * push.y).abs() < 1e-11 * push.norm());
        }
    }
}

mechanism! {
    /// A wheel on a rubber hinge, whose torque is a sine of its angle, and one that strikes stops.
    pub(crate) mechanism Rubber {
        function sine(angle: Angle) -> Torque = 4Nm * sin(angle);
        function play(angle: Angle) -> Torque = 300Nm_rad * (max(angle - 2deg, 0) + min(angle + 2deg, 0));
        body carrier { mass = 1kg;  inertia = 0.5kgm2; }
        body wheel { mass = 1kg;  inertia = 0.2kgm2; }
        body dog { mass = 1kg;  inertia = 0.1kgm2; }
        joint one = revolute(ground.position, carrier.position);
        joint two = revolute(ground.position, wheel.position);
        joint three = revolute(ground.position, dog.position);
        slice force rubber = nonlinear_torsion_spring(carrier, wheel, sine);
        slice force coupling = nonlinear_torsion_spring(ground, dog, law: play);
        freedom a = carrier.angle from 0.2rad at 1rad_s;
        freedom b = wheel.angle from 2rad at -3rad_s;
        freedom c = dog.angle from 0 at 2rad_s;
    }
}

mechanism! {
    /// The same about an oblique axis in space.
    pub(crate) mechanism ObliqueRubber in space {
        function sine(angle: Angle) -> Torque = 4Nm * sin(angle);
        ground { axis a = (1, 2, 2); }
        body carrier { axis a = (0, 0, 1);  mass = 1kg;  inertia = (0.4kgm2, 0.4kgm2, 0.5kgm2); }
        body wheel { axis a = (0, 0, 1);  mass = 1kg;  inertia = (0.2kgm2, 0.2kgm2, 0.2kgm2); }
        joint one = revolute(ground.position, ground.a, carrier.position, carrier.a);
        joint two = revolute(ground.position, ground.a, wheel.position, wheel.a);
        slice force rubber = nonlinear_torsion_spring(carrier.a, wheel.a, sine);
        freedom a = one.angle from 0.2rad at 1rad_s;
        freedom b = two.angle from 2rad at -3rad_s;
    }
}

/// Energy with 4 N m (1 − cos φ), and angular momentum; a body with play swings between 2° and the angle of its energy, with a closed period.
#[test]
fn torsion_springs_by_a_law_keep_energy_and_angular_momentum() {
    let (plane, space) = (Rubber::default(), ObliqueRubber::default());
    let (mut flat, mut oblique) = (plane.initial_state().expect("a state"), space.initial_state().expect("a state"));
    let (mut integrator, mut second) = (Integrator::new(1e-11), Integrator::new(1e-11));
    let kept = |state: &RubberState| {
        let (carrier, wheel) = (state.carrier(), state.wheel());
        let kinetic = 0.25 * carrier.angular_velocity.powi(2) + 0.1 * wheel.angular_velocity.powi(2);
        let stored = 4.0 * (1.0 - (wheel.angle - carrier.angle).cos());
        Vector2::new(kinetic + stored, 0.5 * carrier.angular_velocity + 0.2 * wheel.angular_velocity)
    };
    let start = kept(&flat);
    for frame in 1..=20 {
        let time = 0.1 * f64::from(frame);
        plane.advance(&mut flat, time, &mut integrator).expect("they turn");
        space.advance(&mut oblique, time, &mut second).expect("they turn");
        assert!((kept(&flat) - start).norm() < 1e-8, "{} after {time} s, first {start}", kept(&flat));
        let axis = Vector3::new(1.0, 2.0, 2.0) / 3.0;
        assert!((oblique.wheel().angular_velocity - axis * flat.wheel().angular_velocity).norm() < 1e-7);
        let torque = -4.0 * (flat.wheel().angle - flat.carrier().angle).sin();
        assert!((plane.load_of_rubber(&flat).torques[0] - torque).abs() < 1e-12);
        assert!((space.load_of_rubber(&oblique).torques[0] - axis * torque).norm() < 1e-6);
    }
}

/// A body with play goes through it at its speed, and turns back in half a period of the spring behind it.
#[test]
fn play_in_a_coupling_lengthens_the_period() {
    let rubber = Rubber::default();
    let mut state = rubber.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-11);
    rubber.advance_until(&mut state, 1.0, &mut integrator, |state| state.dog().angle).expect("it comes back");
    let wanted = 2.0 * 2_f64.to_radians() / 2.0 + core::f64::consts::PI * (0.1_f64 / 300.0).sqrt();
    assert!((state.t - wanted).abs() < 1e-9, "{} s, not {wanted}", state.t);
    assert!((state.dog().angular_velocity + 2.0).abs() < 1e-8);
}

mechanism! {
    /// Two ends of a travel, led past both: a rope and a buffer.
    pub(crate) mechanism Travel {
        function rope(l: Length) -> Force = if l > 2m { 40kN_m * (l - 2m) } else { 0 };
        function buffer(l: Length) -> Force = -2kN * (max(80mm - l, 0) / 10mm)^3;
        body block { mass = 1kg;  start x = 40mm; }
        joint rail = translational((1, 0), (0m, 0m), block.position);
        drive pull = drive_x(block.position, 50mm + 1m_s * t);
        slice force line = nonlinear_spring((0m, 0m), block.position, rope);
        slice force rubber = nonlinear_spring((0m, 0m), block.position, buffer);
    }
}

#[test]
fn a_rope_pulls_and_a_buffer_pushes_at_its_end_alone() {
    let travel = Travel::default();
    for (x, pull, push) in [(0.05, 0.0, 54e3), (0.07, 0.0, 2e3), (0.5, 0.0, 0.0), (1.9, 0.0, 0.0), (2.1, 4e3, 0.0)] {
        let state = travel.solve(x - 0.05).expect("a state");
        let (line, rubber) = (travel.load_of_line(&state), travel.load_of_rubber(&state));
        assert!((line.forces[1].x + pull).abs() < 1e-9 && (rubber.forces[1].x - push).abs() < 1e-8, "{line:?}, {rubber:?} at {x} m");
    }
}
