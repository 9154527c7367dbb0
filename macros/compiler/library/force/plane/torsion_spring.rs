/// A torsion spring between two bodies in the plane.
///
/// ```text
///         ╱ two
///        ╱
///       ╱ ) φ_two − φ_one
///    (@)──────────── one
///   stiffness
///
///   T = −stiffness (φ_two − φ_one − rest) on `two`, −T on `one`
/// ```
///
/// Angles are not wrapped: the spring remembers whole turns. Degenerate case: none.
///
/// Reference: Nikravesh, section 9.4; Haug, section 6.2.
force torsion_spring(one: Body, two: Body, stiffness: Torque / Angle, rest: Angle) in plane {
    require one != two: "a torsion spring acts between two bodies";
    let torque = stiffness * (two.angle - one.angle - rest);
    potential: 0.5 * stiffness * (two.angle - one.angle - rest)^2 / 1rad;
    on two: -torque;
    on one: torque;
}
