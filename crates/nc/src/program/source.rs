//! The text of a program while it is read.

use super::error::ProgramWarningKind;
use super::lines::Lines;
use super::place::TextPlace;
use super::warnings::Warnings;

/// The lines of a program, and what is odd about them.
pub(super) struct Source<'a> {
    text: &'a str,
    lines: &'a Lines,
    warnings: &'a mut Warnings,
}

impl<'a> Source<'a> {
    pub(super) const fn new(text: &'a str, lines: &'a Lines, warnings: &'a mut Warnings) -> Self {
        Self { text, lines, warnings }
    }

    /// The whole text.
    pub(super) const fn text(&self) -> &'a str {
        self.text
    }

    /// How many lines there are.
    pub(super) const fn count(&self) -> usize {
        self.lines.count()
    }

    /// A line, counted from 0; empty beyond the last.
    pub(super) fn line(&self, line: usize) -> &'a str {
        self.lines.line(self.text, line)
    }

    /// A place in a line: bytes turned into characters.
    pub(super) fn place(&self, line: usize, at: usize) -> TextPlace {
        self.lines.place(self.text, line, at)
    }

    /// Adds a warning at a place in a line, in bytes.
    pub(super) fn warn(&mut self, line: usize, at: usize, what: ProgramWarningKind) {
        let place = self.place(line, at);
        self.warnings.add(place, || what);
    }
}
