//! All states of the references: errors over attainable ones, bounds over errors, certificates, polished states.

use std::fmt::Write as _;

use reuleaux::nalgebra::SVector;
use reuleaux::{Cause, Enclosure, Failure, Family, Mechanism, Stages, State};
use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::declared::{Declared, vector};
use reuleaux_tests::common::reference::{Value, decimals, file, list, number, numbers, text};
use reuleaux_tests::mechanisms::*;
use reuleaux_tests::stress::*;

/// 2⁻⁵³
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// What plain Newton and LU attain on the six mechanisms, relative to the largest entry, as the reference says.
const ATTAINED: [f64; 3] = [2e-15, 2e-15, 2e-14];

const KEYS: [&str; 3] = ["q", "qd", "qdd"];

/// The worst of a family.
struct Row {
    name: String,
    states: usize,
    condition: f64,
    /// Errors of q, q̇ and q̈ over attainable ones.
    shares: [f64; 3],
    /// The same of polished states, the worst of the three.
    polished: f64,
    /// The least and the greatest bound of an error over that error, of entries that are not nearly exact.
    bounds: (f64, f64),
    certified: usize,
    /// Refused as nearly singular.
    refused: usize,
}

/// The families as a table in Markdown.
pub(crate) fn table() -> String {
    let mut rows = vec![
        mechanism::<FourBarCrankRocker, _>("four_bar_crank_rocker"),
        mechanism::<SliderCrank, _>("slider_crank"),
        mechanism::<QuickReturn, _>("quick_return"),
        mechanism::<TheoJansenLeg, _>("theo_jansen_leg"),
        mechanism::<HydraulicLoader, _>("hydraulic_loader"),
        mechanism::<TwoStageGearTrain, _>("two_stage_gear_train"),
    ];
    rows.extend([
        family::<FourBar, _>("change_point", |_| true),
        family::<Dyad, _>("collinear_dyad", |_| true),
        family::<RockerDrivenFourBar, _>("dead_point", |_| true),
        family::<FourBar, _>("far_origin", |_| true),
        family::<FourBar, _>("many_turns", |_| true),
        family::<SmallAndLarge, _>("mixed_scales", |_| true),
        family::<Rail, _>("small_distance", |case| is_on(case, "rail")),
        family::<Arm, _>("small_distance", |case| is_on(case, "rocker")),
        family::<InLineSliderCrank, _>("unit_ratio", |_| true),
    ]);
    let mut table = String::from(
        "| family | states | worst condition | q | q̇ | q̈ | polished | bound over error | certified | nearly singular |\n\
         | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n",
    );
    for row in &rows {
        let Row { name, states, condition, shares: [q, qd, qdd], polished, bounds, certified, refused } = row;
        let bounds = if bounds.1 > 0.0 { format!("{:.2} to {:.2}", bounds.0, bounds.1) } else { String::new() };
        let _ = writeln!(
            table,
            "| {name} | {states} | {condition:.0e} | {q:.2} | {qd:.2} | {qdd:.2} | {polished:.2} | {bounds} | {certified} | {refused} |",
        );
    }
    table
}

/// Errors that are none: a number that is exactly zero is a sum of terms with 32 digits at most.
const LEAST: f64 = 1e-24;

fn is_on(case: &Value, model: &str) -> bool {
    text(&case["parameters"]["model"]) == model
}

impl Row {
    fn new(name: &str) -> Self {
        let name = name.replace('_', " ");
        Self { name, states: 0, condition: 1.0, shares: [0.0; 3], polished: 0.0, bounds: (f64::INFINITY, 0.0), certified: 0, refused: 0 }
    }

    /// Takes in a state, of which the reference and the attainable error are known by entry.
    ///
    /// * `constants`: given, what the constants of the mechanism may be off, relative to the largest entry: where the compiler has made
    ///   one of several, it is rounded once, and those of the reference are products of doubles.
    fn take<M, const N: usize>(
        &mut self,
        mechanism: &M,
        state: &State<f64, N>,
        reference: &Value,
        attainable: [Vec<f64>; 3],
        constants: f64,
    ) where
        M: Mechanism<f64, N> + Family<f64>,
        M::Over<Enclosure>: Stages<Enclosure, N>,
    {
        self.states += 1;
        self.condition = self.condition.max(state.condition);
        let bound = mechanism.error_bound(state).unwrap_or_else(|doubt| panic!("{}: {doubt}", self.name));
        self.certified += usize::from(mechanism.certify(state).is_ok());
        let mut polished = state.clone();
        let _ = mechanism.polish(&mut polished);
        let entries = |state: &State<f64, N>| [state.q, state.qd, state.qdd];
        for order in 0..3 {
            let exact = decimals(&reference[KEYS[order]]);
            let shares = |found: &SVector<f64, N>| share(found, &exact, &attainable[order]);
            self.shares[order] = self.shares[order].max(shares(&entries(state)[order]));
            self.polished = self.polished.max(shares(&entries(&polished)[order]));
            let bounds = [bound.q, bound.qd, bound.qdd][order];
            for i in 0..N {
                let error = exact[i].error_of(entries(state)[order][i]);
                let (digits, name) = ((1e-22 + constants) * largest(&exact), &self.name);
                assert!(error <= bounds[i] + digits, "{name}: an error of {error:e} beyond {:e}", bounds[i]);
                assert!(bounds[i] <= 1000.0 * error + attainable[order][i] + LEAST, "{name}: a bound of {:e} for {error:e}", bounds[i]);
                if error > LEAST + 0.2 * attainable[order][i] {
                    self.bounds = (self.bounds.0.min(bounds[i] / error), self.bounds.1.max(bounds[i] / error));
                }
            }
        }
    }
}

/// The largest error over the attainable one.
fn share<const N: usize>(found: &SVector<f64, N>, exact: &[Decimal], attainable: &[f64]) -> f64 {
    let shares = found.iter().zip(exact).zip(attainable).map(|((x, exact), attainable)| {
        let error = exact.error_of(*x);
        if error <= LEAST { 0.0 } else { error / attainable }
    });
    shares.fold(0.0, f64::max)
}

fn largest(entries: &[Decimal]) -> f64 {
    entries.iter().map(|entry| entry.value.abs()).fold(0.0, f64::max)
}

/// One of the six mechanisms, in a sweep over its cycle.
fn mechanism<M, const N: usize>(name: &str) -> Row
where
    M: Declared + Default + Mechanism<f64, N> + Family<f64>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    let (mechanism, file, mut row) = (M::default(), file(&format!("mechanisms/{name}.json")), Row::new(name));
    let states = list(&file["states"]);
    for (found, reference) in mechanism.sweep(states.iter().map(|state| number(&state["t"]))).zip(states) {
        let state = found.unwrap_or_else(|failure| panic!("{failure}"));
        let attainable = |order: usize| vec![ATTAINED[order] * largest(&decimals(&reference[KEYS[order]])); N];
        row.take(&mechanism, &state, reference, [0, 1, 2].map(attainable), ROUNDING);
    }
    row
}

/// A family of hard cases, each from the guess of its file.
fn family<M, const N: usize>(name: &str, is_meant: impl Fn(&Value) -> bool) -> Row
where
    M: Declared + Mechanism<f64, N> + Family<f64>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    let (file, mut row) = (file(&format!("stress/{name}.json")), Row::new(name));
    if let Some(model) = list(&file["cases"]).iter().find(|case| is_meant(case)).and_then(|case| case["parameters"]["model"].as_str()) {
        row.name = format!("{}, {model}", row.name);
    }
    for case in list(&file["cases"]).iter().filter(|case| is_meant(case)) {
        let mechanism = of::<M>(&case["model"]);
        match mechanism.solve_near(number(&case["t"]), &vector(&numbers(&case["initial_guess"]))) {
            Ok(state) => {
                let attainable = |order: usize| {
                    let at_rest = if order == 0 { 0.0 } else { 4.0 * ROUNDING * largest(&decimals(&case[KEYS[order]])) };
                    numbers(&case["attainable"][KEYS[order]]).iter().map(|entry| entry + at_rest).collect()
                };
                row.take(&mechanism, &state, case, [0, 1, 2].map(attainable), 0.0);
            }
            Err(Failure { cause: Cause::Singular { .. }, .. }) => row.refused += 1,
            Err(failure) => panic!("{name}: {failure}"),
        }
    }
    row
}
