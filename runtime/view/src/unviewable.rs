//! Reasons why states cannot be shown.

use core::error::Error;
use core::fmt::{self, Display, Formatter};
use std::io;

use reuleaux_picture::Undrawable;

/// Reason why states cannot be shown. `{:?}` is the sentence, as `{}` is.
#[non_exhaustive]
pub enum Unviewable {
    /// A state cannot be drawn, or there is no state.
    Undrawable(Undrawable),
    /// The abscissa does not increase.
    Abscissa {
        /// Name of the abscissa.
        name: String,
        /// First state, counted from 0, at which the abscissa does not exceed the value before or is not a number.
        state: usize,
    },
    /// A traced point has no finite coordinates.
    Trace {
        /// Name of the trace.
        name: String,
        /// First state, counted from 0, at which the coordinates are not finite.
        state: usize,
    },
    /// This machine has no font for the labels.
    NoFont,
    /// A frame could not be rendered as pixels.
    Pixels(String),
    /// A diagram could not be drawn.
    Diagram(String),
    /// A file could not be written.
    File(io::Error),
}

impl Display for Unviewable {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Unviewable::Undrawable(reason) => reason.fmt(f),
            Unviewable::Abscissa { name, state } => write!(f, "`{name}` does not increase at state {state}"),
            Unviewable::Trace { name, state } => write!(f, "`{name}` has no place at state {state}"),
            Unviewable::NoFont => write!(f, "there is no font to draw words with"),
            Unviewable::Pixels(reason) => write!(f, "a frame has no pixels: {reason}"),
            Unviewable::Diagram(reason) => write!(f, "there is no diagram: {reason}"),
            Unviewable::File(reason) => reason.fmt(f),
        }
    }
}

impl fmt::Debug for Unviewable {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        Display::fmt(self, f)
    }
}

impl Error for Unviewable {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Unviewable::Undrawable(reason) => Some(reason),
            Unviewable::File(reason) => Some(reason),
            _ => None,
        }
    }
}

impl From<Undrawable> for Unviewable {
    fn from(reason: Undrawable) -> Unviewable {
        Unviewable::Undrawable(reason)
    }
}

impl From<io::Error> for Unviewable {
    fn from(reason: io::Error) -> Unviewable {
        Unviewable::File(reason)
    }
}
