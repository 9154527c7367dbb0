/// Two involute gears in mesh, with the force between their teeth.
///
/// ```text
///                            _______
///      _____              _▟╱       ╲
///    ╱       ╲        _─▔  ╱         ╲
///   │   A(o)══╪══ k ═P════│═══(o)B    │        base circles, radii |a| cos α and |b| cos α,
///    ╲       ╱   _─▔       ╲         ╱         and the taut line of the teeth
///      ▔▔▔▔▔▜─▔             ╲_______╱
///
///   a (φ_A − φ_k − θ) + b (φ_B − φ_k − θ) − c − s sgn(b) |a + b| (inv α' − inv α) = 0      1 row, m
///   θ = arg(r_B − r_A) − φ_k − line,  cos α' = |a + b| cos α / |r_B − r_A|,  inv α = tan α − α
/// ```
///
/// `A` and `B` are the centres, points of the gears; `a` and `b` are pitch radii with signs as in `gear_pair`: the same sign for an
/// external mesh, opposite ones for an internal one, in which the larger gear is the ring. α is the `pressure_angle` at the pitch circles,
/// `line` the direction from A to B on the carrier k, which is ground unless said, and `c` the phase, 0 unless said. `side` s is 1 or −1.
///
/// Place the gears with revolute joints on the carrier. At the distance |a + b| the row is that of `gear_pair`. At another
/// distance the ratio is the same, and the angle of action α' is another: the line unwinds from one base circle onto the other. Angles of
/// gears are never wrapped, and the carrier may turn any number of times; on the carrier, the line of centres may turn by less than a quarter of a
/// turn from `line`. Beyond that, as where the `carrier` was forgotten, the row has no value, and the motion ends.
///
/// The multiplier λ is the force of the teeth at the pitch circles in N, with the torques −λ a on A and −λ b on B. Their normal force
/// is λ / cos α: it acts along the taut line, at α' to the common tangent of the circles that roll on each other. Bearings carry it; the
/// carrier gets nothing but what they pass on. With `side` 1 the line is that of the flanks by which A drives to the left, or is driven to
/// the right: λ a is positive where they are pressed. With `side` −1 it is that of the other flanks, and λ a is negative where they are
/// pressed. Where λ a and `side` have unlike signs the teeth would have to pull: the other side carries. At the distance |a + b| the
/// motion is the same on both sides.
///
/// Degenerate case: a = 0, b = 0 and a + b = 0 are refused. Where |r_B − r_A| < |a + b| cos α, the base circles have no common tangent
/// between the teeth, and the row has no value; where they are equal, it has no derivative.
///
/// Reference: Norton, Design of Machinery, chapter 9; Litvin and Fuentes, Gear Geometry and Applied Theory, chapter 10.
constraint involute_mesh(
    A: Point, B: Point, a: Length, b: Length, line: Angle, pressure_angle: Angle = 20deg, side: Number = 1, c: Length = 0,
    carrier: Body = ground
) {
    require a != 0: "a gear without radius turns nothing: the pitch radius of a gear may not be zero";
    require b != 0: "a gear without radius turns nothing: the pitch radius of a gear may not be zero";
    require b != -a: "a gear as large as its ring gear does not roll in it: the sum of the signed pitch radii may not be zero";
    require pressure_angle > 0: "a pressure angle is positive: teeth with radial flanks are no involutes";
    require pressure_angle < 90deg: "a pressure angle is less than a right angle: the base circle has a radius";
    require side^2 == 1: "the side of a mesh is 1 where the gear of `A` drives to the left, and -1 where it drives to the right";
    require A.body != B.body: "a gear cannot mesh with itself";
    require carrier != A.body: "a gear does not carry its own mesh: the `carrier` is the body on which both gears have their axes";
    require carrier != B.body: "a gear does not carry its own mesh: the `carrier` is the body on which both gears have their axes";
    let seen = carrier.angle + line;
    // The root has no value where the line of centres has turned by more than a quarter of a turn.
    let ahead = sqrt(dot((cos(seen), sin(seen)), B - A))^2;
    let turned = atan(cross((cos(seen), sin(seen)), B - A) / ahead);
    let base = abs(a + b) * cos(pressure_angle);
    let taut = sqrt(dot(B - A, B - A) - base^2);
    let unwound = taut - base * atan(taut / base) - base * (tan(pressure_angle) - pressure_angle);
    let sense = side * b / abs(b) / cos(pressure_angle);
    a * (A.body.angle - carrier.angle - turned) + b * (B.body.angle - carrier.angle - turned) - c == sense * unwound;
}
