//! From lines to blocks, section by section: every line is a block.

use super::super::around::{Goes, PassedOver};
use super::super::block::{Block, Body, Unit, still};
use super::super::cursor::{Cursor, Stop, shown};
use super::super::error::ProgramWarningKind;
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::lines::trimmed;
use super::super::notation::Notation;
use super::super::source::Source;
use super::super::warnings::LONGEST;
use super::super::weight::Weight;
use super::branches::{Branches, Unended};
use super::language::{self, END, END_OF_UNIT, MACHINING, SUBPROGRAM, Section};
use super::line::Line;
use super::statement::{Said, said};

/// In which part of the program a line is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    /// Data of the section with this word.
    Data(&'static str),
    /// Blocks that run.
    Machining,
    /// Behind the end: only subprograms.
    Behind,
}

pub(super) struct Reader<'a> {
    source: Source<'a>,
    blocks: Vec<Block>,
    branches: Branches,
    part: Part,
    /// The part that goes on behind a subprogram.
    outer: Part,
    /// The name behind `%`, once the program has begun.
    name: Option<String>,
    unit: Option<Unit>,
    has_machining: bool,
    has_end: bool,
    is_told_behind: bool,
    /// The block of the unit that is open.
    unit_block: Option<usize>,
    weight: Weight,
}

impl<'a> Reader<'a> {
    pub(super) fn new(source: Source<'a>) -> Self {
        Self {
            source,
            blocks: Vec::new(),
            branches: Branches::default(),
            part: Part::Data("%"),
            outer: Part::Machining,
            name: None,
            unit: None,
            has_machining: false,
            has_end: false,
            is_told_behind: false,
            unit_block: None,
            weight: Weight::default(),
        }
    }

    pub(super) fn read(mut self) -> (Vec<Block>, bool) {
        for line in 0..self.source.count() {
            if !trimmed(self.source.line(line)).is_empty() {
                let (number, body) = self.block(line);
                self.blocks.push(Block { lines: line..line + 1, number, may_be_skipped: false, body });
            }
        }
        self.end();
        (self.blocks, self.unit.is_some())
    }

    /// A block that is not run, with the reason.
    fn refuse(&mut self, line: usize, at: usize, reason: BlockFault) -> Body {
        self.source.warn(line, at, ProgramWarningKind::NotUnderstood(of_lathes(reason)));
        Body::Other
    }

    /// The number and the body of a line.
    fn block(&mut self, line: usize) -> (Option<u32>, Body) {
        let text = self.source.line(line);
        let parts = match Line::of(text) {
            Ok(parts) => parts,
            Err((at, what)) => {
                self.source.warn(line, at, what);
                // What is passed over need not be understood.
                let body = match self.part {
                    Part::Data(word) => still(word),
                    Part::Machining | Part::Behind => Body::Other,
                };
                return (None, body);
            }
        };
        let section = if parts.number.is_none() { language::section(parts.code) } else { None };
        let body = match section {
            _ if parts.code.is_empty() => Body::Nothing,
            _ if parts.code.starts_with('%') => self.begin(line, parts),
            Some((word, section)) => self.section(line, parts, word, section),
            None => match self.part {
                Part::Data(word) if !is_subprogram(parts.code) => self.data(line, parts, word),
                _ => self.running(line, parts),
            },
        };
        (parts.number, body)
    }

    /// `%NAME.nc "TURN_V1.0"`
    fn begin(&mut self, line: usize, Line { start, code, .. }: Line<'_>) -> Body {
        let name = code.trim_start_matches('%').trim_start();
        if self.name.is_some() {
            let found = shown(code);
            return self.refuse(line, start, BlockFault::LeftOver { found });
        }
        let end = name.find(|c: char| c.is_whitespace() || c == '"').unwrap_or(name.len());
        let (name, rest) = name.split_at_checked(end).unwrap_or((name, ""));
        let mut version = Cursor::new(rest);
        version.quoted();
        if let Err(Stop { at, reason }) = version.end() {
            // Only the name counts.
            self.source.warn(line, start + code.len() - rest.len() + at, ProgramWarningKind::NotUnderstood(reason));
        }
        self.name = Some(name.to_owned());
        if self.is_subprogram_file() && !self.has_section(Section::Machining) {
            self.part = Part::Machining;
        }
        Body::Begin { name: name.to_owned(), unit: Unit::Mm }
    }

    /// The end of the program; its name is empty where it does not begin with one.
    fn end_body(&self) -> Body {
        Body::End { name: self.name.as_ref().map_or_else(String::new, Clone::clone), unit: Unit::Mm }
    }

    fn is_subprogram_file(&self) -> bool {
        self.name.as_ref().is_some_and(|name| name.to_ascii_lowercase().ends_with(SUBPROGRAM))
    }

    fn has_section(&self, wanted: Section) -> bool {
        let found = |line| Line::of(self.source.line(line)).ok().and_then(|line| language::section(line.code));
        (0..self.source.count()).filter_map(found).any(|(_, section)| section == wanted)
    }

    /// A line that begins a section.
    fn section(&mut self, line: usize, parts: Line<'_>, word: &'static str, section: Section) -> Body {
        if self.name.is_none() && section != Section::End {
            self.source.warn(line, parts.start, ProgramWarningKind::NoSection { section: "%NAME.nc" });
            self.name = Some(String::new());
            self.part = if section == Section::Machining { Part::Machining } else { Part::Data(word) };
            self.has_machining = section == Section::Machining;
            return Body::Begin { name: String::new(), unit: Unit::Mm };
        }
        let heading = || Body::Heading { depth: 1, text: parts.code.to_owned() };
        match section {
            Section::Data if matches!(self.part, Part::Data(_)) => {
                self.part = Part::Data(word);
                heading()
            }
            Section::Machining if matches!(self.part, Part::Data(_)) => {
                self.part = Part::Machining;
                self.has_machining = true;
                heading()
            }
            Section::End if !self.has_end => {
                self.end_branches(true);
                self.part = Part::Behind;
                self.has_end = true;
                // Without blocks that run, nothing was measured: the run says so.
                if self.has_machining || self.is_subprogram_file() { self.end_body() } else { Body::Other }
            }
            _ => self.refuse(line, parts.start, BlockFault::UnknownWord { found: word.to_owned() }),
        }
    }

    /// A line of data; the head says the unit.
    fn data(&mut self, line: usize, parts: Line<'_>, word: &'static str) -> Body {
        match language::unit(parts.code) {
            // The head says it, once.
            Some(Ok(unit)) if self.unit.is_some_and(|said| said != unit) => {
                return self.refuse(line, parts.start, BlockFault::SecondUnit);
            }
            Some(Ok(unit)) => self.unit = Some(unit),
            Some(Err(())) => {
                let at = parts.start + parts.code.find(char::is_whitespace).map_or(0, |at| at + 1);
                // Where millimetres cannot be told from inches, nothing is measured.
                return self.refuse(line, at, BlockFault::Missing(ExpectedWord::Unit));
            }
            None => {}
        }
        still(word)
    }

    /// A block that runs.
    fn running(&mut self, line: usize, Line { start, code, .. }: Line<'_>) -> Body {
        let read = self.weigh(code).and_then(|()| said(&mut Cursor::of(code, Notation::DinPlus)));
        if self.unit_block.is_some() {
            return self.in_unit(line, start, code, read.as_ref().ok());
        }
        let said = match read {
            Ok(said) => said,
            Err(Stop { at, reason }) => {
                self.branches.open_other(code, self.blocks.len());
                return self.refuse(line, start + at, reason);
            }
        };
        match said {
            Said::Body(Body::Nothing) => Body::Nothing,
            Said::Subprogram(_) => {
                // One that has no end goes on where that one began.
                if !self.branches.is_in_subprogram() {
                    self.outer = self.part;
                }
                self.end_branches(true);
                self.part = Part::Machining;
                self.branched(line, start, said)
            }
            Said::Return if self.branches.is_in_subprogram() => {
                self.end_branches(false);
                self.part = self.outer;
                self.branched(line, start, said)
            }
            // A subprogram in a file of its own.
            Said::Return if self.is_subprogram_file() && self.part == Part::Machining => {
                self.end_branches(true);
                self.has_end = true;
                self.part = Part::Behind;
                self.end_body()
            }
            _ if self.part == Part::Behind => {
                if !self.is_told_behind {
                    self.is_told_behind = true;
                    self.source.warn(line, start, ProgramWarningKind::AfterLastSection);
                }
                Body::Other
            }
            Said::Unit => {
                self.unit_block = Some(self.blocks.len());
                // Where a unit leaves the tool, only the control knows.
                let goes = Goes { is_unknown: true, axes: Vec::new() };
                Body::PassedOver(PassedOver { words: "UNIT".to_owned(), goes, machine: Vec::new() })
            }
            Said::EndOfUnit => self.refuse(line, start, BlockFault::Alone { found: END_OF_UNIT, missing: "UNIT" }),
            said => self.branched(line, start, said),
        }
    }

    fn branched(&mut self, line: usize, start: usize, said: Said) -> Body {
        match self.branches.body(said, &mut self.blocks) {
            Ok(Body::Probe(mut cycle)) => {
                for letter in &mut cycle.lines {
                    letter.place = self.source.place(line, start + letter.place.column);
                }
                Body::Probe(cycle)
            }
            Ok(body) => body,
            Err(reason) => self.refuse(line, start, reason),
        }
    }

    /// A block of a unit: passed over, unless it measures or sets a variable.
    fn in_unit(&mut self, line: usize, start: usize, code: &str, said: Option<&Said>) -> Body {
        match said {
            Some(Said::EndOfUnit) => self.unit_block = None,
            Some(Said::Subprogram(_)) => {
                self.end_unit();
                return self.running(line, Line { number: None, start, code, comment: None });
            }
            Some(Said::Body(
                Body::Probe(_)
                | Body::Assign { .. }
                | Body::AssignText { .. }
                | Body::Input { .. }
                | Body::CallLabel { .. }
                | Body::CallProgram(_),
            )) => return self.refuse(line, start, BlockFault::ActsInUnit),
            // What is not understood may measure, too.
            None if shifts(code) => return self.refuse(line, start, BlockFault::ShiftsInUnit),
            None if code.starts_with(['#', 'L', 'I']) || code.contains("G7") => {
                return self.refuse(line, start, BlockFault::ActsInUnit);
            }
            _ => {}
        }
        still("UNIT")
    }

    fn end_unit(&mut self) {
        let Some(block) = self.unit_block.take() else { return };
        let line = self.blocks.get(block).map_or(0, |block| block.lines.start);
        let start = Line::of(self.source.line(line)).map_or(0, |parts| parts.start);
        let body = self.refuse(line, start, BlockFault::Alone { found: "UNIT", missing: END_OF_UNIT });
        if let Some(block) = self.blocks.get_mut(block) {
            block.body = body;
        }
    }

    /// Says which branches have no end, and refuses them.
    fn end_branches(&mut self, and_subprogram: bool) {
        self.end_unit();
        let unended: Vec<Unended> = self.branches.end(and_subprogram, &mut self.blocks);
        for (block, reason) in unended {
            let line = self.blocks.get(block).map_or(0, |block| block.lines.start);
            let start = Line::of(self.source.line(line)).map_or(0, |parts| parts.start);
            self.refuse(line, start, reason);
        }
    }

    /// Counts the text of formulas and long blocks; too much is an error.
    fn weigh(&mut self, code: &str) -> Result<(), Stop> {
        let fail = |reason| Err(Stop { at: 0, reason });
        if LONGEST < code.len() {
            return fail(BlockFault::TooLong { most: LONGEST });
        }
        self.weight.count(std::iter::once(code.len()), code.contains(['#', '('])).or_else(fail)
    }

    /// Looks back at the whole program: what is missing, and its unit.
    fn end(&mut self) {
        self.end_branches(true);
        let last = self.blocks.last().map_or(0, |block| block.lines.start);
        let is_whole = self.is_subprogram_file();
        if !self.has_machining && !is_whole {
            self.source.warn(last, 0, ProgramWarningKind::NoSection { section: MACHINING });
        }
        if !self.has_end {
            self.source.warn(last, 0, ProgramWarningKind::NoSection { section: END });
        }
        if self.unit.is_none() && !is_whole {
            let begin = self.blocks.iter().find(|block| matches!(block.body, Body::Begin { .. }));
            let line = begin.map_or(0, |block| block.lines.start);
            self.source.warn(line, 0, ProgramWarningKind::NoUnit);
        }
        for block in &mut self.blocks {
            if let (Body::Begin { unit, .. } | Body::End { unit, .. }, Some(found)) = (&mut block.body, self.unit) {
                *unit = found;
            }
        }
    }
}

/// Whether a line of data begins a subprogram.
fn is_subprogram(code: &str) -> bool {
    Cursor::of(code, Notation::DinPlus).take_word("SUBPROGRAM")
}

/// Whether a block has a G function that shifts, turns or mirrors the system, or chooses another workpiece: their numbers are general
/// knowledge.
fn shifts(code: &str) -> bool {
    code.split('G').skip(1).any(|behind| {
        let number: String = behind.chars().take_while(char::is_ascii_digit).collect();
        number.parse().is_ok_and(|number: u32| matches!(number, 49 | 51 | 53..=59 | 99 | 120 | 121 | 152))
    })
}

/// A fault in the words of lathe controls.
fn of_lathes(reason: BlockFault) -> BlockFault {
    let of = |wanted| match wanted {
        ExpectedWord::Value => ExpectedWord::ValueOrVariable,
        ExpectedWord::Parameter | ExpectedWord::NumberParameter | ExpectedWord::TextParameter => ExpectedWord::Variable,
        other => other,
    };
    match reason {
        BlockFault::Missing(wanted) => BlockFault::Missing(of(wanted)),
        BlockFault::Unexpected { wanted, found } => BlockFault::Unexpected { wanted: of(wanted), found },
        other => other,
    }
}
