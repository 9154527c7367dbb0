/// A pinion rolls on a rack; both are guided by a carrier.
///
/// ```text
///   origin          rack    u ──▶
///     o──────────────▶o
///    _________________│________
///   │__________________________│
///             ╱▔▔▔▔▔▔▔╲
///            │   (o)─ R│ pinion
///             ╲_______╱
///
///   R (φ_p − φ_k) + û · (r_P − r_k) − c = 0    1 row, m
/// ```
///
/// `rack` is a point of the rack, `u` the direction of the rack's travel and `origin` the place it is
/// measured from, both on the carrier k. With R > 0 the rack moves backwards along `u` as the pinion
/// turns to the left; R may be negative. `c` sets the phase; 0 unless said. Angles are never wrapped.
///
/// Place the pinion with a revolute joint and the rack with a translational joint on the carrier.
/// Degenerate case: R = 0 is refused.
///
/// The multiplier λ is the driving part of the tooth force, in N. The rack gets −λ û at the point `rack`, the pinion the torque −λ R, the
/// carrier λ û on the line through `rack`, and the torque λ R. Teeth with the pressure angle α press on each other with |λ| / cos α. The row
/// leaves out two forces of that: the pinion's bearing carries λ û, and |λ| tan α away from the rack; the guide of the rack carries |λ| tan α
/// away from the pinion, at the contact. Let `rack` lie on the pitch line, |R| from the pinion's
/// centre: at a distance h from that line the torque on the guide is off by λ h.
///
/// Reference: Haug, section 3.4.
constraint rack_pinion(pinion: Body, rack: Point, u: Axis, origin: Point, R: Length, c: Length = 0) {
    require R != 0: "a pinion without radius moves nothing: the radius of a rack and pinion may not be zero";
    require u.body == origin.body: "the axis and the origin of a rack do not lie on the same carrier";
    R * (pinion.angle - origin.body.angle) + dot(unit(u), rack - origin) == c;
}
