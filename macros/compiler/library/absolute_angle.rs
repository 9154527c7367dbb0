/// A body keeps its angle: it moves without turning.
///
/// ```text
///      ╱ b              ╱ b
///     ╱                ╱
///    ╱ ) c            ╱ ) c
///   ╱_______ x       ╱_______ x
///
///   φ − c = 0                                  1 row, rad
/// ```
///
/// Angles are never wrapped: `c` may be several turns.
constraint absolute_angle(b: Body, c: Angle) {
    b.angle == c;
}
