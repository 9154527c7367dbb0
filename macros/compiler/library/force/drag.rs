/// A resistance at a point that grows with the square of its speed: air, water.
///
/// ```text
///          ╭───╮
///   F ◀════│ P │────▶ v
///          ╰───╯
///
///   F = −factor |v| v at P      v = ṙ_P
/// ```
///
/// `factor` is half the density times the drag coefficient times the area. Degenerate case: none; at rest there is no force.
///
/// Reference: Batchelor, An Introduction to Fluid Dynamics, section 5.11.
force drag(P: Point, factor: Mass / Length) {
    let v = rate(P);
    // The length of a vector has no derivative where it is zero; the force has.
    let speed: Velocity = if dot(v, v) > 0 { norm(v) } else { 0 };
    at P: -factor * speed * v;
}
