/// Two involute gears in mesh, with the force between their teeth.
///
/// ```text
///         φ_A                    φ_B
///      ╱▔▔▔▔▔▔▔▔╲            ╱▔▔▔▔▔▔▔▔▔▔▔▔╲
///     │  base    ╲  taut    ╱  base        │
///     │   ( A )───╲────────╱──────( B )    │      base circles: a cos α, b cos α
///     │  circle    ╲  line╱  circle        │      k carries both centres
///      ╲▁▁▁▁▁▁▁▁▁▁▁╱╲▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁╱
///
///   s cos α (a (φ_A − φ_k − θ) + b (φ_B − φ_k − θ) − c) ∓ |a + b| cos α (inv α' − inv α) = 0      1 row, m
///   θ = arg(r_B − r_A) − φ_k − line,  cos α' = |a + b| cos α / |r_B − r_A|,  inv α = tan α − α
/// ```
///
/// `A` and `B` are the centres, points of the gears; `a` and `b` are the pitch radii, with signs as in `gear_pair`: the same sign for an
/// external mesh, opposite ones for an internal one, the larger being the ring gear. α is the `pressure_angle` at the pitch circles, `line`
/// the direction from A to B as seen from the carrier k, which is ground unless said, and `c` the phase, 0 unless said. The upper sign is
/// that of an external mesh. (For a < 0 the first term takes the other sign.)
///
/// Place the gears with revolute joints on the carrier. At the distance |a + b| the row is that of `gear_pair`, times cos α. At another
/// distance the ratio stays the same and the angle of action α' changes: a taut line unwinds from one base circle onto the other.
/// Angles are never wrapped, and a carrier may turn any number of times; the line of centres may turn on it by less than half a turn.
///
/// The multiplier λ is the normal force between the teeth, in N. It acts along the taut line, at α' to the tangent of the pitch circles, with
/// the torque of λ times the base radius about each centre, so that the bearings carry it; the carrier gets none directly. λ is positive
/// where the teeth press on each other. `side` s says which flanks do: 1, unless said, where A drives to the left or is driven to the
/// right; −1 where A drives to the right or is driven to the left. A negative λ means that the other flanks carry; change `side`. At the
/// distance |a + b| both have the same motion.
///
/// Degenerate case: a = 0, b = 0 and a + b = 0 are refused. Where |r_B − r_A| ≤ |a + b| cos α, one base circle has no taut line to the
/// other, and the row no value.
///
/// Reference: Norton, Design of Machinery, chapter 9; Litvin and Fuentes, Gear Geometry and Applied Theory, chapter 10.
constraint involute_mesh(
    A: Point, B: Point, a: Length, b: Length, line: Angle, pressure_angle: Angle = 20deg, side: Number = 1, c: Length = 0,
    carrier: Body = ground
) {
    require a != 0: "a gear without radius turns nothing: the pitch radius of a gear may not be zero";
    require b != 0: "a gear without radius turns nothing: the pitch radius of a gear may not be zero";
    require a + b != 0: "a gear as large as its ring gear does not roll in it: the sum of the signed pitch radii may not be zero";
    require pressure_angle > 0: "a pressure angle is positive: teeth with radial flanks are no involutes";
    require pressure_angle < 90deg: "a pressure angle is less than a right angle: the base circle has a radius";
    require side^2 == 1: "`side` is 1 where the gear of `A` drives to the left, and -1 where it drives to the right";
    require A.body != B.body: "a gear cannot mesh with itself";
    require A.body != carrier: "a gear does not carry its own mesh: the `carrier` is the body on which both gears have their axes";
    require B.body != carrier: "a gear does not carry its own mesh: the `carrier` is the body on which both gears have their axes";
    let turned = wrap(direction(B - A) - carrier.angle - line);
    let base = abs(a + b) * cos(pressure_angle);
    let taut = sqrt(dot(B - A, B - A) - base^2);
    let unwound = taut - base * atan(taut / base) - base * (tan(pressure_angle) - pressure_angle);
    let rolled = a * (A.body.angle - carrier.angle - turned) + b * (B.body.angle - carrier.angle - turned) - c;
    a / abs(a) * cos(pressure_angle) * rolled == side * a * b / abs(a * b) * unwound;
}
