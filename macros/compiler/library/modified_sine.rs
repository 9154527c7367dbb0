/// Rise from 0 to 1 with modified sinusoidal acceleration.
///
/// ```text
///   A = 4π²/(4+π)      acceleration
///   0   … 1/8          A sin 4πu
///   1/8 … 7/8          A cos (4π/3)(u − 1/8)
///   7/8 … 1            A sin 4πu
/// ```
///
/// 0 before u = 0, 1 after u = 1; its first and second derivatives are continuous.
/// Peak values: velocity 4π/(4+π) ≈ 1.760, the smallest of the named laws without a jump of acceleration, and acceleration 4π²/(4+π) ≈ 5.528.
/// Its acceleration changes sign slowly, so that it takes the smallest peak of torque: it suits large turrets and tables.
/// Multiply by the rise and give it the time over the duration:
/// `rise * modified_sine((t - t0) / duration)`.
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapters 2 and 3.
function modified_sine(u: Number) -> Number =
    if u < 1/8 { (pi * max(u, 0) - sin(4 * pi * max(u, 0)) / 4) / (4 + pi) }
    else if u < 7/8 { 1/2 + (pi * (u - 1/2) + 9/4 * sin(4 * pi / 3 * (u - 1/2))) / (4 + pi) }
    else { 1 - (pi * max(1 - u, 0) - sin(4 * pi * max(1 - u, 0)) / 4) / (4 + pi) };
