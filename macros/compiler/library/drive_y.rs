/// A point's y coordinate in ground follows a law of time.
///
/// ```text
///   y_P − C(t) = 0                             1 row, m
///   ν = Ċ
/// ```
///
/// Reference: Nikravesh, section 4.2.6; Haug, section 3.5.
constraint drive_y(P: Point, C: Length) {
    P.y == C;
}
