/// Rise from 0 to 1 by the 4-5-6-7 polynomial.
///
/// ```text
///   s = 35u⁴ − 84u⁵ + 70u⁶ − 20u⁷              0 ≤ u ≤ 1
/// ```
///
/// 0 before u = 0, 1 after u = 1; its first three derivatives are continuous.
/// Peak values: velocity 35/16, acceleration 84√5/25.
/// Multiply by the rise and give it the time over the duration:
/// `rise * polynomial_4567((t - t0) / duration)`.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapters 2 and 3.
function polynomial_4567(u: Number) -> Number =
    if u < 1/2 { max(u, 0)^4 * (35 + max(u, 0) * (max(u, 0) * (70 - 20 * max(u, 0)) - 84)) } else { 1 - max(1 - u, 0)^4 * (35 + max(1 - u, 0) * (max(1 - u, 0) * (70 - 20 * max(1 - u, 0)) - 84)) };
