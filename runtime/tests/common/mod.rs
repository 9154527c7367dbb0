//! Hand-written mechanisms with known properties.

#![allow(dead_code, unreachable_pub, reason = "each test file uses its part")]

pub mod four_bar;
pub mod jet;
pub mod planar;
#[rustfmt::skip]
#[allow(clippy::approx_constant, reason = "they are results")]
pub mod reference;

/// Largest difference of two vectors as a share of the largest entry of the second (of 1 where all are zero).
pub fn error(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let difference = found.iter().zip(expected).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    let size = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if size == 0.0 { difference } else { difference / size }
}
