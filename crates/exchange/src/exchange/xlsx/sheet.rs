//! The cells of a sheet as texts, row by row.

use std::collections::BTreeMap;
use std::io::{Read, Seek};

use calamine::{DataRef, ExcelDateTime, Font, Style, XlsxCellReader, XlsxError, XlsxFormulaMetadata};
use csv::StringRecord;
use fitcheck_core::length::{Length, Unit};

use super::shown;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::{cells, units};

/// Columns that are read: a cell further to the right is refused.
const MOST_COLUMNS: usize = 1_000;

/// The sign that begins the text of a formula whose value is not stored; no cell of text begins with it.
pub(super) const FORMULA: char = '\u{e000}';

/// The rows of a sheet that hold anything.
pub(super) struct Rows<'x, R: Read + Seek> {
    cells: XlsxCellReader<'x, R>,
    units: &'x UnitsShown,
    /// The first cell of the next row.
    waiting: Option<(usize, usize, String)>,
    /// The columns in which a number has a decimal comma, as the texts beside it: it has no sign of its own.
    with_comma: Vec<usize>,
    /// The decimal signs of texts that are numbers, by column: how many points and commas.
    signs: BTreeMap<usize, [usize; 2]>,
    /// The row before, from 1.
    before: usize,
    /// Whether the last cell was read.
    is_ended: bool,
}

impl<'x, R: Read + Seek> Rows<'x, R> {
    pub(super) fn new(cells: XlsxCellReader<'x, R>, units: &'x UnitsShown) -> Self {
        Self { cells, units, waiting: None, with_comma: Vec::new(), signs: BTreeMap::new(), before: 0, is_ended: false }
    }

    /// The same with a decimal comma in some columns.
    pub(super) fn with_comma_in(self, with_comma: Vec<usize>) -> Self {
        Self { with_comma, ..self }
    }

    /// The decimal sign that most texts of a column have, as far as it was read; `None` where it has numbers alone.
    pub(super) fn sign_of(&self, at: usize) -> Option<char> {
        let [points, commas] = self.signs.get(&at)?;
        Some(if points < commas { ',' } else { '.' })
    }

    /// The next row: its number from 1, and its cells.
    ///
    /// # Errors
    /// Why the sheet cannot be read on.
    pub(super) fn next(&mut self) -> Result<Option<(usize, StringRecord)>, ImportErrorKind> {
        let first = match self.waiting.take() {
            Some(cell) => Some(cell),
            None => self.cell()?,
        };
        let Some((row, mut at, mut text)) = first else { return Ok(None) };
        if row <= self.before {
            return Err(ImportErrorKind::Workbook { reason: format!("row {row} comes after row {}", self.before) });
        }
        self.before = row;
        let mut cells = StringRecord::new();
        loop {
            if at < cells.len() || MOST_COLUMNS <= at {
                let cell = name(row, at);
                return Err(if at < cells.len() {
                    ImportErrorKind::Workbook { reason: format!("cell {cell} is not in order") }
                } else {
                    ImportErrorKind::SheetWide { cell, most: MOST_COLUMNS }
                });
            }
            (cells.len()..at).for_each(|_empty| cells.push_field(""));
            cells.push_field(&text);
            match self.cell()? {
                Some((next, next_at, next_text)) if next == row => (at, text) = (next_at, next_text),
                other => {
                    self.waiting = other;
                    return Ok(Some((row, cells)));
                }
            }
        }
    }

    /// The next cell that holds anything: row from 1, column from 0, text.
    fn cell(&mut self) -> Result<Option<(usize, usize, String)>, ImportErrorKind> {
        let index = |number: u32| usize::try_from(number).unwrap_or(usize::MAX);
        while !self.is_ended
            && let Some(cell) = self.cells.next_cell_with_formula_metadata().map_err(|error| refused(&error))?
        {
            let (row, at) = cell.pos;
            let text = match (&cell.value, &cell.formula) {
                (DataRef::Empty, Some(formula)) => format!("{FORMULA}{}", of_formula(formula)),
                (DataRef::Float(number), _) if self.with_comma.contains(&index(at)) => typed(*number).replace('.', ","),
                (value @ (DataRef::String(_) | DataRef::SharedString(_)), _) => {
                    let text = text(value);
                    if let Some(sign) = cells::sign_of(&text).filter(|_| cells::is_number(&text)) {
                        let [points, commas] = self.signs.entry(index(at)).or_default();
                        *if sign == ',' { commas } else { points } += 1;
                    }
                    text
                }
                (value, _) => text(value),
            };
            // A number that was typed as text stands before the unit of its format, too.
            let is_number = matches!(cell.value, DataRef::Int(_) | DataRef::Float(_))
                || Length::parse_in(&text, Unit::Millimetre).is_ok();
            let text = match self.units.of(row, at).filter(|_| is_number) {
                Some(unit) => with_unit(&text, unit),
                None => text,
            };
            if !text.is_empty() {
                return Ok(Some((index(row).saturating_add(1), index(at), text)));
            }
        }
        self.is_ended = true;
        Ok(None)
    }
}

/// The most runs of cells whose number formats show a unit.
const MOST_RUNS: usize = 1_000_000;

/// What stands behind a number that somebody has crossed out, so that it is none.
const STRUCK: &str = "(struck through)";

/// The units that number formats of a sheet show, where any do; a number that is struck through shows that as its unit.
#[derive(Debug, Default)]
pub(super) struct UnitsShown {
    /// By style: the text of its unit, or nothing.
    units: Vec<Option<String>>,
    /// By column, from 0: first and last row of neighbouring cells with the same unit.
    runs: BTreeMap<u32, Vec<(u32, u32, usize)>>,
}

impl UnitsShown {
    /// Those of a sheet; it is read through where the workbook has such a format at all.
    ///
    /// # Errors
    /// Why the sheet cannot be read on.
    pub(super) fn of_sheet<R: Read + Seek>(mut cells: XlsxCellReader<'_, R>) -> Result<Self, ImportErrorKind> {
        let shown = |style: &Style| {
            let is_struck = style.font.as_ref().is_some_and(Font::has_strikethrough);
            let unit = || shown::unit(&style.number_format.as_ref()?.format_code);
            if is_struck { Some(STRUCK.to_owned()) } else { unit() }
        };
        let shown: Vec<_> = cells.styles().iter().map(shown).collect();
        let mut all = Self::default();
        if shown.iter().all(Option::is_none) {
            return Ok(all);
        }
        let mut count = 0;
        while let Some((row, at, style)) = cells.next_style_id().map_err(|error| refused(&error))? {
            // Where cells without a style of their own show a unit, those with one are told apart from them.
            let is_kept = shown.get(style).is_some_and(Option::is_some) || shown.first().is_some_and(Option::is_some);
            if !is_kept {
                continue;
            }
            let runs = all.runs.entry(at).or_default();
            match runs.last_mut() {
                // Other styles of a table, such as those of every second row, may show the same unit.
                Some((_, last, own)) if shown.get(*own) == shown.get(style) && last.checked_add(1) == Some(row) => {
                    *last = row;
                }
                _ => {
                    count += 1;
                    if MOST_RUNS < count {
                        return Err(ImportErrorKind::TooManyCells { most: MOST_RUNS });
                    }
                    runs.push((row, row, style));
                }
            }
        }
        all.units = shown;
        Ok(all)
    }

    /// The unit behind the number of a cell: row and column from 0.
    fn of(&self, row: u32, at: u32) -> Option<&str> {
        let style = self.runs.get(&at).and_then(|runs| {
            let (_, last, style) = runs.get(runs.partition_point(|(first, ..)| *first <= row).checked_sub(1)?)?;
            (row <= *last).then_some(*style)
        });
        // A cell without a style of its own has the first one.
        let shown = self.units.get(style.unwrap_or(0))?.as_deref();
        shown.filter(|unit| !unit.is_empty())
    }
}

/// A number with the unit that its format shows: inches as millimetres, since cells are read without an inch behind them; what is not
/// a length with a known unit is refused by whoever reads it.
fn with_unit(text: &str, unit: &str) -> String {
    match units::known(unit) {
        Some(Unit::Inch) => match Length::parse_in(text, Unit::Inch) {
            Ok(length) => format!("{length} mm"),
            Err(_) => format!("{text} {unit}"),
        },
        Some(Unit::Micrometre) => format!("{text} \u{b5}m"),
        Some(Unit::Millimetre) => format!("{text} mm"),
        _ => format!("{text} {unit}"),
    }
}

/// What the reader of workbooks says.
pub(super) fn refused(error: &XlsxError) -> ImportErrorKind {
    match error {
        XlsxError::Password => ImportErrorKind::WorkbookPassword,
        error => super::broken(error),
    }
}

/// The name of a cell, such as `C7`: row from 1, column from 0.
pub(super) fn name(row: usize, at: usize) -> String {
    format!("{}{row}", letters(at))
}

/// The name of a column from 0, such as `C`.
pub(super) fn letters(mut at: usize) -> String {
    let mut letters = String::new();
    loop {
        let letter = u8::try_from(at % 26).map_or('?', |letter| char::from(b'A' + letter));
        letters.insert(0, letter);
        if at < 26 {
            return letters;
        }
        at = at / 26 - 1;
    }
}

fn of_formula(formula: &XlsxFormulaMetadata) -> &str {
    match formula {
        XlsxFormulaMetadata::Normal { formula } | XlsxFormulaMetadata::Shared { formula, .. } => formula,
        _ => "",
    }
}

/// What a cell holds, without its format.
fn text(value: &DataRef<'_>) -> String {
    match value {
        DataRef::Int(number) => number.to_string(),
        DataRef::Float(number) => typed(*number),
        DataRef::String(text) | DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => without_marks(text),
        DataRef::SharedString(text) => without_marks(text),
        DataRef::Bool(is_true) => if *is_true { "TRUE" } else { "FALSE" }.to_owned(),
        DataRef::DateTime(time) => date_time(time),
        DataRef::Error(error) => error.to_string(),
        DataRef::Empty => String::new(),
    }
}

fn without_marks(text: &str) -> String {
    text.trim_start_matches(FORMULA).to_owned()
}

/// The decimal number that was typed: a workbook has it as a double, with up to 17 digits. Spreadsheet programs show 15.
fn typed(number: f64) -> String {
    let fifteen = format!("{number:.14e}").parse().unwrap_or(number);
    // Less than a micrometre of a micrometre is what a subtraction leaves behind.
    f64::to_string(&fifteen)
}

/// A date, a time, or both, as ISO 8601 writes them.
fn date_time(time: &ExcelDateTime) -> String {
    let (year, month, day, hour, minute, second, millisecond) = time.to_ymd_hms_milli();
    let of_day = if millisecond == 0 {
        format!("{hour:02}:{minute:02}:{second:02}")
    } else {
        format!("{hour:02}:{minute:02}:{second:02}.{millisecond:03}")
    };
    if time.is_duration() || time.as_f64() < 1.0 {
        return of_day;
    }
    let date = format!("{year:04}-{month:02}-{day:02}");
    if time.as_f64().fract() == 0.0 { date } else { format!("{date} {of_day}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_have_the_names_that_spreadsheets_show() {
        for (row, at, expected) in [(7, 2, "C7"), (1, 25, "Z1"), (1, 26, "AA1"), (9, 701, "ZZ9"), (9, 702, "AAA9")] {
            assert_eq!(name(row, at), expected);
        }
    }

    #[test]
    fn numbers_are_those_that_were_typed() {
        for (number, expected) in
            [(25.0123, "25.0123"), (25.1 - 0.1, "25"), (0.1 + 0.2, "0.3"), (-0.004, "-0.004"), (1e-7, "0.0000001")]
        {
            assert_eq!(typed(number), expected);
        }
    }
}
