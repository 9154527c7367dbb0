/// First half of a cycloidal rise, from 0 to 1: from rest to a constant velocity.
///
/// ```text
///   s = u − sin(πu) / π                        0 ≤ u < 1
/// ```
///
/// 0 before u = 0, 1 from u = 1 on. Velocity and acceleration begin at 0; at the end the velocity is 2 and the acceleration 0.
/// Peak values: velocity 2, acceleration π.
/// A motion with the velocity 2 h/β follows it without a jump, such as `linear` over twice the rise in the same time:
/// `rise * half_cycloidal_start((t - t0) / duration) + 2 * rise * linear((t - t0 - duration) / duration)`.
///
/// Reference: Rothbart, Cam Design Handbook, chapter 2 (curve C-1).
function half_cycloidal_start(u: Number) -> Number =
    if u < 1 { max(u, 0) - sin(pi * max(u, 0)) / pi } else { 1 + (min(u, 1) - 1)^4 };
