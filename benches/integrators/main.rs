//! Integrators of other crates on Andrews' mechanism: `cargo run --release --manifest-path benches/integrators/Cargo.toml`.
//!
//! Out: for each method and error the run that reaches it with the fewest evaluations, at whatever tolerance: its time, and how often it computed
//! the accelerations, those for central differences included. `mechanism!` generates the accelerations for all. Errors are relative ones of the
//! angles at 0.03 s. Only our integrator brings the state back to where the loops close; the others drift, which counts in their errors.

use std::cell::Cell;
use std::error::Error;
use std::hint::black_box;

use differential_equations::prelude::{ExplicitRungeKutta, IVP, ImplicitRungeKutta, Matrix as Jacobian, ODE};
use diffsol::{NalgebraLU, NalgebraMat, NalgebraVec, OdeBuilder, OdeEquations, OdeSolverMethod};
use numeris::ode::{AdaptiveSettings, RKAdaptive, RKV98NoInterp, RODAS4, Rosenbrock};
use numeris::{Matrix, Vector};
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, SVector as Column, System};
use reuleaux::nalgebra::SVector;
use reuleaux::{Dynamics, Integrator, Method};
use reuleaux_benches::measured;
use reuleaux_benches::released::andrews::{Andrews, AndrewsState, DURATION, EXACT};

/// Entries of the state.
const N: usize = 21;
/// Integrated angles.
const I: usize = 7;
/// Angles and their rates.
const BOTH: usize = 2 * I;
/// Angles of which the exact values are known, as entries of the state.
const KNOWN: [usize; 4] = [2, 8, 14, 20];

const ERRORS: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// A method.
type Way = fn(&Motion, f64) -> Option<[f64; BOTH]>;

/// Methods by their crates.
const WAYS: [(&str, &str, Way); 10] = [
    ("reuleaux", "Dormand and Prince 8(5,3)", Motion::own),
    ("reuleaux", "RODAS 4(3)", Motion::own_stiff),
    ("ode_solvers 0.6.2", "Dormand and Prince 8(5,3)", Motion::ode_solvers),
    ("differential-equations 0.7.0", "Dormand and Prince 8(5,3)", Motion::differential_equations),
    ("differential-equations 0.7.0", "Radau IIA 5", Motion::radau),
    ("numeris 0.6.0", "Verner 9(8)", Motion::numeris),
    ("numeris 0.6.0", "RODAS 4(3)", Motion::numeris_stiff),
    ("diffsol 0.18.0", "Tsitouras 5(4)", Motion::diffsol),
    ("diffsol 0.18.0", "BDF", Motion::diffsol_bdf),
    ("diffsol 0.18.0", "ESDIRK 4(3)", Motion::diffsol_esdirk),
];

/// The motion as a system of first-order equations.
struct Motion {
    mechanism: Andrews,
    state: AndrewsState,
    start: [f64; BOTH],
    evaluations: Cell<usize>,
}

/// A run of a method.
struct Run {
    tolerance: f64,
    error: f64,
    evaluations: usize,
}

fn main() -> Result<(), Box<dyn Error>> {
    let motion = Motion::new()?;
    let runs = WAYS.map(|(_, _, way)| motion.runs(way));
    let picks: Vec<(usize, usize, &Run)> = (0..WAYS.len())
        .flat_map(|way| (0..ERRORS.len()).map(move |column| (way, column)))
        .filter_map(|(way, column)| Some((way, column, cheapest(&runs[way], ERRORS[column])?)))
        .collect();
    let call = |pick: &(usize, usize, &Run)| {
        let ((_, _, way), tolerance, motion) = (WAYS[pick.0], pick.2.tolerance, &motion);
        move || {
            black_box(way(motion, black_box(tolerance)));
        }
    };
    let mut calls: Vec<_> = picks.iter().map(call).collect();
    let mut calls: Vec<&mut dyn FnMut()> = calls.iter_mut().map(|call| call as &mut dyn FnMut()).collect();
    let times = measured(&mut calls, 1);
    println!("| | | {} |\n| --- | --- |{}", ERRORS.map(|error| format!("{error:e}")).join(" | "), " ---: |".repeat(ERRORS.len()));
    for (way, (name, method, _)) in WAYS.iter().enumerate() {
        let cell = |column: usize| {
            let at = picks.iter().position(|pick| (pick.0, pick.1) == (way, column));
            at.map_or(String::new(), |at| format!("{:.2} ms, {}", times[at] / 1e6, picks[at].2.evaluations))
        };
        println!("| {name} | {method} | {} |", [0, 1, 2, 3, 4].map(cell).join(" | "));
    }
    Ok(())
}

/// The run with the fewest evaluations that reaches an error.
fn cheapest(runs: &[Run], error: f64) -> Option<&Run> {
    runs.iter().filter(|run| run.error <= error).min_by_key(|run| run.evaluations)
}

/// The motion with derivatives along vectors, for implicit methods of diffsol. As a macro, since its type cannot be written.
macro_rules! implicit_problem {
    ($motion:ident, $tolerance:ident) => {
        OdeBuilder::<NalgebraMat<f64>>::new()
            .rtol($tolerance)
            .atol([$tolerance; BOTH])
            .rhs_implicit(
                |at, _, t, rates| rates.copy_from_slice(&$motion.rates(t, at)),
                |at, _, t, along, rates| rates.copy_from_slice(&$motion.along(t, at, along)),
            )
            .init(|_, _, start| start.copy_from_slice(&$motion.start), BOTH)
            .build()
            .ok()?
    };
}

impl Motion {
    fn new() -> Result<Self, Box<dyn Error>> {
        let mechanism = Andrews::default();
        let state = mechanism.initial_state()?;
        let start = picked(&mechanism, &state);
        Ok(Self { mechanism, state, start, evaluations: Cell::new(0) })
    }

    /// Runs of a method from coarse to fine.
    fn runs(&self, way: Way) -> Vec<Run> {
        let run = |halves: i32| {
            let tolerance = 10f64.powf(-f64::from(halves) / 2.0);
            self.evaluations.set(0);
            let end = way(self, tolerance)?;
            let places = indices(&self.mechanism);
            let off = |(entry, exact): (usize, f64)| {
                let at = places.iter().position(|place| *place == entry);
                at.map(|at| ((end[at] - exact) / exact).abs()).filter(|error| error.is_finite()).unwrap_or(f64::INFINITY)
            };
            let error = KNOWN.into_iter().zip(EXACT).map(off).fold(0.0, f64::max);
            Some(Run { tolerance, error, evaluations: self.evaluations.get() })
        };
        (4..=28).filter_map(run).collect()
    }

    /// Rates of angles and rates.
    fn rates(&self, t: f64, at: &[f64]) -> [f64; BOTH] {
        self.evaluations.set(self.evaluations.get() + 1);
        let (mut q, mut qd) = (SVector::<f64, N>::zeros(), SVector::<f64, N>::zeros());
        for (k, place) in indices(&self.mechanism).into_iter().enumerate() {
            (q[place], qd[place]) = (at[k], at[I + k]);
        }
        let accelerations = self.mechanism.accelerations(&q, &qd, t);
        std::array::from_fn(|k| if k < I { at[I + k] } else { accelerations.map_or(f64::NAN, |found| found[k - I]) })
    }

    /// Derivatives of rates by angles and rates, as central differences.
    fn derivatives(&self, t: f64, at: &[f64]) -> [[f64; BOTH]; BOTH] {
        let columns: [[f64; BOTH]; BOTH] = std::array::from_fn(|column| {
            let along: [f64; BOTH] = std::array::from_fn(|k| if k == column { 1.0 } else { 0.0 });
            self.along(t, at, &along)
        });
        std::array::from_fn(|row| std::array::from_fn(|column| columns[column][row]))
    }

    /// The derivative of the rates along a vector, as a central difference.
    fn along(&self, t: f64, at: &[f64], along: &[f64]) -> [f64; BOTH] {
        let size = along.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
        if size == 0.0 {
            return [0.0; BOTH];
        }
        let h = 1e-5 / size;
        let [ahead, behind] = [h, -h].map(|h| self.rates(t, &std::array::from_fn::<f64, BOTH, _>(|k| at[k] + h * along[k])));
        std::array::from_fn(|k| (ahead[k] - behind[k]) / (2.0 * h))
    }

    fn own(&self, tolerance: f64) -> Option<[f64; BOTH]> {
        self.followed(Integrator::new(tolerance))
    }

    fn own_stiff(&self, tolerance: f64) -> Option<[f64; BOTH]> {
        self.followed(Integrator::stiff(tolerance))
    }

    fn followed<K: Method>(&self, mut integrator: Integrator<f64, K>) -> Option<[f64; BOTH]> {
        let mut state = self.state.clone();
        self.mechanism.advance(&mut state, DURATION, &mut integrator).ok()?;
        self.evaluations.set(integrator.evaluations);
        Some(picked(&self.mechanism, &state))
    }

    fn ode_solvers(&self, tolerance: f64) -> Option<[f64; BOTH]> {
        let mut solver = Dop853::new(self, 0.0, DURATION, DURATION, Column::from(self.start), tolerance, tolerance);
        solver.set_output(OutputType::Sparse);
        solver.integrate().ok()?;
        solver.y_out().last().map(|end| (*end).into())
    }

    fn differential_equations(&self, tolerance: f64) -> Option<[f64; BOTH]> {
        let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(MOST);
        let solution = IVP::ode(self, 0.0, DURATION, self.start).method(method).solve().ok()?;
        solution.y.last().copied()
    }

    fn radau(&self, tolerance: f64) -> Option<[f64; BOTH]> {
        let method = ImplicitRungeKutta::radau5().rtol(tolerance).atol(tolerance).max_steps(MOST);
        let solution = IVP::ode(self, 0.0, DURATION, self.start).method(method).solve().ok()?;
        solution.y.last().copied()
    }

    fn numeris(&self, tolerance: f64) -> Option<[f64; BOTH]> {
        let rates = |t: f64, at: &Vector<f64, BOTH>| Vector::from_array(self.rates(t, at.as_slice()));
        let end = RKV98NoInterp::integrate(0.0, DURATION, &Vector::from_array(self.start), rates, &settings(tolerance)).ok()?;
        Some(std::array::from_fn(|k| end.y[k]))
    }

    fn numeris_stiff(&self, tolerance: f64) -> Option<[f64; BOTH]> {
        let rates = |t: f64, at: &Vector<f64, BOTH>| Vector::from_array(self.rates(t, at.as_slice()));
        let derivatives = |t: f64, at: &Vector<f64, BOTH>| Matrix::new(self.derivatives(t, at.as_slice()));
        let end = RODAS4::integrate(0.0, DURATION, &Vector::from_array(self.start), rates, derivatives, &settings(tolerance)).ok()?;
        Some(std::array::from_fn(|k| end.y[k]))
    }

    fn diffsol(&self, tolerance: f64) -> Option<[f64; BOTH]> {
        let problem = OdeBuilder::<NalgebraMat<f64>>::new()
            .rtol(tolerance)
            .atol([tolerance; BOTH])
            .rhs(|at, _, t, rates| rates.copy_from_slice(&self.rates(t, at)))
            .init(|_, _, start| start.copy_from_slice(&self.start), BOTH)
            .build()
            .ok()?;
        last(problem.tsit45().ok()?)
    }

    fn diffsol_bdf(&self, tolerance: f64) -> Option<[f64; BOTH]> {
        let problem = implicit_problem!(self, tolerance);
        last(problem.bdf::<NalgebraLU<f64>>().ok()?)
    }

    fn diffsol_esdirk(&self, tolerance: f64) -> Option<[f64; BOTH]> {
        let problem = implicit_problem!(self, tolerance);
        last(problem.esdirk34::<NalgebraLU<f64>>().ok()?)
    }
}

impl System<f64, Column<f64, BOTH>> for &Motion {
    fn system(&self, t: f64, at: &Column<f64, BOTH>, rates: &mut Column<f64, BOTH>) {
        *rates = self.rates(t, at.as_slice()).into();
    }
}

impl ODE<f64, [f64; BOTH]> for Motion {
    fn diff(&self, t: f64, at: &[f64; BOTH], rates: &mut [f64; BOTH]) {
        *rates = self.rates(t, at);
    }

    fn jacobian(&self, t: f64, at: &[f64; BOTH], derivatives: &mut Jacobian<f64>) {
        for (row, entries) in self.derivatives(t, at).iter().enumerate() {
            for (column, entry) in entries.iter().enumerate() {
                derivatives[(row, column)] = *entry;
            }
        }
    }
}

/// Steps at most.
const MOST: usize = 1_000_000;

fn settings(tolerance: f64) -> AdaptiveSettings<f64> {
    // Its shortest step, 1e-6 s unless set, is a matter of the units.
    AdaptiveSettings { abs_tol: tolerance, rel_tol: tolerance, min_step: 1e-12, max_steps: MOST, ..AdaptiveSettings::default() }
}

/// Entries of the state that are integrated.
fn indices<S: Dynamics<f64, N, I, M, R>, const M: usize, const R: usize>(_: &S) -> [usize; I] {
    S::INTEGRATED
}

/// Angles and rates in a state.
fn picked(mechanism: &Andrews, state: &AndrewsState) -> [f64; BOTH] {
    let places = indices(mechanism);
    std::array::from_fn(|k| if k < I { state.q[places[k]] } else { state.qd[places[k - I]] })
}

/// The end of a motion.
fn last<'a, E, S>(mut solver: S) -> Option<[f64; BOTH]>
where
    E: OdeEquations<T = f64, V = NalgebraVec<f64>> + 'a,
    S: OdeSolverMethod<'a, E>,
{
    solver.solve(DURATION).ok()?;
    let end = solver.state().y;
    Some(std::array::from_fn(|k| end[k]))
}
