/// The gear joint of multi-point constraints: two nodes at fixed places on a carrier, each turning about an axis of it in a fixed ratio.
///
/// ```text
///   v_i − v_0 − ω_0 × (r_i − r_0) = 0          3 rows for each node, m/s      i = 1, 2
///   α Δω_1 · r_1 + Δω_2 · r_2 = 0              1 row, rad/s                   Δω_i = ω_i − ω_0
///   Δω_i · s_i = 0,  Δω_i · t_i = 0            2 rows for each node, rad/s
/// ```
///
/// `r1` and `r2` are axes of the carrier `N0`; s and t are the directions across them. Eleven rows of velocities, as published. Any number
/// of other joints may act on the same nodes.
///
/// As rows of positions the same joint is two `revolute` joints on the carrier and a `gear_pair` of their angles; take these to solve for a
/// motion: nothing drifts in them.
///
/// Degenerate case: none; a rigid motion of all nodes satisfies every row.
///
/// Reference: OpenRadioss theory manual, gear type joints.
constraint gear_joint(N0: Body, N1: Body, N2: Body, r1: Axis, r2: Axis, alpha: Number) in space {
    require r1.body == N0: "the axes of a gear joint are fixed in its carrier";
    require r2.body == N0: "the axes of a gear joint are fixed in its carrier";
    let one = N1.angular_velocity - N0.angular_velocity;
    let two = N2.angular_velocity - N0.angular_velocity;
    rate(N1.position) - rate(N0.position) - cross(N0.angular_velocity, N1.position - N0.position) == 0;
    rate(N2.position) - rate(N0.position) - cross(N0.angular_velocity, N2.position - N0.position) == 0;
    alpha * dot(z_axis(r1), one) + dot(z_axis(r2), two) == 0;
    dot(x_axis(r1), one) == 0;
    dot(y_axis(r1), one) == 0;
    dot(x_axis(r2), two) == 0;
    dot(y_axis(r2), two) == 0;
}
