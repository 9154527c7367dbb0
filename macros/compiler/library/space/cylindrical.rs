/// Two axes stay on one line: the bodies turn about it and slide along it.
///
/// ```text
///       a ──▶          ┌───────┐ b ──▶   ╭───╮
///   ═══════P═══════════╪═══Q═══╪══════   │( )│
///     i                └───────┘ j       ╰───╯
///          └ displacement ▶┘
///
///   x_a · d = 0,  y_a · d = 0                  2 rows, m          d = r_Q − r_P
///   x_a · z_b = 0,  y_a · z_b = 0              2 rows
///   angle = atan2(y_a · x_b, x_a · x_b)
///   displacement = z_a · d
/// ```
///
/// Removes four freedoms. As with `revolute`, the axes point the same way or, where the declared start says so, against each other.
/// Degenerate case: both points on the same body, which is refused.
///
/// Reference: Nikravesh, section 7.2; Haug, section 9.4.
constraint cylindrical(P: Point, a: Axis, Q: Point, b: Axis) in space {
    require P.body == a.body: "the first point and the first axis of a cylindrical joint belong to one body";
    require Q.body == b.body: "the second point and the second axis of a cylindrical joint belong to one body";
    require P.body != Q.body: "the two points of a cylindrical joint lie on the same body";
    let angle = joint_angle(a, b);
    let displacement = along(a, Q - P);
    across(a, Q - P) == 0;
    across(a, b) == 0;
}
