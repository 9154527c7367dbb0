//! The linear analysis of tolerances.

use reuleaux::Mechanism;

use crate::{Linkage, LinkageFailure, LinkageState, POSITIONS, Study, positions};

/// Of a tip in one position.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// The derivatives of x and y by the six lengths.
    pub slopes: [[f64; 6]; 2],
    /// Standard deviations of x and y in m.
    pub deviations: [f64; 2],
}

/// The standard deviations that follow from the derivatives of the nominal tip, in each position:
///
/// ```text
/// σ_x² = Σ (∂x/∂p_k)² σ²
/// ```
///
/// Exact if the tip were a linear function of the lengths.
///
/// # Errors
/// If the nominal linkage cannot be turned.
pub fn linear(study: &Study) -> Result<[Spread; POSITIONS], Box<LinkageFailure>> {
    let nominal = Linkage::default();
    let mut spreads = [Spread { slopes: [[0.0; 6]; 2], deviations: [0.0; 2] }; POSITIONS];
    for (spread, state) in spreads.iter_mut().zip(nominal.sweep(positions())) {
        let state = state?;
        let (varied, state) = nominal.derivatives(&state, |linkage| {
            let Linkage { ground_length, crank_length, coupler_length, rocker_length, along, across } = linkage;
            [ground_length, crank_length, coupler_length, rocker_length, along, across]
        })?;
        let tip = varied.tip(&LinkageState(state)).value;
        let slopes = [tip.x.by, tip.y.by];
        let deviations = slopes.map(|slopes| slopes.map(|slope| slope * slope).iter().sum::<f64>().sqrt() * study.deviation);
        *spread = Spread { slopes, deviations };
    }
    Ok(spreads)
}
