//! Which pivots are trusted.

/// The smallest pivots that are trusted: 1/first of the sum of the row's sizes; for a determinant of n rows 1/(first · furtherⁿ⁻¹) of the
/// product of their sums.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trust {
    pub(super) first: i64,
    pub(super) further: i64,
}

impl Trust {
    /// Of the accelerations.
    pub(super) const OF_MOTION: Trust = Trust { first: 16, further: 1 };

    /// Of rows of many entries: vectors in space, along axes that turn.
    pub(super) const OF_SPINS: Trust = Trust { first: 16, further: 8 };

    /// One part in so many is trusted.
    pub(super) fn of(self, rows: usize) -> i64 {
        (1..rows).fold(self.first, |parts, _| parts * self.further)
    }
}
