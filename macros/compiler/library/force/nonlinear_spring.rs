/// A spring between two points whose force is a law of their distance: a progressive coil, a rubber buffer, a rope, a gas spring by its table.
///
/// ```text
///    P        law(l)          Q
///   (o)──────╱╲╱╲╱╲╱╲╱╲──────(o)
///     F ──▶              ◀── F
///    └──────────── l ────────▶┘
///
///   F = law(l) along the line from P to Q, on both ends      l = |r_Q − r_P|
/// ```
///
/// As with `spring`, a positive force pulls the points together. The law takes the distance (m), not the deflection, and gives the force (N): a
/// formula, a `table` or a Rust function. A rope, a gas spring by the pressures (over ambient) that were measured, and one by a formula:
///
/// ```text
///   function rope(l: Length) -> Force = if l > 2m { 40kN_m * (l - 2m) } else { 0 };
///   function gas(l: Length) -> Force = -area * table(l, [(180mm, 61bar), (220mm, 45bar), (260mm, 36bar), (300mm, 30bar)], linear);
///   function buffer(l: Length) -> Force = -2kN * (max(80mm - l, 0) / 10mm)^3;
/// ```
///
/// What it stores is not known to the energies: its work is in the power. Where it has to count as potential energy, write the energy V instead,
/// and the force follows: `energy name = V(norm(Q - P));`.
///
/// Degenerate case: at length zero the line has no direction.
///
/// Reference: Nikravesh, section 9.4; Haug, section 6.2.
force nonlinear_spring(P: Point, Q: Point, law: Function(Length) -> Force) {
    require P.body != Q.body: "the two ends of a spring lie on the same body";
    let line = Q - P;
    let force = law(norm(line));
    at P: force * unit(line);
    at Q: -force * unit(line);
}
