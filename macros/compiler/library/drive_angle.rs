/// A body's angle follows a law of time.
///
/// ```text
///   φ − C(t) = 0                               1 row, rad
///   ν = Ċ,  γ = C̈
/// ```
///
/// Angles are never wrapped: after ten turns the angle is 20π.
constraint drive_angle(b: Body, C: Angle) {
    b.angle == C;
}
