//! Code of the equations of motion.

use super::routine::Routine;
use super::schedule;
use super::words::Words;
use crate::dynamics::{Dynamics, MotionRow};
use crate::expr::{Arena, Expr};
use crate::model::Model;
use crate::system::System;

/// Code of the equations of motion, each routine with its results in the order stated.
#[derive(Clone, Debug)]
pub struct DynamicsCode {
    /// All expressions.
    pub arena: Arena,
    /// Indices in the state of the coordinates that are integrated.
    pub integrated: Vec<usize>,
    /// What changes its sign at the kinks of equations.
    pub kinks: Routine,
    /// What changes its sign at the kinks of forces.
    pub kinks_of_forces: Routine,
    /// Joint of each equation at t = 0, and whether it counts between positions and between speeds.
    pub initial_rows: Vec<(usize, [bool; 2])>,
    /// Dimension of each of these equations, as a power of a length.
    pub powers: Vec<u8>,
    /// Number of equations between integrated coordinates, the first of those at t = 0.
    pub rows: usize,
    /// How many of them follow from the others.
    pub redundant: usize,
    /// Φ, ν and the entries of J.
    pub constraints: Routine,
    /// The same of all equations at t = 0.
    pub initial: Routine,
    /// Φ, then J u − ν, of the equations at t = 0 that are not between integrated coordinates, from all entries of the state.
    pub departures: Routine,
    /// Row and column of each entry of J of all equations at t = 0 that is not always zero.
    pub pattern: Vec<(usize, usize)>,
    /// How many of these entries, the first, are of equations between integrated coordinates.
    pub entries: usize,
    /// Joint of each equation that is checked, and the power of a length with which it is judged.
    pub checked_rows: Vec<(usize, u8)>,
    /// Their Φ.
    pub checked: Routine,
    /// The entries of J, γ, the entries of M, f.
    pub balance: Routine,
    /// Row and column of each entry of M in its lower triangle that is not always zero.
    pub masses: Vec<(usize, usize)>,
    /// u̇, then the checked numbers of its computation, each with the number that it has to exceed.
    pub accelerations: Option<Routine>,
    /// The acceleration of every entry of the state; λ, the loads of joints and drives, and each checked number with its lower bound.
    pub with_loads: Option<Routine>,
    /// Value, rate and acceleration of every entry of the state.
    pub state: Routine,
    /// Kinetic energy, potential energy, power.
    pub energies: Routine,
}

/// Plans the equations of motion.
pub(super) fn code(model: &Model, system: &System, dynamics: &Dynamics) -> DynamicsCode {
    let words = Words::new(model, system);
    let arena = dynamics.arena.clone();
    let line = |results: Vec<Expr>| schedule::routine(&arena, results, &words);
    let Dynamics { initial, checked, mass, forces, state, energies, integrated, .. } = dynamics;
    let rows = &[dynamics.rows.as_slice(), &dynamics.redundant].concat();
    let all: Vec<MotionRow> = rows.iter().chain(initial).cloned().collect();
    let level = |row: &MotionRow| {
        // A pin holds a position, and leaves its rate to the equations between speeds.
        let is_pin = row.of.1 >= model.joints[row.of.0].residuals.len();
        (row.of.0, [row.phi.is_some(), !is_pin])
    };
    let is_entry = |entry: &Expr| *entry != dynamics.zero;
    let in_row = |row: &MotionRow| row.jacobian.clone().into_iter().enumerate().filter(|(_, entry)| is_entry(entry)).collect::<Vec<_>>();
    let entries = |rows: &[MotionRow]| rows.iter().flat_map(in_row).map(|(_, entry)| entry).collect::<Vec<_>>();
    let kinematics = |rows: &[MotionRow]| {
        let phi = rows.iter().map(|row| row.phi.unwrap_or(dynamics.zero));
        phi.chain(rows.iter().map(|row| row.nu)).chain(entries(rows)).collect::<Vec<_>>()
    };
    let gamma = rows.iter().map(|row| row.gamma);
    let pattern = all.iter().enumerate().flat_map(|(number, row)| in_row(row).into_iter().map(move |(column, _)| (number, column)));
    let triangle = (0..integrated.len()).flat_map(|row| (0..=row).map(move |column| (row, column)));
    let masses: Vec<((usize, usize), Expr)> = triangle.zip(mass.iter().copied()).filter(|(_, entry)| is_entry(entry)).collect();
    let of_masses = masses.iter().map(|(_, entry)| *entry);
    DynamicsCode {
        integrated: integrated.clone(),
        kinks: line(dynamics.kinks.clone()),
        kinks_of_forces: line(dynamics.kinks_of_forces.clone()),
        initial_rows: all.iter().map(level).collect(),
        powers: all.iter().map(|row| row.power).collect(),
        rows: rows.len(),
        redundant: dynamics.redundant.len(),
        checked_rows: checked.iter().map(|(joint, _, power)| (*joint, *power)).collect(),
        checked: line(checked.iter().map(|(_, phi, _)| *phi).collect()),
        constraints: line(kinematics(rows)),
        initial: line(kinematics(&all)),
        departures: line([0, 1].into_iter().flat_map(|level| dynamics.departures.iter().map(move |both| both[level])).collect()),
        pattern: pattern.collect(),
        entries: entries(rows).len(),
        balance: line(entries(rows).into_iter().chain(gamma).chain(of_masses).chain(forces.iter().copied()).collect()),
        masses: masses.into_iter().map(|(place, _)| place).collect(),
        accelerations: dynamics.accelerations.as_ref().map(|found| {
            let results = found.values.iter().chain(found.checks.iter().flatten());
            line(results.copied().collect())
        }),
        with_loads: dynamics.with_loads.as_ref().map(|found| {
            let results = found.accelerations.iter().chain(&found.loads).chain(found.checks.iter().flatten());
            line(results.copied().collect())
        }),
        state: line(state.iter().flatten().copied().collect()),
        energies: line(energies.to_vec()),
        arena,
    }
}
