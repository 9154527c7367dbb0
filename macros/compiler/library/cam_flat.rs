/// A flat-faced follower on a disc cam: the face stays a tangent of the cam's outline.
///
/// ```text
///       ▲ n
///       │
///   ____F_____________________
///            ╱▔▔▔│▔▔▔╲
///           ╱    │ h  ╲
///          │     │ ) ψ │
///          │     O────────▶ x_cam
///           ╲_________╱
///
///   n · (r_F − r_O) − h(ψ) = 0                 1 row, m
///   ψ = arg n − φ_cam
/// ```
///
/// `F` is a point of the face and `n` its normal, away from the cam, both on the follower. `h` is the
/// support function of the outline: the distance from the centre `O` to the tangent whose normal has
/// the angle ψ in the cam. For a follower that moves along `n` it is the base circle's radius plus the
/// rise. The point of contact lies h'(ψ) beside the foot of the normal through `O`. ψ goes backwards as
/// the cam turns; `h` must repeat after a full turn.
///
/// A law over the cam's own angle θ, which counts from the moment the follower stands on the cam's x axis, is written with
/// θ = −ψ; where the follower stands in another direction δ, with θ = δ − ψ. For a follower above the cam:
///
/// ```text
///   function h(psi: Angle) -> Length = 20mm + 8mm * cycloidal(wrap(90deg - psi) / 120deg);
/// ```
///
/// Degenerate case: where h + h'' ≤ 0 the outline is not convex and the face would cut into it, of which the compiler warns.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapter 7.
constraint cam_flat(O: Point, F: Point, n: Axis, h: Function(Angle) -> Length) {
    require n.body == F.body: "the normal and the point of the face do not lie on the same follower";
    require O.body != F.body: "cam and follower are the same body";
    dot(unit(n), F - O) == h(direction(n) - O.body.angle);
}
