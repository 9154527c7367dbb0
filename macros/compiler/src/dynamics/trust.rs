//! Which pivots are trusted.

/// How small pivots may be: one is trusted above one part in `first` of the sum of its row, a determinant of more rows above such a part of
/// the product of their sums, divided by `further` for each row more.
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
