/// Double harmonic rise from 0 to 1: from a dwell to a turn without one.
///
/// ```text
///   s = (1 − cos πu)/2 − (1 − cos 2πu)/8       0 ≤ u < 1
/// ```
///
/// 0 before u = 0, 1 from u = 1 on. Its first and second derivatives are continuous at the beginning; at the end the acceleration is −π²,
/// and `double_harmonic_end` downwards goes on from there. At u = 1 the second derivative is 0, so that where one motion ends and the next
/// begins only one of them counts.
/// Peak values: velocity 3√3π/8 ≈ 2.041, acceleration 9π²/16 ≈ 5.552 and −π² ≈ −9.870.
/// Multiply by the rise and give it the time over the duration:
/// `rise * (double_harmonic((t - t0) / duration) - double_harmonic_end((t - t0 - duration) / duration))`.
///
/// Reference: Rothbart, Cam Design Handbook, chapter 2.
function double_harmonic(u: Number) -> Number =
    if u < 1 { (1 - cos(pi * max(u, 0))) / 2 - (1 - cos(2 * pi * max(u, 0))) / 8 } else { 1 + (min(u, 1) - 1)^4 };
