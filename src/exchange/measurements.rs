//! CSV of id, callout and measured value, with or without a header.
//!
//! Separator, decimal sign and columns are detected; what could be meant in two ways is refused. The whole file is in
//! memory, so the caller bounds its size ([`crate::files::LARGEST`]); the number of rows is bounded here.

use std::sync::Arc;

use csv::StringRecord;
use jiff::civil::{DateTime, Time};

use super::cells;
use super::columns::{self, Columns, Sample};
use super::delimited::{Item, LONGEST_ROW, Rows, without_separator_line};
use super::error::{ImportErrorKind, ImportWarningKind, shorten};
use super::imported::{Sink, Unjudged, WhyUnjudged};
use super::rules::{Cell, Found, Refused, Rules};
use super::sizes::{Size, SizesOf};
use super::{Format, Source};
use crate::journal::Record;
use crate::message::Place;
use crate::probing::{Measurement, Origin};

pub(super) const FORMAT: Format = Format {
    name: "measurements",
    endings: &["csv", "tsv", "txt"],
    description: "exchange-format-measurements",
    recognises: |source| is_text(&source.head()),
    read,
};

/// Text, not arbitrary bytes: at most one of fifty characters is a control character.
fn is_text(head: &str) -> bool {
    let odd = head.chars().filter(|c| c.is_control() && !"\t\r\n".contains(*c)).count();
    odd * 50 <= head.chars().count()
}

fn read(source: &Source<'_>, sink: &mut Sink<'_>) {
    read_rows(source, sink, None);
}

/// Reads the measured sizes alone: limits are not looked up.
pub(super) fn read_sizes(source: &Source<'_>, sink: &mut Sink<'_>, sizes: SizesOf<'_>) {
    read_rows(source, sink, Some(sizes));
}

fn read_rows(source: &Source<'_>, sink: &mut Sink<'_>, sizes: Option<SizesOf<'_>>) {
    let text = source.text();
    let (text, first_line, separator) = without_separator_line(&text);
    let sample = Sample::of(text, first_line, separator);
    let columns = match sample.columns() {
        Ok(columns) => columns,
        Err(reason) => return sink.fail(reason),
    };
    let separator = sample.separator;
    // The first rows are read once more with the rest.
    drop(sample);
    let mut reader = Reader { source, columns: &columns, separator, sink, is_open: false, sizes };
    reader.warn_of_columns(first_line);
    let nothing = Cell { at: None, text: "" };
    let has_end = text.ends_with(['\n', '\r']);
    let mut rows = Rows::new(text, first_line, separator).peekable();
    while let Some(item) = rows.next() {
        if reader.sink.is_full(item.line()) {
            break;
        }
        reader.is_open = !has_end && rows.peek().is_none();
        match item {
            Item::Row { line, cells } => reader.row(line, &cells),
            Item::OpenQuote { line, text } => reader.refuse(line, Cell { at: None, text }, ImportErrorKind::OpenQuote),
            Item::TooLong { line } => {
                reader.refuse(line, nothing, ImportErrorKind::RowTooLong { most: LONGEST_ROW >> 10 });
            }
        }
    }
    if reader.sink.rows() == 0 {
        reader.refuse(first_line, nothing, ImportErrorKind::NoRows);
    }
}

/// Reads a single row whose columns are known, as one of a whole file.
pub(super) fn read_row(
    source: &Source<'_>,
    (columns, separator): (&Columns, u8),
    (line, cells): (usize, &StringRecord),
    sink: &mut Sink<'_>,
) {
    let mut reader = Reader { source, columns, separator, sink, is_open: false, sizes: None };
    if let Err((cell, reason)) = reader.measurement(line, cells) {
        reader.refuse(line, cell, reason);
    }
}

struct Reader<'a, 's, 'z> {
    source: &'a Source<'a>,
    columns: &'a Columns,
    separator: u8,
    sink: &'a mut Sink<'s>,
    /// Whether the row is the last one and has no line end.
    is_open: bool,
    /// Where sizes go, if they alone are wanted.
    sizes: Option<SizesOf<'z>>,
}

impl<'a> Reader<'a, '_, '_> {
    fn warn_of_columns(&mut self, first_line: usize) {
        let line = self.columns.header.unwrap_or(first_line);
        if self.columns.own.are_corrected() {
            self.warn(line, ImportWarningKind::Corrected);
        }
        if self.columns.own.have_rule() {
            self.warn(line, ImportWarningKind::OtherRule);
        }
        if !self.columns.ignored.is_empty() {
            let columns = columns::listed(&self.columns.ignored);
            self.warn(line, ImportWarningKind::IgnoredColumns { columns });
        }
    }

    fn warn(&mut self, line: usize, reason: ImportWarningKind) {
        self.sink.warn(Place::line(line), None, reason);
    }

    fn refuse(&mut self, line: usize, cell: Cell<'_>, reason: ImportErrorKind) {
        let given = shorten(cell.text.trim());
        self.sink.refuse(Place { column: cell.at.map(|at| at + 1), ..Place::line(line) }, reason, given);
    }

    fn row(&mut self, line: usize, cells: &StringRecord) {
        if cells::is_blank(cells) {
            return;
        }
        if cells::is_comment(cells) {
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
            let cell = Cell { at: None, text: cells.get(0).unwrap_or_default() };
            return self.refuse(line, cell, ImportErrorKind::Comment);
        }
        match self.columns.header {
            Some(header) if line == header && self.columns.names_known => return,
            Some(header) if line <= header => return self.warn(line, ImportWarningKind::not_used(cells)),
            _ => {}
        }
        let read = if self.sizes.is_some() { self.size(line, cells) } else { self.measurement(line, cells) };
        if let Err((cell, reason)) = read {
            self.refuse(line, cell, reason);
        }
    }

    /// Takes the size of a row, or names the cell that cannot be used.
    fn size<'c>(&mut self, line: usize, cells: &'c StringRecord) -> Result<(), Refused<'c>> {
        let rules = self.rules();
        let Some(sizes) = &mut self.sizes else { return Ok(()) };
        let Found { measured, is_simulated, .. } = rules.size(cells, sizes.feature)?;
        let id = self.columns.id.and_then(|at| cells.get(at)).unwrap_or_default().trim().to_owned();
        self.sink.count();
        (sizes.take)(Size { line, id, measured, is_simulated });
        Ok(())
    }

    fn rules(&self) -> Rules<'a> {
        Rules { columns: self.columns, has_commas: self.separator == b',', sources: self.source.sources }
    }

    /// Judges a row and keeps it, or names the cell that cannot be used.
    fn measurement<'c>(&mut self, line: usize, cells: &'c StringRecord) -> Result<(), Refused<'c>> {
        let Found { measured, asked, is_simulated } = self.rules().read(cells)?;
        let id = self.columns.id.and_then(|at| cells.get(at)).unwrap_or_default().trim().to_owned();
        if let Some(given) = self.rules().cut_off(cells).filter(|_| self.is_open) {
            let reason = ImportWarningKind::CutOff { given: shorten(given) };
            self.sink.warn(Place::line(line), Some(line), reason);
        }
        let time = self.time(line, cells);
        let Some((callout, limits)) = asked else {
            let why = WhyUnjudged::NoCallout;
            self.sink.set_aside(Unjudged { line, id, time, measured: Some(measured), position: None, why });
            return Ok(());
        };
        let file = Arc::clone(&self.source.file);
        let origin = if is_simulated { Origin::ImportedSimulation { file } } else { Origin::Imported { file } };
        let measurement = Measurement::of_diameter(measured, origin);
        let correction = self.columns.own.correction(cells, measured)?;
        let record = Record::judged(time, id, Some(callout), limits, measurement, None);
        self.sink.keep(line, Record { correction, ..record });
        Ok(())
    }

    /// The time of a row, or the time of import with a warning.
    fn time(&mut self, line: usize, cells: &StringRecord) -> DateTime {
        let texts = self.columns.time.iter().filter_map(|&at| cells.get(at)).map(str::trim);
        let given = texts.filter(|text| !text.is_empty()).collect::<Vec<_>>().join(" ");
        let read = date_time(&given);
        let reason = match read {
            _ if self.columns.time.is_empty() => None,
            None if given.is_empty() => Some(ImportWarningKind::NoTime),
            None => Some(ImportWarningKind::Time { given: shorten(&given) }),
            Some(_) if has_offset(&given) => Some(ImportWarningKind::Offset { given: shorten(&given) }),
            Some(_) => None,
        };
        if let Some(reason) = reason {
            self.sink.warn(Place::line(line), Some(line), reason);
        }
        read.unwrap_or(self.source.now)
    }
}

/// Whether a date and time says how far it is from UTC, or in which time zone it is.
fn has_offset(given: &str) -> bool {
    let time = given.split_once(['T', 't', ' ']).map_or("", |(_, time)| time);
    given.contains('[') || time.contains(['+', '-', '\u{2212}'])
}

/// `2024-03-14 08:05:09` as in ISO 8601 (the time is optional), or day first: `14.3.2024 8:05`.
fn date_time(given: &str) -> Option<DateTime> {
    if let Ok(time) = given.parse() {
        return Some(time);
    }
    let (day, time) = given.split_once([' ', 'T']).unwrap_or((given, "0:00"));
    let mut parts = day.split(['-', '.']);
    let (day, month, year) = (parts.next()?, parts.next()?, parts.next()?);
    let year = year.parse().ok().filter(|year| 1000 <= *year)?;
    let date = jiff::civil::Date::new(year, month.parse().ok()?, day.parse().ok()?).ok()?;
    let mut parts = time.trim().split(':');
    let (hour, minute) = (parts.next()?.parse().ok()?, parts.next()?.parse().ok()?);
    let second = parts.next().map_or(Some(0), |second| second.parse().ok())?;
    Some(date.to_datetime(Time::new(hour, minute, second, 0).ok()?))
}
