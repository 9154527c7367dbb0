/// Simple harmonic rise from 0 to 1.
///
/// ```text
///   s = (1 − cos πu) / 2                       0 ≤ u ≤ 1
/// ```
///
/// 0 before u = 0, 1 after u = 1; its second derivative jumps at both ends.
/// Peak values: velocity π/2, acceleration π²/2.
/// Multiply by the rise and give it the time over the duration:
/// `rise * harmonic((t - t0) / duration)`.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapters 2 and 3.
function harmonic(u: Number) -> Number =
    (1 - cos(pi * min(max(u, 0), 1))) / 2;
