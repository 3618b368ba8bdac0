//! Plans as CSV: one feature per line.
//!
//! The header names the columns, in any order: `callout`, and any other of [`Column`]. Comma, semicolon or tab separates cells;
//! numbers have a point or a comma.

use super::Document;
use super::column::Column;
use super::draft::{Draft, DraftCell, DraftFeature};
use super::fault::{PlanError, PlanFault};
use super::plan::MOST_FEATURES;
use crate::message::{FilePlace, Located};
use crate::text::{decode, lines};

/// The largest plan, 1 MiB: a kilobyte for every feature. Every cell takes memory and time, also an empty one.
pub(super) const LARGEST: usize = 1 << 20;

/// Reads a plan; unknown columns and cells beyond the header are problems, and the rest is read.
pub(super) fn read(bytes: &[u8]) -> Result<Document, PlanError> {
    if LARGEST < bytes.len() {
        return Err(whole(PlanFault::TooLarge { most: LARGEST >> 10 }));
    }
    let text = decode(bytes);
    let header = lines(&text).map(|(_, line)| line).find(|line| !line.trim().is_empty());
    let separates = |sign: &u8| header.is_some_and(|header| header.as_bytes().contains(sign));
    let separator = [b';', b'\t'].into_iter().find(separates).unwrap_or(b',');
    of_rows(lines(&text).map(|(line, row)| (line, cells(row, separator))))
}

/// The same from rows of cells with their lines, such as those of a workbook.
pub(super) fn of_rows(rows: impl IntoIterator<Item = (usize, Vec<String>)>) -> Result<Document, PlanError> {
    let mut columns: Option<Vec<Option<Column>>> = None;
    let mut document = Document::default();
    for (line, row) in rows {
        let problem = |what| Located { what, place: FilePlace::line(line) };
        if row.iter().all(|cell| cell.trim().is_empty()) {
            continue;
        }
        let Some(columns) = &columns else {
            let header = header(&row, line, &mut document.problems);
            // Without a single known name it is no plan at all, and every row would be a fault.
            if header.iter().flatten().next().is_none() {
                let first = document.problems.into_iter().next();
                return Err(first.unwrap_or_else(|| whole(PlanFault::NotAPlan)));
            }
            columns = Some(header);
            continue;
        };
        if document.draft.rows.len() == MOST_FEATURES {
            document.problems.push(problem(PlanFault::TooMany { most: MOST_FEATURES }));
            break;
        }
        let filled = row.iter().rposition(|cell| !cell.trim().is_empty()).map_or(0, |last| last + 1);
        if columns.len() < filled {
            document.problems.push(problem(PlanFault::Cells { found: row.len(), expected: columns.len() }));
        }
        let mut feature = DraftFeature::at(FilePlace::line(line));
        for (column, text) in columns.iter().zip(row) {
            if let Some(column) = column {
                feature.put(*column, DraftCell::at(text.trim().to_owned(), FilePlace::line(line)));
            }
        }
        document.draft.rows.push(feature);
    }
    Ok(document)
}

/// The plan with semicolons: every column that is used. What is said of all features stands with each.
pub(super) fn write(draft: &Draft) -> String {
    let draft = draft.spread();
    let columns: Vec<Column> = draft.used().collect();
    let header = columns.iter().map(|column| column.key()).collect();
    let rows = draft.rows.iter().map(|row| columns.iter().map(|column| row.said(*column)).collect());
    let mut bytes = Vec::new();
    let mut writer = csv::WriterBuilder::new().delimiter(b';').from_writer(&mut bytes);
    let mut lines = std::iter::once(header).chain(rows);
    let written = lines.try_for_each(|cells: Vec<&str>| writer.write_record(cells)).and_then(|()| Ok(writer.flush()?));
    drop(writer);
    if let Err(error) = written {
        // A writer into memory never fails.
        log::error!("a plan as CSV: {error}");
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn whole(what: PlanFault) -> PlanError {
    Located { what, place: FilePlace::default() }
}

/// The cells of a line; none contains a line end.
fn cells(line: &str, separator: u8) -> Vec<String> {
    let reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .delimiter(separator)
        .buffer_capacity(line.len().clamp(1, 1 << 16))
        .from_reader(line.as_bytes());
    // A row of a text in memory can always be read; one that is blank is no record.
    let row = reader.into_records().find_map(Result::ok);
    row.iter().flatten().map(str::to_owned).collect()
}

/// What the columns are; `None` for one that a plan does not have, which is told.
fn header(row: &[String], line: usize, problems: &mut Vec<PlanError>) -> Vec<Option<Column>> {
    let mut columns = Vec::new();
    let mut problem = |what| problems.push(Located { what, place: FilePlace::line(line) });
    for cell in row {
        let column = Column::of_key(cell);
        match column {
            None => problem(PlanFault::UnknownColumn {
                column: super::values::beginning(cell.trim()),
                known: Column::known(),
            }),
            Some(column) if columns.contains(&Some(column)) => {
                problem(PlanFault::ColumnTwice { column: column.key() });
                columns.push(None);
                continue;
            }
            Some(_) => {}
        }
        columns.push(column);
    }
    if !columns.contains(&Some(Column::Callout)) {
        problem(PlanFault::NoColumn { column: "callout" });
    }
    columns
}
