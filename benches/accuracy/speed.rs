//! Errors and times of a step, in single and double precision, and polished.

use std::hint::black_box;
use std::time::Instant;

use reuleaux::{Enclosure, Family, Float, Mechanism, Stages, State};
use reuleaux_tests::mechanisms::{FourBarCrankRocker, HydraulicLoader, TheoJansenLeg};
use reuleaux_tests::stress::Dyad;

/// Steps of a sweep, and how often it is timed.
const STEPS: usize = 1000;
const ROUNDS: usize = 15;

/// Measurements of one mechanism.
pub(crate) struct Panel {
    pub(crate) name: String,
    pub(crate) marks: Vec<Mark>,
}

/// One precision.
pub(crate) struct Mark {
    pub(crate) precision: Precision,
    /// ns per state.
    pub(crate) time: f64,
    /// Largest errors of q, q̇ and q̈ in the sweep, relative to the largest entry.
    pub(crate) errors: [f64; 3],
}

#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Precision {
    Single,
    Double,
    Polished,
}

/// All mechanisms of the picture.
pub(crate) fn panels() -> Vec<Panel> {
    let dyad = |gap: f64| Dyad { c0: 1.7 * (1.0 - gap), ..Dyad::default() };
    // Dyads are followed for a tenth of their gap.
    let on = |gap: f64| 0.17 * gap;
    vec![
        panel("four-bar", &FourBarCrankRocker::default(), Some(&FourBarCrankRocker::with_defaults()), 1.0),
        panel("Jansen's leg", &TheoJansenLeg::default(), Some(&TheoJansenLeg::with_defaults()), 1.0),
        panel("loader", &HydraulicLoader::default(), Some(&HydraulicLoader::with_defaults()), 1.0),
        panel("dyad, 1e-4 from its toggle", &dyad(1e-4), Some(&single(&dyad(1e-4))), on(1e-4)),
        panel("dyad, 1e-8 from its toggle", &dyad(1e-8), None::<&Dyad<f32>>, on(1e-8)),
        panel("dyad, 1e-12 from its toggle", &dyad(1e-12), None::<&Dyad<f32>>, on(1e-12)),
    ]
}

/// A dyad over `f32`.
fn single(dyad: &Dyad) -> Dyad<f32> {
    Dyad::gather([dyad], |[parameter]| parameter as f32)
}

/// One mechanism, in single precision where it moves at all.
fn panel<D, S, const N: usize>(name: &str, double: &D, single: Option<&S>, end: f64) -> Panel
where
    D: Mechanism<f64, N> + Family<f64>,
    D::Over<Enclosure>: Stages<Enclosure, N>,
    S: Mechanism<f32, N> + Family<f32>,
    S::Over<Enclosure>: Stages<Enclosure, N>,
{
    let mut marks = Vec::new();
    if let Some(single) = single {
        marks.push(mark(Precision::Single, single, end, |_| ()));
    }
    marks.push(mark(Precision::Double, double, end, |_| ()));
    marks.push(mark(Precision::Polished, double, end, |state| double.polish(state).expect("a state to polish")));
    Panel { name: name.to_owned(), marks }
}

fn mark<T, M, const N: usize>(precision: Precision, mechanism: &M, end: f64, finish: impl Fn(&mut State<T, N>)) -> Mark
where
    T: Float,
    M: Mechanism<T, N> + Family<T>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    let start = mechanism.solve(T::of(0.0)).unwrap_or_else(|failure| panic!("{failure}"));
    let steps = if precision == Precision::Polished { STEPS / 20 } else { STEPS };
    let sweep = |each: &mut dyn FnMut(&State<T, N>)| {
        let mut state = start.clone();
        for step in 1..=steps {
            let t = T::of(end * step as f64 / STEPS as f64);
            mechanism.advance(&mut state, t).unwrap_or_else(|failure| panic!("{failure}"));
            let mut finished = state.clone();
            finish(&mut finished);
            each(black_box(&finished));
        }
    };
    let mut errors = [0.0_f64; 3];
    sweep(&mut |state| {
        let bound = mechanism.error_bound(state).unwrap_or_else(|doubt| panic!("{doubt}"));
        for (error, (found, bound)) in errors.iter_mut().zip([(&state.q, &bound.q), (&state.qd, &bound.qd), (&state.qdd, &bound.qdd)]) {
            let most = |entries: &[T]| entries.iter().map(|entry| entry.to_f64().abs()).fold(0.0, f64::max);
            *error = error.max(most(bound.as_slice()) / most(found.as_slice()));
        }
    });
    let mut times: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let begin = Instant::now();
            sweep(&mut |_| ());
            begin.elapsed().as_secs_f64() * 1e9 / steps as f64
        })
        .collect();
    times.sort_by(f64::total_cmp);
    Mark { precision, time: times[ROUNDS / 2], errors }
}
