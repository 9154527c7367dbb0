//! Constraints and components of another crate.

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

    /// Two points are one.
    pub constraint pinned(P: Point, Q: Point) { P == Q; }

    /// A link that turns evenly about `P`.
    #[derive(PartialOrd)]
    pub component Link(P: Point, start: Angle, speed: AngularVelocity = 1rad_s) {
        /// From its pin to its end.
        param length: Length = 100mm;
        let end = (length, 0mm);
        body bar { point end = end; }
        joint pin = pinned(P, bar.position);
        drive turn = drive_angle(bar, start + speed * t);
        output end = bar.end;
    }

    /// Three links, each on the end of the one before.
    pub component Chain(P: Point) {
        part link[0] = Link(P, 0);
        for i in 1..3 { part link[i] = Link(link[i - 1].bar.end, 10deg * i, speed: 1rad_s * (i + 1)); }
        body last {}
        joint pin = pinned(link[2].bar.end, last.position);
        drive wave = drive_angle(last, crate::law(1rad_s * t));
    }

    /// A pendulum of one mass.
    pub component Pendulum(P: Point) {
        param length: Length = 500mm;
        body bob { point A = (0mm, length);  mass = 2kg; }
        joint pin = revolute(P, bob.A);
        freedom swing = bob.angle from 30deg;
    }

    /// A crank on any axis.
    pub component Crank(P: Point, u: Axis) in space {
        body bar { point A = (0mm, 0mm, 0mm);  point end = (100mm, 0mm, 50mm);  axis u = (0, 0, 1); }
        joint pin = revolute(P, u, bar.A, bar.u);
        drive turn = drive_rotation(pin, 1rad_s * t);
    }

    /// Several at once.
    pub bundle columns {
        constraint left_of(P: Point, Q: Point, d: Length) { Q.x - P.x == d; }
        constraint below(P: Point, Q: Point, d: Length) { Q.y - P.y == d; }
        constraint along_x(P: Point, Q: Point) in space { Q.y == P.y; Q.z == P.z; }
        component Pile(P: Point, d: Length) {
            body top {}
            joint upright = absolute_angle(top, 0);
            joint height = below(P, top.position, d);
            joint side = left_of(P, top.position, 0);
        }
    }
}

reuleaux::constraint! {
    /// Distances the other way round, and another component of the same name.
    pub bundle hanging {
        constraint below(P: Point, Q: Point, d: Length) { P.y - Q.y == d; }
        component Pile(P: Point, d: Length) {
            body top {}
            joint upright = absolute_angle(top, 0);
            joint height = below(P, top.position, d);
            joint side = vertical(P, top.position);
        }
    }

    /// A point stays below another one.
    pub constraint vertical(P: Point, Q: Point) { P.x == Q.x; }
}

/// A law: 1 − cos x with its first and second derivative.
pub fn law<T: reuleaux::Real>(x: T) -> (T, T, T) {
    let (sine, cosine) = x.sin_cos();
    (T::of(1.0) - cosine, sine, cosine)
}
