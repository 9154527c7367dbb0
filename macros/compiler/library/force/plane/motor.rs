/// A torque between two bodies in the plane: a motor, a brake, a load.
///
/// ```text
///           ╭▶     ◀╮
///      one  │−T   T │  two
///   ────────┴──(o)──┴────────
///
///   T on `two`, −T on `one`
/// ```
///
/// The torque may depend on time, on speeds and on anything else. Degenerate case: none.
///
/// Reference: Haug, section 6.2.
force motor(one: Body, two: Body, torque: Torque) in plane {
    require one != two: "a motor turns one body against another one";
    on two: torque;
    on one: -torque;
}
