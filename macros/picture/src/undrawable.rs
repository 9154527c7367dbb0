//! Reasons why a scene cannot be drawn.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// Reason why a scene cannot be drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Undrawable {
    /// The scene has this many bodies, too many to tell apart.
    Bodies(usize),
    /// The scene has this many joints and drives, too many to tell apart.
    Joints(usize),
    /// The scene has this many points, too many to tell apart.
    Points(usize),
    /// The scene has neither bodies nor points.
    Empty,
    /// The scene refers to a body that does not exist.
    UnknownBody(String),
    /// A coordinate is not a number, or too large.
    Nowhere,
    /// The direction from which the scene is seen is zero or not finite.
    Unseen,
}

impl Undrawable {
    /// The reason as a sentence.
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
            Undrawable::Unseen => "the direction of view is zero or not finite".to_owned(),
        }
    }
}

impl Display for Undrawable {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "there is no picture: {}", self.reason())
    }
}

impl Error for Undrawable {}
