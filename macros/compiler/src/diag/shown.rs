//! A refusal as a reader sees it, for tests and pages: rustc is not needed to look at one.
//!
//! In: a refusal, and the source that was parsed to the tokens it blames. Spans know their lines and columns only outside of
//! rustc, so that this is no part of what the macros do.

use super::Refusal;
use std::ops::Range;

impl Refusal {
    /// The text that is underlined, of the first line if it goes on.
    #[must_use]
    pub fn underlined<'a>(&self, source: &'a str) -> &'a str {
        let (line, columns) = self.place(source);
        let byte = |column: usize| line.char_indices().nth(column).map_or(line.len(), |(byte, _)| byte);
        line.get(byte(columns.start)..byte(columns.end)).unwrap_or("")
    }

    /// Message, line and underline, in the manner of rustc.
    ///
    /// ```text
    /// error: expected a length (m), found an angle (rad) [reuleaux::E0305]
    ///   |
    ///   | param length: Length = 30deg;
    ///   |                        ^^^^^
    /// ```
    #[must_use]
    pub fn shown(&self, source: &str) -> String {
        let (line, columns) = self.place(source);
        let message = self.fact.message().replace('\n', "\n       ");
        format!("error: {message}\n  |\n  | {line}\n  | {}{}\n", " ".repeat(columns.start), "^".repeat(columns.len().max(1)))
    }

    /// The line on which the blamed tokens begin, and from which character to which they are underlined.
    fn place<'a>(&self, source: &'a str) -> (&'a str, Range<usize>) {
        let (first, last) = (self.range.first.start(), self.range.last.end());
        let line = source.lines().nth(first.line.saturating_sub(1)).unwrap_or("");
        let end = if last.line == first.line { last.column } else { line.chars().count() };
        (line, first.column..end)
    }
}
