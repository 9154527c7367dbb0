//! Published problems: Andrews' squeezing mechanism, pendulums and the N-four-bar.

use crate::compare::{TOLERANCES, error, times};
use reuleaux::{Integrator, Stopped, mechanism};
use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::reference::{file, list, text};

mechanism! {
    /// `andrews.json`, in coordinates of the centres of mass.
    pub(crate) mechanism Andrews {
        ground {
            point O = (0m, 0m);  point A = (-0.06934m, -0.00227m);
            point B = (-0.03635m, 0.03273m);  point C = (0.014m, 0.072m);
        }
        body of  { point O = (-0.00092m, 0m);  point F = (0.00608m, 0m);  mass = 0.04325kg;  inertia = 2.194e-6kgm2;  start angle = -0.0617rad; }
        body ef  { point F = (0.0115m, 0m);  point E = (-0.0165m, 0m);  mass = 0.00365kg;  inertia = 4.41e-7kgm2;  start angle = -0.0617rad; }
        body bde {
            point B = (-0.01043m, 0.01874m);  point D = (0.00957m, 0.00074m);  point E = (-0.01043m, -0.01626m);
            mass = 0.02373kg;  inertia = 5.255e-6kgm2;  start angle = 0.455rad;
        }
        body ge  { point G = (0m, 0.00579m);  point E = (0m, -0.01421m);  mass = 0.00706kg;  inertia = 5.667e-7kgm2;  start angle = 0.71rad; }
        body ag  { point A = (-0.02308m, -0.00916m);  point G = (0.01692m, -0.00916m);  mass = 0.0705kg;  inertia = 1.169e-5kgm2;  start angle = 0.487rad; }
        body he  { point H = (-0.00579m, 0m);  point E = (0.01421m, 0m);  mass = 0.00706kg;  inertia = 5.667e-7kgm2;  start angle = 1.008rad; }
        body ah  { point A = (0.00449m, 0.01228m);  point H = (0.00449m, -0.02772m);  mass = 0.05498kg;  inertia = 1.912e-5kgm2;  start angle = 1.23rad; }
        joint o = revolute(ground.O, of.O);
        joint f = revolute(of.F, ef.F);
        joint e1 = revolute(ef.E, bde.E);
        joint b = revolute(ground.B, bde.B);
        joint e2 = revolute(ef.E, ge.E);
        joint g = revolute(ge.G, ag.G);
        joint a1 = revolute(ground.A, ag.A);
        joint e3 = revolute(ef.E, he.E);
        joint h = revolute(he.H, ah.H);
        joint a2 = revolute(ground.A, ah.A);
        force motor = { on of: 0.033Nm; }
        force spring = spring(ground.C, bde.D, stiffness: 4530N_m, rest: 0.07785m);
        freedom beta = of.angle from -0.0617138900142764496358948458001rad;
    }
}

/// The crank makes 2.5 turns in 0.03 s and errors grow with its angle; the published state has about ten digits.
#[test]
fn andrews_mechanism_squeezes_as_published() {
    let reference = file("andrews.json");
    let reference = &reference["dynamics_cartesian"];
    let mechanism = Andrews::default();
    for tolerance in TOLERANCES {
        let mut state = mechanism.initial_state().expect("a state");
        let mut integrator = Integrator::new(tolerance);
        for (time, wanted) in times(reference).into_iter().zip(list(&reference["states"])) {
            mechanism.advance(&mut state, time, &mut integrator).expect("a motion");
            let loads = mechanism.loads(&state);
            let found = [
                ("q", state.q.as_slice()),
                ("qd", state.qd.as_slice()),
                ("qdd", state.qdd.as_slice()),
                ("lambda", loads.multipliers.as_slice()),
            ];
            for (name, found) in found {
                let error = error(found, &wanted[name]);
                // The crank turns at 1100 rad/s, and accelerations change with its angle.
                let bound = if name == "q" { tolerance } else { 10.0 * tolerance };
                assert!(error <= bound, "{name} at {time} s and {tolerance:e}: {error:e}");
            }
        }
    }
}

mechanism! {
    /// The double pendulum of `pendulum.json`.
    pub(crate) mechanism Rods {
        gravity = (0, -9.81m_s2);
        body rod1 { point A = (-0.5m, 0m);  point B = (0.5m, 0m);  mass = 1kg;  inertia = (1/12) * 1kgm2;  start position = (0.5m, 0m); }
        body rod2 { point B = (-0.5m, 0m);  mass = 1kg;  inertia = (1/12) * 1kgm2;  start position = (1.5m, 0m); }
        joint upper = revolute((0m, 0m), rod1.A);
        joint lower = revolute(rod1.B, rod2.B);
        freedom one = rod1.angle;
        freedom two = rod2.angle;
    }
}

/// The motion is chaotic: errors grow as the file says.
#[test]
fn rods_swing_as_published() {
    let reference = file("pendulum.json");
    let reference = &reference["double"];
    let mechanism = Rods::default();
    for tolerance in TOLERANCES {
        let mut state = mechanism.initial_state().expect("a state");
        let mut integrator = Integrator::new(tolerance);
        for (time, wanted) in times(reference).into_iter().zip(list(&reference["states"])) {
            let sensitivity = Decimal::parse(text(&wanted["sensitivity_inf"])).value;
            if sensitivity * tolerance > 0.01 {
                break;
            }
            mechanism.advance(&mut state, time, &mut integrator).expect("a motion");
            for (name, found) in [("q", &state.q), ("qd", &state.qd), ("qdd", &state.qdd)] {
                let error = error(found.as_slice(), &wanted[name]);
                assert!(error <= tolerance * sensitivity.max(1.0), "{name} at {time} s and {tolerance:e}: {error:e}");
            }
        }
    }
}

mechanism! {
    /// The N-four-bar of `nfourbar.json` with two windows.
    pub(crate) mechanism Windows {
        gravity = (0, -9.81m_s2);
        body v0 { point A = (0m, -0.5m);  point B = (0m, 0.5m);  mass = 1kg;  inertia = (1/12) * 1kgm2;  start position = (0m, 0.5m); }
        body v1 { point A = (0m, -0.5m);  point B = (0m, 0.5m);  mass = 1kg;  inertia = (1/12) * 1kgm2;  start position = (1m, 0.5m); }
        body v2 { point A = (0m, -0.5m);  point B = (0m, 0.5m);  mass = 1kg;  inertia = (1/12) * 1kgm2;  start position = (2m, 0.5m); }
        body h1 { point L = (-0.5m, 0m);  point R = (0.5m, 0m);  mass = 1kg;  inertia = (1/12) * 1kgm2;  start position = (0.5m, 1m); }
        body h2 { point L = (-0.5m, 0m);  point R = (0.5m, 0m);  mass = 1kg;  inertia = (1/12) * 1kgm2;  start position = (1.5m, 1m); }
        joint a0 = revolute((0m, 0m), v0.A);
        joint a1 = revolute((1m, 0m), v1.A);
        joint a2 = revolute((2m, 0m), v2.A);
        joint l1 = revolute(v0.B, h1.L);
        joint r1 = revolute(h1.R, v1.B);
        joint l2 = revolute(v1.B, h2.L);
        joint r2 = revolute(h2.R, v2.B);
        freedom fall = v0.angle at -1rad_s;
    }
}

/// Where all bars are in line the joints lose rank: the motion can go on in several ways, and stops.
#[test]
fn windows_fall_until_their_bars_are_in_line() {
    let reference = file("nfourbar.json");
    let case = &list(&reference["cases"])[0];
    let in_line = Decimal::parse(text(&case["collinear_times"][0])).value;
    let mechanism = Windows::default();
    let wanted = &list(&case["states"])[1];
    for tolerance in TOLERANCES {
        let mut state = mechanism.initial_state().expect("a state");
        let mut integrator = Integrator::new(tolerance);
        mechanism.advance(&mut state, 0.5, &mut integrator).expect("a motion");
        let found = [-state.v0().angle, -state.v0().angular_velocity, -state.v0().angular_acceleration];
        for (found, name) in found.into_iter().zip(["theta", "theta_dot", "theta_ddot"]) {
            let error = Decimal::parse(text(&wanted[name])).error_of(found);
            assert!(error <= 10.0 * tolerance, "{name} at {tolerance:e}: {error:e}");
        }
        let end = mechanism.advance(&mut state, 10.0, &mut integrator);
        assert!(matches!(end, Err(Stopped::Singular { time, .. }) if (time - in_line).abs() < 1e-6), "{tolerance:e}: {end:?}");
    }
}
