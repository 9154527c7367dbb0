//! What derivatives by parameters cost where the state is written in place, beside a warm step, which writes in place as well:
//! `cargo run --release -p reuleaux-benches --bin derivatives_in_place`.

mod mechanisms;

use std::hint::black_box;

use mechanisms::*;
use reuleaux::Mechanism;

/// Measures a mechanism: a warm step, derivatives by one parameter, and by all.
macro_rules! measure {
    ($name:literal, $mechanism:ident, $state:ident, $output:ident, $one:ident, [$($all:ident),*]) => {{
        let mechanism = $mechanism::default();
        let times: Vec<f64> = (0..=STEPS).map(|step| f64::from(step) / f64::from(STEPS)).collect();
        let states: Vec<$state> = mechanism.sweep(times.iter().copied()).map(|state| state.expect("it turns")).collect();
        let mut step = || {
            let mut state = states[0].clone();
            for &t in &times[1..] {
                mechanism.advance(&mut state, t).expect("it turns");
                black_box(mechanism.$output(&state));
            }
        };
        let (varied, there) = mechanism.derivatives(&states[0], |m| [&mut m.$one]).expect("a state");
        let mut there = $state(there);
        let mut of_one = || {
            for state in &states[1..] {
                mechanism.update_derivatives(state, &varied, &mut there.0).expect("a state");
                black_box(varied.$output(&there));
            }
        };
        let all = mechanism.derivatives(&states[0], |m| {
            let $mechanism { $($all),* } = m;
            [$($all),*]
        });
        let (varied, there) = all.expect("a state");
        let mut there = $state(there);
        let mut of_all = || {
            for state in &states[1..] {
                mechanism.update_derivatives(state, &varied, &mut there.0).expect("a state");
                black_box(varied.$output(&there));
            }
        };
        let count = [$(stringify!($all)),*].len();
        let found = measured(&mut [&mut step, &mut of_one, &mut of_all]);
        let [step, one, all] = found[..] else { unreachable!("three ways") };
        println!("| {} | {step:.0} ns | {one:.0} ns | {count} | {all:.0} ns | {:.2} |", $name, all / step / count as f64);
    }};
}

fn main() {
    println!("| mechanism | warm step and output | by 1 parameter | parameters | by all | for each, in steps |");
    println!("| --- | ---: | ---: | ---: | ---: | ---: |");
    each!(measure);
}
