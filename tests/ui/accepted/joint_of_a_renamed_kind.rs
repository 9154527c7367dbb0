//! The kind of a joint is the name of its definition, also if a `use` item renames it.

reuleaux::mechanism! {
    pub mechanism Shuttle {
        use elsewhere::{rail as groove, push};
        body shuttle {}
        joint upright = absolute_angle(shuttle, 0);
        joint way = groove((1, 0), (0mm, 0mm), shuttle.position);
        drive there = push(way, 1m_s * t);
    }
}

fn main() {
    assert_eq!(Shuttle::default().solve(0.25).unwrap().shuttle().position.x, 0.25);
}
