//! Rows of Φ_q as numbers.

use crate::expr::{Evaluator, Expr, Values, evaluate};
use crate::model::Joint;
use crate::numeric::Numeric;
use crate::numeric::basis::{Basis, DEPENDENT, Matrix};
use crate::numeric::samples::Pose;
use crate::quantity::Role;
use crate::structure::{Block, Structure, Subsystem};
use crate::system::Equation;
use std::collections::BTreeMap;

/// The rows of a subsystem, in the order in which they are taken.
pub(super) struct Rows {
    /// Of joints in the order declared, then of drives.
    pub(super) plain: Vec<usize>,
    /// Of redundant joints.
    pub(super) marked: Vec<usize>,
}

impl Numeric<'_> {
    pub(super) fn joint(&self, subsystem: &Subsystem, row: usize) -> &Joint {
        &self.model.joints[self.system.equations[subsystem.equations[row]].joint]
    }

    pub(super) fn rows(&self, subsystem: &Subsystem) -> Rows {
        let mut all: Vec<usize> = (0..subsystem.equations.len()).collect();
        all.sort_by_key(|row| (self.joint(subsystem, *row).is_drive, subsystem.equations[*row]));
        let (marked, plain) = all.into_iter().partition(|row| self.joint(subsystem, *row).is_redundant);
        Rows { plain, marked }
    }

    /// The rows of Φ_q that belong to a subsystem, at each pose, in scaled unknowns and of unit length.
    pub(super) fn matrices(&self, subsystem: &Subsystem, poses: &[Pose]) -> Vec<Matrix> {
        let place: BTreeMap<usize, usize> = subsystem.unknowns.iter().enumerate().map(|(column, unknown)| (*unknown, column)).collect();
        let equations: Vec<&Equation> = subsystem.equations.iter().map(|equation| &self.system.equations[*equation]).collect();
        let roots: Vec<Expr> = equations.iter().flat_map(|equation| equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
        let mut evaluator = Evaluator::new(&self.system.arena, &roots);
        let mut values = vec![f64::NAN; roots.len()];
        let matrix = |pose: &Pose| {
            evaluator.run(&Values { time: pose.time, coordinates: &pose.q, ..self.known }, &mut values);
            let mut entries = values.iter();
            let row = |(number, equation): (usize, &&Equation)| {
                let mut row = vec![0.0; subsystem.unknowns.len()];
                for ((unknown, _), value) in equation.jacobian.iter().zip(&mut entries) {
                    // A function in Rust is not known here: its row is taken for one that has nothing to do with any other.
                    let value =
                        if value.is_finite() { *value } else { 0.1 + (number as f64 * 0.754_877 + *unknown as f64 * 0.569_84).fract() };
                    if let Some(column) = place.get(unknown) {
                        row[*column] = value * self.scale(*unknown);
                    }
                }
                unit(row)
            };
            equations.iter().enumerate().map(row).collect()
        };
        poses.iter().map(matrix).collect()
    }

    /// In one of the blocks the Jacobian of what is iterated, everything explicit put in, is singular.
    pub(super) fn has_singular_block(&self, structure: &Structure, q: &[f64]) -> bool {
        let roots: Vec<Expr> =
            self.system.equations.iter().flat_map(|equation| equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
        let values = evaluate(&self.system.arena, &roots, &Values { coordinates: q, ..self.known });
        let mut entries = values.into_iter();
        let rows: Vec<Vec<(usize, f64)>> = self
            .system
            .equations
            .iter()
            .map(|equation| {
                equation.jacobian.iter().zip(&mut entries).map(|((unknown, _), value)| (*unknown, value * self.scale(*unknown))).collect()
            })
            .collect();
        structure.blocks.iter().filter(|block| !block.iterated.is_empty()).any(|block| is_singular(block, &rows))
    }

    /// The coordinates in these columns of a subsystem.
    pub(super) fn names(&self, subsystem: &Subsystem, columns: &[usize]) -> Vec<String> {
        let name = |column: &usize| self.system.name(self.model, subsystem.unknowns[*column]);
        // Where an angle is free, places mostly follow it.
        let is_angle = |column: &&usize| self.system.coordinates[subsystem.unknowns[**column]].role == Role::Angle;
        let angles: Vec<String> = columns.iter().filter(is_angle).map(name).collect();
        if angles.is_empty() { columns.iter().map(name).collect() } else { angles }
    }
}

/// The derivative of a block's residuals by what it iterates is singular, everything explicit put in.
fn is_singular(block: &Block, rows: &[Vec<(usize, f64)>]) -> bool {
    let column = |iterated: &usize| {
        let mut moved: BTreeMap<usize, f64> = BTreeMap::from([(*iterated, 1.0)]);
        let along = |row: &[(usize, f64)], moved: &BTreeMap<usize, f64>| -> f64 {
            let terms = row.iter().filter_map(|(unknown, value)| Some(value * moved.get(unknown)?));
            let (sum, size) = terms.fold((0.0, 0.0), |(sum, size): (f64, f64), term| (sum + term, size + term.abs()));
            // What is left of terms that cancel is rounding.
            if sum.abs() < DEPENDENT * size { 0.0 } else { sum }
        };
        for explicit in &block.explicit {
            let row = &rows[explicit.equation];
            let pivot = row.iter().find(|(unknown, _)| *unknown == explicit.unknown).map_or(f64::NAN, |(_, value)| *value);
            let way = -along(row, &moved) / pivot;
            moved.insert(explicit.unknown, way);
        }
        block.residuals.iter().map(|equation| along(&rows[*equation], &moved)).collect()
    };
    let columns: Vec<Vec<f64>> = block.iterated.iter().map(column).map(unit).collect();
    if columns.iter().flatten().any(|value| !value.is_finite()) {
        // A function in Rust, of which nothing is known.
        return false;
    }
    let poses = [columns];
    let mut basis = Basis::new(&poses);
    !(0..block.iterated.len()).all(|column| basis.takes(column))
}

/// A row of unit length; one that is zero stays so.
fn unit(mut row: Vec<f64>) -> Vec<f64> {
    let length = row.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    if length > 0.0 {
        row.iter_mut().for_each(|entry| *entry /= length);
    }
    row
}
