/// The differential of multi-point constraints, as published: the turns of three nodes against a carrier, along three axes.
///
/// ```text
///                     ║ N1   ▲ r_1
///                 │╲╲─╨─╱
///                 ├──┬──────┬──────┐
///                 │  │ │╲───┴───╱│ │
///    N2 ══════════╪══╪═╡         ╞═╪══════════ N3
///      r_2 ──▶    │  │ │╱───┬───╲│ │   r_3 ──▶
///                 ├──┴──────┴──────┘
///   o N0          │
///
///   α Δω_1 · e_1 + Δω_2 · e_2 + Δω_3 · e_3 = 0     3 rows, rad/s      e = r, s, t,  Δω_i = ω_i − ω_0
/// ```
///
/// The axes belong to the carrier `N0`. The rows hold no place: add the joints that do, or take `differential_joint_on_bearings`.
/// Degenerate case: none.
///
/// The joint adds `mass` and `inertia` to each of the four nodes: a mass at the
/// origin of the body, an inertia that is the same about every axis. Ground takes none.
///
/// Reference: OpenRadioss theory manual, gear type joints.
constraint differential_joint(
    N0: Body, N1: Body, N2: Body, N3: Body, r1: Axis, r2: Axis, r3: Axis, alpha: Number,
    mass: Mass = 0kg, inertia: Inertia = 0kgm2,
) in space {
    require r1.body == N0: "the axes of a differential are fixed in its carrier";
    require r2.body == N0: "the axes of a differential are fixed in its carrier";
    require r3.body == N0: "the axes of a differential are fixed in its carrier";
    require mass >= 0: "a joint takes no mass away";
    require inertia >= 0: "a joint takes no inertia away";
    add mass at N0.position: mass;
    add inertia on N0: inertia;
    add mass at N1.position: mass;
    add inertia on N1: inertia;
    add mass at N2.position: mass;
    add inertia on N2: inertia;
    add mass at N3.position: mass;
    add inertia on N3: inertia;
    let one = N1.angular_velocity - N0.angular_velocity;
    let two = N2.angular_velocity - N0.angular_velocity;
    let three = N3.angular_velocity - N0.angular_velocity;
    alpha * dot(z_axis(r1), one) + dot(z_axis(r2), two) + dot(z_axis(r3), three) == 0;
    alpha * dot(x_axis(r1), one) + dot(x_axis(r2), two) + dot(x_axis(r3), three) == 0;
    alpha * dot(y_axis(r1), one) + dot(y_axis(r2), two) + dot(y_axis(r3), three) == 0;
}
