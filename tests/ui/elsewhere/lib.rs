//! Constraints of another crate.

reuleaux::constraint! {
    /// `P` stays at the height `h` above ground.
    pub constraint at_height(P: Point, h: Length) { P.y == h; }

    /// Several at once.
    pub bundle columns {
        constraint left_of(P: Point, Q: Point, d: Length) { Q.x - P.x == d; }
        constraint below(P: Point, Q: Point, d: Length) { Q.y - P.y == d; }
    }
}
