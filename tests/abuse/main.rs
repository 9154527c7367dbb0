//! The public interface under abuse: for any call with any numbers the result is an error or a state, and a state satisfies its equations
//! to rounding in doubles, verified with 32 digits.
//!
//! Bytes determine a case entirely: mechanism, number type, parameters, states, guesses, times, and the order of calls. The usual run has
//! a tenth of the cases of `corpus.txt`, which together cover every outcome ever seen of each call for each mechanism; `.ci/run` has all of them. Both
//! have some random cases, with numbers up to a hundred or not finite. A long run, with any numbers, is
//!
//! ```text
//! REULEAUX_FUZZ_CASES=100000 cargo test --release -p reuleaux-tests --test abuse -- --nocapture
//! ```
//!
//! and `REULEAUX_FUZZ_SEED=17 REULEAUX_FUZZ_CASES=1` repeats case 17. With `REULEAUX_FUZZ_KEEP=1`, cases with new outcomes are added to
//! the corpus.

mod bytes;
mod calls;
mod judge;
mod mechanisms;

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use bytes::Bytes;
use calls::{Count, calls, lanes};
use mechanisms::{Bare, Coupled, Crank, Incline, Laws, Plate, Rod, Scene};
use reuleaux_tests::samples;
use reuleaux_wide::{F32x8, F64x4};

/// First random case of the usual run, and the number of cases.
const USUAL: [u64; 2] = [880, 120];

/// Largest number in the usual run; larger ones may take a million steps to refuse and are left to long runs.
const LARGEST: f64 = 100.0;

/// Stack for several copies of states of a hundred coordinates without optimisation.
const STACK: usize = 8 << 20;

/// Runs a mechanism by its number, in doubles, in singles, and in lanes.
macro_rules! each {
    ($number:expr, $bytes:expr, $count:expr; $($name:ident: $rows:literal by $n:literal),* $(,)?) => {{
        let mut kind = $number;
        $(
            match kind {
                0 | 1 => return calls::<$name, f64, $rows, $n>(&$name::default(), $bytes, $count),
                2 => return calls::<$name<f32>, f32, $rows, $n>(&$name::with_defaults(), $bytes, $count),
                3 => return lanes::<$name, F64x4, 4, $rows, $n>(&$name::default(), $bytes, $count),
                4 => return lanes::<$name<f32>, F32x8, 8, $rows, $n>(&$name::with_defaults(), $bytes, $count),
                _ => kind -= 5,
            }
        )*
        let _ = kind;
    }};
}

/// Runs a case, with numbers up to `largest`.
fn case(bytes: &[u8], largest: f64, count: &mut Count) -> Result<(), String> {
    let bytes = &mut Bytes::new(bytes, largest);
    let number = bytes.below(40);
    each!(number, bytes, count;
        Rod: 6 by 6, Bare: 6 by 6, Crank: 12 by 12, Incline: 9 by 9, Plate: 3 by 3, Laws: 9 by 9, Scene: 36 by 36, Coupled: 13 by 12);
    Ok(())
}

/// Kept cases: the bytes of one case per line.
const CORPUS: &str = include_str!("corpus.txt");

/// Path of the corpus.
const CORPUS_FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/abuse/corpus.txt");

/// Longest time of a kept case, with optimisation.
const PATIENCE: Duration = Duration::from_millis(5);

/// The cases of the corpus.
fn kept() -> Vec<(String, Vec<u8>)> {
    let byte = |digits: &[u8]| u8::from_str_radix(std::str::from_utf8(digits).expect("two digits"), 16).expect("a byte");
    let case = |(number, line): (usize, &str)| (format!("corpus, line {}", number + 1), line.as_bytes().chunks(2).map(byte).collect());
    CORPUS.lines().enumerate().map(case).collect()
}

/// Adds random cases with new outcomes to the corpus.
fn keep(cases: &[(String, Vec<u8>)]) {
    let mut corpus = CORPUS.to_owned();
    let mut seen = BTreeSet::new();
    let mut is_new = |bytes: &[u8]| {
        let (mut count, begin) = (Count::default(), Instant::now());
        case(bytes, f64::MAX, &mut count).expect("a case that is right");
        let which = bytes.first().copied().unwrap_or(0) % 40;
        let is_quick = begin.elapsed() < PATIENCE;
        is_quick && count.outcomes.into_iter().filter(|outcome| seen.insert((which, outcome.clone()))).count() > 0
    };
    kept().iter().for_each(|(_, bytes)| {
        is_new(bytes);
    });
    for (_, bytes) in cases.iter().filter(|(_, bytes)| is_new(bytes)) {
        corpus.extend(bytes.iter().map(|byte| format!("{byte:02x}")).chain(["\n".to_owned()]));
    }
    std::fs::write(CORPUS_FILE, corpus).expect("the corpus can be written");
}

/// The bytes of a random case.
fn random(seed: u64) -> Vec<u8> {
    let mut random = fastrand::Rng::with_seed(seed);
    (0..random.usize(8..200)).map(|_| random.u8(..)).collect()
}

/// Runs all cases, on a thread with a small stack for each processor, which takes the next case when it is done with one.
fn all(cases: &[(String, Vec<u8>)], largest: f64) -> Count {
    let next = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        let start = |_| {
            let worker = std::thread::Builder::new().stack_size(STACK);
            let cases = std::iter::from_fn(|| cases.get(next.fetch_add(1, Ordering::Relaxed)));
            worker.spawn_scoped(scope, move || run(cases, largest)).expect("a thread can be started")
        };
        let workers: Vec<_> = (0..std::thread::available_parallelism().map_or(1, usize::from)).map(start).collect();
        workers.into_iter().map(|worker| worker.join().expect("no case panics, and none is wrong")).sum()
    })
}

/// Runs cases one after the other.
fn run<'c>(cases: impl Iterator<Item = &'c (String, Vec<u8>)>, largest: f64) -> Count {
    let mut count = Count::default();
    let mut wrong = Vec::new();
    for (name, bytes) in cases {
        if let Err(why) = case(bytes, largest, &mut count) {
            wrong.push(format!("{name}: {why}"));
        }
    }
    assert!(wrong.is_empty(), "{} cases: {wrong:#?}", wrong.len());
    count
}

#[test]
fn kept_cases_return_states_or_errors() {
    let kept: Vec<_> = kept().into_iter().step_by(samples(10, 1)).collect();
    let count = all(&kept, f64::MAX);
    assert!(count.outcomes.len() > samples(10, 20), "{count:?}");
}

#[test]
fn whatever_is_called_returns_a_state_or_an_error() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let cases: Option<u64> = number("REULEAUX_FUZZ_CASES");
    let largest = if cases.is_some() { f64::MAX } else { LARGEST };
    let (first, cases) = (number("REULEAUX_FUZZ_SEED").unwrap_or(USUAL[0]), cases.unwrap_or(USUAL[1]));
    let random: Vec<_> = (first..first + cases).map(|seed| (format!("seed {seed}"), random(seed))).collect();
    if std::env::var_os("REULEAUX_FUZZ_KEEP").is_some() {
        keep(&random);
    }
    let count = all(&random, largest);
    println!("{cases} cases from seed {first}: {count:?}");
    assert!(count.found >= count.refused || cases < 100, "{count:?}");
}
