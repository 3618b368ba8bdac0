//! Cells as spreadsheets copy and paste them: tabs between cells, a line a row.

use fitcheck_core::part::Column;
use fitcheck_exchange::report::csv::harmless;

/// The cells of a text. A cell in quotation marks may hold tabs, line ends and doubled quotation marks; marks that do not
/// end are signs like any other.
pub(super) fn cells(text: &str) -> Vec<Vec<String>> {
    let (rows, is_quoted) = read(text, true);
    if is_quoted { read(text, false).0 } else { rows }
}

/// The cells, and whether the last one is in marks that do not end.
fn read(text: &str, with_marks: bool) -> (Vec<Vec<String>>, bool) {
    let mut rows = vec![vec![String::new()]];
    let mut signs = text.chars().peekable();
    let mut is_quoted = false;
    while let Some(sign) = signs.next() {
        let Some(cell) = rows.last_mut().and_then(|row| row.last_mut()) else { break };
        match sign {
            '"' if is_quoted && signs.peek() == Some(&'"') => {
                signs.next();
                cell.push('"');
            }
            '"' if is_quoted => is_quoted = false,
            sign if is_quoted => cell.push(sign),
            '"' if with_marks && cell.is_empty() => is_quoted = true,
            '\t' => {
                if let Some(row) = rows.last_mut() {
                    row.push(String::new());
                }
            }
            '\r' if signs.peek() == Some(&'\n') => {}
            '\n' | '\r' => rows.push(vec![String::new()]),
            sign => cell.push(sign),
        }
    }
    // Spreadsheets end the last row, too.
    if 1 < rows.len() && rows.last().is_some_and(|row| row.iter().all(String::is_empty)) {
        rows.pop();
    }
    (rows, is_quoted)
}

/// The first row of a block, which names its columns.
#[derive(Debug, Default)]
pub(super) struct Header {
    /// What each column holds; `None` for one that is left out.
    pub(super) columns: Vec<Option<Column>>,
    /// Those that are named once more.
    pub(super) twice: Vec<Column>,
    /// Names that a plan does not know.
    pub(super) unknown: Vec<String>,
}

/// The header of a block: at least two names of columns, and no more that are unknown than are known; `None` where the first row is none.
/// A cell without a name has no column.
pub(super) fn header(rows: &[Vec<String>]) -> Option<Header> {
    let first = rows.first().filter(|_| 1 < rows.len())?;
    let mut header = Header::default();
    let mut known = 0;
    for name in first {
        let name = name.trim();
        let column = Column::of_key(name);
        known += usize::from(column.is_some());
        if column.is_none() && !name.is_empty() {
            header.unknown.push(name.to_owned());
        }
        let is_twice = column.is_some() && header.columns.contains(&column);
        header.twice.extend(column.filter(|_| is_twice));
        header.columns.push(column.filter(|_| !is_twice));
    }
    (1 < known && header.unknown.len() <= known).then_some(header)
}

/// A cell without the mark that says that it is no formula.
pub(super) fn bare(column: Column, text: &str) -> &str {
    text.strip_prefix('\'').filter(|bare| column.is_free_text() && harmless(bare) == text).unwrap_or(text)
}

/// A row of cells as a line.
pub(super) fn line(row: impl Iterator<Item = (Column, String)>) -> String {
    let cells: Vec<String> = row
        .map(|(column, text)| {
            // A direction such as -Z is no formula, and comes back as it was.
            let text = if column.is_free_text() { harmless(&text) } else { text };
            if text.contains(['\t', '\n', '\r', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
        })
        .collect();
    cells.join("\t")
}
