//! CSV of id, callout and measured value, with or without a header.
//!
//! Separator, decimal sign and columns are detected; what could be meant in two ways is refused. The whole file is in
//! memory, so the caller bounds its size ([`crate::files::LARGEST`]); the number of rows is bounded here.

use std::sync::Arc;

use csv::StringRecord;
use jiff::civil::{DateTime, Time};

use super::columns::{self, Columns, LengthColumn, Sample};
use super::delimited::{Item, LONGEST_ROW, Rows};
use super::error::{ImportErrorKind, ImportWarningKind, shorten};
use super::imported::{Sink, Unjudged, WhyUnjudged};
use super::{Format, Source};
use crate::journal::Record;
use crate::length::Length;
use crate::message::Place;
use crate::probing::{Measurement, Origin};
use crate::tolerance::{Callout, CalloutError};

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
    let mut reader = Reader { source, columns, separator, sink };
    reader.warn_of_columns(first_line);
    let nothing = Cell { at: None, text: "" };
    for item in Rows::new(text, first_line, separator) {
        if reader.sink.is_full(item.line()) {
            break;
        }
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

/// The text after a line `sep=;`, which spreadsheets put first.
fn without_separator_line(text: &str) -> (&str, usize, Option<u8>) {
    let separator =
        text.get(..4).filter(|start| start.eq_ignore_ascii_case("sep=")).and_then(|_| text.as_bytes().get(4));
    let (Some(&separator), Some(rest)) = (separator, text.get(5..)) else { return (text, 1, None) };
    match rest.strip_prefix("\r\n").or_else(|| rest.strip_prefix(['\n', '\r'])) {
        Some(rest) if separator.is_ascii() => (rest, 2, Some(separator)),
        _ => (text, 1, None),
    }
}

struct Reader<'a, 's> {
    source: &'a Source<'a>,
    columns: Columns,
    separator: u8,
    sink: &'a mut Sink<'s>,
}

/// A cell and its place in the row, from 0.
#[derive(Debug, Clone, Copy)]
struct Cell<'a> {
    at: Option<usize>,
    text: &'a str,
}

/// A cell that cannot be used.
type Refused<'a> = (Cell<'a>, ImportErrorKind);

impl Reader<'_, '_> {
    fn warn_of_columns(&mut self, first_line: usize) {
        let line = self.columns.header.unwrap_or(first_line);
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
        if columns::is_blank(cells) {
            return;
        }
        if columns::is_comment(cells) {
            if columns::is_data(cells) {
                self.warn(line, ImportWarningKind::Comment);
            }
            return;
        }
        match self.columns.header {
            Some(header) if line == header && self.columns.names_known => return,
            Some(header) if line <= header => {
                let text = cells.iter().map(str::trim).filter(|cell| !cell.is_empty()).collect::<Vec<_>>().join(" ");
                return self.warn(line, ImportWarningKind::NotUsed { text: shorten(&text) });
            }
            _ => {}
        }
        if let Err((cell, reason)) = self.measurement(line, cells) {
            self.refuse(line, cell, reason);
        }
    }

    /// Judges a row and keeps it, or names the cell that cannot be used.
    fn measurement<'c>(&mut self, line: usize, cells: &'c StringRecord) -> Result<(), Refused<'c>> {
        self.right_length(cells)?;
        let measured = self.measured(cells)?;
        let callout = self.callout(cells, measured)?;
        let id = self.columns.id.and_then(|at| cells.get(at)).unwrap_or_default().trim().to_owned();
        let Some((callout, cell)) = callout else {
            let time = self.time(line, cells);
            let why = WhyUnjudged::NoCallout;
            self.sink.set_aside(Unjudged { line, id, time, measured: Some(measured), position: None, why });
            return Ok(());
        };
        let limits =
            self.source.sources.limits(&callout, None).map_err(|error| (cell, ImportErrorKind::Limits(error)))?;
        let measurement = Measurement::of_diameter(measured, self.origin(cells)?);
        let record = Record::judged(self.time(line, cells), id, Some(callout), limits, measurement, None);
        self.sink.keep(line, record);
        Ok(())
    }

    /// There must be enough cells for what is needed, and none beyond the columns.
    fn right_length<'c>(&self, cells: &'c StringRecord) -> Result<(), Refused<'c>> {
        let expected = self.columns.count;
        let found = cells.len();
        if let Some((at, text)) = cells.iter().enumerate().skip(expected).find(|(_, cell)| !cell.trim().is_empty()) {
            return Err((Cell { at: Some(at), text }, ImportErrorKind::RowLong { found, expected }));
        }
        let needed = self.columns.tolerance.into_iter().chain([self.columns.measured.at]).max().unwrap_or_default();
        if found <= needed {
            return Err((
                Cell { at: None, text: cells.iter().next_back().unwrap_or_default() },
                ImportErrorKind::RowShort { found, expected },
            ));
        }
        Ok(())
    }

    fn measured<'c>(&self, cells: &'c StringRecord) -> Result<Length, Refused<'c>> {
        let (cell, measured) = length(cells, self.columns.measured, ImportErrorKind::Measured)?;
        let given = || shorten(cell.text);
        if let Some(sign) = self.columns.decimal_sign
            && cell.text.contains(if sign == '.' { ',' } else { '.' })
        {
            return Err((cell, ImportErrorKind::DecimalSign { given: given(), sign }));
        }
        // 25,012 between separating commas: 25 in this column and 012 in the next one.
        let behind = cells.get(self.columns.measured.at + 1).filter(|behind| columns::is_whole(behind));
        if let Some(behind) = behind
            && self.separator == b','
            && columns::is_whole(cell.text)
            && !self.columns.whole_numbers_behind
        {
            let joined = format!("{},{}", given(), shorten(behind.trim()));
            return Err((cell, ImportErrorKind::DecimalComma { joined }));
        }
        if measured <= Length::ZERO {
            return Err((cell, ImportErrorKind::NotPositive { given: given() }));
        }
        Ok(measured)
    }

    /// The callout of a row and its cell; `None` where the cell is empty or there is no such column.
    fn callout<'c>(
        &self,
        cells: &'c StringRecord,
        measured: Length,
    ) -> Result<Option<(Callout, Cell<'c>)>, Refused<'c>> {
        let Some(at) = self.columns.tolerance else { return Ok(None) };
        let text = cells.get(at).unwrap_or_default().trim();
        let cell = Cell { at: Some(at), text };
        if text.is_empty() {
            return Ok(None);
        }
        let begins_with_letter = text.starts_with(|c: char| c.is_ascii_alphabetic());
        let given = shorten(text);
        let nominal = match self.columns.nominal {
            Some(column) if begins_with_letter || !is_blank(cells, column.at) => {
                Some(length(cells, column, ImportErrorKind::Nominal)?)
            }
            _ => None,
        };
        let read = match nominal {
            Some((_, nominal)) if begins_with_letter => {
                given.parse().map_err(CalloutError::from).and_then(|class| Callout::new(nominal, class))
            }
            _ => given.parse::<Callout>(),
        };
        let callout = read.map_err(|error| (cell, ImportErrorKind::Callout(error)))?;
        if let Some((_, nominal)) = nominal.filter(|(_, nominal)| *nominal != callout.nominal()) {
            return Err((cell, ImportErrorKind::NominalDiffers { callout, nominal }));
        }
        self.one_callout(cells, cell, callout, measured)?;
        Ok(Some((callout, cell)))
    }

    /// `25,5 H7,25.512` without a header is 5 H7 of part 25, or 25,5 H7. The measured value shows the doubt.
    fn one_callout<'c>(
        &self,
        cells: &'c StringRecord,
        cell: Cell<'c>,
        callout: Callout,
        measured: Length,
    ) -> Result<(), Refused<'c>> {
        if self.columns.names_known || self.separator != b',' {
            return Ok(());
        }
        let Some(before) = cell.at.and_then(|at| at.checked_sub(1)).and_then(|at| cells.get(at)) else { return Ok(()) };
        let joined = format!("{},{}", before.trim(), cell.text);
        let Ok(other) = joined.parse::<Callout>() else { return Ok(()) };
        let off = |nominal: Length| measured.saturating_sub(nominal).abs();
        if off(other.nominal()) < off(callout.nominal()) {
            return Err((cell, ImportErrorKind::DecimalComma { joined: shorten(&joined) }));
        }
        Ok(())
    }

    /// The file; a value that it calls simulated stays so.
    fn origin<'c>(&self, cells: &'c StringRecord) -> Result<Origin, Refused<'c>> {
        let file = Arc::clone(&self.source.file);
        let text = self.columns.simulated.and_then(|at| cells.get(at)).unwrap_or_default().trim();
        match text.to_ascii_lowercase().as_str() {
            "" | "false" => Ok(Origin::Imported { file }),
            "true" => Ok(Origin::ImportedSimulation { file }),
            _ => Err((Cell { at: self.columns.simulated, text }, ImportErrorKind::Simulated { given: shorten(text) })),
        }
    }

    /// The time of a row, or the time of import with a warning.
    fn time(&mut self, line: usize, cells: &StringRecord) -> DateTime {
        let texts = self.columns.time.iter().filter_map(|&at| cells.get(at)).map(str::trim);
        let given = texts.filter(|text| !text.is_empty()).collect::<Vec<_>>().join(" ");
        if given.is_empty() {
            return self.source.now;
        }
        date_time(&given).unwrap_or_else(|| {
            let reason = ImportWarningKind::Time { given: shorten(&given) };
            self.sink.warn(Place::line(line), Some(line), reason);
            self.source.now
        })
    }
}

fn is_blank(cells: &StringRecord, at: usize) -> bool {
    cells.get(at).is_none_or(|cell| cell.trim().is_empty())
}

fn length(
    cells: &StringRecord,
    column: LengthColumn,
    reason: fn(crate::length::LengthError) -> ImportErrorKind,
) -> Result<(Cell<'_>, Length), Refused<'_>> {
    let text = cells.get(column.at).unwrap_or_default().trim();
    let cell = Cell { at: Some(column.at), text };
    let length = Length::parse_in(&shorten(text), column.unit).map_err(|error| (cell, reason(error)))?;
    Ok((cell, length))
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
