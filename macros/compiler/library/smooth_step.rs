/// Rise from 0 to 1 by the cubic polynomial.
///
/// ```text
///   s = 3u² − 2u³                              0 ≤ u ≤ 1
/// ```
///
/// 0 before u = 0, 1 after u = 1; its second derivative jumps at both ends.
/// Peak values: velocity 3/2, acceleration 6.
/// Multiply by the rise and give it the time over the duration:
/// `rise * smooth_step((t - t0) / duration)`.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapters 2 and 3.
function smooth_step(u: Number) -> Number =
    if u < 1/2 { max(u, 0)^2 * (3 - 2 * max(u, 0)) } else { 1 - max(1 - u, 0)^2 * (3 - 2 * max(1 - u, 0)) };
