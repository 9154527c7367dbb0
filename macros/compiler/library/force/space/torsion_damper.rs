/// A torsion damper in space, about a common axis of two bodies: viscous friction in a hinge.
///
/// ```text
///      a ──▶      ┌─────      ╭─  b ──▶
///   ══════════════╡  ╞════════╪═════════
///                 └─────      ╰─▶ θ̇
///
///   T = −damping θ̇, T z_a on the body of `b`, −T z_a on the body of `a`      θ̇: rate of b against a about z_a
/// ```
///
/// The axes have to stay in one direction, as a revolute or cylindrical joint keeps them. Degenerate case: none.
///
/// Reference: Haug, section 9.5.
force torsion_damper(a: Axis, b: Axis, damping: Torque / AngularVelocity) in space {
    require a.body != b.body: "a torsion damper acts between two bodies";
    let line = damping * rate(joint_angle(a, b)) * z_axis(a);
    on b.body: -line;
    on a.body: line;
}
