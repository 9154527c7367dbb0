/// A knife-edge follower on a disc cam: the point `F` of the follower stays on the cam's outline.
///
/// ```text
///      │   │
///       ╲ ╱
///      __F__
///     ╱  │  ╲
///    ╱   │ R ╲
///   │    │ ) ψ│
///   │    O───────▶ x_cam
///    ╲_______╱
///
///   |r_F − r_O| − R(ψ) = 0                     1 row, m
///   ψ = arg(r_F − r_O) − φ_cam
/// ```
///
/// `O` is the centre of the cam, `R` the outline in polar coordinates about `O`: its radius, seen at
/// the angle ψ from the cam's own x axis. ψ goes backwards as the cam turns; `R` must repeat after a
/// full turn. Guide the follower with a joint of its own, in a line or about a pivot.
///
/// A law over the cam's own angle θ, which counts from the moment the follower stands on the cam's x axis, is written with
/// θ = −ψ; where the follower stands in another direction δ, with θ = δ − ψ. For a follower above the cam:
///
/// ```text
///   function R(psi: Angle) -> Length = 20mm + 8mm * cycloidal(wrap(90deg - psi) / 120deg);
/// ```
///
/// Degenerate case: R = 0, where the outline meets the centre and ψ has no value.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapter 7.
constraint cam_knife(O: Point, F: Point, R: Function(Angle) -> Length) {
    require O.body != F.body: "cam and follower are the same body";
    norm(F - O) == R(direction(F - O) - O.body.angle);
}
