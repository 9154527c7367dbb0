//! Times of a sweep, by value or by reference.

use super::Scalar;

/// A time (s), or a reference to one.
pub trait Time<T>: Sealed<T> {
    /// The time itself.
    fn time(self) -> T;
}

/// Keeps [`Time`] to numbers and references to numbers.
pub trait Sealed<T> {}

impl<T: Scalar> Sealed<T> for T {}
impl<T: Scalar> Sealed<T> for &T {}

impl<T: Scalar> Time<T> for T {
    #[inline]
    fn time(self) -> T {
        self
    }
}

impl<T: Scalar> Time<T> for &T {
    #[inline]
    fn time(self) -> T {
        *self
    }
}

/// The times (s) of a sweep: an array, a `Vec` or an iterator of numbers, or a reference to a slice, an array or a `Vec`.
///
/// ```
/// use reuleaux::Times;
///
/// fn last(times: impl Times<f64>) -> Option<f64> {
///     times.into_iter().map(reuleaux::Time::time).last()
/// }
///
/// let times = vec![0.0, 0.5, 1.0];
/// assert_eq!(last(&times), Some(1.0));
/// assert_eq!(last(&times[..2]), Some(0.5));
/// assert_eq!(last((0..=100).map(|k| f64::from(k) / 100.0)), Some(1.0));
/// assert_eq!(last(times), Some(1.0));
/// ```
///
/// `0.0..1.0` has no times, because it has no step.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not give times of type `{T}`",
    label = "not a sequence of times",
    note = "times are an array, a slice, a `Vec` or an iterator of `{T}` or `&{T}`",
    note = "a range of numbers has no step: write `(0..=100).map(|k| f64::from(k) / 100.0)`"
)]
pub trait Times<T>: IntoIterator<Item: Time<T>> {}

#[diagnostic::do_not_recommend]
impl<T, I: IntoIterator<Item: Time<T>>> Times<T> for I {}
