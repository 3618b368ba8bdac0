//! Tables of characteristics of CALYPSO: `NAME_chr.txt`.
//!
//! Columns are separated by tabs and found by the names in the first line; a row may be shorter than that, and the last line is `END`.
//! Tolerances are deviations from the nominal value. The table says neither hole nor shaft, and has no time: that is in another file.

mod columns;
mod error;
mod row;

use columns::{Column, Columns};
pub use error::{CalypsoFault, CalypsoWarning};
use fitcheck_core::length::Unit;
use fitcheck_core::message::FilePlace;
use fitcheck_core::text::{PLAIN_LINE_END_BYTES, PLAIN_LINE_ENDS, lines, plain_lines_from};
use row::{CalypsoRow, RefusedRow};

use super::characteristic::Characteristics;
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::imported::Sink;
use super::index::LONGEST_ROW;
use super::source::{Beginning, Context, Source};
use super::{Format, units};

pub(super) const FORMAT: Format = Format {
    name: "calypso",
    endings: &["txt"],
    description: "exchange-format-calypso",
    recognises,
    read,
    plan: Some(plan),
    line_ends: b"",
    has_marks: true,
    shows_end: false,
};

impl From<CalypsoFault> for ImportErrorKind {
    fn from(fault: CalypsoFault) -> Self {
        Self::Calypso(fault)
    }
}

impl From<CalypsoWarning> for ImportWarningKind {
    fn from(warning: CalypsoWarning) -> Self {
        Self::Calypso(warning)
    }
}

/// The last line.
const END: &str = "END";

fn recognises(beginning: &Beginning<'_>) -> bool {
    let text = beginning.text();
    lines(&text)
        .map(|(_, line)| line)
        .find(|line| !line.trim().is_empty())
        .is_some_and(|line| Columns::of(line).is_some())
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let context = source.context.clone();
    let unit = source.given_unit();
    let mut reader = Reader { context, sink, rounded: None, unit, is_unit_told: false };
    let mut last = None;
    let end = each(source, &mut |line, text, columns, is_open| {
        if reader.sink.is_full(line) {
            return false;
        }
        last = Some(line);
        reader.row(line, text, columns, is_open);
        true
    })?;
    reader.end(&end);
    if last.is_none() {
        return Err(ImportErrorKind::NoRows);
    }
    Ok(())
}

/// How a table ended.
struct End {
    /// The line of the header, and the columns that are not used.
    header: usize,
    skipped: String,
    /// The last line that was read.
    line: usize,
    is_whole: bool,
    /// A line of bytes 0 alone.
    zeros: Option<usize>,
    /// Whether all was read that was wanted.
    is_stopped: bool,
    /// A line behind the end.
    behind: Option<(usize, String)>,
}

/// Hands out the rows with their lines, until `take` wants no more.
fn each(
    source: &mut Source<'_>,
    take: &mut dyn FnMut(usize, &str, &Columns, bool) -> bool,
) -> Result<End, ImportErrorKind> {
    let mut pieces = source.pieces(PLAIN_LINE_END_BYTES)?;
    let mut columns = None;
    let mut end = End {
        header: 1,
        skipped: String::new(),
        line: 1,
        is_whole: false,
        zeros: None,
        is_stopped: false,
        behind: None,
    };
    while let Some(piece) = pieces.next()? {
        let is_open = !piece.ends_with(PLAIN_LINE_ENDS);
        let first = end.line + usize::from(columns.is_some());
        let mut lines = plain_lines_from(&piece, first).peekable();
        while let Some((line, text)) = lines.next() {
            end.line = line;
            let is_last = is_open && lines.peek().is_none();
            if text.trim().is_empty() || text.trim() == "\u{1a}" {
                continue;
            }
            if text.trim_matches('\0').trim().is_empty() {
                end.zeros = Some(line);
                continue;
            }
            if end.is_whole {
                end.behind = Some((line, shorten(text.trim())));
                return Ok(end);
            }
            let Some(columns) = &columns else {
                let found = Columns::of(text).ok_or(ImportErrorKind::NotRecognised)?;
                end.header = line;
                end.skipped = found.skipped();
                columns = Some(found);
                continue;
            };
            if text.trim() == END {
                end.is_whole = true;
            } else if !take(line, text, columns, is_last) {
                end.is_stopped = true;
                return Ok(end);
            }
        }
    }
    Ok(end)
}

/// Why a row cannot be read whatever stands in it: half a number in its last cell would be judged as a whole one.
fn broken(text: &str, is_open: bool) -> Option<ImportErrorKind> {
    match (text.contains('\0'), is_open) {
        _ if LONGEST_ROW < text.len() => Some(ImportErrorKind::RowTooLong { most: LONGEST_ROW >> 10 }),
        (true, _) => Some(CalypsoFault::Zeros.into()),
        (false, true) => Some(CalypsoFault::RowCutOff.into()),
        (false, false) => None,
    }
}

/// Reads the rows.
struct Reader<'a, 's> {
    context: Context<'a>,
    sink: &'a mut Sink<'s>,
    /// Values that were rounded: the line of the first one, and how many.
    rounded: Option<(usize, usize)>,
    /// The unit of what says none, where the user has said it.
    unit: Option<Unit>,
    is_unit_told: bool,
}

impl Reader<'_, '_> {
    fn row(&mut self, line: usize, text: &str, columns: &Columns, is_open: bool) {
        if let Some(kind) = broken(text, is_open) {
            return self.sink.refuse(FilePlace::line(line), kind, shorten(text.trim_matches('\0').trim()));
        }
        let read = CalypsoRow::read(line, text, columns, self.unit).and_then(|row| {
            if let Some(value) = &row.value {
                return Ok((value.clone(), row));
            }
            let (column, _) = columns.named(Column::Actual);
            Err(RefusedRow { kind: CalypsoFault::NoActual.into(), column, given: text })
        });
        let (value, row) = match read {
            Ok(read) => read,
            Err(refused) => {
                let place = refused.column.map_or(FilePlace::line(line), |column| FilePlace::in_line(line, column));
                return self.sink.refuse(place, refused.kind, shorten(refused.given));
            }
        };
        if row.is_unit_assumed && !self.is_unit_told {
            self.is_unit_told = true;
            self.sink.warn(FilePlace::line(line), None, ImportWarningKind::UnitAssumed);
        }
        if row.is_rounded {
            let (first, count) = self.rounded.unwrap_or((line, 0));
            self.rounded = Some((first, count + 1));
        }
        for warning in row.doubts(value.measured) {
            self.sink.warn(FilePlace::line(line), Some(line), warning.into());
        }
        row.characteristic.judge(value, &self.context, self.sink);
    }

    fn end(&mut self, end: &End) {
        let mut warn = |line, kind| self.sink.warn(FilePlace::line(line), None, kind);
        if !end.skipped.is_empty() {
            warn(end.header, ImportWarningKind::IgnoredColumns { columns: end.skipped.clone() });
        }
        if let Some((line, count)) = self.rounded {
            warn(line, ImportWarningKind::RoundedValues { count });
        }
        if let Some(line) = end.zeros {
            warn(line, CalypsoWarning::Zeros.into());
        }
        if !end.is_whole && !end.is_stopped {
            warn(end.line, CalypsoWarning::NoEnd.into());
        }
        if let Some((line, text)) = &end.behind {
            warn(*line, CalypsoWarning::Behind { given: text.clone() }.into());
        }
    }
}

fn plan(source: &mut Source<'_>, found: &mut Characteristics) -> Result<(), ImportErrorKind> {
    let unit = source.given_unit();
    let end = each(source, &mut |line, text, columns, is_open| {
        if let Some(kind) = broken(text, is_open) {
            found.refuse(line, kind);
            return true;
        }
        match CalypsoRow::read(line, text, columns, unit) {
            Ok(CalypsoRow { characteristic, is_unit_assumed, .. }) => {
                if is_unit_assumed {
                    found.tell(line, ImportWarningKind::UnitAssumed);
                }
                let (name, asked) = (&characteristic.name, characteristic.said());
                let other = found.of_name(name).find(|(_, known)| known.said() != asked).map(|(first, _)| *first);
                match other {
                    Some(first) => {
                        let fault = CalypsoFault::Differs { name: characteristic.id(), first, second: line };
                        found.refuse(line, fault.into());
                    }
                    None => found.add(line, characteristic),
                }
            }
            Err(RefusedRow { kind: ImportErrorKind::Unit { unit }, .. }) if units::is_of_angle(&unit) => {
                // An angle is no size, and refuses no other characteristic.
                let cells: Vec<&str> = text.split('\t').collect();
                found.add_other(line, columns.text(&cells, Column::Id).to_owned(), unit);
            }
            Err(refused) => found.refuse(line, refused.kind),
        }
        true
    })?;
    if !end.is_whole {
        found.refuse(end.line, CalypsoFault::CutOff.into());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLATE: &[u8] = include_bytes!("../../../../../tests/data/calypso/plate_chr.txt");

    fn planned(bytes: &[u8]) -> Result<Vec<(usize, String)>, String> {
        let plan = FORMAT.declared("plate_chr.txt", bytes, None)?;
        Ok(plan.into_iter().map(|(line, of)| (line, of.name)).collect())
    }

    #[test]
    fn each_characteristic_is_planned_once_however_many_parts_there_are() {
        let names = ["BORE1_X", "BORE1_Y", "BORE1_D", "BORE2_D", "PIN1_D"];
        let expected: Vec<(usize, String)> = (2..).zip(names.map(str::to_owned)).collect();
        assert_eq!(planned(PLATE), Ok(expected.clone()));
        let text = std::str::from_utf8(PLATE).unwrap();
        let (header, rows) = text.split_once('\n').unwrap();
        let rows = rows.strip_suffix("END\r\n").unwrap();
        assert_eq!(planned(format!("{header}\n{rows}{rows}END\n").as_bytes()), Ok(expected));
    }

    #[test]
    fn two_rows_of_one_name_that_ask_for_different_things_are_no_plan() {
        let text = std::str::from_utf8(PLATE).unwrap();
        let row = text.lines().find(|line| line.contains("BORE1_D")).unwrap();
        let other = row.replacen("25.0000000", "30.0000000", 1);
        assert_ne!(row, other);
        let both = text.replace(row, &format!("{row}\r\n{other}"));
        let said = "the rows of BORE1_D in lines 4 and 5 have different nominal values or limits";
        assert_eq!(planned(both.as_bytes()), Err(said.to_owned()));
    }

    #[test]
    fn what_is_no_plan_says_why() {
        let cut_off = "the last line, END, is missing: the file may be cut off";
        assert_eq!(planned(&PLATE[..PLATE.len() - 5]), Err(cut_off.to_owned()));
        let text = std::str::from_utf8(PLATE).unwrap().replace("25.0123000", "25.0l");
        assert_eq!(planned(text.as_bytes()), Err("actual: 25.0l is not a number".to_owned()));
    }
}
