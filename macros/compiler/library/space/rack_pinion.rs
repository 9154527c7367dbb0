/// The angle of a joint moves a point along an axis: rack and pinion.
///
/// ```text
///     P               Q     a ──▶
///     o──────────────▶o
///    _________________│________
///   │__________________________│
///             ╱▔▔▔▔▔▔▔╲
///            │ θ (o)───│ radius
///             ╲_______╱
///
///   z_a · (r_Q − r_P) + radius θ − c = 0       1 row, m
/// ```
///
/// `angle` is that of the pinion's joint, `a` the direction of the rack on the carrier, through `P`; `Q` lies on the rack. Removes one
/// freedom; exact over any number of turns. Degenerate case: a radius of zero, which is refused.
///
/// Reference: Nikravesh, section 7.4.
constraint rack_pinion(angle: Angle, P: Point, a: Axis, Q: Point, radius: Length, c: Length = 0mm) in space {
    require radius != 0: "a pinion of radius zero moves nothing";
    require P.body == a.body: "the point and the direction of the rack belong to one body";
    require P.body != Q.body: "the rack and its carrier are the same body";
    along(a, Q - P) + radius * angle == c;
}
