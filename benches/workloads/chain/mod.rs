//! W4: a chain of N four-bars, all links 1. Ground pivots at (i, 0), couplers between neighbouring crank tips; the first crank
//! swings, φ = π/2 + 0.8 sin 2πt, and all stay parallelograms.

use super::{TOLERANCES, Workload, name};
use crate::contender::Entry;
use crate::hand::{Angles, Bar, Closed, Crank, Law, Pair, Point, Whole, dyad, fixed};
use crate::linkage::{Link, Linkage};

/// A chain as a mechanism.
macro_rules! chain {
    ($module:ident: $name:ident, $state:ident, $title:literal, $count:literal, absolute by $factor:tt) => {
        // One of them is a part of the interface.
        #[allow(unreachable_pub)]
        mod $module {
            reuleaux::mechanism! {
                /// W4: four-bars in a row.
                pub mechanism $name {
                    let n = $count;
                    ground { for i in 0..=n { point P[i] = (i * 1m, 0m); } }
                    for i in 0..=n {
                        body crank[i] { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
                        joint p[i] = revolute(ground.P[i], crank[i].O);
                    }
                    for i in 0..n {
                        body coupler[i] { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
                        joint a[i] = revolute(crank[i].A, coupler[i].A);
                        joint b[i] = revolute(coupler[i].B, crank[i + 1].A);
                    }
                    drive input = drive_angle(crank[0], 90deg + 0.8 * sin(2 * pi * t / 1s));
                    slice output tip = crank[n].A;
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
        }
    };
}

/// The contenders made from the declaration; with all coordinates at once only where that takes less than all day.
macro_rules! declared_by {
    (nothing, $name:ident, $state:ident) => {
        vec![
            crate::contender::Entry { name: crate::workloads::name::GENERATED, tolerance: None, contender: generated() },
            crate::workloads::alone!($name, solve_for_tip),
        ]
    };
    ($factor:ident, $name:ident, $state:ident) => {
        crate::workloads::declared!($name, $state, tip, solve_for_tip, $factor)
    };
}
use declared_by;

chain!(of_10: Chain10, Chain10State, "W4 chain of 10", 10, absolute by Static);
chain!(of_40: Chain40, Chain40State, "W4 chain of 40", 40, absolute by Dynamic);
chain!(of_160: Chain160, Chain160State, "W4 chain of 160", 160, absolute by nothing);
chain!(of_500: Chain500, Chain500State, "W4 chain of 500", 500, absolute by nothing);

pub use of_10::Chain10;

const CRANK: Crank = Crank { pivot: [0.0, 0.0], length: 1.0, law: Law::Swinging };

/// The chains.
pub(crate) fn workloads() -> Vec<Workload> {
    vec![of_10::workload(), of_40::workload(), of_160::workload(), of_500::workload()]
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
    // The first crank, then a coupler and a crank for each loop.
    let bars = (Bar::default(), [[Bar::default(); 2]; COUNT]);
    let whole = move |t, (first, rest): &mut (Bar, [[Bar; 2]; COUNT])| {
        first.angle = CRANK.angle(t);
        rest.iter_mut().zip(1..).fold(CRANK.pin_at(first.angle), |tip, ([coupler, crank], index)| {
            let (pivot, next) = (pivot(index), dyad(&tip, 1.0, &pivot(index), 1.0, 1.0));
            coupler.follow(&tip, &next);
            crank.follow(&pivot, &next);
            next
        })
    };
    let mut entries = vec![Entry::new(name::CLOSED, Closed::new(closed)), Entry::new(name::CLOSED_WHOLE, Whole::new(bars, whole))];
    entries.extend(Entry::each(name::ANGLES, &TOLERANCES, |tolerance| Angles::new(CRANK, pairs, tolerance, follow)));
    entries
}
