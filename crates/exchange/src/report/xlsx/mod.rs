//! The report as a workbook (XLSX), for people who sort, filter and reckon on: numbers are numbers, dates are dates, and what a person
//! would reckon is a formula with its result beside it, for readers that reckon nothing.
//!
//! | file | what |
//! |---|---|
//! | `summary` | the first sheet: the head, and the counts |
//! | `table` | the columns of a check, and a check as a row |
//! | `checks` | the sheet of all checks |
//! | `parts` | the sheet of a lot, the worst part first, and a sheet for each part |
//! | `notes` | the last sheet: notes, and what is not in the workbook |
//! | `cells` | cells: kinds of them, their looks, the longest text |
//! | `names` | names of sheets |
//! | `container` | the ZIP file around it |
//!
//! A workbook is made in memory, so it lists at most [`MOST_CHECKS`]; the counts are those of all checks. Texts are never formulas or
//! links. A verdict has its mark and its word, and colours only besides; what nobody measured has the mark of no verdict, says so in its
//! cell, in a column of its own and at the head of each sheet with such a value.

mod cells;
mod checks;
mod container;
mod names;
mod notes;
mod parts;
mod summary;
mod table;

use std::io::{self, Write};

use fitcheck_core::message::message;
use fitcheck_core::words::Words;
use rust_xlsxwriter::{DocProperties, Workbook, XlsxError};

use super::said::title;
use super::seen::ReportSurvey;
use super::told::on_one_line;
use super::{Holds, Rendering, Report};
use cells::{Looks, Paper, excel_time};
use names::SheetNames;

pub const RENDERING: Rendering =
    Rendering { name: "xlsx", title: "XLSX", is_for_people: true, holds: Holds::Report, endings: &["xlsx"], render };

/// The most checks of a workbook, far below the 1 048 576 rows of a sheet: it takes some 100 MB of memory to write, and as much to open.
pub const MOST_CHECKS: usize = 50_000;

/// The most parts with a sheet of their own; the sheet of the lot has all.
pub const MOST_PART_SHEETS: usize = 100;

/// The largest piece that is written at once.
const PIECE: usize = 16 << 10;

/// What every sheet is made from.
struct Book<'a> {
    report: &'a Report,
    words: &'a Words,
    seen: ReportSurvey,
    looks: Looks,
    names: SheetNames,
    /// How many texts were cut.
    cut: usize,
}

/// Where the sheets of checks and of parts have their verdicts, for the formulas that count them.
#[derive(Default)]
struct Counted {
    checks: Option<String>,
    parts: Option<String>,
}

fn render(report: &Report, words: &Words, out: &mut dyn Write) -> io::Result<()> {
    let seen = ReportSurvey::of(report, MOST_CHECKS)?;
    let mut book = Book { report, words, seen, looks: Looks::new(words), names: SheetNames::default(), cut: 0 };
    let bytes = book.bytes()?;
    bytes.chunks(PIECE).try_for_each(|piece| out.write_all(piece))
}

/// What the writer of workbooks says.
fn failed(error: XlsxError) -> io::Error {
    match error {
        XlsxError::IoError(error) => error,
        error => io::Error::other(error),
    }
}

impl Book<'_> {
    fn bytes(&mut self) -> io::Result<Vec<u8>> {
        let mut workbook = Workbook::new();
        let mut properties =
            DocProperties::new().set_title(on_one_line(&self.title())).set_author(on_one_line(&self.report.program));
        // Never the time of day: the same report has the same bytes.
        if let Some(created) = excel_time(self.report.created) {
            properties = properties.set_creation_datetime(&created);
        }
        workbook.set_properties(&properties);
        let first = self.names.of(&self.words.get("report-title"));
        workbook.add_worksheet().set_name(first).map_err(failed)?;
        let mut counted = Counted::default();
        if !self.report.parts.is_empty() {
            counted.parts = Some(parts::lot(self, &mut workbook)?);
        }
        if 0 < self.seen.total {
            counted.checks = Some(checks::sheet(self, &mut workbook)?);
        }
        parts::sheets(self, &mut workbook)?;
        summary::fill(self, workbook.worksheet_from_index(0).map_err(failed)?, &counted)?;
        // Last, because only now it is known what was cut.
        notes::sheet(self, &mut workbook)?;
        workbook.save_to_buffer().map(container::made_on_unix).map_err(failed)
    }

    fn title(&self) -> String {
        title(self.report, self.words)
    }

    /// Writes a text, and counts it where it is too long for a cell.
    fn text(&mut self, paper: &mut Paper<'_>, at: cells::At, text: &str, look: cells::Look) -> io::Result<()> {
        let is_cut = paper.text(at, text, (&self.looks, look))?;
        self.cut += usize::from(is_cut);
        Ok(())
    }

    /// Says at the head of a sheet that some values of the report are simulated, where some are.
    fn simulated(&mut self, paper: &mut Paper<'_>, at: cells::At) -> io::Result<()> {
        let count = self.seen.simulated;
        if count == 0 {
            return Ok(());
        }
        let said = self.words.say(&message!("walk-page-simulated").count("count", count));
        let said = format!("{}: {said}", self.looks.simulated);
        self.text(paper, at, &said, cells::Look::Label)
    }

    /// Another sheet behind the others, by this name or one that is like it.
    fn paper<'w>(&mut self, workbook: &'w mut Workbook, name: &str) -> io::Result<Paper<'w>> {
        let name = self.names.of(name);
        let sheet = workbook.add_worksheet();
        sheet.set_name(name).map_err(failed)?;
        Ok(self.set_up(sheet))
    }

    fn set_up<'w>(&self, sheet: &'w mut rust_xlsxwriter::Worksheet) -> Paper<'w> {
        Paper::new(sheet, &self.report.program)
    }
}
