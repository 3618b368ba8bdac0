//! Some rows of a block once more, with their cells: judged again by the same judge, so that nothing has to be kept.

use std::sync::Arc;

use csv::StringRecord;
use fitcheck_core::message::{Message, Say as _};
use fitcheck_core::tolerance::Sources;
use fitcheck_core::tolerance::fit::thermal::Temperature;
use jiff::civil::DateTime;

use super::court::StreamJudging;
use super::cut::Block;
use super::judge::Take;
use super::judged::Judged;
use super::layout::Layout;
use super::marks::{Part, RowFate};
use crate::exchange::cell::Cells as _;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::imported::{Imported, Sink, WhyUnjudged};
use crate::exchange::lookup::Lookup;
use crate::exchange::row::TextRow;
use crate::exchange::rules::Rules;
use crate::exchange::source::Context;
use crate::exchange::{cells, measurements, stated};

/// A row that was read again.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picked {
    /// Its number in the part, from 0.
    pub number: usize,
    /// Its line, from 0 at the stream's first row.
    pub line: usize,
    /// The cells as `import` reads them; of a line that cannot be split into cells, the line or its beginning.
    pub cells: Vec<String>,
    /// Its verdict; `None` where it has none.
    pub judged: Option<Judged>,
    /// Why it has none.
    pub why: Option<Message>,
    /// The name of its part or feature, and its callout as written; both are empty where there is none.
    pub named: [String; 2],
}

/// Reads rows of a part again from its bytes. `wanted` are their numbers in it, ascending. `None` where the bytes are not
/// those that were judged: another number of rows, or another verdict.
pub fn pick(bytes: Vec<u8>, part: &Part, wanted: &[usize], court: &StreamJudging<'_>) -> Option<Vec<Picked>> {
    if bytes.len() != part.bytes {
        return None;
    }
    let block = Block::again(bytes, court.layout().separator, part.broken);
    let mut picker = Picker { court, part, wanted, at: 0, line: 0, differs: false, picked: Vec::new() };
    court.judge().block(&block, &mut picker);
    (picker.at == part.len() && !picker.differs).then_some(picker.picked)
}

struct Picker<'a> {
    court: &'a StreamJudging<'a>,
    part: &'a Part,
    wanted: &'a [usize],
    /// The number of the next row.
    at: usize,
    line: usize,
    /// Whether a row has another verdict than before.
    differs: bool,
    picked: Vec<Picked>,
}

impl Picker<'_> {
    /// Counts a row; its number if it is wanted.
    fn next(&mut self, fate: RowFate) -> Option<usize> {
        let number = self.at;
        self.at += 1;
        self.differs |= self.part.row(number).is_none_or(|(before, _)| before != fate);
        self.wanted.binary_search(&number).ok().map(|_| number)
    }

    fn keep(&mut self, number: usize, cells: &StringRecord, judged: Option<Judged>, why: Option<Message>) {
        let columns = &self.court.layout().columns;
        let cell = |at: Option<usize>| shorten(cells.cell(at).trim());
        self.picked.push(Picked {
            number,
            line: self.part.line + self.line,
            cells: cells.iter().map(str::to_owned).collect(),
            judged,
            why,
            named: [cell(columns.id), cell(columns.tolerance)],
        });
    }

    /// Why a row of cells has no verdict.
    fn why(&self, cells: &StringRecord) -> Message {
        let court = self.court;
        let stray = || stated::stray(&court.layout().columns, cells);
        if cells::is_comment(cells) {
            return stray().unwrap_or(ImportErrorKind::Comment).message();
        }
        let rules = Rules {
            columns: &court.layout().columns,
            has_commas: court.layout().has_commas(),
            sources: court.sources(),
            lookup: None,
            has_plan: false,
            file: &court.file,
        };
        match rules.read(cells) {
            Err((_, reason)) => stray().unwrap_or(reason).message(),
            Ok(read) => read.asked.err().unwrap_or(WhyUnjudged::NoCallout).message(),
        }
    }
}

impl Take for Picker<'_> {
    fn at(&mut self, line: usize) {
        self.line = line;
    }

    fn judged(&mut self, row: &TextRow<'_>, judged: &Judged) {
        if let Some(number) = self.next(RowFate::Judged(judged.status)) {
            self.keep(number, &row.record(), Some(*judged), None);
        }
    }

    fn refused(&mut self, row: &TextRow<'_>, reason: &str) {
        if reason.is_empty() {
            return;
        }
        if let Some(number) = self.next(RowFate::NotJudged) {
            let cells = row.record();
            let why = self.why(&cells);
            self.keep(number, &cells, None, Some(why));
        }
    }

    fn broken(&mut self, line: &str, reason: &ImportErrorKind) {
        if let Some(number) = self.next(RowFate::NotJudged) {
            self.keep(number, &StringRecord::from(vec![line]), None, Some(reason.message()));
            if let Some(picked) = self.picked.last_mut() {
                picked.named = Default::default();
            }
        }
    }

    fn line(&mut self, _line: &[u8]) {}
}

impl Picked {
    /// What an import makes of this row: a record, or why there is none.
    pub fn imported(&self, layout: &Layout, file: &str, sources: &Sources, now: DateTime) -> Imported {
        let mut imported = Imported::default();
        let source =
            Context { file: Arc::from(file), sources, now, counted: Temperature::REFERENCE, lookup: Lookup::default() };
        let cells: StringRecord = self.cells.iter().collect();
        let mut keep = |item| imported.keep(item);
        let columns = (&layout.columns, layout.separator);
        measurements::read_row(&source, columns, (layout.line + self.line, &cells), &mut Sink::new(&mut keep));
        imported
    }
}
