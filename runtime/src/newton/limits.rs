//! Limits that several ways through Newton's method share.

/// Longest scaled step towards a first assembly: half a radian, or half of L. Within it a revolute is still about linear.
pub(crate) const LONGEST_STEP: f64 = 0.5;

/// Up to this share of 1 / √ε a condition says that two solutions are told apart: where they meet, at a fold, they are about
/// 1 / condition apart and each is known to about ε times the condition.
pub(crate) const WELL_CONDITIONED: f64 = 0.125;

/// Longest way of a prediction, scaled; an eighth of a turn, so that it cannot be mistaken for another turn.
pub(crate) const LONGEST_PREDICTION: f64 = 0.8;

/// Longest first correction of a predicted position, scaled: further away another assembly may be as near.
pub(crate) const LONGEST_FIRST_CORRECTION: f64 = 0.2;

/// Largest contraction of the first correction of a predicted position; 1/2 is the limit of quadratic convergence.
pub(crate) const LARGEST_CONTRACTION: f64 = 0.25;

/// Factorisations where the first correction was the last.
pub(crate) const ONE_CORRECTION: usize = 2;
