//! Causes of failure, as data.

use super::{Coordinate, ParameterOutOfRange, Row};

/// Where the branch of the declared start ends while parameters are changed from the declared defaults: beyond, its loops do not
/// close, or close only as the mirror image.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct BranchEnd<T> {
    /// λ on the line of parameters: 0 at the defaults, 1 at these parameters. [`Stages::interpolated`](crate::Stages::interpolated)
    /// returns the mechanism there.
    pub lambda: T,
    /// A row of the block that becomes singular there.
    pub row: Row,
    /// The coordinate of the block that its rows do not determine there.
    pub coordinate: Coordinate,
}

/// Cause of a failure.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum Cause<T> {
    /// No position was found that fulfils the equations: from the given start no step reduces the residuals any further.
    DoesNotClose {
        /// The row that stays open furthest.
        row: Row,
        /// Its residual, in its unit.
        residual: T,
        /// Its residual divided by the norm of its gradient, in m; for an angle, the arc at radius L.
        /// Where no coordinate changes the row: the residual as a length for rows in m, rad and m², otherwise infinite.
        gap: T,
    },
    /// An equation of a redundant joint does not follow from the others with these parameters: the mechanism would be strained.
    DoesNotHold {
        /// The row with the largest residual, relative to its bound for rounding errors.
        row: Row,
        /// Its residual, in its unit.
        residual: T,
    },
    /// Φ_q is singular, or nearly so: a dead point, where the branch ends; a change point without a smooth continuation, or one
    /// that [`solve_near`](crate::Mechanism::solve_near) found from a guess; or dependent equations. Between two states the
    /// failure's time is that of the singularity, to rounding.
    Singular {
        /// A row that depends on the others.
        row: Row,
        /// The coordinate that is determined least.
        coordinate: Coordinate,
        /// Condition at the last position reached.
        condition: T,
    },
    /// The motion would jump: the branch ends, and the next assembly is not close.
    BranchLost {
        /// The coordinate that jumps most.
        coordinate: Coordinate,
        /// The size of the jump, in m or rad.
        jump: T,
    },
    /// The motion diverges: a length grows beyond all bounds, approximately at the failure's time.
    Diverges {
        /// The coordinate that grows most.
        coordinate: Coordinate,
        /// Its last value, in m.
        value: T,
    },
    /// A number is infinite or NaN.
    NotFinite {
        /// Where it first appeared.
        of: Culprit,
    },
    /// A parameter has a value for which the mechanism is not defined.
    ParameterOutOfRange(ParameterOutOfRange<T>),
    /// The given state was solved with other inputs or other parameters than those of the mechanism.
    OtherInputs,
    /// The given state was solved with other parameters than those of the mechanism, or changed, and no solution with these is near.
    StateTooFar {
        /// The coordinate that would jump most.
        coordinate: Coordinate,
        /// The size of the jump, in m or rad.
        jump: T,
    },
    /// Newton's method did not converge.
    NoConvergence {
        /// Length of the last correction, scaled.
        correction: T,
        /// Number of corrections.
        iterations: usize,
    },
    /// The time is not reached within the steps of one call.
    TooManySteps {
        /// Number of steps made.
        steps: usize,
    },
}

/// Quantity that was not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum Culprit {
    /// The time asked for.
    Time,
    /// A coordinate, its correction or its rate.
    Coordinate(Coordinate),
    /// A row of Φ, Φ_q, ν or γ.
    Row(Row),
}
