//! The last sheet: what was told while the report was made, and what is not in the workbook.

use std::io;

use fitcheck_core::message::message;
use rust_xlsxwriter::Workbook;

use super::cells::Look;
use super::{Book, MOST_PART_SHEETS};

/// The most notes that are listed.
const MOST: usize = 10_000;

pub(super) fn sheet(book: &mut Book<'_>, workbook: &mut Workbook) -> io::Result<()> {
    let name = book.words.get("report-notes");
    let mut paper = book.paper(workbook, &name)?;
    paper.widths(&[8.0, 120.0])?;
    book.text(&mut paper, (0, 0), &name, Look::Title)?;
    book.simulated(&mut paper, (1, 0))?;
    let report = book.report;
    let words = book.words;
    let mut notes: Vec<String> = book.seen.note(words).into_iter().collect();
    let parts = report.parts.len();
    if MOST_PART_SHEETS < parts {
        notes.push(words.say(&message!("report-sheets").count("listed", MOST_PART_SHEETS).count("total", parts)));
    }
    notes.extend(report.notes.iter().take(MOST).map(|note| words.say(note)));
    let more = report.notes.len().saturating_sub(MOST);
    if 0 < more {
        notes.push(words.say(&message!("report-note-more").count("count", more)));
    }
    notes.push(words.get("report-sheets-without"));
    let mut row = 2;
    for (number, note) in (1..).zip(&notes) {
        row += 1;
        paper.whole((row, 0), number, &book.looks)?;
        book.text(&mut paper, (row, 1), note, Look::Plain)?;
    }
    if 0 < book.cut {
        row += 1;
        paper.whole((row, 0), notes.len() + 1, &book.looks)?;
        let cut = words.say(&message!("report-sheets-cut").count("count", book.cut));
        book.text(&mut paper, (row, 1), &cut, Look::Plain)?;
    }
    paper.print_all((row, 1))
}
