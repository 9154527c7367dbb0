//! Moments of inertia.

/// Rounding errors of an inertia at a bound.
const ROUNDING: f64 = 1e-12;

/// True if the inertia belongs to a possible mass distribution: the second moments ∫ x xᵀ dm = ½ tr(I) − I are positive semidefinite.
pub(crate) fn is_inertia([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> bool {
    let half = 0.5 * (xx + yy + zz);
    let size = half.abs() * (1.0 + ROUNDING);
    let [a, b, c] = [half - xx, half - yy, half - zz].map(|moment| moment + ROUNDING * size);
    let [d, e, f] = [-xy, -xz, -yz];
    let minors = [a * b - d * d, a * c - e * e, b * c - f * f];
    let determinant = a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e);
    let is_unknown = [xx, yy, zz, xy, xz, yz].iter().any(|value| value.is_nan());
    is_unknown
        || [a, b, c].iter().all(|moment| *moment >= 0.0)
            && minors.iter().all(|minor| *minor >= -ROUNDING * size * size)
            && determinant >= -ROUNDING * size * size * size
}
