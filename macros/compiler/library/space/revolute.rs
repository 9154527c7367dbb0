/// Two points stay together, and two axes through them keep one direction: the bodies turn about the common axis (a hinge).
///
/// ```text
///          a ║ b
///        i   ║   j
///   ────────(o)────────
///            ║ P = Q
///
///   r_P − r_Q = 0                              3 rows, m
///   x_a · z_b = 0,  y_a · z_b = 0              2 rows
///   angle = atan2(y_a · x_b, x_a · x_b), continued over whole turns
/// ```
///
/// x, y and z are unit vectors: z along the axis, x across it towards the direction that the axis is declared with (`from`). Removes five
/// freedoms.
///
/// The axes may be of any length. They point the same way, unless the declared orientations of both bodies turn them more than 90° apart at
/// the start: then they point against each other. The angle is counted about `a`.
///
/// Degenerate case: both points on the same body, which is refused.
///
/// Reference: Nikravesh, section 7.2; Haug, section 9.4.
constraint revolute(P: Point, a: Axis, Q: Point, b: Axis) in space {
    require P.body == a.body: "the first point and the first axis of a revolute joint belong to one body";
    require Q.body == b.body: "the second point and the second axis of a revolute joint belong to one body";
    require P.body != Q.body: "the two points of a revolute joint lie on the same body";
    let angle = joint_angle(a, b);
    P == Q;
    across(a, b) == 0;
}
