//! Limits that several variants of Newton's method share.

/// Longest scaled step from a rough guess: half a radian, or half of L. A revolute is still nearly linear within it.
pub(crate) const LONGEST_STEP: f64 = 0.5;

/// Two solutions are distinguishable up to this condition, as a fraction of 1 / √ε: near a fold they are about 1 / condition apart,
/// and each is known to about ε times the condition.
pub(crate) const WELL_CONDITIONED: f64 = 0.125;

/// From this condition κ on, accelerations near a change point have lost most of their digits: they are known to κ³ ε. In single precision other limits
/// are lower.
pub(crate) const BLURRED: f64 = 2e4;

/// Longest predicted change, scaled; an eighth of a turn, so that solutions a whole turn apart cannot be confused.
pub(crate) const LONGEST_PREDICTION: f64 = 0.8;

/// Longest first correction of a prediction, scaled; beyond it another assembly may be as close.
pub(crate) const LONGEST_FIRST_CORRECTION: f64 = 0.2;

/// Largest contraction after the first correction of a prediction; 1/2 is the limit of quadratic convergence.
pub(crate) const LARGEST_CONTRACTION: f64 = 0.25;

/// Number of factorisations in a warm step with a single correction.
pub(crate) const ONE_CORRECTION: usize = 2;
