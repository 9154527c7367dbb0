/// A point of body j stays on a line fixed in body i: a pin in a slot.
///
/// ```text
///         u ──▶
///   ──────P──────(Q)────
///
///   û⊥ · (r_Q − r_P) = 0                       1 row, m
/// ```
///
/// The line goes through `P` along `u`, both on body i; û is `u` with unit length, so that the row is
/// the distance of `Q` from the line. The bodies may turn against each other.
///
/// Reference: Nikravesh, section 4.2.4.
constraint point_on_line(P: Point, u: Axis, Q: Point) {
    require u.body == P.body: "the axis and the first point of a line do not lie on the same body";
    require P.body != Q.body: "the point on the line and the line lie on the same body";
    dot(perp(unit(u)), Q - P) == 0;
}
