//! What is drawn the same way throughout a motion, so that ground stands still and guides keep their lengths: where links leave places
//! on ground, how far guides are used, and to which side they are pulled.

use crate::plane::Place;
use std::collections::BTreeMap;

/// Places nearer to each other than this are one in the picture.
const NEAR: f64 = 1.0;

/// What happens in a motion.
#[derive(Clone, Debug, Default)]
pub(crate) struct Habits {
    /// Places on ground with the directions (rad) in which links leave them.
    reached: Vec<(Place, Vec<f64>)>,
    /// By joint.
    guides: BTreeMap<usize, Guide>,
}

/// A guide or a slot in use.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Guide {
    /// The least coordinate along it of what it guides.
    pub(crate) low: f64,
    /// The largest one.
    pub(crate) high: f64,
    /// The sum of what pulls at it.
    pull: f64,
    count: u32,
}

impl Guide {
    /// What pulls at it on the mean.
    pub(crate) fn pull(&self) -> f64 {
        self.pull / f64::from(self.count)
    }

    /// What it guides is at a coordinate along it, and is pulled to a side.
    pub(crate) fn new(at: f64, pull: f64) -> Guide {
        Guide { low: at, high: at, pull, count: 1 }
    }

    fn and(self, other: Guide) -> Guide {
        let (pull, count) = (self.pull + other.pull, self.count.saturating_add(other.count));
        Guide { low: self.low.min(other.low), high: self.high.max(other.high), pull, count }
    }
}

impl Habits {
    /// Links leave a place in these directions.
    pub(crate) fn reach(&mut self, at: Place, directions: Vec<f64>) {
        match self.reached.iter_mut().find(|(known, _)| (*known - at).norm() < NEAR) {
            Some((_, known)) => known.extend(directions),
            None => self.reached.push((at, directions)),
        }
    }

    /// A guide is used.
    pub(crate) fn slide(&mut self, joint: usize, guide: Guide) {
        self.guides.entry(joint).and_modify(|known| *known = known.and(guide)).or_insert(guide);
    }

    /// Takes in those of another scene.
    pub(crate) fn learn(&mut self, other: Habits) {
        other.reached.into_iter().for_each(|(at, directions)| self.reach(at, directions));
        other.guides.into_iter().for_each(|(joint, guide)| self.slide(joint, guide));
    }

    /// The directions in which links leave a place.
    pub(crate) fn at(&self, at: Place) -> impl Iterator<Item = f64> {
        self.reached.iter().filter(move |(known, _)| (*known - at).norm() < NEAR).flat_map(|(_, directions)| directions.iter().copied())
    }

    /// How a guide is used, if that is known.
    pub(crate) fn guide(&self, joint: usize) -> Option<Guide> {
        self.guides.get(&joint).copied()
    }
}
