/// Two axes keep one direction.
///
/// ```text
///   ▲ a           ▲ b
///   ║             ║
///   ║             ║
///   ║ i           ║ j
///
///   x_a · z_b = 0,  y_a · z_b = 0              2 rows
///   angle = atan2(y_a · x_b, x_a · x_b)
/// ```
///
/// Removes two freedoms. As with `revolute`, the axes point the same way or, where the declared start says so, against each other.
/// Degenerate case: both axes on the same body, which is refused.
///
/// Reference: Haug, section 9.4.
constraint parallel_axes(a: Axis, b: Axis) in space {
    require a.body != b.body: "the two axes lie on the same body";
    let angle = joint_angle(a, b);
    across(a, b) == 0;
}
