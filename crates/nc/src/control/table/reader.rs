//! The pass over the lines of a table: which line it is at, what is found odd, and how much may still be kept.

use std::sync::Arc;

use fitcheck_core::message::{FilePlace, Located};
use fitcheck_core::text::lines;

use super::fault::{TableError, TableFault, TableWarning, TableWarningKind};
use super::{Comment, CommentPlace};

/// The longest line in bytes. iTNC 530 has 200 characters, a TNC7 a few thousand.
const LONGEST_LINE: usize = 1 << 16;
/// The most columns. iTNC 530 has 30.
pub(super) const MOST_COLUMNS: usize = 1_000;
/// The most cells and other kept parts: 30 columns and 30 000 rows fit, and memory stays within about 100 MB.
const MOST_CELLS: usize = 1_000_000;
/// The widest column that a block may describe.
pub(super) const WIDEST: usize = 10_000;

/// The pass over the lines.
pub(super) struct Reader<'a> {
    lines: Box<dyn Iterator<Item = (usize, &'a str)> + 'a>,
    pub(super) file: Arc<str>,
    /// The number of the line that was read last.
    pub(super) line: usize,
    pub(super) warnings: Vec<TableWarning>,
    /// How many more parts may be kept.
    budget: usize,
    /// Whether rows may end before the last column.
    pub(super) may_be_short: bool,
}

impl<'a> Reader<'a> {
    pub(super) fn new(text: &'a str, file: &str) -> Self {
        let lines = Box::new(lines(text));
        Self { lines, file: file.into(), line: 0, warnings: Vec::new(), budget: MOST_CELLS, may_be_short: false }
    }

    /// An error at a character (from 0) of the line that was read last.
    pub(super) fn fault(&self, what: TableFault, character: usize) -> TableError {
        self.fault_at(what, self.line.max(1), character)
    }

    pub(super) fn fault_at(&self, what: TableFault, line: usize, character: usize) -> TableError {
        Located { what, place: FilePlace::in_file(&self.file, line, character + 1) }
    }

    pub(super) fn warn(&mut self, what: TableWarningKind, character: usize) {
        let place = FilePlace::in_file(&self.file, self.line.max(1), character + 1);
        self.warnings.push(Located { what, place });
    }

    /// Counts kept parts; one too many is an error.
    pub(super) fn keep(&mut self, parts: usize) -> Result<(), TableError> {
        let too_large = || self.fault(TableFault::TooLarge { limit: MOST_CELLS }, 0);
        self.budget = self.budget.checked_sub(parts).ok_or_else(too_large)?;
        Ok(())
    }

    /// The next line that is not blank.
    pub(super) fn next_line(&mut self) -> Result<Option<&'a str>, TableError> {
        for (number, line) in self.lines.by_ref() {
            self.line = number;
            if LONGEST_LINE < line.len() {
                return Err(self.fault(TableFault::LineTooLong { limit: LONGEST_LINE }, 0));
            }
            if let Some((at, control)) = line.chars().enumerate().find(|(_, c)| c.is_control() && *c != '\t') {
                return Err(self.fault(TableFault::NotText { code: control.into() }, at));
            }
            if !line.trim().is_empty() {
                return Ok(Some(line));
            }
        }
        Ok(None)
    }

    pub(super) fn comment(&mut self, place: CommentPlace, text: &str) -> Result<Comment, TableError> {
        self.keep(1)?;
        Ok(Comment { place, text: text.to_owned() })
    }
}
