/// A stop between two points: a buffer that keeps them from coming nearer than a length.
///
/// ```text
///    P      ▒▒▒│               Q
///   (o)─────▒▒▒│  ├───────────(o)
///     ◀── F ▒▒▒│                F ──▶
///          └ δ ┘
///    └──────────── l ─────────▶┘
///
///   F = force (δ / depth)^exponent (1 + damping δ̇), not below 0, pushes P and Q apart where δ > 0; otherwise F = 0
///   δ = length − l      l = |r_Q − r_P|
/// ```
///
/// A `force` (N) applied slowly presses the buffer in by `depth` (m). With the `exponent` 1.5 of Hertz, which it is unless said, force and
/// stiffness begin from zero; with 1 the stiffness jumps to force / depth. `damping` (s/m), such as `0.3s / 1m`, makes the force larger on the way
/// in than on the way out; it begins from zero too, and the stop never pulls. A body alone that comes at the speed v leaves at the speed w for
/// which v/c − ln(1 + c v)/c² = −w/c − ln(1 − c w)/c², c = damping: about v (1 − 2/3 c v). Without damping the stop gives back all its work,
/// force · depth / (exponent + 1) · (δ / depth)^(exponent + 1), which is in the potential energy.
///
/// For the other end of the travel, such as a rope or a cylinder that is out, write a `nonlinear_spring` with a law that is 0 up to its length; for
/// a floor, a wall or the ends of a guide, `stop_along`.
///
/// Degenerate case: at length zero the line has no direction.
///
/// Reference: Hunt and Crossley (1975), Coefficient of restitution interpreted as damping in vibroimpact.
force stop(
    P: Point,
    Q: Point,
    length: Length,
    force: Force,
    depth: Length,
    exponent: Number = 1.5,
    damping: Time / Length = 0,
) {
    require P.body != Q.body: "the two ends of a stop lie on the same body";
    require force >= 0: "a stop pushes, and its force is not negative";
    require depth > 0: "the depth of a stop, at which it has its force, is above zero";
    require exponent >= 1: "a stop with an exponent below 1 is infinitely stiff at first touch";
    require damping >= 0: "the damping of a stop is not negative";
    let line = Q - P;
    let pressed = length - norm(line);
    let elastic = if pressed > 0 { force * (pressed / depth)^exponent } else { 0 };
    potential: if pressed > 0 { force * depth / (exponent + 1) * (pressed / depth)^(exponent + 1) } else { 0 };
    let push = max(elastic * (1 + damping * rate(pressed)), 0) * unit(line);
    at P: -push;
    at Q: push;
}
