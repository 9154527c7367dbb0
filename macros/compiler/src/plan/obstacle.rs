//! Outputs with jerk depend on nothing that has only two derivatives: inputs, tables and Rust functions.
//!
//! In: the equations on which an output depends. Out: a refusal that names the joint or drive. Not done here: differentiating.

use crate::diag::{Diag, JerkObstacle, MotionFact};
use crate::expr::{Arena, Expr, Leaf, Node};
use crate::model::{Model, Said};
use crate::structure::{Block, Structure};
use crate::system::{System, coordinates_in};
use std::collections::BTreeSet;

/// Refuses outputs with jerk that depend on what has only two derivatives.
pub(super) fn jerks_are_known(model: &Model, system: &System, structure: &Structure, diag: &mut Diag) -> Option<()> {
    let mut said = Said::default();
    for (output, motion) in model.outputs.iter().zip(&system.outputs).filter(|(output, _)| output.derivatives == 3) {
        let values: Vec<Expr> = motion.components.iter().map(|[value, _, _]| *value).collect();
        let obstacle = if has_two_derivatives(&system.arena, &values) {
            Some(JerkObstacle::TwoDerivatives { joint: None })
        } else {
            let joint = upstream(system, structure, &values).into_iter().find(|equation| {
                let phi = system.equations[*equation].phi();
                has_two_derivatives(&system.arena, phi.as_slice())
            });
            joint
                .map(|equation| system.equations[equation].joint)
                .map(|joint| JerkObstacle::TwoDerivatives { joint: Some(model.joints[joint].name.to_string()) })
        };
        if let Some(obstacle) = obstacle
            && said.is_new(&output.name)
        {
            diag.refuse::<()>(&output.name, MotionFact::NoJerk { output: output.name.to_string(), obstacle });
        }
    }
    diag.is_clean().then_some(())
}

/// The equations on which some values depend.
fn upstream(system: &System, structure: &Structure, values: &[Expr]) -> BTreeSet<usize> {
    let mut needed: BTreeSet<usize> = values.iter().flat_map(|value| coordinates_in(&system.arena, *value)).collect();
    let mut found = BTreeSet::new();
    for Block { explicit, iterated, residuals } in structure.blocks.iter().rev() {
        let is_needed = iterated.iter().chain(explicit.iter().map(|explicit| &explicit.unknown)).any(|unknown| needed.contains(unknown));
        // The unknowns of a block that is iterated depend on each other.
        let is_whole = !iterated.is_empty() && is_needed;
        let mut take = |equation: usize, needed: &mut BTreeSet<usize>| {
            found.insert(equation);
            needed.extend(system.equations[equation].phi().into_iter().flat_map(|phi| coordinates_in(&system.arena, phi)));
        };
        for explicit in explicit.iter().rev() {
            if is_whole || needed.contains(&explicit.unknown) {
                take(explicit.equation, &mut needed);
            }
        }
        for equation in residuals.iter().filter(|_| is_whole) {
            take(*equation, &mut needed);
        }
    }
    found
}

/// True if some expressions contain inputs, tables or Rust functions.
fn has_two_derivatives(arena: &Arena, roots: &[Expr]) -> bool {
    arena.reachable(roots).iter().any(|expr| matches!(arena.node(*expr), Node::Call { .. } | Node::Leaf(Leaf::Input { .. })))
}
