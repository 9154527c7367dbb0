//! Long tables on the page of a mechanism, cut where they repeat.
//!
//! Of an array the first two members are shown and the others counted, in mechanisms that would fill pages otherwise.

use crate::model::{Model, Name};
use std::fmt::Write;

/// Mechanisms of up to this many bodies are shown whole.
const WHOLE: usize = 20;

/// Of a long list of names this many are shown.
const LISTED: usize = 12;

/// A table while it is written.
pub(super) struct Abridged {
    is_long: bool,
    left_out: usize,
}

impl Abridged {
    pub(super) fn new(model: &Model) -> Abridged {
        Abridged { is_long: model.bodies.len() > WHOLE, left_out: 0 }
    }

    /// A line about these names is shown; if not, it is counted.
    pub(super) fn shows<'a>(&mut self, mut names: impl Iterator<Item = &'a Name>) -> bool {
        let is_shown = !self.is_long || names.any(|name| !is_repetition(name));
        self.left_out += usize::from(!is_shown);
        is_shown
    }

    /// Says how many lines are missing.
    pub(super) fn rest(&self, page: &mut String, line: impl Fn(&str) -> String) {
        if self.left_out > 0 {
            let _ = writeln!(page, "{}", line(&format!("and {} more with larger indices", self.left_out)));
        }
    }
}

/// One of its indices is above 1.
fn is_repetition(name: &Name) -> bool {
    let indices = name.path.split('[').skip(1).filter_map(|part| part.split(']').next()?.parse::<usize>().ok());
    indices.max().is_some_and(|largest| largest > 1)
}

/// Names with commas; of very many the first.
pub(super) fn list(names: &[String]) -> String {
    match names.len().checked_sub(LISTED) {
        None | Some(0) => names.join(", "),
        Some(more) => format!("{} and {more} more", names[..LISTED].join(", ")),
    }
}
