/// Two points keep their distance: a massless link with a pin at each end (revolute-revolute).
///
/// ```text
///    P                 Q
///   (o)───────────────(o)
///   i        c          j
///
///   (r_Q − r_P)ᵀ(r_Q − r_P) − c² = 0           1 row, m²
/// ```
///
/// Degenerate case: c = 0. Then the row's derivative vanishes where the row does; it is refused, a
/// `revolute` joint keeps two points together. A negative `c` means the same as a positive one.
///
/// Reference: Nikravesh, section 4.2.4; Haug, section 3.3.
constraint distance(P: Point, Q: Point, c: Length) {
    require c != 0: "a distance of zero cannot be differentiated where it holds: use `revolute`, in space `spherical`, to keep two points together";
    require c >= 0: "a distance is not negative";
    require P.body != Q.body: "the two points of a distance constraint lie on the same body";
    dot(Q - P, Q - P) == c^2;
}
