/// A point keeps its distance from a place in ground.
///
/// ```text
///     C                 P
///    (o)───────────────(o)
///   ──┴──      c
///   /////
///
///   hᵀh − c² = 0,  h = r_P − C                 1 row, m²
/// ```
///
/// `C` is a point of ground, or a place such as `(0.1m, 0.2m)`. Degenerate case: c = 0 is refused, a
/// `revolute` joint keeps two points together.
///
/// Reference: Nikravesh, section 4.2.1.
constraint absolute_distance(P: Point, C: Point, c: Length) {
    require c != 0: "a distance of zero cannot be differentiated where it holds: use `revolute` to keep a point in place";
    require c >= 0: "a distance is not negative";
    require C.body == ground: "the centre of an absolute distance does not lie on ground: use `distance` between two bodies";
    dot(P - C, P - C) == c^2;
}
