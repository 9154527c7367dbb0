/// Sun, ring and carrier of a planetary gear train.
///
/// ```text
///          ┌──────┐
///          │    ──┴──     z_ring
///          │    ──┬──
///   ring ──┘      o──────┐
///               ──┴──    │
///               ──┬──    │  z_sun
///    sun ─────────┘      └── carrier
///
///   z_s (θ_s − θ_c) + z_r (θ_r − θ_c) − c = 0  1 row, rad (or m with radii)
/// ```
///
/// `sun`, `ring` and `carrier` are the angles of their joints, all against one body about axes that point the same way; for the one that
/// rests in that body write 0. `z_sun` and `z_ring` are numbers of teeth or pitch radii, both positive for the usual train with an internal
/// ring; with a negative one it is a train with two sun gears. A planet's own angle against the carrier follows from a
/// `gear_pair`. Removes one freedom; exact over any number of turns. Degenerate case: no teeth are refused.
///
/// Reference: Willis, Principles of Mechanism; Müller, Epicyclic Drive Trains.
constraint planetary(sun: Angle, ring: Angle, carrier: Angle, z_sun: Quantity, z_ring: Quantity, c: Quantity = 0) in space {
    require z_sun != 0: "a sun gear without teeth turns nothing: `z_sun` may not be zero";
    require z_ring != 0: "a ring gear without teeth turns nothing: `z_ring` may not be zero";
    z_sun * (sun - carrier) + z_ring * (ring - carrier) == c;
}
