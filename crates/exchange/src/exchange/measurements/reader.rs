//! Rows whose columns are known: each is judged, refused, or told about.

use super::time::{date_time, has_offset};
use crate::exchange::cell::{Cells as _, joined};
use crate::exchange::claim::{Claim, ClaimAnswer};
use crate::exchange::column::listed;
use crate::exchange::columns::Columns;
use crate::exchange::delimited::{Item, Rows, lines};
use crate::exchange::error::{ImportErrorKind, ImportWarningKind};
use crate::exchange::evidence::marks_simulation;
use crate::exchange::given::shorten;
use crate::exchange::imported::{Sink, Unjudged};
use crate::exchange::index::LONGEST_ROW;
use crate::exchange::refused::{Cell, Refused};
use crate::exchange::remarks::Heard;
use crate::exchange::rules::{RowMeasurement, Rules};
use crate::exchange::size::{Size, SizesOf};
use crate::exchange::source::Context;
use crate::exchange::{Labels, cells, left_out, stated, words};
use crate::journal::Record;
use csv::StringRecord;
use fitcheck_core::length::Length;
use fitcheck_core::message::FilePlace;
use fitcheck_core::probing::{Measurement, Origin};
use fitcheck_core::text::Within as _;
use jiff::civil::DateTime;
use std::sync::Arc;

/// No cell.
pub(super) const NOTHING: Cell<'_> = Cell { at: None, text: "" };

/// Reads rows, one after the other.
pub(super) struct Reader<'a, 's, 'z> {
    source: &'a Context<'a>,
    columns: &'a Columns,
    separator: u8,
    has_plan: bool,
    pub(super) sink: &'a mut Sink<'s>,
    /// Whether the row is the last one and has no line end.
    is_open: bool,
    /// Whether the mark of a simulation stands above it.
    is_simulated: bool,
    /// Where sizes go, if they alone are wanted.
    pub(super) sizes: Option<SizesOf<'z>>,
    nominal: Nominal,
    /// The line that names other columns: what is below it is not known.
    renamed: Option<usize>,
    /// What remarks have said so far.
    heard: Heard,
}

/// How many values were judged, and how many of them are exactly the nominal size.
#[derive(Default)]
struct Nominal {
    judged: usize,
    exact: usize,
}

impl<'a, 's, 'z> Reader<'a, 's, 'z> {
    pub(super) fn new(
        source: &'a Context<'a>,
        (columns, separator, has_plan): (&'a Columns, u8, bool),
        sink: &'a mut Sink<'s>,
    ) -> Self {
        let is_open = false;
        let is_simulated = false;
        let sizes = None;
        let nominal = Nominal::default();
        let renamed = None;
        let heard = Heard::default();
        Self { source, columns, separator, has_plan, sink, is_open, is_simulated, sizes, nominal, renamed, heard }
    }

    /// The same for sizes alone, where they are wanted.
    pub(super) fn of(self, sizes: Option<SizesOf<'z>>) -> Self {
        Self { sizes, ..self }
    }

    /// Reads some rows, and gives the number of the line after them; `None` where no more are wanted.
    pub(super) fn rows(&mut self, rows: &mut Rows<'_>) -> Option<usize> {
        let mut next = rows.next();
        while let Some(item) = next {
            if self.sink.is_full(item.line()) {
                return None;
            }
            next = rows.next();
            self.is_open = next.is_none() && rows.is_open();
            match item {
                Item::Lines { line, text, cells } if self.columns.hides_rows(&cells, self.separator) => {
                    self.torn(line, text);
                }
                Item::Row { line, cells } | Item::Lines { line, cells, .. } => self.row(line, &cells),
                Item::OpenQuote { line, text } => {
                    self.refuse(line, Cell { at: None, text }, ImportErrorKind::OpenQuote);
                }
                Item::TooLong { line } => {
                    self.refuse(line, NOTHING, ImportErrorKind::RowTooLong { most: LONGEST_ROW >> 10 });
                }
            }
        }
        Some(rows.next_line())
    }

    /// A row with such lines: none of them has a verdict.
    fn torn(&mut self, first: usize, text: &str) {
        for (line, from, to) in lines(text, 0, first) {
            let reason = if line == first { ImportErrorKind::OpenQuote } else { ImportErrorKind::WithinQuotes };
            self.refuse(line, Cell { at: None, text: text.within(from..to) }, reason);
        }
    }

    pub(super) fn warn_of_columns(&mut self, first_line: usize) {
        let line = self.columns.header.unwrap_or(first_line);
        if let Some((line, reason)) = self.columns.stated.told(self.columns.measured) {
            self.warn(line, reason);
        }
        if let Some((line, said)) = &self.columns.head.said {
            self.warn(*line, ImportWarningKind::HeadRead { said: said.clone() });
        }
        if self.columns.own.are_corrected() {
            self.warn(line, ImportWarningKind::Corrected);
        }
        if self.columns.own.have_rule() {
            self.warn(line, ImportWarningKind::OtherRule);
        }
        if !self.columns.ignored.is_empty() {
            let columns = listed(&self.columns.ignored);
            self.warn(line, ImportWarningKind::IgnoredColumns { columns });
        }
        for kind in self.columns.taken_as_sizes() {
            self.warn(line, kind);
        }
    }

    /// Tells that nobody may have measured: a drawing's list of sizes passes every limit of H and h.
    pub(super) fn tell_all_nominal(&mut self, first_line: usize) {
        let Nominal { judged, exact } = self.nominal;
        if 1 < judged && judged == exact {
            let line = self.columns.header.unwrap_or(first_line);
            self.warn(line, ImportWarningKind::AllNominal { count: judged });
        }
    }

    fn warn(&mut self, line: usize, reason: ImportWarningKind) {
        self.sink.warn(FilePlace::line(line), None, reason);
    }

    fn warn_row(&mut self, line: usize, reason: ImportWarningKind) {
        self.sink.warn(FilePlace::line(line), Some(line), reason);
    }

    pub(super) fn refuse(&mut self, line: usize, cell: Cell<'_>, reason: ImportErrorKind) {
        let given = shorten(cell.text.trim());
        self.sink.refuse(FilePlace { column: cell.at.map(|at| at + 1), ..FilePlace::line(line) }, reason, given);
    }

    pub(super) fn row(&mut self, line: usize, cells: &StringRecord) {
        if cells::is_blank(cells) || self.columns.stated.is_row_of_units(cells) {
            return;
        }
        if marks_simulation(cells) {
            self.is_simulated = true;
            return;
        }
        let stray = || stated::stray(self.columns, cells);
        if cells::is_comment(cells) {
            if let Some(reason) = stray() {
                return self.refuse(line, Cell { at: None, text: cells.cell(0) }, reason);
            }
            if let Some(told) = self.said_against(line, cells) {
                self.warn(line, told);
            }
            let rules = self.rules();
            let hides = match &self.sizes {
                Some(sizes) => rules.hides_size(cells, sizes.feature),
                None => rules.hides_measurement(cells),
            };
            if !hides {
                return;
            }
            if self.columns.header.is_some_and(|header| line < header) {
                return self.warn(line, ImportWarningKind::Comment);
            }
            let cell = Cell { at: None, text: cells.cell(0) };
            return self.refuse(line, cell, ImportErrorKind::Comment);
        }
        match self.columns.header {
            Some(header) if line == header && self.columns.names_known => return,
            Some(_) if self.columns.top == Some(line) => return,
            _ if self.columns.stated.told(self.columns.measured).is_some_and(|(told, _)| told == line) => {
                let told = self.said_against(line, cells);
                return told.into_iter().for_each(|told| self.warn(line, told));
            }
            Some(header) if line <= header => return self.not_used(line, cells),
            _ if self.columns.first.is_some_and(|first| line < first) => return self.not_used(line, cells),
            _ => {}
        }
        if let Some(header) = self.renamed {
            return self.refuse(line, NOTHING, ImportErrorKind::BelowOtherHeader { line: header });
        }
        for columns in self.columns.of_values(cells) {
            self.value(line, cells, columns);
        }
    }

    /// Reads a value of a row by these columns.
    fn value(&mut self, line: usize, cells: &StringRecord, columns: &'a Columns) {
        let all = std::mem::replace(&mut self.columns, columns);
        let read = if self.sizes.is_some() { self.size(line, cells) } else { self.measurement(line, cells) };
        self.columns = all;
        if let Err((cell, reason)) = read {
            let stray = || stated::stray(self.columns, cells);
            if words::is_summary(cells) {
                return self.not_used(line, cells);
            }
            if self.columns.stated.repeats_names(cells) {
                return self.not_used(line, cells);
            }
            if self.columns.are_renamed_by(cells) {
                self.renamed = Some(line);
                return self.refuse(line, cell, ImportErrorKind::OtherHeader);
            }
            self.refuse(line, cell, stray().unwrap_or(reason));
        }
    }

    /// Tells that a line is not used, or what it says against the values.
    fn not_used(&mut self, line: usize, cells: &StringRecord) {
        let counted = self.columns.counted_at(line, self.source.counted);
        if let Some(told) = left_out::said_against(cells, counted) {
            return self.warn(line, told);
        }
        // What the head of the table has of it is told already.
        let rest = self.columns.head.rest(line, cells);
        if !cells::is_blank(&rest) {
            self.warn(line, left_out::not_used(&rest, counted));
        }
    }

    /// What a line that is no row says against the values.
    fn said_against(&self, line: usize, cells: &StringRecord) -> Option<ImportWarningKind> {
        left_out::said_against(cells, self.columns.counted_at(line, self.source.counted))
    }

    /// Takes the size of a row, or names the cell that cannot be used.
    fn size<'c>(&mut self, line: usize, cells: &'c StringRecord) -> Result<(), Refused<'c>> {
        let rules = self.rules();
        let Some(sizes) = &self.sizes else { return Ok(()) };
        let RowMeasurement { measured, is_simulated, .. } = rules.size(cells, sizes.feature)?;
        let id = cells.cell(self.columns.id).trim().to_owned();
        if let Some(claim) = self.columns.claims(cells, &mut self.heard).into_iter().find(Claim::is_rejection) {
            return Err((NOTHING, ImportErrorKind::Rejected { given: claim.said().to_owned() }));
        }
        if words::is_of_several_parts(&id) {
            let cell = Cell { at: self.columns.id, text: cells.cell(self.columns.id) };
            return Err((cell, ImportErrorKind::NoPart { given: shorten(&id) }));
        }
        self.tell_cut_off(line, cells);
        let is_simulated = is_simulated || self.is_simulated;
        let Some(sizes) = &mut self.sizes else { return Ok(()) };
        self.sink.count();
        (sizes.take)(Size { line, id, measured, is_simulated });
        Ok(())
    }

    /// Tells that the end of the file may have cut off a row.
    fn tell_cut_off(&mut self, line: usize, cells: &StringRecord) {
        if let Some(reason) = self.rules().cut_off(cells).filter(|_| self.is_open) {
            self.warn_row(line, reason);
        }
    }

    fn rules(&self) -> Rules<'a> {
        let Context { sources, lookup, .. } = self.source;
        let has_commas = self.separator == b',';
        let has_plan = self.has_plan;
        let file = &self.source.file;
        Rules { columns: self.columns, has_commas, sources, has_plan, lookup: Some(lookup), file }
    }

    /// Judges a row and keeps it, or names the cell that cannot be used.
    pub(super) fn measurement<'c>(&mut self, line: usize, cells: &'c StringRecord) -> Result<(), Refused<'c>> {
        let RowMeasurement { measured, is_length, asked, said, is_simulated, quantity } = self.rules().read(cells)?;
        let id = cells.cell(self.columns.id).trim().to_owned();
        self.tell_cut_off(line, cells);
        let time = self.time(line, cells);
        let file = Arc::clone(&self.source.file);
        let origin = if is_simulated || self.is_simulated {
            Origin::ImportedSimulation { file }
        } else {
            Origin::Imported { file }
        };
        let correction = self.columns.own.correction(cells, measured)?;
        let (callout, limits) = match asked {
            Ok(asked) => asked,
            Err(why) => {
                let labels = Labels { quantity, ..self.labels(line, cells) };
                let asked = said;
                let measured = is_length.then_some(measured);
                let position = None;
                let unjudged = Unjudged { line, id, labels, time, measured, origin, position, asked, correction, why };
                self.sink.set_aside(unjudged);
                return Ok(());
            }
        };
        let measurement = Measurement::of_diameter(measured, origin);
        let record = Record::judged(time, id, callout, limits, measurement, None);
        let labels = Labels { quantity, ..self.labels(line, cells) };
        self.nominal.judged += 1;
        self.nominal.exact += usize::from(record.measurement.diameter == record.limits.nominal);
        let answer = ClaimAnswer::of(&record);
        for warning in labels.claims.iter().filter_map(|claim| claim.tells(&answer)) {
            self.warn_row(line, warning);
        }
        self.sink.keep(line, Record { correction, ..record }, labels);
        Ok(())
    }

    /// What else a row says of its value.
    fn labels(&mut self, line: usize, cells: &StringRecord) -> Labels {
        let columns = &self.columns.labels;
        let text = |at: usize| cells.cell(at).trim();
        let label = |at: Option<usize>| cells.cell(at).trim().to_owned();
        let head = &self.columns.head;
        let or_head = |at: Option<usize>, of_all: &str| {
            Some(label(at)).filter(|own| !own.is_empty()).unwrap_or_else(|| of_all.to_owned())
        };
        let place = columns.place.map(|column| {
            let column = column.filter(|column| !text(column.at).is_empty())?;
            let given = shorten(text(column.at));
            let length = Length::parse_in(&given, self.columns.stated.of_place(column, cells)).ok();
            if length.is_none() {
                let place = FilePlace::in_line(line, column.at + 1);
                self.sink.warn(place, Some(line), ImportWarningKind::Place { given });
            }
            length
        });
        Labels {
            number: label(columns.number),
            part: or_head(columns.part, &head.part),
            serial: or_head(columns.serial, &head.serial),
            sample: self.columns.sample.clone(),
            who: or_head(columns.who, &head.who),
            machine: or_head(columns.machine, &head.machine),
            batch: or_head(columns.batch, &head.batch),
            claims: self
                .columns
                .claims(cells, &mut self.heard)
                .into_iter()
                .chain(
                    self.columns
                        .limits
                        .iter()
                        .filter(|_| self.has_plan)
                        .flat_map(|limits| limits.claims(cells, &self.columns.stated)),
                )
                .map(|claim| claim.from(self.source.counted))
                .collect(),
            place,
            is_corrected: self.columns.evidence.is_corrected(cells),
            may_be_running: self.columns.labels.may_be_running,
            ..Labels::default()
        }
    }

    /// The time of a row, or the time of import with a warning.
    fn time(&mut self, line: usize, cells: &StringRecord) -> DateTime {
        let given = joined(self.columns.time.iter().filter_map(|&at| cells.get(at)));
        let read = date_time(&given);
        let reason = match read {
            _ if self.columns.time.is_empty() => None,
            None if given.is_empty() => Some(ImportWarningKind::NoTime),
            None => Some(ImportWarningKind::Time { given: shorten(&given) }),
            Some(_) if has_offset(&given) => Some(ImportWarningKind::Offset { given: shorten(&given) }),
            Some(_) => None,
        };
        if let Some(reason) = reason {
            self.warn_row(line, reason);
        }
        read.or(self.columns.head.time).unwrap_or(self.source.now)
    }
}
