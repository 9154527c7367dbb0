/// Rise from 0 to 1 with modified trapezoidal acceleration.
///
/// ```text
///   A = 8π/(2+π)       acceleration
///   0   … 1/8          A sin 4πu
///   1/8 … 3/8          A
///   3/8 … 5/8          A cos 4π(u − 3/8)
///   5/8 … 7/8         −A
///   7/8 … 1           −A cos 4π(u − 7/8)
/// ```
///
/// 0 before u = 0, 1 after u = 1; its first and second derivatives are continuous.
/// Peak values: velocity 2, acceleration 8π/(2+π) ≈ 4.888, the smallest of the named laws without a jump;
/// `scca` with shorter edges has a smaller one.
/// Multiply by the rise and give it the time over the duration:
/// `rise * modified_trapezoidal((t - t0) / duration)`.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapters 2 and 3.
function modified_trapezoidal(u: Number) -> Number =
    if u < 1/8 { 2 / (2 + pi) * (max(u, 0) - sin(4 * pi * max(u, 0)) / (4 * pi)) }
    else if u < 3/8 { 2 / (2 + pi) * (u - 1 / (4 * pi) + 2 * pi * (u - 1/8)^2) }
    else if u < 5/8 { 2 / (2 + pi) * (u + pi / 8 + pi * (u - 3/8) - cos(4 * pi * (u - 3/8)) / (4 * pi)) }
    else if u < 7/8 { 1 - 2 / (2 + pi) * (1 - u - 1 / (4 * pi) + 2 * pi * (7/8 - u)^2) }
    else { 1 - 2 / (2 + pi) * (max(1 - u, 0) - sin(4 * pi * max(1 - u, 0)) / (4 * pi)) };
