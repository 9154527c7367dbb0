/// A point keeps its y coordinate in ground.
///
/// ```text
///   y
///   │   ───────P──────
///   │          ▲
///   │          │ c
///   └──────────┴───── x
///
///   y_P − c = 0                                1 row, m
/// ```
///
/// γ = (x' sin φ + y' cos φ) φ̇² with the local coordinates x', y' of `P`: a point that is held still demands acceleration of a
/// body that turns.
///
/// Reference: Nikravesh, section 4.2.1.
constraint absolute_y(P: Point, c: Length) {
    P.y == c;
}
