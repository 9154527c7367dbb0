//! Solving allocates nothing on the heap, on any path and with any result.

use allocation_counter::measure;
use reuleaux::nalgebra::SVector;
use reuleaux::{Mechanism, Stages};
use reuleaux_tests::blocks::SixPlates;
use reuleaux_tests::mechanisms::{FourBarCrankRocker, HydraulicLoader, SliderCrank, TheoJansenLeg, TwoStageGearTrain};
use reuleaux_tests::stress::RockerDrivenFourBar;
use reuleaux_wide::{F64x4, Lockstep};

/// Asserts that `run` allocates nothing.
fn without_memory(what: &str, run: impl FnOnce()) {
    let taken = measure(run);
    assert_eq!((taken.count_total, taken.bytes_total), (0, 0), "{what}");
}

fn times() -> impl Iterator<Item = f64> {
    (0..200).map(|step| f64::from(step) / 100.0)
}

fn check<M: Mechanism<f64, N> + Stages<f64, N>, const N: usize>(mechanism: &M) {
    without_memory("solve", || assert!(mechanism.solve(0.3).is_ok()));
    let state = mechanism.solve(0.0).unwrap();
    without_memory("solve_from", || assert!(mechanism.solve_from(0.7, &state).is_ok()));
    without_memory("solve_near", || assert!(mechanism.solve_near(0.0, &state.q).is_ok()));
    without_memory("sweep", || assert!(mechanism.sweep(times()).all(|state| state.is_ok())));
    without_memory("advance", || {
        let mut state = state.clone();
        assert!(times().all(|t| mechanism.advance(&mut state, t).is_ok()));
    });
    without_memory("times that are no numbers", || {
        assert!(mechanism.solve(f64::NAN).is_err() && mechanism.solve_from(f64::INFINITY, &state).is_err());
    });
    without_memory("guesses that are none", || {
        let _ = mechanism.solve_near(0.0, &SVector::from_element(1e9));
        assert!(mechanism.solve_near(0.0, &SVector::from_element(f64::NAN)).is_err());
    });
}

#[test]
fn reference_mechanisms_need_no_allocation() {
    check(&FourBarCrankRocker::default());
    check(&SliderCrank::default());
    check(&TheoJansenLeg::default());
    check(&HydraulicLoader::default());
    check(&TwoStageGearTrain::default());
}

reuleaux::mechanism! {
    /// Four-bars side by side, half of them at rest.
    #[allow(far_start)]
    pub mechanism Row {
        param incline: Angle = 10deg;
        component FourBar(O: Point, C: Point, law: Angle) {
            body crank { point A = (100mm * cos(incline) / cos(10deg), 0mm); }
            body coupler { point B = (350mm, 0mm); start angle = 30deg; }
            body rocker { point B = (300mm, 0mm); start angle = 70deg; }
            joint o = revolute(O, crank.position);
            joint a = revolute(crank.A, coupler.position);
            joint b = revolute(coupler.B, rocker.B);
            joint c = revolute(rocker.position, C);
            drive input = drive_angle(crank, law);
        }
        ground { for i in 0..20 { point O[i] = (i * 1m, 0m); point C[i] = (i * 1m + 400mm, 0m); } }
        for i in 0..10 { part still[i] = FourBar(ground.O[i], ground.C[i], 20deg * i); }
        for i in 10..20 { part moving[i - 10] = FourBar(ground.O[i], ground.C[i], 20deg * i + 1rad_s * t); }
        slice output tip = moving[3].rocker.B;
    }
}

#[test]
fn shared_code_slices_and_large_blocks_need_no_allocation() {
    let row = Row { incline: 0.2 };
    check(&row);
    check(&row.prepared());
    check(&row.solve_for_tip());
    check(&SixPlates::default());
}

#[test]
fn failures_need_no_allocation() {
    let never_closes = FourBarCrankRocker { crank_length: 7.0, ..Default::default() };
    without_memory("a loop that does not close", || assert!(never_closes.solve(0.0).is_err()));
    let no_number = FourBarCrankRocker { crank_length: f64::NAN, ..Default::default() };
    without_memory("a parameter that is no number", || assert!(no_number.solve(0.0).is_err()));
    let rocker_driven = RockerDrivenFourBar::<f64>::with_defaults();
    without_memory("a dead point", || {
        assert!(rocker_driven.sweep((0..400).map(|step| f64::from(step) / 10.0)).any(|state| state.is_err()))
    });
}

#[test]
fn singles_need_no_allocation() {
    let mechanism = FourBarCrankRocker::<f32>::with_defaults();
    without_memory("f32", || assert!(mechanism.sweep((0..100_u8).map(|step| f32::from(step) / 100.0)).all(|state| state.is_ok())));
}

#[test]
fn lanes_need_no_allocation() {
    let lengths = [0.1, 0.09, 0.11, 7.0];
    let mechanisms = lengths.map(|crank_length| FourBarCrankRocker { crank_length, ..Default::default() });
    without_memory("four lanes, one of which does not close", || {
        let mut together = Lockstep::<_, F64x4, 4, 9>::new(mechanisms, [0.0; 4]);
        times().for_each(|t| together.advance([t; 4]));
        assert!(together.lane(0).is_ok() && together.lane(3).is_err());
    });
}

reuleaux::mechanism! {
    /// A pendulum that falls, with events.
    pub mechanism Swing {
        gravity = (0m_s2, -9.81m_s2);
        body upper { point end = (500mm, 0mm);  mass = 1kg;  center = (250mm, 0mm);  inertia = 0.025kgm2; }
        body lower { mass = 0.8kg;  center = (200mm, 0mm);  inertia = 0.009kgm2; }
        joint shoulder = revolute((0mm, 0mm), upper.position);
        joint elbow = revolute(upper.end, lower.position);
        freedom first = upper.angle;
        freedom second = lower.angle;
    }
}

reuleaux::mechanism! {
    /// Is measured.
    pub mechanism Measured {
        input theta: Angle = 40deg;
        ground { point C = (400mm, 0mm); }
        body crank   { point A = (100mm, 0mm); }
        body coupler { point B = (350mm, 0mm); }
        body rocker  { point B = (300mm, 0mm);  start angle = 70deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive motor = drive_angle(crank, theta);
    }
}

#[test]
fn inputs_need_no_allocation() {
    let mechanism = Measured::default();
    let at = |angle: f64| MeasuredInputs { theta: reuleaux::Motion::at(angle) };
    let mut state = mechanism.solve(0.0, at(0.5)).unwrap();
    without_memory("steps and jumps of inputs", || {
        for (step, angle) in [0.501, 0.502, 3.0, -9.0].into_iter().enumerate() {
            assert!(mechanism.advance(&mut state, 1e-3 * step as f64, at(angle)).is_ok());
        }
        assert!(mechanism.advance(&mut state, 1.0, at(f64::NAN)).is_err());
    });
}

#[test]
fn motion_from_forces_needs_none() {
    let swing = Swing::default();
    let mut state = swing.initial_state().unwrap();
    let mut integrator = reuleaux::Integrator::new(1e-9);
    without_memory("initial_state", || assert!(swing.initial_state().is_ok()));
    without_memory("advance", || assert!(swing.advance(&mut state, 0.5, &mut integrator).is_ok()));
    without_memory("advance_until", || {
        assert!(swing.advance_until(&mut state, 5.0, &mut integrator, |state| state.upper().angular_velocity) == Ok(true));
    });
    without_memory("step", || assert!(swing.step(&mut state, 0.001).is_ok()));
    without_memory("energy and loads", || {
        assert!(swing.energy(&state).kinetic > 0.0 && swing.loads(&state).shoulder().force.norm() > 0.0);
    });
}
