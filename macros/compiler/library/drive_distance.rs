/// The distance of two points follows a law of time: a hydraulic cylinder, a linear motor with a pin
/// at each end.
///
/// ```text
///    P   ┌─────────────┐           Q
///   (o)──┤         ║───┼──────────(o)
///        └─────────────┘
///    └──────────── C(t) ──────────▶┘
///
///   (r_Q − r_P)ᵀ(r_Q − r_P) − C(t)² = 0        1 row, m²
///   ν = 2 C Ċ
///   γ = γ_distance + 2 C C̈ + 2 Ċ²
/// ```
///
/// Degenerate case: where C passes through zero the row's derivative vanishes, and the distance could grow again on either side. A
/// motion through it goes on smoothly; no state can be found there from a guess. A law that is constantly zero is refused.
///
/// Reference: Nikravesh, section 4.2.6; Haug, section 3.5.
constraint drive_distance(P: Point, Q: Point, C: Length) {
    require C != 0: "a distance of zero cannot be differentiated where it holds: use `revolute`, in space `spherical`, to keep two points together";
    require P.body != Q.body: "the two points of a distance drive lie on the same body";
    dot(Q - P, Q - P) == C^2;
}
