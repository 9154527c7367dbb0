/// The displacement of a joint follows a law of time: a linear motor.
///
/// ```text
///   z_a · (r_Q − r_P) − C(t) = 0               1 row, m
///   ν = Ċ
/// ```
///
/// `displacement` is a joint that has a displacement, or a displacement such as `rail.displacement`. Degenerate case: none.
///
/// Reference: Haug, section 9.5.
constraint drive_translation(displacement: Length, C: Length) in space {
    displacement == C;
}
