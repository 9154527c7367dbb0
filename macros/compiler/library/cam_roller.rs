/// A roller follower on a disc cam: the roller's centre `C` stays on the pitch curve.
///
/// ```text
///       │ │
///       │ │
///      ( C ) ρ
///     ╱▔▔│▔▔▔▔▔╲
///    ╱   │ R + ρ╲
///   │    │ ) ψ   │
///   │    O──────────▶ x_cam
///    ╲__________╱
///
///   |r_C − r_O| − R(ψ) − ρ = 0                 1 row, m
///   ψ = arg(r_C − r_O) − φ_cam
/// ```
///
/// `O` is the centre of the cam and ρ the roller's radius. R + ρ is the pitch curve in polar
/// coordinates about `O`, on which a cutter of the roller's size moves when the cam is made: R is the
/// base circle's radius plus the follower's rise, the numbers a cam is designed from. The cam's
/// surface is the inner curve at distance ρ from the pitch curve; for R a constant it is the circle of
/// radius R, for any other it is not the curve R(ψ), since ρ is added along the radius and not along the
/// normal. Where the surface itself is given, the guide, `reuleaux::guide::cams`, has the equations of the
/// contact. ψ goes backwards as the cam turns; `R` must repeat after a full turn.
///
/// A law over the cam's own angle θ, which counts from the moment the follower stands on the cam's x axis, is written with
/// θ = −ψ; where the follower stands in another direction δ, with θ = δ − ψ. For a follower above the cam:
///
/// ```text
///   function R(psi: Angle) -> Length = 20mm + 8mm * cycloidal(wrap(90deg - psi) / 120deg);
/// ```
///
/// Degenerate case: where the pitch curve's radius of curvature falls below ρ the surface is
/// undercut, of which the compiler warns; the motion of the follower is still the one given here.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapter 7.
constraint cam_roller(O: Point, C: Point, roller: Length, R: Function(Angle) -> Length) {
    require roller > 0: "the radius of the roller is not positive: for a follower without a roller use `cam_knife`";
    require O.body != C.body: "cam and follower are the same body";
    norm(C - O) == R(direction(C - O) - O.body.angle) + roller;
}
