//! Tolerances that GEOPAK of MCOSMOS (Mitutoyo) writes to a file, without names of columns: its cells stand in one order, which the
//! figures confirm.
//!
//! `1;Diameter;Circle_1;25.000;0.021;0.000;25.012;0.012;;` has the number of the element, the tolerance, the name, the nominal value, the
//! upper and the lower tolerance, the actual value, the deviation, and how far it is out. No unit is given, and nothing says hole or shaft.

use std::borrow::Cow;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::FilePlace;
use fitcheck_core::text::{LINE_END_BYTES, lines};

use super::characteristic::Characteristics;
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::imported::Sink;
use super::printed::{Figure, PrintedFault, PrintedLine, PrintedRow, each_line};
use super::source::Source;
use super::{Format, Labels, cells};

pub(super) const FORMAT: Format = Format {
    name: "geopak",
    endings: &["txt", "csv", "asc"],
    description: "exchange-format-geopak",
    recognises: |beginning| is_confirmed(&beginning.text()),
    read,
    plan: Some(plan),
    line_ends: LINE_END_BYTES,
    has_marks: true,
    shows_end: true,
};

/// The figures of a row and the places of their cells.
const FIGURES: [(Figure, usize); 6] = [
    (Figure::Nominal, 3),
    (Figure::Upper, 4),
    (Figure::Lower, LOWER),
    (Figure::Measured, 6),
    (Figure::Deviation, 7),
    (Figure::Beyond, 8),
];

const LOWER: usize = 5;

/// How many cells a row has, of which the last one may be empty.
const CELLS: usize = 9;

/// The cells of a row; `None` where a line is none.
fn row(line: &str) -> Option<Vec<&str>> {
    let cells: Vec<&str> = line.split(';').map(str::trim).collect();
    let is_number = |cell: &str| !cell.is_empty() && cell.bytes().all(|byte| byte.is_ascii_digit());
    let has_words = cells.get(1).is_some_and(|what| what.contains(char::is_alphabetic));
    (CELLS <= cells.len() && cells.first().is_some_and(|number| is_number(number)) && has_words).then_some(cells)
}

fn length(cells: &[&str], wanted: Figure) -> Option<Length> {
    let (_, at) = FIGURES.into_iter().find(|(figure, _)| *figure == wanted)?;
    cells::length(cells.get(at)?, Unit::Millimetre).ok()
}

/// Whether the lines of a text are rows, the last one perhaps not whole, and more of them have the deviation of their figures than another.
fn is_confirmed(text: &str) -> bool {
    let (mut confirmed, mut contradicted) = (0, 0);
    let mut all = lines(text).filter(|(_, line)| !line.trim().is_empty()).peekable();
    while let Some((_, line)) = all.next() {
        let Some(cells) = row(line) else {
            if all.peek().is_none() {
                break;
            }
            return false;
        };
        let figures = length(&cells, Figure::Measured).zip(length(&cells, Figure::Nominal));
        if let Some(((measured, nominal), deviation)) = figures.zip(length(&cells, Figure::Deviation)) {
            let off = measured.saturating_sub(nominal).saturating_sub(deviation).abs();
            // Each of the three is rounded by itself.
            *(if off <= Length::from_micrometres(2) { &mut confirmed } else { &mut contradicted }) += 1;
        }
    }
    contradicted < confirmed
}

/// Whether the lower tolerances stand without their minus: one of them is not below its upper tolerance, and none has a sign.
fn is_minus_left(source: &mut Source<'_>) -> Result<bool, ImportErrorKind> {
    let (mut is_crossed, mut has_sign) = (false, false);
    each_line(source, &mut |line| {
        let Some(cells) = row(line.text) else { return true };
        let tolerances = length(&cells, Figure::Upper).zip(length(&cells, Figure::Lower));
        is_crossed |= tolerances.is_some_and(|(upper, lower)| upper <= lower && lower != Length::ZERO);
        has_sign |= cells.get(LOWER).is_some_and(|cell| cell.starts_with(['-', '+', '\u{2212}']));
        true
    })?;
    Ok(is_crossed && !has_sign)
}

/// How the rows of a file are read.
#[derive(Clone, Copy)]
struct Rows {
    unit: Option<Unit>,
    is_minus_left: bool,
}

impl Rows {
    fn of(source: &mut Source<'_>) -> Result<Self, ImportErrorKind> {
        Ok(Self { unit: source.given_unit(), is_minus_left: is_minus_left(source)? })
    }

    fn told(self) -> Option<ImportWarningKind> {
        self.is_minus_left.then(|| ImportWarningKind::MinusSupplied { column: (LOWER + 1).to_string() })
    }

    fn read(self, line: PrintedLine<'_>) -> Result<PrintedRow, ImportErrorKind> {
        if let Some(kind) = line.broken(false) {
            return Err(kind);
        }
        let Some(cells) = row(line.text) else {
            let found = line.text.split(';').count();
            return Err(PrintedFault::Cells { found, expected: CELLS }.into());
        };
        let [_, what, name, ..] = cells.as_slice() else { return Err(ImportErrorKind::NoRows) };
        let figures = FIGURES.map(|(figure, at)| {
            let cell = cells.get(at).copied().unwrap_or_default();
            let is_bare = at == LOWER && self.is_minus_left && cell.starts_with(|sign: char| sign.is_ascii_digit());
            (figure, if is_bare { Cow::Owned(format!("-{cell}")) } else { Cow::Borrowed(cell) })
        });
        let figures: Vec<(Figure, &str)> = figures.iter().map(|(figure, cell)| (*figure, cell.as_ref())).collect();
        PrintedRow::read((name, what), &figures, self.unit, word)
    }
}

/// What the manual of the program calls a figure.
const fn word(figure: Figure) -> &'static str {
    match figure {
        Figure::Measured => "Actual",
        Figure::Nominal => "Nominal",
        Figure::Upper => "Upper tolerance",
        Figure::Lower => "Lower tolerance",
        Figure::Deviation => "Deviation",
        Figure::Beyond => "Out of specification",
    }
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let context = source.context.clone();
    let rows = Rows::of(source)?;
    if let Some(told) = rows.told() {
        sink.warn(FilePlace::line(1), None, told);
    }
    let mut is_unit_told = rows.unit.is_some();
    each_line(source, &mut |line| {
        if sink.is_full(line.number) {
            return false;
        }
        match rows.read(line) {
            Ok(row) => {
                if !std::mem::replace(&mut is_unit_told, true) {
                    sink.warn(FilePlace::line(line.number), None, ImportWarningKind::UnitAssumed);
                }
                row.judge(line, (Labels::default(), None), word(Figure::Beyond), &context, sink);
            }
            Err(kind) => sink.refuse(FilePlace::line(line.number), kind, shorten(line.text.trim())),
        }
        true
    })?;
    if sink.rows() == 0 { Err(ImportErrorKind::NoRows) } else { Ok(()) }
}

fn plan(source: &mut Source<'_>, found: &mut Characteristics) -> Result<(), ImportErrorKind> {
    let rows = Rows::of(source)?;
    if let Some(told) = rows.told() {
        found.tell(1, told);
    }
    each_line(source, &mut |line| {
        match rows.read(line) {
            Ok(row) => {
                if !row.has_unit {
                    found.tell(line.number, ImportWarningKind::UnitAssumed);
                }
                found.add(line.number, row.characteristic);
            }
            Err(kind) => found.refuse(line.number, kind),
        }
        true
    })
}
