/// The gear joint of multi-point constraints: two nodes at fixed places on a carrier, each turning about an axis of it in a fixed ratio.
///
/// ```text
///             ▲ r_1          ▲ r_2
///             ║              ║
///   │─── α ───╫─────────││─1─╫───│
///             ║ N1           ║ N2
///   ══════════╩══════════════╩════ N0
///
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
/// The joint adds `mass` and `inertia` to each of the three nodes: a mass at the
/// origin of the body, an inertia that is the same about every axis. Ground takes none.
///
/// Reference: OpenRadioss theory manual, gear type joints.
constraint gear_joint(N0: Body, N1: Body, N2: Body, r1: Axis, r2: Axis, alpha: Number, mass: Mass = 0kg, inertia: Inertia = 0kgm2) in space {
    require r1.body == N0: "the axes of a gear joint are fixed in its carrier";
    require r2.body == N0: "the axes of a gear joint are fixed in its carrier";
    require mass >= 0: "a joint takes no mass away";
    require inertia >= 0: "a joint takes no inertia away";
    add mass at N0.position: mass;
    add inertia on N0: inertia;
    add mass at N1.position: mass;
    add inertia on N1: inertia;
    add mass at N2.position: mass;
    add inertia on N2: inertia;
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
