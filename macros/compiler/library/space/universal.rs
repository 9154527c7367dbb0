/// Two points stay together, and an axis of one body stays perpendicular to an axis of the other: the cross of a Hooke's joint.
///
/// ```text
///           ┌────┬──   a
///       i   │    ║         j
///   ════════╡   (o)════════════
///           │    ║ b
///           └────┴──   P = Q
///
///   r_P − r_Q = 0                              3 rows, m
///   z_a · z_b = 0                              1 row
///   angle_a =  atan2(y_a · z_b, x_a · z_b)
///   angle_b = −atan2(y_b · z_a, x_b · z_a)
/// ```
///
/// `a` and `b` are the two arms of the cross, each fixed in its body. The cross turns about `a` by `angle_a`, counted from where `b` lies along
/// x of `a` (its `from`), and the second body turns against the cross about `b` by `angle_b`, counted from where x of `b` lies along `a`. Both lie
/// between −180° and 180°, where they jump: a head that turns further about `a` is two revolute joints with a body between them. A spring about
/// an arm is `energy name = 0.5 * k * cross.angle_a^2 / 1rad;`.
///
/// A body of which no start is declared begins where `angle_a` and `angle_b` are zero.
///
/// Removes four freedoms. Degenerate case: where the shafts stand at a right angle to each other the cross folds, and the joint transmits no
/// rotation.
///
/// Reference: Nikravesh, section 7.2; Haug, section 9.4.
constraint universal(P: Point, a: Axis, Q: Point, b: Axis) in space {
    require P.body == a.body: "the first point and the first axis of a universal joint belong to one body";
    require Q.body == b.body: "the second point and the second axis of a universal joint belong to one body";
    require P.body != Q.body: "the two points of a universal joint lie on the same body";
    let angle_a = atan2(dot(y_axis(a), z_axis(b)), dot(x_axis(a), z_axis(b)));
    let angle_b = -atan2(dot(y_axis(b), z_axis(a)), dot(x_axis(b), z_axis(a)));
    P == Q;
    dot(z_axis(a), z_axis(b)) == 0;
}
