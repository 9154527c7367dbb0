//! The components of a vector, as many as space has dimensions.

use crate::expr::Expr;
use std::ops::Deref;

/// Space has no more dimensions.
const MOST: usize = 3;

/// Up to three expressions along the axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Components {
    /// Those beyond `length` repeat the first one.
    parts: [Expr; MOST],
    length: usize,
}

impl Components {
    /// From one expression for each axis; `None` if there are none or too many of them.
    pub(crate) fn new(parts: &[Expr]) -> Option<Components> {
        let mut all = [*parts.first()?; MOST];
        all.get_mut(..parts.len())?.copy_from_slice(parts);
        Some(Components { parts: all, length: parts.len() })
    }

    /// In the plane.
    pub(crate) fn plane(x: Expr, y: Expr) -> Components {
        Components { parts: [x, y, x], length: 2 }
    }

    /// Each component changed.
    pub(crate) fn map(mut self, mut change: impl FnMut(Expr) -> Expr) -> Components {
        let length = self.length;
        self.parts[..length].iter_mut().for_each(|part| *part = change(*part));
        Components { parts: std::array::from_fn(|at| self.parts[if at < length { at } else { 0 }]), length }
    }

    /// Both components along each axis made into one.
    pub(crate) fn zip(self, other: Components, mut combine: impl FnMut(Expr, Expr) -> Expr) -> Components {
        debug_assert_eq!(self.length, other.length, "vectors of one mechanism have equally many components");
        let mut others = other.iter().copied();
        self.map(|part| others.next().map_or(part, |other| combine(part, other)))
    }

    /// x and y of a vector in the plane.
    pub(crate) fn in_plane(self) -> Option<[Expr; 2]> {
        let [x, y] = *self else { return None };
        Some([x, y])
    }
}

impl Deref for Components {
    type Target = [Expr];

    fn deref(&self) -> &[Expr] {
        &self.parts[..self.length]
    }
}
