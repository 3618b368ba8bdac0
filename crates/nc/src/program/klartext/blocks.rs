//! From lines to blocks.

use super::super::block::{Block, Body, Unit};
use super::super::cycle_block::CycleBlock;
use super::super::error::ProgramWarningKind;
use super::super::lines::{Front, Piece, first, front, next, trimmed};
use super::super::numbering::Numbering;
use super::super::source::Source;
use super::super::warnings::Odd;
use super::super::weight::Weight;
use super::cut_off::{Before, CutOff, belongs, cut_off};
use super::cycle;
use super::understand::understand;

pub(super) struct Reader<'a> {
    source: Source<'a>,
    blocks: Vec<Block>,
    pieces: Vec<Piece<'a>>,
    weight: Weight,
    numbering: Numbering,
    /// The cycle directly before.
    cycle: Option<Before>,
    /// How many blocks there were when lines were added to the last one.
    joined: Option<usize>,
    begin: Option<Unit>,
    has_end: bool,
    has_text_after_end: bool,
}

impl<'a> Reader<'a> {
    pub(super) fn new(source: Source<'a>) -> Self {
        Self {
            source,
            blocks: Vec::new(),
            pieces: Vec::new(),
            weight: Weight::default(),
            numbering: Numbering::default(),
            cycle: None,
            joined: None,
            begin: None,
            has_end: false,
            has_text_after_end: false,
        }
    }

    pub(super) fn read(mut self) -> Vec<Block> {
        let mut line = 0;
        while line < self.source.count() {
            line = if trimmed(self.source.line(line)).is_empty() { line + 1 } else { self.block(line) };
        }
        if let Some((line, what)) = self.numbering.warning() {
            self.source.warn(line, 0, what);
        }
        if let (false, Some(last)) = (self.has_end, self.blocks.last()) {
            self.source.warn(last.lines.end - 1, 0, ProgramWarningKind::NoEnd);
        }
        self.blocks
    }

    /// Reads the block that begins in a line; returns the line after it.
    fn block(&mut self, line: usize) -> usize {
        let front = front(self.source.line(line));
        let end = self.collect(line, front.end);
        self.numbering.next(line, front.number);
        if self.join(line, front, end) {
            return end;
        }
        let weighed = self.weight.add(&self.pieces, &["Q", "FN", "DECLARE"]);
        let place = |line, at| self.source.place(line, at);
        let read = weighed.and_then(|()| understand(&self.pieces, place));
        let body = read.unwrap_or_else(|Odd { line, at, what }| {
            self.source.warn(line, at, what);
            Body::Other
        });
        let found = cut_off(self.cycle.as_ref(), front, &self.pieces, &body);
        let is_cut_off = found.is_some();
        let body = match found {
            Some(CutOff { piece, what, is_refused }) => {
                let (line, at) = self.pieces.get(piece).map_or((line, 0), |piece| (piece.line, piece.start));
                self.source.warn(line, at, what);
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
        let mut added = CycleBlock { number: String::new(), name: String::new(), lines: Vec::new() };
        for piece in &self.pieces {
            if cycle::line(&mut added, piece, |at| self.source.place(piece.line, piece.start + at)).is_err() {
                return false;
            }
        }
        let count = self.blocks.len();
        let Some(Block { body: Body::CycleDefinition(cycle) | Body::GlobalDefinition(cycle), lines, .. }) =
            self.blocks.last_mut()
        else {
            return false;
        };
        cycle.lines.append(&mut added.lines);
        let (number, before) = (cycle.number.clone(), lines.end);
        lines.end = end;
        // Said once for each cycle.
        if self.joined.replace(count) != Some(count) {
            self.source.warn(line, first.start, ProgramWarningKind::CycleWithoutTilde { cycle: number, line: before });
        }
        true
    }

    /// Parses the lines of a block; returns the line after it. A comment that is a block of its own continues as a
    /// comment; otherwise every line is parsed. Blank lines are skipped.
    fn collect(&mut self, line: usize, from: usize) -> usize {
        self.pieces.clear();
        let mut last = first(self.source.line(line), line, from);
        self.pieces.push(last);
        let is_comment = last.code.is_empty() && last.comment.is_some();
        let is_heading = last.code.starts_with('*');
        let mut end = line + 1;
        while last.goes_on {
            while end < self.source.count() && trimmed(self.source.line(end)).is_empty() {
                end += 1;
            }
            if self.source.count() <= end {
                self.source.warn(last.line, 0, ProgramWarningKind::OpenEnd);
                return last.line + 1;
            }
            last = next(self.source.line(end), end, 0);
            if is_comment || is_heading {
                let comment = Some(trimmed(self.source.line(end)));
                last = Piece { code: "", comment, open_quote: None, ..last };
            }
            self.pieces.push(last);
            end += 1;
        }
        end
    }

    /// Checks that the program begins and ends correctly.
    fn check_frame(&mut self, line: usize, body: &Body) {
        if self.has_end && !self.has_text_after_end {
            self.has_text_after_end = true;
            self.source.warn(line, 0, ProgramWarningKind::AfterEnd);
        }
        match body {
            Body::Begin { .. } if self.begin.is_some() => self.source.warn(line, 0, ProgramWarningKind::SecondBegin),
            Body::Begin { unit, .. } => self.begin = Some(*unit),
            Body::End { unit, .. } if !self.has_end => {
                self.has_end = true;
                if let Some(begin) = self.begin.filter(|begin| begin != unit) {
                    self.source.warn(line, 0, ProgramWarningKind::Units { begin, end: *unit });
                }
            }
            _ => {}
        }
        if self.blocks.is_empty() && !matches!(body, Body::Begin { .. }) {
            self.source.warn(line, 0, ProgramWarningKind::NoBegin);
        }
    }
}
