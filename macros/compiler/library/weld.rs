/// Two bodies become one: a point of each stays together and the angle between them is kept.
///
/// ```text
///                ╱ j
///               ╱
///       i      ╱ ) c
///   ──────────●─ ─ ─ ─
///           P = Q
///
///   r_P − r_Q     = 0                          rows 1 and 2, m
///   φ_j − φ_i − c = 0                          row 3, rad
/// ```
///
/// `P` lies on body i, `Q` on body j, `c` is 0 unless said. Removes three freedoms. Where the bodies
/// are never taken apart, one body with more points is cheaper.
///
/// Reference: Shabana, Computational Dynamics, section 3.3.
constraint weld(P: Point, Q: Point, c: Angle = 0) {
    require P.body != Q.body: "the two points of a weld lie on the same body";
    P == Q;
    Q.body.angle - P.body.angle == c;
}
