/// A gas spring between two points: a closed volume of gas under a piston.
///
/// ```text
///          P   ┌────────────────────┐        Q
///   F ◀───(o)──┤◀ column − s ▶║─────┼───────(o)───▶ F
///              └────────────────────┘
///          └─────────────── l ──────────────▶┘
///
///   F = force (column / (column − s))^exponent pushes P and Q apart      s = length − l,  l = |r_Q − r_P|
/// ```
///
/// `force` is that at the extended `length`, s is how far the spring is pushed in, and `column` is the volume of the gas at s = 0 over the area
/// that it pushes on: p = p₀ (V₀/V)^exponent. The exponent is 1 where the gas keeps its temperature, and up to 1.4, that of air, where it is
/// pushed in fast. The work to push it in is force · column · ln(column / (column − s)) for the exponent 1, otherwise
/// force · column · ((column / (column − s))^(exponent − 1) − 1) / (exponent − 1).
///
/// Degenerate case: where s reaches the column no room is left for the gas, and the force has no value.
///
/// Reference: Dubbel, Taschenbuch für den Maschinenbau, on gas springs.
force gas_spring(P: Point, Q: Point, force: Force, length: Length, column: Length, exponent: Number = 1) {
    require P.body != Q.body: "the two ends of a gas spring lie on the same body";
    require column > 0: "a gas spring without a column of gas has no force";
    let line = Q - P;
    let room = (column - length + norm(line)) / column;
    // The root has no value where there is no room, whatever the exponent.
    let push = force * sqrt(room)^(-2 * exponent) * unit(line);
    at P: -push;
    at Q: push;
}
