//! Comparisons with a defined result for NaN.

use super::{Float, Scalar};

/// The greater of two numbers, or NaN if one is.
pub(crate) fn greater<T: Float>(a: T, b: T) -> T {
    #[expect(clippy::eq_op, reason = "only NaN differs from itself")]
    let keep = b <= a || a != a;
    if keep { a } else { b }
}

/// The smaller of two numbers; `a` where they cannot be compared.
pub(crate) fn smaller<T: Scalar>(a: T, b: T) -> T {
    if b < a { b } else { a }
}
