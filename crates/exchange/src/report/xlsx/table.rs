//! The columns that the sheet of checks and those of parts share, and a check as a row of them.

use std::io;

use fitcheck_core::tolerance::Limits;
use fitcheck_core::words::Words;
use rust_xlsxwriter::utility::row_col_to_cell;

use super::Book;
use super::cells::{Look, Paper};
use crate::journal::Record;
use crate::report::text;
use crate::report::told::{self, CheckSaid};

/// The row of a table's head: above it are the name of the sheet, what it says of all rows, and a blank line.
pub(super) const HEAD: u32 = 3;

/// A column: the name of its text, its unit, and how wide it is in characters.
type Column = (&'static str, &'static str, f64);

/// What is at the left of a table of checks.
pub(super) const OF_CHECK: [Column; 3] = [("report-contact", "", 6.0), ("report-id", "", 16.0), TIME];

/// What is at the left of a table of a part's sizes.
pub(super) const OF_SIZE: [Column; 3] = [("report-balloon", "", 8.0), ("report-id", "", 16.0), TIME];

const TIME: Column = ("report-sign-date", "", 19.0);

/// What follows in both.
const SHARED: [Column; 17] = [
    ("report-callout", "", 11.0),
    ("parts-page-column-feature", "", 9.0),
    ("report-nominal", "mm", 12.0),
    ("report-minimum", "mm", 12.0),
    ("report-maximum", "mm", 12.0),
    ("report-measured", "mm", 12.0),
    ("report-deviation", "µm", 11.0),
    ("report-verdict", "", 24.0),
    ("columns-page-role-simulated", "", 13.0),
    ("report-remove", "", 13.0),
    ("report-remove-to-middle", "", 14.0),
    ("report-position", "", 12.0),
    ("report-sheets-corrected", "", 14.0),
    ("report-limits-from", "", 20.0),
    ("report-from", "", 18.0),
    ("report-verdict-from", "", 22.0),
    ("parts-page-head-remark", "", 44.0),
];

const FIRST: u16 = 3;
const NOMINAL: u16 = FIRST + 2;
const MEASURED: u16 = FIRST + 5;

/// The column of the verdicts.
pub(super) const VERDICT: u16 = FIRST + 7;

/// The last column.
pub(super) const LAST: u16 = FIRST + 16;

/// Writes the head of a table, and how wide its columns are.
pub(super) fn head(book: &mut Book<'_>, paper: &mut Paper<'_>, left: &[Column; 3]) -> io::Result<()> {
    let all: Vec<Column> = left.iter().chain(&SHARED).copied().collect();
    paper.widths(&all.iter().map(|(.., width)| *width).collect::<Vec<_>>())?;
    for (column, (id, unit, _)) in (0..).zip(&all) {
        let name = titled(book.words, id, unit);
        book.text(paper, (HEAD, column), &name, Look::Head)?;
    }
    Ok(())
}

fn titled(words: &Words, id: &str, unit: &str) -> String {
    // What is to be removed at least stands in the column before.
    let name = match id {
        "report-remove-to-middle" => format!("{}, {}", words.get("report-remove"), words.get(id)),
        _ => words.get(id),
    };
    if unit.is_empty() { name } else { format!("{name} ({unit})") }
}

/// What a size has whether it was measured or not: the callout, and limits.
pub(super) fn asked(
    book: &mut Book<'_>,
    paper: &mut Paper<'_>,
    row: u32,
    (callout, limits): (&str, &Limits),
) -> io::Result<()> {
    book.text(paper, (row, FIRST), callout, Look::Plain)?;
    let feature = book.words.say(&text::feature(limits.feature));
    book.text(paper, (row, FIRST + 1), &feature, Look::Plain)?;
    for (column, size) in (NOMINAL..).zip([limits.nominal, limits.minimum(), limits.maximum()]) {
        paper.mm((row, column), size, &book.looks)?;
    }
    Ok(())
}

/// What was measured, and what there is to say of it.
pub(super) fn answered(book: &mut Book<'_>, paper: &mut Paper<'_>, row: u32, record: &Record) -> io::Result<()> {
    let Record { limits, measurement, verdict, .. } = record;
    paper.time((row, 2), record.time, &book.looks)?;
    paper.mm((row, MEASURED), measurement.diameter, &book.looks)?;
    let deviation = measurement.diameter.saturating_sub(limits.nominal);
    // Rounded, because floats of millimetres leave noise behind the nanometre.
    let formula = format!("=ROUND(({}-{})*1000,3)", row_col_to_cell(row, MEASURED), row_col_to_cell(row, NOMINAL));
    paper.reckoned((row, MEASURED + 1), &formula, deviation, &book.looks)?;
    let word = told::verdict(record, book.words);
    book.text(paper, (row, VERDICT), &word, Look::Strong)?;
    if measurement.origin.is_simulated() {
        let simulated = book.looks.simulated.clone();
        book.text(paper, (row, VERDICT + 1), &simulated, Look::Strong)?;
    }
    if let Some(removal) = verdict.size.removal {
        paper.amount((row, VERDICT + 2), removal.to_limit, &book.looks)?;
        paper.amount((row, VERDICT + 3), removal.to_middle, &book.looks)?;
    }
    let position = book.words.say(&text::position(verdict.position));
    let said = CheckSaid::of(record, book.words);
    // A reader of the column takes any text for a yes, and corrects no second time.
    let change = record.correction.map(|correction| format!("{} µm", book.words.signed_um(correction.change())));
    let texts = [
        position,
        change.unwrap_or_default(),
        said.limits_from,
        said.measured_from,
        said.rule,
        said.remarks.join("; "),
    ];
    (VERDICT + 4..).zip(texts).try_for_each(|(column, text)| book.text(paper, (row, column), &text, Look::Plain))
}

/// A size without a value: why there is none.
pub(super) fn unanswered(
    book: &mut Book<'_>,
    paper: &mut Paper<'_>,
    row: u32,
    (word, reason): (&str, &str),
) -> io::Result<()> {
    book.text(paper, (row, VERDICT), &format!("{} {word}", told::mark(None)), Look::Strong)?;
    book.text(paper, (row, LAST), reason, Look::Plain)
}
