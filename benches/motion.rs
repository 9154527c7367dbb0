//! Motions that follow from forces: `cargo run --release -p reuleaux-benches --bin motion`.
//!
//! Out: each mechanism at several tolerances: its error, its evaluations and its time; of Bricard's linkage and of a heavy top the same by
//! equations of motion written by hand, which the same integrator follows. `data` and `turns` are for `peers/space_forces.py`: the mechanisms
//! and our errors as JSON, and times of each mechanism named on standard input.

use std::error::Error;
use std::hint::black_box;
use std::rc::Rc;

use reuleaux::Integrator;
use reuleaux_benches::measured;
use reuleaux_benches::released::{andrews, bricard, chain, follow, four_bar, top};
use reuleaux_benches::served::{self, Way};
use serde_json::{Value, json};

/// All tolerances that peers are compared at.
const TOLERANCES: [f64; 8] = [1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12];

/// Who follows a motion.
const DECLARED: &str = "reuleaux";
const HAND: &str = "by hand";

/// A motion to its end with an integrator, and its error there.
type Run = Rc<dyn Fn(&mut Integrator) -> f64>;

/// A motion, by whom it is followed, and the same as data: exact numbers at the end and its duration among it.
struct Problem {
    name: &'static str,
    runs: Vec<(&'static str, Run)>,
    given: Value,
}

fn main() -> Result<(), Box<dyn Error>> {
    let problems = [of_andrews()?, of_four_bar()?, of_bricard()?, of_top()?];
    match std::env::args().nth(1).as_deref() {
        None => {
            tables(&problems);
            chains()?;
        }
        Some("data") => println!("{}", json!(problems.iter().map(described).collect::<Vec<_>>())),
        Some("turns") => served::serve(|name| problems.iter().find(|problem| problem.name == name).map(ways))?,
        Some(_) => return Err("there is `data` and `turns`".into()),
    }
    Ok(())
}

fn tables(problems: &[Problem]) {
    let [alone, beside] = [0, 1].map(|count: usize| problems.iter().filter(move |problem| (problem.runs.len() > 1) == (count == 1)));
    println!("| | tolerance | error | steps | evaluations | ms |\n| --- | ---: | ---: | ---: | ---: | ---: |");
    alone.for_each(print_alone);
    println!("\n| | | tolerance | error | steps | evaluations | ms | ratio |\n| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |");
    beside.for_each(print_beside);
}

fn print_alone(problem: &Problem) {
    let run = &problem.runs[0].1;
    for tolerance in TOLERANCES {
        let mut integrator = Integrator::new(tolerance);
        let error = run(&mut integrator);
        let mut again = || {
            black_box(run(&mut Integrator::new(black_box(tolerance))));
        };
        let time = measured(&mut [&mut again], 2)[0] / 1e6;
        let (steps, evaluations) = (integrator.accepted, integrator.evaluations);
        println!("| {} | {tolerance:e} | {error:.0e} | {steps} | {evaluations} | {time:.2} |", problem.name);
    }
}

fn print_beside(problem: &Problem) {
    let name = problem.name;
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let run = |way: &Run| {
            black_box(way(&mut Integrator::new(black_box(tolerance))));
        };
        let [mut by_hand, mut declared] = [0, 1].map(|who: usize| move || run(&problem.runs[who].1));
        let times = measured(&mut [&mut by_hand, &mut declared], 1);
        for ((who, way), time) in problem.runs.iter().zip(&times) {
            let mut integrator = Integrator::new(tolerance);
            let error = way(&mut integrator);
            assert!(error < tolerance, "{name}, {who}, {tolerance:e}: off by {error:e}");
            let (steps, evaluations, ms, ratio) = (integrator.accepted, integrator.evaluations, time / 1e6, time / times[0]);
            println!("| {name} | {who} | {tolerance:e} | {error:.0e} | {steps} | {evaluations} | {ms:.3} | {ratio:.2} |");
        }
    }
}

/// What a step of a long chain takes: all that a step does besides its twelve accelerations grows with the equations between coordinates.
fn chains() -> Result<(), Box<dyn Error>> {
    println!("\n| half a second at 1e-9 | steps | µs for each | drift of energy, J |\n| --- | ---: | ---: | ---: |");
    macro_rules! row {
        ($name:literal, $mechanism:expr) => {
            let mechanism = $mechanism;
            let start = mechanism.initial_state()?;
            let run = |integrator: &mut Integrator| {
                let mut state = start.clone();
                mechanism.advance(&mut state, 0.5, integrator).unwrap_or_else(|stopped| panic!("{stopped}"));
                let [before, after] = [&start, &state].map(|state| mechanism.energy(state)).map(|energy| energy.kinetic + energy.potential);
                (after - before).abs()
            };
            let mut integrator = Integrator::new(1e-9);
            let drift = run(&mut integrator);
            let mut again = || {
                black_box(run(&mut Integrator::new(black_box(1e-9))));
            };
            let steps = integrator.accepted;
            println!("| {} | {steps} | {:.1} | {drift:.0e} |", $name, measured(&mut [&mut again], 2)[0] / 1e3 / steps as f64);
        };
    }
    row!("a four-bar", chain::ChainOf1::default());
    row!("a chain of 10", chain::ChainOf10::default());
    row!("a chain of 40", chain::ChainOf40::default());
    Ok(())
}

/// The words for a contender at a tolerance.
fn called(who: &str, tolerance: f64) -> String {
    format!("{who}, {tolerance:e}")
}

fn described(problem: &Problem) -> Value {
    let pairs = problem.runs.iter().flat_map(|run| TOLERANCES.map(|tolerance| (run, tolerance)));
    let ours = pairs.map(|((who, run), tolerance)| {
        let mut integrator = Integrator::new(tolerance);
        let error = run(&mut integrator);
        json!({ "name": called(who, tolerance), "who": who, "tolerance": tolerance, "error": error })
    });
    json!({ "name": problem.name, "ours": ours.collect::<Vec<_>>(), "given": problem.given })
}

fn ways(problem: &Problem) -> Vec<Way> {
    let pairs = problem.runs.iter().flat_map(|run| TOLERANCES.map(|tolerance| (run, tolerance)));
    let way = |((who, run), tolerance): (&(&str, Run), f64)| {
        let run = Rc::clone(run);
        let run = move || {
            black_box(run(&mut Integrator::new(black_box(tolerance))));
        };
        Way { name: called(who, tolerance), steps: 1, run: Box::new(run) }
    };
    pairs.map(way).collect()
}

fn of_andrews() -> Result<Problem, Box<dyn Error>> {
    let mechanism = andrews::Andrews::default();
    let start = mechanism.initial_state()?;
    let declared: Run = Rc::new(move |integrator| {
        let mut state = start.clone();
        mechanism.advance(&mut state, andrews::DURATION, integrator).unwrap_or_else(|stopped| panic!("{stopped}"));
        let angles = [state.of(), state.bde(), state.ag(), state.ah()].map(|body| body.angle);
        angles.into_iter().zip(andrews::EXACT).map(|(found, exact)| ((found - exact) / exact).abs()).fold(0.0, f64::max)
    });
    let exact: Vec<(usize, f64)> = [0, 2, 3, 5].into_iter().zip(andrews::EXACT).collect();
    let given = json!({ "model": andrews::described(), "duration": andrews::DURATION, "relative": exact });
    Ok(Problem { name: "D1 Andrews", runs: vec![(DECLARED, declared)], given })
}

fn of_four_bar() -> Result<Problem, Box<dyn Error>> {
    let mechanism = four_bar::FourBar::default();
    let start = mechanism.initial_state()?;
    let declared: Run = Rc::new(move |integrator| {
        let mut state = start.clone();
        mechanism.advance(&mut state, four_bar::DURATION, integrator).unwrap_or_else(|stopped| panic!("{stopped}"));
        (state.crank().angle - four_bar::ANGLE).abs()
    });
    let given = json!({ "model": four_bar::model().described(), "duration": four_bar::DURATION, "absolute": [[0, four_bar::ANGLE]] });
    Ok(Problem { name: "D2 four-bar", runs: vec![(DECLARED, declared)], given })
}

fn of_bricard() -> Result<Problem, Box<dyn Error>> {
    let mechanism = bricard::Bricard::default();
    let start = mechanism.initial_state()?;
    let by_hand: Run = Rc::new(|integrator| {
        let mut state = bricard::ByHand::start();
        follow(&bricard::ByHand, &mut state, bricard::DURATION, integrator);
        (state.q[0] - bricard::ANGLE).abs()
    });
    let declared: Run = Rc::new(move |integrator| {
        let mut state = start.clone();
        mechanism.advance(&mut state, bricard::DURATION, integrator).unwrap_or_else(|stopped| panic!("{stopped}"));
        (mechanism.a(&state).value - bricard::ANGLE).abs()
    });
    let given = json!({ "model": bricard::described(), "duration": bricard::DURATION, "absolute": [[0, bricard::ANGLE]] });
    Ok(Problem { name: "D5 Bricard's linkage", runs: vec![(HAND, by_hand), (DECLARED, declared)], given })
}

fn of_top() -> Result<Problem, Box<dyn Error>> {
    let mechanism = top::Top::default();
    let start = mechanism.initial_state()?;
    let off = |q: [f64; 4]| top::center(q).iter().zip(top::CENTER).map(|(found, exact)| (found - exact).abs()).fold(0.0, f64::max);
    let by_hand: Run = Rc::new(move |integrator| {
        let mut state = top::ByHand::start();
        follow(&top::ByHand, &mut state, top::DURATION, integrator);
        off(state.q.into())
    });
    let declared: Run = Rc::new(move |integrator| {
        let mut state = start.clone();
        mechanism.advance(&mut state, top::DURATION, integrator).unwrap_or_else(|stopped| panic!("{stopped}"));
        off([3, 4, 5, 6].map(|k: usize| state.q[k]))
    });
    let start = [1.0, 0.0, 0.0, 0.0, 0.0, 150.0, -4.61538];
    let given = json!({ "numbers": top::NUMBERS, "start": start, "duration": top::DURATION, "center": top::CENTER });
    Ok(Problem { name: "D6 heavy top", runs: vec![(HAND, by_hand), (DECLARED, declared)], given })
}
