//! Rows of parallel axes, by the axes of one of their bodies.
//!
//! ```text
//! x₁ · z₂ = 0,  y₁ · z₂ = 0      z₂ = s z₁, s = ±1
//! x₁ × z₂ = −s y₁                by the turns of the first body; the opposite by those of the second
//! y₁ × z₂ =  s x₁
//! ```
//!
//! Where the triads agree by the choice of the unknowns, the columns of Φ_uᵀ are axes instead of products of axes.

use super::Equation;
use crate::expr::Arena;
use crate::model::{Model, Relationship, Triad};
use crate::quantity::{Ambient, SpeedRole};
use std::collections::BTreeMap;

/// Writes the entries of rows of parallel axes by the axes of the first body.
///
/// * `aligned`: the triads of each angle of a joint that keeps its axes in one direction, with equal z axes.
pub(super) fn by_axes_of_one_body(model: &Model, arena: &mut Arena, aligned: &BTreeMap<u32, [Triad; 2]>, equations: &mut [Equation]) {
    for (joint, row, relation) in &model.space.relations {
        let Relationship::SameDirection(one, two) = *relation else { continue };
        let opposed = two.half_turned(arena, 0);
        let is_of_it = |triads: &&[Triad; 2]| triads[0] == one && [two, opposed].contains(&triads[1]);
        let Some(is_opposed) = aligned.values().find(is_of_it).map(|triads| triads[1] == opposed) else { continue };
        let [x, y, _] = one.in_ground(arena);
        for (offset, axis, is_negative) in [(0, y, !is_opposed), (1, x, is_opposed)] {
            let Some(equation) = equations.iter_mut().find(|equation| (equation.joint, equation.row) == (*joint, row + offset)) else {
                continue;
            };
            for (body, is_negative) in [(one.body, is_negative), (two.body, !is_negative)] {
                let Some(body) = body else { continue };
                let axis = if is_negative { axis.map(|part| arena.neg(part)) } else { axis };
                equation.jacobian.retain(|(speed, _)| Ambient::Space.body_of(*speed) != body);
                let entries = SpeedRole::angular(body).into_iter().zip(axis);
                let zero = arena.integer(0);
                equation.jacobian.extend(entries.filter(|(_, entry)| *entry != zero));
                equation.jacobian.sort_by_key(|(speed, _)| *speed);
            }
        }
    }
}
