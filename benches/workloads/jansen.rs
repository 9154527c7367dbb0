//! W3: Theo Jansen's leg with Holland's numbers divided by 10; one turn a second.

use reuleaux::mechanism;

use super::{TOLERANCES, Workload, declared, generated, name, sketch};
use crate::contender::Entry;
use crate::hand::{Angles, Bar, Closed, Crank, Law, Pair, Point, Whole, dyad, fixed};
use crate::linkage::{Link, Linkage};

mechanism! {
    /// W3: Jansen's leg.
    pub mechanism Jansen {
        ground { point O = (0m, 0m); point V = (-3.8m, -0.78m); }
        body crank { point O = (0m, 0m); point X = (1.5m, 0m); }
        body bar_j { point X = (0m, 0m); point U = (5m, 0m); start angle = 2.466; }
        let wx = ((4.15m)^2 + (4.01m)^2 - (5.58m)^2) / (2 * 4.15m);
        body upper { point V = (0m, 0m); point U = (4.15m, 0m); point W = (wx, sqrt((4.01m)^2 - wx^2)); start angle = 1.227; }
        body bar_k { point X = (0m, 0m); point C = (6.19m, 0m); start angle = -2.315; }
        body bar_c { point V = (0m, 0m); point C = (3.93m, 0m); start angle = -1.286; }
        body bar_f { point W = (0m, 0m); point F = (3.94m, 0m); start angle = -1.165; }
        let tx = ((3.67m)^2 + (6.57m)^2 - (4.90m)^2) / (2 * 3.67m);
        body foot { point F = (0m, 0m); point C = (3.67m, 0m); point T = (tx, -sqrt((6.57m)^2 - tx^2)); start angle = -0.496; }
        joint o = revolute(ground.O, crank.O);
        joint xj = revolute(crank.X, bar_j.X);
        joint xk = revolute(crank.X, bar_k.X);
        joint u = revolute(bar_j.U, upper.U);
        joint v = revolute(ground.V, upper.V);
        joint vc = revolute(ground.V, bar_c.V);
        joint kc = revolute(bar_k.C, bar_c.C);
        joint w = revolute(upper.W, bar_f.W);
        joint f = revolute(bar_f.F, foot.F);
        joint cf = revolute(bar_c.C, foot.C);
        drive input = drive_angle(crank, 1turn * t / 1s);
        slice output toe = foot.T;
    }
}
generated!(Jansen, JansenState, toe);

const CRANK: Crank = Crank { pivot: [0.0, 0.0], length: 1.5, law: Law::Turning };
const V: [f64; 2] = [-3.8, -0.78];

pub(crate) fn workload() -> Workload {
    let mut linkage = Linkage {
        name: "W3 Jansen's leg",
        points: vec![[0.0, 0.0], V, [1.5, 0.0]],
        fixed: 2,
        crank: CRANK,
        crank_ends: [0, 2],
        links: Vec::new(),
        slider: None,
        order: Vec::new(),
        tracked: 7,
        size: 10.0,
    };
    let (v, x) = (1, 2);
    let u = linkage.hang((x, 5.0), (v, 4.15), -1.0);
    let w = linkage.hang((v, 4.01), (u, 5.58), 1.0);
    let c = linkage.hang((x, 6.19), (v, 3.93), 1.0);
    let f = linkage.hang((w, 3.94), (c, 3.67), -1.0);
    let toe = linkage.hang((f, 6.57), (c, 4.90), -1.0);
    linkage.links = vec![
        Link::bar(x, u, 5.0),
        Link::triangle([v, u], 4.15, w, [4.01, 5.58], 1.0),
        Link::bar(x, c, 6.19),
        Link::bar(v, c, 3.93),
        Link::bar(w, f, 3.94),
        Link::triangle([f, c], 3.67, toe, [6.57, 4.90], -1.0),
    ];
    Workload { linkage, generated, plan, contenders }
}

fn contenders(linkage: &Linkage) -> Vec<Entry> {
    let v = fixed(V[0], V[1]);
    let closed = move |t| {
        let x = CRANK.pin(t);
        let u = dyad(&x, 5.0, &v, 4.15, -1.0);
        let w = dyad(&v, 4.01, &u, 5.58, 1.0);
        let c = dyad(&x, 6.19, &v, 3.93, 1.0);
        let f = dyad(&w, 3.94, &c, 3.67, -1.0);
        dyad(&f, 6.57, &c, 4.90, -1.0)
    };
    // The apex of a triangle needs no loop of its own: it follows from its two other points.
    let place = |point: usize| linkage.points[point];
    let pairs = [Pair::meeting(place(2), V, place(3)), Pair::meeting(place(2), V, place(5)), Pair::meeting(place(4), place(5), place(6))];
    let follow = move |[upper, lower, knee]: &mut [Pair; 3], x: &Point, h, tolerance| {
        let u = upper.close((x, 5.0), (&v, 4.15), h, tolerance);
        let w = dyad(&v, 4.01, &u, 5.58, 1.0);
        let c = lower.close((x, 6.19), (&v, 3.93), h, tolerance);
        let f = knee.close((&w, 3.94), (&c, 3.67), h, tolerance);
        dyad(&f, 6.57, &c, 4.90, -1.0)
    };
    let whole = move |t, [crank, bars @ ..]: &mut [Bar; 7]| {
        crank.angle = CRANK.angle(t);
        let x = CRANK.pin_at(crank.angle);
        let u = dyad(&x, 5.0, &v, 4.15, -1.0);
        let w = dyad(&v, 4.01, &u, 5.58, 1.0);
        let c = dyad(&x, 6.19, &v, 3.93, 1.0);
        let f = dyad(&w, 3.94, &c, 3.67, -1.0);
        for (bar, [from, to]) in bars.iter_mut().zip([[&x, &u], [&v, &u], [&x, &c], [&v, &c], [&w, &f], [&f, &c]]) {
            bar.follow(from, to);
        }
        dyad(&f, 6.57, &c, 4.90, -1.0)
    };
    let mut entries =
        vec![Entry::new(name::CLOSED, Closed::new(closed)), Entry::new(name::CLOSED_WHOLE, Whole::new([Bar::default(); 7], whole))];
    entries.extend(Entry::each(name::ANGLES, &TOLERANCES, |tolerance| Angles::new(CRANK, pairs, tolerance, follow)));
    entries.extend(declared!(Jansen, JansenState, toe, solve_for_toe, Static));
    entries.extend(sketch(linkage));
    entries
}
