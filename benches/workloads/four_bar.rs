//! W1: ground 4, crank 1, coupler 3.5, rocker 3; one turn a second.

use reuleaux::mechanism;

use super::{TOLERANCES, Workload, declared, generated, name, sketch};
use crate::contender::Entry;
use crate::hand::{Angles, Bar, Closed, Crank, Law, Pair, Point, Whole, dyad, fixed};
use crate::linkage::{Link, Linkage};

mechanism! {
    /// W1: a four-bar whose crank turns.
    pub mechanism FourBar {
        ground { point O = (0m, 0m); point C = (4m, 0m); }
        body crank { point O = (0m, 0m); point A = (1m, 0m); }
        body coupler { point A = (0m, 0m); point B = (3.5m, 0m); }
        body rocker { point C = (0m, 0m); point B = (3m, 0m); start angle = 110deg; }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive input = drive_angle(crank, 1turn * t / 1s);
        slice output pin = rocker.B;
    }
}
generated!(FourBar, FourBarState, pin);

const CRANK: Crank = Crank { pivot: [0.0, 0.0], length: 1.0, law: Law::Turning };

pub(crate) fn workload() -> Workload {
    let mut linkage = Linkage {
        name: "W1 four-bar",
        points: vec![[0.0, 0.0], [4.0, 0.0], [1.0, 0.0]],
        fixed: 2,
        crank: CRANK,
        crank_ends: [0, 2],
        links: Vec::new(),
        slider: None,
        order: Vec::new(),
        tracked: 3,
        size: 4.0,
    };
    let pin = linkage.hang((2, 3.5), (1, 3.0), 1.0);
    linkage.links = vec![Link::bar(2, pin, 3.5), Link::bar(1, pin, 3.0)];
    Workload { linkage, generated, plan, contenders }
}

fn contenders(linkage: &Linkage) -> Vec<Entry> {
    let rocker_pivot = fixed(4.0, 0.0);
    let closed = move |t| dyad(&CRANK.pin(t), 3.5, &rocker_pivot, 3.0, 1.0);
    let pair = Pair::meeting(linkage.points[2], linkage.points[1], linkage.points[3]);
    let follow = move |pair: &mut Pair, pin: &Point, h, tolerance| pair.close((pin, 3.5), (&rocker_pivot, 3.0), h, tolerance);
    let whole = move |t, [crank, coupler, rocker]: &mut [Bar; 3]| {
        crank.angle = CRANK.angle(t);
        let pin = CRANK.pin_at(crank.angle);
        let end = dyad(&pin, 3.5, &rocker_pivot, 3.0, 1.0);
        coupler.follow(&pin, &end);
        rocker.follow(&rocker_pivot, &end);
        end
    };
    let mut entries =
        vec![Entry::new(name::CLOSED, Closed::new(closed)), Entry::new(name::CLOSED_WHOLE, Whole::new([Bar::default(); 3], whole))];
    entries.extend(Entry::each(name::ANGLES, &TOLERANCES, |tolerance| Angles::new(CRANK, pair, tolerance, follow)));
    entries.extend(declared!(FourBar, FourBarState, pin, solve_for_pin, Static));
    entries.extend(sketch(linkage));
    entries
}
