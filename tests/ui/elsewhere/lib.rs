//! Constraints of another crate.

reuleaux::constraint! {
    /// `P` stays at the height `h` above ground.
    pub constraint at_height(P: Point, h: Length) { P.y == h; }

    /// `P` rises by the law of this crate as `b` turns.
    pub constraint lifted(P: Point, b: Body) { P.y == 10mm * crate::law(b.angle); }

    /// `Q` slides along the line through `P`.
    pub constraint rail(u: Axis, P: Point, Q: Point) { dot(perp(u), Q - P) == 0; }

    /// The place of a point on its rail.
    pub constraint push(slide: Joint(rail), C: Length) { dot(unit(slide.u), slide.Q - slide.P) == C; }

    /// A spring that stiffens as it is drawn out.
    pub force stiffening_spring(P: Point, Q: Point, stiffness: Stiffness, cubic: Number) {
        let x = norm(Q - P);
        let pull = stiffness * x * (1 + cubic * (x / 1m)^2) * unit(Q - P);
        at P: pull;
        at Q: -pull;
    }

    /// Several at once.
    pub bundle columns {
        constraint left_of(P: Point, Q: Point, d: Length) { Q.x - P.x == d; }
        constraint below(P: Point, Q: Point, d: Length) { Q.y - P.y == d; }
    }
}

/// A law: 1 − cos x with its first and second derivative.
pub fn law<T: reuleaux::Real>(x: T) -> (T, T, T) {
    let (sine, cosine) = x.sin_cos();
    (T::of(1.0) - cosine, sine, cosine)
}
