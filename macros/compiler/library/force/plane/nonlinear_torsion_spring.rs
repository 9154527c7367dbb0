/// A torsion spring between two bodies in the plane whose torque is a law of the angle: a rubber hinge, play, the end stops of a hinge.
///
/// ```text
///         ╱ two
///        ╱
///       ╱ ) φ_two − φ_one
///    (@)──────────── one
///   law(φ)
///
///   T = −law(φ_two − φ_one) on `two`, −T on `one`
/// ```
///
/// As with `torsion_spring`, a positive value turns `two` back. The law takes the angle (rad) and gives the torque (N m): a formula, a `table` or
/// a Rust function. A coupling with 2° of play to each side:
///
/// ```text
///   function play(angle: Angle) -> Torque = 300Nm_rad * (max(angle - 2deg, 0) + min(angle + 2deg, 0));
/// ```
///
/// Angles are not wrapped: the spring remembers whole turns. What it stores is in the power; as a potential energy write `energy name = …;`
/// instead. Degenerate case: none.
///
/// Reference: Nikravesh, section 9.4; Haug, section 6.2.
force nonlinear_torsion_spring(one: Body, two: Body, law: Function(Angle) -> Torque) in plane {
    require one != two: "a torsion spring acts between two bodies";
    let torque = law(two.angle - one.angle);
    on two: -torque;
    on one: torque;
}
