/// Rise from 0 to 1 by the 3-4-5 polynomial.
///
/// ```text
///   s = 10u³ − 15u⁴ + 6u⁵                      0 ≤ u ≤ 1
/// ```
///
/// 0 before u = 0, 1 after u = 1; its first and second derivatives are continuous.
/// Peak values: velocity 15/8, acceleration 10/√3.
/// Multiply by the rise and give it the time over the duration:
/// `rise * polynomial_345((t - t0) / duration)`.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapters 2 and 3.
function polynomial_345(u: Number) -> Number =
    if u < 1/2 { max(u, 0)^3 * (10 + max(u, 0) * (6 * max(u, 0) - 15)) } else { 1 - max(1 - u, 0)^3 * (10 + max(1 - u, 0) * (6 * max(1 - u, 0) - 15)) };
