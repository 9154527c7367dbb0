//! Redundant equations: they hold of themselves, or the mechanism does not fit.

use nalgebra::SVector;

use super::equations::Dynamics;
use super::stopped::Stopped;
use crate::names::{Description, Row};
use crate::number::Scalar;

/// The joint whose row is off most, and its residual; `None` if all rows hold.
///
/// A row holds if it is below √ε of the characteristic length, or of a radian: positions fulfil the rows that are solved to rounding, times
/// the condition of their elimination.
///
/// * `rows`: given, the joint of each row, its residual, and the power of a length with which it is judged.
pub fn misfit<T: Scalar, S: Description<T, N>, const N: usize>(
    mechanism: &S,
    rows: &[(&'static str, T, usize)],
) -> Option<(&'static str, T)> {
    let length = mechanism.characteristic_length();
    let mut worst = (T::ROOT_EPSILON, None);
    for (joint, residual, power) in rows {
        let size = (0..*power).fold(residual.abs(), |size, _| size / length);
        // A NaN does not hold, either.
        let holds = size <= worst.0;
        if !holds {
            worst = (size, Some((*joint, *residual)));
        }
    }
    worst.1
}

/// Whether the redundant equations hold at a place.
///
/// # Errors
/// The joint of the one that is off most.
pub(super) fn holds<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    q: &SVector<T, N>,
    time: T,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    match mechanism.misfit(q, time) {
        Some((joint, residual)) => Err(Stopped::DoesNotHold { time, joint, residual, unit: unit_of::<T, S, N>(joint) }),
        None => Ok(()),
    }
}

/// The unit of the rows of a joint; empty if they have several.
pub(super) fn unit_of<T: Scalar, S: Description<T, N>, const N: usize>(joint: &str) -> &'static str {
    unit_among(S::ROWS, joint)
}

fn unit_among(rows: &[Row], joint: &str) -> &'static str {
    let is_of_it = |row: &&Row| row.joint == joint;
    let first = rows.iter().find(is_of_it).map_or("", |row| row.unit);
    if rows.iter().filter(is_of_it).all(|row| row.unit == first) { first } else { "" }
}
