//! s
mod common;
use common::four_bar::CRANK_ROCKER;
use common::reference::THEO_JANSEN_LEG;
use reuleaux::Mechanism;
#[test]
fn speed() {
    let n = 100000;
    let t = std::time::Instant::now();
    let mut s = 0.0;
    for st in CRANK_ROCKER.sweep((0..n).map(|k| k as f64 / 1000.0)) {
        s += st.unwrap().q[5];
    }
    println!("four-bar {s} {:?}/step", t.elapsed() / n);
    let n = 1000;
    let t = std::time::Instant::now();
    for st in THEO_JANSEN_LEG.sweep((0..n).map(|k| k as f64 / 1000.0)) {
        s += st.unwrap().iterations as f64;
    }
    println!("jansen jets {s} {:?}/step", t.elapsed() / n);
}
