/// Rise from 0 to 1 with constant velocity.
///
/// ```text
///   s = u                                      0 ≤ u < 1
/// ```
///
/// 0 before u = 0, 1 from u = 1 on; its first derivative jumps at both ends. At u = 0 it is that of the rise and at u = 1 it is 0, so
/// that where one motion ends and the next begins only one of them counts.
/// Peak values: velocity 1, acceleration 0; where the velocity jumps, the force on a mass is infinite. Between
/// `half_cycloidal_start` and `half_cycloidal_end` with the same velocity nothing jumps.
/// Multiply by the rise and give it the time over the duration:
/// `rise * linear((t - t0) / duration)`.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapters 2 and 3.
function linear(u: Number) -> Number =
    if u < 1 { max(u, 0) } else { 1 + (min(u, 1) - 1)^4 };
