//! Why a motion stops.

use core::fmt::{self, Display, Formatter};

use crate::names::{Measure, ParameterOutOfRange};
use crate::number::Scalar;

/// Why there is no initial state, or why a motion stops. `{:?}` is the sentence, as `{}` is.
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum Stopped<T> {
    /// Joints, drives and the initial values of the freedoms cannot hold together.
    NotAssembled {
        /// The joint or freedom that stays open furthest.
        joint: &'static str,
        /// Its residual.
        residual: T,
        /// The unit of the residual, `"m"`, `"rad"` or `"m²"` for example; empty if the joint has rows of several units.
        unit: &'static str,
    },
    /// On the way from the declared parameters to these, the assembly of the declared start ends, and no other one with the same sign of det J
    /// was found.
    AssemblyEnds {
        /// Share of the way, between 0 and 1.
        share: T,
        /// A joint whose equations depend there on those of other joints.
        joint: &'static str,
    },
    /// A redundant joint does not fit: with all other joints closed it stays open.
    DoesNotHold {
        /// Time in s.
        time: T,
        /// The joint.
        joint: &'static str,
        /// Its residual.
        residual: T,
        /// The unit of the residual, `"m"`, `"rad"` or `"m²"` for example; empty if the joint has rows of several units.
        unit: &'static str,
    },
    /// A state was changed, or parameters were, and its equations hold nowhere near it.
    StaysOpen {
        /// Time in s.
        time: T,
        /// The joint or freedom that stays open furthest.
        joint: &'static str,
        /// Its residual.
        residual: T,
        /// The unit of the residual, `"m"`, `"rad"` or `"m²"` for example; empty if the joint has rows of several units.
        unit: &'static str,
    },
    /// An equation depends on the others: the mechanism can go on in several ways, or its joints lock.
    Singular {
        /// Time in s.
        time: T,
        /// Its joint.
        joint: &'static str,
    },
    /// No mass or inertia resists a motion that joints and drives allow.
    Massless {
        /// Time in s.
        time: T,
        /// Body or joint of a coordinate that is free to move.
        owner: &'static str,
        /// The coordinate.
        coordinate: &'static str,
    },
    /// The speed of a coordinate jumps, and with it the momentum of a freedom: an infinite force acts.
    SpeedJumps {
        /// Time in s.
        time: T,
        /// Body or joint of the coordinate whose speed jumps most.
        owner: &'static str,
        /// The coordinate.
        coordinate: &'static str,
    },
    /// A number is infinite or NaN.
    NotFinite {
        /// Time in s.
        time: T,
    },
    /// No step is short enough for the tolerance.
    StepTooShort {
        /// Time in s.
        time: T,
    },
    /// The time is not reached within the steps of one call.
    TooManySteps {
        /// Time in s.
        time: T,
    },
    /// The tolerance of the integrator is not above zero or not finite, its longest step is not above zero, or its next step or its largest speed
    /// is not finite.
    BadIntegrator {
        /// `tolerance`, `longest`, `step` or `fastest`.
        field: &'static str,
        /// Its value.
        value: T,
    },
    /// A parameter has a value for which the mechanism is not defined.
    ParameterOutOfRange(ParameterOutOfRange<T>),
}

impl<T: Scalar + Display> Display for Stopped<T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Stopped::NotAssembled { joint, residual, unit } => {
                let open = Measure(residual.to_f64().abs(), unit);
                write!(f, "there is no initial state: `{joint}` stays open by {open}; start nearer to it, or change the initial values")
            }
            Stopped::AssemblyEnds { share, joint } => {
                write!(
                    f,
                    "there is no initial state: on the way from the declared parameters to these the assembly of the declared start ends, at {:.4} % \
                     of it, where the equations of `{joint}` depend on those of other joints; choose parameters nearer to the declared ones, or \
                     declare a start nearer to these",
                    100.0 * share.to_f64()
                )
            }
            Stopped::DoesNotHold { time, joint, residual, unit } => {
                let off = Measure(residual.to_f64().abs(), unit);
                write!(f, "at t = {time} s the redundant joint `{joint}` does not fit: it is off by {off}")
            }
            Stopped::StaysOpen { time, joint, residual, unit } => {
                let open = Measure(residual.to_f64().abs(), unit);
                write!(
                    f,
                    "at t = {time} s the changed state cannot be closed: `{joint}` stays open by {open}; change positions or parameters less"
                )
            }
            Stopped::Singular { time, joint } => {
                write!(
                    f,
                    "at t = {time} s the equations of `{joint}` depend on those of other joints: the joints lock, or the motion can go on in several ways"
                )
            }
            // Components of quaternions.
            Stopped::Massless { time, owner, coordinate: "e0" | "e1" | "e2" | "e3" } => {
                write!(f, "at t = {time} s no mass or inertia resists a turning of `{owner}`; give a body that turns with it an inertia")
            }
            Stopped::Massless { time, owner, coordinate } => {
                write!(
                    f,
                    "at t = {time} s no mass or inertia resists the motion of `{owner}.{coordinate}`; give a body that moves with it a mass"
                )
            }
            Stopped::SpeedJumps { time, owner, coordinate } => {
                write!(f, "at t = {time} s the ")?;
                match *coordinate {
                    // Beside the components of the angular velocity.
                    "a11" | "a12" | "a13" => write!(f, "angular velocity of `{owner}` jumps")?,
                    _ => write!(f, "speed of `{owner}.{coordinate}` jumps")?,
                }
                write!(
                    f,
                    ", which takes an infinite force; use a law or an equation without a kink, such as `cycloidal` instead of `linear`"
                )
            }
            Stopped::NotFinite { time } => write!(f, "at t = {time} s a number is infinite or not a number"),
            Stopped::StepTooShort { time } => {
                write!(
                    f,
                    "at t = {time} s no step is short enough for the tolerance: the motion is not smooth there, or the tolerance below rounding errors"
                )
            }
            Stopped::BadIntegrator { field, value } => {
                let wanted = if ["tolerance", "longest"].contains(field) { "positive" } else { "finite" };
                write!(f, "the integrator's `{field}` is {value}: it has to be a {wanted} number")
            }
            Stopped::TooManySteps { time } => {
                write!(f, "the steps of one call end at t = {time} s: with a larger `most` the integrator makes more of them")
            }
            Stopped::ParameterOutOfRange(ParameterOutOfRange { name, value, unit, why }) => {
                let space = if unit.is_empty() { "" } else { " " };
                write!(f, "the parameter `{name}` is {value}{space}{unit}: {why}")
            }
        }
    }
}

impl<T: Scalar + Display> fmt::Debug for Stopped<T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(self, f)
    }
}

impl<T: Scalar + Display> core::error::Error for Stopped<T> {}
