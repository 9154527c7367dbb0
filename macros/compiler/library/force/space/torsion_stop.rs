/// The end stops of a hinge in space: buffers that keep the angle of one body against another about their common axis in a range.
///
/// ```text
///      a ──▶    ▒▒ greatest  ╭─  b ──▶
///   ══════════╡▒    ▒╞═══════╪═════════
///               ▒▒ least     ╰─▶ θ
///
///   T = torque (δ / depth)^exponent (1 + damping δ̇), not below 0, turns θ back into the range where δ > 0; otherwise T = 0
///   δ = least − θ or θ − greatest, whichever is larger      θ: angle of b against a about z_a
/// ```
///
/// Within the range there is no torque. A `torque` (N m) applied slowly presses a buffer in by `depth` (rad). With the `exponent` 1.5, which it is
/// unless said, torque and stiffness begin from zero; with 1 the stiffness jumps to torque / depth. `damping` (s/rad), such as `0.3s / 1rad`, makes
/// the torque larger on the way in than on the way out, as with `stop`; a buffer never pulls. Without damping it gives back all its work,
/// torque · depth / (exponent + 1) · (δ / depth)^(exponent + 1), which is in the potential energy.
///
/// The axes have to stay in one direction, as a revolute or cylindrical joint keeps them. θ is `joint_angle(a, b)`. Degenerate case: none.
///
/// Reference: Hunt and Crossley (1975), Coefficient of restitution interpreted as damping in vibroimpact.
force torsion_stop(
    a: Axis,
    b: Axis,
    least: Angle,
    greatest: Angle,
    torque: Torque,
    depth: Angle,
    exponent: Number = 1.5,
    damping: Time / Angle = 0,
) in space {
    require a.body != b.body: "a stop of a hinge acts between two bodies";
    require least < greatest: "the least angle of a stop comes before the greatest";
    require torque >= 0: "a stop pushes, and its torque is not negative";
    require depth > 0: "the depth of a stop, at which it has its torque, is above zero";
    require exponent >= 1: "a stop with an exponent below 1 is infinitely stiff at first touch";
    require damping >= 0: "the damping of a stop is not negative";
    let angle = joint_angle(a, b);
    let pressed = max(least - angle, angle - greatest);
    let elastic = if pressed > 0 { torque * (pressed / depth)^exponent } else { 0 };
    potential: if pressed > 0 { torque * depth / (exponent + 1) * (pressed / depth)^(exponent + 1) } else { 0 };
    let push = max(elastic * (1 + damping * rate(pressed)), 0);
    let back = if least - angle > angle - greatest { push } else { -push };
    on b.body: back * z_axis(a);
    on a.body: -back * z_axis(a);
}
