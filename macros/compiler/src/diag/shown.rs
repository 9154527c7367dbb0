//! Renders an error as a user sees it, for tests and pages, without rustc.
//!
//! In: an error, and the source of its tokens. Spans have lines and columns only outside of rustc, so that the macros do not use this.

use super::Refusal;
use std::ops::Range;

impl Refusal {
    /// The underlined text; of several lines the first one.
    #[must_use]
    pub fn underlined<'a>(&self, source: &'a str) -> &'a str {
        let (line, columns) = self.place(source);
        let byte = |column: usize| line.char_indices().nth(column).map_or(line.len(), |(byte, _)| byte);
        line.get(byte(columns.start)..byte(columns.end)).unwrap_or("")
    }

    /// Message, source line and underline, in the style of rustc.
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

    /// The first source line of the tokens at fault, and the columns to underline.
    fn place<'a>(&self, source: &'a str) -> (&'a str, Range<usize>) {
        let (first, last) = (self.range.first.start(), self.range.last.end());
        let line = source.lines().nth(first.line.saturating_sub(1)).unwrap_or("");
        let end = if last.line == first.line { last.column } else { line.chars().count() };
        (line, first.column..end)
    }
}
