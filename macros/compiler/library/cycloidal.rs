/// Cycloidal rise from 0 to 1.
///
/// ```text
///   s = u − sin(2πu) / 2π                      0 ≤ u ≤ 1
/// ```
///
/// 0 before u = 0, 1 after u = 1; its first and second derivatives are continuous.
/// Peak values: velocity 2, acceleration 2π.
/// Multiply by the rise and give it the time over the duration:
/// `rise * cycloidal((t - t0) / duration)`.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapters 2 and 3.
function cycloidal(u: Number) -> Number =
    min(max(u, 0), 1) - sin(2 * pi * min(max(u, 0), 1)) / (2 * pi);
