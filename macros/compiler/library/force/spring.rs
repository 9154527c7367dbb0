/// A spring between two points.
///
/// ```text
///    P                        Q
///   (o)──────╱╲╱╲╱╲╱╲╱╲──────(o)
///     F ──▶              ◀── F
///    └──────────── l ────────▶┘
///
///   F = stiffness (l − rest) along the line from P to Q, on both ends      l = |r_Q − r_P|
/// ```
///
/// `at P` it pulls towards `Q` where it is longer than `rest`, and pushes where it is shorter. Degenerate case: at length zero the line has
/// no direction, and the force is not a number. Without `rest` it is `stiffness (r_Q − r_P)`, also at length zero; with a parameter as `rest` it is
/// not a number there even if that is 0.
///
/// Reference: Nikravesh, section 9.4; Haug, section 6.2.
force spring(P: Point, Q: Point, stiffness: Stiffness, rest: Length = 0mm) {
    require P.body != Q.body: "the two ends of a spring lie on the same body";
    let line = Q - P;
    let force = stiffness * (1 - rest / norm(line)) * line;
    potential: 0.5 * stiffness * (norm(line) - rest)^2;
    at P: force;
    at Q: -force;
}
