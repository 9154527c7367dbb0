/// The rack and pinion of multi-point constraints, as published: a turn of one node goes with a displacement of another, along three axes.
///
/// ```text
///                           r_2 ──▶
///    ____________________________
///   │____________________________│ N2
///               ╱▔▔▔▔▔▔▔╲
///              │r_1(o)─ α│ N1
///               ╲_______╱
///   o N0
///
///   α Δω_1 · e_1 + ΔV_2 · e_2 = 0              3 rows, m/s      e = r, s, t
///   Δω_1 = ω_1 − ω_0
///   ΔV_2 = v_2 − v_0 − ω_0 × (r_2 − r_0)
/// ```
///
/// `r1` and `r2` are axes of the carrier `N0`; s and t are the directions across them. The rows hold neither place: add the joints that do,
/// or take `guided_rack_and_pinion_joint`. To solve for a motion take `rack_pinion` of a joint's angle. Degenerate case: none.
///
/// The joint adds `mass` and `inertia` to each of the three nodes: a mass at the
/// origin of the body, an inertia that is the same about every axis. Ground takes none.
///
/// Reference: OpenRadioss theory manual, gear type joints.
constraint rack_and_pinion_joint(
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
    alpha * dot(z_axis(r1), turn) + dot(z_axis(r2), slide) == 0;
    alpha * dot(x_axis(r1), turn) + dot(x_axis(r2), slide) == 0;
    alpha * dot(y_axis(r1), turn) + dot(y_axis(r2), slide) == 0;
}
