/// A torsion spring and a torsion damper in parallel between two bodies in the plane.
///
/// ```text
///         ╱ two
///        ╱────╮
///       ╱   │ ┴ │ damping
///      ╱    └─┬─┘
///    (@)──────┴───── one
///   stiffness
///
///   T = −stiffness (φ_two − φ_one − rest) − damping (φ̇_two − φ̇_one) on `two`, −T on `one`
/// ```
///
/// Angles are not wrapped: the spring remembers whole turns. Degenerate case: none.
///
/// Reference: Nikravesh, section 9.4; Haug, section 6.2.
force torsion_spring_damper(
    one: Body,
    two: Body,
    stiffness: Torque / Angle,
    rest: Angle,
    damping: Torque / AngularVelocity,
) in plane {
    require one != two: "a torsion spring acts between two bodies";
    let turning = two.angular_velocity - one.angular_velocity;
    let torque = stiffness * (two.angle - one.angle - rest) + damping * turning;
    potential: 0.5 * stiffness * (two.angle - one.angle - rest)^2 / 1rad;
    on two: -torque;
    on one: torque;
}
