//! Block numbers, which rise.

use super::error::ProgramWarningKind;

/// The block numbers of a program, one after the other.
#[derive(Debug, Default)]
pub(super) struct Numbering {
    last: Option<u32>,
    not_rising: Option<NotRising>,
}

/// A number that does not rise.
#[derive(Debug, Clone, Copy)]
struct NotRising {
    line: usize,
    number: u32,
    previous: u32,
    count: usize,
}

impl Numbering {
    /// The number of the next block.
    pub(super) fn next(&mut self, line: usize, number: Option<u32>) {
        let Some(number) = number else { return };
        if let Some(previous) = self.last.filter(|&previous| number <= previous) {
            let first = NotRising { line, number, previous, count: 0 };
            self.not_rising.get_or_insert(first).count += 1;
        }
        self.last = Some(number);
    }

    /// The warning about numbers that do not rise, and the line of the first.
    pub(super) fn warning(&self) -> Option<(usize, ProgramWarningKind)> {
        let NotRising { line, number, previous, count } = self.not_rising?;
        Some((line, ProgramWarningKind::Numbers { number, previous, count }))
    }
}
