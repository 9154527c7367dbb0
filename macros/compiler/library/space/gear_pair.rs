/// The angles of two joints turn in a fixed ratio: spur, bevel and worm gears.
///
/// ```text
///      _________
///     ╱         ╲
///    ╱           ╲ ╱▔▔▔▔▔▔▔╲
///   │── a (o)     │   (o)─ b│
///    ╲           ╱ ╲_______╱
///     ╲_________╱
///      one  θ_1     two  θ_2
///
///   a θ_1 + b θ_2 − c = 0                      1 row; rad, or m with radii
/// ```
///
/// `one` and `two` are the angles of the joints that carry the wheels, `a` and `b` radii or numbers of teeth: both positive for wheels
/// that turn against each other about axes that point the same way. The axes may be parallel, intersecting or skew, and the carrier may
/// move. Removes one freedom; exact over any number of turns. Degenerate case: a factor of zero, which is refused.
///
/// Reference: Nikravesh, section 7.4.
constraint gear_pair(one: Angle, two: Angle, a: Quantity, b: Quantity, c: Quantity = 0) in space {
    require a != 0: "a wheel of size zero transmits nothing";
    require b != 0: "a wheel of size zero transmits nothing";
    a * one + b * two == c;
}
