/// A point stays in a plane of another body, or at a distance from it.
///
/// ```text
///     a ▲          Q
///       │          │ offset
///     __│__________│_____
///    ╱  P          ┴    ╱
///   ╱__________________╱
///
///   z_a · d − offset = 0                       1 row, m           d = r_Q − r_P
/// ```
///
/// The plane goes through `P` and is normal to `a`. Removes one freedom. Degenerate case: both points on the same body, which is refused.
///
/// Reference: Haug, section 9.4.
constraint point_on_plane(P: Point, a: Axis, Q: Point, offset: Length = 0mm) in space {
    require P.body == a.body: "the point and the normal of the plane belong to one body";
    require P.body != Q.body: "the plane and the point lie on the same body";
    dot(z_axis(a), Q - P) == offset;
}
