//! Coordinates that only equations of speeds determine keep their declared start values. One without a declared start keeps 0 if the
//! mechanism closes there, and otherwise its value in a configuration nearby that satisfies the equations of positions. If the mechanism does
//! not close at the declared values, these are only the guess for such a configuration; then an unknown without a declared start whose rate alone
//! is given, by a freedom or by a drive, keeps 0. If no steps from the guess lead to such a configuration, others are guesses.
//!
//! If declared places or turns are not kept, the compiler looks for a configuration that is nearer to them and pins coordinates there; those linked
//! with them that have no declared start begin there.

mod nearest;
mod position;
mod start;

use super::rows::Row;
use super::{Coordinate, Equation};
use crate::expr::{Arena, Exact, Leaf, Values, evaluate};
use crate::model::{Model, defaults, tabulated};
use crate::quantity::{Dim, Role};
use crate::structure::SMALL;
use nearest::nearest;
use position::PositionRows;
use start::{DeclaredStart, SWAYS, WIDE};

/// Another configuration is taken if it is nearer by more than this part.
const NEARER: f64 = 1e-6;

/// Rows that hold the coordinates which the equations leave open at the start; they belong to the last freedom.
///
/// * `coordinates`: given and returned; those without a declared start begin at the configuration found, if it is nearer to the declared places.
/// * `of_speeds`: given, the equations of speeds, with those of freedoms.
pub(super) fn pins(model: &Model, arena: &mut Arena, coordinates: &mut [Coordinate], [equations, of_speeds]: [&[Equation]; 2]) -> Vec<Row> {
    let Open { start, unknowns, keeps_declared, begins_there } = open(model, arena, coordinates, [equations, of_speeds]);
    for unknown in begins_there {
        coordinates[unknown].start = Exact::binary(start[unknown]).map(|value| arena.constant(value));
    }
    let coordinates = &*coordinates;
    let joint = model.joints.len() - 1;
    let first = model.joints[joint].residuals.len();
    let row = |(number, unknown): (usize, usize)| {
        let role = coordinates[unknown].role;
        let leaf = arena.leaf(Leaf::Coordinate(unknown as u32));
        let nearby = Exact::binary(start[unknown]).filter(|_| !keeps_declared[unknown] || !is_declared(model, &coordinates[unknown]));
        let held = nearby.map(|value| arena.constant(value)).or(coordinates[unknown].start);
        let residual = held.map_or(leaf, |held| arena.sub(leaf, held));
        let dim = match role {
            Role::Position(_) | Role::Displacement => Dim::LENGTH,
            Role::Angle => Dim::ANGLE,
            Role::Quaternion(_) => Dim::NUMBER,
        };
        Row { joint, row: first + number, dim, residual, is_velocity: false, is_initial: true }
    };
    unknowns.into_iter().enumerate().map(row).collect()
}

/// What the equations of positions leave open.
struct Open {
    /// A configuration near the declared start.
    start: Vec<f64>,
    /// The unknowns that Φ_q leaves open there.
    unknowns: Vec<usize>,
    /// True of each unknown that has its declared start value, if it has one.
    keeps_declared: Vec<bool>,
    /// The unknowns without a declared start that begin at this configuration.
    begins_there: Vec<usize>,
}

/// True if a start value of a coordinate is declared. In space an angle or a component of a quaternion has one, even if it is 0, where the
/// orientation of the body is declared.
fn is_declared(model: &Model, coordinate: &Coordinate) -> bool {
    let declared = &model.bodies[coordinate.body].coordinates;
    let is_turned = || declared.iter().any(|one| matches!(one.role, Role::Quaternion(_)) && one.start.is_some());
    match coordinate.role {
        Role::Quaternion(_) => is_turned(),
        Role::Angle => coordinate.start.is_some() || is_turned(),
        Role::Position(_) | Role::Displacement => coordinate.start.is_some(),
    }
}

fn open(model: &Model, arena: &Arena, coordinates: &[Coordinate], [equations, of_speeds]: [&[Equation]; 2]) -> Open {
    let functions = |number: u32, x: f64| tabulated(&model.functions, number, x);
    let parameters = defaults(model, arena);
    let known = Values { time: 0.0, parameters: &parameters, coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
    let start = |coordinate: &Coordinate| coordinate.start.and_then(|start| evaluate(arena, &[start], &known).pop()).unwrap_or(0.0);
    let rates = || of_speeds.iter().filter(|row| row.jacobian.len() == 1);
    let declared = DeclaredStart {
        values: coordinates.iter().map(start).collect(),
        are_declared: coordinates.iter().map(|coordinate| is_declared(model, coordinate)).collect(),
        are_turns: coordinates.iter().map(|one| matches!(one.role, Role::Angle | Role::Quaternion(_))).collect(),
        rates: rates().map(|row| row.jacobian[0].0).collect(),
        driven: rates().filter(|row| model.joints[row.joint].is_driven()).map(|row| row.jacobian[0].0).collect(),
    };
    let mut rows = PositionRows::new(arena, &known, equations, coordinates.len());
    let open = as_declared(&mut rows, &declared);
    if declared.values.len() > SMALL || !(0..declared.values.len()).any(|unknown| declared.is_place(unknown)) {
        return open;
    }
    let closed = rows.closed_near(&open.start, &open.unknowns);
    let distance = closed.as_ref().map_or(f64::INFINITY, |closed| declared.distance(closed));
    if let Some(start) = closed.filter(|_| distance <= declared.exact()) {
        // At a dead point other coordinates are open than beside it.
        let unknowns = if rows.hold(&start, &open.unknowns) { open.unknowns } else { rows.open(&start, &declared.are_declared) };
        let begins_there = declared.undeclared(&rows.linked(unknowns.iter().copied().filter(|unknown| declared.is_told_nothing(*unknown))));
        return Open { start, unknowns, begins_there, ..open };
    }
    let is_held = |unknown: &usize| declared.are_turns[*unknown] && declared.are_declared[*unknown];
    let held: Vec<usize> = open.unknowns.iter().copied().filter(is_held).chain(declared.driven.iter().copied()).collect();
    match nearest(&mut rows, &declared, &held).filter(|found| declared.distance(found) < (1.0 - NEARER) * distance) {
        None => open,
        Some(start) => {
            let keeps_declared: Vec<bool> = (0..start.len()).map(|unknown| declared.is_kept(unknown, start[unknown])).collect();
            // Places that are not kept follow from turns, whatever the parameters are.
            let is_kept: Vec<bool> = keeps_declared.iter().zip(&declared.are_declared).map(|(kept, declared)| *kept && *declared).collect();
            let unknowns = rows.open(&start, &is_kept);
            let begins_there = declared.undeclared(&rows.linked(unknowns.iter().copied()));
            Open { start, unknowns, keeps_declared, begins_there }
        }
    }
}

/// The unknowns that are open if declared starts are kept, as far as the mechanism closes with them.
fn as_declared(rows: &mut PositionRows, start: &DeclaredStart) -> Open {
    let DeclaredStart { values: declared, are_declared: is_declared, rates, .. } = start;
    let kept = |(start, unknowns): (Vec<f64>, Vec<usize>)| Open {
        keeps_declared: vec![true; start.len()],
        start,
        unknowns,
        begins_there: Vec::new(),
    };
    let open = rows.open(declared, is_declared);
    let held: Vec<usize> = open.iter().copied().filter(|unknown| is_declared[*unknown]).collect();
    // Equations that depend on each other at the declared start alone leave fewer unknowns open beside it.
    let may_leave_fewer = rows.shape[0] + open.len() > declared.len() && declared.len() <= SMALL;
    let fewer = |(attempt, held): (usize, &[usize])| {
        let closed = rows.closed_near(&start.swayed(attempt), held)?;
        let there = rows.open(&closed, is_declared);
        (there.len() < open.len()).then_some((closed, there))
    };
    let attempts = [held.as_slice(), &[]].into_iter().flat_map(|held| (0..=SWAYS.len()).map(move |attempt| (attempt, held)));
    if let Some(found) = attempts.filter(|_| may_leave_fewer).find_map(fewer) {
        return kept(found);
    }
    if rows.closed_near(declared, &open).is_some() {
        return kept((declared.clone(), open));
    }
    if let Some(closed) = rows.closed_near(declared, &held) {
        let open = if held.is_empty() { rows.open(&closed, is_declared) } else { open };
        return kept((closed, open));
    }
    // Steps that end at a smallest gap say nothing about other configurations.
    let from = |attempt: usize, held: &[usize]| {
        let mut there = start.swayed(attempt);
        held.iter().for_each(|unknown| there[*unknown] = declared[*unknown]);
        there
    };
    let most = if declared.len() <= SMALL { SWAYS.len() + WIDE } else { 0 };
    let mut closed_anywhere = |held: &[usize]| (0..=most).find_map(|attempt| rows.closed_near(&from(attempt, held), held));
    // A coordinate whose rate alone is known is rather held at 0 than another one at a declared start at which nothing closes.
    let is_rate: Vec<bool> = (0..declared.len()).map(|unknown| rates.contains(&unknown)).collect();
    let may_be_held = !rates.is_empty() && !rates.iter().any(|unknown| is_declared[*unknown]);
    if let Some(closed) = may_be_held.then(|| closed_anywhere(rates)).flatten() {
        let unknowns = rows.open(&closed, &is_rate);
        return Open { unknowns, keeps_declared: vec![false; closed.len()], start: closed, begins_there: Vec::new() };
    }
    if closed_anywhere(&open).is_some() {
        return kept((declared.clone(), open));
    }
    if let Some(closed) = closed_anywhere(&held) {
        let open = rows.open(&closed, is_declared);
        return kept((closed, open));
    }
    // It does not close, as is said later of its joints; until then its freedoms are counted beside the start.
    let beside = may_leave_fewer.then(|| rows.open(&start.swayed(1), is_declared));
    kept((declared.clone(), beside.filter(|beside| beside.len() < open.len()).unwrap_or(open)))
}
