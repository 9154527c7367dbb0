//! Coordinates that only equations of speeds determine keep their declared start values.

use super::rows::Row;
use super::{Coordinate, Equation};
use crate::expr::{Arena, Expr, Leaf, Values, evaluate};
use crate::linear::Echelon;
use crate::model::{Function, Model};
use crate::quantity::{Dim, Role};

/// Coordinates of which the equations leave more than this share open are pinned first.
const CLEARLY: f64 = 0.1;

/// The others are pinned if more than this share is open.
const HARDLY: f64 = 1e-9;

/// Rows that hold the coordinates which the equations leave open at the start; they belong to the last freedom.
pub(super) fn pins(model: &Model, arena: &mut Arena, coordinates: &[Coordinate], equations: &[Equation]) -> Vec<Row> {
    let (open, joint) = (open(model, arena, coordinates, equations), model.joints.len() - 1);
    let first = model.joints[joint].residuals.len();
    let row = |(number, unknown): (usize, usize)| {
        let Coordinate { role, start, .. } = coordinates[unknown];
        let leaf = arena.leaf(Leaf::Coordinate(unknown as u32));
        let residual = start.map_or(leaf, |start| arena.sub(leaf, start));
        let dim = match role {
            Role::Position(_) | Role::Displacement => Dim::LENGTH,
            Role::Angle => Dim::ANGLE,
            Role::Quaternion(_) => Dim::NUMBER,
        };
        Row { joint, row: first + number, dim, residual, is_velocity: false, is_initial: true }
    };
    open.into_iter().enumerate().map(row).collect()
}

/// Unknowns that Φ_q leaves open at the declared start.
fn open(model: &Model, arena: &Arena, coordinates: &[Coordinate], equations: &[Equation]) -> Vec<usize> {
    let functions = |number: u32, x: f64| match model.functions.get(number as usize) {
        Some(Function::Table(table)) => table.evaluate(x),
        _ => [f64::NAN; 3],
    };
    let nothing = Values { time: 0.0, parameters: &[], coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
    let defaults: Vec<Expr> = model.parameters.iter().map(|parameter| parameter.default).collect();
    let parameters = evaluate(arena, &defaults, &nothing);
    let known = Values { parameters: &parameters, ..nothing };
    let start = |coordinate: &Coordinate| coordinate.start.and_then(|start| evaluate(arena, &[start], &known).pop()).unwrap_or(0.0);
    let start: Vec<f64> = coordinates.iter().map(start).collect();
    let at_start = Values { coordinates: &start, ..known };
    let mut echelon = Echelon::new(coordinates.len());
    for equation in equations {
        let mut row = vec![0.0; coordinates.len()];
        let entries: Vec<Expr> = equation.jacobian.iter().map(|(_, entry)| *entry).collect();
        for ((column, _), value) in equation.jacobian.iter().zip(evaluate(arena, &entries, &at_start)) {
            row[*column] = value;
        }
        echelon.takes(row);
    }
    // Coordinates with a declared start come first; among them and among the others, those that are no pivot of an equation.
    let free = echelon.free();
    let mut order: Vec<usize> = (0..coordinates.len()).collect();
    order.sort_by_key(|unknown| (coordinates[*unknown].start.is_none(), !free.contains(unknown)));
    let mut pinned = Vec::new();
    for share in [CLEARLY, HARDLY] {
        for unknown in &order {
            let mut row = vec![0.0; coordinates.len()];
            row[*unknown] = 1.0;
            pinned.extend(echelon.takes_above(share, row).then_some(*unknown));
        }
    }
    pinned.sort_unstable();
    pinned
}
