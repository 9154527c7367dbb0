//! Choice of the configuration that is drawn: the start, or a pose near it if links of a planar mechanism overlap at the start.

use super::scene::{Instant, scene};
use crate::assembly::{Assembly, Poses};
use crate::model::Model;
use crate::quantity::Ambient;
use crate::system::System;
use reuleaux_picture::{Scene, Undrawable};

/// Wanted clearance of hinges and links, as a fraction of the size.
const CLEAR: f64 = 0.035;

/// Mechanisms with more bodies are drawn at their start.
const LARGEST: usize = 12;

/// The configuration that is drawn, with its time.
pub(super) fn pose(model: &Model, system: &System, assembly: &Assembly) -> Result<(f64, Scene), Undrawable> {
    let first = scene(model, system, &Instant { time: 0.0, q: assembly.start.clone() });
    // In space, the direction of view is chosen instead.
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
        // A pose before the start is preferred only if it is clearly better.
        let clear = clear.min(CLEAR * 1.5) * if time < 0.0 { 0.8 } else { 1.0 };
        if clear > best.2 {
            best = (time, scene, clear);
        }
    }
    Ok((best.0, best.1))
}
