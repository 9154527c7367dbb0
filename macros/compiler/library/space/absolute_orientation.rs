/// Two axes with the directions across them stay together: the bodies keep one orientation.
///
/// ```text
///   y_a · z_b = 0,  z_a · x_b = 0,  x_a · y_b = 0      3 rows
/// ```
///
/// Removes three freedoms. With an axis of ground the orientation is absolute. Degenerate case: both axes on the same body, which is
/// refused.
///
/// The rows hold as well after half a turn of one triad about an axis of its own, which is another assembly: of the four, the one nearest
/// to a declared `start orientation` is taken; without it, equal axes.
///
/// Reference: Haug, section 9.3.
constraint absolute_orientation(a: Axis, b: Axis) in space {
    require a.body != b.body: "the two axes lie on the same body";
    misalignment(a, b) == 0;
}
