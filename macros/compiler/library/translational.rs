/// Body j slides along a line fixed in body i, without turning in it (a prismatic joint, a slider).
///
/// ```text
///         u ──▶            the line through P along u is fixed in body i,
///   ──────P─────[ Q ]───   Q is fixed in body j
///    i             j
///
///   û⊥ · (r_Q − r_P) = 0                       row 1, m
///   φ_j − φ_i − c    = 0                       row 2, rad
/// ```
///
/// `u` is an axis of body i and `P` a point of it; û is `u` with unit length, so that row 1 is the
/// distance of `Q` from the line. `c` is the angle between the bodies, 0 unless said; angles are
/// never wrapped, so `c` may be several turns.
///
/// Removes two freedoms. Degenerate case: none; the axis may not be the zero vector. For a pin in a
/// slot, which may turn, use `point_on_line`.
///
/// Reference: Nikravesh, section 4.2.3; Haug, section 3.3. Their second row, v_i⊥ · v_j = 0, has two
/// solutions half a turn apart; the row here has one.
constraint translational(u: Axis, P: Point, Q: Point, c: Angle = 0) {
    require u.body == P.body: "the axis and the first point of a translational joint do not lie on the same body";
    require P.body != Q.body: "the two points of a translational joint lie on the same body";
    dot(perp(unit(u)), Q - P) == 0;
    Q.body.angle - P.body.angle == c;
}
