//! The search for the configuration nearest to what is declared of the start.

use super::position::{HOLDS, PositionRows, product, shortest};
use super::start::{DeclaredStart, SWAYS, WIDE};

/// A step towards the declared places turns no body by more than this, in rad.
const LONGEST: f64 = 0.5;

/// Cost of changing a coordinate, against that of leaving a declared place.
const EFFORT: f64 = 1e-2;

/// Number of configurations of which the nearest is taken, if it is near.
const TRIES: usize = 5;

/// A configuration is near within this part of the farthest declared place, or within this angle in rad.
const NEAR: f64 = 1.0 / 3.0;

/// Steps to the configuration that is nearest to the declared places.
const APPROACHES: usize = 60;

/// A configuration that satisfies the equations, as near to the declared places as any that is found. The values of some unknowns are held.
pub(super) fn nearest(rows: &mut PositionRows, declared: &DeclaredStart, held: &[usize]) -> Option<Vec<f64>> {
    let mut best: Option<(f64, Vec<f64>)> = None;
    for attempt in 0..=SWAYS.len() + WIDE {
        let mut guess = declared.swayed(attempt);
        held.iter().for_each(|unknown| guess[*unknown] = declared.values[*unknown]);
        let guess = approach(rows, declared, guess, held);
        if let Some(found) = rows.closed_near(&guess, held) {
            let distance = declared.distance(&found);
            if best.as_ref().is_none_or(|(least, _)| distance < *least) {
                best = Some((distance, found));
            }
        }
        match &best {
            // What closes nowhere near does not close.
            None if attempt == SWAYS.len() => return None,
            Some((least, _)) if *least <= declared.exact() || attempt >= TRIES && *least <= NEAR => break,
            _ => {}
        }
    }
    best.map(|(_, found)| found)
}

/// Steps that bring declared places nearer, along the linearized equations: (q + Δ − d)ᵀ P (q + Δ − d) + Δᵀ E Δ is least, Φ + Φ_q Δ = 0.
fn approach(rows: &mut PositionRows, declared: &DeclaredStart, mut q: Vec<f64>, held: &[usize]) -> Vec<f64> {
    let weights: Vec<f64> = (0..q.len()).map(|unknown| declared.unit(unknown).powi(-2)).collect();
    let pull = |unknown: usize| if declared.are_declared[unknown] { weights[unknown] } else { 0.0 };
    // In units in which P + E is the identity.
    let units: Vec<f64> = (0..q.len()).map(|unknown| (pull(unknown) + EFFORT * weights[unknown]).sqrt()).collect();
    for _ in 0..APPROACHES {
        let (phi, mut jacobian) = rows.at(&q);
        jacobian.iter_mut().for_each(|row| held.iter().for_each(|unknown| row[*unknown] = 0.0));
        let wish: Vec<f64> = (0..q.len()).map(|unknown| pull(unknown) * (declared.values[unknown] - q[unknown]) / units[unknown]).collect();
        let scaled: Vec<Vec<f64>> = jacobian.iter().map(|row| row.iter().zip(&units).map(|(entry, unit)| entry / unit).collect()).collect();
        let left: Vec<f64> = phi.iter().zip(&scaled).map(|(phi, row)| phi + product(row, &wish)).collect();
        let Some(back) = shortest(&left, &scaled) else { return q };
        let step: Vec<f64> = (0..q.len()).map(|unknown| (wish[unknown] - back[unknown]) / units[unknown]).collect();
        let turn = (0..q.len()).filter(|unknown| declared.are_turns[*unknown]).map(|unknown| step[unknown].abs()).fold(0.0, f64::max);
        let share = if turn > LONGEST { LONGEST / turn } else { 1.0 };
        q.iter_mut().zip(&step).for_each(|(value, step)| *value += share * step);
        if step.iter().zip(&units).all(|(step, unit)| (step * unit).abs() <= HOLDS) {
            break;
        }
    }
    q
}
