//! The mask and the table of a series.
//!
//! The mask prints a block for each part: every value between its limits, then mean and range so far. Six decimals are nanometres, so
//! that what is read back is what was judged. The words are those of the control's dialogue (`assets/dialogues`).

use std::fmt::Write as _;

use super::Planned;
use super::error::SetError;
use super::names::{Control, Names};
use super::series::{CHECKED, COLUMNS, MAXIMUM, MEAN, MEASURED, MINIMUM, RANGE, STATUS, SeriesSize, sizes};
use crate::control::table::{Column, ControlTable, Generation, TableUnit};

/// Every size with its number.
fn numbered(planned: &[Planned<'_>]) -> Vec<(usize, SeriesSize)> {
    (0..).zip(planned.iter().flat_map(|planned| sizes(*planned))).collect()
}

/// The mask, lines in CRLF.
pub(super) fn mask(names: &Names<'_>, planned: &[Planned<'_>]) -> Vec<u8> {
    let words = &names.target.language.words().series;
    let (number, whole) = match names.target.control {
        Control::Itnc530 => ("%11.6LF", "%4.0LF"),
        Control::Tnc640 | Control::Tnc7 => ("%11.6F", "%4.0F"),
    };
    let mut text = format!("\"{}: {whole}\", Q94;\n\"{}: %S\", QS15;\n", words.part, words.status);
    for (at, SeriesSize { column, limits, .. }) in numbered(planned) {
        let (front, parameters) = match limits {
            Some(_) => (
                format!("{}:{number}  {}:{number}  ", words.minimum, words.maximum),
                format!("Q{}, Q{}, ", MINIMUM + at, MAXIMUM + at),
            ),
            None => (String::new(), String::new()),
        };
        let _infallible = write!(
            text,
            "\"{column}: %S  {front}{}:{number}  %S\", QS{}, {parameters}Q{}, QS{};\n\
             \"{column} {}:{number}  {}:{number}\", Q{}, Q{};\n",
            words.measured,
            CHECKED + at,
            MEASURED + at,
            STATUS + at,
            words.mean,
            words.range,
            MEAN + at,
            RANGE + at
        );
    }
    let _infallible = write!(text, "\"{}: %S\", QS10;\nM_APPEND;\nM_CLOSE;\n", words.worst);
    text.replace('\n', "\r\n").into_bytes()
}

/// The table with a row for each part; the counter 0 is that of a row without a part.
pub(super) fn table(names: &Names<'_>, planned: &[Planned<'_>], parts: u16) -> Result<Vec<u8>, SetError> {
    let generation = names.target.control.generation();
    let [number, part, status] = COLUMNS;
    let mut columns = vec![column(number, 8, generation, None), column(part, 8, generation, Some(0))];
    columns.extend(numbered(planned).iter().map(|(_, size)| column(&size.column, 13, generation, Some(6))));
    columns.push(text(status, 14, generation));
    let rows = (0..parts).map(|row| {
        let mut cells = vec![row.to_string(), "0".to_owned()];
        cells.resize(columns.len(), String::new());
        cells
    });
    let rows = rows.collect();
    let (name, suffix) = names.series_table.rsplit_once('.').unwrap_or((names.series_table, "tab"));
    let (name, suffix) = (name.to_owned(), Some(suffix.to_owned()));
    let unit = Some(TableUnit::Millimetre);
    let table = ControlTable { name, suffix, unit, generation, columns, rows, ..ControlTable::default() };
    table.write().map_err(|error| SetError::Table { table: names.series_table, error })
}

/// A column of numbers with so many decimals. `#STRUCTBEGIN` does not describe the number of the row.
fn column(name: &str, width: usize, generation: Generation, decimals: Option<usize>) -> Column {
    let width = width.max(name.len() + 1);
    let kind = match (generation, decimals) {
        (Generation::Plain, _) | (Generation::Structure, None) => None,
        (Generation::Structure, Some(_)) => Some("N"),
        (Generation::Description, None | Some(0)) => Some("INT"),
        // Never LENGTH: a control set to inches would convert it.
        (Generation::Description, Some(_)) => Some("FLOAT"),
    };
    let decimals = decimals.filter(|_| generation == Generation::Structure);
    Column { kind: kind.map(str::to_owned), decimals, ..Column::plain(name, width) }
}

fn text(name: &str, width: usize, generation: Generation) -> Column {
    let (kind, decimals) = match generation {
        Generation::Plain => (None, None),
        Generation::Structure => (Some("C"), Some(0)),
        Generation::Description => (Some("TEXT"), None),
    };
    Column { kind: kind.map(str::to_owned), decimals, ..Column::plain(name, width) }
}
