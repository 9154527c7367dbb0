//! Signs of determinants.

/// The sign of a determinant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DetSign {
    /// Above zero.
    Positive,
    /// Below zero.
    Negative,
}
