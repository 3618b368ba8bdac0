//! CSV of id, callout and measured value, with or without a header.
//!
//! Separator, decimal sign and columns are detected by the first rows; what could be meant in two ways is refused. The text is read in
//! pieces of whole lines, and a row that spans two of them is read with the second: a file of any size takes the memory of one piece.

use std::borrow::Cow;
use std::sync::Arc;

use csv::StringRecord;
use fitcheck_core::length::Length;
use fitcheck_core::message::Place;
use fitcheck_core::probing::{Measurement, Origin};
use jiff::civil::{DateTime, Time};

use super::cells;
use super::claim::{Answer, Claim};
use super::column::listed;
use super::columns::Columns;
use super::delimited::{Item, Rows, lines, without_separator_line};
use super::error::{ImportErrorKind, ImportWarningKind};
use super::evidence::marks_simulation;
use super::given::shorten;
use super::imported::{Sink, Unjudged, WhyUnjudged};
use super::index::LONGEST_ROW;
use super::left_out;
use super::mapping::Mapping;
use super::pieces::Pieces;
use super::refused::{Cell, Refused};
use super::remarks::Heard;
use super::rules::{Found, Rules};
use super::sample::{NO_SEPARATOR, Sample};
use super::size::{Size, SizesOf};
use super::source::{Context, Source, WHOLE};
use super::stated;
use super::words;
use super::{Format, Labels};
use crate::exchange::cell::{Cells as _, joined};
use crate::journal::Record;
use crate::within::Within as _;

/// The bytes that end a row.
pub(super) const LINE_ENDS: &[u8] = b"\n\r";

pub(super) const FORMAT: Format = Format {
    name: "measurements",
    endings: &["csv", "tsv", "txt"],
    description: "exchange-format-measurements",
    recognises: |beginning| is_text(&beginning.text()),
    read,
    plan: None,
    line_ends: LINE_ENDS,
    has_marks: false,
    shows_end: true,
};

/// Text, not arbitrary bytes: at most one of fifty characters is a control character.
fn is_text(head: &str) -> bool {
    let odd = head.chars().filter(|c| c.is_control() && !"\t\r\n".contains(*c)).count();
    odd * 50 <= head.chars().count()
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    read_rows(source, sink, None)
}

/// Reads the measured sizes alone: limits are not looked up.
pub(super) fn read_sizes(
    source: &mut Source<'_>,
    sink: &mut Sink<'_>,
    sizes: SizesOf<'_>,
) -> Result<(), ImportErrorKind> {
    read_rows(source, sink, Some(sizes))
}

fn read_rows(source: &mut Source<'_>, sink: &mut Sink<'_>, sizes: Option<SizesOf<'_>>) -> Result<(), ImportErrorKind> {
    let context = source.context.clone();
    let mapping = source.given.mapping;
    let detects = Mapping::default();
    let has_plan = source.given.has_plan;
    // What is stated behind the last row holds for the first one as well.
    let unit_lines = stated::unit_lines(&mut source.pieces(LINE_ENDS)?);
    let mut pieces = source.pieces(LINE_ENDS)?;
    let head = head(&mut pieces)?;
    let (text, first_line, separator) = without_separator_line(&head);
    let mapping = mapping.unwrap_or(&detects);
    let mut sample = Sample::of(text, first_line, mapping.separator().or(separator));
    let separator = sample.separator;
    let columns = mapping.columns(&mut sample)?;
    stated::agree(&columns, &unit_lines)?;
    // The first rows are read once more with the rest.
    drop(sample);
    let mut reader = Reader { sizes, ..Reader::new(&context, (&columns, separator, has_plan), sink) };
    reader.warn_of_columns(first_line);
    let mut rows = Rows::new(text, first_line, separator).going_on(true);
    let mut next = reader.rows(&mut rows);
    let mut rest = rows.rest().to_owned();
    drop(head);
    let mut goes_on = true;
    while goes_on && let Some(line) = next {
        let piece = pieces.next()?;
        goes_on = piece.is_some();
        // Behind the last piece only the rest of it is left.
        let piece = piece.unwrap_or(Cow::Borrowed(""));
        let text = if rest.is_empty() { piece } else { Cow::Owned(std::mem::take(&mut rest) + &piece) };
        let mut rows = Rows::after(&text, line, separator).going_on(goes_on);
        next = reader.rows(&mut rows);
        rows.rest().clone_into(&mut rest);
    }
    if reader.sink.rows() == 0 {
        reader.refuse(first_line, NOTHING, ImportErrorKind::NoRows);
    }
    reader.tell_all_nominal(first_line);
    Ok(())
}

/// Reads the rows of a file that has cells as such; a row is not known to be the last one.
pub(super) struct Cells<'a, 's, 'z>(Reader<'a, 's, 'z>);

impl<'a, 's, 'z> Cells<'a, 's, 'z> {
    pub(super) fn new(
        source: &'a Context<'a>,
        columns: &'a Columns,
        has_plan: bool,
        sink: &'a mut Sink<'s>,
        sizes: Option<SizesOf<'z>>,
    ) -> Self {
        let separator = NO_SEPARATOR;
        let mut reader = Reader { sizes, ..Reader::new(source, (columns, separator, has_plan), sink) };
        reader.warn_of_columns(1);
        Self(reader)
    }

    /// Reads a row; `false` where no more are wanted.
    pub(super) fn row(&mut self, line: usize, cells: &StringRecord) -> bool {
        if self.0.sink.is_full(line) {
            return false;
        }
        self.0.row(line, cells);
        true
    }

    /// Tells it where no row held anything.
    pub(super) fn end(mut self) {
        if self.0.sink.rows() == 0 {
            self.0.refuse(1, NOTHING, ImportErrorKind::NoRows);
        }
        self.0.tell_all_nominal(1);
    }
}

/// Reads some rows of a file of which no more are known.
pub(super) fn read_these<'r>(
    source: &Context<'_>,
    (columns, separator, has_plan): (&Columns, u8, bool),
    rows: impl Iterator<Item = &'r (usize, StringRecord)>,
    sink: &mut Sink<'_>,
) {
    let mut reader = Reader::new(source, (columns, separator, has_plan), sink);
    for (line, cells) in rows {
        reader.row(*line, cells);
    }
}

/// The beginning of a text, by which its columns are known: down to rows below comments and header.
pub(super) fn head(pieces: &mut Pieces<'_>) -> Result<String, ImportErrorKind> {
    let most = WHOLE.try_into().unwrap_or(usize::MAX);
    let mut head = String::new();
    while let Some(piece) = pieces.next()? {
        head.push_str(&piece);
        let (text, first_line, separator) = without_separator_line(&head);
        if most < head.len() || Sample::of(text, first_line, separator).has_data() {
            break;
        }
    }
    Ok(head)
}

/// No cell.
const NOTHING: Cell<'_> = Cell { at: None, text: "" };

/// Reads a single row whose columns are known, as one of a whole file.
pub(super) fn read_row(
    source: &Context<'_>,
    (columns, separator): (&Columns, u8),
    (line, cells): (usize, &StringRecord),
    sink: &mut Sink<'_>,
) {
    let mut reader = Reader::new(source, (columns, separator, false), sink);
    if let Err((cell, reason)) = reader.measurement(line, cells) {
        reader.refuse(line, cell, reason);
    }
}

struct Reader<'a, 's, 'z> {
    source: &'a Context<'a>,
    columns: &'a Columns,
    separator: u8,
    has_plan: bool,
    sink: &'a mut Sink<'s>,
    /// Whether the row is the last one and has no line end.
    is_open: bool,
    /// Whether the mark of a simulation stands above it.
    is_simulated: bool,
    /// Where sizes go, if they alone are wanted.
    sizes: Option<SizesOf<'z>>,
    nominal: Nominal,
    /// The line that names other columns: what is below it is not known.
    renamed: Option<usize>,
    /// What remarks have said so far.
    heard: Heard,
}

/// How many values were judged, and how many of them are exactly the nominal size.
#[derive(Default)]
struct Nominal {
    judged: usize,
    exact: usize,
}

impl<'a, 's> Reader<'a, 's, '_> {
    fn new(
        source: &'a Context<'a>,
        (columns, separator, has_plan): (&'a Columns, u8, bool),
        sink: &'a mut Sink<'s>,
    ) -> Self {
        let is_open = false;
        let is_simulated = false;
        let sizes = None;
        let nominal = Nominal::default();
        let renamed = None;
        let heard = Heard::default();
        Self { source, columns, separator, has_plan, sink, is_open, is_simulated, sizes, nominal, renamed, heard }
    }

    /// Reads some rows, and gives the number of the line after them; `None` where no more are wanted.
    fn rows(&mut self, rows: &mut Rows<'_>) -> Option<usize> {
        let mut next = rows.next();
        while let Some(item) = next {
            if self.sink.is_full(item.line()) {
                return None;
            }
            next = rows.next();
            self.is_open = next.is_none() && rows.is_open();
            match item {
                Item::Lines { line, text, cells } if self.columns.hides_rows(&cells, self.separator) => {
                    self.torn(line, text);
                }
                Item::Row { line, cells } | Item::Lines { line, cells, .. } => self.row(line, &cells),
                Item::OpenQuote { line, text } => {
                    self.refuse(line, Cell { at: None, text }, ImportErrorKind::OpenQuote);
                }
                Item::TooLong { line } => {
                    self.refuse(line, NOTHING, ImportErrorKind::RowTooLong { most: LONGEST_ROW >> 10 });
                }
            }
        }
        Some(rows.next_line())
    }

    /// A row with such lines: none of them has a verdict.
    fn torn(&mut self, first: usize, text: &str) {
        for (line, from, to) in lines(text, 0, first) {
            let reason = if line == first { ImportErrorKind::OpenQuote } else { ImportErrorKind::WithinQuotes };
            self.refuse(line, Cell { at: None, text: text.within(from..to) }, reason);
        }
    }

    fn warn_of_columns(&mut self, first_line: usize) {
        let line = self.columns.header.unwrap_or(first_line);
        if let Some((line, reason)) = self.columns.stated.told(self.columns.measured) {
            self.warn(line, reason);
        }
        if self.columns.own.are_corrected() {
            self.warn(line, ImportWarningKind::Corrected);
        }
        if self.columns.own.have_rule() {
            self.warn(line, ImportWarningKind::OtherRule);
        }
        if !self.columns.ignored.is_empty() {
            let columns = listed(&self.columns.ignored);
            self.warn(line, ImportWarningKind::IgnoredColumns { columns });
        }
        for kind in self.columns.taken_as_sizes() {
            self.warn(line, kind);
        }
    }

    /// Tells that nobody may have measured: a drawing's list of sizes passes every limit of H and h.
    fn tell_all_nominal(&mut self, first_line: usize) {
        let Nominal { judged, exact } = self.nominal;
        if 1 < judged && judged == exact {
            let line = self.columns.header.unwrap_or(first_line);
            self.warn(line, ImportWarningKind::AllNominal { count: judged });
        }
    }

    fn warn(&mut self, line: usize, reason: ImportWarningKind) {
        self.sink.warn(Place::line(line), None, reason);
    }

    fn warn_row(&mut self, line: usize, reason: ImportWarningKind) {
        self.sink.warn(Place::line(line), Some(line), reason);
    }

    fn refuse(&mut self, line: usize, cell: Cell<'_>, reason: ImportErrorKind) {
        let given = shorten(cell.text.trim());
        self.sink.refuse(Place { column: cell.at.map(|at| at + 1), ..Place::line(line) }, reason, given);
    }

    fn row(&mut self, line: usize, cells: &StringRecord) {
        if cells::is_blank(cells) || self.columns.stated.is_row_of_units(cells) {
            return;
        }
        if marks_simulation(cells) {
            self.is_simulated = true;
            return;
        }
        let stray = || stated::stray(self.columns, cells);
        if cells::is_comment(cells) {
            if let Some(reason) = stray() {
                return self.refuse(line, Cell { at: None, text: cells.cell(0) }, reason);
            }
            if let Some(told) = self.said_against(line, cells) {
                self.warn(line, told);
            }
            let rules = self.rules();
            let hides = match &self.sizes {
                Some(sizes) => rules.hides_size(cells, sizes.feature),
                None => rules.hides_measurement(cells),
            };
            if !hides {
                return;
            }
            if self.columns.header.is_some_and(|header| line < header) {
                return self.warn(line, ImportWarningKind::Comment);
            }
            let cell = Cell { at: None, text: cells.cell(0) };
            return self.refuse(line, cell, ImportErrorKind::Comment);
        }
        match self.columns.header {
            Some(header) if line == header && self.columns.names_known => return,
            _ if self.columns.stated.told(self.columns.measured).is_some_and(|(told, _)| told == line) => {
                let told = self.said_against(line, cells);
                return told.into_iter().for_each(|told| self.warn(line, told));
            }
            Some(header) if line <= header => return self.not_used(line, cells),
            _ if self.columns.first.is_some_and(|first| line < first) => return self.not_used(line, cells),
            _ => {}
        }
        if let Some(header) = self.renamed {
            return self.refuse(line, NOTHING, ImportErrorKind::BelowOtherHeader { line: header });
        }
        let read = if self.sizes.is_some() { self.size(line, cells) } else { self.measurement(line, cells) };
        if let Err((cell, reason)) = read {
            if self.columns.stated.repeats_names(cells) {
                return self.not_used(line, cells);
            }
            if self.columns.are_renamed_by(cells) {
                self.renamed = Some(line);
                return self.refuse(line, cell, ImportErrorKind::OtherHeader);
            }
            self.refuse(line, cell, stray().unwrap_or(reason));
        }
    }

    /// Tells that a line is not used, or what it says against the values.
    fn not_used(&mut self, line: usize, cells: &StringRecord) {
        self.warn(line, left_out::not_used(cells, self.columns.counted_at(line, self.source.counted)));
    }

    /// What a line that is no row says against the values.
    fn said_against(&self, line: usize, cells: &StringRecord) -> Option<ImportWarningKind> {
        left_out::said_against(cells, self.columns.counted_at(line, self.source.counted))
    }

    /// Takes the size of a row, or names the cell that cannot be used.
    fn size<'c>(&mut self, line: usize, cells: &'c StringRecord) -> Result<(), Refused<'c>> {
        let rules = self.rules();
        let Some(sizes) = &self.sizes else { return Ok(()) };
        let Found { measured, is_simulated, .. } = rules.size(cells, sizes.feature)?;
        let id = cells.cell(self.columns.id).trim().to_owned();
        if let Some(claim) = self.columns.claims(cells, &mut self.heard).into_iter().find(Claim::is_rejection) {
            return Err((NOTHING, ImportErrorKind::Rejected { given: claim.said().to_owned() }));
        }
        if words::is_of_several_parts(&id) {
            let cell = Cell { at: self.columns.id, text: cells.cell(self.columns.id) };
            return Err((cell, ImportErrorKind::NoPart { given: shorten(&id) }));
        }
        self.tell_cut_off(line, cells);
        let is_simulated = is_simulated || self.is_simulated;
        let Some(sizes) = &mut self.sizes else { return Ok(()) };
        self.sink.count();
        (sizes.take)(Size { line, id, measured, is_simulated });
        Ok(())
    }

    /// Tells that the end of the file may have cut off a row.
    fn tell_cut_off(&mut self, line: usize, cells: &StringRecord) {
        if let Some(reason) = self.rules().cut_off(cells).filter(|_| self.is_open) {
            self.warn_row(line, reason);
        }
    }

    fn rules(&self) -> Rules<'a> {
        let Context { sources, lookup, .. } = self.source;
        let has_commas = self.separator == b',';
        let has_plan = self.has_plan;
        Rules { columns: self.columns, has_commas, sources, has_plan, lookup: Some(lookup) }
    }

    /// Judges a row and keeps it, or names the cell that cannot be used.
    fn measurement<'c>(&mut self, line: usize, cells: &'c StringRecord) -> Result<(), Refused<'c>> {
        let Found { measured, asked, said, is_simulated, quantity } = self.rules().read(cells)?;
        let id = cells.cell(self.columns.id).trim().to_owned();
        self.tell_cut_off(line, cells);
        let time = self.time(line, cells);
        let file = Arc::clone(&self.source.file);
        let origin = if is_simulated || self.is_simulated {
            Origin::ImportedSimulation { file }
        } else {
            Origin::Imported { file }
        };
        let correction = self.columns.own.correction(cells, measured)?;
        let Some((callout, limits)) = asked else {
            let column = self.columns.measured.at;
            let given = shorten(cells.cell(column).trim());
            let below = WhyUnjudged::NotPositive { given, column: column + 1 };
            let other = self.rules().other_than_size(cells);
            let why = match other {
                Some(cell) => WhyUnjudged::NotASize { what: shorten(cell.text) },
                None if measured <= Length::ZERO => below,
                None => WhyUnjudged::NoCallout,
            };
            let labels = Labels { quantity, ..self.labels(line, cells) };
            let asked = said;
            let measured = Some(measured);
            let position = None;
            let unjudged = Unjudged { line, id, labels, time, measured, origin, position, asked, correction, why };
            self.sink.set_aside(unjudged);
            return Ok(());
        };
        let measurement = Measurement::of_diameter(measured, origin);
        let record = Record::judged(time, id, Some(callout), limits, measurement, None);
        let labels = Labels { quantity, ..self.labels(line, cells) };
        self.nominal.judged += 1;
        self.nominal.exact += usize::from(record.measurement.diameter == record.limits.nominal);
        let answer = Answer::of(&record);
        for warning in labels.claims.iter().filter_map(|claim| claim.tells(&answer)) {
            self.warn_row(line, warning);
        }
        self.sink.keep(line, Record { correction, ..record }, labels);
        Ok(())
    }

    /// What else a row says of its value.
    fn labels(&mut self, line: usize, cells: &StringRecord) -> Labels {
        let columns = &self.columns.labels;
        let text = |at: usize| cells.cell(at).trim();
        let label = |at: Option<usize>| cells.cell(at).trim().to_owned();
        let place = columns.place.map(|column| {
            let column = column.filter(|column| !text(column.at).is_empty())?;
            let given = shorten(text(column.at));
            let length = Length::parse_in(&given, self.columns.stated.of_place(column, cells)).ok();
            if length.is_none() {
                let place = Place::in_line(line, column.at + 1);
                self.sink.warn(place, Some(line), ImportWarningKind::Place { given });
            }
            length
        });
        Labels {
            number: label(columns.number),
            part: label(columns.part),
            serial: label(columns.serial),
            who: label(columns.who),
            claims: self
                .columns
                .claims(cells, &mut self.heard)
                .into_iter()
                .map(|claim| claim.from(self.source.counted))
                .collect(),
            place,
            is_corrected: self.columns.evidence.is_corrected(cells),
            ..Labels::default()
        }
    }

    /// The time of a row, or the time of import with a warning.
    fn time(&mut self, line: usize, cells: &StringRecord) -> DateTime {
        let given = joined(self.columns.time.iter().filter_map(|&at| cells.get(at)));
        let read = date_time(&given);
        let reason = match read {
            _ if self.columns.time.is_empty() => None,
            None if given.is_empty() => Some(ImportWarningKind::NoTime),
            None => Some(ImportWarningKind::Time { given: shorten(&given) }),
            Some(_) if has_offset(&given) => Some(ImportWarningKind::Offset { given: shorten(&given) }),
            Some(_) => None,
        };
        if let Some(reason) = reason {
            self.warn_row(line, reason);
        }
        read.unwrap_or(self.source.now)
    }
}

/// Whether a date and time says how far it is from UTC, or in which time zone it is.
fn has_offset(given: &str) -> bool {
    let time = given.split_once(['T', 't', ' ']).map_or("", |(_, time)| time);
    given.contains('[') || time.contains(['+', '-', '\u{2212}'])
}

/// `2024-03-14 08:05:09` as in ISO 8601 (the time is optional), or day first: `14.3.2024 8:05`.
fn date_time(given: &str) -> Option<DateTime> {
    if let Ok(time) = given.parse() {
        return Some(time);
    }
    let (day, time) = given.split_once([' ', 'T']).unwrap_or((given, "0:00"));
    let mut parts = day.split(['-', '.']);
    let day = parts.next()?;
    let month = parts.next()?;
    let year = parts.next()?;
    let year = year.parse().ok().filter(|year| 1000 <= *year)?;
    let date = jiff::civil::Date::new(year, month.parse().ok()?, day.parse().ok()?).ok()?;
    let mut parts = time.trim().split(':');
    let hour = parts.next()?.parse().ok()?;
    let minute = parts.next()?.parse().ok()?;
    let second = parts.next().map_or(Some(0), |second| second.parse().ok())?;
    Some(date.to_datetime(Time::new(hour, minute, second, 0).ok()?))
}
