//! Measured programs are right: contenders go where the exact motion goes, and workloads have the blocks they are there for.

use crate::workloads::{Workload, name};
use crate::{exact, times, workloads};
use reuleaux_tests::samples;

/// Beyond this many links only generated ones are followed: a dense matrix takes minutes without optimisation.
const LINKS: usize = 40;

#[test]
fn contenders_are_where_the_exact_motion_is() {
    std::thread::scope(|scope| {
        for workload in workloads::all() {
            // Without optimisation every call has copies of its own of a state of 1503 coordinates.
            let thread = std::thread::Builder::new().stack_size(64 << 20).spawn_scoped(scope, move || agree(&workload));
            thread.expect("a thread");
        }
    });
}

fn agree(workload: &Workload) {
    let large = workload.linkage.links.len() > LINKS;
    let times = &times()[..if large { samples(3, 50) } else { samples(12, 50) }];
    let exact = exact::motion(&workload.linkage, times);
    for mut entry in (workload.contenders)(&workload.linkage) {
        if large && !entry.name.starts_with(name::GENERATED) {
            continue;
        }
        entry.contender.sweep(times);
        let (seen, exact) = (entry.contender.seen(), exact[times.len() - 1]);
        let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        // A residual is worth several times as much of a position, and a position dozens of times as much of an acceleration.
        let allowed = 1e-12 + 10.0 * entry.tolerance.unwrap_or(0.0);
        let who = format!("{}, {}, {:?}", workload.linkage.name, entry.name, entry.tolerance);
        assert!(distance(seen.place, exact.place) < allowed, "{who}: {seen:?} is not {exact:?}");
        if let (Some(seen), Some(exact)) = (seen.acceleration, exact.acceleration) {
            assert!(distance(seen, exact) < 1e3 * allowed, "{who}: {seen:?} is not {exact:?}");
        }
    }
}

#[test]
fn last_two_workloads_do_not_fall_apart() {
    let blocks: Vec<Vec<usize>> = workloads::all().iter().map(|workload| (workload.plan)().blocks().collect()).collect();
    assert_eq!(blocks[..3], [vec![2], vec![1], vec![2, 2, 2]]);
    assert_eq!(blocks[blocks.len() - 2..], [vec![4], vec![12]]);
}
