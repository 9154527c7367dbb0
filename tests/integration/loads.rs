//! Loads of driven mechanisms in the plane: reactions, torques and powers against reference numbers.

use reuleaux::{PlanarLoad, mechanism};
use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::reference::{Value, file, list, number, text};

mechanism! {
    /// `dynamics/driven_four_bar.json`.
    pub(crate) mechanism DrivenFourBar {
        gravity = (0, -9.81m_s2);
        ground { point A = (0m, 0m);  point D = (0.35m, 0m); }
        body crank   { point A = (0m, 0m);  point B = (0.1m, 0m);  mass = 0.8kg;  inertia = 0.002kgm2;  center = (0.05m, 0m); }
        body coupler { point B = (0m, 0m);  point C = (0.3m, 0m);  mass = 1.5kg;  inertia = 0.015kgm2;  center = (0.16m, 0.05m);  start angle = 0.759rad; }
        body rocker  { point D = (-0.125m, 0m);  point C = (0.125m, 0m);  mass = 1.2kg;  inertia = 0.009kgm2;  start angle = 1.73rad; }
        joint a = revolute(ground.A, crank.A);
        joint b = revolute(crank.B, coupler.B);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.D, ground.D);
        drive motor = drive_relative_angle(ground, crank, (0.4 + 12 * (t / 1s) + 0.05 * sin((24 * (t / 1s) + 0.3) * 1rad)) * 1rad);
    }
}

mechanism! {
    /// `dynamics/slider_crank_engine.json`.
    pub(crate) mechanism Engine {
        gravity = (0, -9.81m_s2);
        let w = 75rad_s * t;
        ground { point O = (0m, 0m);  axis bore = (1, 0); }
        body crank  { point O = (0m, 0m);  point A = (0.05m, 0m);  mass = 2.5kg;  inertia = 0.004kgm2;  center = (-0.008m, 0.001m); }
        body rod    { point A = (-0.05m, 0m);  point B = (0.12000000000000001m, 0m);  mass = 0.55kg;  inertia = 0.0021kgm2;  start angle = -0.0585rad; }
        body piston { point B = (0m, 0m);  mass = 0.4kg;  inertia = 0.0003kgm2;  center = (0.01m, 0m); }
        joint main = revolute(ground.O, crank.O);
        joint big = revolute(crank.A, rod.A);
        joint small = revolute(rod.B, piston.B);
        joint cylinder = translational(ground.bore, ground.O, piston.B);
        drive turn = drive_relative_angle(ground, crank, 0.2rad + 150rad_s * t);
        force gas = {
            at piston.B: (
                (-900 - 1500 * sin(w + 1.2rad) - 700 * sin(2 * w + 0.9rad) + 300 * sin(3 * w + 0.2rad)) * 1N,
                0N
            );
        }
    }
}

/// Errors of reactions relative to the largest entry of the multipliers.
fn reaction(found: PlanarLoad<f64>, wanted: &Value, sign: f64, size: f64) -> f64 {
    assert!(found.is_unique);
    let [x, y] = [0, 1].map(|k| Decimal::parse(text(&wanted["force"][k])));
    let torque = Decimal::parse(text(&wanted["torque"]));
    [x.error_of(sign * found.force.x), y.error_of(sign * found.force.y), torque.error_of(sign * found.torque)]
        .into_iter()
        .fold(0.0, f64::max)
        / size
}

fn largest(state: &Value) -> f64 {
    list(&state["lambda"]).iter().map(|entry| Decimal::parse(text(entry)).value.abs()).fold(0.0, f64::max)
}

#[test]
fn a_driven_four_bar_has_its_reference_reactions_torque_and_power() {
    let reference = file("dynamics/driven_four_bar.json");
    let mechanism = DrivenFourBar::default();
    let times: Vec<f64> = list(&reference["states"]).iter().map(|state| number(&state["t"])).collect();
    for (state, wanted) in mechanism.sweep(times).zip(list(&reference["states"])) {
        let loads = mechanism.loads(&state.expect("a state"));
        let size = largest(wanted);
        // The load of the last joint is stated on the rocker in the file, and here too: ground does not move.
        let errors = [loads.a(), loads.b(), loads.c(), loads.d()]
            .into_iter()
            .zip(list(&wanted["reactions"]))
            .map(|(found, wanted)| reaction(found, wanted, 1.0, size));
        let worst = errors.fold(0.0, f64::max);
        let drive = loads.motor();
        let torque = Decimal::parse(text(&wanted["driver_forces"][0])).error_of(drive.effort) / size;
        let power = Decimal::parse(text(&wanted["power_drivers"])).error_of(drive.power) / (12.0 * size);
        assert!(worst < 1e-12 && torque < 1e-12 && power < 1e-12, "{worst:e} {torque:e} {power:e}");
    }
}

#[test]
fn an_engine_has_its_reference_reactions_torque_and_power() {
    let reference = file("dynamics/slider_crank_engine.json");
    let mechanism = Engine::default();
    let times: Vec<f64> = list(&reference["states"]).iter().map(|state| number(&state["t"])).collect();
    for (state, wanted) in mechanism.sweep(times).zip(list(&reference["states"])) {
        let loads = mechanism.loads(&state.expect("a state"));
        let size = largest(wanted);
        let errors = [loads.main(), loads.big(), loads.small(), loads.cylinder()]
            .into_iter()
            .zip(list(&wanted["reactions"]))
            .map(|(found, wanted)| reaction(found, wanted, 1.0, size));
        let worst = errors.fold(0.0, f64::max);
        let drive = loads.turn();
        let torque = Decimal::parse(text(&wanted["driver_forces"][0])).error_of(drive.effort) / size;
        let power = Decimal::parse(text(&wanted["power_drivers"])).error_of(drive.power) / (150.0 * size);
        assert!(worst < 1e-12 && torque < 1e-12 && power < 1e-12, "{worst:e} {torque:e} {power:e}");
    }
}

mechanism! {
    /// A mass on a spring and a damper, moved along its line.
    pub(crate) mechanism Shaken {
        param stiffness: Stiffness = 2000N_m;
        ground { point P = (0m, 0m);  axis line = (1, 0); }
        body block { point Q = (0m, 0m);  mass = 3kg; }
        joint rail = translational(ground.line, ground.P, block.Q);
        drive shake = drive_x(block.Q, 200mm + 20mm * sin(10rad_s * t));
        force support = spring_damper(ground.P, block.Q, stiffness, rest: 150mm, damping: 40Ns_m);
    }
}

#[test]
fn a_drive_carries_inertia_spring_and_damper() {
    let shaken = Shaken::default();
    for step in 0..50 {
        let t = f64::from(step) * 0.0137;
        let loads = shaken.loads(&shaken.solve(t).expect("a state"));
        let (sine, cosine) = (10.0 * t).sin_cos();
        let [x, v, a] = [0.2 + 0.02 * sine, 0.2 * cosine, -2.0 * sine];
        let wanted = 3.0 * a + 2000.0 * (x - 0.15) + 40.0 * v;
        assert!((loads.shake().effort - wanted).abs() < 1e-12 * 200.0, "{} {wanted}", loads.shake().effort);
        assert!((loads.shake().power - wanted * v).abs() < 1e-12 * 40.0);
    }
}

#[test]
fn drives_forces_and_energies_are_in_balance() {
    let (four_bar, shaken) = (DrivenFourBar::default(), Shaken::default());
    // d/dt of kinetic and potential energy, by central differences of seventh order.
    let rate = |energy: &dyn Fn(f64) -> f64, t: f64| {
        let h = 1e-3;
        let pair = |k: f64| energy(t + k * h) - energy(t - k * h);
        (672.0 * pair(1.0) - 168.0 * pair(2.0) + 32.0 * pair(3.0) - 3.0 * pair(4.0)) / (840.0 * h)
    };
    let of_four_bar = |t: f64| four_bar.energy(&four_bar.solve(t).expect("a state"));
    let of_shaken = |t: f64| shaken.energy(&shaken.solve(t).expect("a state"));
    for step in 1..20 {
        let t = 0.031 * f64::from(step);
        let state = four_bar.solve(t).expect("a state");
        let wanted = rate(&|t| of_four_bar(t).kinetic + of_four_bar(t).potential, t);
        let found = four_bar.loads(&state).motor().power;
        assert!((found - wanted).abs() < 1e-8 * found.abs().max(10.0) && of_four_bar(t).power == 0.0, "{found} {wanted}");
        let wanted = rate(&|t| of_shaken(t).kinetic + of_shaken(t).potential, t);
        let found = shaken.loads(&shaken.solve(t).expect("a state")).shake().power + of_shaken(t).power;
        assert!((found - wanted).abs() < 1e-9 * 40.0, "{found} {wanted}");
    }
}

mechanism! {
    /// Two loads that are lifted by cylinders: their distances from ground follow laws.
    mechanism Lifts {
        param start: Length = 250mm;
        gravity = (0, -10m_s2);
        ground { point side = (2m, 0m); }
        body load { mass = 3kg;  start y = 250mm; }
        body other { mass = 2kg;  start y = 400mm; }
        joint upright = absolute_angle(load, 0deg);
        joint rail = absolute_x(load.position, 0mm);
        slice drive jack = drive_distance(ground.position, load.position, start + 100mm_s * t + 500mm_s2 * t^2);
        joint also_upright = absolute_angle(other, 0deg);
        joint other_rail = absolute_x(other.position, 2m);
        drive press = { (400mm - 50mm_s * t)^2 == dot(other.position - ground.side, other.position - ground.side); };
    }
}

#[test]
fn the_effort_of_a_distance_is_the_force_along_it() {
    for start in [0.05, 0.25, 3.0] {
        let lifts = Lifts { start };
        for state in lifts.sweep((0..20).map(|step| 0.1 * f64::from(step))) {
            let state = state.expect("a state");
            let loads = lifts.loads(&state);
            let (force, rate) = (3.0 * (10.0 + 1.0), 0.1 + state.t);
            for jack in [loads.jack(), lifts.load_of_jack(&state)] {
                assert!((jack.effort - force).abs() < 1e-12 * force && (jack.power - force * rate).abs() < 1e-12 * force, "{jack:?}");
            }
            // Squares written the other way round.
            let press = loads.press();
            assert!((press.effort - 20.0).abs() < 1e-12 && (press.power + 20.0 * 0.05).abs() < 1e-13, "{press:?}");
        }
    }
}

mechanism! {
    /// An isosceles slider-crank passes its change point at 90° while its crank gains speed, and a crank beside it.
    mechanism Isosceles {
        param gain: AngularAcceleration = 0.6rad_s2;
        ground { axis way = (1, 0);  point aside = (1m, 0m); }
        body crank  { point A = (120mm, 0mm); }
        body rod    { point B = (120mm, 0mm);  mass = 0.5kg;  inertia = 0.002kgm2;  start angle = -60deg; }
        body slide  { mass = 0.8kg; }
        body beside { inertia = 1e6kgm2;  mass = 1kg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, rod.position);
        joint b = revolute(rod.B, slide.position);
        joint guide = translational(ground.way, ground.position, slide.position);
        joint pivot = revolute(ground.aside, beside.position);
        drive motor = drive_angle(crank, 60deg + 1rad_s * t + gain * t^2 / 2);
        drive other = drive_angle(beside, gain * t^2 / 2);
    }
}

#[test]
fn loads_that_grow_beyond_all_bounds_at_a_change_point_are_no_numbers_there() {
    for gain in [0.6, 0.0] {
        let isosceles = Isosceles { gain };
        // 60° + t + gain t² / 2 = 90°
        let sixth = core::f64::consts::FRAC_PI_6;
        let t = 2.0 * sixth / (1.0 + (1.0 + 2.0 * gain * sixth).sqrt());
        let loads = isosceles.loads(&isosceles.solve(t).expect("a state"));
        // The rod turns by J φ̈ with φ̈ = −gain, and the slide accelerates by −2 r gain: no force along the rod turns it.
        assert_eq!(loads.motor().effort.is_finite(), gain == 0.0, "{:?}", loads.motor());
        assert!(loads.a().force.iter().all(|force| force.is_nan() == (gain != 0.0)), "{:?}", loads.a());
        assert_eq!((loads.motor().is_unique, loads.guide().is_unique), (gain == 0.0, false));
        // What is not coupled with it has its loads, however heavy it is.
        let other = loads.other();
        assert!(other.is_unique && (other.effort - 1e6 * gain).abs() <= 1e-14 * 1e6, "{other:?}");
        // Near it the motor does the work of all masses: T = I θ̇² / 2, I = m r² + J + 4 m_s r² sin² θ.
        let near = t + 1e-3;
        let (angle, speed) = (2.0 * sixth + near + gain * near * near / 2.0, 1.0 + gain * near);
        let (own, of_slide) = (0.5 * 0.0144 + 0.002, 0.8 * 4.0 * 0.0144);
        let effort = (own + of_slide * angle.sin().powi(2)) * gain + of_slide * angle.sin() * angle.cos() * speed * speed;
        let found = isosceles.loads(&isosceles.solve(near).expect("a state")).motor();
        assert!(found.is_unique && (found.effort - effort).abs() < 1e-8, "{found:?} {effort}");
    }
}

mechanism! {
    /// A parallelogram whose bars weigh something. In line, they lie along x.
    mechanism Heavy {
        gravity = (0, -9.81m_s2);
        ground { point C = (300mm, 0mm); }
        body crank  { point A = (100mm, 0mm); }
        body bar    { point B = (300mm, 0mm);  mass = 1kg;  center = (150mm, 0mm); }
        body rocker { point B = (100mm, 0mm);  start angle = 60deg;  mass = 1kg;  center = (50mm, 0mm); }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, bar.position);
        joint b = revolute(bar.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        slice drive motor = drive_angle(crank, 60deg + 2rad_s * t);
    }
}

/// At the change point bar and rocker could turn against each other, which their weights would do.
#[test]
fn bars_in_line_with_an_axis_have_no_loads_that_balance_their_weights() {
    let heavy = Heavy::default();
    for turns in 0..4 {
        let crossing = core::f64::consts::FRAC_PI_3 + f64::from(turns) * core::f64::consts::FRAC_PI_2;
        let there = heavy.solve(crossing).expect("in line");
        let (effort, slice) = (heavy.loads(&there).motor(), heavy.load_of_motor(&there));
        assert!(effort.effort.is_nan() && !effort.is_unique && slice.effort.is_nan(), "{effort:?} {slice:?}");
        assert!(heavy.loads(&there).o().force.iter().all(|force| force.is_nan()), "{:?}", heavy.loads(&there).o());
        for beside in [-1e-2, -1e-4, -1e-6, 1e-6, 1e-4, 1e-2] {
            let state = heavy.solve(crossing + beside).expect("beside it");
            // Both centres rise with the crank, that of the bar by all of it.
            let right = 9.81 * (0.1 + 0.05) * state.crank().angle.cos();
            let found = heavy.loads(&state).motor();
            assert!(found.is_unique && (found.effort - right).abs() < 1e-5 * right.abs(), "{turns} {beside:e}: {found:?} {right}");
        }
    }
}

mechanism! {
    /// A balanced rotor on two bearings, which nothing turns.
    mechanism Rotor in space {
        ground { axis u = (1, 2, 3) from (1, 0, -1 / 3);  point P = (1m, 2m, 3m); }
        body rotor { axis u = (0, 0, 1);  point P = (0m, 0m, sqrt(14) * 1m);  mass = 2kg;  inertia = (0.1kgm2, 0.1kgm2, 0.2kgm2); }
        joint one = revolute(ground.position, ground.u, rotor.position, rotor.u);
        redundant joint two = revolute(ground.P, ground.u, rotor.P, rotor.u);
        freedom turn = one.angle from 0.3rad at 7rad_s;
    }
}

#[test]
fn bearings_that_carry_nothing_have_no_load() {
    let rotor = Rotor::default();
    let loads = rotor.loads(&rotor.initial_state().expect("a state"));
    // Rounding of J ω × ω, which vanishes about a principal axis: 0.2 · 49 N m.
    assert!(loads.one().force.norm() < 1e-12 && loads.two().torque.norm() < 1e-12, "{:?} {:?}", loads.one(), loads.two());
}
