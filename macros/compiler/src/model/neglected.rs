//! A point that may be meant in the place of another, where joints contradict each other.

use super::Model;
use super::sketch::{Instantiation, JointArgument, LocalVector, Sketch};
use crate::diag::Neglected;
use crate::expr::{Expr, Leaf};
use std::collections::{BTreeMap, BTreeSet};

/// Joints that keep two points together. Two of them rarely share a point.
const PINS: [&str; 4] = ["revolute", "spherical", "universal", "constant_velocity"];

/// A point by its body and its components.
type Place = (Option<usize>, Vec<Expr>);

impl Model {
    /// A point of a body or of ground that nothing uses, while at least two of `joints` take another point of it.
    ///
    /// `None` where equations that are written out, or forces, may use points.
    pub(crate) fn neglected(&self, joints: impl Iterator<Item = usize>) -> Option<Box<Neglected>> {
        let sketch = &self.sketch;
        let is_written_out = |(joint, made): (&super::Joint, &Instantiation)| joint.freedom.is_none() && made.arguments.is_empty();
        if !self.forces.is_empty() || self.joints.iter().zip(&sketch.joints).any(is_written_out) {
            return None;
        }
        let mut pins_at: BTreeMap<Place, Vec<usize>> = BTreeMap::new();
        for joint in joints {
            let made = sketch.joints.get(joint).filter(|made| PINS.contains(&made.kind.as_str()));
            for place in made.into_iter().flat_map(places) {
                pins_at.entry(place).or_default().push(joint);
            }
        }
        let of_joints = sketch.joints.iter().flat_map(places);
        let used: BTreeSet<Place> = of_joints.chain(sketch.outputs.iter().map(|output| place(&output.at))).collect();
        sketch.points.iter().filter(|point| !used.contains(&place(&point.at))).find_map(|point| {
            let body = point.at.body;
            let mut shared = pins_at.iter().filter(|((other, _), pins)| *other == body && pins.len() > 1);
            let (taken, pins) = shared.find_map(|(taken, pins)| Some((self.name_at(taken)?, pins)))?;
            let written = |name: &str| format!("{}.{name}", self.drawn_name(body));
            let joints = pins.iter().map(|joint| self.joints[*joint].name.to_string()).collect();
            Some(Box::new(Neglected { point: written(&point.name), taken: written(taken), joints }))
        })
    }

    /// One of `joints` that keeps constant what a drive would move: `distance` for `drive_distance`, between the same points.
    pub(crate) fn held_by(&self, drive: usize, mut joints: impl Iterator<Item = usize>) -> Option<String> {
        let driven = self.joints[drive].kind.strip_prefix("drive_")?;
        let made = |joint: usize| self.sketch.joints.get(joint);
        let places_of = |joint: usize| made(joint).map(places).unwrap_or_default();
        let leaves = |joint: usize| -> BTreeSet<_> {
            let all = self.joints[joint].residuals.iter().flat_map(|residual| self.arena.leaves(residual.expr));
            all.filter(|leaf| matches!(leaf, Leaf::Coordinate(_))).collect()
        };
        let found = joints.find(|joint| {
            self.joints[*joint].kind.trim_start_matches("absolute_") == driven
                && places_of(*joint) == places_of(drive)
                && leaves(*joint) == leaves(drive)
        })?;
        Some(self.joints[found].name.to_string())
    }

    /// The name of a declared point, or `position` for the origin of a body or of ground.
    fn name_at(&self, taken: &Place) -> Option<&str> {
        let Sketch { arena, points, .. } = &self.sketch;
        let is_zero = |part: &Expr| arena.as_constant(*part).is_some_and(|value| value.is_zero());
        let declared = points.iter().find(|point| place(&point.at) == *taken);
        declared.map(|point| point.name.as_str()).or_else(|| taken.1.iter().all(is_zero).then_some("position"))
    }
}

fn place(at: &LocalVector) -> Place {
    (at.body, at.local.iter().copied().collect())
}

/// The points of a joint.
fn places(made: &Instantiation) -> BTreeSet<Place> {
    made.arguments.iter().filter_map(|(_, argument)| if let JointArgument::Point(at) = argument { Some(place(at)) } else { None }).collect()
}
