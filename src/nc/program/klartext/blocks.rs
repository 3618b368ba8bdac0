//! From lines to blocks.

use super::super::block::{Block, Body, Place, Unit};
use super::super::cursor::Cursor;
use super::super::error::ProgramWarningKind;
use super::super::fault::BlockFault;
use super::super::lines::{Front, Lines, Piece, first, front, next, trimmed};
use super::super::warnings::Warnings;
use super::cut_off::{Before, CutOff, belongs, cut_off};
use super::cycle;
use super::understand::{Odd, understand};

/// The most text in formulas and in lines longer than [`LONG`], 8 MiB: once read, it takes up to fifty times its length
/// in memory. Real programs stay far below.
const MOST_FORMULAS: usize = 8 << 20;
/// A line from this length on is long: a control's has about 250 characters.
const LONG: usize = 256;

/// A number that does not rise.
#[derive(Debug, Clone, Copy)]
struct NotRising {
    line: usize,
    number: u32,
    previous: u32,
    count: usize,
}

pub(super) struct Reader<'a> {
    text: &'a str,
    lines: &'a Lines,
    warnings: &'a mut Warnings,
    blocks: Vec<Block>,
    pieces: Vec<Piece<'a>>,
    formulas: usize,
    number: Option<u32>,
    /// The cycle directly before.
    cycle: Option<Before>,
    /// How many blocks there were when lines were added to the last one.
    joined: Option<usize>,
    not_rising: Option<NotRising>,
    begin: Option<Unit>,
    has_end: bool,
    has_text_after_end: bool,
}

impl<'a> Reader<'a> {
    pub(super) fn new(text: &'a str, lines: &'a Lines, warnings: &'a mut Warnings) -> Self {
        Self {
            text,
            lines,
            warnings,
            blocks: Vec::new(),
            pieces: Vec::new(),
            formulas: 0,
            number: None,
            cycle: None,
            joined: None,
            not_rising: None,
            begin: None,
            has_end: false,
            has_text_after_end: false,
        }
    }

    pub(super) fn read(mut self) -> Vec<Block> {
        let mut line = 0;
        while line < self.lines.count() {
            line = if trimmed(self.line(line)).is_empty() { line + 1 } else { self.block(line) };
        }
        if let Some(NotRising { line, number, previous, count }) = self.not_rising {
            self.warn(line, 0, ProgramWarningKind::Numbers { number, previous, count });
        }
        if let (false, Some(last)) = (self.has_end, self.blocks.last()) {
            self.warn(last.lines.end - 1, 0, ProgramWarningKind::NoEnd);
        }
        self.blocks
    }

    fn line(&self, line: usize) -> &'a str {
        self.lines.line(self.text, line)
    }

    /// A place in a line: bytes turned into characters.
    fn place(&self, line: usize, at: usize) -> Place {
        let before = self.line(line).get(..at).map_or(0, |before| before.chars().count());
        Place { line: line + 1, column: before + 1 }
    }

    fn warn(&mut self, line: usize, at: usize, what: ProgramWarningKind) {
        let place = self.place(line, at);
        self.warnings.add(place, || what);
    }

    /// Reads the block that begins in a line; returns the line after it.
    fn block(&mut self, line: usize) -> usize {
        let front = front(self.line(line));
        let end = self.collect(line, front.end);
        self.check_number(line, front);
        if self.join(line, front, end) {
            return end;
        }
        let read = self.weigh().and_then(|()| understand(&self.pieces, |line, at| self.place(line, at)));
        let body = read.unwrap_or_else(|Odd { line, at, what }| {
            self.warn(line, at, what);
            Body::Other
        });
        let found = cut_off(self.cycle.as_ref(), front, &self.pieces, &body);
        let is_cut_off = found.is_some();
        let body = match found {
            Some(CutOff { piece, what, is_refused }) => {
                let (line, at) = self.pieces.get(piece).map_or((line, 0), |piece| (piece.line, piece.start));
                self.warn(line, at, what);
                if is_refused { Body::Other } else { body }
            }
            None => body,
        };
        self.cycle = Before::after(self.cycle.take(), front, &body, end, is_cut_off);
        self.check_frame(line, &body);
        let Front { number, may_be_skipped, .. } = front;
        self.blocks.push(Block { lines: line..end, number, may_be_skipped, body });
        end
    }

    /// Adds the lines to the cycle before, if they belong to it although a `~` is missing.
    fn join(&mut self, line: usize, front: Front, end: usize) -> bool {
        let Some(&first) = self.pieces.first().filter(|first| belongs(self.blocks.last(), front, first)) else {
            return false;
        };
        let Some(Block { body: Body::CycleDefinition(cycle) | Body::GlobalDefinition(cycle), lines, .. }) =
            self.blocks.last()
        else {
            return false;
        };
        let mut cycle = cycle.clone();
        let before = lines.end;
        for piece in &self.pieces {
            if cycle::line(&mut cycle, piece, |at| self.place(piece.line, piece.start + at)).is_err() {
                return false;
            }
        }
        // Said once for each cycle.
        if self.joined.replace(self.blocks.len()) != Some(self.blocks.len()) {
            let what = ProgramWarningKind::CycleWithoutTilde { cycle: cycle.number.clone(), line: before };
            self.warn(line, first.start, what);
        }
        if let Some(Block { body: Body::CycleDefinition(whole) | Body::GlobalDefinition(whole), lines, .. }) =
            self.blocks.last_mut()
        {
            *whole = cycle;
            lines.end = end;
        }
        true
    }

    /// Parses the lines of a block; returns the line after it. A comment that is a block of its own continues as a
    /// comment; otherwise every line is parsed. Blank lines are skipped.
    fn collect(&mut self, line: usize, from: usize) -> usize {
        self.pieces.clear();
        let mut last = first(self.line(line), line, from);
        self.pieces.push(last);
        let is_comment = last.code.is_empty() && last.comment.is_some();
        let is_heading = last.code.starts_with('*');
        let mut end = line + 1;
        while last.goes_on {
            while end < self.lines.count() && trimmed(self.line(end)).is_empty() {
                end += 1;
            }
            if self.lines.count() <= end {
                self.warn(last.line, 0, ProgramWarningKind::OpenEnd);
                return last.line + 1;
            }
            last = next(self.line(end), end, 0);
            if is_comment || is_heading {
                let comment = Some(trimmed(self.line(end)));
                last = Piece { code: "", comment, open_quote: None, ..last };
            }
            self.pieces.push(last);
            end += 1;
        }
        end
    }

    /// Counts the total of formulas and long lines; too much is an error.
    fn weigh(&mut self) -> Result<(), Odd> {
        let Some(&first) = self.pieces.first() else { return Ok(()) };
        let is_formula = ["Q", "FN", "DECLARE"].iter().any(|word| Cursor::new(first.code).take_prefix(word));
        let lengths = self.pieces.iter().map(|piece| piece.code.len());
        let weight: usize = lengths.filter(|length| is_formula || LONG < *length).sum();
        self.formulas = self.formulas.saturating_add(weight);
        if weight == 0 || self.formulas <= MOST_FORMULAS {
            return Ok(());
        }
        let reason = BlockFault::TooMuch { most: MOST_FORMULAS >> 20 };
        Err(Odd { line: first.line, at: first.start, what: ProgramWarningKind::NotUnderstood(reason) })
    }

    fn check_number(&mut self, line: usize, front: Front) {
        let Some(number) = front.number else { return };
        if let Some(previous) = self.number.filter(|&previous| number <= previous) {
            let first = NotRising { line, number, previous, count: 0 };
            self.not_rising.get_or_insert(first).count += 1;
        }
        self.number = Some(number);
    }

    /// Checks that the program begins and ends correctly.
    fn check_frame(&mut self, line: usize, body: &Body) {
        if self.has_end && !self.has_text_after_end {
            self.has_text_after_end = true;
            self.warn(line, 0, ProgramWarningKind::AfterEnd);
        }
        match body {
            Body::Begin { .. } if self.begin.is_some() => self.warn(line, 0, ProgramWarningKind::SecondBegin),
            Body::Begin { unit, .. } => self.begin = Some(*unit),
            Body::End { unit, .. } if !self.has_end => {
                self.has_end = true;
                if let Some(begin) = self.begin.filter(|begin| begin != unit) {
                    self.warn(line, 0, ProgramWarningKind::Units { begin, end: *unit });
                }
            }
            _ => {}
        }
        if self.blocks.is_empty() && !matches!(body, Body::Begin { .. }) {
            self.warn(line, 0, ProgramWarningKind::NoBegin);
        }
    }
}
