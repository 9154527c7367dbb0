/// A spring and a damper in parallel between two points.
///
/// ```text
///    P     ┌────╱╲╱╲╱╲╱╲────┐     Q
///   (o)────┤                ├────(o)
///          │     ┌──────    │
///     F ──▶└─────┤   ├──────┘◀── F
///                └──────
///    └────────────── l ──────────▶┘
///
///   F = stiffness (l − rest) + damping l̇ along the line from P to Q, on both ends      l = |r_Q − r_P|
/// ```
///
/// Degenerate case: at length zero the line has no direction.
///
/// Reference: Nikravesh, section 9.4; Haug, section 6.2.
force spring_damper(P: Point, Q: Point, stiffness: Stiffness, rest: Length, damping: Mass / Time) {
    require P.body != Q.body: "the two ends of a spring lie on the same body";
    let line = Q - P;
    let force = stiffness * (norm(line) - rest) + damping * rate(norm(line));
    potential: 0.5 * stiffness * (norm(line) - rest)^2;
    at P: force * unit(line);
    at Q: -force * unit(line);
}
