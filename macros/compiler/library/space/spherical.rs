/// Two points, one on each body, stay together; the bodies turn freely about them (a ball joint).
///
/// ```text
///       i      ╭───       j
///   ───────────┤ (●)───────────
///              ╰───  P = Q
///
///   r_P − r_Q = 0                              3 rows, m
/// ```
///
/// Removes three freedoms. Either point may lie on ground. The order of `P` and `Q` does not matter.
///
/// Degenerate case: both points on the same body, which is refused.
///
/// Reference: Nikravesh, Computer-Aided Analysis of Mechanical Systems, section 7.2; Haug, Computer Aided Kinematics and Dynamics of
/// Mechanical Systems, section 9.4.
constraint spherical(P: Point, Q: Point) in space {
    require P.body != Q.body: "the two points of a spherical joint lie on the same body";
    P == Q;
}
