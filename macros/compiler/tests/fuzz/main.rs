//! The compiler returns on any tokens, and its output is valid Rust.
//!
//! Valid declarations are mutated: tokens are deleted, repeated, swapped, replaced or nested, and numbers made extreme. Every case is
//! determined by its seed. The usual run is short; a long one is
//!
//! ```text
//! REULEAUX_FUZZ_CASES=100000 cargo test --release -p reuleaux-compiler --test fuzz -- --nocapture
//! ```
//!
//! and `REULEAUX_FUZZ_SEED=17 REULEAUX_FUZZ_CASES=1` repeats case 17 and prints its source.

mod corpus;
mod mutate;
mod random;
#[path = "../../src/expr/tests/samples.rs"]
mod samples;

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::quote;
use random::Random;
use samples::samples;
use std::panic::catch_unwind;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Numbers of cases: in the usual run, and in `.ci/run`.
const CASES: [usize; 2] = [150, 600];

/// Number of cases per thread: the fallback of `proc_macro2` keeps every source that a thread has read.
const CHUNK: u64 = 100;

/// Size of the stack on which rustc runs macros.
const STACK: usize = 8 << 20;

/// Longest time of a case with optimisation: more is noticeable in `cargo check`.
const PATIENCE: Duration = Duration::from_secs(2);

/// Case that a worker is running, and its start.
static CURRENT: Mutex<Option<(u64, Instant)>> = Mutex::new(None);

#[test]
fn any_tokens_are_answered_in_rust() {
    let number = |name: &str, otherwise: u64| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(otherwise);
    let (first, cases) = (number("REULEAUX_FUZZ_SEED", 0), number("REULEAUX_FUZZ_CASES", samples(CASES[0], CASES[1]) as u64));
    std::thread::spawn(watch);
    let (mut slow, mut accepted) = (Vec::new(), 0);
    for start in (first..first + cases).step_by(CHUNK as usize) {
        let seeds = start..(start + CHUNK).min(first + cases);
        let worker = std::thread::Builder::new().stack_size(STACK).name(format!("cases from {start}"));
        let outcome = worker.spawn(move || seeds.map(|seed| (seed, timed(seed))).collect::<Vec<_>>());
        let outcome = outcome.expect("a thread can be started").join().expect("no case panics");
        accepted += outcome.iter().filter(|(_, (_, accepted))| *accepted).count();
        slow.extend(outcome.into_iter().filter(|(_, (took, _))| *took > PATIENCE && !cfg!(debug_assertions)));
    }
    println!("{cases} cases from seed {first}: {accepted} accepted, {} slow", slow.len());
    assert!(slow.is_empty(), "slow cases: {slow:?}");
}

/// Names a case that does not return, then aborts the run.
fn watch() {
    loop {
        std::thread::sleep(Duration::from_secs(1));
        if let Some((seed, since)) = *CURRENT.lock().expect("no worker panics while it holds the lock")
            && since.elapsed() > 30 * PATIENCE
        {
            eprintln!("case {seed} does not return");
            std::process::abort();
        }
    }
}

/// Duration of a case; true if its mechanism was accepted.
fn timed(seed: u64) -> (Duration, bool) {
    let start = Instant::now();
    *CURRENT.lock().expect("no worker panics while it holds the lock") = Some((seed, start));
    let outcome = catch_unwind(|| case(seed));
    *CURRENT.lock().expect("no worker panics while it holds the lock") = None;
    let Ok(accepted) = outcome else { panic!("case {seed} fails") };
    (start.elapsed(), accepted)
}

/// Runs one case; true if it was accepted.
fn case(seed: u64) -> bool {
    let mut random = Random::new(seed);
    let (kind, tokens) = corpus::pick(&mut random);
    let tokens = mutate::mutilated(tokens, &mut random);
    if std::env::var("REULEAUX_FUZZ_CASES").is_ok_and(|cases| cases == "1") {
        println!("{kind:?} {tokens}");
    }
    match kind {
        corpus::Kind::Mechanism if random.below(8) == 0 => {
            resumed(tokens, &mut random);
            false
        }
        corpus::Kind::Mechanism => mechanism(tokens),
        corpus::Kind::Constraint => constraint(tokens),
    }
}

fn mechanism(tokens: TokenStream) -> bool {
    let output = reuleaux_compiler::mechanism(tokens.clone());
    let has_error = is_rust(&output);
    let uses = mutate::flat(tokens.clone()).iter().any(|token| token.to_string() == "use");
    if !uses {
        assert_eq!(reuleaux_compiler::compile(tokens).is_err(), has_error, "a refusal is an error");
    }
    !has_error
}

fn constraint(tokens: TokenStream) -> bool {
    let has_error = is_rust(&reuleaux_compiler::constraint(tokens.clone()));
    assert_eq!(reuleaux_compiler::check_constraint(tokens).is_err(), has_error, "a refusal is an error");
    !has_error
}

/// Resumes a mechanism with mutated definitions, since definitions from other macro calls may be broken too.
fn resumed(mechanism: TokenStream, random: &mut Random) {
    let definition = mutate::mutilated(corpus::definition(random), random);
    let known = mutate::mutilated(quote!(rolling { constraint rolling(P: Point) { P.x == 0; } }), random);
    let name = Ident::new("sliding", Span::call_site());
    let braces = |content| TokenTree::Group(Group::new(Delimiter::Brace, content));
    let (definition, known, mechanism) = (braces(definition), braces(known), braces(mechanism));
    is_rust(&reuleaux_compiler::resume(quote!(#definition #known #name #mechanism)));
}

/// Parses the output; true if it contains an error.
fn is_rust(output: &TokenStream) -> bool {
    if let Err(error) = syn::parse2::<syn::File>(output.clone()) {
        panic!("{error} in\n{output}");
    }
    output.to_string().contains("compile_error")
}
