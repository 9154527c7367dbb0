//! W4: a chain of N four-bars, all links 1. Ground pivots at (i, 0), couplers between neighbouring crank tips; the first crank
//! swings, φ = π/2 + 0.8 sin 2πt, and all stay parallelograms.

use super::{TOLERANCES, Workload, name};
use crate::contender::Entry;
use crate::hand::{Angles, Closed, Crank, Law, Pair, Point, dyad, fixed};
use crate::linkage::{Link, Linkage};

/// A chain as a mechanism. `links` holds for each four-bar: x of its left pivot, its left crank, its coupler, its right crank, x of
/// the right pivot, and names for its joints.
macro_rules! chain {
    (
        $name:ident, $state:ident, $title:literal, $count:literal, absolute by $factor:tt, first $first:ident, last $last:ident,
        $($left_x:tt $left:ident $coupler:ident $right:ident $right_x:tt $a:ident $b:ident $p:ident;)*
    ) => {
        reuleaux::mechanism! {
            mechanism $name {
                body $first { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; start position = (0m, 0m); }
                joint p0 = revolute((0m, 0m), $first.O);
                $(
                    body $coupler { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; start position = ($left_x, 1m); }
                    body $right { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; start position = ($right_x, 0m); }
                    joint $a = revolute($left.A, $coupler.A);
                    joint $b = revolute($coupler.B, $right.A);
                    joint $p = revolute(($right_x, 0m), $right.O);
                )*
                drive input = drive_angle($first, 90deg + 0.8 * sin(2 * pi * t / 1s));
                output tip = $last.A;
            }
        }
        crate::workloads::generated!($name, $state, tip);

        pub(super) fn workload() -> crate::workloads::Workload {
            crate::workloads::Workload { linkage: super::linkage($title, $count), generated, plan, contenders }
        }

        fn contenders(linkage: &crate::linkage::Linkage) -> Vec<crate::contender::Entry> {
            let mut entries = super::by_hand::<$count>(linkage);
            entries.extend(super::declared_by!($factor, $name, $state));
            entries.extend(crate::workloads::sketch(linkage));
            entries
        }
    };
}

/// The contenders made from the declaration; with all coordinates at once only where that takes less than all day.
macro_rules! declared_by {
    (nothing, $name:ident, $state:ident) => {
        [crate::contender::Entry { name: crate::workloads::name::GENERATED, tolerance: None, contender: generated() }]
    };
    ($factor:ident, $name:ident, $state:ident) => {
        crate::workloads::declared!($name, $state, tip, $factor)
    };
}
use declared_by;

mod of_10 {
    include!("of_10.rs");
}

#[cfg(feature = "chain_of_40")]
mod of_40 {
    include!("of_40.rs");
}

#[cfg(feature = "chain_of_160")]
mod of_160 {
    include!("of_160.rs");
}

#[cfg(feature = "chain_of_500")]
mod of_500 {
    include!("of_500.rs");
}

const CRANK: Crank = Crank { pivot: [0.0, 0.0], length: 1.0, law: Law::Swinging };

/// The chains that were asked for.
pub(crate) fn workloads() -> Vec<Workload> {
    vec![
        of_10::workload(),
        #[cfg(feature = "chain_of_40")]
        of_40::workload(),
        #[cfg(feature = "chain_of_160")]
        of_160::workload(),
        #[cfg(feature = "chain_of_500")]
        of_500::workload(),
    ]
}

fn linkage(name: &'static str, count: usize) -> Linkage {
    let mut points: Vec<[f64; 2]> = (0..=count).map(|pivot| [pivot as f64, 0.0]).collect();
    points.push(CRANK.pin(0.0).p.into());
    let crank_pin = count + 1;
    let mut linkage = Linkage {
        name,
        points,
        fixed: count + 1,
        crank: CRANK,
        crank_ends: [0, crank_pin],
        links: Vec::new(),
        slider: None,
        order: Vec::new(),
        tracked: crank_pin + count,
        size: 1.0,
    };
    for pivot in 1..=count {
        let tip = linkage.hang((crank_pin + pivot - 1, 1.0), (pivot, 1.0), 1.0);
        linkage.links.extend([Link::bar(tip - 1, tip, 1.0), Link::bar(pivot, tip, 1.0)]);
    }
    linkage
}

/// Dyads, and pairs of angles, one after the other along the chain.
fn by_hand<const COUNT: usize>(linkage: &Linkage) -> Vec<Entry> {
    let pivot = |index: usize| fixed(index as f64, 0.0);
    let closed = move |t| (1..=COUNT).fold(CRANK.pin(t), |tip, index| dyad(&tip, 1.0, &pivot(index), 1.0, 1.0));
    let pairs: [Pair; COUNT] = std::array::from_fn(|index| {
        let [tip, next] = [1, 2].map(|tip| linkage.points[COUNT + index + tip]);
        Pair::meeting(tip, linkage.points[index + 1], next)
    });
    let follow = move |pairs: &mut [Pair; COUNT], pin: &Point, h, tolerance| {
        pairs.iter_mut().zip(1..).fold(*pin, |tip, (pair, index)| pair.close((&tip, 1.0), (&pivot(index), 1.0), h, tolerance))
    };
    let mut entries = vec![Entry::new(name::CLOSED, Closed::new(closed))];
    entries.extend(Entry::each(name::ANGLES, &TOLERANCES, |tolerance| Angles::new(CRANK, pairs, tolerance, follow)));
    entries
}
