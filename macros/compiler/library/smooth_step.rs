/// Rise from 0 to 1 by the cubic polynomial.
///
/// ```text
///   s = 3u² − 2u³                              0 ≤ u < 1
/// ```
///
/// 0 before u = 0, 1 from u = 1 on; its second derivative jumps at both ends. At u = 0 it is that of the rise and at u = 1 it is 0, so
/// that where one motion ends and the next begins only one of them counts.
/// Peak values: velocity 3/2, acceleration 6.
/// Multiply by the rise and give it the time over the duration:
/// `rise * smooth_step((t - t0) / duration)`.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapters 2 and 3.
function smooth_step(u: Number) -> Number =
    if u < 1/2 { max(u, 0)^2 * (3 - 2 * max(u, 0)) } else if u < 1 { 1 - (1 - u)^2 * (3 - 2 * (1 - u)) } else { 1 + (min(u, 1) - 1)^4 };
