/// Two bodies are one: two points stay together, and two axes with the directions across them.
///
/// ```text
///         z_a = z_b
///             │
///       i     │     j
///   ══════════●══════════
///            ╱ P = Q
///      x_a = x_b
///
///   r_P − r_Q = 0                              3 rows, m
///   y_a · z_b = 0,  z_a · x_b = 0,  x_a · y_b = 0      3 rows
/// ```
///
/// Removes all six freedoms. The directions that the axes are declared with (`from`) say how the bodies stand to each other. Degenerate
/// case: both points on the same body, which is refused.
///
/// The rows also hold with one triad turned by 180° about one of its axes. Of these four assemblies the one nearest to the declared
/// `start orientation` is taken; if none is declared, the axes are equal.
///
/// Reference: Nikravesh, section 7.2; Haug, section 9.4.
constraint weld(P: Point, a: Axis, Q: Point, b: Axis) in space {
    require P.body == a.body: "the first point and the first axis of a weld belong to one body";
    require Q.body == b.body: "the second point and the second axis of a weld belong to one body";
    require P.body != Q.body: "the two points of a weld lie on the same body";
    P == Q;
    misalignment(a, b) == 0;
}
