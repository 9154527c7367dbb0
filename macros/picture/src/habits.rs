//! Properties of a drawing that are shared by all frames of a motion, so that supports stand still and guides keep their lengths:
//! directions of links at places on ground, ranges of guides, and the side to which each guide is loaded.

use crate::plane::Place;
use std::collections::BTreeMap;

/// Places nearer to each other than this coincide in the picture.
const NEAR: f64 = 1.0;

/// Ranges and directions over a motion.
#[derive(Clone, Debug, Default)]
pub(crate) struct Habits {
    /// Places on ground with the directions (rad) in which links leave them.
    reached: Vec<(Place, Vec<f64>)>,
    /// Indexed by joint.
    guides: BTreeMap<usize, Guide>,
}

/// Range and loading of a guide or a slot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Guide {
    /// Least coordinate of the guided point along the guide.
    pub(crate) low: f64,
    /// Largest coordinate.
    pub(crate) high: f64,
    /// Sum of the lateral pulls of the links on the guided point.
    pull: f64,
    count: u32,
}

impl Guide {
    /// Mean lateral pull.
    pub(crate) fn pull(&self) -> f64 {
        self.pull / f64::from(self.count)
    }

    /// A guide used at one coordinate only, with a lateral pull.
    pub(crate) fn new(at: f64, pull: f64) -> Guide {
        Guide { low: at, high: at, pull, count: 1 }
    }

    fn and(self, other: Guide) -> Guide {
        let (pull, count) = (self.pull + other.pull, self.count.saturating_add(other.count));
        Guide { low: self.low.min(other.low), high: self.high.max(other.high), pull, count }
    }
}

impl Habits {
    /// Records directions (rad) in which links leave a place.
    pub(crate) fn reach(&mut self, at: Place, directions: Vec<f64>) {
        match self.reached.iter_mut().find(|(known, _)| (*known - at).norm() < NEAR) {
            Some((_, known)) => known.extend(directions),
            None => self.reached.push((at, directions)),
        }
    }

    /// Records the use of a guide.
    pub(crate) fn slide(&mut self, joint: usize, guide: Guide) {
        self.guides.entry(joint).and_modify(|known| *known = known.and(guide)).or_insert(guide);
    }

    /// Merges the habits of another scene.
    pub(crate) fn learn(&mut self, other: Habits) {
        other.reached.into_iter().for_each(|(at, directions)| self.reach(at, directions));
        other.guides.into_iter().for_each(|(joint, guide)| self.slide(joint, guide));
    }

    /// Directions in which links leave a place.
    pub(crate) fn at(&self, at: Place) -> impl Iterator<Item = f64> {
        self.reached.iter().filter(move |(known, _)| (*known - at).norm() < NEAR).flat_map(|(_, directions)| directions.iter().copied())
    }

    /// Range and loading of a guide, if recorded.
    pub(crate) fn guide(&self, joint: usize) -> Option<Guide> {
        self.guides.get(&joint).copied()
    }
}
