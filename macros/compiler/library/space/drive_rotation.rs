/// The angle of a joint follows a law of time: a motor.
///
/// ```text
///       ┌───────┐      ╭─
///   i ══╡       ╞══════╪══════ j
///       └───────┘      ╰─▶ C(t)
///
///   θ − C(t) = 0                               1 row, rad
///   ν = Ċ
/// ```
///
/// `angle` is a joint that has an angle, or an angle such as `axle.angle`. Exact over any number of turns. Degenerate case: none.
///
/// As a load, its effort is the torque about the axis of the joint on its second body, and its opposite on the first (N m); effort · Ċ is the
/// power.
///
/// Reference: Haug, section 9.5.
constraint drive_rotation(angle: Angle, C: Angle) in space {
    angle == C;
}
