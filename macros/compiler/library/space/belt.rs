/// The angles of two joints turn in a fixed ratio the same way: a belt or chain that does not slip.
///
/// ```text
///     ╱▔▔▔▔▔▔▔╲▔▔▔▔▔───────◀───────▁▁▁▁▁▁▁▁▁
///    ╱         ╲                    ╱▔▔▔▔▔▔▔╲
///   │─ a (o)    │                  │   (o)─ b│
///    ╲         ╱                    ╲_______╱
///     ╲_______╱_____───────▶───────▔▔▔▔▔▔▔▔▔
///     one  θ_1                      two  θ_2
///
///   a θ_1 − b θ_2 − c = 0                      1 row; rad, or m with radii
/// ```
///
/// `one` and `two` are the angles of the joints that carry the pulleys, counted about axes that point the same way; `a` and `b` are radii or
/// numbers of teeth, positive ones for an open belt, one negative for a crossed belt. The carrier may move. Removes one freedom;
/// exact over any number of turns. Degenerate case: a radius of zero, which is refused.
constraint belt(one: Angle, two: Angle, a: Quantity, b: Quantity, c: Quantity = 0) in space {
    require a != 0: "a pulley without radius turns nothing: the radius of a belt's pulley may not be zero";
    require b != 0: "a pulley without radius turns nothing: the radius of a belt's pulley may not be zero";
    a * one == b * two + c;
}
