//! Which configuration is drawn: the start, unless links of a plane mechanism lie on each other there and do not a little later.

use super::scene::scene;
use crate::assembly::{Assembly, Poses};
use crate::model::Model;
use crate::quantity::Ambient;
use crate::system::System;
use reuleaux_picture::{Scene, Undrawable};

/// Hinges and links should be this far from each other, as a part of the picture.
const CLEAR: f64 = 0.035;

/// Mechanisms with more bodies are drawn at their start.
const LARGEST: usize = 12;

/// A time and a configuration.
#[derive(Clone, Debug)]
pub(super) struct Instant {
    /// In s.
    pub(super) time: f64,
    /// One value for each unknown, in SI.
    pub(super) q: Vec<f64>,
}

/// The configuration that is drawn, with its time.
pub(super) fn pose(model: &Model, system: &System, assembly: &Assembly) -> Result<(f64, Scene), Undrawable> {
    let first = scene(model, system, &Instant { time: 0.0, q: assembly.start.clone() });
    // In space it is looked at from where nothing lies on anything else.
    if model.ambient == Ambient::Space {
        return Ok((0.0, first));
    }
    let clear = first.clearance()?;
    let has_drive = model.joints.iter().any(|joint| joint.is_drive);
    if clear >= CLEAR || !has_drive || model.bodies.len() > LARGEST || !model.task.is_determined() {
        return Ok((0.0, first));
    }
    let mut best = (0.0, first, (2.0 * clear).max(0.2 * CLEAR));
    for (time, q) in Poses::new(model, system, assembly).closed() {
        let scene = scene(model, system, &Instant { time, q: q.to_vec() });
        let Ok(clear) = scene.clearance() else { continue };
        // What comes later is preferred a little to what was before.
        let clear = clear.min(CLEAR * 1.5) * if time < 0.0 { 0.8 } else { 1.0 };
        if clear > best.2 {
            best = (time, scene, clear);
        }
    }
    Ok((best.0, best.1))
}
