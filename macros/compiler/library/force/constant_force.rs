/// A spring that pulls with one force at every length: a tape that is wound up, a weight on a rope over a pulley far away.
///
/// ```text
///    P                          Q
///   (@)────────────────────────(o)
///      force ──▶      ◀── force
///
///   F = force along the line from P to Q, on both ends
/// ```
///
/// A negative force pushes. From one length to another it takes the work `force` times the difference. Degenerate case: at length zero the line
/// has no direction.
///
/// Reference: Haug, section 6.2.
force constant_force(P: Point, Q: Point, force: Force) {
    require P.body != Q.body: "the two ends of a spring lie on the same body";
    let line = unit(Q - P);
    potential: force * norm(Q - P);
    at P: force * line;
    at Q: -force * line;
}
