/// A stop in one direction of a body: a floor, a wall, an end of a guide.
///
/// ```text
///         u ──▶     │▒▒▒
///   ──────P─────────│▒▒▒  [ Q ]────
///                   │▒▒▒   F ──▶
///         └── limit ────▶┘
///
///   F = force (δ / depth)^exponent (1 + damping δ̇), not below 0, F u on the body of `Q` at Q where δ > 0; otherwise F = 0
///   −F u on the body of `P` at the same place      δ = limit − u · (r_Q − r_P)
/// ```
///
/// `P` and the axis `u`, of unit length here, belong to one body, `Q` to another one. The stop keeps Q beyond `limit` (m) from P along u; what Q does
/// across u is free. The other end of a guide is a stop along an axis that points the other way, with the opposite limit; a ball on a floor has its
/// radius as limit. `force` (N), `depth` (m), `exponent` and `damping` (s/m), and the speed after a rebound, are those of `stop`.
///
/// Degenerate case: none.
///
/// Reference: Hunt and Crossley (1975), Coefficient of restitution interpreted as damping in vibroimpact.
force stop_along(
    P: Point,
    u: Axis,
    Q: Point,
    limit: Length,
    force: Force,
    depth: Length,
    exponent: Number = 1.5,
    damping: Time / Length = 0,
) {
    require P.body == u.body: "the first point and the axis of a stop belong to one body";
    require P.body != Q.body: "the two points of a stop lie on the same body";
    require force >= 0: "a stop pushes, and its force is not negative";
    require depth > 0: "the depth of a stop, at which it has its force, is above zero";
    require exponent >= 1: "a stop with an exponent below 1 is infinitely stiff at first touch";
    require damping >= 0: "the damping of a stop is not negative";
    let d = Q - P;
    let pressed = limit - dot(unit(u), d);
    let elastic = if pressed > 0 { force * (pressed / depth)^exponent } else { 0 };
    potential: if pressed > 0 { force * depth / (exponent + 1) * (pressed / depth)^(exponent + 1) } else { 0 };
    let push = max(elastic * (1 + damping * rate(pressed)), 0) * unit(u);
    at Q: push;
    at P: -push;
    on P.body: -cross(d, push);
}
