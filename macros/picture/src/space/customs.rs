//! Properties of a drawing that are shared by all frames of a motion: ranges of guides, and directions of ground at joints on it.

use super::placed::{Of, Placed};
use super::vector::{UP, Vec3};
use std::collections::BTreeMap;

/// Points whose middle is closer to a joint than this leave it in no direction (picture units).
const BALANCED: f64 = 1e-3;

/// Ranges and directions over a motion.
#[derive(Clone, Debug, Default)]
pub(crate) struct Customs {
    /// Least and largest displacement of each joint.
    ways: BTreeMap<usize, (f64, f64)>,
    /// For each joint on ground, the sum of the directions in which its body leaves the joint.
    leaves: BTreeMap<usize, Vec3>,
}

impl Customs {
    /// Collects them from scenes in picture units.
    pub(crate) fn of(scenes: &[Placed]) -> Customs {
        let mut customs = Customs::default();
        for scene in scenes {
            let all: Vec<Vec3> = scene.bodies.iter().flat_map(|body| body.points.iter().copied()).collect();
            let middle = Vec3::middle(&all);
            for (number, joint) in scene.joints.iter().enumerate() {
                if let Some((p, q, a)) = joint_of(scene, number) {
                    let way = (q.at - p.at).dot(a);
                    let known = customs.ways.entry(number).or_insert((way, way));
                    *known = (known.0.min(way), known.1.max(way));
                }
                let Some(mover) = joint.given.points().find_map(|of| of.body) else { continue };
                let at = joint.given.points().next().map_or(Vec3::default(), |of| of.at);
                let points = &scene.bodies[mover].points;
                // Where a body is balanced about its joint, rounding would decide: then all that hangs on it does.
                let ways = [Vec3::middle(points) - at, middle - at];
                let way = ways.into_iter().find(|way| way.norm() > BALANCED).and_then(Vec3::direction).unwrap_or_default();
                let known = customs.leaves.entry(number).or_default();
                *known = *known + way;
            }
        }
        customs
    }

    /// Least and largest displacement of a joint.
    pub(crate) fn way(&self, joint: usize) -> (f64, f64) {
        self.ways.get(&joint).copied().unwrap_or_default()
    }

    /// Direction of ground: downwards, unless the body hangs below the joint.
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
