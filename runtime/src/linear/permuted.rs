//! Access by an index from a permutation. The index is always in range, but rustc cannot prove it; these functions contain no
//! panic.

use crate::number::Real;

/// The entry at `index`.
#[inline(always)]
pub(super) fn entry<T: Real>(entries: &[T], index: usize) -> T {
    entries.get(index).copied().unwrap_or(T::of(0.0))
}

/// Puts an entry at `index`.
#[inline(always)]
pub(super) fn put<T>(entries: &mut [T], index: usize, value: T) {
    if let Some(entry) = entries.get_mut(index) {
        *entry = value;
    }
}

/// Exchanges two entries.
#[inline(always)]
pub(super) fn exchange<T>(entries: &mut [T], i: usize, j: usize) {
    // None are disjoint where i is j.
    if let Ok([one, other]) = entries.get_disjoint_mut([i, j]) {
        core::mem::swap(one, other);
    }
}
