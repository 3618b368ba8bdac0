//! The parts of a lot, the worst first, and a sheet for each of the first ones.

use std::io;

use fitcheck_core::verdict::Status;
use rust_xlsxwriter::Workbook;
use rust_xlsxwriter::utility::{cell_range, worksheet_range_absolute};

use super::cells::{Look, Paper};
use super::table::{self, HEAD, LAST, OF_SIZE, VERDICT};
use super::{Book, MOST_PART_SHEETS};
use crate::report::part::PartSheet;
use crate::report::said::{heading, lacks};
use crate::report::told;

/// The columns of the lot, by the names of their texts, and how wide they are.
const COLUMNS: [(&str, f64); 14] = [
    ("report-contact", 6.0),
    ("report-part", 24.0),
    ("records-page-serial", 18.0),
    ("report-verdict", 22.0),
    ("report-measured", 11.0),
    ("report-missing", 11.0),
    ("report-skipped", 11.0),
    ("status-good", 11.0),
    ("status-rework", 14.0),
    ("status-re-measure", 14.0),
    ("status-out-of-limits", 14.0),
    ("status-scrap", 11.0),
    ("simulated", 13.0),
    ("parts-page-head-remark", 60.0),
];

/// The column of the lot's verdicts.
const STANDING: u16 = 3;

/// The columns that are counted, from the first to the last.
const COUNTED: [u16; 2] = [7, 12];

const LAST_OF_LOT: u16 = 13;

/// How many values of a part there are of each status, in the order of [`Status::ALL`], and how many nobody measured.
fn counts(part: &PartSheet) -> [usize; Status::ALL.len() + 1] {
    let mut counts = [0; Status::ALL.len() + 1];
    for record in part.records() {
        let at =
            if record.measurement.origin.is_simulated() { Status::ALL.len() } else { record.verdict.status().at() };
        if let Some(count) = counts.get_mut(at) {
            *count += 1;
        }
    }
    counts
}

/// The places of the parts in the report, the worst part first: scrap, out of limits, re-measure, rework, those without a verdict, good.
fn worst_first(parts: &[PartSheet]) -> Vec<usize> {
    let rank = |part: &PartSheet| match part.status() {
        Some(Status::Scrap) => 0,
        Some(Status::OutOfLimits) => 1,
        Some(Status::ReMeasure) => 2,
        Some(Status::Rework) => 3,
        None => 4,
        Some(Status::Good) => 5,
    };
    let mut ranked: Vec<(i32, usize)> = parts.iter().map(rank).zip(0..).collect();
    ranked.sort_unstable();
    ranked.into_iter().map(|(_, at)| at).collect()
}

/// Writes the sheet of the lot; the range of its verdicts.
pub(super) fn lot(book: &mut Book<'_>, workbook: &mut Workbook) -> io::Result<String> {
    let name = book.words.get("page-parts");
    let mut paper = book.paper(workbook, &name)?;
    let report = book.report;
    book.text(&mut paper, (0, 0), &name, Look::Title)?;
    if report.parts.iter().any(|part| 0 < part.standing().simulated) {
        let said = book.looks.simulated.clone();
        book.text(&mut paper, (1, 0), &said, Look::Label)?;
    }
    paper.widths(&COLUMNS.map(|(_, width)| width))?;
    for (column, (id, _)) in (0..).zip(COLUMNS) {
        let title = book.words.get(id);
        book.text(&mut paper, (HEAD, column), &title, Look::Head)?;
    }
    let mut row = HEAD;
    for at in worst_first(&report.parts) {
        if let Some(part) = report.parts.get(at) {
            row += 1;
            line(book, &mut paper, row, (at + 1, part))?;
        }
    }
    paper.table((HEAD, 0), (row, LAST_OF_LOT), STANDING, &book.looks)?;
    Ok(worksheet_range_absolute(&paper.name(), HEAD + 1, STANDING, row, STANDING))
}

/// A part of the lot.
fn line(book: &mut Book<'_>, paper: &mut Paper<'_>, row: u32, (number, part): (usize, &PartSheet)) -> io::Result<()> {
    let standing = part.standing();
    let counts = counts(part);
    paper.whole((row, 0), number, &book.looks)?;
    book.text(paper, (row, 1), &part.plan.head.part, Look::Plain)?;
    book.text(paper, (row, 2), part.serial(), Look::Plain)?;
    let verdict = told::standing(part, book.words);
    book.text(paper, (row, STANDING), &verdict, Look::Strong)?;
    let [first, last] = COUNTED;
    let formula = format!("=SUM({})", cell_range(row, first, row, last));
    paper.counted((row, 4), &formula, counts.iter().sum(), &book.looks)?;
    paper.whole((row, 5), standing.missing, &book.looks)?;
    paper.whole((row, 6), standing.skipped, &book.looks)?;
    for (column, count) in (first..).zip(counts) {
        paper.whole((row, column), count, &book.looks)?;
    }
    book.text(paper, (row, LAST_OF_LOT), &lacks(part, book.words).join("; "), Look::Plain)
}

/// Writes the sheets of the first parts, in their order in the report.
pub(super) fn sheets(book: &mut Book<'_>, workbook: &mut Workbook) -> io::Result<()> {
    let report = book.report;
    (1..).zip(report.parts.iter().take(MOST_PART_SHEETS)).try_for_each(|(number, part)| {
        let serial = Some(part.serial()).filter(|serial| !serial.is_empty());
        let name = serial.unwrap_or(&part.plan.head.part);
        let mut paper = book.paper(workbook, &format!("{number} {name}"))?;
        of_part(book, &mut paper, part)
    })
}

/// A part with all its sizes.
fn of_part(book: &mut Book<'_>, paper: &mut Paper<'_>, part: &PartSheet) -> io::Result<()> {
    let standing = part.standing();
    let title = heading(part, book.words);
    book.text(paper, (0, 0), &title, Look::Title)?;
    let mut said = format!("{}: {}", told::standing(part, book.words), book.words.told(&standing));
    if 0 < standing.simulated {
        said = format!("{}; {said}", book.looks.simulated);
    }
    book.text(paper, (1, 0), &said, Look::Label)?;
    let drawing = Some(&part.plan.head.drawing).filter(|drawing| !drawing.is_empty());
    let drawing = drawing.map(|drawing| format!("{}: {drawing}", book.words.get("parts-page-head-drawing")));
    let lines: Vec<String> = drawing.into_iter().chain(lacks(part, book.words)).collect();
    book.text(paper, (2, 0), &lines.join("; "), Look::Label)?;
    table::head(book, paper, &OF_SIZE)?;
    let mut row = HEAD;
    for (size, step, record) in part.sizes() {
        row += 1;
        match size.feature.number.parse() {
            Ok(number) => paper.whole((row, 0), number, &book.looks)?,
            Err(_) => book.text(paper, (row, 0), &size.feature.number, Look::Plain)?,
        }
        book.text(paper, (row, 1), &size.name(), Look::Plain)?;
        let callout = size.callout.map_or_else(String::new, |callout| book.words.number(&callout.to_string()));
        table::asked(book, paper, row, (&callout, size.limits))?;
        match (record, &step.skipped) {
            (Some(record), _) => table::answered(book, paper, row, record)?,
            (None, Some(reason)) => {
                table::unanswered(book, paper, row, (&book.words.get("parts-page-balloon-skipped"), reason))?;
            }
            (None, None) => table::unanswered(book, paper, row, (&book.words.get("parts-page-balloon-open"), ""))?,
        }
    }
    paper.table((HEAD, 0), (row, LAST), VERDICT, &book.looks)
}
