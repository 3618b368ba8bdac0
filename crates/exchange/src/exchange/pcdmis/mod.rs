//! Text reports of PC-DMIS: dimensions, each with a row for every axis.
//!
//! | file | what |
//! |---|---|
//! | here | the lines of a report, and its values judged |
//! | `head` | part, serial number, operator, date and time |
//! | `heading` | the title of a dimension and its columns |
//! | `row` | an axis with its figures |
//!
//! Tolerances are deviations from the nominal value, and a report says neither hole nor shaft. A minus tolerance stands without its sign, or
//! with it, as the program is set: all rows of a report together say which (see `MinusIs`). A report has no mark of its end.

mod head;
mod heading;
mod row;

use fitcheck_core::length::Unit;
use fitcheck_core::message::FilePlace;
use head::Head;
use heading::{Column, Columns, MEASURED, Title, words};
use row::{MinusIs, Row, quantity};

use super::characteristic::{Characteristic, CharacteristicKind, Characteristics, Value};
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::imported::{Sink, WhyUnjudged};
use super::printed::{LeftLines, PrintedFault, PrintedLine, each_line, set_aside};
use super::quantity::Quantity;
use super::source::{Beginning, Context, Source};
use super::{Format, Labels};
use fitcheck_core::text::lines;

pub(super) const FORMAT: Format = Format {
    name: "pcdmis",
    endings: &["txt"],
    description: "exchange-format-pcdmis",
    recognises,
    read,
    plan: Some(plan),
    line_ends: b"",
    has_marks: true,
    shows_end: false,
};

/// By a dimension and the names of its columns.
fn recognises(beginning: &Beginning<'_>) -> bool {
    let text = beginning.text();
    let mut has_title = false;
    lines(&text).any(|(_, line)| {
        has_title |= is_title(line);
        has_title && Columns::of(line).is_some()
    })
}

fn is_title(text: &str) -> bool {
    text.trim_start().strip_prefix("DIM ").is_some_and(|rest| rest.contains('='))
}

/// What a line of a report is.
enum Part<'l> {
    Title,
    /// A line of a title that goes on.
    Options,
    Columns(Columns),
    Row(Result<Row, ImportErrorKind>, &'l Columns),
    /// Figures that belong to nothing.
    Stray(PrintedFault),
    Head,
    End,
    Other,
}

/// Where in a report its lines are.
#[derive(Default)]
struct Place {
    title: Title,
    /// The lines of a title above its columns.
    open: Option<(usize, String)>,
    columns: Option<Columns>,
    head: Head,
}

impl Place {
    fn part(&mut self, text: &str) -> Part<'_> {
        if is_title(text) {
            return Part::Title;
        }
        if text.trim_start().starts_with("END OF DIMENSION") {
            return Part::End;
        }
        if let Some(columns) = Columns::of(text) {
            return Part::Columns(columns);
        }
        if self.head.line(text) {
            return Part::Head;
        }
        if let Some(columns) = &self.columns
            && let Some(row) = Row::of(text, columns)
        {
            return Part::Row(row, columns);
        }
        let is_number = |word: &str| word.contains('.') && word.parse::<f64>().is_ok();
        let words = words(text);
        if 2 < words.iter().filter(|(word, _)| is_number(word)).count() {
            let first = words.first().map_or("", |(word, _)| word.as_str());
            return Part::Stray(match self.columns {
                Some(_) => PrintedFault::UnknownRow { given: shorten(first) },
                None => PrintedFault::NoHeading,
            });
        }
        if self.open.is_some() { Part::Options } else { Part::Other }
    }

    /// A dimension without a row, as it ends.
    fn close(&mut self) -> Option<(usize, PrintedFault)> {
        let (line, text) = self.open.take()?;
        let label = Title::of(&text).label;
        let name = if label.is_empty() { shorten(text.trim()) } else { label };
        Some((line, PrintedFault::NoRows { name }))
    }
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let minus_is = minus_is(source)?;
    let context = source.context.clone();
    let unit = source.given_unit();
    let mut reader = Reader { sink, context, minus_is, unit, told: String::new(), skipped: Vec::new(), has_unit: true };
    let mut left = LeftLines::default();
    let mut place = Place::default();
    let mut last = 1;
    each_line(source, &mut |line| {
        if reader.sink.is_full(line.number) {
            return false;
        }
        last = line.number;
        reader.line(line, &mut place, &mut left);
        true
    })?;
    reader.end(place, left, last)
}

/// How the minus tolerances of a report are written: a row of it alone does not say. The column is called `-TOL`, so a report without a
/// minus has none.
fn minus_is(source: &mut Source<'_>) -> Result<MinusIs, ImportErrorKind> {
    let mut place = Place::default();
    let (mut has_minus, mut is_plain, mut is_signed) = (false, false, false);
    each_line(source, &mut |line| {
        match place.part(line.text) {
            Part::Columns(columns) => place.columns = Some(columns),
            Part::Title | Part::End => place.columns = None,
            Part::Row(Ok(row), columns) => {
                if let Some((is_negative, is_sure)) = row.minus(columns) {
                    has_minus |= is_negative;
                    is_plain |= !is_negative && is_sure;
                    is_signed |= is_negative && is_sure;
                }
            }
            _ => {}
        }
        true
    })?;
    Ok(match (has_minus, is_plain, is_signed) {
        (false, ..) | (true, true, false) => MinusIs::Unsigned,
        (true, false, true) => MinusIs::Signed,
        (true, true, true) | (true, false, false) => MinusIs::Open,
    })
}

/// Reads the lines.
struct Reader<'a, 's> {
    sink: &'a mut Sink<'s>,
    context: Context<'a>,
    minus_is: MinusIs,
    /// The unit of what says none, where the user has said it.
    unit: Option<Unit>,
    /// What was told of a head.
    told: String,
    skipped: Vec<String>,
    has_unit: bool,
}

impl Reader<'_, '_> {
    fn refuse(&mut self, line: usize, kind: ImportErrorKind, text: &str) {
        self.sink.refuse(FilePlace::line(line), kind, shorten(text.trim_matches('\0').trim()));
    }

    fn line(&mut self, line: PrintedLine<'_>, place: &mut Place, left: &mut LeftLines) {
        let PrintedLine { number, text, .. } = line;
        match place.part(text) {
            Part::Title => {
                self.close(place);
                place.columns = None;
                place.open = Some((number, text.to_owned()));
            }
            Part::Options => {
                if let Some((_, title)) = &mut place.open {
                    title.push(' ');
                    title.push_str(text.trim());
                }
            }
            Part::End => {
                self.close(place);
                place.columns = None;
            }
            Part::Columns(columns) => {
                // The names of the columns stand again on each page.
                if let Some((_, title)) = &place.open {
                    place.title = Title::of(title);
                }
                if columns.has(Column::Measured) {
                    self.skipped.extend(columns.skipped().map(str::to_owned));
                    place.columns = Some(columns);
                } else {
                    place.open = None;
                    place.columns = None;
                    self.refuse(number, PrintedFault::NoColumn { column: MEASURED }.into(), text);
                }
            }
            Part::Row(row, columns) => {
                let columns = columns.clone();
                place.open = None;
                let broken = line.broken(row.as_ref().is_ok_and(|row| row.is_complete));
                let read = match broken {
                    Some(kind) => Err(kind),
                    None => row.and_then(|row| self.row(number, &row, &columns, place)),
                };
                if let Err(kind) = read {
                    self.refuse(number, kind, text);
                }
            }
            Part::Stray(fault) => self.refuse(number, fault.into(), text),
            Part::Head => {}
            Part::Other => left.add(line),
        }
    }

    /// Tells of a dimension that had no row.
    fn close(&mut self, place: &mut Place) {
        if let Some((line, fault)) = place.close() {
            let PrintedFault::NoRows { name } = &fault else { return };
            let given = name.clone();
            self.sink.refuse(FilePlace::line(line), fault.into(), given);
        }
    }

    /// What the head says, told once.
    fn head(&mut self, line: usize, head: &Head) {
        let said = head.said();
        if said.is_empty() || self.told == said {
            return;
        }
        self.told.clone_from(&said);
        let mut warn = |kind| self.sink.warn(FilePlace::line(line), None, kind);
        warn(ImportWarningKind::HeadRead { said });
        match head.date_time() {
            Ok(Some(_)) => {}
            Ok(None) => warn(ImportWarningKind::NoTime),
            Err(given) => warn(ImportWarningKind::Time { given }),
        }
    }

    fn row(&mut self, line: usize, row: &Row, columns: &Columns, place: &Place) -> Result<(), ImportErrorKind> {
        let head = &place.head;
        self.head(line, head);
        let time = head.date_time().ok().flatten();
        let characteristic = match characteristic(row, columns, place, (self.minus_is, self.unit))? {
            Read::Length(read) => read,
            Read::Other { id, labels, what } => {
                let why = WhyUnjudged::NotASize { what };
                self.sink.set_aside(set_aside(line, id, *labels, time, why, &self.context));
                return Ok(());
            }
        };
        let ReadRow { characteristic, figures, has_unit } = *characteristic;
        if !has_unit && std::mem::replace(&mut self.has_unit, false) {
            self.sink.warn(FilePlace::line(line), None, ImportWarningKind::UnitAssumed);
        }
        let measured = figures.measured.length;
        for warning in figures.computed.tells(measured, &figures.asked) {
            self.sink.warn(FilePlace::line(line), Some(line), warning.into());
        }
        let labels = Labels {
            serial: head.serial.clone(),
            who: head.who.clone(),
            claims: figures.computed.claim(&figures.said).into_iter().collect(),
            rounded_by: figures.measured.rounded_by(),
            ..characteristic.labels.clone()
        };
        let value = Value { line, measured, time, labels, is_simulated: false };
        characteristic.judge(value, &self.context, self.sink);
        Ok(())
    }

    fn end(mut self, mut place: Place, left: LeftLines, last: usize) -> Result<(), ImportErrorKind> {
        self.close(&mut place);
        self.skipped.sort_unstable();
        self.skipped.dedup();
        if !self.skipped.is_empty() {
            let columns = self.skipped.join(", ");
            self.sink.warn(FilePlace::line(last), None, ImportWarningKind::IgnoredColumns { columns });
        }
        left.tell(self.sink);
        if self.sink.rows() == 0 { Err(ImportErrorKind::NoRows) } else { Ok(()) }
    }
}

/// What a row says.
enum Read {
    Length(Box<ReadRow>),
    /// An angle, a vector, an area.
    Other {
        id: String,
        labels: Box<Labels>,
        what: String,
    },
}

struct ReadRow {
    characteristic: Characteristic,
    figures: row::Figures,
    has_unit: bool,
}

/// The characteristic of a row. A diameter has the name of its feature, and everything else says besides what was measured of it: nothing
/// may take the place of the diameter.
fn characteristic(
    row: &Row,
    columns: &Columns,
    Place { title, head, .. }: &Place,
    (minus_is, given): (MinusIs, Option<Unit>),
) -> Result<Read, ImportErrorKind> {
    let axis = row.axis.as_str();
    let name = match &title.feature {
        Some(feature) if axis == "D" => feature.clone(),
        Some(feature) if axis == "M" => format!("{feature} {}", title.kind),
        Some(feature) => format!("{feature} {axis}"),
        None if axis == "M" => title.label.clone(),
        None => format!("{} {axis}", title.label),
    };
    let what = shorten(format!("{} {axis}", title.kind).trim());
    let quantity = quantity(axis).filter(|_| axis != "M" || !title.is_of_angle());
    let labels = Labels { part: head.part.clone(), quantity: quantity.clone(), ..Labels::default() };
    let Some(quantity) = quantity else {
        let labels = Labels { quantity: Some(Quantity::Other), serial: head.serial.clone(), ..labels };
        return Ok(Read::Other { id: name, labels: Box::new(labels), what });
    };
    let unit = title.unit()?.or(given);
    let figures = row.figures(columns, title, unit.unwrap_or(Unit::Millimetre), minus_is)?;
    let characteristic = Characteristic {
        name,
        what: match quantity {
            Quantity::Diameter => CharacteristicKind::Size,
            _ if figures.asked.minimum.is_none() && figures.asked.maximum.is_none() => {
                CharacteristicKind::Length(WhyUnjudged::NoTolerance)
            }
            _ => CharacteristicKind::Length(WhyUnjudged::NotASize { what }),
        },
        class: String::new(),
        feature: None,
        nominal: figures.asked.nominal,
        minimum: figures.asked.minimum,
        maximum: figures.asked.maximum,
        expanded: None,
        labels,
    };
    Ok(Read::Length(Box::new(ReadRow { characteristic, figures, has_unit: unit.is_some() })))
}

/// The characteristics, each once however many parts the report has.
fn plan(source: &mut Source<'_>, found: &mut Characteristics) -> Result<(), ImportErrorKind> {
    let minus_is = minus_is(source)?;
    let unit = source.given_unit();
    let mut place = Place::default();
    each_line(source, &mut |line| {
        match place.part(line.text) {
            Part::Title => place.open = Some((line.number, line.text.to_owned())),
            Part::Options => {
                if let Some((_, title)) = &mut place.open {
                    title.push(' ');
                    title.push_str(line.text.trim());
                }
            }
            Part::Columns(columns) => {
                if let Some((_, title)) = place.open.take() {
                    place.title = Title::of(&title);
                }
                place.columns = Some(columns);
            }
            Part::End => place.columns = None,
            Part::Row(row, columns) => {
                let columns = columns.clone();
                let broken = line.broken(row.as_ref().is_ok_and(|row| row.is_complete));
                let row = broken.map_or(row, Err);
                match row.and_then(|row| characteristic(&row, &columns, &place, (minus_is, unit))) {
                    Ok(Read::Length(read)) => {
                        if !read.has_unit {
                            found.tell(line.number, ImportWarningKind::UnitAssumed);
                        }
                        found.add(line.number, read.characteristic);
                    }
                    Ok(Read::Other { id, what, .. }) => found.add_other(line.number, id, what),
                    Err(kind) => found.refuse(line.number, kind),
                }
            }
            Part::Stray(_) | Part::Head | Part::Other => {}
        }
        true
    })
}
