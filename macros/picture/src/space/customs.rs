//! What is drawn the same way throughout a motion: how far guides are used, and where ground lies below joints on it.

use super::placed::{Of, Placed};
use super::vector::{UP, Vec3};
use std::collections::BTreeMap;

/// What happens in a motion.
#[derive(Clone, Debug, Default)]
pub(crate) struct Customs {
    /// By joint, the least and the largest displacement.
    ways: BTreeMap<usize, (f64, f64)>,
    /// By joint on ground, the sum of the directions in which its body leaves it.
    leaves: BTreeMap<usize, Vec3>,
}

impl Customs {
    /// Of scenes in units of the picture.
    pub(crate) fn of(scenes: &[Placed]) -> Customs {
        let mut customs = Customs::default();
        for scene in scenes {
            for (number, joint) in scene.joints.iter().enumerate() {
                if let Some((p, q, a)) = joint_of(scene, number) {
                    let way = (q.at - p.at).dot(a);
                    let known = customs.ways.entry(number).or_insert((way, way));
                    *known = (known.0.min(way), known.1.max(way));
                }
                let Some(mover) = joint.given.points().find_map(|of| of.body) else { continue };
                let at = joint.given.points().next().map_or(Vec3::default(), |of| of.at);
                let points = &scene.bodies[mover].points;
                let way = (Vec3::middle(points) - at).direction().unwrap_or_default();
                let known = customs.leaves.entry(number).or_default();
                *known = *known + way;
            }
        }
        customs
    }

    /// The least and the largest displacement of a joint.
    pub(crate) fn way(&self, joint: usize) -> (f64, f64) {
        self.ways.get(&joint).copied().unwrap_or_default()
    }

    /// Downwards, unless the body hangs there.
    pub(crate) fn down(&self, joint: usize) -> Vec3 {
        let leaves = self.leaves.get(&joint).copied().and_then(Vec3::direction).unwrap_or_default();
        if leaves.z < -0.6 { UP } else { -UP }
    }
}

fn joint_of(scene: &Placed, number: usize) -> Option<(Of, Of, Vec3)> {
    let (p, q, a) = scene.joints[number].hinge().or_else(|| {
        let given = &scene.joints[number].given;
        Some((given.point("P")?, given.point("Q")?, given.axis("a")?))
    })?;
    Some((p, q, a.at))
}
