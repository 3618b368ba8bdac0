//! The sheet of all checks, one a row.

use std::io;

use rust_xlsxwriter::Workbook;
use rust_xlsxwriter::utility::worksheet_range_absolute;

use super::Book;
use super::cells::Look;
use super::table::{self, HEAD, LAST, OF_CHECK, VERDICT};
use crate::report::told;

/// Writes it; the range of the verdicts where all checks are listed.
pub(super) fn sheet(book: &mut Book<'_>, workbook: &mut Workbook) -> io::Result<String> {
    let name = book.words.get("budget-page-checks");
    let mut paper = book.paper(workbook, &name)?;
    book.text(&mut paper, (0, 0), &name, Look::Title)?;
    book.simulated(&mut paper, (1, 0))?;
    if let Some(note) = book.seen.note(book.words) {
        book.text(&mut paper, (2, 0), &note, Look::Label)?;
    }
    table::head(book, &mut paper, &OF_CHECK)?;
    let mut row = HEAD;
    let report = book.report;
    let seen = std::mem::take(&mut book.seen);
    let written = seen.each(report, &mut |number, record| {
        row += 1;
        paper.whole((row, 0), number, &book.looks)?;
        book.text(&mut paper, (row, 1), &record.id, Look::Plain)?;
        table::asked(book, &mut paper, row, (&told::callout(record, book.words), &record.limits))?;
        table::answered(book, &mut paper, row, record)
    });
    book.seen = seen;
    written?;
    paper.table((HEAD, 0), (row.max(HEAD + 1), LAST), VERDICT, &book.looks)?;
    Ok(worksheet_range_absolute(&paper.name(), HEAD + 1, VERDICT, row.max(HEAD + 1), VERDICT))
}
