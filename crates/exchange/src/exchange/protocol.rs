//! Printed reports of CALYPSO, as text: a table whose columns stand below their names, and a row for each characteristic.
//!
//! ```text
//! Part name   HOUSING                      Part ident   17
//! Name             Measured value   Nominal value    +Tol     -Tol   Deviation   +/-
//! Diameter_Bore1        25.012 mm          25.000   0.021    0.000       0.012
//! ```
//!
//! Two blanks or more stand between columns, and one within a cell. Both tolerances are deviations with their signs. A row without
//! tolerances is shorter; a row with one alone could be read in two ways and is refused. A report says neither hole nor shaft, and the name
//! of a characteristic may say what was measured.

use csv::StringRecord;
use fitcheck_core::length::{Length, LengthError, Unit};
use fitcheck_core::message::FilePlace;
use fitcheck_core::text::lines;

use super::characteristic::{Characteristic, CharacteristicKind, Value};
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::head::Head;
use super::imported::{Sink, StatedLimits, WhyUnjudged};
use super::limits;
use super::printed::{Computed, LeftLines, Printed, PrintedFault, PrintedLine, each_line, set_aside};
use super::quantity::{self, Quantity};
use super::role::Role;
use super::source::{Beginning, Context, Source};
use super::{Format, Labels, units, words};

pub(super) const FORMAT: Format = Format {
    name: "calypso-text",
    endings: &["txt"],
    description: "exchange-format-calypso-text",
    recognises: |beginning: &Beginning<'_>| lines(&beginning.text()).any(|(_, line)| Columns::of(line).is_some()),
    read,
    plan: Some(plan),
    line_ends: b"",
    has_marks: true,
    shows_end: false,
};

/// What stands below a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Column {
    Measured,
    Nominal,
    Upper,
    Lower,
    Deviation,
    /// How far the value is beyond its tolerance; empty within it.
    Beyond,
}

/// The columns behind the name of a characteristic, in their order.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Columns(Vec<Column>);

/// The cells of a line.
fn cells(line: &str) -> Vec<&str> {
    line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect()
}

impl Columns {
    /// Those of a heading; `None` where a line is none.
    fn of(line: &str) -> Option<Self> {
        if line.contains(['\t', ';']) {
            return None;
        }
        let (_, names) = cells(line).split_first().map(|(first, names)| (*first, names.to_vec()))?;
        let column = |name: &&str| {
            Some(match words::role(name) {
                Some((Role::Measured, _)) => Column::Measured,
                Some((Role::Nominal, _)) => Column::Nominal,
                Some((Role::Upper, _)) => Column::Upper,
                Some((Role::Lower, _)) => Column::Lower,
                _ if super::beside::is_deviation(name) => Column::Deviation,
                _ if limits::goes_both_ways(name) => Column::Beyond,
                _ => return None,
            })
        };
        let found: Vec<Column> = names.iter().map(column).collect::<Option<_>>()?;
        let has_one = |wanted: Column| found.iter().filter(|column| **column == wanted).count() == 1;
        let needed = [Column::Measured, Column::Nominal, Column::Upper, Column::Lower];
        let is_twice = found.iter().any(|column| !has_one(*column));
        (needed.into_iter().all(has_one) && !is_twice).then_some(Self(found))
    }

    /// The columns that so many cells stand in: the last one may be empty, and both tolerances with it.
    fn below(&self, count: usize) -> Option<Vec<Column>> {
        let is_tolerance = |column: &Column| matches!(column, Column::Upper | Column::Lower);
        let mut all = self.0.clone();
        if all.len() == count {
            return Some(all);
        }
        all.retain(|column| *column != Column::Beyond);
        if all.len() != count {
            all.retain(|column| !is_tolerance(column));
        }
        (all.len() == count).then_some(all)
    }
}

/// A row of a table.
struct Row {
    characteristic: Characteristic,
    measured: Printed,
    asked: StatedLimits,
    computed: Computed,
    /// Whether it has a unit.
    has_unit: bool,
}

/// What a line of a report is.
enum Line {
    Columns(Columns),
    Row(Result<Box<Row>, ImportErrorKind>),
    /// An angle: its name.
    Angle(String),
    Head(Head),
    Other,
}

/// The sign of an angle, and its words.
fn is_angle(cell: &str) -> bool {
    cell.contains('°') || cell.ends_with(" deg") || cell.ends_with(" rad")
}

/// Whether a cell is a figure with decimals, or an angle.
fn is_figure(cell: &str) -> bool {
    let begins =
        cell.trim_start_matches(['+', '-', '\u{2212}', '.', ',']).starts_with(|sign: char| sign.is_ascii_digit());
    let first = cell.split(' ').next().unwrap_or(cell);
    begins && (is_angle(cell) || first.contains(['.', ',']) && first.parse::<jiff::civil::Date>().is_err())
}

fn line(text: &str, number: usize, columns: Option<&Columns>) -> Line {
    if let Some(columns) = Columns::of(text) {
        return Line::Columns(columns);
    }
    let cells = cells(text);
    let head = || {
        let record = (number, StringRecord::from(cells.clone()));
        Some(Head::of(std::iter::once(&record))).filter(|head| head.said.is_some())
    };
    let row = match (cells.as_slice(), columns) {
        ([name, first, ..], Some(columns)) if is_figure(first) => Some((*name, *first, columns)),
        _ => None,
    };
    match (row, head()) {
        (Some((name, first, _)), _) if is_angle(first) => Line::Angle(name.to_owned()),
        (Some((name, _, columns)), head) => match (columns.below(cells.len() - 1), head) {
            (None, Some(head)) => Line::Head(head),
            (None, None) => {
                let found = cells.len() - 1;
                Line::Row(Err(PrintedFault::Cells { found, expected: columns.0.len() }.into()))
            }
            (Some(below), _) => {
                let figures: Vec<(Column, &str)> = below.into_iter().zip(cells.iter().skip(1).copied()).collect();
                Line::Row(Row::read(name, &figures).map(Box::new))
            }
        },
        (None, Some(head)) => Line::Head(head),
        (None, None) => Line::Other,
    }
}

/// A figure without its unit, and that unit.
fn figure(cell: &str) -> Result<(&str, Option<Unit>), ImportErrorKind> {
    match cell.rsplit_once(' ') {
        Some((number, unit)) => match units::known(unit) {
            Some(unit) => Ok((number.trim(), Some(unit))),
            None => Err(ImportErrorKind::Unit { unit: shorten(unit) }),
        },
        None => Ok((cell, None)),
    }
}

impl Row {
    fn read(name: &str, figures: &[(Column, &str)]) -> Result<Self, ImportErrorKind> {
        let cell = |wanted: Column| figures.iter().find(|(column, _)| *column == wanted).map(|(_, cell)| *cell);
        let missing = || PrintedFault::NoValue { column: "Measured value" };
        let (_, unit) = figure(cell(Column::Measured).ok_or_else(missing)?)?;
        let read = |wanted: Column| -> Result<Option<Printed>, ImportErrorKind> {
            let Some(cell) = cell(wanted) else { return Ok(None) };
            let (number, own) = figure(cell)?;
            let unit = own.or(unit).unwrap_or(Unit::Millimetre);
            let wrong = |reason: LengthError| PrintedFault::Number { column: word(wanted).to_owned(), reason }.into();
            Printed::read(number, unit).map(Some).map_err(wrong)
        };
        let measured = read(Column::Measured)?.ok_or_else(missing)?;
        let nominal = read(Column::Nominal)?.map(|nominal| nominal.length);
        let limit = |wanted: Column| -> Result<Option<Length>, ImportErrorKind> {
            let Some((nominal, deviation)) = nominal.zip(read(wanted)?) else { return Ok(None) };
            let too_large = || LengthError::TooLarge { text: cell(wanted).unwrap_or("").to_owned() };
            let wrong = || PrintedFault::Number { column: word(wanted).to_owned(), reason: too_large() }.into();
            nominal.checked_add(deviation.length).map(Some).ok_or_else(wrong)
        };
        let asked = StatedLimits { nominal, minimum: limit(Column::Lower)?, maximum: limit(Column::Upper)? };
        let computed = Computed { deviation: read(Column::Deviation)?, beyond: read(Column::Beyond)? };
        let quantity = quantity::of_text(name);
        let what = match quantity {
            Some(Quantity::Diameter) => CharacteristicKind::Size,
            _ if asked.minimum.is_none() && asked.maximum.is_none() => {
                CharacteristicKind::Length(WhyUnjudged::NoTolerance)
            }
            _ => CharacteristicKind::Length(WhyUnjudged::NotASize { what: shorten(name) }),
        };
        let characteristic = Characteristic {
            name: name.to_owned(),
            what,
            class: String::new(),
            feature: None,
            nominal,
            minimum: asked.minimum,
            maximum: asked.maximum,
            expanded: None,
            labels: Labels { quantity, ..Labels::default() },
        };
        Ok(Self { characteristic, measured, asked, computed, has_unit: unit.is_some() })
    }
}

/// What a report calls a column.
const fn word(column: Column) -> &'static str {
    match column {
        Column::Measured => "Measured value",
        Column::Nominal => "Nominal value",
        Column::Upper => "+Tol",
        Column::Lower => "-Tol",
        Column::Deviation => "Deviation",
        Column::Beyond => "+/-",
    }
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let context = source.context.clone();
    let mut reader = Reader { context, sink, columns: None, head: Head::default(), has_unit: true };
    let mut left = LeftLines::default();
    each_line(source, &mut |line| {
        if reader.sink.is_full(line.number) {
            return false;
        }
        reader.line(line, &mut left);
        true
    })?;
    left.tell(reader.sink);
    if reader.sink.rows() == 0 { Err(ImportErrorKind::NoRows) } else { Ok(()) }
}

/// Reads the lines.
struct Reader<'a, 's> {
    context: Context<'a>,
    sink: &'a mut Sink<'s>,
    columns: Option<Columns>,
    /// What the lines above the rows say of all of them.
    head: Head,
    has_unit: bool,
}

impl Reader<'_, '_> {
    fn line(&mut self, printed: PrintedLine<'_>, left: &mut LeftLines) {
        let PrintedLine { number, text, .. } = printed;
        let found = line(text, number, self.columns.as_ref());
        let is_row = matches!(found, Line::Row(_) | Line::Angle(_));
        if let Some(kind) = printed.broken(false).filter(|_| is_row) {
            return self.sink.refuse(FilePlace::line(number), kind, shorten(text.trim_matches('\0').trim()));
        }
        match found {
            Line::Columns(columns) => self.columns = Some(columns),
            Line::Head(head) => self.head(number, head),
            Line::Row(Ok(row)) => self.row(number, *row),
            Line::Row(Err(kind)) => self.sink.refuse(FilePlace::line(number), kind, shorten(text.trim())),
            Line::Angle(name) => {
                let labels = Labels { quantity: Some(Quantity::Other), ..self.labels(Labels::default()) };
                let why = WhyUnjudged::NotASize { what: shorten(&name) };
                self.sink.set_aside(set_aside(number, name, labels, self.head.time, why, &self.context));
            }
            Line::Other => left.add(printed),
        }
    }

    /// What a line of the head says, told where it is new: the head stands again on each page.
    fn head(&mut self, line: usize, head: Head) {
        let said = head.said.clone().map(|(_, said)| said);
        if let Some(said) = said.filter(|_| self.head.go_on(head)) {
            self.sink.warn(FilePlace::line(line), None, ImportWarningKind::HeadRead { said });
        }
    }

    fn labels(&self, labels: Labels) -> Labels {
        let Head { part, serial, who, machine, batch, .. } = self.head.clone();
        Labels { part, serial, who, batch, machine, ..labels }
    }

    fn row(&mut self, line: usize, row: Row) {
        let Row { characteristic, measured, asked, computed, has_unit } = row;
        if !has_unit && std::mem::replace(&mut self.has_unit, false) {
            self.sink.warn(FilePlace::line(line), None, ImportWarningKind::UnitAssumed);
        }
        for warning in computed.tells(measured.length, &asked) {
            self.sink.warn(FilePlace::line(line), Some(line), warning.into());
        }
        let said = computed.beyond.map_or_else(String::new, |beyond| format!("+/- {}", beyond.length));
        let labels = Labels {
            claims: computed.claim(&said).into_iter().collect(),
            rounded_by: measured.rounded_by(),
            ..self.labels(characteristic.labels.clone())
        };
        let time = self.head.time;
        let value = Value { line, measured: measured.length, time, labels, is_simulated: false };
        characteristic.judge(value, &self.context, self.sink);
    }
}

/// The characteristics, each once however many parts the report has.
fn plan(source: &mut Source<'_>) -> Result<Vec<(usize, Characteristic)>, ImportErrorKind> {
    let mut plan: Vec<(usize, Characteristic)> = Vec::new();
    let mut columns = None;
    let mut fault = None;
    each_line(source, &mut |printed| {
        match line(printed.text, printed.number, columns.as_ref()) {
            Line::Columns(found) => columns = Some(found),
            Line::Row(Ok(row)) => {
                let found = row.characteristic;
                let is_known = |known: &Characteristic| known.name == found.name && known.said() == found.said();
                if plan.iter().all(|(_, known)| !is_known(known)) {
                    plan.push((printed.number, found));
                }
            }
            Line::Row(Err(kind)) => fault = fault.take().or(Some(kind)),
            Line::Angle(_) | Line::Head(_) | Line::Other => {}
        }
        true
    })?;
    match fault {
        Some(kind) => Err(kind),
        None => Ok(plan),
    }
}
