//! Many mechanisms in parallel.

use std::sync::Mutex;

use reuleaux::parallel::rayon::iter::{IntoParallelIterator, ParallelIterator};
use reuleaux::parallel::{Progress, each};
use reuleaux::{Cause, Failure, State};
use reuleaux_tests::mechanisms::FourBarCrankRocker;

type Ending = Result<State<f64, 9>, Box<Failure<f64, 9>>>;

/// Mechanisms of many sizes, including one that cannot be assembled.
fn cranks() -> Vec<FourBarCrankRocker> {
    let length = |step| if step == 17 { f64::NAN } else { 0.05 + 0.00125 * f64::from(step) };
    (0..40).map(|step| FourBarCrankRocker { crank_length: length(step), ..Default::default() }).collect()
}

fn last(crank: &FourBarCrankRocker) -> Ending {
    let times = (0..300).map(|step| f64::from(step) / 100.0);
    reuleaux::Mechanism::sweep(crank, times).last().expect("there are times").map_err(Box::new)
}

#[test]
fn each_is_as_it_is_alone_and_in_its_place() {
    let (cranks, told) = (cranks(), Mutex::new(Vec::new()));
    let together = each(&cranks, last, |Progress { done, of, .. }| told.lock().unwrap().push((done, of)));

    for (index, (crank, found)) in cranks.iter().zip(&together).enumerate() {
        let alone = last(crank);
        assert_eq!(found.is_ok(), index != 17);
        match (found, &alone) {
            (Ok(found), Ok(alone)) => assert_eq!(found, alone),
            (Err(found), Err(alone)) => {
                assert!(matches!(found.cause, Cause::ParameterOutOfRange(_)), "{found}");
                assert_eq!(found.to_string(), alone.to_string());
            }
            _ => panic!("{index} ends otherwise than alone"),
        }
    }
    let mut told = told.into_inner().unwrap();
    told.sort_unstable();
    assert_eq!(told, (1..=40).map(|done| (done, 40)).collect::<Vec<_>>());
}

#[test]
fn mechanisms_may_be_made_when_their_turn_comes() {
    let made = (0..100_u32).into_par_iter().map(|step| 0.05 + 0.0001 * f64::from(step));
    let made = made.map(|crank_length| FourBarCrankRocker { crank_length, ..Default::default() });
    let found = each(made, |crank| crank.solve(0.3).map(|state| (crank.crank_length, state.rocker().angle)).ok(), |_| ());
    assert_eq!(found.len(), 100);
    for (step, found) in (0..100_u32).zip(found) {
        assert!(found.is_some());
        let crank = FourBarCrankRocker { crank_length: 0.05 + 0.0001 * f64::from(step), ..Default::default() };
        assert_eq!(found, crank.solve(0.3).ok().map(|state| (crank.crank_length, state.rocker().angle)));
    }
}
