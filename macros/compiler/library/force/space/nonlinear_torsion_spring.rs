/// A torsion spring in space whose torque is a law of the angle, about a common axis of two bodies: a rubber hinge, play, the end stops of a hinge.
///
/// ```text
///      a ──▶     law(θ)     ╭─  b ──▶
///   ══════════╡╱╲╱╲╱╲╱╲╞════╪═════════
///                           ╰─▶ θ
///
///   T = −law(θ), T z_a on the body of `b`, −T z_a on the body of `a`      θ: angle of b against a about z_a
/// ```
///
/// As with `torsion_spring`, a positive value turns `b` back. The law takes the angle (rad) and gives the torque (N m): a formula, a `table` or a
/// Rust function. A coupling with 2° of play to each side:
///
/// ```text
///   function play(angle: Angle) -> Torque = 300Nm_rad * (max(angle - 2deg, 0) + min(angle + 2deg, 0));
/// ```
///
/// The axes have to stay in one direction, as a revolute or cylindrical joint keeps them. What it stores is in the power; as a potential energy
/// write `energy name = …;` instead. Degenerate case: none.
///
/// Reference: Haug, section 9.5.
force nonlinear_torsion_spring(a: Axis, b: Axis, law: Function(Angle) -> Torque) in space {
    require a.body != b.body: "a torsion spring acts between two bodies";
    let line = law(joint_angle(a, b)) * z_axis(a);
    on b.body: -line;
    on a.body: line;
}
