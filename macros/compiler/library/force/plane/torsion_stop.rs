/// The end stops of a hinge in the plane: buffers that keep the angle of one body against another in a range.
///
/// ```text
///      greatest ▒▒   ╱ two
///              ▒▒   ╱
///               ╲  ╱ ) φ = φ_two − φ_one
///                (o)──────────── one
///                  ╲▒▒
///                   ▒▒ least
///
///   T = torque (δ / depth)^exponent (1 + damping δ̇), not below 0, turns φ back into the range where δ > 0; otherwise T = 0
///   δ = least − φ or φ − greatest, whichever is larger
/// ```
///
/// Within the range there is no torque. A `torque` (N m) applied slowly presses a buffer in by `depth` (rad). With the `exponent` 1.5, which it is
/// unless said, torque and stiffness begin from zero; with 1 the stiffness jumps to torque / depth. `damping` (s/rad), such as `0.3s / 1rad`, makes
/// the torque larger on the way in than on the way out, as with `stop`; a buffer never pulls. Without damping it gives back all its work,
/// torque · depth / (exponent + 1) · (δ / depth)^(exponent + 1), which is in the potential energy.
///
/// Angles are not wrapped: a body that comes round once more comes from behind. Degenerate case: none.
///
/// Reference: Hunt and Crossley (1975), Coefficient of restitution interpreted as damping in vibroimpact.
force torsion_stop(
    one: Body,
    two: Body,
    least: Angle,
    greatest: Angle,
    torque: Torque,
    depth: Angle,
    exponent: Number = 1.5,
    damping: Time / Angle = 0,
) in plane {
    require one != two: "a stop of a hinge acts between two bodies";
    require least < greatest: "the least angle of a stop comes before the greatest";
    require torque >= 0: "a stop pushes, and its torque is not negative";
    require depth > 0: "the depth of a stop, at which it has its torque, is above zero";
    require exponent >= 1: "a stop with an exponent below 1 is infinitely stiff at first touch";
    require damping >= 0: "the damping of a stop is not negative";
    let angle = two.angle - one.angle;
    let pressed = max(least - angle, angle - greatest);
    let elastic = if pressed > 0 { torque * (pressed / depth)^exponent } else { 0 };
    potential: if pressed > 0 { torque * depth / (exponent + 1) * (pressed / depth)^(exponent + 1) } else { 0 };
    let push = max(elastic * (1 + damping * rate(pressed)), 0);
    let back = if least - angle > angle - greatest { push } else { -push };
    on two: back;
    on one: -back;
}
