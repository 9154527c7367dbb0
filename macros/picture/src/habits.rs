//! What is drawn the same way throughout a motion, so that ground stands still: where links leave places on it, and to which side
//! guides are pulled.

use crate::plane::Place;
use std::collections::BTreeMap;

/// Places nearer to each other than this are one in the picture.
const NEAR: f64 = 1.0;

/// What happens at ground.
#[derive(Clone, Debug, Default)]
pub(crate) struct Habits {
    /// Places on ground with the directions (rad) in which links leave them.
    reached: Vec<(Place, Vec<f64>)>,
    /// By joint that is a guide on ground: the sum of what pulls at it, and how many there were.
    pulls: BTreeMap<usize, (f64, u32)>,
}

impl Habits {
    /// Links leave a place in these directions.
    pub(crate) fn reach(&mut self, at: Place, directions: Vec<f64>) {
        match self.reached.iter_mut().find(|(known, _)| (*known - at).norm() < NEAR) {
            Some((_, known)) => known.extend(directions),
            None => self.reached.push((at, directions)),
        }
    }

    /// A guide is pulled to a side.
    pub(crate) fn pull(&mut self, joint: usize, pull: f64) {
        let (sum, count) = self.pulls.entry(joint).or_default();
        (*sum, *count) = (*sum + pull, *count + 1);
    }

    /// Takes in those of another scene.
    pub(crate) fn learn(&mut self, other: Habits) {
        other.reached.into_iter().for_each(|(at, directions)| self.reach(at, directions));
        for (joint, (sum, count)) in other.pulls {
            let known = self.pulls.entry(joint).or_default();
            *known = (known.0 + sum, known.1 + count);
        }
    }

    /// The directions in which links leave a place.
    pub(crate) fn at(&self, at: Place) -> impl Iterator<Item = f64> {
        self.reached.iter().filter(move |(known, _)| (*known - at).norm() < NEAR).flat_map(|(_, directions)| directions.iter().copied())
    }

    /// What pulls at a guide on the mean, if it is known.
    pub(crate) fn pulled(&self, joint: usize) -> Option<f64> {
        self.pulls.get(&joint).map(|(sum, count)| sum / f64::from(*count))
    }
}
