//! Equations of positions, and configurations that satisfy them.

use super::super::Equation;
use crate::expr::{Arena, Evaluator, Expr, Values};
use crate::linear::Echelon;
use crate::linear::dense::cholesky;
use std::collections::BTreeSet;

/// A coordinate is pinned first if the equations leave more than this fraction of it open.
const CLEARLY: f64 = 0.1;

/// The other coordinates are pinned if more than this fraction is open.
const HARDLY: f64 = 1e-9;

/// At a dead point steps converge slowly: an unknown that holds less than this part of what is open counts as holding nothing.
const BARELY: f64 = 1e-4;

/// Newton steps to a configuration that satisfies the equations.
const STEPS: usize = 40;

/// Each step is halved at most so often.
const HALVINGS: usize = 20;

/// The equations hold if no row, divided by its largest derivative, exceeds this, in m or rad.
pub(super) const HOLDS: f64 = 1e-12;

/// Added to the diagonal of Φ_q Φ_qᵀ, since rows may depend on each other.
const DAMPING: f64 = 1e-13;

/// Equations of positions, at the defaults and t = 0.
pub(super) struct PositionRows<'a> {
    known: Values<'a>,
    evaluator: Evaluator,
    /// Row and column of each derivative.
    pattern: Vec<(usize, usize)>,
    pub(super) shape: [usize; 2],
}

impl<'a> PositionRows<'a> {
    pub(super) fn new(arena: &Arena, known: &Values<'a>, equations: &[Equation], columns: usize) -> PositionRows<'a> {
        let rows: Vec<(Expr, &Equation)> = equations.iter().filter_map(|equation| Some((equation.phi()?, equation))).collect();
        let entries = || rows.iter().enumerate().flat_map(|(row, (_, equation))| equation.jacobian.iter().map(move |one| (row, one)));
        let roots: Vec<Expr> = rows.iter().map(|(phi, _)| *phi).chain(entries().map(|(_, (_, entry))| *entry)).collect();
        let pattern = entries().map(|(row, (column, _))| (row, *column)).collect();
        PositionRows { known: *known, evaluator: Evaluator::new(arena, &roots), pattern, shape: [rows.len(), columns] }
    }

    /// Φ and Φ_q, each row divided by its largest derivative. Rows without a value, such as those of Rust functions, count as closed.
    pub(super) fn at(&mut self, q: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
        let [rows, columns] = self.shape;
        let mut values = vec![0.0; rows + self.pattern.len()];
        self.evaluator.run(&Values { coordinates: q, ..self.known }, &mut values);
        let mut jacobian = vec![vec![0.0; columns]; rows];
        self.pattern.iter().zip(&values[rows..]).for_each(|((row, column), entry)| jacobian[*row][*column] = *entry);
        values.truncate(rows);
        for (phi, row) in values.iter_mut().zip(&mut jacobian) {
            let largest = row.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
            if !phi.is_finite() || row.iter().any(|entry| !entry.is_finite()) {
                *phi = 0.0;
                row.fill(0.0);
            } else if largest > 0.0 {
                *phi /= largest;
                row.iter_mut().for_each(|entry| *entry /= largest);
            }
        }
        (values, jacobian)
    }

    /// The unknowns that Φ_q leaves open at a configuration.
    pub(super) fn open(&mut self, q: &[f64], is_declared: &[bool]) -> Vec<usize> {
        let mut echelon = Echelon::new(q.len());
        for row in self.at(q).1 {
            echelon.takes(row);
        }
        // Coordinates with a declared start come first; among them and among the others, those that are no pivot of an equation.
        let free = echelon.free();
        let mut order: Vec<usize> = (0..q.len()).collect();
        order.sort_by_key(|unknown| (!is_declared[*unknown], !free.contains(unknown)));
        let mut pinned = Vec::new();
        for share in [CLEARLY, HARDLY] {
            for unknown in &order {
                let mut row = vec![0.0; q.len()];
                row[*unknown] = 1.0;
                pinned.extend(echelon.takes_above(share, row).then_some(*unknown));
            }
        }
        pinned.sort_unstable();
        pinned
    }

    /// A mark for each unknown that equations link with any of these, and for these.
    pub(super) fn linked(&self, unknowns: impl Iterator<Item = usize>) -> Vec<bool> {
        let mut is_linked = vec![false; self.shape[1]];
        unknowns.for_each(|unknown| is_linked[unknown] = true);
        loop {
            let reached: BTreeSet<usize> = self.pattern.iter().filter(|(_, column)| is_linked[*column]).map(|(row, _)| *row).collect();
            let next = self.pattern.iter().filter(|(row, column)| reached.contains(row) && !is_linked[*column]);
            let next: Vec<usize> = next.map(|(_, column)| *column).collect();
            if next.is_empty() {
                return is_linked;
            }
            next.into_iter().for_each(|column| is_linked[column] = true);
        }
    }

    /// True if the equations and some unknowns held leave nothing open at a configuration.
    pub(super) fn hold(&mut self, q: &[f64], held: &[usize]) -> bool {
        let mut echelon = Echelon::new(q.len());
        let rows = self.at(q).1;
        let before = rows.into_iter().filter(|row| echelon.takes(row.clone())).count();
        let holds = |unknown: &usize| (0..q.len()).map(|column| f64::from(u8::from(column == *unknown))).collect();
        let taken = held.iter().filter(|unknown| echelon.takes_above(BARELY, holds(unknown))).count();
        before + taken == q.len()
    }

    /// A configuration that satisfies the equations, by the shortest steps Φ_qᵀ (Φ_q Φ_qᵀ)⁻¹ Φ; `None` if they do not lead to one. The
    /// values of some unknowns are held.
    pub(super) fn closed_near(&mut self, start: &[f64], held: &[usize]) -> Option<Vec<f64>> {
        let mut q = start.to_vec();
        let (mut phi, mut jacobian) = self.at(&q);
        for _ in 0..STEPS {
            if phi.iter().all(|value| value.abs() <= HOLDS) {
                return Some(q);
            }
            jacobian.iter_mut().for_each(|row| held.iter().for_each(|unknown| row[*unknown] = 0.0));
            let change = shortest(&phi, &jacobian)?;
            let cost = product(&phi, &phi);
            let shorter = (0..HALVINGS).find_map(|halvings| {
                let share = 0.5_f64.powi(halvings as i32);
                let trial: Vec<f64> = q.iter().zip(&change).map(|(value, change)| value - share * change).collect();
                let there = self.at(&trial);
                (product(&there.0, &there.0) < cost).then_some((trial, there))
            });
            (q, (phi, jacobian)) = shorter?;
        }
        None
    }
}

/// The shortest change by which the linearized equations hold.
pub(super) fn shortest(phi: &[f64], jacobian: &[Vec<f64>]) -> Option<Vec<f64>> {
    let mut matrix: Vec<Vec<f64>> = jacobian.iter().map(|one| jacobian.iter().map(|other| product(one, other)).collect()).collect();
    for (number, row) in matrix.iter_mut().enumerate() {
        row[number] += DAMPING;
    }
    let factors = cholesky(matrix, phi.to_vec())?;
    let columns = jacobian.first()?.len();
    Some((0..columns).map(|column| factors.iter().zip(jacobian).map(|(factor, row)| factor * row[column]).sum()).collect())
}

pub(super) fn product(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}
