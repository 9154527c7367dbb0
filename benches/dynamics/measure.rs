//! Times, errors and instructions of all contenders.

use std::cell::RefCell;
use std::error::Error;

use reuleaux_benches::multibody::forces::reaction;
use reuleaux_benches::served::{self, Way};
use reuleaux_benches::{instructions_of, turns};
use serde_json::{Map, Value, json};

use crate::case::{Case, Contender, Entry, Given};

/// Evaluations of one contender in one round.
const EVALUATIONS: usize = 2048;

/// Prints the table.
pub(crate) fn print(cases: impl Iterator<Item = Case>, rounds: usize) {
    println!("| | | time | ratio | error |\n| --- | --- | ---: | ---: | ---: |");
    for mut case in cases {
        let errors: Vec<Option<f64>> = case.entries.iter_mut().map(|entry| error(&mut *entry.contender, &case.exact)).collect();
        let mut ways: Vec<Box<dyn FnMut() + '_>> = Vec::new();
        for entry in &mut case.entries {
            let contender = &mut entry.contender;
            ways.push(Box::new(move || contender.evaluate(EVALUATIONS)));
        }
        let lines = turns(&mut ways, rounds);
        drop(ways);
        for ((entry, error), (time, ratio)) in case.entries.iter().zip(errors).zip(lines) {
            let error = error.map_or(String::new(), |error| format!("{error:.0e}"));
            println!("| {} | {} | {:.0} ns | {ratio:.2} | {error} |", case.name, entry.name, time / EVALUATIONS as f64);
        }
    }
}

/// The largest difference from the exact numbers; none if nothing was compared.
fn error(contender: &mut dyn Contender, exact: &[(usize, Vec<f64>)]) -> Option<f64> {
    let pairs = exact.iter().flat_map(|(state, exact)| contender.seen(*state).into_iter().zip(exact.iter()));
    pairs.map(|(found, exact)| (found - exact).abs()).reduce(f64::max)
}

/// Problems that others solve as well, with what is exact in some states, and the errors of our contenders.
pub(crate) fn data(cases: impl Iterator<Item = Case>) -> Value {
    let with_given = |mut case: Case| {
        let given = case.given.take()?;
        let errors = |entry: &mut Entry| (entry.name.to_owned(), json!(error(&mut *entry.contender, &case.exact)));
        let errors: Map<String, Value> = case.entries.iter_mut().map(errors).collect();
        Some(described(&case, &given, &errors))
    };
    json!(cases.filter_map(with_given).collect::<Vec<_>>())
}

fn described(case: &Case, given: &Given, errors: &Map<String, Value>) -> Value {
    let exact = case.exact.iter().map(|(state, _)| {
        let of = &given.states[*state];
        let driven: Vec<(usize, f64)> = of.get(2).into_iter().flatten().copied().enumerate().collect();
        let found = reaction(&given.model, &of[0], &of[1], &driven);
        json!({ "state": state, "accelerations": found.accelerations, "cuts": found.cuts, "efforts": found.efforts })
    });
    json!({ "name": case.name, "model": given.model.described(), "states": given.states, "exact": exact.collect::<Vec<_>>(), "errors": errors })
}

/// Times of an evaluation, problem by problem as they are asked for.
pub(crate) fn serve(cases: impl Iterator<Item = Case>) -> Result<(), Box<dyn Error>> {
    let way = |mut entry: Entry| Way {
        name: entry.name.to_owned(),
        steps: EVALUATIONS,
        run: Box::new(move || entry.contender.evaluate(EVALUATIONS)),
    };
    let cases = RefCell::new(cases.collect::<Vec<Case>>());
    served::serve(|name| {
        let mut cases = cases.borrow_mut();
        let place = cases.iter().position(|case| case.name == name)?;
        Some(cases.remove(place).entries.into_iter().map(way).collect())
    })
}

/// Instructions of an evaluation of each contender.
pub(crate) fn count(cases: impl Iterator<Item = Case>) -> Result<(), Box<dyn Error>> {
    println!("| | | instructions | ratio |\n| --- | --- | ---: | ---: |");
    for case in cases {
        let mut first = None;
        for entry in &case.entries {
            let count = instructions_of(&["steps", &case.name, entry.name])?;
            println!("| {} | {} | {count:.0} | {:.2} |", case.name, entry.name, count / *first.get_or_insert(count));
        }
    }
    Ok(())
}

/// What runs when instructions are counted.
pub(crate) fn evaluate(mut cases: impl Iterator<Item = Case>, [name, contender]: [&str; 2], count: usize) -> Result<(), Box<dyn Error>> {
    let case = cases.find(|case| case.name == name).ok_or("no such problem")?;
    let mut entry = case.entries.into_iter().find(|entry| entry.name == contender).ok_or("no such contender")?;
    entry.contender.evaluate(count);
    Ok(())
}
