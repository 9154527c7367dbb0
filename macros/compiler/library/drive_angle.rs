/// A body's angle follows a law of time.
///
/// ```text
///      ╱ b
///     ╱ ◀╮
///    ╱   │ C(t)
///   ╱____│___ x
///
///   φ − C(t) = 0                               1 row, rad
///   ν = Ċ,  γ = C̈
/// ```
///
/// Angles are never wrapped: after ten turns the angle is 20π.
///
/// As a load, its effort is the torque on `b` (N m), positive to the left; effort · Ċ is the power.
constraint drive_angle(b: Body, C: Angle) {
    b.angle == C;
}
