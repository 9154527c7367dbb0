//! States as arguments: with or without the names of a declaration.

use core::ops::Deref;

use super::State;

/// A [`State`], or what refers to one, as the states that generated functions return do.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no state of this mechanism",
    note = "write `&state` for a state that `solve` returned"
)]
pub trait HasState<T, const N: usize> {
    /// The state without names.
    #[doc(hidden)]
    fn as_state(&self) -> &State<T, N>;
}

impl<T, const N: usize> HasState<T, N> for State<T, N> {
    #[inline]
    fn as_state(&self) -> &State<T, N> {
        self
    }
}

impl<T, const N: usize, S: Deref<Target = State<T, N>>> HasState<T, N> for S {
    #[inline]
    fn as_state(&self) -> &State<T, N> {
        self
    }
}
