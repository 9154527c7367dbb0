/// Sun, ring and carrier of a planetary gear train.
///
/// ```text
///      _________________
///    ╱                   ╲──────── ring  z_ring
///   │╱▔▔▔▔╲ ╱▔▔▔▔▔╲ ╱▔▔▔▔╲│
///   │   o══╪═══o═══╪══o═══╪═══════ carrier
///   │╲____╱ ╲__│__╱ ╲____╱│
///    ╲_________│_________╱
///              └────────────────── sun   z_sun
///
///   z_s (φ_s − φ_c) + z_r (φ_r − φ_c) − c = 0  1 row, rad (or m with radii)
/// ```
///
/// `z_sun` and `z_ring` are numbers of teeth or pitch radii, both positive for the usual train with
/// an internal ring; with a negative one it is a train with two sun gears. This is Willis' equation: seen
/// from the carrier, sun and ring turn against each other by −z_r/z_s. A planet's own angle follows
/// from `gear_pair(sun, planet, z_sun, z_planet, carrier: arm)`. Any of the three may be ground.
/// A ring that is not larger than its sun is a warning. Degenerate case: no teeth are refused.
///
/// Reference: Willis, Principles of Mechanism; Müller, Epicyclic Drive Trains.
constraint planetary(sun: Body, ring: Body, carrier: Body, z_sun: Quantity, z_ring: Quantity, c: Quantity = 0) {
    require z_sun != 0: "a sun gear without teeth turns nothing: `z_sun` may not be zero";
    require z_ring != 0: "a ring gear without teeth turns nothing: `z_ring` may not be zero";
    require sun != ring: "sun and ring of a planetary train are the same body";
    require sun != carrier: "sun and carrier of a planetary train are the same body";
    require ring != carrier: "ring and carrier of a planetary train are the same body";
    z_sun * (sun.angle - carrier.angle) + z_ring * (ring.angle - carrier.angle) == c;
}
