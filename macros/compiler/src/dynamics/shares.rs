//! Joints whose bodies do not get opposite loads: gears between bodies, racks, belts, differentials.
//!
//! Equations that depend on how two bodies stand against each other alone do no work in a motion of both together, so that their forces and
//! their moments about one point are opposite. Equations between more bodies, or between the angles of bodies against ground, need the load
//! on each.

use super::loads::state_at;
use crate::assembly::Assembly;
use crate::expr::{Arena, Values, evaluate};
use crate::library;
use crate::model::Model;
use crate::numeric::Numeric;
use crate::quantity::Ambient;
use crate::redundancy::subsystems;
use crate::structure::Structure;
use crate::system::{LoadEquations, LoadRow};
use std::collections::{BTreeMap, BTreeSet};

/// Sums of forces and moments below such a part of their terms are rounding.
const ROUNDING: f64 = 1e-9;

/// By joint, the bodies with loads of their own beside the one on which the load of the joint is stated.
///
/// For a joint of the library the answer is the same at every pose. For one of a definition it need not be: the ends of a rope over a pulley
/// may be in line at the start.
pub(super) fn shares(
    numeric: &Numeric,
    structure: &Structure,
    arena: &mut Arena,
    assembly: &Assembly,
    equations: &LoadEquations,
) -> BTreeMap<usize, Vec<usize>> {
    let model = numeric.model;
    let start = (numeric.known.time, state_at(numeric, arena, numeric.known.time, &assembly.start));
    let mut elsewhere = None;
    let mut shares = BTreeMap::new();
    for (index, joint) in model.joints.iter().enumerate().filter(|(_, joint)| joint.freedom.is_none() && !joint.is_drive) {
        let Some((stated, _)) = equations.arms[index].as_ref().filter(|_| !joint.residuals.is_empty()) else { continue };
        let own: Vec<&LoadRow> = equations.rows.iter().filter(|row| row.joint == index).collect();
        let speeds = own.iter().flat_map(|row| row.jacobian.iter().map(|(speed, _)| *speed));
        let bodies: BTreeSet<usize> = speeds.map(|speed| model.ambient.body_of(speed)).collect();
        let is_balanced = |arena: &Arena, (time, state): &(f64, Vec<f64>)| {
            let known = Values { time: *time, coordinates: state, ..numeric.known };
            own.iter().all(|row| is_balanced(model, arena, row, &known))
        };
        let is_of_library = || library::constraints(model.ambient).any(|known| known == joint.kind);
        let mut are_opposite = bodies.len() < 2 || bodies.len() == 2 && is_balanced(arena, &start);
        if bodies.len() == 2 && are_opposite && !is_of_library() {
            let states = elsewhere.get_or_insert_with(|| reached(numeric, structure, arena, assembly));
            are_opposite = states.iter().all(|state| is_balanced(arena, state));
        }
        if !are_opposite {
            shares.insert(index, bodies.into_iter().filter(|body| body != stated).collect());
        }
    }
    shares
}

/// Times and states of poses that the mechanism reaches from its start.
fn reached(numeric: &Numeric, structure: &Structure, arena: &mut Arena, assembly: &Assembly) -> Vec<(f64, Vec<f64>)> {
    let leaves_out = |equation: usize| structure.checked.contains(&equation);
    let samples = numeric.samples(&subsystems(numeric.system, structure), &assembly.start, leaves_out);
    samples.poses.iter().map(|pose| (pose.time, state_at(numeric, arena, pose.time, &pose.q))).collect()
}

/// The forces of a row have no sum, and no moment.
fn is_balanced(model: &Model, arena: &Arena, row: &LoadRow, known: &Values) -> bool {
    let values = evaluate(arena, &row.jacobian.iter().map(|(_, entry)| *entry).collect::<Vec<_>>(), known);
    let mut sums = vec![[0.0, 0.0]; model.ambient.speeds().len()];
    let mut add = |at: usize, value: f64| sums[at] = [sums[at][0] + value, sums[at][1] + value.abs()];
    for ((speed, _), value) in row.jacobian.iter().zip(values) {
        let body = model.ambient.body_of(*speed);
        let (place, at) = (model.ambient.first_coordinate(body), speed - model.ambient.first_speed(body));
        add(at, value);
        if at >= model.ambient.components() {
            continue;
        }
        // The moment about the origin of ground of a force along this axis.
        match model.ambient {
            Ambient::Plane => add(2, if at == 0 { -value * known.coordinates[place + 1] } else { value * known.coordinates[place] }),
            Ambient::Space => {
                let [next, last] = [(at + 1) % 3, (at + 2) % 3];
                add(3 + next, value * known.coordinates[place + last]);
                add(3 + last, -value * known.coordinates[place + next]);
            }
        }
    }
    sums.into_iter().all(|[sum, size]| sum.abs() <= ROUNDING * size)
}
