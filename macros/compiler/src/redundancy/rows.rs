//! Numerical rows of Φ_q.

use crate::expr::{Evaluator, Expr, Values, evaluate};
use crate::model::Joint;
use crate::numeric::Numeric;
use crate::numeric::basis::{Basis, DEPENDENT, Matrix};
use crate::numeric::least_squares::TOUCHING;
use crate::numeric::samples::Pose;
use crate::quantity::Role;
use crate::structure::{Block, Structure, Subsystem};
use crate::system::Equation;
use std::collections::{BTreeMap, BTreeSet};

/// Rows of a subsystem, in the order in which the basis takes them.
pub(super) struct Rows {
    /// Rows of joints in declaration order, then of drives.
    pub(super) plain: Vec<usize>,
    /// Rows of joints declared as redundant.
    pub(super) marked: Vec<usize>,
}

impl Numeric<'_> {
    pub(super) fn joint(&self, subsystem: &Subsystem, row: usize) -> &Joint {
        &self.model.joints[self.system.equations[subsystem.equations[row]].joint]
    }

    pub(super) fn rows(&self, subsystem: &Subsystem) -> Rows {
        let mut all: Vec<usize> = (0..subsystem.equations.len()).collect();
        // Rows that hold by the choice of coordinates indicate a redundant joint: the other rows of that joint come last.
        let blamed: BTreeSet<usize> = match &self.system.declared {
            Some(_) => self.resting().iter().map(|row| self.system.equations[*row].joint).collect(),
            None => BTreeSet::new(),
        };
        let joint_of = |row: usize| self.system.equations[subsystem.equations[row]].joint;
        all.sort_by_key(|row| (self.joint(subsystem, *row).is_drive, blamed.contains(&joint_of(*row)), subsystem.equations[*row]));
        let (marked, plain) = all.into_iter().partition(|row| self.joint(subsystem, *row).is_redundant);
        Rows { plain, marked }
    }

    /// Rows of Φ_q of a subsystem at each pose, in scaled unknowns, normalised to unit length.
    pub(super) fn matrices(&self, subsystem: &Subsystem, poses: &[Pose]) -> Vec<Matrix> {
        let place: BTreeMap<usize, usize> = subsystem.unknowns.iter().enumerate().map(|(column, unknown)| (*unknown, column)).collect();
        let equations: Vec<&Equation> = subsystem.equations.iter().map(|equation| &self.system.equations[*equation]).collect();
        let roots: Vec<Expr> = equations.iter().flat_map(|equation| equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
        let mut evaluator = Evaluator::new(&self.system.arena, &roots);
        let mut values = vec![f64::NAN; roots.len()];
        // Rounding errors of a row that holds by construction must not count as a gradient.
        let resting = self.system.declared.is_some().then(|| self.resting());
        let matrix = |pose: &Pose| {
            evaluator.run(&Values { time: pose.time, coordinates: &pose.q, ..self.known }, &mut values);
            let mut entries = values.iter();
            let row = |(number, equation): (usize, &&Equation)| {
                let mut row = vec![0.0; subsystem.unknowns.len()];
                for ((unknown, _), value) in equation.jacobian.iter().zip(&mut entries) {
                    // A Rust function is unknown to the compiler: its row gets arbitrary entries, independent of all other rows.
                    let value =
                        if value.is_finite() { *value } else { 0.1 + (number as f64 * 0.754_877 + *unknown as f64 * 0.569_84).fract() };
                    if let Some(column) = place.get(unknown)
                        && !resting.is_some_and(|resting| resting.contains(&subsystem.equations[number]))
                    {
                        row[*column] = value * self.scale(*unknown);
                    }
                }
                // A row that touches zero along the motion demands nothing there.
                let touches = row.iter().all(|entry| entry.abs() < TOUCHING * self.natural(subsystem.equations[number]));
                if touches { vec![0.0; row.len()] } else { unit(row) }
            };
            equations.iter().enumerate().map(row).collect()
        };
        poses.iter().map(matrix).collect()
    }

    /// True if the Jacobian of a block's iterated unknowns, with the explicit unknowns eliminated, is singular.
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

    /// Names of the coordinates in some columns of a subsystem; of the angles only, if there are any.
    pub(super) fn names(&self, subsystem: &Subsystem, columns: &[usize]) -> Vec<String> {
        let name = |column: &usize| self.system.name(self.model, subsystem.unknowns[*column]);
        // If an angle is free, positions usually follow it.
        let is_angle = |column: &&usize| self.system.coordinates[subsystem.unknowns[**column]].role == Role::Angle;
        let angles: Vec<String> = columns.iter().filter(is_angle).map(name).collect();
        if angles.is_empty() { columns.iter().map(name).collect() } else { angles }
    }
}

/// True if the derivative of a block's residuals by its iterated unknowns is singular, with the explicit unknowns eliminated.
fn is_singular(block: &Block, rows: &[Vec<(usize, f64)>]) -> bool {
    let column = |iterated: &usize| {
        let mut moved: BTreeMap<usize, f64> = BTreeMap::from([(*iterated, 1.0)]);
        let along = |row: &[(usize, f64)], moved: &BTreeMap<usize, f64>| -> f64 {
            let terms = row.iter().filter_map(|(unknown, value)| Some(value * moved.get(unknown)?));
            let (sum, size) = terms.fold((0.0, 0.0), |(sum, size): (f64, f64), term| (sum + term, size + term.abs()));
            // The remainder of cancelling terms is rounding.
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
        // A Rust function, unknown to the compiler.
        return false;
    }
    let poses = [columns];
    let mut basis = Basis::new(&poses);
    !(0..block.iterated.len()).all(|column| basis.takes(column))
}

/// Normalises a row to unit length; zero stays zero.
fn unit(mut row: Vec<f64>) -> Vec<f64> {
    let length = row.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    if length > 0.0 {
        row.iter_mut().for_each(|entry| *entry /= length);
    }
    row
}
