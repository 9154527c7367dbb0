/// A torsion damper between two bodies in the plane: viscous friction in a hinge.
///
/// ```text
///        ╱ two
///       ╱────╮
///      ╱   │ ┴ │ damping
///     ╱    └─┬─┘
///   (o)──────┴───── one
///
///   T = −damping (φ̇_two − φ̇_one) on `two`, −T on `one`
/// ```
///
/// Degenerate case: none.
///
/// Reference: Nikravesh, section 9.4; Haug, section 6.2.
force torsion_damper(one: Body, two: Body, damping: Torque / AngularVelocity) in plane {
    require one != two: "a torsion damper acts between two bodies";
    let torque = damping * (two.angular_velocity - one.angular_velocity);
    on two: -torque;
    on one: torque;
}
