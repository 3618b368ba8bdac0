//! From lines to blocks. A block goes on to its `*`, at the latest to the next block number.

use super::super::block::{Block, Body, Unit};
use super::super::error::ProgramWarningKind;
use super::super::klartext::{Before, assigned};
use super::super::lines::{Piece, trimmed};
use super::super::numbering::Numbering;
use super::super::place::Place;
use super::super::source::Source;
use super::super::warnings::Odd;
use super::super::weight::Weight;
use super::body::frame;
use super::modes::Modes;
use super::pieces::{front, piece};
use super::understand::{Collected, is_global, understand};

/// The most lines of a block; one without its `*` is not searched for it any further.
const MOST_LINES: usize = 500;

pub(super) struct Reader<'a> {
    source: Source<'a>,
    blocks: Vec<Block>,
    pieces: Vec<Piece<'a>>,
    weight: Weight,
    numbering: Numbering,
    modes: Modes,
    /// The cycle directly before.
    cycle: Option<Before>,
    begin: Option<Unit>,
    has_end: bool,
    has_text_after_end: bool,
}

impl<'a> Reader<'a> {
    pub(super) fn new(source: Source<'a>) -> Self {
        let modes = Modes::new(source.text());
        Self {
            source,
            blocks: Vec::new(),
            pieces: Vec::new(),
            weight: Weight::default(),
            numbering: Numbering::default(),
            modes,
            cycle: None,
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
            self.source.warn(last.lines.end - 1, 0, ProgramWarningKind::IsoNoEnd);
        }
        self.blocks
    }

    /// Reads the block that begins in a line; returns the line after it.
    fn block(&mut self, line: usize) -> usize {
        let front = front(self.source.line(line));
        let (end, has_star) = self.collect(line, front.end);
        self.numbering.next(line, front.number);
        let before = self.modes;
        let body = match self.read_body(has_star) {
            Ok(body) => body,
            Err(Odd { line, at, what }) => {
                self.source.warn(line, at, what);
                for piece in &self.pieces {
                    self.modes.not_understood(piece.code);
                }
                Body::Other
            }
        };
        if front.may_be_skipped {
            self.modes.skipped(before);
        }
        let cut_off = self.pieces.first().and_then(|first| assigned(self.cycle.as_ref(), front, first, &body));
        let is_cut_off = cut_off.is_some();
        let body = match cut_off {
            Some(cut_off) => {
                let at = self.pieces.first().map_or(0, |first| first.start);
                self.source.warn(line, at, in_iso(cut_off.what));
                if cut_off.is_refused { Body::Other } else { body }
            }
            None => body,
        };
        self.cycle = Before::after(self.cycle.take(), front, &body, end, is_cut_off);
        self.check_frame(line, &body);
        self.blocks.push(Block { lines: line..end, number: front.number, may_be_skipped: front.may_be_skipped, body });
        end
    }

    fn read_body(&mut self, has_star: bool) -> Result<Body, Odd> {
        self.weight.add(&self.pieces, &["Q", "D"])?;
        let place = |line, at| -> Place { self.source.place(line, at) };
        let collected = Collected { pieces: &self.pieces, has_star, is_first: self.begin.is_none() };
        understand(collected, &mut self.modes, place)
    }

    /// Parses the lines of a block; returns the line after it, and whether a `*` ends it. Blank lines are skipped.
    fn collect(&mut self, line: usize, from: usize) -> (usize, bool) {
        self.pieces.clear();
        let (mut last, mut has_star) = piece(self.source.line(line), line, from);
        self.pieces.push(last);
        let mut end = line + 1;
        // Comments, headings and the program's name are whole without a `*`.
        if last.code.is_empty() || last.code.starts_with('*') || frame(last.code).is_some() {
            return (end, has_star);
        }
        let is_global = is_global(last.code);
        while !has_star && (!is_global || last.goes_on) && self.pieces.len() < MOST_LINES {
            let mut next = end;
            while next < self.source.count() && trimmed(self.source.line(next)).is_empty() {
                next += 1;
            }
            if self.source.count() <= next || begins_a_block(self.source.line(next)) {
                break;
            }
            (last, has_star) = piece(self.source.line(next), next, 0);
            self.pieces.push(last);
            end = next + 1;
        }
        (end, has_star)
    }

    /// Checks that the program ends correctly. It begins with its name, or it would not be read here.
    fn check_frame(&mut self, line: usize, body: &Body) {
        if self.has_end && !self.has_text_after_end {
            self.has_text_after_end = true;
            self.source.warn(line, 0, ProgramWarningKind::IsoAfterEnd);
        }
        match body {
            Body::Begin { unit, .. } => self.begin = Some(*unit),
            Body::End { unit, .. } if !self.has_end => {
                self.has_end = true;
                if let Some(begin) = self.begin.filter(|begin| begin != unit) {
                    self.source.warn(line, 0, ProgramWarningKind::IsoUnits { begin, end: *unit });
                }
            }
            _ => {}
        }
    }
}

/// Whether a line can only be the first of a block.
fn begins_a_block(line: &str) -> bool {
    let front = front(line);
    let code = line.get(front.end..).map_or("", trimmed);
    front.number.is_some() || front.may_be_skipped || code.starts_with('%') || is_global(code)
}

/// What is wrong with a line of a cycle, without a `~`.
fn in_iso(what: ProgramWarningKind) -> ProgramWarningKind {
    match what {
        ProgramWarningKind::CycleCut { cycle, line, parameter } => {
            ProgramWarningKind::IsoCycleCut { cycle, line, parameter }
        }
        what => what,
    }
}
