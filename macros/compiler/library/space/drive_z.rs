/// The z coordinate of a point follows a law of time.
///
/// ```text
///     z      ___________
///     │     ╱     P    ╱
///     │    ╱______▲___╱
///     │           │ C(t)
///     o───────────┴───── y
///    ╱
///   x
///
///   z_P − C(t) = 0                             1 row, m
///   ν = Ċ
/// ```
///
/// Degenerate case: none.
///
/// As a load, its effort is the force on `P` along z (N); effort · Ċ is the power.
///
/// Reference: Haug, section 9.5.
constraint drive_z(P: Point, C: Length) in space {
    P.z == C;
}
