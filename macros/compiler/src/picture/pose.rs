//! Which configuration is drawn: the start, unless links lie on each other there and do not a little later.

use super::plane::{Place, Rectangle, farthest};
use super::scene::{Instant, Scene, Sign};
use crate::assembly::{Assembly, Poses};
use crate::model::Model;
use crate::system::System;

/// Hinges and links should be this far from each other, as a part of the picture.
const CLEAR: f64 = 0.035;

/// Mechanisms with more bodies are drawn at their start.
const LARGEST: usize = 12;

/// The configuration that is drawn; none if nothing can be evaluated.
pub(super) fn pose(model: &Model, system: &System, assembly: &Assembly) -> Option<(Instant, Scene)> {
    let start = Instant { time: 0.0, q: assembly.start.clone() };
    let first = Scene::at(model, system, &start)?;
    let has_drive = first.joints.iter().any(|joint| joint.is_drive);
    let clear = clearance(&first);
    if clear >= CLEAR || !has_drive || model.bodies.len() > LARGEST || !model.task.is_solved() {
        return Some((start, first));
    }
    let mut best = (start, first, (2.0 * clear).max(0.2 * CLEAR));
    for (time, q) in Poses::new(model, system, assembly).closed() {
        let instant = Instant { time, q: q.to_vec() };
        let Some(scene) = Scene::at(model, system, &instant) else { continue };
        // What comes later is preferred a little to what was before.
        let clear = clearance(&scene).min(CLEAR * 1.5) * if time < 0.0 { 0.8 } else { 1.0 };
        if clear > best.2 {
            best = (instant, scene, clear);
        }
    }
    Some((best.0, best.1))
}

/// The least distance of a hinge from another one, and from a link that it is not part of, as a part of the whole.
fn clearance(scene: &Scene) -> f64 {
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

/// The least distance of the end of a link from the line of another one at the same hinge: links in line look like one.
fn straightness(scene: &Scene, near: f64) -> f64 {
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
