//! Valid models are accepted, and models with one mistake are refused for it: 150 of each, a thousand in `.ci/run`, without rustc.
//!
//! Seeds are fixed, so that a failure is reproducible; it prints the whole declaration.

mod elements;
mod mistakes;
mod model;
pub(crate) mod motion;
mod rings;

use fastrand::Rng;
use mistakes::KINDS;
use model::Model;
use motion::Verdict;
use reuleaux_compiler::diag::Refusal;
use reuleaux_compiler::{Compiled, compile};
use reuleaux_tests::samples;
use std::num::NonZero;
use std::thread;

/// Number of models of each kind.
fn models() -> u64 {
    samples(150, 1000) as u64
}

/// Seeds of the models with a mistake begin here.
const WITH_A_MISTAKE: u64 = 1000;

fn compiled(source: &str) -> Result<Compiled, Vec<Refusal>> {
    compile(source.parse().expect("the declaration consists of tokens"))
}

fn shown(refusals: &[Refusal], source: &str) -> String {
    refusals.iter().map(|refusal| refusal.shown(source)).collect::<Vec<_>>().join("\n")
}

#[test]
fn what_can_be_assembled_is_accepted() {
    let is_accepted = |seed: u64| {
        let source = elements::random(&mut Rng::with_seed(seed)).declaration();
        match compiled(&source) {
            Ok(compiled) => assert!(compiled.assembly.is_closed, "seed {seed} is not assembled:\n{source}"),
            Err(refusals) => panic!("seed {seed} is refused:\n{}\nin\n{source}", shown(&refusals, &source)),
        }
    };
    // Assembly takes most of the time, and runs on all processors.
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
    thread::scope(|scope| {
        for first in 0..threads as u64 {
            scope.spawn(move || (first..models()).step_by(threads).for_each(is_accepted));
        }
    });
}

#[test]
fn motions_end_where_it_is_said_and_nowhere_else() {
    let threads = thread::available_parallelism().map_or(1, NonZero::get) as u64;
    let judged = thread::scope(|scope| {
        let judge = |first: u64| (first..samples(40, 80) as u64).step_by(threads as usize).map(motion::judge).collect::<Vec<Verdict>>();
        let all: Vec<_> = (0..threads).map(|first| scope.spawn(move || judge(first))).collect();
        all.into_iter().flat_map(|judged| judged.join().expect("a motion is as it is said")).collect::<Vec<Verdict>>()
    });
    let count = |verdict: Verdict| judged.iter().filter(|judged| **judged == verdict).count();
    // Only few are too hard to decide.
    assert!(
        count(Verdict::GoesOn) > samples(2, 5) && count(Verdict::Ends) > samples(10, 20) && count(Verdict::Open) < samples(10, 20),
        "{judged:?}"
    );
}

#[test]
fn one_mistake_gives_one_error_that_names_it() {
    for (seed, kind) in (WITH_A_MISTAKE..WITH_A_MISTAKE + models()).zip(KINDS.iter().cycle()) {
        let mut rng = Rng::with_seed(seed);
        let mut model: Model = elements::random(&mut rng);
        let guilty = kind.put_into(&mut model, &mut rng);
        let source = model.declaration();
        let refusals = compiled(&source).err().unwrap_or_default();
        let shown = shown(&refusals, &source);
        assert_eq!(refusals.len(), 1, "{kind:?} with seed {seed} gives one error:\n{shown}\nin\n{source}");
        // The text that a user reads: the message, and the marked line.
        assert!(
            guilty.iter().any(|name| shown.contains(name.as_str())),
            "{kind:?} with seed {seed} names one of {guilty:?}:\n{shown}\nin\n{source}"
        );
    }
}
