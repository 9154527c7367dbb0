/// Two axes stay on one line and the bodies do not turn about it: one slides along the other (a prismatic joint).
///
/// ```text
///       a ──▶          ┌───────┐ b ──▶   ┌───┐
///   ═══════P═══════════╪═══Q═══╪══════   │[ ]│
///     i                └───────┘ j       └───┘
///          └ displacement ▶┘
///
///   x_a · d = 0,  y_a · d = 0                  2 rows, m          d = r_Q − r_P
///   x_a · z_b = 0,  y_a · z_b = 0,  x_a · y_b = 0      3 rows
///   displacement = z_a · d
/// ```
///
/// The directions that the axes are declared with (`from`) say how the bodies stand to each other. Removes five freedoms. Degenerate
/// case: both points on the same body, which is refused.
///
/// The rows also hold with one triad turned by 180° about one of its axes. Of these four assemblies the one nearest to the declared
/// `start orientation` is taken; if none is declared, the axes are equal.
///
/// Reference: Nikravesh, section 7.2; Haug, section 9.4.
constraint translational(P: Point, a: Axis, Q: Point, b: Axis) in space {
    require P.body == a.body: "the first point and the first axis of a translational joint belong to one body";
    require Q.body == b.body: "the second point and the second axis of a translational joint belong to one body";
    require P.body != Q.body: "the two points of a translational joint lie on the same body";
    let displacement = along(a, Q - P);
    across(a, Q - P) == 0;
    across(a, b) == 0;
    dot(x_axis(a), y_axis(b)) == 0;
}
