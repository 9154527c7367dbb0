//! Components of a vector, as many as space has dimensions.

use crate::expr::Expr;
use std::ops::Deref;

/// Largest number of components.
const MOST: usize = 3;

/// Up to three expressions, one for each axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Components {
    /// Entries beyond `length` repeat the first one.
    parts: [Expr; MOST],
    length: usize,
}

impl Components {
    /// Components along the axes; `None` for none or more than three.
    pub(crate) fn new(parts: &[Expr]) -> Option<Components> {
        let mut all = [*parts.first()?; MOST];
        all.get_mut(..parts.len())?.copy_from_slice(parts);
        Some(Components { parts: all, length: parts.len() })
    }

    /// Components of a vector in the plane.
    pub(crate) fn plane(x: Expr, y: Expr) -> Components {
        Components { parts: [x, y, x], length: 2 }
    }

    /// As many components; new ones repeat the first.
    pub(crate) fn resized(mut self, length: usize) -> Components {
        let first = self.parts[0];
        (self.length..MOST).for_each(|at| self.parts[at] = first);
        Components { length: length.min(MOST), ..self }
    }

    /// Components of a vector in space.
    pub(crate) fn space(parts: [Expr; 3]) -> Components {
        Components { parts, length: 3 }
    }

    /// x, y and z; `None` unless there are exactly three components.
    pub(crate) fn in_space(self) -> Option<[Expr; 3]> {
        let [x, y, z] = *self else { return None };
        Some([x, y, z])
    }

    /// Applies `change` to each component.
    pub(crate) fn map(mut self, mut change: impl FnMut(Expr) -> Expr) -> Components {
        let length = self.length;
        self.parts[..length].iter_mut().for_each(|part| *part = change(*part));
        Components { parts: std::array::from_fn(|at| self.parts[if at < length { at } else { 0 }]), length }
    }

    /// Combines two vectors axis by axis.
    pub(crate) fn zip(self, other: Components, mut combine: impl FnMut(Expr, Expr) -> Expr) -> Components {
        debug_assert_eq!(self.length, other.length, "vectors of one mechanism have equally many components");
        let mut others = other.iter().copied();
        self.map(|part| others.next().map_or(part, |other| combine(part, other)))
    }

    /// x and y; `None` unless there are exactly two components.
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
