//! Parallel sweeps of many mechanisms.

use std::sync::Mutex;

use reuleaux::parallel::{Progress, sweeps};
use reuleaux::{Cause, Failure, State};
use reuleaux_tests::mechanisms::FourBarCrankRocker;

type Ending = Result<State<f64, 9>, Box<Failure<f64, 9>>>;

/// Mechanisms of many sizes, including one that cannot be assembled.
fn cranks() -> Vec<FourBarCrankRocker> {
    let length = |step| if step == 17 { f64::NAN } else { 0.05 + 0.00125 * f64::from(step) };
    (0..40).map(|step| FourBarCrankRocker { crank_length: length(step), ..Default::default() }).collect()
}

fn last(sweep: impl Iterator<Item = Result<State<f64, 9>, Failure<f64, 9>>>) -> Ending {
    sweep.last().expect("there are times").map_err(Box::new)
}

#[test]
fn each_is_as_it_is_alone_and_in_its_place() {
    let (cranks, times): (_, Vec<f64>) = (cranks(), (0..300).map(|step| f64::from(step) / 100.0).collect());
    let told = Mutex::new(Vec::new());
    let together = sweeps(&cranks, &times, |sweep| last(sweep), |Progress { done, of }| told.lock().unwrap().push((done, of)));

    for (index, (crank, found)) in cranks.iter().zip(&together).enumerate() {
        let alone = last(reuleaux::Mechanism::sweep(crank, times.iter().copied()));
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
