//! Several mechanisms in the lanes of a register: each gives the same result as alone.

mod branches;
mod declared;

use declared::{Linkage, Swing};
use reuleaux::{Cause, Family, Mask, Mechanism, Real, SimdReal, Stages, State};
use reuleaux_tests::mechanisms::*;
use reuleaux_wide::{F32x8, F64x4, Lockstep, Wide};

/// The largest difference of q, q̇ and q̈ between two states, relative to the largest entry.
fn differences<const N: usize>(found: &State<f64, N>, expected: &State<f64, N>) -> [f64; 3] {
    let pairs = [(found.q, expected.q), (found.qd, expected.qd), (found.qdd, expected.qdd)];
    pairs.map(|(found, expected)| (found - expected).amax() / expected.amax().max(1e-3))
}

/// Over `span` seconds in steps of 1/200 s, with each lane ahead of the lane before.
fn check<M, const N: usize>(mechanism: M, span: f64)
where
    M: Family<f64> + Mechanism<f64, N> + Copy,
    M::Over<F64x4>: Stages<F64x4, N>,
{
    let times = |step: i32| core::array::from_fn(|lane| span * (f64::from(step) / 200.0 + 0.13 * lane as f64));
    let mut together = Lockstep::<M, F64x4, 4, N>::new([mechanism; 4], times(0));
    let mut alone = times(0).map(|t| mechanism.solve(t).unwrap());
    let mut largest = [0.0_f64; 3];
    for step in 1..=200 {
        together.advance(times(step));
        for (lane, state) in alone.iter_mut().enumerate() {
            mechanism.advance(state, times(step)[lane]).unwrap();
            let found = together.lane(lane).unwrap();
            assert_eq!((found.t, found.branch), (state.t, state.branch));
            let differences = differences(&found, state);
            largest = core::array::from_fn(|i| largest[i].max(differences[i] / state.condition));
        }
    }
    println!("{}: largest differences over the condition {largest:?}", M::NAME);
    assert!(largest[0] <= 1e-15 && largest[1] <= 4e-15 && largest[2] <= 4e-14, "{largest:?}");
}

#[test]
fn reference_mechanisms_are_as_they_are_alone() {
    check(FourBarCrankRocker::default(), 4.0);
    check(SliderCrank::default(), 4.0);
    check(QuickReturn::default(), 4.0);
    check(TheoJansenLeg::default(), 4.0);
    check(HydraulicLoader::default(), 1.0);
    check(TwoStageGearTrain::default(), 4.0);
    check(GearTrainOfPairs::default(), 4.0);
}

#[test]
fn large_blocks_are_as_they_are_alone() {
    check(Linkage::default(), 1.0);
}

#[test]
fn slices_are_as_they_are_alone() {
    check(FourBarCrankRocker::default().solve_for_interest(), 4.0);
}

#[test]
fn steps_too_long_to_go_straight_on_are_made_one_by_one() {
    let mechanism = FourBarCrankRocker::default();
    let mut together = Lockstep::<_, F64x4, 4, 9>::new([mechanism; 4], [0.0; 4]);
    for times in [[0.01, 1.5, 0.02, -2.0], [3.0, 1.6, 0.03, -2.01]] {
        together.advance(times);
        for (lane, t) in times.into_iter().enumerate() {
            let (found, expected) = (together.lane(lane).unwrap(), Mechanism::solve(&mechanism, t).unwrap());
            assert!(differences(&found, &expected)[0] <= 1e-14, "lane {lane}");
        }
    }
}

#[test]
fn one_at_a_dead_point_ends_and_the_others_go_on() {
    let swings = [0.3, 0.5, 0.35, 0.38].map(|amplitude| Swing { amplitude });
    let mut together = Lockstep::<_, F64x4, 4, 9>::new(swings, [0.0; 4]);
    let mut alone = swings.map(|swing| Mechanism::solve(&swing, 0.0).map_err(Box::new));
    let mut at_the_end = None;
    for step in 1..=400 {
        let t = f64::from(step) / 400.0;
        together.advance([t; 4]);
        for ((swing, alone), lane) in swings.iter().zip(&mut alone).zip(0..) {
            if let Ok(state) = alone
                && let Err(failure) = Mechanism::advance(swing, state, t)
            {
                *alone = Err(Box::new(failure));
            }
            match (together.lane(lane), &*alone) {
                (Ok(found), Ok(expected)) => assert!(differences(&found, expected)[0] <= 1e-13 * expected.condition),
                (Err(found), Err(expected)) => {
                    assert_eq!(lane, 1);
                    assert_eq!(
                        (core::mem::discriminant(&found.cause), found.mechanism),
                        (core::mem::discriminant(&expected.cause), "Swing")
                    );
                    assert!((found.time - expected.time).abs() <= 1e-9, "{} and {}", found.time, expected.time);
                    // A lane that has ended no longer changes.
                    let stands = together.state().q.map(|entry| entry.to_array()[1]);
                    assert_eq!(*at_the_end.get_or_insert(stands), stands);
                }
                (found, expected) => panic!("lane {lane} at {t} s: {found:?}, alone {expected:?}"),
            }
        }
    }
    assert!(alone[1].is_err() && [0, 2, 3].iter().all(|lane| together.lane(*lane).is_ok()));
}

#[test]
fn a_parameter_that_is_no_number_ends_its_lane_only() {
    let lengths = [0.1, f64::NAN, 0.09, 0.11];
    let mut together =
        Lockstep::<_, F64x4, 4, 9>::new(lengths.map(|crank_length| FourBarCrankRocker { crank_length, ..Default::default() }), [0.0; 4]);
    for step in 1..=100 {
        together.advance([f64::from(step) / 100.0; 4]);
    }
    for lane in [0, 2, 3] {
        assert!(together.lane(lane).unwrap().q.iter().all(|entry| entry.is_finite()));
    }
    assert!(matches!(together.lane(1).unwrap_err().cause, Cause::ParameterOutOfRange(_)));
}

#[test]
fn a_parameter_beyond_its_bounds_ends_its_lane_only() {
    let together = Lockstep::<_, F64x4, 4, 9>::new([0.1, 0.2, 2.1, 0.3].map(|amplitude| Swing { amplitude }), [0.0; 4]);
    assert!([0, 1, 3].iter().all(|lane| together.lane(*lane).is_ok()));
    let refused = together.lane(2).unwrap_err().to_string();
    assert_eq!(refused, "`Swing` cannot be solved with `amplitude` = 2.1 rad: it must lie in ..= 2 rad");
}

#[test]
fn a_time_that_is_no_number_ends_its_lane_only() {
    let mut together = Lockstep::<_, F64x4, 4, 9>::new([FourBarCrankRocker::default(); 4], [0.0; 4]);
    together.advance([0.01, 0.01, f64::INFINITY, f64::NAN]);
    together.advance([0.02; 4]);
    assert!(together.lane(0).is_ok() && together.lane(1).is_ok());
    assert!([2, 3].iter().all(|lane| matches!(together.lane(*lane).unwrap_err().cause, Cause::NotFinite { .. })));
}

#[test]
fn eight_singles_are_as_they_are_alone() {
    let mechanism = FourBarCrankRocker::<f32>::with_defaults();
    let times = |step: i32| core::array::from_fn(|lane| f32::of(f64::from(step) / 100.0 + 0.1 * lane as f64));
    let mut together = Lockstep::<_, F32x8, 8, 9>::new([mechanism; 8], times(0));
    for step in 1..=200 {
        together.advance(times(step));
    }
    for (lane, t) in times(200).into_iter().enumerate() {
        let (found, expected) = (together.lane(lane).unwrap(), Mechanism::solve(&mechanism, t).unwrap());
        assert!((found.q - expected.q).amax() <= 2e-6, "lane {lane}");
    }
}

#[test]
fn sines_and_cosines_are_those_of_one_lane() {
    for x in [[0.3, -2.0, 3.1, 7.9], [1e5, -9.9e5, 1.6, 0.0], [1e300, 0.5, -4e7, 2.0]] {
        let (sine, cosine) = F64x4::from(x).fast_sin_cos();
        for (lane, x) in x.into_iter().enumerate() {
            let expected = SimdReal::fast_sin_cos(x);
            let (sine, cosine) = (sine.to_array()[lane], cosine.to_array()[lane]);
            assert!((sine - expected.0).abs() <= 2e-16 && (cosine - expected.1).abs() <= 2e-16, "{x}: {sine}, {cosine}");
        }
    }
    let (sine, cosine) = F64x4::from([f64::NAN, 1.0, f64::INFINITY, 2.0]).fast_sin_cos();
    assert_eq!(F64x4::mask_to_lanes(sine.at_most(F64x4::splat(1.0)).and(cosine.at_most(F64x4::splat(1.0)))), [false, true, false, true]);
}
