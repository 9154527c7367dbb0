//! Code of the loads.

use super::routine::Routine;
use super::schedule;
use super::words::Words;
use crate::dynamics::Loads;
use crate::expr::{Arena, Expr};
use crate::model::Model;
use crate::system::System;

/// Code of the loads, each routine with its results in the order stated.
#[derive(Clone, Debug)]
pub struct LoadsCode {
    /// All expressions.
    pub arena: Arena,
    /// Number of multipliers.
    pub multipliers: usize,
    /// Number of results of `actions`.
    pub width: usize,
    /// Equation and speed of each entry of Φ_u.
    pub pattern: Vec<(usize, usize)>,
    /// Entries of Φ_u, then f.
    pub equations: Routine,
    /// What joints and drives do, from multipliers as data.
    pub actions: Routine,
    /// λ, what joints and drives do, and each number with the one that it has to exceed.
    pub closed: Option<Routine>,
    /// Kinetic energy, potential energy, and power of the forces declared.
    pub energies: Routine,
}

/// Plans the loads.
pub(super) fn code(model: &Model, system: &System, loads: Option<&Loads>) -> Option<LoadsCode> {
    let (loads, equations) = (loads?, system.loads.as_ref()?);
    let words = Words::new(model, system);
    let arena = loads.arena.clone();
    let line = |results: Vec<Expr>| schedule::routine(&arena, results, &words);
    let rows = || equations.rows.iter().filter(|row| !row.is_of_freedom);
    let entries = || rows().enumerate().flat_map(|(number, row)| row.jacobian.iter().map(move |(speed, entry)| ((number, *speed), *entry)));
    let closed = loads.closed.as_ref().map(|found| {
        let results = found.values.iter().chain(&found.actions).chain(found.checks.iter().flatten());
        line(results.copied().collect())
    });
    Some(LoadsCode {
        multipliers: rows().count(),
        width: loads.actions.len(),
        pattern: entries().map(|(place, _)| place).collect(),
        equations: line(entries().map(|(_, entry)| entry).chain(equations.forces.iter().copied()).collect()),
        actions: line(loads.actions.clone()),
        closed,
        energies: line(equations.energies.to_vec()),
        arena,
    })
}
