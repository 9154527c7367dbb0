//! A Stephenson III six-bar driven at its far link: a four-bar on A₀ and B₀ whose coupler point C is led round by a crank about
//! D₀. From that end no loop closes before the other, and four angles are found together.

use reuleaux::mechanism;
use reuleaux::nalgebra::SVector;

use super::{TOLERANCES, Workload, declared, generated, name, sketch};
use crate::contender::Entry;
use crate::hand::{Angles, Crank, Law, Loops, Point, Term, fixed};
use crate::linkage::{Link, Linkage};

mechanism! {
    mechanism SixBar {
        ground { point A0 = (0m, 0m); point B0 = (4m, 0m); point D0 = (4m, 5.5m); }
        body crank { point D0 = (0m, 0m); point D = (1m, 0m); }
        body link { point D = (0m, 0m); point C = (3.5m, 0m); start position = (5m, 5.5m); start angle = -164.8deg; }
        body left { point A0 = (0m, 0m); point A = (2.5m, 0m); start angle = 101.3deg; }
        body coupler { point A = (0m, 0m); point B = (4.5m, 0m); point C = (2.25m, sqrt((3m)^2 - (2.25m)^2)); start angle = 3.8deg; }
        body right { point B0 = (0m, 0m); point B = (2.75m, 0m); start angle = 90deg; }
        joint d0 = revolute(ground.D0, crank.D0);
        joint d = revolute(crank.D, link.D);
        joint c = revolute(link.C, coupler.C);
        joint a0 = revolute(ground.A0, left.A0);
        joint a = revolute(left.A, coupler.A);
        joint b = revolute(coupler.B, right.B);
        joint b0 = revolute(ground.B0, right.B0);
        drive input = drive_angle(crank, 1turn * t / 1s);
        slice output pin = coupler.C;
    }
}
generated!(SixBar, SixBarState, pin);

const CRANK: Crank = Crank { pivot: [4.0, 5.5], length: 1.0, law: Law::Turning };

pub(crate) fn workload() -> Workload {
    let linkage = Linkage {
        name: "six-bar, one block of 4",
        points: vec![[0.0, 0.0], [4.0, 0.0], [4.0, 5.5], [5.0, 5.5], [-0.490476, 2.451415], [3.999607, 2.75], [1.622902, 4.580647]],
        fixed: 3,
        crank: CRANK,
        crank_ends: [2, 3],
        links: vec![Link::bar(3, 6, 3.5), Link::bar(0, 4, 2.5), Link::triangle([4, 5], 4.5, 6, [3.0, 3.0], 1.0), Link::bar(1, 5, 2.75)],
        slider: None,
        order: vec![vec![4, 5, 6]],
        tracked: 6,
        size: 6.0,
    };
    Workload { linkage, generated, plan, contenders }
}

fn contenders(linkage: &Linkage) -> Vec<Entry> {
    let [left, coupler, right, link] = [0, 1, 2, 3];
    let apex = linkage.links[2].local()[2].1;
    let term = |along, angle, arm| Term { along, angle, arm };
    let place = |point: usize| linkage.points[point];
    let angle = |from: usize, to: usize| (place(to)[1] - place(from)[1]).atan2(place(to)[0] - place(from)[0]);
    let loops = Loops::<4> {
        // A₀ A B B₀, and A₀ A C D.
        terms: vec![
            term(0, left, [2.5, 0.0]),
            term(0, coupler, [4.5, 0.0]),
            term(0, right, [-2.75, 0.0]),
            term(1, left, [2.5, 0.0]),
            term(1, coupler, apex),
            term(1, link, [-3.5, 0.0]),
        ],
        base: SVector::from([-4.0, 0.0, 0.0, 0.0]),
        driven: vec![(1, -1.0)],
        q: SVector::from([angle(0, 4), angle(4, 5), angle(1, 5), angle(3, 6)]),
        qd: SVector::zeros(),
        qdd: SVector::zeros(),
    };
    let follow = move |loops: &mut Loops<4>, pin: &Point, h, tolerance| {
        loops.close(pin, h, tolerance);
        let a = loops.end(&fixed(0.0, 0.0), left, [2.5, 0.0]);
        loops.end(&a, coupler, apex)
    };
    let angles = |tolerance| Angles::new(CRANK, loops.clone(), tolerance, follow);
    let mut entries: Vec<Entry> = Entry::each(name::ANGLES, &TOLERANCES, angles).collect();
    // The strictest comes first: ratios are to it.
    entries.reverse();
    entries.extend(declared!(SixBar, SixBarState, pin, solve_for_pin, Static));
    entries.extend(sketch(linkage));
    entries
}
