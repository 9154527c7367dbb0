//! Everything public under abuse: whatever is asked with whatever numbers, the answer is an error or a state, and a state fulfils its
//! equations as far as doubles can, recomputed with 32 digits.
//!
//! A case is made of bytes, and all of it follows from them: which mechanism, over which numbers, which parameters, states, guesses and
//! times, in which order. The usual run is short, and its
//! numbers are at most a hundred or no numbers; a long one, with any numbers, is
//!
//! ```text
//! REULEAUX_FUZZ_CASES=100000 cargo test --release -p reuleaux-tests --test abuse -- --nocapture
//! ```
//!
//! and `REULEAUX_FUZZ_SEED=17 REULEAUX_FUZZ_CASES=1` repeats the case 17.

mod bytes;
mod calls;
mod judge;
mod mechanisms;

use bytes::Bytes;
use calls::{Count, calls, lanes};
use mechanisms::{Bare, Coupled, Crank, Incline, Laws, Plate, Rod, Scene};
use reuleaux::wide::{f32x8, f64x4};

/// The first case of the usual run, and how many there are.
const USUAL: [u64; 2] = [880, 120];

/// The numbers of the usual run: what takes a million steps to refuse is left to long ones.
const LARGEST: f64 = 100.0;

/// What states of a hundred coordinates take without optimisation, several times.
const STACK: usize = 8 << 20;

/// Each mechanism, in doubles, in singles, and in lanes.
macro_rules! each {
    ($number:expr, $bytes:expr, $count:expr; $($name:ident: $rows:literal by $n:literal),* $(,)?) => {{
        let mut kind = $number;
        $(
            match kind {
                0 | 1 => return calls::<$name, f64, $rows, $n>(&$name::default(), $bytes, $count),
                2 => return calls::<$name<f32>, f32, $rows, $n>(&$name::with_defaults(), $bytes, $count),
                3 => return lanes::<$name, f64x4, 4, $rows, $n>(&$name::default(), $bytes, $count),
                4 => return lanes::<$name<f32>, f32x8, 8, $rows, $n>(&$name::with_defaults(), $bytes, $count),
                _ => kind -= 5,
            }
        )*
        let _ = kind;
    }};
}

/// A case, with numbers up to `largest`.
fn case(bytes: &[u8], largest: f64, count: &mut Count) -> Result<(), String> {
    let bytes = &mut Bytes::new(bytes, largest);
    let number = bytes.below(40);
    each!(number, bytes, count;
        Rod: 6 by 6, Bare: 6 by 6, Crank: 12 by 12, Incline: 9 by 9, Plate: 3 by 3, Laws: 9 by 9, Scene: 36 by 36, Coupled: 13 by 12);
    Ok(())
}

/// The bytes of a case.
fn random(seed: u64) -> Vec<u8> {
    let mut random = fastrand::Rng::with_seed(seed);
    (0..random.usize(8..200)).map(|_| random.u8(..)).collect()
}

/// On a thread with a small stack.
fn all(cases: Vec<(String, Vec<u8>)>, largest: f64) -> Count {
    let worker = std::thread::Builder::new().stack_size(STACK).spawn(move || {
        let mut count = Count::default();
        let mut wrong = Vec::new();
        for (name, bytes) in cases {
            if let Err(why) = case(&bytes, largest, &mut count) {
                wrong.push(format!("{name}: {why}"));
            }
        }
        assert!(wrong.is_empty(), "{} cases: {wrong:#?}", wrong.len());
        count
    });
    worker.expect("a thread can be started").join().expect("no case panics, and none is wrong")
}

#[test]
fn whatever_is_called_returns_a_state_or_an_error() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let cases: Option<u64> = number("REULEAUX_FUZZ_CASES");
    let largest = if cases.is_some() { f64::MAX } else { LARGEST };
    let (first, cases) = (number("REULEAUX_FUZZ_SEED").unwrap_or(USUAL[0]), cases.unwrap_or(USUAL[1]));
    let count = all((first..first + cases).map(|seed| (format!("seed {seed}"), random(seed))).collect(), largest);
    println!("{cases} cases from seed {first}: {count:?}");
    assert!(count.found >= count.refused || cases < 100, "{count:?}");
}
