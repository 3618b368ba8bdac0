//! Workbooks of spreadsheets (XLSX): the rows of a sheet, read as those of a CSV.
//!
//! `package` looks at the file before anything is made of it, `sheet` makes texts of cells, with the unit that a number format shows
//! (`shown`); `hidden` is what nobody sees of a sheet. Formulas count by the value that is stored with them. Of merged cells the first
//! one holds the value, as in the file: a callout over several rows is that of the first row, and the others are not judged.

mod hidden;
mod package;
mod sheet;
mod shown;

use std::collections::BTreeMap;
use std::io::BufReader;

use calamine::{Reader as _, SheetType, SheetVisible, Xlsx};
use csv::StringRecord;

use super::columns::Columns;
use super::error::{ImportError, ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::guarded::guarded;
use super::imported::{Item, Sink};
use super::mapping::Mapping;
use super::measurements::CellsReader;
use super::sample::{SAMPLE, Sample};
use super::size::SizesOf;
use super::source::{Beginning, Body, Context, Source};
use super::{Format, cells, left_out, stated};
use fitcheck_core::message::FilePlace;
use hidden::Hidden;
use package::WorkbookSheets;
use sheet::{FORMULA, Rows, UnitsShown};

pub(super) const FORMAT: Format = Format {
    name: "xlsx",
    endings: &["xlsx", "xlsm"],
    description: "exchange-format-xlsx",
    recognises: |beginning| is_zip(beginning) || is_compound(beginning),
    read: |source, sink| read(source, sink, None),
    plan: None,
    line_ends: b"",
    has_marks: true,
    shows_end: true,
};

/// The most sheets whose first rows are looked at one beside the other.
const MOST_SHEETS: usize = 50;

/// Sheets with their first rows.
pub(super) type Sheets = Vec<(String, Vec<(usize, StringRecord)>)>;

/// The most cells that are given as texts.
const MOST_CELLS: usize = 1_000_000;

fn is_zip(beginning: &Beginning<'_>) -> bool {
    beginning.bytes.starts_with(b"PK\x03\x04") || beginning.bytes.starts_with(b"PK\x05\x06")
}

/// Files of the spreadsheet programs of the last century, and workbooks with a password.
fn is_compound(beginning: &Beginning<'_>) -> bool {
    beginning.bytes.starts_with(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1")
}

type Workbook<'b> = Xlsx<BufReader<&'b mut dyn Body>>;

/// Something that cannot be read, in the words of who tried.
fn broken(error: &dyn std::fmt::Display) -> ImportErrorKind {
    ImportErrorKind::Workbook { reason: shorten(&error.to_string()) }
}

/// Opens a workbook, once it is known what it unpacks to.
fn open<'b>(source: &'b mut Source<'_>) -> Result<(Workbook<'b>, WorkbookSheets), ImportErrorKind> {
    let beginning = source.beginning();
    if is_compound(&beginning) {
        let is_locked =
            memchr::memmem::find(beginning.bytes, b"E\0n\0c\0r\0y\0p\0t\0e\0d\0P\0a\0c\0k\0a\0g\0e").is_some();
        let old = ImportErrorKind::OldWorkbook { format: "XLS" };
        return Err(if is_locked { ImportErrorKind::WorkbookPassword } else { old });
    }
    let head = beginning.bytes.get(..200).unwrap_or(beginning.bytes);
    if memchr::memmem::find(head, b"application/vnd.oasis.opendocument").is_some() {
        return Err(ImportErrorKind::OldWorkbook { format: "ODS" });
    }
    let seen = package::check(source.bytes()?)?;
    let body = source.bytes()?;
    let workbook = calm(|| Xlsx::new(BufReader::new(body)).map_err(|error| sheet::refused(&error)))?;
    Ok((workbook, seen))
}

/// Does something with a decoder that may panic in a damaged file.
fn calm<T>(decode: impl FnOnce() -> Result<T, ImportErrorKind>) -> Result<T, ImportErrorKind> {
    let damaged = |said: Option<String>| broken(&said.unwrap_or_else(|| "it is damaged".to_owned()));
    guarded(decode).unwrap_or_else(|said| Err(damaged(said)))
}

/// The units that number formats of a sheet show.
fn units(workbook: &mut Workbook<'_>, sheet: &str) -> Result<UnitsShown, ImportErrorKind> {
    calm(|| UnitsShown::of_sheet(workbook.worksheet_cells_reader(sheet).map_err(|error| sheet::refused(&error))?))
}

/// The rows of a sheet.
fn rows<'x, 'b>(
    workbook: &'x mut Workbook<'b>,
    sheet: &str,
    units: &'x UnitsShown,
) -> Result<Rows<'x, BufReader<&'b mut dyn Body>>, ImportErrorKind> {
    let cells = calm(|| workbook.worksheet_cells_reader(sheet).map_err(|error| sheet::refused(&error)))?;
    Ok(Rows::new(cells, units))
}

/// Reads the measured sizes alone: limits are not looked up.
pub(super) fn read_sizes(
    source: &mut Source<'_>,
    sink: &mut Sink<'_>,
    sizes: SizesOf<'_>,
) -> Result<(), ImportErrorKind> {
    read(source, sink, Some(sizes))
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>, sizes: Option<SizesOf<'_>>) -> Result<(), ImportErrorKind> {
    let context = source.context.clone();
    let mapping = source.given.mapping;
    let detects = Mapping::default();
    let has_plan = source.given.has_plan;
    let (mut workbook, seen) = open(source)?;
    let names = names(&workbook);
    let Chosen { sheet: chosen, columns, units, count } = choose(&mut workbook, &names, mapping.unwrap_or(&detects))?;
    let others: Vec<&String> = names.iter().filter(|name| **name != chosen).collect();
    if !others.is_empty() {
        // Who names a sheet has left the others.
        let is_named = mapping.is_some_and(|mapping| mapping.sheet().is_some());
        let others_hold: Vec<Other> =
            others.iter().filter(|_| !is_named).map(|name| Other::of(&mut workbook, name)).collect();
        let may_hold_rows = others_hold.iter().any(|other| matches!(other, Other::Rows));
        let left = others.iter().map(|name| shorten(name)).collect::<Vec<_>>().join(", ");
        let kind = ImportWarningKind::SheetsLeft { sheet: shorten(&chosen), left: shorten(&left), may_hold_rows };
        sink.warn(FilePlace::line(1), None, kind);
        // A cover sheet speaks of the values, too.
        let counted = columns.counted_at(usize::MAX, context.counted);
        let lines = others_hold.iter().flat_map(|other| match other {
            Other::Lines(lines) => lines.as_slice(),
            Other::Rows | Other::Chart => &[],
        });
        for told in lines.filter_map(|cells| left_out::said_against(cells, counted)) {
            sink.warn(FilePlace::line(1), None, told);
        }
    }
    if is_hidden(&workbook, &chosen) {
        sink.warn(FilePlace::line(1), None, ImportWarningKind::SheetHidden { sheet: shorten(&chosen) });
    }
    let hidden = seen.hidden(&chosen);
    if let Some((count, rows)) = hidden.and_then(Hidden::rows) {
        sink.warn(FilePlace::line(1), None, ImportWarningKind::RowsHidden { count, rows });
    }
    if let Some(columns) = hidden.and_then(|hidden| hidden.columns(columns.count)) {
        sink.warn(FilePlace::line(1), None, ImportWarningKind::ColumnsHidden { columns });
    }
    if SAMPLE <= count {
        agree(&mut rows(&mut workbook, &chosen, &units)?, &columns)?;
    }
    let with_comma = columns.with_decimal_comma();
    let mut rows = rows(&mut workbook, &chosen, &units)?.with_comma_in(with_comma);
    read_rows(&mut rows, (&context, &columns, &chosen, has_plan), sink, sizes)
}

/// Refuses a sheet with a row behind its first ones that states another unit.
fn agree(rows: &mut Rows<'_, BufReader<&mut dyn Body>>, columns: &Columns) -> Result<(), ImportErrorKind> {
    // What is wrong with a row is told where it is read.
    while let Ok(Some((line, cells))) = calm(|| rows.next()) {
        if let Some(reason) = stated::stray_row(columns, line, &cells) {
            return Err(reason);
        }
    }
    Ok(())
}

/// What a sheet holds that is not read.
enum Other {
    /// It looks as if something measured were in it: its columns are found, or a row of it has a callout and a value. What cannot be read
    /// may hold anything.
    Rows,
    /// Its first lines, none of them measured.
    Lines(Vec<StringRecord>),
    Chart,
}

impl Other {
    fn of(workbook: &mut Workbook<'_>, name: &str) -> Self {
        let is_table = |sheet: &calamine::Sheet| sheet.name != name || sheet.typ == SheetType::WorkSheet;
        if !workbook.sheets_metadata().iter().all(is_table) {
            return Self::Chart;
        }
        let units = UnitsShown::default();
        let sampled = rows(workbook, name, &units).and_then(|mut rows| {
            let mut sample = Vec::new();
            while sample.len() < SAMPLE
                && let Some(row) = calm(|| rows.next())?
            {
                sample.push(row);
            }
            Ok(sample)
        });
        let Ok(sample) = sampled else { return Self::Rows };
        let lines: Vec<StringRecord> = sample.iter().map(|(_, cells)| cells.clone()).collect();
        let has_rows = lines.iter().any(cells::is_data);
        let has_columns = || Mapping::default().columns(&mut Sample::of_cells(sample.into_iter())).is_ok();
        if has_rows || has_columns() { Self::Rows } else { Self::Lines(lines) }
    }
}

fn is_hidden(workbook: &Workbook<'_>, name: &str) -> bool {
    let sheet = workbook.sheets_metadata().iter().find(|sheet| sheet.name == name);
    sheet.is_some_and(|sheet| sheet.visible != SheetVisible::Visible)
}

/// The names of the sheets: those that a user sees come first.
fn names(workbook: &Workbook<'_>) -> Vec<String> {
    let mut names = workbook.sheet_names();
    names.sort_by_cached_key(|name| is_hidden(workbook, name));
    names
}

/// The sheet that is read.
struct Chosen {
    sheet: String,
    columns: Columns,
    units: UnitsShown,
    /// How many rows were looked at.
    count: usize,
}

/// The first sheet with callouts and measured values; else the first one with measured values.
fn choose(workbook: &mut Workbook<'_>, names: &[String], mapping: &Mapping) -> Result<Chosen, ImportErrorKind> {
    let mut second_best = None;
    let mut reason = None;
    if let Some(given) = mapping.sheet().filter(|sheet| !names.iter().any(|name| name == sheet)) {
        let sheets = names.iter().map(|name| shorten(name)).collect::<Vec<_>>().join(", ");
        return Err(ImportErrorKind::NoSheet { given: shorten(given), sheets: shorten(&sheets) });
    }
    for name in names.iter().filter(|name| mapping.sheet().is_none_or(|sheet| sheet == name.as_str())) {
        let mut units = UnitsShown::default();
        let mut signs = BTreeMap::new();
        let (sample, sampled) = sample(workbook, name, (&mut units, &mut signs));
        let count = sample.len();
        let columns = match sampled {
            Err(error) if sample.is_empty() => Err(error),
            // Where there are rows before a fault, they tell.
            _ => mapping.columns(&mut Sample::of_cells(sample.into_iter())),
        };
        match columns {
            Ok(mut columns) => {
                // A number of a workbook has no decimal sign: texts alone tell which one is theirs.
                if mapping.decimal().is_none() {
                    columns.each_value(|own| own.decimal_sign = signs.get(&own.measured.at).copied());
                }
                let is_best = columns.tolerance.is_some();
                let chosen = Chosen { sheet: name.clone(), columns, units, count };
                if is_best {
                    return Ok(chosen);
                }
                second_best = second_best.or(Some(chosen));
            }
            Err(ImportErrorKind::NoRows) => {}
            Err(error) => {
                let cell = shorten(name);
                reason = reason.or(Some(ImportErrorKind::Cell { cell, reason: Box::new(error) }));
            }
        }
    }
    second_best.ok_or(reason.unwrap_or(ImportErrorKind::NoRows))
}

/// The first rows of a sheet, and what went wrong behind them; the units that its number formats show go into `shown`.
fn sample(
    workbook: &mut Workbook<'_>,
    sheet: &str,
    (shown, signs): (&mut UnitsShown, &mut BTreeMap<usize, char>),
) -> (Vec<(usize, StringRecord)>, Result<(), ImportErrorKind>) {
    let mut sample = Vec::new();
    let sampled = units(workbook, sheet).and_then(|units| {
        *shown = units;
        let mut rows = rows(workbook, sheet, shown)?;
        while sample.len() < SAMPLE
            && let Some(row) = calm(|| rows.next())?
        {
            sample.push(row);
        }
        let width = sample.iter().map(|(_, cells)| cells.len()).fold(0, usize::max);
        signs.extend((0..width).filter_map(|at| Some((at, rows.sign_of(at)?))));
        Ok(())
    });
    (sample, sampled)
}

/// The sheets of a workbook with their first rows, and the place of the one that is read where none is said.
///
/// # Errors
/// Why it cannot be opened, or that it has no rows.
pub(super) fn samples(source: &mut Source<'_>) -> Result<(Sheets, usize), ImportErrorKind> {
    let (mut workbook, _seen) = open(source)?;
    let names = names(&workbook);
    let chosen = choose(&mut workbook, &names, &Mapping::default()).map(|chosen| chosen.sheet).ok();
    let mut sheets = Sheets::new();
    for name in names.into_iter().take(MOST_SHEETS) {
        let (rows, _) = sample(&mut workbook, &name, (&mut UnitsShown::default(), &mut BTreeMap::new()));
        if !rows.is_empty() || chosen.as_ref() == Some(&name) {
            sheets.push((name, rows));
        }
    }
    if sheets.is_empty() {
        return Err(ImportErrorKind::NoRows);
    }
    let place = sheets.iter().position(|(name, _)| chosen.as_ref() == Some(name)).unwrap_or(0);
    Ok((sheets, place))
}

/// Reads all rows of a sheet; an error in a row says in which cell it is.
fn read_rows(
    rows: &mut Rows<'_, BufReader<&mut dyn Body>>,
    (context, columns, sheet, has_plan): (&Context<'_>, &Columns, &str, bool),
    sink: &mut Sink<'_>,
    sizes: Option<SizesOf<'_>>,
) -> Result<(), ImportErrorKind> {
    let left = sink.left();
    let mut pass = |item| sink.pass(in_cell(item, sheet));
    let mut inner = Sink::up_to(left, &mut pass);
    let mut cells = CellsReader::new(context, columns, has_plan, &mut inner, sizes);
    loop {
        match calm(|| rows.next()) {
            Ok(Some((line, row))) => {
                if !cells.row(line, &row) {
                    return Ok(());
                }
            }
            Ok(None) => {
                cells.end();
                return Ok(());
            }
            Err(error) => return Err(ImportErrorKind::Cell { cell: shorten(sheet), reason: Box::new(error) }),
        }
    }
}

/// An error with its sheet and cell.
fn in_cell(item: Item, sheet: &str) -> Item {
    let Item::Error(mut error) = item else { return item };
    let place = &error.place;
    let cell = match (place.line, place.column) {
        (Some(line), Some(column)) => sheet::name(line, column.saturating_sub(1)),
        (Some(line), None) if error.what.kind != ImportErrorKind::NoRows => line.to_string(),
        _ => return Item::Error(error),
    };
    let ImportError { kind, given } = error.what;
    let kind = if let Some(formula) = given.strip_prefix(FORMULA) {
        ImportErrorKind::FormulaWithoutValue { formula: formula.to_owned() }
    } else if given.starts_with('#') && given.len() < 16 && given.parse::<calamine::CellErrorType>().is_ok() {
        ImportErrorKind::CellError { error: given.clone() }
    } else {
        kind
    };
    let given = given.trim_start_matches(FORMULA).to_owned();
    let cell = format!("{}!{cell}", shorten(sheet));
    error.what = ImportError { kind: ImportErrorKind::Cell { cell, reason: Box::new(kind) }, given };
    Item::Error(error)
}

/// The cells of the first sheet that has any, as texts: each row with its number from 1.
///
/// # Errors
/// Why it is not a workbook, or cannot be read.
pub(super) fn sheet_rows(source: &mut Source<'_>) -> Result<Vec<(usize, Vec<String>)>, ImportErrorKind> {
    let (mut workbook, _seen) = open(source)?;
    for name in names(&workbook) {
        let units = units(&mut workbook, &name)?;
        let mut rows = rows(&mut workbook, &name, &units)?;
        let mut all = Vec::new();
        let mut count = 0;
        while let Some((line, cells)) = calm(|| rows.next())? {
            count += cells.len();
            if MOST_CELLS < count {
                return Err(ImportErrorKind::TooManyCells { most: MOST_CELLS });
            }
            all.push((line, texts(&cells)));
        }
        if !all.is_empty() {
            return Ok(all);
        }
    }
    Err(ImportErrorKind::NoRows)
}

fn texts(cells: &StringRecord) -> Vec<String> {
    // A formula without a stored value is seen as such: as its text.
    cells
        .iter()
        .map(|cell| cell.strip_prefix(FORMULA).map_or_else(|| cell.to_owned(), |formula| format!("={formula}")))
        .collect()
}
