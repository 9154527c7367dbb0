/// Double harmonic rise from 0 to 1, in reverse: from a turn without a dwell to a dwell.
///
/// ```text
///   s = (1 − cos πu)/2 + (1 − cos 2πu)/8       0 ≤ u ≤ 1
/// ```
///
/// 0 before u = 0, 1 after u = 1. The acceleration begins with π²; at the end the first and second derivatives are continuous.
/// It is 1 − `double_harmonic`(1 − u): subtracted after a `double_harmonic` of the same duration it gives the return to a dwell.
/// Peak values: velocity 3√3π/8 ≈ 2.041, acceleration π² ≈ 9.870 and −9π²/16 ≈ −5.552.
/// Multiply by the fall and give it the time over the duration:
/// `rise * (1 - double_harmonic_end((t - t0) / duration))`.
///
/// Reference: Rothbart, Cam Design Handbook, chapter 2.
function double_harmonic_end(u: Number) -> Number =
    (1 - cos(pi * min(max(u, 0), 1))) / 2 + (1 - cos(2 * pi * min(max(u, 0), 1))) / 8;
