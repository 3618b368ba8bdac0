//! Checks as CSV: one line per check, the same in every language.
//!
//! UTF-8, comma, LF, always a decimal point; a header names the columns and their units. `contacts` holds an array as
//! in the JSON, `[[x,y,z],…]` in millimetres; several `warnings` are separated by ` | `. Title, part and signature are
//! not included. `status` is the part's, as on the report: SCRAP where the centre is out of position; then `warnings`
//! has the status of the size alone.
//!
//! A spreadsheet reads a field that begins with `=`, `+`, `-` or `@` as a formula, and an id or a file name can hold
//! one. Such a text gets an apostrophe in front, as in a spreadsheet itself: it is shown as text and never computed.
//! Columns of numbers never get one, so a negative deviation stays a number. The same within a text behind a semicolon, a tab or a
//! line end, where another setting of the spreadsheet begins the next cell.

use std::borrow::Cow;
use std::io::{self, Write};

use fitcheck_core::length::{Length, Line};
use fitcheck_core::message::{guarded, is_formula};
use fitcheck_core::words::Words;

use super::part::PartSheet;
use super::{Holds, RenderError, Rendering, Report};
use crate::journal::Record;
use crate::row::ReportRow;
use crate::row::columns::{Cell as _, Column, cells, names};

pub const RENDERING: Rendering = Rendering {
    name: "csv",
    title: "CSV",
    is_for_people: false,
    holds: Holds::Checks,
    endings: &["csv"],
    render: render_report,
};

fn render_report(report: &Report, _words: &Words, out: &mut dyn Write) -> io::Result<()> {
    let more = report.checks.more()?;
    // The picture of the part is named beside every check of it.
    let picture = report.parts.iter().find_map(PartSheet::picture_name).map(harmless);
    let name = picture.as_ref().map(|_| PICTURE);
    line(names(&COLUMNS).into_iter().chain(more.names()).chain(name), out)?;
    report.checks.each(&mut |record| {
        let row = ReportRow::of(record);
        line(cells(&COLUMNS, &row).chain(more.of_row(&row)).chain(picture.clone()), out)
    })
}

/// The last column of a report of whole parts whose plan has a picture.
const PICTURE: &str = "picture";

/// The records as CSV, with a header, in their order.
pub fn render(records: &[Record]) -> Result<Vec<u8>, RenderError> {
    render_rows(records.iter().map(ReportRow::of), More::of(records))
}

/// Which columns a file has besides those of every file: only those that a check of it has.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct More(u8);

/// Columns, and which checks have them.
type Optional = (&'static [Column<ReportRow>], fn(&Record) -> bool);

/// Columns that a file may have, in their order.
const MORE: [Optional; 4] = [
    (&CORRECTED, |record| record.correction.is_some()),
    (&GUARDED, |record| !record.verdict.rule.is_plain()),
    (&BUDGETED, |record| record.budget.is_some()),
    (&UNDECIDED, |record| record.verdict.undecided.is_some()),
];

impl More {
    /// The columns of a correction to 20 °C.
    pub const CORRECTED: Self = Self(1);
    /// The columns of a decision rule.
    pub const GUARDED: Self = Self(2);
    /// The columns of a budget.
    pub const BUDGETED: Self = Self(4);

    /// The same with others, where they are wanted.
    #[must_use]
    pub const fn with(self, others: Self, are_wanted: bool) -> Self {
        if are_wanted { Self(self.0 | others.0) } else { self }
    }

    /// What some records have.
    pub fn of(records: &[Record]) -> Self {
        let mut more = Self::default();
        for record in records {
            more.see(record);
        }
        more
    }

    /// Adds what a record has.
    pub fn see(&mut self, record: &Record) {
        for (bit, (_, has)) in MORE.iter().enumerate() {
            self.0 |= u8::from(has(record)) << bit;
        }
    }

    /// The columns, in their order.
    fn columns(self) -> impl Iterator<Item = &'static Column<ReportRow>> {
        let wanted = MORE.iter().enumerate().filter(move |(bit, _)| self.0 & (1 << bit) != 0);
        wanted.flat_map(|(_, (columns, _))| columns.iter())
    }

    /// The names of the columns.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        self.columns().map(|(name, _)| *name)
    }

    /// The cells of a record in these columns.
    pub fn cells(self, record: &Record) -> Vec<String> {
        let row = ReportRow::of(record);
        self.of_row(&row).collect()
    }

    fn of_row(self, row: &ReportRow) -> impl Iterator<Item = String> {
        // What a row does not have is an empty cell.
        self.columns().map(|(_, cell)| cell(row).unwrap_or_default())
    }
}

fn render_rows(mut rows: impl Iterator<Item = ReportRow>, more: More) -> Result<Vec<u8>, RenderError> {
    let mut bytes = Vec::new();
    let written = header(more, &mut bytes).and_then(|()| rows.try_for_each(|row| check(&row, more, &mut bytes)));
    written.map(|()| bytes).map_err(|error| RenderError::writer("csv", &error))
}

/// The names of the columns.
fn header(more: More, out: &mut dyn Write) -> io::Result<()> {
    line(names(&COLUMNS).into_iter().chain(more.names()), out)
}

fn check(row: &ReportRow, more: More, out: &mut dyn Write) -> io::Result<()> {
    line(cells(&COLUMNS, row).chain(more.of_row(row)), out)
}

/// Writes a line. Into memory first: so an error of the stream stays what it is.
pub fn line<T: AsRef<str>>(cells: impl IntoIterator<Item = T>, out: &mut dyn Write) -> io::Result<()> {
    let mut line = CsvLine::default();
    cells.into_iter().for_each(|cell| line.cell(cell.as_ref()));
    out.write_all(line.end())
}

/// Cells of a CSV, one behind the other: a cell with a comma, a quotation mark or a line end stands in quotation marks. One of these
/// serves for all lines of a file.
#[derive(Debug, Default)]
pub struct CsvLine {
    line: Line,
    cells: usize,
    /// Whether the next cell begins another line.
    is_ended: bool,
}

impl CsvLine {
    /// The next cell.
    pub fn cell(&mut self, text: &str) {
        self.next();
        let guarded = guarded(text);
        let text = guarded.as_ref();
        if !text.bytes().any(|byte| matches!(byte, b',' | b'"' | b'\n' | b'\r')) {
            return self.line.append(text.as_bytes());
        }
        self.line.push(b'"');
        for piece in text.split_inclusive('"') {
            self.line.append(piece.as_bytes());
            if piece.ends_with('"') {
                self.line.push(b'"');
            }
        }
        self.line.push(b'"');
    }

    /// The next cell: a length in millimetres, with at least so many decimals, at most 6.
    pub fn mm(&mut self, length: Length, decimals: u8) {
        self.next();
        self.line.pieces(|window| length.put_mm(decimals, window));
    }

    /// The next cell: a length in micrometres, with the decimals that it has.
    pub fn um(&mut self, length: Length) {
        self.next();
        self.line.pieces(|window| length.put_um(0, window));
    }

    fn next(&mut self) {
        if self.is_ended {
            self.line.clear();
            self.cells = 0;
            self.is_ended = false;
        }
        if 0 < self.cells {
            self.line.push(b',');
        }
        self.cells += 1;
    }

    /// The line with its end; the next cell begins another one.
    pub fn end(&mut self) -> &[u8] {
        // A single cell without a text would be an empty line, which is none.
        if self.cells == 1 && self.line.bytes().is_empty() {
            self.line.append(b"\"\"");
        }
        self.line.push(b'\n');
        self.is_ended = true;
        self.line.bytes()
    }
}

/// Millimetres have at least three decimals, except in the nominal size.
pub(super) const COLUMNS: [Column<ReportRow>; 21] = [
    ("time", |row| row.time.cell()),
    ("id", |row| harmless(&row.id).cell()),
    ("callout", |row| row.callout.cell()),
    ("feature", |row| row.feature.cell()),
    ("nominal_mm", |row| row.nominal_mm.text(0).cell()),
    ("min_mm", |row| row.min_mm.text(3).cell()),
    ("max_mm", |row| row.max_mm.text(3).cell()),
    ("measured_mm", |row| row.measured_mm.text(3).cell()),
    ("deviation_um", |row| row.deviation_um.text().cell()),
    ("status", |row| row.status.cell()),
    ("remove_um", |row| row.remove_um?.text().cell()),
    ("remove_to_middle_um", |row| row.remove_to_middle_um?.text().cell()),
    ("position", |row| row.position.cell()),
    ("centre_x_mm", |row| row.centre_x_mm?.text(3).cell()),
    ("centre_y_mm", |row| row.centre_y_mm?.text(3).cell()),
    ("contacts", contacts),
    ("source", |row| harmless(&row.source).cell()),
    ("origin", |row| harmless(&row.origin).cell()),
    ("rule", |row| row.rule.cell()),
    ("warnings", |row| row.warnings.join(" | ").cell()),
    ("simulated", |row| row.simulated.cell()),
];

/// What a correction to 20 °C adds; without one a file has none of these columns.
const CORRECTED: [Column<ReportRow>; 6] = [
    ("as_measured_mm", |row| row.corrected.as_ref()?.as_measured_mm.text(3).cell()),
    ("correction_um", |row| row.corrected.as_ref()?.correction_um.text().cell()),
    ("temperature_c", |row| Some(row.corrected.as_ref()?.temperature_c.to_string())),
    ("expansion_um_per_m_k", |row| Some(row.corrected.as_ref()?.expansion_um_per_m_k.to_string())),
    ("scale_temperature_c", |row| Some(row.corrected.as_ref()?.scale_temperature_c?.to_string())),
    ("scale_expansion_um_per_m_k", |row| Some(row.corrected.as_ref()?.scale_expansion_um_per_m_k?.to_string())),
];

/// What a decision rule adds; without one a file has none of these columns.
const GUARDED: [Column<ReportRow>; 7] = [
    ("rule_name", |row| row.guarded.as_ref()?.rule_name.cell()),
    ("u_um", |row| Some(row.guarded.as_ref()?.u_um?.to_string())),
    ("k", |row| Some(row.guarded.as_ref()?.k?.to_string())),
    ("zone_min_mm", |row| row.guarded.as_ref()?.zone_min_mm?.text(3).cell()),
    ("zone_max_mm", |row| row.guarded.as_ref()?.zone_max_mm?.text(3).cell()),
    ("conformity", |row| Some(row.guarded.as_ref()?.conformity?.to_string())),
    ("proven", |row| row.guarded.as_ref()?.proven?.cell()),
];

/// What a budget adds.
const BUDGETED: [Column<ReportRow>; 4] = [
    ("budget", |row| harmless(&row.budgeted.as_ref()?.budget).cell()),
    ("budget_date", |row| row.budgeted.as_ref()?.budget_date.cell()),
    ("budget_valid_until", |row| row.budgeted.as_ref()?.budget_valid_until.cell()),
    ("budget_validity", |row| row.budgeted.as_ref()?.budget_validity.cell()),
];

/// What contacts that the uncertainty does not count for add.
const UNDECIDED: [Column<ReportRow>; 1] = [("remeasure_reason", |row| row.undecided.as_ref()?.remeasure_reason.cell())];

fn contacts(row: &ReportRow) -> Option<String> {
    let all: serde_json::Value = row.contacts.iter().map(|contact| contact.to_vec()).collect();
    (!row.contacts.is_empty()).then(|| all.to_string())
}

/// A cell of any CSV that Fitcheck writes: a number as it is, any other text so that no spreadsheet computes it.
pub fn cell(text: &str) -> Cow<'_, str> {
    if text.parse::<f64>().is_ok() { Cow::Borrowed(text) } else { harmless_text(text) }
}

fn harmless_text(text: &str) -> Cow<'_, str> {
    if is_formula(text) { Cow::Owned(format!("'{}", guarded(text))) } else { guarded(text) }
}

/// A text that no spreadsheet computes. Blanks and control characters in front do not hide a formula, and the wide
/// signs of East Asian keyboards are formulas to some spreadsheets, too.
pub fn harmless(text: &str) -> String {
    harmless_text(text).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    proptest::proptest! {
        /// The `csv` crate knows when a cell needs quotation marks.
        #[test]
        fn lines_are_those_of_the_csv_crate(lines in proptest::collection::vec(
            proptest::collection::vec("[a\",;\r\n =ä\\t]{0,20}", 1..5), 1..4)
        ) {
            let mut own = CsvLine::default();
            for cells in lines {
                for cell in &cells {
                    own.cell(cell);
                }
                let mut writer = csv::WriterBuilder::new().from_writer(Vec::new());
                writer.write_record(cells.iter().map(|cell| guarded(cell).into_owned())).unwrap();
                proptest::prop_assert_eq!(own.end(), writer.into_inner().unwrap());
            }
        }
    }
}
