//! Assemblies connected to others by curves.
//!
//! In: a block and an assembly of it. Out: the assemblies on the curve through it on which all residuals but one vanish:
//!
//! ```text
//! v = R⁻¹ e_i         tangent: R_j v = 0 for every other residual j
//! δ = R_v⁻¹ (−g)      correction: R_v is R with vᵀ in place of row i, and g_i is 0
//! ```
//!
//! If the residuals bound the unknowns, the curve is closed, and the residual left out vanishes on it at least once more: curves find
//! assemblies that few guesses reach. Not done here: choosing the assemblies to start from.
//!
//! Reference: Allgower and Georg (1990), Numerical Continuation Methods, chapters 2 and 6.

use super::reduced::{LinearizedBlock, Reduced};
use crate::linear::dense::solve;

/// First, longest and shortest step along a curve, in rad and characteristic lengths.
const STEP: f64 = 0.15;
const LONGEST: f64 = 0.4;
const SHORTEST: f64 = 1e-3;

/// Largest number of corrections of a step.
const CORRECTIONS: usize = 3;

/// A correction shorter than this fraction of the step is the last.
const CORRECTED: f64 = 1e-2;

/// A first correction longer than this fraction of the step leads to another curve.
const ASTRAY: f64 = 0.4;

/// Smallest cosine of the angle between tangents at consecutive points, and the cosine above which the step may grow.
const TURNED: [f64; 2] = [0.85, 0.97];

/// Largest number of bisections of a step to find two zeros of the residual in it.
const HALVED: usize = 8;

/// A point on a curve.
struct CurvePoint {
    x: Vec<f64>,
    linear: LinearizedBlock,
    /// Unit tangent of the curve.
    along: Vec<f64>,
}

impl CurvePoint {
    /// The residual left out, and its derivative along the curve.
    fn residual(&self, left_out: usize) -> [f64; 2] {
        [self.linear.g[left_out], dot(&self.linear.r[left_out], &self.along)]
    }
}

/// A curve on which all residuals but one vanish.
pub(super) struct Curve<'a, 'b> {
    pub(super) reduced: &'a mut Reduced<'b>,
    pub(super) left_out: usize,
}

impl Curve<'_, '_> {
    /// Assemblies on the curve through one, until the curve returns to it, fails or no steps are left.
    pub(super) fn follow(&mut self, from: &[f64], is_back: &dyn Fn(&[f64]) -> bool, steps: &mut usize) -> Vec<Vec<f64>> {
        let mut met = Vec::new();
        let Some(mut here) = self.begin(from) else { return met };
        let (mut step, mut is_first) = (STEP, true);
        while *steps > 0 && step >= SHORTEST {
            *steps -= 1;
            let Some(there) = self.next(&here, step) else {
                step *= 0.5;
                continue;
            };
            for mut x in self.crossings(&here, &there, step, is_first, HALVED) {
                if self.reduced.close(&mut x) {
                    if is_back(&x) {
                        return met;
                    }
                    met.push(x);
                }
            }
            is_first = false;
            if dot(&here.along, &there.along) > TURNED[1] {
                step = (step * 1.5).min(LONGEST);
            }
            here = there;
        }
        met
    }

    /// First point of the curve: an assembly and the tangent there.
    fn begin(&mut self, from: &[f64]) -> Option<CurvePoint> {
        let linear = self.reduced.linearize(from)?;
        let along = unit(solve(linear.r.clone(), &self.only(1.0))?)?;
        Some(CurvePoint { x: from.to_vec(), linear, along })
    }

    /// Next point, one predictor-corrector step further; `None` if the step fails or the curve turns too much.
    fn next(&mut self, here: &CurvePoint, step: f64) -> Option<CurvePoint> {
        let way: Vec<f64> = here.along.iter().map(|along| along * step).collect();
        let mut x = self.reduced.moved(&here.x, &here.linear, &way);
        for correction in 0..=CORRECTIONS {
            let linear = self.reduced.linearize(&x)?;
            let mut matrix = linear.r.clone();
            matrix[self.left_out].clone_from(&here.along);
            let mut right: Vec<f64> = linear.g.iter().map(|g| -g).collect();
            right[self.left_out] = 0.0;
            let change = solve(matrix.clone(), &right)?;
            let length = dot(&change, &change).sqrt();
            if length <= CORRECTED * step {
                let along = unit(solve(matrix, &self.only(1.0))?)?;
                return (dot(&along, &here.along) >= TURNED[0]).then_some(CurvePoint { x, linear, along });
            }
            if length > ASTRAY * step * 0.5_f64.powi(correction as i32) {
                return None;
            }
            x = self.reduced.moved(&x, &linear, &change);
        }
        None
    }

    /// Approximate zeros of the residual left out between two points.
    fn crossings(&mut self, here: &CurvePoint, there: &CurvePoint, step: f64, is_first: bool, halvings: usize) -> Vec<Vec<f64>> {
        let ([a, da], [b, db]) = (here.residual(self.left_out), there.residual(self.left_out));
        // The residual vanishes at the assembly where the curve starts.
        if is_first && a.abs() < da.abs() * 1e-6 {
            return if da * b < 0.0 { vec![there.x.clone()] } else { Vec::new() };
        }
        if a * b <= 0.0 {
            let share = if a == b { 0.5 } else { a / (a - b) };
            let way: Vec<f64> = here.along.iter().map(|along| along * step * share).collect();
            return vec![self.reduced.moved(&here.x, &here.linear, &way)];
        }
        // The residual may have two zeros within the step.
        let comes_near = a * da < 0.0 && b * db > 0.0 && a.abs().min(b.abs()) < step * da.abs().max(db.abs());
        if !comes_near || halvings == 0 {
            return Vec::new();
        }
        let Some(middle) = self.next(here, 0.5 * step) else { return Vec::new() };
        let mut found = self.crossings(here, &middle, 0.5 * step, false, halvings - 1);
        found.extend(self.crossings(&middle, there, 0.5 * step, false, halvings - 1));
        found
    }

    fn only(&self, value: f64) -> Vec<f64> {
        (0..self.reduced.iterated).map(|index| if index == self.left_out { value } else { 0.0 }).collect()
    }
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

/// Normalises a vector to length 1; `None` if it is zero or not finite.
fn unit(vector: Vec<f64>) -> Option<Vec<f64>> {
    let length = dot(&vector, &vector).sqrt();
    (length > 0.0 && length.is_finite()).then(|| vector.into_iter().map(|entry| entry / length).collect())
}
