/// An angle brought between half a turn backwards and half a turn forwards.
///
/// ```text
///   wrap u = u − 2π n,  −π < wrap u ≤ π
/// ```
///
/// Coordinates are never wrapped; a law that must repeat after a turn, such as the outline of a cam, is written over
/// `wrap(u)`. Its derivative is 1, also where it jumps.
function wrap(u: Angle) -> Angle = atan2(sin(u), cos(u));
