//! The linkages as JSON, with the exact motion of their tracked points: `cargo run --release -p reuleaux-benches --bin linkages`.
//!
//! In: nothing. Out: what `peers/peers.py` reads, so that all contenders have the same data. Lengths in m, times in s.

use reuleaux_benches::contender::Seen;
use reuleaux_benches::hand::Law;
use reuleaux_benches::linkage::{Link, Linkage};
use reuleaux_benches::{exact, times, workloads};
use serde_json::{Value, json};

fn main() {
    let linkages: Vec<Value> = workloads::all().iter().map(|workload| described(&workload.linkage)).collect();
    println!("{}", json!({ "times": times(), "linkages": linkages }));
}

fn described(linkage: &Linkage) -> Value {
    let exact = exact::motion(linkage, &times());
    let places: Vec<[f64; 2]> = exact.iter().map(|Seen { place, .. }| *place).collect();
    let accelerations: Vec<Option<[f64; 2]>> = exact.iter().map(|Seen { acceleration, .. }| *acceleration).collect();
    json!({
        "name": linkage.name,
        "size": linkage.size,
        "points": linkage.points,
        "fixed": linkage.fixed,
        "crank": {
            "ends": linkage.crank_ends,
            "length": linkage.crank.length,
            "law": if linkage.crank.law == Law::Turning { "turning" } else { "swinging" },
        },
        "links": linkage.links.iter().map(Link::local).collect::<Vec<_>>(),
        "bars": linkage.bars(),
        "slider": linkage.slider,
        "order": linkage.order,
        "tracked": linkage.tracked,
        "places": places,
        "accelerations": accelerations,
    })
}
