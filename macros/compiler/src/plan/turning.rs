//! Blocks that solve for the orientation of a free body: columns of their Jacobian by turns instead of components of a quaternion.
//!
//! ```text
//! A δ = b     A = M D
//! (ρ, θ) = D δe     ρ = 2 e · δe,  θ = 2/(e · e) vec(δe ē)
//! ```
//!
//! M has three columns of turns θ about the axes of ground, which are shorter than the four columns of e. In the row of the norm its only
//! entry is 1. Only rows in which e occurs through vectors fixed in the body can be written so: they do not change
//! with the length of e.

#[cfg(test)]
mod tests;

use super::stage::Iteration;
use crate::expr::{Arena, Expr, Leaf, Mark, Node, derivative};
use crate::quantity::Role;
use crate::structure::Block;
use crate::system::System;
use std::collections::BTreeSet;

/// A quaternion that a block solves for together with its norm.
pub(super) struct TurningBody {
    body: usize,
    /// Index of e0 to e3 among the unknowns of the block.
    pub(super) columns: [usize; 4],
    /// The equation of the norm.
    norm: usize,
}

/// The quaternions of a block.
pub(super) fn turning_bodies(arena: &mut Arena, system: &System, block: &Block) -> Vec<TurningBody> {
    let place = |of: usize| block.iterated.iter().position(|unknown| *unknown == of);
    let first = |unknown: &&usize| system.coordinates.get(**unknown).is_some_and(|one| one.role == Role::Quaternion(0));
    let of_body = |first: &usize| {
        // The components of a quaternion are neighbours.
        let numbers = [0, 1, 2, 3].map(|k| first + k);
        let columns = numbers.map(place);
        let [Some(w), Some(x), Some(y), Some(z)] = columns else { return None };
        let gradient: Vec<(usize, Expr)> = numbers.map(|number| (number, twice(arena, number))).to_vec();
        let norm = block.residuals.iter().copied().find(|equation| system.equations[*equation].jacobian == gradient)?;
        Some(TurningBody { body: system.coordinates[*first].body, columns: [w, x, y, z], norm })
    };
    block.iterated.iter().filter(first).filter_map(of_body).collect()
}

/// 2 q
fn twice(arena: &mut Arena, number: usize) -> Expr {
    let leaf = arena.leaf(Leaf::Coordinate(number as u32));
    arena.twice(leaf)
}

/// Puts the columns of M in the place of those by quaternions, and notes the quaternions; `None` if a row cannot be written so.
///
/// * `found`: given, coordinates of earlier stages.
pub(super) fn put_columns(arena: &mut Arena, bodies: &[TurningBody], system: &mut Iteration, found: &BTreeSet<u32>) -> Option<()> {
    if bodies.is_empty() {
        return Some(());
    }
    let mut rows = system.jacobian.clone();
    let is_known = |number: &u32| found.contains(number) || system.unknowns.contains(&(*number as usize));
    for TurningBody { body, columns, norm } in bodies {
        let quaternion = columns.map(|column| Leaf::Coordinate(system.unknowns[column] as u32));
        let turns = Leaf::turns_of(*body);
        for ((row, equation), residual) in rows.iter_mut().zip(&system.equations).zip(&system.residuals) {
            if equation == norm {
                row[columns[0]] = arena.integer(1);
                continue;
            }
            if !occurs_in_vectors_only(arena, *residual, &quaternion, turns[0]) {
                return None;
            }
            for (column, turn) in columns[1..].iter().zip(turns) {
                let slope = derivative(arena, *residual, turn);
                row[*column] = coordinates_of(arena, slope).all(|number| is_known(&number)).then_some(slope)?;
            }
        }
    }
    system.jacobian = rows;
    system.quaternions = bodies.iter().map(|body| body.columns).collect();
    Some(())
}

/// True if a quaternion occurs nowhere but in vectors fixed in frames that turn with its body.
fn occurs_in_vectors_only(arena: &Arena, residual: Expr, quaternion: &[Leaf; 4], turn: Leaf) -> bool {
    let turns_with = |vector: u32| arena.frame(arena.vector(vector).0).turns.iter().any(|(leaf, _)| *leaf == turn);
    let is_vector = |expr: Expr| matches!(*arena.node(expr), Node::Marked { mark: Mark::Turned { vector, .. }, .. } if turns_with(vector));
    let is_one = |expr: &Expr| matches!(arena.node(*expr), Node::Leaf(leaf) if quaternion.contains(leaf));
    !arena.reachable_down_to(&[residual], |_| false, is_vector).iter().any(is_one)
}

fn coordinates_of(arena: &Arena, expr: Expr) -> impl Iterator<Item = u32> + use<> {
    let number = |leaf: Leaf| if let Leaf::Coordinate(number) = leaf { Some(number) } else { None };
    arena.leaves(expr).into_iter().filter_map(number)
}
