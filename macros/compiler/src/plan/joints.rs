//! Equations of a system grouped by joint, with the targets of their results.

use super::rolled::{Cell, Target};
use crate::expr::Expr;
use crate::system::Equation;

/// Equations of a system, grouped by joint.
pub(super) struct Joints<'a> {
    /// Equations of each joint, with their indices in Φ.
    joints: Vec<Vec<(u32, &'a Equation)>>,
}

impl<'a> Joints<'a> {
    pub(super) fn new(equations: &'a [Equation]) -> Joints<'a> {
        let mut joints: Vec<Vec<(u32, &Equation)>> = Vec::new();
        for (row, equation) in equations.iter().enumerate() {
            match joints.last_mut() {
                Some(joint) if joint.last().is_some_and(|(_, last)| last.joint == equation.joint) => joint.push((row as u32, equation)),
                _ => joints.push(vec![(row as u32, equation)]),
            }
        }
        Joints { joints }
    }

    /// One result per equation.
    pub(super) fn rows(&self, of: impl Fn(&Equation) -> Option<Expr>) -> Vec<Cell> {
        let cell =
            |joint: &Vec<(u32, &Equation)>| joint.iter().filter_map(|(row, equation)| Some((Target::Row(*row), of(equation)?))).collect();
        self.joints.iter().map(cell).collect()
    }

    /// Entries of Φ_q as a list.
    pub(super) fn entries(&self) -> Vec<Cell> {
        let mut number = 0;
        let mut next = || {
            number += 1;
            Target::Row(number - 1)
        };
        let cell = |joint: &Vec<(u32, &Equation)>| {
            joint.iter().flat_map(|(_, equation)| &equation.jacobian).map(|(_, entry)| (next(), *entry)).collect()
        };
        self.joints.iter().map(cell).collect()
    }

    /// Φ, then the entries of Φ_q with row and column.
    pub(super) fn linearized(&self, residual: impl Fn(&Equation) -> Option<Expr>) -> Vec<Cell> {
        let entries = |(row, equation): &(u32, &'a Equation)| {
            let row = *row;
            equation.jacobian.iter().map(move |(column, entry)| (Target::Entry(row, *column as u32), *entry)).collect::<Vec<_>>()
        };
        let cells = self.rows(residual).into_iter().zip(&self.joints);
        cells.map(|(phi, joint)| phi.into_iter().chain(joint.iter().flat_map(entries)).collect()).collect()
    }

    /// Row and column of each entry of Φ_q.
    pub(super) fn pattern(&self) -> Vec<(usize, usize)> {
        let entries = |(row, equation): &(u32, &'a Equation)| {
            let row = *row as usize;
            equation.jacobian.iter().map(move |(column, _)| (row, *column)).collect::<Vec<_>>()
        };
        self.joints.iter().flatten().flat_map(entries).collect()
    }
}
