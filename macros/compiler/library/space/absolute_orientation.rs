/// Two axes with the directions across them stay together: the bodies keep one orientation.
///
/// ```text
///     z_a               z_b
///      │                 │
///      │                 │
///      o────── y_a       o────── y_b
///     ╱                 ╱
///   x_a               x_b
///
///   y_a · z_b = 0,  z_a · x_b = 0,  x_a · y_b = 0      3 rows
/// ```
///
/// Removes three freedoms. With an axis of ground the orientation is absolute. Degenerate case: both axes on the same body, which is
/// refused.
///
/// The rows also hold with one triad turned by 180° about one of its axes. Of these four assemblies the one nearest to the declared
/// `start orientation` is taken; if none is declared, the axes are equal.
///
/// Reference: Haug, section 9.3.
constraint absolute_orientation(a: Axis, b: Axis) in space {
    require a.body != b.body: "the two axes lie on the same body";
    misalignment(a, b) == 0;
}
