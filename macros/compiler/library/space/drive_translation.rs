/// The displacement of a joint follows a law of time: a linear motor.
///
/// ```text
///       a ──▶      ┌───────┐
///   ═══════P═══════╪═══Q═══╪═══════
///     i    │       └───┬───┘ j
///          └── C(t) ──▶┘
///
///   z_a · (r_Q − r_P) − C(t) = 0               1 row, m
///   ν = Ċ
/// ```
///
/// `displacement` is a joint that has a displacement, or a displacement such as `rail.displacement`. Degenerate case: none.
///
/// As a load, its effort is the force along the axis of the joint on its second body, and its opposite on the first (N); effort · Ċ is the
/// power.
///
/// Reference: Haug, section 9.5.
constraint drive_translation(displacement: Length, C: Length) in space {
    displacement == C;
}
