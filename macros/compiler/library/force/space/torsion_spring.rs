/// A torsion spring in space, about a common axis of two bodies.
///
/// ```text
///      a ──▶                ╭─  b ──▶
///   ══════════╡╱╲╱╲╱╲╱╲╞════╪═════════
///                           ╰─▶ θ
///
///   T = −stiffness (θ − rest), T z_a on the body of `b`, −T z_a on the body of `a`      θ: angle of b against a about z_a
/// ```
///
/// The axes have to stay in one direction, as a revolute or cylindrical joint keeps them. Degenerate case: none.
///
/// Reference: Haug, section 9.5.
force torsion_spring(a: Axis, b: Axis, stiffness: Torque / Angle, rest: Angle) in space {
    require a.body != b.body: "a torsion spring acts between two bodies";
    let line = stiffness * (joint_angle(a, b) - rest) * z_axis(a);
    potential: 0.5 * stiffness * (joint_angle(a, b) - rest)^2 / 1rad;
    on b.body: -line;
    on a.body: line;
}
