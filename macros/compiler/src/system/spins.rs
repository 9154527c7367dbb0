//! Equations of motion with components of ω as the speeds of each body that is free to turn.
//!
//! The rates of a quaternion are one speed more than the body has, and masses that are constant in its axes vary with them. ω has the
//! numbers of the first three components of the quaternion; the fourth is not used.

use super::forest::{self, FreeSpeeds};
use super::rows::{self, Differentiation, Row};
use super::{Choice, Coordinate, Equation, rates};
use crate::expr::{Arena, Expr, Leaf, Seed, Spin};
use crate::model::Model;
use crate::quantity::Role;

/// Equations of motion by ω.
#[derive(Clone, Debug)]
pub struct EquationsBySpins {
    /// The equations between positions, each in the place of the same one by the rates of coordinates; those of norms are empty.
    pub equations: Vec<Equation>,
    /// The same of equations between speeds alone.
    pub of_speeds: Vec<Equation>,
    /// M u̇ − Q, by speed.
    pub forces: Vec<Expr>,
    /// The speeds of each body that is free to turn.
    pub spins: Vec<Spin>,
}

/// Derives the equations.
///
/// * `at_level`: given, for each row whether it is one of velocities.
pub(super) fn equations(model: &Model, arena: &mut Arena, coordinates: &[Coordinate], at_level: &[bool]) -> EquationsBySpins {
    // Outputs and loads are rewritten once more, since angles that they alone name are unknowns with numbers, too.
    let Choice { mut rows, balance, frames, .. } = forest::reduce(model, arena, FreeSpeeds::Spin);
    rows::integrate_again(model, arena, coordinates, &mut rows, at_level);
    let (of_speeds, rows): (Vec<Row>, Vec<Row>) = rows.into_iter().partition(|row| row.is_velocity);
    let columns = (0..coordinates.len() as u32).map(Leaf::Coordinate);
    let mut derivatives = Differentiation::new(columns, Seed::constant_speeds(rates(coordinates.len())), 0);
    let is_first = |coordinate: &&Coordinate| coordinate.role == Role::Quaternion(0);
    let spins = coordinates.iter().filter(is_first).filter_map(|coordinate| arena.spin(frames[coordinate.body])).collect();
    EquationsBySpins {
        equations: derivatives.of_all(arena, &rows),
        of_speeds: derivatives.of_all(arena, &of_speeds),
        forces: balance.map_or_else(Vec::new, |balance| balance.forces),
        spins,
    }
}
