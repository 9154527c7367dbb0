/// A point keeps its x coordinate in ground.
///
/// ```text
///   y          │
///   │          │
///   ├─── c ───▶P
///   │          │
///   └──────────────── x
///
///   x_P − c = 0                                1 row, m
/// ```
///
/// γ = (x' cos φ − y' sin φ) φ̇² with the local coordinates x', y' of `P`: a point that is held still demands acceleration of a
/// body that turns.
///
/// Reference: Nikravesh, section 4.2.1.
constraint absolute_x(P: Point, c: Length) {
    P.x == c;
}
