//! A ring of six bars on six legs, the pivot of one of which goes round on a crank: no part of it stands before all of it does,
//! and twelve angles are found together.

use reuleaux::mechanism;
use reuleaux::nalgebra::SVector;

use super::{TOLERANCES, Workload, declared, generated, name, sketch};
use crate::contender::Entry;
use crate::hand::{Angles, Crank, Law, Loops, Point, Term, fixed};
use crate::linkage::{Link, Linkage};

mechanism! {
    mechanism Hexagon {
        ground {
            point O = (1.5m, 1m); point G1 = (0.5m, 3.5m); point G2 = (-2m, 2m);
            point G3 = (-2m, -1.5m); point G4 = (0m, -3m); point G5 = (2m, -1m);
        }
        body crank { point O = (0m, 0m); point G0 = (0.5m, 0m); }
        body leg_0 { point G = (0m, 0m); point N = (1.1m, 0m); start position = (2m, 1m); start angle = -134.5deg; }
        body leg_1 { point G = (0m, 0m); point N = (2.65m, 0m); start angle = -90.9deg; }
        body leg_2 { point G = (0m, 0m); point N = (1.75m, 0m); start angle = -36.1deg; }
        body leg_3 { point G = (0m, 0m); point N = (1.9m, 0m); start angle = 52.1deg; }
        body leg_4 { point G = (0m, 0m); point N = (2.25m, 0m); start angle = 99.9deg; }
        body leg_5 { point G = (0m, 0m); point N = (1.45m, 0m); start angle = 165deg; }
        body ring_0 { point A = (0m, 0m); point B = (1m, 0m); start position = (1.22923m, 0.2152m); start angle = 140.6deg; }
        body ring_1 { point A = (0m, 0m); point B = (1.05m, 0m); start position = (0.45684m, 0.85035m); start angle = 173.6deg; }
        body ring_2 { point A = (0m, 0m); point B = (1m, 0m); start position = (-0.58653m, 0.96821m); start angle = -104.2deg; }
        body ring_3 { point A = (0m, 0m); point B = (0.9m, 0m); start position = (-0.8324m, -0.0011m); start angle = -60.4deg; }
        body ring_4 { point A = (0m, 0m); point B = (1m, 0m); start position = (-0.38795m, -0.7837m); start angle = 9.1deg; }
        body ring_5 { point A = (0m, 0m); point B = (1.05m, 0m); start position = (0.59936m, -0.6249m); start angle = 53.1deg; }
        joint o = revolute(ground.O, crank.O);
        joint g0 = revolute(crank.G0, leg_0.G);
        joint g1 = revolute(ground.G1, leg_1.G);
        joint g2 = revolute(ground.G2, leg_2.G);
        joint g3 = revolute(ground.G3, leg_3.G);
        joint g4 = revolute(ground.G4, leg_4.G);
        joint g5 = revolute(ground.G5, leg_5.G);
        joint a0 = revolute(leg_0.N, ring_0.A);
        joint b0 = revolute(ring_0.B, leg_1.N);
        joint a1 = revolute(leg_1.N, ring_1.A);
        joint b1 = revolute(ring_1.B, leg_2.N);
        joint a2 = revolute(leg_2.N, ring_2.A);
        joint b2 = revolute(ring_2.B, leg_3.N);
        joint a3 = revolute(leg_3.N, ring_3.A);
        joint b3 = revolute(ring_3.B, leg_4.N);
        joint a4 = revolute(leg_4.N, ring_4.A);
        joint b4 = revolute(ring_4.B, leg_5.N);
        joint a5 = revolute(leg_5.N, ring_5.A);
        joint b5 = revolute(ring_5.B, leg_0.N);
        drive input = drive_angle(crank, 1turn * t / 1s);
        slice output pin = leg_3.N;
    }
}
generated!(Hexagon, HexagonState, pin);

const CRANK: Crank = Crank { pivot: [1.5, 1.0], length: 0.5, law: Law::Turning };
/// Pivots of the legs, the crank pin first.
const PIVOTS: [[f64; 2]; 6] = [[2.0, 1.0], [0.5, 3.5], [-2.0, 2.0], [-2.0, -1.5], [0.0, -3.0], [2.0, -1.0]];
/// Lengths of the legs.
const LEGS: [f64; 6] = [1.1, 2.65, 1.75, 1.9, 2.25, 1.45];
/// Lengths of the bars of the ring, from each node to the next.
const RING: [f64; 6] = [1.0, 1.05, 1.0, 0.9, 1.0, 1.05];
/// The nodes at t = 0, nearly.
const NODES: [[f64; 2]; 6] =
    [[1.22923, 0.2152], [0.45684, 0.85035], [-0.58653, 0.96821], [-0.8324, -0.0011], [-0.38795, -0.7837], [0.59936, -0.6249]];
/// The node that is tracked, across from the crank.
const TRACKED: usize = 3;

pub(crate) fn workload() -> Workload {
    // The crank's pivot, the pivots, the crank pin, the nodes.
    let mut points = vec![CRANK.pivot];
    points.extend(PIVOTS[1..].iter().chain([&PIVOTS[0]]).chain(&NODES));
    let (pivot, node) = (|leg: usize| if leg == 0 { 6 } else { leg }, |leg: usize| 7 + leg % 6);
    let legs = (0..6).map(|leg| Link::bar(pivot(leg), node(leg), LEGS[leg]));
    let ring = (0..6).map(|bar| Link::bar(node(bar), node(bar + 1), RING[bar]));
    let linkage = Linkage {
        name: "ring, one block of 12",
        points,
        fixed: 6,
        crank: CRANK,
        crank_ends: [0, 6],
        links: legs.chain(ring).collect(),
        slider: None,
        order: vec![(0..6).map(node).collect()],
        tracked: node(TRACKED),
        size: 6.5,
    };
    Workload { linkage, generated, plan, contenders }
}

/// Loop k goes from pivot k along its leg and the bar to the next node, and back down the next leg: pivot k + leg k + bar k −
/// leg k+1 − pivot k+1. Angles 0 to 5 are those of the legs, 6 to 11 those of the bars.
fn loops() -> Loops<12> {
    let angle = |[from, to]: [[f64; 2]; 2]| (to[1] - from[1]).atan2(to[0] - from[0]);
    let mut loops = Loops {
        terms: Vec::new(),
        base: SVector::zeros(),
        driven: vec![(0, 1.0), (5, -1.0)],
        q: SVector::zeros(),
        qd: SVector::zeros(),
        qdd: SVector::zeros(),
    };
    for along in 0..6 {
        let next = (along + 1) % 6;
        let terms = [(along, LEGS[along]), (6 + along, RING[along]), (next, -LEGS[next])];
        loops.terms.extend(terms.map(|(angle, length)| Term { along, angle, arm: [length, 0.0] }));
        for (pivot, sign) in [(along, 1.0), (next, -1.0)] {
            // The first pivot is the crank pin.
            for i in (0..2).filter(|_| pivot > 0) {
                loops.base[2 * along + i] += sign * PIVOTS[pivot][i];
            }
        }
        loops.q[along] = angle([PIVOTS[along], NODES[along]]);
        loops.q[6 + along] = angle([NODES[along], NODES[next]]);
    }
    loops
}

fn contenders(linkage: &Linkage) -> Vec<Entry> {
    let pivot = fixed(PIVOTS[TRACKED][0], PIVOTS[TRACKED][1]);
    let follow = move |loops: &mut Loops<12>, pin: &Point, h, tolerance| {
        loops.close(pin, h, tolerance);
        loops.end(&pivot, TRACKED, [LEGS[TRACKED], 0.0])
    };
    let mut entries: Vec<Entry> =
        Entry::each(name::ANGLES, &TOLERANCES, |tolerance| Angles::new(CRANK, loops(), tolerance, follow)).collect();
    // The strictest comes first: ratios are to it.
    entries.reverse();
    entries.extend(declared!(Hexagon, HexagonState, pin, solve_for_pin, Static));
    entries.extend(sketch(linkage));
    entries
}
