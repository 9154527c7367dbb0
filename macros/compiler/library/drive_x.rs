/// A point's x coordinate in ground follows a law of time.
///
/// ```text
///   y          │
///   │          │
///   ├─ C(t) ──▶P
///   │          │
///   └──────────────── x
///
///   x_P − C(t) = 0                             1 row, m
///   ν = Ċ
/// ```
///
/// As a load, its effort is the force on `P` along x (N); effort · Ċ is the power.
///
/// Reference: Nikravesh, section 4.2.6; Haug, section 3.5.
constraint drive_x(P: Point, C: Length) {
    P.x == C;
}
