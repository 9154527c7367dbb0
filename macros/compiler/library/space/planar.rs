/// A point of one body stays in a plane of the other, and the normals of both keep one direction.
///
/// ```text
///     a ▲              ▲ b
///       │        ______│______
///       │       ╱      Q     ╱  j
///       │      ╱_______┬____╱
///     __│______________│ offset__
///    ╱  P              ┴        ╱  i
///   ╱__________________________╱
///
///   x_a · z_b = 0,  y_a · z_b = 0              2 rows
///   z_a · d − offset = 0                       1 row, m           d = r_Q − r_P
///   angle = atan2(y_a · x_b, x_a · x_b)
///   x = x_a · d,  y = y_a · d
/// ```
///
/// Removes three freedoms: the bodies slide and turn in the plane. Degenerate case: both points on the same body, which is refused.
///
/// Reference: Haug, section 9.4.
constraint planar(P: Point, a: Axis, Q: Point, b: Axis, offset: Length = 0mm) in space {
    require P.body == a.body: "the first point and the first axis of a planar joint belong to one body";
    require Q.body == b.body: "the second point and the second axis of a planar joint belong to one body";
    require P.body != Q.body: "the two points of a planar joint lie on the same body";
    let angle = joint_angle(a, b);
    let x = dot(x_axis(a), Q - P);
    let y = dot(y_axis(a), Q - P);
    across(a, b) == 0;
    dot(z_axis(a), Q - P) == offset;
}
