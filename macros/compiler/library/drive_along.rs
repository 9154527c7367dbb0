/// The displacement along a translational joint follows a law of time.
///
/// ```text
///         u ──▶
///   ──────P─────────[ Q ]────
///         └─ C(t) ───▶┘
///
///   û · (r_Q − r_P) − C(t) = 0                 1 row, m
/// ```
///
/// `slide` is the name of the joint that is driven; û, `P` and `Q` are its axis and points.
///
/// ```text
///   joint slide = translational(ground.u, ground.O, ram.O);
///   drive push = drive_along(slide, 20mm * sin(speed * t));
/// ```
///
/// As a load, its effort is the force on the body of `Q` along û, and its opposite on that of `P` (N); effort · Ċ is the power.
constraint drive_along(slide: Joint(translational), C: Length) {
    dot(unit(slide.u), slide.Q - slide.P) == C;
}
