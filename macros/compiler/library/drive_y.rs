/// A point's y coordinate in ground follows a law of time.
///
/// ```text
///   y
///   │   ───────P──────
///   │          ▲
///   │          │ C(t)
///   └──────────┴───── x
///
///   y_P − C(t) = 0                             1 row, m
///   ν = Ċ
/// ```
///
/// As a load, its effort is the force on `P` along y (N); effort · Ċ is the power.
///
/// Reference: Nikravesh, section 4.2.6; Haug, section 3.5.
constraint drive_y(P: Point, C: Length) {
    P.y == C;
}
