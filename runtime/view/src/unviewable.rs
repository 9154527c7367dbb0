//! Why there is no moving picture.

use core::error::Error;
use core::fmt::{self, Display, Formatter};
use std::io;

use reuleaux_picture::Undrawable;

/// Why states cannot be shown.
#[derive(Debug)]
#[non_exhaustive]
pub enum Unviewable {
    /// One of them cannot be drawn, or there is none.
    Undrawable(Undrawable),
    /// What states are ordered by does not increase.
    Abscissa {
        /// Its name.
        name: String,
        /// The first state, counted from 0, at which it is not larger than before, or is not a number.
        state: usize,
    },
    /// A traced point is nowhere.
    Trace {
        /// Its name.
        name: String,
        /// The first state, counted from 0, at which it has no place.
        state: usize,
    },
    /// There is no font on this machine to draw words with.
    NoFont,
    /// A frame could not be turned into pixels.
    Pixels(String),
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
            Unviewable::File(reason) => reason.fmt(f),
        }
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
