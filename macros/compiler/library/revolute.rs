/// Two points, one on each body, stay together; the bodies turn freely about them (a hinge, a pin).
///
/// ```text
///        i        P = Q        j
///   ───────────────(o)───────────────
///
///   r_P − r_Q = 0                              2 rows, m
/// ```
///
/// Removes two freedoms. Either point may lie on ground. The order of `P` and `Q` does not matter.
///
/// Degenerate case: both points on the same body. Then the rows say nothing of how that body moves
/// and the joint is refused where the points are on ground.
///
/// Reference: Nikravesh, Computer-Aided Analysis of Mechanical Systems, section 4.2.3; Haug,
/// Computer Aided Kinematics and Dynamics of Mechanical Systems, section 3.3.
constraint revolute(P: Point, Q: Point) {
    require P.body != Q.body: "the two points of a revolute joint lie on the same body";
    P == Q;
}
