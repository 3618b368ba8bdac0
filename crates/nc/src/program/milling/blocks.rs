//! From lines to blocks, as far as Klartext and ISO do it alike: numbers, the cut-off lines of cycles, beginning and end.

use super::super::block::{Block, Body, Unit};
use super::super::error::ProgramWarningKind;
use super::super::lines::{Front, Piece, trimmed};
use super::super::numbering::Numbering;
use super::super::place::TextPlace;
use super::super::source::Source;
use super::super::warnings::Odd;
use super::super::weight::Weight;
use super::cut_off::{Before, CutOff};

/// What a notation does in its own way.
pub(in super::super) trait Form: Sized {
    /// The words that formulas begin with.
    const FORMULAS: &'static [&'static str];
    /// The program has no last block.
    const NO_END: ProgramWarningKind;
    /// Something follows the last block.
    const AFTER_END: ProgramWarningKind;
    /// The program does not begin with its first block; `None` where it would not be read as one of this notation.
    const NO_BEGIN: Option<ProgramWarningKind>;

    /// Beginning and end have different units.
    fn units(begin: Unit, end: Unit) -> ProgramWarningKind;

    /// Reads what precedes a block.
    fn front(line: &str) -> Front;

    /// Parses the lines of a block that begins in a line, behind the first `from` bytes; returns the line after it.
    fn collect(reader: &mut Reader<'_, Self>, line: usize, from: usize) -> usize;

    /// Adds the lines to the block before, if they belong to it; whether they did.
    fn join(_reader: &mut Reader<'_, Self>, _line: usize, _front: Front, _end: usize) -> bool {
        false
    }

    /// What the lines of a block say, unless they are too many (`weighed`); `place` turns a line and its bytes into a place.
    fn understand(
        &mut self,
        weighed: Result<(), Odd>,
        front: Front,
        pieces: &[Piece<'_>],
        place: impl Fn(usize, usize) -> TextPlace,
    ) -> Result<Body, Odd>;

    /// What a missing or a surplus sign has put into the wrong block.
    fn cut_off(before: Option<&Before>, front: Front, pieces: &[Piece<'_>], read: &Body) -> Option<CutOff>;
}

/// Reads the blocks of a program.
pub(in super::super) struct Reader<'a, F> {
    pub form: F,
    pub source: Source<'a>,
    pub blocks: Vec<Block>,
    /// The lines of the present block.
    pub pieces: Vec<Piece<'a>>,
    weight: Weight,
    numbering: Numbering,
    /// The cycle directly before.
    cycle: Option<Before>,
    begin: Option<Unit>,
    has_end: bool,
    has_text_after_end: bool,
}

impl<'a, F: Form> Reader<'a, F> {
    pub(in super::super) fn new(source: Source<'a>, form: F) -> Self {
        Self {
            form,
            source,
            blocks: Vec::new(),
            pieces: Vec::new(),
            weight: Weight::default(),
            numbering: Numbering::default(),
            cycle: None,
            begin: None,
            has_end: false,
            has_text_after_end: false,
        }
    }

    pub(in super::super) fn read(mut self) -> Vec<Block> {
        let mut line = 0;
        while line < self.source.count() {
            line = if self.is_blank(line) { line + 1 } else { self.block(line) };
        }
        if let Some((line, what)) = self.numbering.warning() {
            self.source.warn(line, 0, what);
        }
        if let (false, Some(last)) = (self.has_end, self.blocks.last()) {
            self.source.warn(last.lines.end - 1, 0, F::NO_END);
        }
        self.blocks
    }

    fn is_blank(&self, line: usize) -> bool {
        trimmed(self.source.line(line)).is_empty()
    }

    /// The next line from here that is not blank.
    pub(in super::super) fn next_line(&self, from: usize) -> Option<usize> {
        (from..self.source.count()).find(|&line| !self.is_blank(line))
    }

    /// Reads the block that begins in a line; returns the line after it.
    fn block(&mut self, line: usize) -> usize {
        let front = F::front(self.source.line(line));
        let end = F::collect(self, line, front.end);
        self.numbering.next(line, front.number);
        if F::join(self, line, front, end) {
            return end;
        }
        let body = self.body(line, front, end);
        self.check_frame(line, &body);
        let Front { number, may_be_skipped, .. } = front;
        self.blocks.push(Block { lines: line..end, number, may_be_skipped, body });
        end
    }

    /// What a block says; what is not understood, or may mean something else, is not run.
    fn body(&mut self, line: usize, front: Front, end: usize) -> Body {
        let weighed = self.weight.add(&self.pieces, F::FORMULAS);
        let place = |line, at| self.source.place(line, at);
        let read = self.form.understand(weighed, front, &self.pieces, place);
        let body = read.unwrap_or_else(|Odd { line, at, what }| {
            self.source.warn(line, at, what);
            Body::Other
        });
        let found = F::cut_off(self.cycle.as_ref(), front, &self.pieces, &body);
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
        body
    }

    /// Checks that the program begins and ends correctly.
    fn check_frame(&mut self, line: usize, body: &Body) {
        if self.has_end && !self.has_text_after_end {
            self.has_text_after_end = true;
            self.source.warn(line, 0, F::AFTER_END);
        }
        match body {
            Body::Begin { .. } if self.begin.is_some() => self.source.warn(line, 0, ProgramWarningKind::SecondBegin),
            Body::Begin { unit, .. } => self.begin = Some(*unit),
            Body::End { unit, .. } if !self.has_end => {
                self.has_end = true;
                if let Some(begin) = self.begin.filter(|begin| begin != unit) {
                    self.source.warn(line, 0, F::units(begin, *unit));
                }
            }
            _ => {}
        }
        if let Some(what) = F::NO_BEGIN.filter(|_| self.blocks.is_empty() && !matches!(body, Body::Begin { .. })) {
            self.source.warn(line, 0, what);
        }
    }
}
