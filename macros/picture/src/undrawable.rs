//! Why there is no picture.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// Why a scene cannot be drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Undrawable {
    /// It has this many bodies, more than could be told apart.
    Bodies(usize),
    /// It has this many joints and drives.
    Joints(usize),
    /// It has this many points.
    Points(usize),
    /// It has neither bodies nor points.
    Empty,
    /// It refers to a body that it does not have.
    UnknownBody(String),
    /// Something has no place: a coordinate is not a number, or so large that sizes are none.
    Nowhere,
}

impl Undrawable {
    /// The reason as a whole sentence.
    #[must_use]
    pub fn sentence(&self) -> String {
        format!("There is no picture: {}.", self.reason())
    }

    fn reason(&self) -> String {
        let too_many = |count: &usize, what: &str| format!("in one of {count} {what} nothing could be told apart");
        match self {
            Undrawable::Bodies(count) => too_many(count, "bodies"),
            Undrawable::Joints(count) => too_many(count, "joints"),
            Undrawable::Points(count) => too_many(count, "points"),
            Undrawable::Empty => "there is nothing to draw".to_owned(),
            Undrawable::UnknownBody(name) => format!("`{name}` is none of the bodies"),
            Undrawable::Nowhere => "not every place is a number".to_owned(),
        }
    }
}

impl Display for Undrawable {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "there is no picture: {}", self.reason())
    }
}

impl Error for Undrawable {}
