//! Places where the equations of the joints depend on each other: a motion stops there or passes, but never goes on with other speeds.

use std::f64::consts::PI;

use reuleaux::{Integrator, Stopped, mechanism};
use reuleaux_tests::samples;

mechanism! {
    /// Two pairs of equal links: it falls through the place where all of them lie in line.
    mechanism Kite {
        gravity = (0, -9.81m_s2);
        ground { point B = (500mm, 0mm); }
        body a { point P = (200mm, 0mm);  mass = 1kg;  inertia = 0.02kgm2;  start angle = 100deg; }
        body c { point Q = (200mm, 0mm);  mass = 1kg;  inertia = 0.02kgm2;  center = (100mm, 20mm);  start angle = 20deg; }
        body b { point P = (500mm, 0mm);  mass = 1kg;  inertia = 0.1kgm2;  start angle = 160deg; }
        joint ja = revolute(ground.position, a.position);
        joint jb = revolute(ground.B, b.position);
        joint jc = revolute(a.P, c.position);
        joint jd = revolute(c.Q, b.P);
        freedom f = a.angle from 100deg at -6rad_s;
    }
}

mechanism! {
    /// A parallelogram that falls.
    mechanism Parallelogram {
        gravity = (0, -9.81m_s2);
        ground { point B = (1m, 0m); }
        body a { point P = (300mm, 0mm);  mass = 1kg;  inertia = 0.02kgm2;  start angle = 60deg; }
        body b { point P = (300mm, 0mm);  mass = 1kg;  inertia = 0.02kgm2;  start angle = 60deg; }
        body c { point Q = (1m, 0m);  mass = 1kg;  inertia = 0.1kgm2;  center = (500mm, 0mm); }
        joint ja = revolute(ground.position, a.position);
        joint jb = revolute(ground.B, b.position);
        joint jc = revolute(a.P, c.position);
        joint jd = revolute(c.Q, b.P);
        freedom f = a.angle from 60deg;
    }
}

mechanism! {
    /// A parallelogram that a third crank keeps one beyond its flat place.
    mechanism ThreeCranks {
        gravity = (0, -9.81m_s2);
        ground { point B = (2m, 0m);  point C = (1m, 0m); }
        body crank { point P = (500mm, 0mm);  mass = 2kg;  center = (200mm, 10mm);  inertia = 0.05kgm2;  start angle = 60deg; }
        body bar { point Q = (2m, 0m);  point R = (1m, 0m);  mass = 5kg;  center = (0.8m, 50mm);  inertia = 1.2kgm2; }
        body rocker { point P = (500mm, 0mm);  mass = 1kg;  center = (250mm, 0mm);  inertia = 0.03kgm2;  start angle = 60deg; }
        body third { point P = (500mm, 0mm);  mass = 1.5kg;  center = (250mm, 0mm);  inertia = 0.03kgm2;  start angle = 60deg; }
        joint a = revolute(ground.position, crank.position);
        joint b = revolute(ground.B, rocker.position);
        joint c = revolute(crank.P, bar.position);
        joint d = revolute(bar.Q, rocker.P);
        joint e = revolute(ground.C, third.position);
        redundant joint f = revolute(bar.R, third.P);
        force stop = torsion_spring_damper(crank, bar, 20Nm_rad, 0deg, 1Nms);
        freedom s = crank.angle from 60deg at 1rad_s;
    }
}

/// Tolerances between 1e-4 and 1e-12.
fn tolerances() -> impl Iterator<Item = f64> {
    (0..=16).step_by(16 / samples(4, 16)).map(|k| 1e-4 * 10.0_f64.powf(-0.5 * f64::from(k)))
}

/// True if the equations are said to depend on each other.
fn is_told(stopped: &Stopped<f64>) -> bool {
    matches!(stopped, Stopped::Singular { .. })
}

/// All states of sweeps, single advances and stiff ones keep the energy of the first, until a motion stops.
macro_rules! keeps_its_energy {
    ($mechanism:ident, $times:expr) => {{
        let mechanism = $mechanism::default();
        let first = mechanism.initial_state().expect("a start");
        let total = |state: &_| mechanism.energy(state).total();
        // Relative to 10 J, about the work of gravity.
        let energy = total(&first);
        let off = |state: &_| (total(state) - energy).abs() / 10.0;
        for tolerance in tolerances() {
            for state in mechanism.sweep($times, Integrator::new(tolerance)) {
                match state {
                    Ok(state) => assert!(off(&state) < 300.0 * tolerance, "{tolerance} {} {}", state.t, off(&state)),
                    Err(stopped) => assert!(is_told(&stopped), "{tolerance} {stopped}"),
                }
            }
            for t in $times {
                let mut state = first.clone();
                match mechanism.advance(&mut state, t, &mut Integrator::new(tolerance)) {
                    Ok(()) => assert!(off(&state) < 300.0 * tolerance, "{tolerance} {t} {}", off(&state)),
                    Err(stopped) => assert!(is_told(&stopped), "{tolerance} {stopped}"),
                }
                let mut state = first.clone();
                match mechanism.advance(&mut state, t, &mut Integrator::stiff(tolerance.max(1e-8))) {
                    Ok(()) => assert!(off(&state) < 300.0 * tolerance.max(1e-8), "stiff {tolerance} {t} {}", off(&state)),
                    Err(stopped) => assert!(is_told(&stopped), "stiff {tolerance} {stopped}"),
                }
            }
        }
    }};
}

#[test]
fn a_kite_keeps_its_energy_or_stops() {
    keeps_its_energy!(Kite, [0.3, 0.33, 0.34, 0.4, 0.5, 0.6, 0.8]);
}

#[test]
fn a_parallelogram_keeps_its_energy_or_stops() {
    keeps_its_energy!(Parallelogram, [0.3, 0.4, 0.45, 0.5, 0.6]);
}

mechanism! {
    /// A pendulum of two cranks and a bar, which begins at any angle.
    mechanism Pendulum {
        param start: Angle = 60deg;
        gravity = (0, -9.81m_s2);
        ground { point B = (300mm, 0mm); }
        body a { point P = (100mm, 0mm);  mass = 1kg;  inertia = 0.002kgm2; }
        body c { point Q = (300mm, 0mm);  mass = 1kg;  center = (150mm, 0mm);  inertia = 0.01kgm2; }
        body b { point P = (100mm, 0mm);  mass = 1kg;  inertia = 0.005kgm2;  start angle = 60deg; }
        joint ja = revolute(ground.position, a.position);
        joint jb = revolute(ground.B, b.position);
        joint jc = revolute(a.P, c.position);
        joint jd = revolute(c.Q, b.P);
        freedom f = a.angle from start at 2rad_s;
    }
}

/// States that are handed out keep digits of their accelerations, or are refused: where all bars are in line nothing decides between the branches.
#[test]
fn beside_the_place_where_bars_are_in_line_accelerations_keep_digits_or_are_refused() {
    // Only the bar is lifted: α = −m g r cos θ / (J + J' + m r²)
    let right = |angle: f64| -9.81 * 0.1 * angle.cos() / (0.002 + 0.005 + 0.01);
    let check = |found: Result<PendulumState, Stopped<f64>>, beside: f64| match found {
        Ok(state) => {
            assert!(beside.abs() > 1e-5, "{beside:e}");
            let off = [state.a().angular_acceleration, state.b().angular_acceleration].map(|found| found / right(state.a().angle) - 1.0);
            assert!(off.iter().all(|off| off.abs() < 1e-3), "{beside:e}: {off:?}");
        }
        Err(stopped) => assert!(is_told(&stopped) && beside.abs() < 1e-3, "{beside:e}: {stopped}"),
    };
    for beside in (2..=14).map(|digits| 0.3 * 0.1_f64.powi(digits)).chain([0.0]) {
        check(Pendulum { start: PI - beside }.initial_state(), beside);
        if beside > 0.0 {
            let mechanism = Pendulum { start: PI - 0.1 };
            let mut state = mechanism.initial_state().expect("a start");
            let event = |state: &PendulumState| state.a().angle - (PI - beside);
            let found = mechanism.advance_until(&mut state, 1.0, &mut Integrator::new(1e-10), event);
            if let Ok(is_found) = found {
                assert!(is_found && (state.a().angle - (PI - beside)).abs() < 1e-9, "{beside:e}: {}", state.a().angle);
            }
            check(found.map(|_| state), beside);
        }
    }
}

/// The angle of the cranks at a time: as long as the bar does not turn they have one equation, here by Runge and Kutta's method.
fn of_cranks(t: f64) -> f64 {
    const INERTIA: f64 = 0.05 + 2.0 * (0.2 * 0.2 + 0.01 * 0.01) + 0.03 + 0.25 * 0.25 + 0.03 + 1.5 * 0.25 * 0.25 + 5.0 * 0.5 * 0.5;
    let acceleration = |[angle, speed]: [f64; 2]| {
        let (sine, cosine) = angle.sin_cos();
        let weight = 9.81 * ((2.0 * 0.2 + 0.25 + 1.5 * 0.25 + 5.0 * 0.5) * cosine - 2.0 * 0.01 * sine);
        (-weight - 20.0 * angle - speed) / INERTIA
    };
    let rates = |at: [f64; 2]| [at[1], acceleration(at)];
    let moved = |at: [f64; 2], h: f64, by: [f64; 2]| [at[0] + h * by[0], at[1] + h * by[1]];
    let (steps, mut at) = (4000, [60.0_f64.to_radians(), 1.0]);
    let h = t / f64::from(steps);
    for _ in 0..steps {
        let one = rates(at);
        let two = rates(moved(at, h / 2.0, one));
        let three = rates(moved(at, h / 2.0, two));
        let four = rates(moved(at, h, three));
        at = std::array::from_fn(|k| at[k] + h / 6.0 * (one[k] + 2.0 * (two[k] + three[k]) + four[k]));
    }
    at[0]
}

#[test]
fn three_cranks_go_on_together_or_stop() {
    let mechanism = ThreeCranks::default();
    for times in [&[0.0, 0.2, 0.345, 0.348, 0.36, 0.4][..], &[0.0, 0.1, 0.2, 0.3, 0.34, 0.35]] {
        for tolerance in tolerances() {
            for state in mechanism.sweep(times, Integrator::new(tolerance)) {
                match state {
                    Ok(state) => {
                        let off = (state.crank().angle - of_cranks(state.t)).abs();
                        assert!(off < 100.0 * tolerance + 1e-9, "{tolerance} {}: {off}", state.t);
                    }
                    Err(stopped) => assert!(is_told(&stopped), "{tolerance} {stopped}"),
                }
            }
            for &t in times {
                let (mut state, tolerance) = (mechanism.initial_state().expect("a start"), tolerance.max(1e-8));
                match mechanism.advance(&mut state, t, &mut Integrator::stiff(tolerance)) {
                    Ok(()) => {
                        let off = (state.crank().angle - of_cranks(t)).abs();
                        assert!(off < 100.0 * tolerance, "stiff {tolerance} {t}: {off}");
                    }
                    Err(stopped) => assert!(is_told(&stopped), "stiff {tolerance} {stopped}"),
                }
            }
        }
    }
}
