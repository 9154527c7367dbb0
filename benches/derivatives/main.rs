//! What derivatives by parameters cost, beside a warm step: `cargo run --release -p reuleaux-benches --bin derivatives`.
//!
//! A warm step writes its state in place (`advance`). Derivatives are measured both ways: in place (`update_derivatives`), and with a
//! new state for each (`derivatives`). Each is followed by the tracked point with its rate and acceleration; all are measured in turns. Parameters
//! are selected all at once or in parts; then all states have their turn for a part before the next.

mod mechanisms;

use std::hint::black_box;

use mechanisms::*;
use reuleaux::Mechanism;
use reuleaux_benches::measured;

/// Turns for one measurement.
const TURNS: usize = 4;

/// Measures a mechanism: a warm step, and derivatives by one parameter and by all, in place and as new states.
macro_rules! measure {
    ($name:literal, $mechanism:ident, $state:ident, $output:ident, $one:ident, [$([$($all:ident),*]),*]) => {{
        let mechanism = $mechanism::default();
        let times: Vec<f64> = (0..=STEPS).map(|step| f64::from(step) / f64::from(STEPS)).collect();
        let states: Vec<$state> = mechanism.sweep(times.iter().copied()).map(|state| state.expect("it turns")).collect();
        let mut step = || {
            let mut state = states[0].clone();
            for &t in &times[1..] {
                mechanism.advance(&mut state, t).expect("it turns");
                black_box(&mechanism.$output(&state));
            }
        };
        let (varied, there) = mechanism.derivatives(&states[0], |m| [&mut m.$one]).expect("a state");
        let mut there = $state(there);
        let mut of_one = || {
            for state in &states[1..] {
                mechanism.update_derivatives(state, &varied, &mut there.0).expect("a state");
                black_box(&varied.$output(&there));
            }
        };
        let mut each_part: Vec<Box<dyn FnMut(&$state)>> = vec![$({
            let (varied, there) = mechanism.derivatives(&states[0], |m| [$(&mut m.$all),*]).expect("a state");
            let mut there = $state(there);
            let mechanism = &mechanism;
            Box::new(move |state| {
                mechanism.update_derivatives(state, &varied, &mut there.0).expect("a state");
                black_box(&varied.$output(&there));
            })
        }),*];
        let mut of_all = || each_part.iter_mut().for_each(|part| states[1..].iter().for_each(&mut *part));
        let mut new_of_one = || {
            for state in &states[1..] {
                let (varied, state) = mechanism.derivatives(state, |m| [&mut m.$one]).expect("a state");
                black_box(&varied.$output(&$state(state)));
            }
        };
        let mut new_of_all = || {
            $(for state in &states[1..] {
                let (varied, state) = mechanism.derivatives(state, |m| [$(&mut m.$all),*]).expect("a state");
                black_box(&varied.$output(&$state(state)));
            })*
        };
        let count = [$($(stringify!($all)),*),*].len();
        let found = measured(&mut [&mut step, &mut of_one, &mut of_all, &mut new_of_one, &mut new_of_all], TURNS);
        let found: Vec<f64> = found.into_iter().map(|turn| turn / f64::from(STEPS)).collect();
        let [step, one, all, new_one, new_all] = found[..] else { unreachable!("five ways") };
        let each = |all: f64| all / step / count as f64;
        println!(
            "| {} | {step:.0} ns | {count} | {one:.0} ns | {all:.0} ns | {:.2} | {new_one:.0} ns | {new_all:.0} ns | {:.2} |",
            $name,
            each(all),
            each(new_all)
        );
    }};
}

fn main() {
    println!(
        "| mechanism | warm step and output | parameters | in place: by 1 | by all | for each, in steps | new: by 1 | by all | for each |"
    );
    println!("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
    each!(measure);
}
