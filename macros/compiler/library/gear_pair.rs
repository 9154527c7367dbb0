/// Two gears in mesh, with their axes on a carrier.
///
/// ```text
///      _________
///     ╱         ╲
///    ╱           ╲ ╱▔▔▔▔▔▔▔╲
///   │── a (o)═ k ═╪═══(o)─ b│
///    ╲           ╱ ╲_______╱
///     ╲_________╱
///          i           j
///
///   a (φ_i − φ_k) + b (φ_j − φ_k) − c = 0      1 row; rad, or m with radii
/// ```
///
/// `a` and `b` are pitch radii or numbers of teeth, with a sign: the same sign for an external mesh
/// (the gears turn against each other), opposite signs for an internal one. Angles count from the
/// carrier k, which is ground unless said, and are never wrapped: the row is exact over any number of
/// turns. `c` sets the phase; 0 unless said.
///
/// Place the gears with revolute joints on the carrier; the row says nothing about their centres. With pitch radii and both
/// joints on the carrier, the compiler warns if the radii miss the distance between them by more than 5 %.
/// Degenerate case: a = 0 or b = 0 is refused.
///
/// The row holds angles only, so that its load is torques, and bearings carry nothing of it. `involute_mesh` has the force between the
/// teeth, which loads the bearings.
///
/// Reference: Nikravesh, section 4.2.5, who writes the row in absolute angles; on a carrier that turns
/// only the relative angles are right (Willis, Principles of Mechanism).
constraint gear_pair(i: Body, j: Body, a: Quantity, b: Quantity, c: Quantity = 0, carrier: Body = ground) {
    require a != 0: "a gear without radius or teeth turns nothing: the ratio of a gear pair may not be zero";
    require b != 0: "a gear without radius or teeth turns nothing: the ratio of a gear pair may not be zero";
    require i != j: "a gear cannot mesh with itself";
    a * (i.angle - carrier.angle) + b * (j.angle - carrier.angle) == c;
}
