//! Rigorous error bounds: the mechanism is evaluated over [`Enclosure`]s around a state.
//!
//! In: a mechanism and a state. Out: balls that contain q, q̇ and q̈ of the solution next to the state, or the reason why none can
//! be proven. The emitted code is the same as in a step; only the solution of a block differs ([`block`]). Centres of balls have 32
//! digits, so that radii are far below a rounding, and the error of a state is known to about ten digits.

mod ball;
mod block;
mod functions;
mod moving;
mod system;
#[cfg(test)]
mod tests;
mod twofold;

use core::cell::Cell;
use core::fmt;

use nalgebra::SVector;

use crate::names::{self, Coordinate, CoordinateEntries, CoordinateKind, Culprit, Description, Row};
use crate::newton::{self, StepError};
use crate::number::{Float, Real, Scalar};
use crate::solve::{Family, Solver, Stages, lengths_of};
use crate::state::{State, Values};

use ball::Ball;
pub use moving::Enclosure;

/// Bounds of the errors of a state, by coordinate: a solution lies within all of them.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ErrorBound<T, const N: usize> {
    /// Of q, in m and rad.
    pub q: SVector<T, N>,
    /// Of q̇, in m/s and rad/s.
    pub qd: SVector<T, N>,
    /// Of q̈, in m/s² and rad/s².
    pub qdd: SVector<T, N>,
}

/// The proof that within a radius of a state there is exactly one solution.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Certificate<T, const N: usize> {
    /// The largest entry of `within.q`, with lengths divided by the characteristic length L.
    pub radius: T,
    /// Exactly one q with Φ(q, t) = 0 is within these bounds of the state's, and its q̇ and q̈ are within theirs.
    pub within: ErrorBound<T, N>,
}

/// Why nothing could be proven about a state. `{:?}` is the sentence, as `{}` is.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// The parameter of this name is out of range.
    ParameterOutOfRange(&'static str),
    /// The coordinate or one of its rates is not finite in the state.
    NotFinite(Coordinate),
    /// No solution was proven near this coordinate and the others of its block: the state does not belong to this mechanism at this
    /// time, or the Jacobian is singular there.
    NoSolution(Coordinate),
    /// There is a solution, but another one may be as close to the state, with a different value of this coordinate and the others
    /// of its block. [`error_bound`](crate::Mechanism::error_bound) is still available.
    Another(Coordinate),
    /// A row of a redundant joint does not hold.
    DoesNotHold(Row),
    /// This coordinate depends on a function that is known only by its values at doubles, or on a condition that is undecided
    /// within the error of the state. [`error_bound`](crate::Mechanism::error_bound) assumes that it is smooth.
    Unproven(Coordinate),
}

/// Encloses the solution next to a state, block by block.
pub struct EnclosureSolver<const N: usize> {
    /// The state's q.
    q: SVector<f64, N>,
    /// Whether to prove that no other solution is as close to the state.
    alone: bool,
    /// L and 1/L.
    lengths: (Enclosure, Enclosure),
    coordinates: &'static [Coordinate],
    /// Why a block could not be enclosed.
    doubt: Cell<Option<Doubt>>,
    /// The first verified equation that does not hold: its index in Φ.
    off: Cell<Option<usize>>,
}

/// What a state holds at one index: entries of q, q̇ and q̈.
type Entries = [Ball; 3];

/// The solution next to a state.
///
/// # Errors
/// Why it cannot be enclosed.
fn enclosed<T, E, const N: usize>(mechanism: &E, state: &State<T, N>, alone: bool) -> Result<SVector<Entries, N>, Doubt>
where
    T: Float,
    E: Family<T> + Description<T, N>,
    E::Over<Enclosure>: Stages<Enclosure, N>,
{
    mechanism.validate().map_err(|parameter| Doubt::ParameterOutOfRange(parameter.name))?;
    // Rates are those of values: the values of inputs move.
    let enclosed = E::gather([mechanism], |[parameter]| Enclosure::of(parameter.to_f64())).later(Enclosure::time(0.0));
    let (q, lengths, coordinates) = (state.q.map(Scalar::to_f64), lengths_of(enclosed.characteristic_length()), E::COORDINATES);
    let solver = EnclosureSolver { q, alone, lengths, coordinates, doubt: Cell::new(None), off: Cell::new(None) };
    let coordinate = |index: usize| names::coordinate(E::COORDINATES, index);
    let found = enclosed.stages(Enclosure::time(state.t.to_f64()), &mut Solver::cold(&solver)).map_err(|error| {
        let of = |culprit| if let StepError::NotFinite(Culprit::Coordinate(of)) = culprit { of } else { coordinate(0) };
        solver.doubt.get().unwrap_or(Doubt::NoSolution(of(error)))
    })?;
    if let Some(row) = solver.off.get() {
        return Err(Doubt::DoesNotHold(names::row(E::ROWS, row)));
    }
    let entries = SVector::<Entries, N>::from_fn(|index, _| {
        let (q, qd, qdd) = (found.q[index], found.qd[index], found.qdd[index]);
        match names::entries(E::COORDINATES, index) {
            CoordinateEntries::Motion => [q.value, q.rate, q.acceleration],
            // Velocities and third derivatives are no rates of q.
            CoordinateEntries::Velocity | CoordinateEntries::Jerk => [q.value, qd.value, qdd.value],
        }
    });
    match entries.iter().position(|of| !of.iter().all(|ball| ball.magnitude().is_finite())) {
        Some(index) => Err(Doubt::NoSolution(coordinate(index))),
        None => Ok(entries),
    }
}

/// Bounds of the distance of a state from the enclosed solution.
///
/// # Errors
/// If the state is not finite.
fn distance<T: Float, E: Description<T, N>, const N: usize>(
    _: &E,
    state: &State<T, N>,
    found: &SVector<Entries, N>,
) -> Result<ErrorBound<T, N>, Doubt> {
    let is_bad = |index: &usize| [&state.q, &state.qd, &state.qdd].iter().any(|entries| !entries[*index].is_finite());
    if let Some(index) = (0..N).find(is_bad) {
        return Err(Doubt::NotFinite(names::coordinate(E::COORDINATES, index)));
    }
    let of = |state: &SVector<T, N>, level: usize| {
        SVector::from_fn(|i, _| above((Ball::exact(state[i].to_f64()) - found[i][level]).magnitude()))
    };
    Ok(ErrorBound { q: of(&state.q, 0), qd: of(&state.qd, 1), qdd: of(&state.qdd, 2) })
}

/// An upper bound in `T`.
fn above<T: Float>(bound: f64) -> T {
    T::of(bound) * (T::of(1.0) + T::of(2.0) * T::EPSILON) + T::of(f64::from(f32::MIN_POSITIVE))
}

/// [`Mechanism::error_bound`](crate::Mechanism::error_bound)
pub(crate) fn error_bound<T, E, const N: usize>(mechanism: &E, state: &State<T, N>) -> Result<ErrorBound<T, N>, Doubt>
where
    T: Float,
    E: Family<T> + Description<T, N>,
    E::Over<Enclosure>: Stages<Enclosure, N>,
{
    distance(mechanism, state, &enclosed(mechanism, state, false)?)
}

/// [`Mechanism::certify`](crate::Mechanism::certify)
pub(crate) fn certify<T, E, const N: usize>(mechanism: &E, state: &State<T, N>) -> Result<Certificate<T, N>, Doubt>
where
    T: Float,
    E: Family<T> + Description<T, N>,
    E::Over<Enclosure>: Stages<Enclosure, N>,
{
    let found = enclosed(mechanism, state, true)?;
    if let Some(index) = found.iter().position(|of| !of.iter().all(|ball| ball.is_proven)) {
        return Err(Doubt::Unproven(names::coordinate(E::COORDINATES, index)));
    }
    let within = distance(mechanism, state, &found)?;
    let length = newton::length_of(mechanism.characteristic_length());
    let radius = (0..N).fold(T::of(0.0), |radius, i| {
        let share = match names::coordinate(E::COORDINATES, i).kind {
            CoordinateKind::Length => above((within.q[i] / length).to_f64()),
            CoordinateKind::Angle | CoordinateKind::Number => within.q[i],
        };
        if share > radius { share } else { radius }
    });
    Ok(Certificate { radius, within })
}

/// [`Mechanism::polish`](crate::Mechanism::polish)
pub(crate) fn polish<T, E, const N: usize>(mechanism: &E, state: &mut State<T, N>) -> Result<(), Doubt>
where
    T: Float,
    E: Family<T> + Description<T, N>,
    E::Over<Enclosure>: Stages<Enclosure, N>,
{
    let found = enclosed(mechanism, state, true)?;
    // An entry that cannot be distinguished from the solution is kept.
    let State { values: Values { q, qd, qdd, .. }, .. } = state;
    for (level, entries) in [q, qd, qdd].into_iter().enumerate() {
        for (entry, of) in entries.iter_mut().zip(found.iter()) {
            let is_as_good = (Ball::exact(entry.to_f64()) - of[level]).least() <= 0.0;
            if !is_as_good {
                *entry = T::of(of[level].center.high);
            }
        }
    }
    Ok(())
}

impl fmt::Debug for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ParameterOutOfRange(name) => write!(f, "parameter `{name}` is out of range"),
            Self::NotFinite(of) => write!(f, "{of} is not a finite number"),
            Self::NoSolution(of) => {
                write!(
                    f,
                    "no solution could be proven near {of}: there is none, Φ_q is singular there, or a periodic function begins anew there"
                )
            }
            Self::Another(of) => write!(f, "there may be two solutions near {of}"),
            Self::DoesNotHold(row) => write!(f, "{row} does not hold"),
            Self::Unproven(of) => {
                write!(f, "{of} depends on a function that is known by its values only, or on a condition that may be true or not")
            }
        }
    }
}

impl core::error::Error for Doubt {}
