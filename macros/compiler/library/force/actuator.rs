/// A force along the line between two points: a hydraulic cylinder, a muscle.
///
/// ```text
///          P   ┌────────────┐        Q
///   F ◀───(o)──┤        ║───┼───────(o)───▶ F
///              └────────────┘
///
///   F pushes P and Q apart
/// ```
///
/// The force may depend on time and on anything else. Degenerate case: at length zero the line has no direction.
///
/// Reference: Haug, section 6.2.
force actuator(P: Point, Q: Point, F: Force) {
    require P.body != Q.body: "the two ends of an actuator lie on the same body";
    let line = unit(Q - P);
    at P: -F * line;
    at Q: F * line;
}
