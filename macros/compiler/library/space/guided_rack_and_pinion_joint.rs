/// The rack and pinion of multi-point constraints with its guide: the pinion keeps its place on the carrier, the rack slides along an axis.
///
/// ```text
///   v_1 − v_0 − ω_0 × (r_1 − r_0) = 0          3 rows, m/s
///   ω_2 − ω_0 = 0                              3 rows, rad/s
///   α Δω_1 · r_1 + ΔV_2 · r_2 = 0              1 row, m/s
///   ΔV_2 · s_2 = 0,  ΔV_2 · t_2 = 0            2 rows, m/s
/// ```
///
/// The rows leave the pinion's axis free: add a bearing. To solve for a motion take `revolute`, `translational` and `rack_pinion`.
/// Degenerate case: none.
///
/// Reference: OpenRadioss theory manual, gear type joints.
constraint guided_rack_and_pinion_joint(N0: Body, N1: Body, N2: Body, r1: Axis, r2: Axis, alpha: Length / Angle) in space {
    require r1.body == N0: "the axes of a rack and pinion joint are fixed in its carrier";
    require r2.body == N0: "the axes of a rack and pinion joint are fixed in its carrier";
    let turn = N1.angular_velocity - N0.angular_velocity;
    let slide = rate(N2.position) - rate(N0.position) - cross(N0.angular_velocity, N2.position - N0.position);
    rate(N1.position) - rate(N0.position) - cross(N0.angular_velocity, N1.position - N0.position) == 0;
    N2.angular_velocity - N0.angular_velocity == 0;
    alpha * dot(z_axis(r1), turn) + dot(z_axis(r2), slide) == 0;
    dot(x_axis(r2), slide) == 0;
    dot(y_axis(r2), slide) == 0;
}
