//! The error type of this crate, and its messages.

use core::error::Error;
use core::fmt;

use crate::names::{BranchEnd, Cause, Coordinate, CoordinateEntries, CoordinateKind, Culprit, Measure, ParameterOutOfRange, Row};
use crate::number::Float;
use crate::state::State;

/// A failure to find a state, in the words of the declaration.
///
/// `{:?}` is the sentence, as `{}` is, so that a program whose `main` returns a failure ends with it; `{:#?}` shows the fields.
///
/// ```
/// reuleaux::mechanism! {
///     mechanism Swing {
///         param length: Length = 1m in 10mm..;
///         body bob { point P = (length, 0m); }
///         joint pivot = revolute(ground.position, bob.position);
///         drive swing = drive_angle(bob, 1rad * sin(t * 2rad_s));
///     }
/// }
///
/// fn main() -> Result<(), SwingFailure> {
///     let failure = Swing { length: 0.0 }.solve(0.0).unwrap_err();
///     assert_eq!(format!("{failure:?}"), "`Swing` cannot be solved with `length` = 0 m: it must lie in 10 mm ..");
///     Swing::default().solve(1.0)?;
///     Ok(())
/// }
/// ```
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub struct Failure<T, const N: usize> {
    /// The mechanism as declared.
    pub mechanism: &'static str,
    /// Cause of the failure.
    pub cause: Cause<T>,
    /// Time of the failure, in s.
    pub time: T,
    /// End of the branch between the declared defaults and these parameters, if it ends there.
    pub end: Option<BranchEnd<T>>,
    /// The last valid state before the failure.
    pub last: Option<State<T, N>>,
}

impl<T: Float, const N: usize> fmt::Display for Failure<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, t) = (self.mechanism, Plain(self.time.to_f64()));
        match (&self.cause, &self.last) {
            (Cause::TooManySteps { steps }, Some(last)) if last.condition.to_f64() > CREEPING => write!(
                f,
                "`{name}` does not reach t = {t} s in {steps} steps: at t = {} s, where it is nearly singular, they become too short; \
                 `solve_near` may find a state beyond from a guess",
                Plain(last.t.to_f64())
            )?,
            (Cause::TooManySteps { steps }, None) => write!(
                f,
                "`{name}` does not find the way from its defaults to these parameters in {steps} steps: give defaults nearer to them, or give \
                 `solve_near` a guess"
            )?,
            (cause, _) => cause.fmt(f, name, t)?,
        }
        let Some(BranchEnd { lambda, row, coordinate }) = &self.end else { return Ok(()) };
        write!(
            f,
            "; on the way from its defaults to these parameters the branch ends at {:.4} %, where {row} does not determine {coordinate}",
            100.0 * lambda.to_f64()
        )
    }
}

impl<T: Float, const N: usize> fmt::Debug for Failure<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !f.alternate() {
            return fmt::Display::fmt(self, f);
        }
        let Self { mechanism, cause, time, end, last } = self;
        let mut fields = f.debug_struct("Failure");
        fields.field("mechanism", mechanism).field("cause", cause).field("time", time).field("end", end).field("last", last).finish()
    }
}

impl<T: Float> Cause<T> {
    /// Writes the cause for the mechanism of this name at time t.
    fn fmt(&self, f: &mut fmt::Formatter<'_>, name: &str, t: Plain) -> fmt::Result {
        match self {
            Cause::DoesNotClose { row, residual, gap } if gap.to_f64().is_infinite() && residual.to_f64().is_finite() => write!(
                f,
                "`{name}` was not assembled at t = {t} s: where the search ended, {row} is off by {}, and no coordinate changes it there",
                Measure(residual.to_f64().abs(), row.unit)
            ),
            Cause::DoesNotClose { row, residual, gap } => {
                write!(
                    f,
                    "`{name}` was not assembled at t = {t} s: where the search ended, {row} stays open by {}{}",
                    if is_bound(row.unit, residual.to_f64(), gap.to_f64()) { "up to " } else { "" },
                    Measure(gap.to_f64(), "m")
                )?;
                if row.unit == "m" { Ok(()) } else { write!(f, " (residual {})", Measure(residual.to_f64(), row.unit)) }
            }
            Cause::DoesNotHold { row, residual } => {
                write!(
                    f,
                    "`{name}` does not fit at t = {t} s: {row} is redundant and off by {}",
                    Measure(residual.to_f64().abs(), row.unit)
                )
            }
            Cause::Singular { row, coordinate, condition } => write!(
                f,
                "`{name}` is at a dead point or change point at t = {t} s: {row} does not determine {coordinate} (condition {:.1e})",
                condition.to_f64()
            ),
            Cause::BranchLost { coordinate, jump } => write!(
                f,
                "`{name}` loses its branch at t = {t} s: {coordinate} would jump by {}",
                Measure(jump.to_f64(), coordinate.kind.unit())
            ),
            Cause::Diverges { coordinate, value } => write!(
                f,
                "`{name}` diverges about at t = {t} s: {coordinate} grows beyond all bounds and is {} already",
                Measure(value.to_f64(), coordinate.kind.unit())
            ),
            Cause::NotFinite { of } => write!(f, "`{name}` is not finite at t = {t} s: {of}"),
            Cause::ParameterOutOfRange(parameter) => write!(f, "`{name}` cannot be solved with {parameter}"),
            Cause::OtherInputs => write!(
                f,
                "`{name}` has other inputs or parameters than those with which this state at t = {t} s was solved: write \
                 `mechanism.with_inputs_of(&state)` instead of `mechanism`"
            ),
            Cause::StateTooFar { coordinate, jump } => write!(
                f,
                "`{name}` has no state at t = {t} s near the given one, from which {coordinate} would jump by {}: the given state was \
                 solved with other parameters, or was changed; solve anew, or change parameters in smaller steps",
                Measure(jump.to_f64(), coordinate.kind.unit())
            ),
            Cause::NoConvergence { correction, iterations } => write!(
                f,
                "`{name}` does not settle at t = {t} s: after {iterations} corrections they are still {:.1e} long",
                correction.to_f64()
            ),
            Cause::TooManySteps { steps } => write!(
                f,
                "`{name}` does not reach t = {t} s in {steps} steps, so far is that time from the state before: go on with `solve_from` from the \
                 last state of this failure, `sweep` through times between, or give `solve_near` a guess for this time"
            ),
        }
    }
}

/// True for the gap of a distance d that should be c, of which only |d − c| ≤ √|d² − c²| is known.
fn is_bound(unit: &str, residual: f64, gap: f64) -> bool {
    unit == "m²" && gap * gap >= (1.0 - 1e-6) * residual.abs()
}

/// Above this condition, short steps are attributed to the condition.
const CREEPING: f64 = 1e5;

/// A number with all its digits; in scientific notation if it has more than six digits before the point or more than twelve zeros after
/// it.
#[derive(Clone, Copy)]
struct Plain(f64);

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let &Plain(value) = self;
        let is_usual = value == 0.0 || !value.is_finite() || (1e-13..1e6).contains(&value.abs());
        if is_usual { write!(f, "{value}") } else { write!(f, "{value:e}") }
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "joint `{}` ({}, row {} of {})", self.joint, self.kind, self.index, self.of)
    }
}

impl fmt::Display for Coordinate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = match self.entries {
            CoordinateEntries::Motion => "",
            CoordinateEntries::Velocity => " of velocity",
            CoordinateEntries::Jerk => " of jerk",
        };
        match self.kind {
            CoordinateKind::Length | CoordinateKind::Angle => write!(f, "`{}.{}{of}`", self.body, self.name),
            // A component of a quaternion or a direction cosine.
            CoordinateKind::Number => write!(f, "the orientation of `{}` (`{}`)", self.body, self.name),
        }
    }
}

impl fmt::Display for Culprit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Time => write!(f, "the time itself"),
            Self::Coordinate(coordinate) => coordinate.fmt(f),
            Self::Row(row) => row.fmt(f),
        }
    }
}

impl<T: Float, const N: usize> Error for Failure<T, N> {}

impl<T: Float> fmt::Display for ParameterOutOfRange<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let space = if self.unit.is_empty() { "" } else { " " };
        write!(f, "`{}` = {}{space}{}: {}", self.name, Plain(self.value.to_f64()), self.unit, self.why)
    }
}

impl<T: Float> Error for ParameterOutOfRange<T> {}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::Plain;
    use std::string::ToString;

    #[test]
    fn very_large_and_very_small_numbers_have_an_exponent() {
        for (value, shown) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (0.25, "0.25"),
            (999_999.5, "999999.5"),
            (1e6, "1e6"),
            (1e300, "1e300"),
            (-1.234e-300, "-1.234e-300"),
            (1e-13, "0.0000000000001"),
            (9e-14, "9e-14"),
            (f64::MIN_POSITIVE / 2.0, "1.1125369292536007e-308"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(Plain(value).to_string(), shown);
        }
    }
}
