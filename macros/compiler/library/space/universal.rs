/// Two points stay together, and an axis of one body stays perpendicular to an axis of the other: the cross of a Hooke's joint.
///
/// ```text
///   r_P − r_Q = 0                              3 rows, m
///   z_a · z_b = 0                              1 row
/// ```
///
/// `a` and `b` are the two arms of the cross, each fixed in its body. Removes four freedoms. Degenerate case: where the shafts stand at a
/// right angle to each other the cross folds, and the joint transmits no rotation.
///
/// Reference: Nikravesh, section 7.2; Haug, section 9.4.
constraint universal(P: Point, a: Axis, Q: Point, b: Axis) in space {
    require P.body == a.body: "the first point and the first axis of a universal joint belong to one body";
    require Q.body == b.body: "the second point and the second axis of a universal joint belong to one body";
    require P.body != Q.body: "the two points of a universal joint lie on the same body";
    P == Q;
    dot(z_axis(a), z_axis(b)) == 0;
}
