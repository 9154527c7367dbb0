//! Why there is no state, as data.

use super::{Coordinate, ParameterOutOfRange, Row};

/// Where the branch of the declared start ends while parameters are changed from their declared defaults: beyond, it does not close,
/// and would have to go on as its mirror image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BranchEnd<T> {
    /// The share of the way, 0 at the defaults and 1 at these parameters; [`Stages::interpolated`](crate::Stages::interpolated) gives the
    /// mechanism there, with the parameters that it has.
    pub lambda: T,
    /// A row of the block that becomes singular there.
    pub row: Row,
    /// The coordinate of the block that its rows do not determine there.
    pub coordinate: Coordinate,
}

/// What happened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause<T> {
    /// No position was found that fulfils the equations: from the given start, every way nearer ends.
    DoesNotClose {
        /// The row that stays open furthest.
        row: Row,
        /// Its residual, in its unit.
        residual: T,
        /// Its residual divided by the length of its gradient, in m; of an angle, the arc at L.
        gap: T,
    },
    /// An equation of a redundant joint does not follow from the others, with these parameters: it would bend something.
    DoesNotHold {
        /// The row that is off most, for the rounding errors that it may have.
        row: Row,
        /// Its residual, in its unit.
        residual: T,
    },
    /// Φ_q is singular, or as good as: a dead point, where the branch ends; a change point from which no branch goes on smoothly, or
    /// to which [`solve_near`](crate::Mechanism::solve_near) came from a guess; or equations that depend on each other. On the way from
    /// one state to another the failure's time is the one at which it happens, to rounding.
    Singular {
        /// A row that depends on the others.
        row: Row,
        /// The coordinate that they leave most undetermined.
        coordinate: Coordinate,
        /// Condition at the last position reached.
        condition: T,
    },
    /// The motion jumps: the branch ends, and the next assembly is not near.
    BranchLost {
        /// The coordinate that jumps most.
        coordinate: Coordinate,
        /// By how much, in m or rad.
        jump: T,
    },
    /// The motion diverges: a length grows beyond all bounds, about at the failure's time.
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
    /// A parameter has a value for which the mechanism has no meaning.
    ParameterOutOfRange(ParameterOutOfRange<T>),
    /// Newton's method went on without settling.
    NoConvergence {
        /// Length of the last correction, scaled.
        correction: T,
        /// Number of corrections.
        iterations: usize,
    },
    /// The way there takes more steps than one call makes.
    TooManySteps {
        /// Number of steps made.
        steps: usize,
    },
}

/// What was not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Culprit {
    /// The time asked for.
    Time,
    /// A coordinate, its correction or its rate.
    Coordinate(Coordinate),
    /// A row of Φ, Φ_q, ν or γ.
    Row(Row),
}
