/// A bushing between two bodies in the plane: a bush of rubber in an eye, an elastic mount.
///
/// ```text
///        y ▲   ╭─────────╮
///          │  ╱  ╭─────╮  ╲
///          │ │╱╲╱│Q   ╱│╱╲╱│ two
///          │ │╱╲╱│ ╲ ╱ │╱╲╱│
///          │  ╲  ╰──P──╯  ╱
///          │   ╰─────────╯  one
///          └─────────────▶ u
///
///   F = −(stiffness_x d_x + damping_x ḋ_x) u − (stiffness_y d_y + damping_y ḋ_y) u⊥ on `two` at Q, −F on `one` at the same place
///   T = −torsion (φ_two − φ_one − rest) − torsion_damping (φ̇_two − φ̇_one) on `two`, −T on `one`
///   d_x = u · (r_Q − r_P),  d_y = u⊥ · (r_Q − r_P)
/// ```
///
/// `P` and the axis `u` belong to body one, `Q` to body two; u has unit length here, and turns with body one. Q yields from P by d, and F acts on
/// both bodies at Q: on body one as −F at P and the torque −d × F, so that momentum and angular momentum are kept however large d is. Unless
/// said, stiffness and damping across u are those along it, and torsion and all damping are 0. What it stores is in the potential energy.
///
/// Stiffness in N/m, torsion in N m/rad, damping in N s/m and N m s/rad. Angles are not wrapped. Degenerate case: none.
///
/// Reference: Blundell and Harty, The Multibody Systems Approach to Vehicle Dynamics, on bushes.
force bushing(
    P: Point,
    u: Axis,
    Q: Point,
    stiffness_x: Stiffness,
    stiffness_y: Stiffness = stiffness_x,
    torsion: Torque / Angle = 0,
    damping_x: Mass / Time = 0,
    damping_y: Mass / Time = damping_x,
    torsion_damping: Torque / AngularVelocity = 0,
    rest: Angle = 0,
) in plane {
    require P.body == u.body: "the first point and the axis of a bushing belong to one body";
    require P.body != Q.body: "the two points of a bushing lie on the same body";
    let d = Q - P;
    let x = dot(unit(u), d);
    let y = dot(perp(unit(u)), d);
    let angle = Q.body.angle - P.body.angle - rest;
    potential: 0.5 * stiffness_x * x^2 + 0.5 * stiffness_y * y^2 + 0.5 * torsion * angle^2 / 1rad;
    let pull = (stiffness_x * x + damping_x * rate(x)) * unit(u) + (stiffness_y * y + damping_y * rate(y)) * perp(unit(u));
    let torque = torsion * angle + torsion_damping * (Q.body.angular_velocity - P.body.angular_velocity);
    at Q: -pull;
    at P: pull;
    on Q.body: -torque;
    on P.body: torque + cross(d, pull);
}
