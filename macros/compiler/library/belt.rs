/// Two pulleys joined by a belt or chain that does not slip, with their axes on a carrier.
///
/// ```text
///     ╱▔▔▔▔▔▔▔╲▔▔▔▔▔───────◀───────▁▁▁▁▁▁▁▁▁
///    ╱         ╲                    ╱▔▔▔▔▔▔▔╲
///   │─ a (o)════╪══════ k ═════════╪═══(o)─ b│
///    ╲         ╱                    ╲_______╱
///     ╲_______╱_____───────▶───────▔▔▔▔▔▔▔▔▔
///         i                             j
///
///   a (φ_i − φ_k) − b (φ_j − φ_k) − c = 0      1 row; rad, or m with radii
/// ```
///
/// `a` and `b` are radii or numbers of teeth: positive ones for an open belt (both turn the same
/// way), one negative for a crossed belt. Angles count from the carrier k, ground unless said, and are
/// never wrapped. Degenerate case: a = 0 or b = 0 is refused.
///
/// The row holds angles only: the pulleys get the torques −λ a and λ b, the carrier λ (a − b), and bearings carry nothing of it. With
/// radii λ is the difference of the tensions of the two strands, in N; with numbers of teeth it is λ times the teeth of a pulley over its
/// radius. If each strand has the pretension F_0 at rest, a pulley pulls at its shaft with
///
/// ```text
///   F = √((2 F_0 cos β)² + (λ sin β)²),  sin β = (a − b) / d
/// ```
///
/// at a distance d of the centres: 2 F_0 cos β towards the other pulley, λ sin β across, to the right as seen from i on the shaft of i, and
/// the opposite on that of j. It takes 2 F_0 ≥ |λ| to keep both strands taut.
///
/// Reference: Shigley, Mechanical Engineering Design, flexible mechanical elements.
constraint belt(i: Body, j: Body, a: Quantity, b: Quantity, c: Quantity = 0, carrier: Body = ground) {
    require a != 0: "a pulley without radius turns nothing: the radius of a belt's pulley may not be zero";
    require b != 0: "a pulley without radius turns nothing: the radius of a belt's pulley may not be zero";
    require i != j: "a belt cannot join a pulley with itself";
    a * (i.angle - carrier.angle) == b * (j.angle - carrier.angle) + c;
}
