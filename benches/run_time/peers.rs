//! What `peers/peers.py` measured of other people's solvers.

use std::error::Error;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::measure::{Errors, Line};

/// Adds the peers to each workload they were measured on. Their ratios are to the closed form in C of the same run; where there is
/// none, to the first contender here.
pub(crate) fn add(workloads: &mut [(&str, Vec<Line>)]) -> Result<(), Box<dyn Error>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers/results.json");
    let results: Value = serde_json::from_str(&fs::read_to_string(path)?)?;
    for (workload, lines) in workloads {
        let first = lines[0].time;
        for peer in results[&**workload].as_array().into_iter().flatten() {
            lines.push(line(peer, first).ok_or("a result of a peer is not complete")?);
        }
    }
    Ok(())
}

fn line(peer: &Value, first: f64) -> Option<Line> {
    let time = peer["time"].as_f64()?;
    Some(Line {
        name: peer["name"].as_str()?.to_owned(),
        tolerance: None,
        time,
        ratio: peer["ratio"].as_f64().unwrap_or(time / first),
        errors: Errors { position: peer["position"].as_f64()?, acceleration: peer["acceleration"].as_f64() },
    })
}
