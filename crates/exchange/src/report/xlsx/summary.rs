//! The first sheet: what the report is about, and how many checks and parts there are of each verdict.

use std::io;

use fitcheck_core::verdict::Status;
use rust_xlsxwriter::Worksheet;

use super::cells::{Look, Paper};
use super::{Book, Counted};
use crate::report::head;
use crate::report::html::closing;
use crate::report::told::mark;

/// The verdicts in the order of the counts, with none at the end.
const VERDICTS: [Option<Status>; 6] = [
    Some(Status::Good),
    Some(Status::Rework),
    Some(Status::ReMeasure),
    Some(Status::OutOfLimits),
    Some(Status::Scrap),
    None,
];

pub(super) fn fill(book: &mut Book<'_>, sheet: &mut Worksheet, counted: &Counted) -> io::Result<()> {
    let mut paper = book.set_up(sheet);
    paper.widths(&[30.0, 60.0, 14.0])?;
    let title = book.title();
    book.text(&mut paper, (0, 0), &title, Look::Title)?;
    book.simulated(&mut paper, (1, 0))?;
    let report = book.report;
    let words = book.words;
    let mut row = 2;
    let company = &report.template.company;
    let name = std::iter::once(&company.name).filter(|name| !name.is_empty());
    for (text, look) in
        name.map(|name| (name, Look::Strong)).chain(company.address.iter().map(|line| (line, Look::Plain)))
    {
        row += 1;
        book.text(&mut paper, (row, 1), text, look)?;
    }
    for entry in head::whole(report, &book.seen, words) {
        row += 1;
        book.text(&mut paper, (row, 0), &entry.label, Look::Label)?;
        if entry.label == words.get("report-date") {
            paper.time((row, 1), book.report.created, &book.looks)?;
            paper.beside((row, 1), true, &book.looks)?;
        } else {
            book.text(&mut paper, (row, 1), &entry.value, Look::Plain)?;
        }
    }
    if let Some(changes) = book.seen.changes.clone() {
        row += 2;
        book.text(&mut paper, (row, 0), &words.say(&changes.heading()), Look::Head)?;
        for line in &changes.lines {
            row += 1;
            book.text(&mut paper, (row, 1), &words.say(line), Look::Plain)?;
        }
    }
    row += 2;
    if book.seen.total == 0 {
        book.text(&mut paper, (row, 0), &words.get("report-no-checks"), Look::Label)?;
        row += 2;
    }
    if let Some(range) = counted.checks.clone() {
        row = checks(book, &mut paper, row, &range)?;
    }
    if let Some(range) = counted.parts.clone() {
        row = parts(book, &mut paper, row, &range)?;
    }
    for said in closing(report, &book.seen, words) {
        book.text(&mut paper, (row, 1), &said, Look::Strong)?;
        row += 1;
    }
    book.text(&mut paper, (row, 1), &words.get("report-footer"), Look::Plain)?;
    paper.print_all((row, 2))
}

/// The counts of the checks: formulas where the sheet lists all of them.
fn checks(book: &mut Book<'_>, paper: &mut Paper<'_>, first: u32, range: &str) -> io::Result<u32> {
    let title = book.words.get("budget-page-checks");
    book.text(paper, (first, 0), &title, Look::Head)?;
    let is_whole = book.seen.is_whole();
    let mut row = first;
    for verdict in VERDICTS {
        row += 1;
        let count = match verdict {
            Some(status) => {
                let of = |counts: &[usize]| counts.get(status.at()).map_or(0, |count| *count);
                of(&book.seen.counts) - of(&book.seen.simulated_of)
            }
            None => book.seen.simulated,
        };
        let word = verdict.map_or_else(|| book.looks.simulated.clone(), |status| book.words.told(&status));
        book.text(paper, (row, 0), &format!("{} {word}", mark(verdict)), Look::Label)?;
        if is_whole {
            paper.counted((row, 1), &counting(range, verdict), count, &book.looks)?;
        } else {
            paper.whole((row, 1), count, &book.looks)?;
        }
        paper.beside((row, 1), false, &book.looks)?;
    }
    total(book, paper, [first + 1, row], book.seen.total)?;
    paper.colours((first + 1, 0), row, &book.looks)?;
    Ok(row + 3)
}

/// The counts of the parts.
fn parts(book: &mut Book<'_>, paper: &mut Paper<'_>, first: u32, range: &str) -> io::Result<u32> {
    let title = book.words.get("page-parts");
    book.text(paper, (first, 0), &title, Look::Head)?;
    let parts = &book.report.parts;
    let mut row = first;
    for verdict in VERDICTS {
        row += 1;
        let count = parts.iter().filter(|part| part.status() == verdict).count();
        let none = || book.words.get("walk-page-not-complete");
        let word = verdict.map_or_else(none, |status| book.words.told(&status));
        book.text(paper, (row, 0), &format!("{} {word}", mark(verdict)), Look::Label)?;
        paper.counted((row, 1), &counting(range, verdict), count, &book.looks)?;
        paper.beside((row, 1), false, &book.looks)?;
    }
    total(book, paper, [first + 1, row], parts.len())?;
    paper.colours((first + 1, 0), row, &book.looks)?;
    Ok(row + 3)
}

fn total(book: &mut Book<'_>, paper: &mut Paper<'_>, [first, last]: [u32; 2], count: usize) -> io::Result<()> {
    let title = book.words.get("report-total");
    book.text(paper, (last + 1, 0), &title, Look::Label)?;
    let range = rust_xlsxwriter::utility::cell_range(first, 1, last, 1);
    paper.counted((last + 1, 1), &format!("=SUM({range})"), count, &book.looks)?;
    paper.beside((last + 1, 1), false, &book.looks)
}

/// Counts the cells with the mark of a verdict.
fn counting(range: &str, verdict: Option<Status>) -> String {
    // A question mark stands for any sign unless it has a tilde before it.
    let mark = mark(verdict).replace('?', "~?");
    format!("=COUNTIF({range},\"{mark}*\")")
}
