//! Our side of a measurement that another program leads, so that its contenders and ours have their turns in the same rounds.

use std::collections::BTreeMap;
use std::error::Error;
use std::time::Instant;

use serde_json::{Value, json};

/// Something that is measured.
pub struct Way {
    /// Who does it.
    pub name: String,
    /// By how many the time of a call is divided.
    pub steps: usize,
    /// One call.
    pub run: Box<dyn FnMut()>,
}

/// Answers each line of standard input, which names a problem, by the nanoseconds per step of all its ways in turn: a list of
/// names and numbers on one line.
/// `ways` makes the ways of a problem, once.
///
/// # Errors
/// If there is no such problem, and if nobody listens.
pub fn serve(ways: impl Fn(&str) -> Option<Vec<Way>>) -> Result<(), Box<dyn Error>> {
    let mut known: BTreeMap<String, Vec<Way>> = BTreeMap::new();
    for line in std::io::stdin().lines() {
        let line = line?;
        if !known.contains_key(&line) {
            let made = ways(&line).ok_or_else(|| format!("there is no problem `{line}`"))?;
            known.insert(line.clone(), made);
        }
        let times: Vec<Value> = known.get_mut(&line).into_iter().flatten().map(timed).collect();
        println!("{}", Value::Array(times));
    }
    Ok(())
}

/// The first call warms the caches, which others have filled since the last turn.
fn timed(way: &mut Way) -> Value {
    (way.run)();
    let begin = Instant::now();
    (way.run)();
    json!([way.name, begin.elapsed().as_nanos() as f64 / way.steps as f64])
}
