/// A massless link, pinned to one body and sliding on another: a point of body j keeps its signed
/// distance from a line fixed in body i.
///
/// ```text
///              (Q)  j
///               │ c
///   ──────P─────┴────▶ u   i
///
///   û⊥ · (r_Q − r_P) − c = 0                   1 row, m
/// ```
///
/// `c` is positive to the left of `u`. With c = 0 it is `point_on_line`.
///
/// Reference: Nikravesh, section 4.2.4; Haug, section 3.3 (revolute-translational composite joint).
constraint revolute_translational(P: Point, u: Axis, Q: Point, c: Length) {
    require u.body == P.body: "the axis and the first point of a line do not lie on the same body";
    require P.body != Q.body: "the point and the line lie on the same body";
    dot(perp(unit(u)), Q - P) == c;
}
