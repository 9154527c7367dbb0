/// A cylindrical joint in which a turn goes with a displacement (a lead screw).
///
/// ```text
///       a ──▶  lead    ┌───────┐ b ──▶
///   ═══════P══╲╲╲╲╲╲╲╲╲╪╲╲╲Q╲╲╲╪╲╲╲╲╲══
///     i                └───────┘ j
///
///   x_a · d = 0,  y_a · d = 0                  2 rows, m          d = r_Q − r_P
///   x_a · z_b = 0,  y_a · z_b = 0              2 rows
///   z_a · d − lead · angle / 2π − offset = 0   1 row, m
/// ```
///
/// `lead` is the displacement of a whole turn, such as `5mm`, positive for a right-handed thread. Removes five freedoms; exact over any number of turns.
/// Degenerate case: both points on the same body, which is refused.
///
/// Reference: Haug, section 9.4.
constraint screw(P: Point, a: Axis, Q: Point, b: Axis, lead: Length, offset: Length = 0mm) in space {
    require P.body == a.body: "the first point and the first axis of a screw joint belong to one body";
    require Q.body == b.body: "the second point and the second axis of a screw joint belong to one body";
    require P.body != Q.body: "the two points of a screw joint lie on the same body";
    require lead != 0: "a screw without a lead does not advance: write `revolute`, or the way of one turn";
    let angle = joint_angle(a, b);
    let displacement = along(a, Q - P);
    across(a, Q - P) == 0;
    across(a, b) == 0;
    displacement - lead * (angle / (2 * pi)) == offset;
}
