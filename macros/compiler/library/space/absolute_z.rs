/// The z coordinate of a point is given.
///
/// ```text
///     z      ___________
///     │     ╱     P    ╱
///     │    ╱______▲___╱
///     │           │ c
///     o───────────┴───── y
///    ╱
///   x
///
///   z_P − c = 0                                1 row, m
/// ```
///
/// Removes one freedom. Degenerate case: none.
///
/// Reference: Haug, section 9.3.
constraint absolute_z(P: Point, c: Length) in space {
    P.z == c;
}
