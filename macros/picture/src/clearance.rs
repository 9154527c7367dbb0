//! Clearance of a drawing: the least distance between parts that a reader has to tell apart.

use crate::placed::{PlacedScene, Sign};
use crate::plane::{Place, Rectangle, farthest};

/// Least distance of a hinge from another hinge and from a link of another body, relative to the size of the mechanism.
pub(crate) fn clearance(scene: &PlacedScene) -> f64 {
    let size = Rectangle::around(scene.places()).size().norm();
    let near = 1e-6 * size;
    let mut hinges: Vec<Place> = Vec::new();
    for at in scene.joints.iter().flat_map(Sign::points).map(|(_, at)| at) {
        if hinges.iter().all(|known| (*known - at).norm() > near) {
            hinges.push(at);
        }
    }
    let bars: Vec<Option<(Place, Place)>> = scene.bodies.iter().map(|body| farthest(&body.points)).collect();
    let mut least = f64::INFINITY;
    for (index, hinge) in hinges.iter().enumerate() {
        least = hinges[..index].iter().map(|other| (*other - *hinge).norm()).fold(least, f64::min);
        for (body, bar) in scene.bodies.iter().zip(&bars) {
            let is_own = body.points.iter().any(|at| (*at - *hinge).norm() <= near);
            if let (Some((one, two)), false) = (bar, is_own) {
                least = least.min(hinge.to_segment(*one, *two));
            }
        }
    }
    least.min(straightness(scene, near)) / size
}

/// Least distance of the end of a link from the line of another link at the same hinge; collinear links would look like one.
fn straightness(scene: &PlacedScene, near: f64) -> f64 {
    let bars = scene.bodies.iter().filter_map(|body| farthest(&body.points));
    let bars: Vec<(Place, Place)> = bars.filter(|(one, two)| (*two - *one).norm() > near).collect();
    let mut least = f64::INFINITY;
    for (index, one) in bars.iter().enumerate() {
        for two in &bars[..index] {
            for (a, b) in [*one, (one.1, one.0)] {
                for (c, d) in [*two, (two.1, two.0)] {
                    if (a - c).norm() <= near {
                        let (v, w) = (b - a, d - c);
                        least = least.min(v.cross(w).abs() / v.norm().max(w.norm()));
                    }
                }
            }
        }
    }
    least
}
