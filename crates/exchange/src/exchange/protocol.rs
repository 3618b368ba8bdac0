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
use fitcheck_core::length::Unit;
use fitcheck_core::message::FilePlace;
use fitcheck_core::text::lines;

use super::characteristic::Characteristics;
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::head::Head;
use super::imported::{Sink, WhyUnjudged};
use super::printed::{Figure, LeftLines, PrintedFault, PrintedLine, PrintedRow, each_line, set_aside};
use super::quantity::Quantity;
use super::role::Role;
use super::source::{Beginning, Context, Source};
use super::{Format, Labels, limits, words};

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

/// The columns behind the name of a characteristic, in their order.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Columns(Vec<Figure>);

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
                Some((Role::Measured, _)) => Figure::Measured,
                Some((Role::Nominal, _)) => Figure::Nominal,
                Some((Role::Upper, _)) => Figure::Upper,
                Some((Role::Lower, _)) => Figure::Lower,
                _ if super::beside::is_deviation(name) => Figure::Deviation,
                _ if limits::goes_both_ways(name) => Figure::Beyond,
                _ => return None,
            })
        };
        let found: Vec<Figure> = names.iter().map(column).collect::<Option<_>>()?;
        let has_one = |wanted: Figure| found.iter().filter(|column| **column == wanted).count() == 1;
        let needed = [Figure::Measured, Figure::Nominal, Figure::Upper, Figure::Lower];
        let is_twice = found.iter().any(|column| !has_one(*column));
        (needed.into_iter().all(has_one) && !is_twice).then_some(Self(found))
    }

    /// The columns that so many cells stand in: the last one may be empty, and both tolerances with it.
    fn below(&self, count: usize) -> Option<Vec<Figure>> {
        let is_tolerance = |column: &Figure| matches!(column, Figure::Upper | Figure::Lower);
        let mut all = self.0.clone();
        if all.len() == count {
            return Some(all);
        }
        all.retain(|column| *column != Figure::Beyond);
        if all.len() != count {
            all.retain(|column| !is_tolerance(column));
        }
        (all.len() == count).then_some(all)
    }
}

/// What a line of a report is.
enum Line {
    Columns(Columns),
    Row(Result<Box<PrintedRow>, ImportErrorKind>),
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

/// What a line is; a row that may not be whole is none.
fn line(printed: &PrintedLine<'_>, columns: Option<&Columns>, unit: Option<Unit>) -> Line {
    let found = of_text(printed.text, printed.number, columns, unit);
    match printed.broken(false) {
        Some(kind) if matches!(found, Line::Row(_) | Line::Angle(_)) => Line::Row(Err(kind)),
        _ => found,
    }
}

fn of_text(text: &str, number: usize, columns: Option<&Columns>, unit: Option<Unit>) -> Line {
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
                let figures: Vec<(Figure, &str)> = below.into_iter().zip(cells.iter().skip(1).copied()).collect();
                Line::Row(PrintedRow::read((name, name), &figures, unit, word).map(Box::new))
            }
        },
        (None, Some(head)) => Line::Head(head),
        (None, None) => Line::Other,
    }
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let context = source.context.clone();
    let unit = source.given_unit();
    let mut reader = Reader { context, sink, columns: None, head: Head::default(), unit, has_unit: true };
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
    /// Of figures without one, where the user has said it.
    unit: Option<Unit>,
    has_unit: bool,
}

impl Reader<'_, '_> {
    fn line(&mut self, printed: PrintedLine<'_>, left: &mut LeftLines) {
        let PrintedLine { number, text, .. } = printed;
        match line(&printed, self.columns.as_ref(), self.unit) {
            Line::Columns(columns) => self.columns = Some(columns),
            Line::Head(head) => self.head(number, head),
            Line::Row(Ok(row)) => self.row(printed, *row),
            Line::Row(Err(kind)) => {
                self.sink.refuse(FilePlace::line(number), kind, shorten(text.trim_matches('\0').trim()));
            }
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

    fn row(&mut self, line: PrintedLine<'_>, row: PrintedRow) {
        if !row.has_unit && std::mem::replace(&mut self.has_unit, false) {
            self.sink.warn(FilePlace::line(line.number), None, ImportWarningKind::UnitAssumed);
        }
        let labels = self.labels(Labels::default());
        row.judge(line, (labels, self.head.time), word(Figure::Beyond), &self.context, self.sink);
    }
}

/// What a report calls a figure.
const fn word(figure: Figure) -> &'static str {
    match figure {
        Figure::Measured => "Measured value",
        Figure::Nominal => "Nominal value",
        Figure::Upper => "+Tol",
        Figure::Lower => "-Tol",
        Figure::Deviation => "Deviation",
        Figure::Beyond => "+/-",
    }
}

fn plan(source: &mut Source<'_>, found: &mut Characteristics) -> Result<(), ImportErrorKind> {
    let unit = source.given_unit();
    let mut columns = None;
    each_line(source, &mut |printed| {
        match line(&printed, columns.as_ref(), unit) {
            Line::Columns(these) => columns = Some(these),
            Line::Row(Ok(row)) => {
                if !row.has_unit {
                    found.tell(printed.number, ImportWarningKind::UnitAssumed);
                }
                found.add(printed.number, row.characteristic);
            }
            Line::Row(Err(kind)) => found.refuse(printed.number, kind),
            Line::Angle(name) => {
                let what = shorten(&name);
                found.add_other(printed.number, name, what);
            }
            Line::Head(head) => {
                found.head.go_on(head);
            }
            Line::Other => {}
        }
        true
    })
}
