/// The rack and pinion of multi-point constraints with its guide: the pinion keeps its place on the carrier, the rack slides along an axis.
///
/// ```text
///                                          r_2 ──▶
///    ______┌─────┐_____________┌─────┐______
///   │______└──┬──┘_____________└──┬──┘______│ N2
///             │    ╱▔▔▔▔▔▔▔╲      │
///             │   │r_1(o)─ α│ N1  │
///             │    ╲___│___╱      │
///             └────────┴──────────┘ N0
///
///   v_1 − v_0 − ω_0 × (r_1 − r_0) = 0          3 rows, m/s
///   ω_2 − ω_0 = 0                              3 rows, rad/s
///   α Δω_1 · r_1 + ΔV_2 · r_2 = 0              1 row, m/s
///   ΔV_2 · s_2 = 0,  ΔV_2 · t_2 = 0            2 rows, m/s
/// ```
///
/// The rows leave the pinion's axis free: add a bearing. To solve for a motion take `revolute`, `translational` and `rack_pinion`.
/// Degenerate case: none.
///
/// The joint adds `mass` and `inertia` to each of the three nodes: a mass at the
/// origin of the body, an inertia that is the same about every axis. Ground takes none.
///
/// Reference: OpenRadioss theory manual, gear type joints.
constraint guided_rack_and_pinion_joint(
    N0: Body, N1: Body, N2: Body, r1: Axis, r2: Axis, alpha: Length / Angle,
    mass: Mass = 0kg, inertia: Inertia = 0kgm2,
) in space {
    require r1.body == N0: "the axes of a rack and pinion joint are fixed in its carrier";
    require r2.body == N0: "the axes of a rack and pinion joint are fixed in its carrier";
    require mass >= 0: "a joint takes no mass away";
    require inertia >= 0: "a joint takes no inertia away";
    add mass at N0.position: mass;
    add inertia on N0: inertia;
    add mass at N1.position: mass;
    add inertia on N1: inertia;
    add mass at N2.position: mass;
    add inertia on N2: inertia;
    let turn = N1.angular_velocity - N0.angular_velocity;
    let slide = rate(N2.position) - rate(N0.position) - cross(N0.angular_velocity, N2.position - N0.position);
    rate(N1.position) - rate(N0.position) - cross(N0.angular_velocity, N1.position - N0.position) == 0;
    N2.angular_velocity - N0.angular_velocity == 0;
    alpha * dot(z_axis(r1), turn) + dot(z_axis(r2), slide) == 0;
    dot(x_axis(r2), slide) == 0;
    dot(y_axis(r2), slide) == 0;
}
