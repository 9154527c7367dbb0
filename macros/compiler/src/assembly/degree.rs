//! Whether the signs of all assemblies of a block sum up to zero.
//!
//! In: a block. Out: whether as many regular assemblies have a positive determinant as have a negative one: where there are not, one is
//! missing. Not done here: looking for it.
//!
//! It is so where the residuals, as a map of the iterated unknowns into a space of the same dimension, have degree zero (Milnor 1965,
//! Topology from the Differentiable Viewpoint, §5). Of angles that do not count turns alone they are a map of a torus. Of places they
//! are one for which the degree is defined where bars and pins keep the places near what is known as long as the residuals are bounded;
//! and there are values that it does not attain, as the residual of a bar, |h|² − c², is never below −c².

use super::links::{self, BodyPoint, Link};
use crate::numeric::Numeric;
use crate::structure::Block;
use std::collections::BTreeSet;

/// A pivot, relative to the largest, above which a determinant has a sign.
const SIGNED: f64 = 1e-6;

impl Numeric<'_> {
    /// Whether the signs of all assemblies of a block sum up to zero, as far as it can be told.
    ///
    /// * `counts`: of each iterated unknown, whether it counts turns.
    pub(super) fn has_degree_zero(&self, block: &Block, counts: &[bool], start: &[f64]) -> bool {
        let (angles, places): (Vec<usize>, Vec<usize>) = (0..counts.len()).partition(|index| self.is_angle(block.iterated[*index]));
        if angles.iter().any(|index| counts[*index]) {
            return false;
        }
        if places.is_empty() {
            return true;
        }
        let (unknowns, equations) = block.parts();
        let links = links::read(self, &equations, start);
        let body = |unknown: &usize| self.system.coordinates[*unknown].body;
        let moving: BTreeSet<usize> = unknowns.iter().filter(|unknown| self.is_position(**unknown)).map(body).collect();
        // What does not move in this block is ground to it.
        let moves = |place: &BodyPoint| place.body.filter(|body| moving.contains(body));
        let mut held: BTreeSet<Option<usize>> = BTreeSet::from([None]);
        for _ in &moving {
            for link in &links {
                let (Link::Pin(one, other) | Link::Rod(one, other, _)) = link else { continue };
                if held.contains(&moves(one)) || held.contains(&moves(other)) {
                    held.extend([moves(one), moves(other)]);
                }
            }
        }
        let has_bar = links.iter().any(|link| matches!(link, Link::Rod(..)));
        (has_bar || !angles.is_empty()) && places.iter().all(|index| held.contains(&Some(body(&block.iterated[*index]))))
    }
}

/// The sign of a determinant; 0 where it has none to be sure of.
pub(super) fn side(mut a: Vec<Vec<f64>>) -> i32 {
    let n = a.len();
    let mut sign = 1;
    for k in 0..n {
        let largest = a[k..].iter().flat_map(|row| &row[k..]).fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
        let Some(pivot) = (k..n).max_by(|one, two| a[*one][k].abs().total_cmp(&a[*two][k].abs())) else { return 0 };
        if a[pivot][k].abs() <= SIGNED * largest {
            return 0;
        }
        if pivot != k {
            a.swap(k, pivot);
            sign = -sign;
        }
        if a[k][k] < 0.0 {
            sign = -sign;
        }
        let (done, rest) = a.split_at_mut(k + 1);
        for row in rest {
            let multiplier = row[k] / done[k][k];
            row[k..].iter_mut().zip(&done[k][k..]).for_each(|(entry, above)| *entry -= multiplier * above);
        }
    }
    sign
}
