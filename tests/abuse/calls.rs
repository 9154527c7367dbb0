//! Calls in any order with any arguments: each returns an error or a state that satisfies its equations.

use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::iter::Sum;

use reuleaux::nalgebra::SVector;
use reuleaux::{Enclosure, Equations, Failure, Family, Float, Mechanism, Stages, State};
use reuleaux_tests::common::twofold::Twofold;
use reuleaux_wide::{Lockstep, Wide};

use super::bytes::Bytes;
use super::judge::judge;

/// Beside parameters larger than this, others would be lost to rounding.
const LARGE: f64 = 1e6;

/// Number of calls per case.
const CALLS: usize = 4;

/// One state in this number is enclosed and polished, which takes longer than solving.
const PROOFS: usize = 16;

/// Outcomes of a case.
#[derive(Clone, Debug, Default)]
pub(crate) struct Count {
    /// Number of states found.
    pub found: usize,
    /// Number of failures.
    pub refused: usize,
    /// Calls with their outcomes.
    pub outcomes: BTreeSet<String>,
}

impl Sum for Count {
    fn sum<I: Iterator<Item = Self>>(counts: I) -> Self {
        counts.fold(Self::default(), |mut sum, count| {
            (sum.found, sum.refused) = (sum.found + count.found, sum.refused + count.refused);
            sum.outcomes.extend(count.outcomes);
            sum
        })
    }
}

impl Count {
    /// Records a call and its outcome, without numbers.
    fn note<T: std::fmt::Debug, const N: usize>(&mut self, call: &str, failure: Option<&Failure<T, N>>) {
        let letters = |text: String| text.chars().take_while(|letter| letter.is_alphanumeric() || *letter == '_').collect::<String>();
        let outcome = failure.map_or_else(|| "Ok".to_owned(), |failure| letters(format!("{:?}", failure.cause)));
        self.outcomes.insert(format!("{} {outcome}", letters(call.to_owned())));
    }
}

/// The mechanism with parameters read from the bytes.
fn with_parameters<M: Family<T, Over<T> = M>, T: Float>(defaults: &M, bytes: &mut Bytes<'_>) -> M {
    let bytes = RefCell::new(bytes);
    let is_default = bytes.borrow_mut().below(3) == 0;
    M::gather([defaults], |[value]: [T; 1]| {
        let mut bytes = bytes.borrow_mut();
        if is_default || bytes.below(3) > 0 { value } else { bytes.number(value) }
    })
}

/// The mechanism in 32 digits, and true if all parameters are of moderate size.
fn exactly<M: Family<T>, T: Float>(mechanism: &M) -> (M::Over<Twofold>, bool) {
    let is_moderate = Cell::new(true);
    let exact = M::gather([mechanism], |[value]: [T; 1]| {
        is_moderate.set(is_moderate.get() && value.to_f64().abs() < LARGE);
        Twofold::from(value.to_f64())
    });
    (exact, is_moderate.get())
}

/// A time, mostly of moderate size.
fn time<T: Float>(bytes: &mut Bytes<'_>) -> T {
    match bytes.below(6) {
        0 => T::of(0.0),
        1..=3 => T::of(bytes.share()),
        4 => T::of(0.01 * bytes.share()),
        _ => bytes.number(T::of(1.0)),
    }
}

fn vector<T: Float, const N: usize>(near: &SVector<T, N>, bytes: &mut Bytes<'_>) -> SVector<T, N> {
    let all = bytes.below(4);
    near.map(|entry| match all {
        0 => entry,
        1 => T::of(entry.to_f64() + 0.2 * bytes.share()),
        2 if !bytes.is_one_in(N.min(200)) => entry,
        _ => bytes.number(entry),
    })
}

/// A state: solved for these or other parameters, possibly modified afterwards, or not solved at all.
fn state<M, T: Float, const N: usize>(mechanism: &M, defaults: &M, bytes: &mut Bytes<'_>) -> State<T, N>
where
    M: Family<T, Over<T> = M> + Mechanism<T, N>,
{
    let nothing = SVector::from_element(T::of(0.0));
    let anything = |bytes: &mut Bytes<'_>| {
        let [q, qd, qdd] = [mechanism.start(), nothing, nothing].map(|near| vector(&near, bytes));
        State::new(time(bytes), q, qd, qdd)
    };
    let solved = match bytes.below(5) {
        0 => return anything(bytes),
        1 | 2 => mechanism.solve(T::of(0.0)),
        3 => defaults.solve(T::of(0.0)),
        _ => with_parameters(defaults, bytes).solve(T::of(0.0)),
    };
    let Ok(mut state) = solved else { return anything(bytes) };
    if bytes.is_one_in(3) {
        let part = bytes.below(6);
        match part {
            0 => state.q = vector(&state.q, bytes),
            1 => state.qd = vector(&state.qd, bytes),
            2 => state.qdd = vector(&state.qdd, bytes),
            3 => state.t = time(bytes),
            4 => state.condition = bytes.number(T::of(1.0)),
            _ => state.branch.iter_mut().for_each(|side| {
                if bytes.is_one_in(2) {
                    *side = reuleaux::DetSign::Negative;
                }
            }),
        }
    }
    state
}

/// Calls every function of one mechanism.
///
/// # Errors
/// The first state that does not satisfy its equations.
pub(crate) fn calls<M, T, const ROWS: usize, const N: usize>(defaults: &M, bytes: &mut Bytes<'_>, count: &mut Count) -> Result<(), String>
where
    T: Float,
    M: Family<T, Over<T> = M> + Mechanism<T, N> + std::fmt::Debug,
    M::Over<Twofold>: Equations<Twofold, ROWS, N>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    let mechanism = with_parameters(defaults, bytes);
    let (exact, is_moderate) = exactly(&mechanism);
    let mut seen = |what: &dyn Fn() -> String, found: &Result<State<T, N>, Failure<T, N>>| {
        count.note(&what(), found.as_ref().err());
        match found {
            Ok(state) => {
                count.found += 1;
                let wrong = |why: String| format!("{}: {why}\nof {mechanism:?}\n{state:?}", what());
                judge(&exact, is_moderate, M::ITERATED, state).map_err(wrong)?;
                if !count.found.is_multiple_of(PROOFS) {
                    return Ok(());
                }
                // An error bound or a proof may be refused; a polished state must still satisfy its equations.
                let (bound, proof) = (mechanism.error_bound(state), mechanism.certify(state));
                if proof.is_ok() && bound.is_err() {
                    return Err(wrong(format!("{proof:?}, but {bound:?}")));
                }
                let mut polished = state.clone();
                match mechanism.polish(&mut polished) {
                    Ok(()) => judge(&exact, is_moderate, M::ITERATED, &polished).map_err(|why| wrong(format!("polished: {why}"))),
                    Err(_) if format!("{polished:?}") == format!("{state:?}") => Ok(()),
                    Err(doubt) => Err(wrong(format!("{doubt}, but it was changed: {polished:?}"))),
                }
            }
            Err(failure) => {
                count.refused += 1;
                // Every failure has a message.
                let told = failure.to_string();
                if told.contains('`') { Ok(()) } else { Err(format!("{}: {told}", what())) }
            }
        }
    };
    for _ in 0..CALLS {
        if bytes.is_empty() {
            break;
        }
        match bytes.below(8) {
            0 => {
                let t = time(bytes);
                seen(&|| format!("solve({t:?})"), &mechanism.solve(t))?;
            }
            1 | 2 => {
                let (t, guess) = (time(bytes), vector(&mechanism.start(), bytes));
                seen(&|| format!("solve_near({t:?}, {guess:?})"), &mechanism.solve_near(t, &guess))?;
            }
            3 | 4 => {
                let (from, t) = (state(&mechanism, defaults, bytes), time(bytes));
                seen(&|| format!("solve_from({t:?}, {from:?})"), &mechanism.solve_from(t, &from))?;
            }
            5 | 6 => {
                let mut there = state(&mechanism, defaults, bytes);
                for _ in 0..1 + bytes.below(4) {
                    let (before, t) = (there.clone(), time(bytes));
                    let made = mechanism.advance(&mut there, t);
                    if made.is_err() && format!("{there:?}") != format!("{before:?}") {
                        return Err(format!("advance({t:?}) fails and leaves {there:?} of {before:?}"));
                    }
                    seen(&|| format!("advance({t:?}) from {before:?}"), &made.map(|()| there.clone()))?;
                }
            }
            _ => {
                let times: Vec<T> = (0..1 + bytes.below(5)).map(|_| time(bytes)).collect();
                for found in mechanism.sweep(times.iter().copied()) {
                    seen(&|| format!("sweep({times:?})"), &found)?;
                }
            }
        }
    }
    Ok(())
}

/// Advances several mechanisms together, any of which may have bad arguments.
///
/// # Errors
/// The first state that does not satisfy its equations.
pub(crate) fn lanes<M, W, const LANES: usize, const ROWS: usize, const N: usize>(
    defaults: &M,
    bytes: &mut Bytes<'_>,
    count: &mut Count,
) -> Result<(), String>
where
    W: Wide<LANES>,
    M: Family<W::Lane, Over<W::Lane> = M> + Mechanism<W::Lane, N> + std::fmt::Debug,
    M::Over<W>: Stages<W, N>,
    M::Over<Twofold>: Equations<Twofold, ROWS, N>,
{
    let each = [(); LANES].map(|()| with_parameters(defaults, bytes));
    let exact = each.each_ref().map(exactly);
    let shown = format!("{each:?}");
    let mut all = Lockstep::<M, W, LANES, N>::new(each, [(); LANES].map(|()| time(bytes)));
    for _ in 0..CALLS {
        for (lane, (exact, is_moderate)) in exact.iter().enumerate() {
            let found = all.lane(lane);
            count.note("lane", found.as_ref().err().copied());
            match found {
                Ok(state) => {
                    count.found += 1;
                    judge(exact, *is_moderate, M::ITERATED, &state).map_err(|why| format!("lane {lane}: {why}\nof {shown}\n{state:?}"))?;
                }
                Err(_) => count.refused += 1,
            }
        }
        let t: W::Lane = time(bytes);
        let is_one_time = bytes.below(3) > 0;
        let times = [(); LANES].map(|()| if is_one_time { t } else { time(bytes) });
        all.advance(times);
    }
    Ok(())
}
