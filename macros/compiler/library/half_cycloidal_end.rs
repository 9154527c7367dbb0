/// Second half of a cycloidal rise, from 0 to 1: from a constant velocity to rest.
///
/// ```text
///   s = u + sin(πu) / π                        0 ≤ u ≤ 1
/// ```
///
/// 0 before u = 0, 1 after u = 1. At the beginning the velocity is 2 and the acceleration 0; both end at 0.
/// Peak values: velocity 2, acceleration π.
/// It follows a motion with the velocity 2 h/β without a jump, such as `linear` over twice the rise in the same time:
/// `2 * rise * linear((t - t0) / duration) + rise * half_cycloidal_end((t - t0 - duration) / duration)`.
///
/// Reference: Rothbart, Cam Design Handbook, chapter 2 (curve C-2).
function half_cycloidal_end(u: Number) -> Number =
    min(max(u, 0), 1) + sin(pi * min(max(u, 0), 1)) / pi;
