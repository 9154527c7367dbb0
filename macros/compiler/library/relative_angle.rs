/// Two bodies keep the angle between them.
///
/// ```text
///      ╱ j
///     ╱
///    ╱ ) c
///   ╱_______ i
///
///   φ_j − φ_i − c = 0                          1 row, rad
/// ```
///
/// Angles are never wrapped: `c` may be several turns. Either body may be ground.
constraint relative_angle(i: Body, j: Body, c: Angle) {
    require i != j: "a body cannot turn against itself";
    j.angle - i.angle == c;
}
