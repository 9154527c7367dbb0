//! Disc cams whose surface cannot be made at the declared parameters.
//!
//! ```text
//!   roller    κ ρ < 1           κ = (r² + 2 r′² − r r″) / (r² + r′²)^(3/2), r = R + ρ: the pitch curve
//!   flat      h + h″ > 0        the radius of curvature of the outline
//! ```
//!
//! Reference: Norton, Cam Design and Manufacturing Handbook, chapter 7.

use crate::diag::{Doubt, Warning, quantity};
use crate::expr::{Derivatives, Evaluator, Leaf, Values};
use crate::model::sketch::{Instantiation, JointArgument};
use crate::model::{Joint, Model, Said};
use crate::numeric::at_defaults;
use crate::quantity::Dim;
use crate::system::System;
use std::f64::consts::TAU;

/// Number of directions in which a cam is looked at.
const LOOKS: usize = 720;

/// Relative tolerance of radii of curvature.
const ROUNDED: f64 = 1e-9;

/// Warnings about cams that are undercut.
pub(super) fn undercut(model: &Model, system: &System) -> Vec<Warning> {
    let mut said = Said::default();
    let of_joint = |(joint, made): (&Joint, &Instantiation)| {
        let (angle, radius, roller) = at_defaults(model, system, |numeric| worst(model, made, &numeric.known))?;
        // One warning for all cams of a loop.
        if !said.is_new(&joint.name) {
            return None;
        }
        let [angle, radius] = [
            quantity(((2.0 * angle.to_degrees()).round() / 2.0).to_radians(), Dim::ANGLE),
            quantity((radius * 1e6).round() * 1e-6, Dim::LENGTH),
        ];
        let roller = roller.map(|roller| quantity(roller, Dim::LENGTH));
        Some(Warning { doubt: Doubt::Undercut { joint: joint.name.to_string(), angle, radius, roller }, range: (&joint.name).into() })
    };
    model.joints.iter().zip(&model.sketch.joints).filter_map(of_joint).collect()
}

/// Where the surface of a cam is undercut most: the direction in the cam, the radius of curvature of its pitch curve or outline, and the radius
/// of its roller.
fn worst(model: &Model, made: &Instantiation, known: &Values) -> Option<(f64, f64, Option<f64>)> {
    let (law, is_flat) = match made.kind.as_str() {
        "cam_roller" => ("R", false),
        "cam_flat" => ("h", true),
        _ => return None,
    };
    let Some(JointArgument::Function(law)) = made.argument(law) else { return None };
    let mut arena = model.sketch.arena.clone();
    let mut by_angle = Derivatives::new(Leaf::Time);
    let slope = by_angle.of(&mut arena, *law);
    let bend = by_angle.of(&mut arena, slope);
    let roller = match made.argument("roller") {
        Some(JointArgument::Number(roller, _)) => *roller,
        _ => arena.integer(0),
    };
    let mut evaluator = Evaluator::new(&arena, &[*law, slope, bend, roller]);
    let mut at = |angle: f64| {
        let mut found = [f64::NAN; 4];
        evaluator.run(&Values { time: angle, ..*known }, &mut found);
        found
    };
    let [first, last] = [-TAU / 2.0, TAU / 2.0].map(|angle| at(angle)[0]);
    // A law that does not repeat after a turn may be meant for a part of one. Of a function in Rust no values are known.
    let repeats = (first - last).abs() <= ROUNDED * first.abs();
    if !repeats {
        return None;
    }
    let looks = (0..LOOKS).map(|look| {
        let angle = look as f64 * TAU / LOOKS as f64 - TAU / 2.0;
        let [law, slope, bend, roller] = at(angle);
        if is_flat {
            // The normal may point towards the cam.
            let radius = law.signum() * (law + bend);
            return (angle, radius, radius, None);
        }
        let r = law + roller;
        let square = r * r + slope * slope;
        let curvature = (r * r + 2.0 * slope * slope - r * bend) / (square * square.sqrt());
        // Of a concave part the radius is no matter.
        let room = if curvature > 0.0 { 1.0 / curvature - roller } else { f64::INFINITY };
        (angle, room, 1.0 / curvature, Some(roller))
    });
    let (angle, room, radius, roller) =
        looks.filter(|look| look.1.is_finite()).reduce(|worst, look| if look.1 < worst.1 { look } else { worst })?;
    let is_undercut = room < -ROUNDED * roller.unwrap_or(radius.abs());
    is_undercut.then_some((angle, radius, roller))
}
