/// Two axes stay at a right angle to each other, or at another angle.
///
/// ```text
///   ▲ a           │
///   ║             │──┐ acos(cosine)
///   ║             │  │
///   ║             o══╧═══════▶ b
///
///   z_a · z_b − cosine = 0                     1 row
/// ```
///
/// Removes one freedom. Degenerate case: at a cosine of 1 or −1 the row's derivative vanishes; use `parallel_axes`.
///
/// Reference: Haug, section 9.4 (dot-1).
constraint perpendicular_axes(a: Axis, b: Axis, cosine: Number = 0) in space {
    require a.body != b.body: "the two axes lie on the same body";
    require cosine^2 < 1: "at this angle two axes are parallel: use `parallel_axes`";
    dot(z_axis(a), z_axis(b)) == cosine;
}
