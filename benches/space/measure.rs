//! Times, errors and instructions of all contenders.

use std::error::Error;

use reuleaux_benches::multibody::Model;
use reuleaux_benches::multibody::exact::{Motion, Numbers};
use reuleaux_benches::served::{self, Way};
use reuleaux_benches::{instructions_of, times, turns};
use serde_json::{Map, Value, json};

use crate::Workload;
use crate::follower::{Entry, Follower, numbers};

/// Beyond this many bodies every twentieth step is compared only.
const MANY: usize = 30;

/// Largest errors of pose, velocities and accelerations in all steps, relative to the largest entry, which counts at least 1.
type Errors = [f64; 3];

/// Errors that nothing measured here may exceed: of pose (in m, entries of matrices), velocities (m/s, rad/s), accelerations (m/s², rad/s²).
const BOUNDS: Errors = [1e-14, 1e-13, 1e-12];

/// Prints the table, and fails if an error is too large.
pub(crate) fn print(workloads: &[Workload], rounds: usize) {
    println!("| | | time | ratio | pose | velocities | accelerations |\n| --- | --- | ---: | ---: | ---: | ---: | ---: |");
    for workload in workloads {
        let mut entries = (workload.contenders)();
        let exact = Exact::new(&workload.model);
        let errors: Vec<Errors> = entries.iter_mut().map(|entry| exact.errors(&mut *entry.follower)).collect();
        for (entry, errors) in entries.iter().zip(&errors) {
            let is_exact = errors.iter().zip(BOUNDS).all(|(error, bound)| *error < bound);
            assert!(is_exact, "{}, {}: {errors:?}", workload.model.name, entry.name);
        }
        let times = times();
        let mut ways: Vec<Box<dyn FnMut() + '_>> = Vec::new();
        for entry in &mut entries {
            let (follower, times) = (&mut entry.follower, &times);
            ways.push(Box::new(move || follower.sweep(times)));
        }
        let lines = turns(&mut ways, rounds);
        drop(ways);
        for ((entry, [pose, velocity, acceleration]), (time, ratio)) in entries.iter().zip(&errors).zip(lines) {
            let (name, time) = (&workload.model.name, time / times.len() as f64);
            println!("| {name} | {} | {time:.0} ns | {ratio:.2} | {pose:.0e} | {velocity:.0e} | {acceleration:.0e} |", entry.name);
        }
    }
}

/// All mechanisms with their exact motion, and the errors of our contenders.
pub(crate) fn data(workloads: &[Workload]) -> Value {
    let described = |workload: &Workload| {
        let exact = Exact::new(&workload.model);
        let errors = |mut entry: Entry| (entry.name.to_owned(), json!(exact.errors(&mut *entry.follower)));
        let errors: Map<String, Value> = (workload.contenders)().into_iter().map(errors).collect();
        let exact: Vec<Value> = exact.steps.iter().map(|(step, bodies)| json!([step, bodies.concat()])).collect();
        json!({ "model": workload.model.described(), "errors": errors, "exact": exact })
    };
    json!({ "times": times(), "workloads": workloads.iter().map(described).collect::<Vec<_>>() })
}

/// Times of a step, workload by workload as they are asked for.
pub(crate) fn serve(workloads: &[Workload]) -> Result<(), Box<dyn Error>> {
    let way = |mut entry: Entry| {
        let times = times();
        Way { name: entry.name.to_owned(), steps: times.len(), run: Box::new(move || entry.follower.sweep(&times)) }
    };
    served::serve(|name| {
        let workload = workloads.iter().find(|workload| workload.model.name == name)?;
        Some((workload.contenders)().into_iter().map(way).collect())
    })
}

/// Instructions of a step of each contender.
pub(crate) fn count(workloads: &[Workload]) -> Result<(), Box<dyn Error>> {
    println!("| | | instructions | ratio |\n| --- | --- | ---: | ---: |");
    for workload in workloads {
        let mut first = None;
        for entry in (workload.contenders)() {
            let name = &workload.model.name;
            let count = instructions_of(&["steps", name, entry.name])?;
            let ratio = count / *first.get_or_insert(count);
            println!("| {name} | {} | {count:.0} | {ratio:.2} |", entry.name);
        }
    }
    Ok(())
}

/// What runs when instructions are counted.
pub(crate) fn follow(workloads: &[Workload], [name, contender]: [&str; 2], steps: usize) -> Result<(), Box<dyn Error>> {
    let workload = workloads.iter().find(|workload| workload.model.name == name).ok_or("no such workload")?;
    let entries = (workload.contenders)();
    let mut entry = entries.into_iter().find(|entry| entry.name == contender).ok_or("no such contender")?;
    entry.follower.sweep(&times()[..steps]);
    Ok(())
}

/// The exact motion, at some steps.
struct Exact {
    steps: Vec<(usize, Vec<Numbers>)>,
}

impl Exact {
    fn new(model: &Model) -> Self {
        let every = if model.bodies.len() > MANY { 20 } else { 1 };
        let mut motion = Motion::new(model);
        motion.follow(0.0);
        let mut steps = Vec::new();
        for (number, &t) in times().iter().enumerate().skip(every - 1).step_by(every) {
            motion.follow(t);
            steps.push((number, motion.bodies()));
        }
        Self { steps }
    }

    fn errors(&self, follower: &mut dyn Follower) -> Errors {
        let (mut errors, mut largest) = ([0.0; 3], [1.0; 3]);
        let mut exact = self.steps.iter().peekable();
        follower.restart();
        for (number, &t) in times().iter().enumerate() {
            follower.step(t);
            let Some((_, bodies)) = exact.next_if(|(step, _)| *step == number) else { continue };
            for (found, exact) in follower.bodies().iter().map(numbers).zip(bodies) {
                for (k, (found, exact)) in found.iter().zip(exact).enumerate() {
                    let kind = usize::from(k >= 12) + usize::from(k >= 18);
                    errors[kind] = f64::max(errors[kind], (found - exact).abs());
                    largest[kind] = f64::max(largest[kind], exact.abs());
                }
            }
        }
        std::array::from_fn(|kind| errors[kind] / largest[kind])
    }
}
