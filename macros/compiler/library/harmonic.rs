/// Simple harmonic rise from 0 to 1.
///
/// ```text
///   s = (1 − cos πu) / 2                       0 ≤ u < 1
/// ```
///
/// 0 before u = 0, 1 from u = 1 on; its second derivative jumps at both ends. At u = 0 it is that of the rise and at u = 1 it is 0, so
/// that where one motion ends and the next begins only one of them counts.
/// Peak values: velocity π/2, acceleration π²/2.
/// Multiply by the rise and give it the time over the duration:
/// `rise * harmonic((t - t0) / duration)`.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapters 2 and 3.
function harmonic(u: Number) -> Number =
    if u < 1 { (1 - cos(pi * max(u, 0))) / 2 } else { 1 + (min(u, 1) - 1)^4 };
