//! Prints of probing macros of a control: features, each with its size and its position.
//!
//! | file | what |
//! |---|---|
//! | here | the lines of a print, and its values judged |
//! | `row` | a size or a position with its figures |
//!
//! A tolerance is half of the zone. A feature may be out of tolerance by a line of its own, which stands anywhere behind the row. A print has no
//! unit and says neither hole nor shaft. A position is measured along its axes and tolerated in all of them together, so that none of
//! its rows has limits. Prints of CAM systems begin with `START` and end with `END`, and name their toolpaths.

mod row;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::FilePlace;
use fitcheck_core::text::lines;
use jiff::civil::DateTime;
use row::Row;

use super::characteristic::{Characteristic, CharacteristicKind, Characteristics, Value};
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::imported::{Sink, WhyUnjudged};
use super::measurements::date_time;
use super::printed::{Computed, LeftLines, Printed, PrintedLine, PrintedWarning, each_line, set_aside};
use super::quantity::Quantity;
use super::source::{Beginning, Context, Source};
use super::{Format, Labels};

pub(super) const FORMAT: Format = Format {
    name: "probed",
    endings: &["txt"],
    description: "exchange-format-probed",
    recognises,
    read,
    plan: Some(plan),
    line_ends: b"",
    has_marks: true,
    shows_end: false,
};

/// The lines around a print.
const START: &str = "START";
const END: &str = "END";

/// Lines between which a print is: a row of a size or a position, or the line above it.
fn recognises(beginning: &Beginning<'_>) -> bool {
    let text = beginning.text();
    lines(&text).any(|(_, line)| Numbers::of(line).is_some())
        && lines(&text).any(|(_, line)| Row::of(line).is_some_and(|row| row.quantity().is_some()))
}

/// `COMPONENT NO 1 FEATURE NO 2`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct Numbers {
    component: String,
    feature: String,
}

impl Numbers {
    fn of(text: &str) -> Option<Self> {
        let words: Vec<&str> = text.split_whitespace().collect();
        match words.as_slice() {
            ["COMPONENT", "NO", component, "FEATURE", "NO", feature] => {
                Some(Self { component: (*component).to_owned(), feature: (*feature).to_owned() })
            }
            _ => None,
        }
    }
}

/// A line such as `+++++OUT OF TOL+++++ ERROR  0.8072`.
enum OutOf {
    /// A size, and how far.
    Size(Printed),
    /// A position or an angle.
    Other,
}

impl OutOf {
    fn of(text: &str, unit: Option<Unit>) -> Option<Self> {
        let text = text.trim();
        if !text.starts_with('+') || !text.contains("OUT OF") {
            return None;
        }
        let is_size = text.trim_start_matches('+').starts_with("OUT OF TOL");
        let unit = unit.unwrap_or(Unit::Millimetre);
        let figure = text.rsplit_once("ERROR").and_then(|(_, text)| Printed::read(text.trim(), unit).ok());
        Some(figure.filter(|_| is_size).map_or(Self::Other, Self::Size))
    }
}

/// `TIMESTAMP 250917 100947`: two digits each, and a first zero may be missing in the time alone.
fn timestamp(text: &str) -> Option<DateTime> {
    let (date, time) = text.trim().split_once(' ')?;
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let time = format!("{:0>6}", time.trim());
    if date.len() != 6 || time.len() != 6 || !digits(date) || !digits(&time) {
        return None;
    }
    let pair = |text: &str, at: usize| fitcheck_core::text::part(text, at, at + 2).to_owned();
    let [year, month, day] = [0, 2, 4].map(|at| pair(date, at));
    let [hour, minute, second] = [0, 2, 4].map(|at| pair(&time, at));
    date_time(&format!("20{year}-{month}-{day} {hour}:{minute}:{second}"))
}

/// A row that waits for the line that says that it is out of tolerance.
struct Waiting {
    line: usize,
    row: Row,
    name: String,
    numbers: Numbers,
    beyond: Option<Printed>,
}

/// So many rows of one feature wait.
const MOST: usize = 64;

/// Reads the lines.
struct Reader<'a, 's> {
    sink: &'a mut Sink<'s>,
    context: Context<'a>,
    numbers: Numbers,
    toolpath: String,
    time: Option<DateTime>,
    waiting: Vec<Waiting>,
    left: LeftLines,
    is_open: bool,
    /// The unit that the user has said; a report says none.
    unit: Option<Unit>,
    is_unit_told: bool,
    last: usize,
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let context = source.context.clone();
    let unit = source.given_unit();
    let mut reader = Reader {
        sink,
        context,
        numbers: Numbers::default(),
        toolpath: String::new(),
        time: None,
        waiting: Vec::new(),
        left: LeftLines::default(),
        is_open: false,
        unit,
        is_unit_told: unit.is_some(),
        last: 1,
    };
    each_line(source, &mut |line| reader.line(line))?;
    reader.flush();
    let Reader { sink, left, is_open, last, .. } = reader;
    left.tell(sink);
    if is_open {
        sink.warn(FilePlace::line(last), None, PrintedWarning::NoEnd { end: END }.into());
    }
    if sink.rows() == 0 { Err(ImportErrorKind::NoRows) } else { Ok(()) }
}

impl Reader<'_, '_> {
    /// Reads a line; `false` where no more are wanted.
    fn line(&mut self, line: PrintedLine<'_>) -> bool {
        let PrintedLine { number, text, .. } = line;
        self.last = number;
        let trimmed = text.trim();
        if let Some(numbers) = Numbers::of(text) {
            self.flush();
            self.numbers = numbers;
        } else if let Some(out) = OutOf::of(text, self.unit) {
            self.out(number, &out, trimmed);
        } else if let Some(row) = Row::of(text) {
            if self.sink.is_full(number) {
                return false;
            }
            self.row(line, row);
        } else if let Some(given) = trimmed.strip_prefix("TIMESTAMP ") {
            self.time = timestamp(given);
            if self.time.is_none() {
                let given = shorten(given.trim());
                self.sink.warn(FilePlace::line(number), None, ImportWarningKind::Time { given });
            }
        } else if let Some(name) = trimmed.strip_prefix("TOOLPATH ") {
            self.flush();
            name.trim().clone_into(&mut self.toolpath);
        } else {
            match trimmed {
                START => self.is_open = true,
                END => self.is_open = false,
                _ => self.left.add(line),
            }
        }
        true
    }

    fn row(&mut self, line: PrintedLine<'_>, row: Row) {
        if let Some(kind) = line.broken(false) {
            let given = shorten(line.text.trim_matches('\0').trim());
            return self.sink.refuse(FilePlace::line(line.number), kind, given);
        }
        if MOST <= self.waiting.len() {
            self.flush();
        }
        let name = name(&row, &self.toolpath, &self.numbers);
        let numbers = self.numbers.clone();
        self.waiting.push(Waiting { line: line.number, row, name, numbers, beyond: None });
    }

    /// A line that says that something is out of tolerance: a size of the feature, or else all of it.
    fn out(&mut self, line: usize, out: &OutOf, text: &str) {
        let mut sizes = self.waiting.iter_mut().rev().filter(|waiting| waiting.row.kind == "SIZE");
        match (out, sizes.next()) {
            (OutOf::Size(beyond), Some(size)) if size.beyond.is_none() => size.beyond = Some(*beyond),
            _ => {
                let row = self.waiting.last().map(|waiting| waiting.line);
                let given = shorten(text);
                self.sink.warn(FilePlace::line(line), row, PrintedWarning::OutOfPlace { given }.into());
            }
        }
    }

    /// Judges the rows that wait.
    fn flush(&mut self) {
        for waiting in std::mem::take(&mut self.waiting) {
            let line = waiting.line;
            if let Err((kind, given)) = self.judge(waiting) {
                self.sink.refuse(FilePlace::line(line), kind, given);
            }
        }
    }

    fn judge(&mut self, waiting: Waiting) -> Result<(), (ImportErrorKind, String)> {
        let Waiting { line, row, name, numbers, beyond } = waiting;
        let labels = labels(&row, &numbers);
        let mut aside = |id: String, why: WhyUnjudged| {
            self.sink.set_aside(set_aside(line, id, labels.clone(), self.time, why, &self.context));
        };
        if row.quantity().is_none() {
            aside(name, WhyUnjudged::NotASize { what: row.what() });
            return Ok(());
        }
        if let Some(said) = row.not_measured() {
            aside(name, WhyUnjudged::NotValid { said: said.to_owned() });
            return Ok(());
        }
        let figures = row.figures(self.unit).map_err(|kind| (kind, row.what()))?;
        if !std::mem::replace(&mut self.is_unit_told, true) {
            self.sink.warn(FilePlace::line(line), None, ImportWarningKind::UnitAssumed);
        }
        let characteristic = characteristic(&row, name, labels, &figures);
        let computed = Computed { deviation: figures.deviation, beyond };
        for warning in computed.tells(figures.measured.length, &characteristic.said()) {
            self.sink.warn(FilePlace::line(line), Some(line), warning.into());
        }
        let said = beyond.map(|beyond| format!("OUT OF TOL {}", beyond.length)).unwrap_or_default();
        let labels = Labels {
            serial: numbers.component,
            claims: computed.claim(&said).into_iter().collect(),
            rounded_by: figures.measured.rounded_by(),
            ..characteristic.labels.clone()
        };
        let value = Value { line, measured: figures.measured.length, time: self.time, labels, is_simulated: false };
        characteristic.judge(value, &self.context, self.sink);
        Ok(())
    }
}

/// What a row is called: by its toolpath, else by its feature. Everything but a diameter says besides what was measured.
fn name(row: &Row, toolpath: &str, numbers: &Numbers) -> String {
    let of = match toolpath {
        "" if numbers.feature.is_empty() => String::new(),
        "" => format!("FEATURE NO {}", numbers.feature),
        toolpath => toolpath.to_owned(),
    };
    if row.quantity() == Some(Quantity::Diameter) { of } else { format!("{of} {}", row.axis).trim().to_owned() }
}

/// The number of a component keeps parts apart, as a serial number does.
fn labels(row: &Row, numbers: &Numbers) -> Labels {
    let quantity = row.quantity();
    let is_size = quantity == Some(Quantity::Diameter);
    Labels {
        number: if is_size { numbers.feature.clone() } else { String::new() },
        may_be_running: true,
        serial: numbers.component.clone(),
        quantity: Some(quantity.unwrap_or(Quantity::Other)),
        ..Labels::default()
    }
}

fn characteristic(row: &Row, name: String, labels: Labels, figures: &row::Figures) -> Characteristic {
    let nominal = figures.nominal.length;
    let tolerance = figures.tolerance.filter(|_| !row.is_of_position).map(|tolerance| tolerance.length);
    let limit = |by: Option<Length>| nominal.checked_add(by?);
    Characteristic {
        name,
        what: match labels.quantity {
            Some(Quantity::Diameter) => CharacteristicKind::Size,
            _ if tolerance.is_none() && !row.is_of_position => CharacteristicKind::Length(WhyUnjudged::NoTolerance),
            _ => CharacteristicKind::Length(WhyUnjudged::NotASize { what: row.what() }),
        },
        class: String::new(),
        feature: None,
        nominal: Some(nominal),
        minimum: limit(tolerance.map(Length::negated)),
        maximum: limit(tolerance),
        expanded: None,
        labels: Labels { serial: String::new(), ..labels },
    }
}

/// The sizes of a print, each once however many components it has.
fn plan(source: &mut Source<'_>, found: &mut Characteristics) -> Result<(), ImportErrorKind> {
    let unit = source.given_unit();
    let mut numbers = Numbers::default();
    let mut toolpath = String::new();
    each_line(source, &mut |line| {
        if let Some(these) = Numbers::of(line.text) {
            numbers = these;
        } else if let Some(name) = line.text.trim().strip_prefix("TOOLPATH ") {
            name.trim().clone_into(&mut toolpath);
        } else if let Some(row) = Row::of(line.text)
            && row.quantity().is_some()
            && row.not_measured().is_none()
        {
            match line.broken(false).map_or_else(|| row.figures(unit), Err) {
                Ok(figures) => {
                    let name = name(&row, &toolpath, &numbers);
                    if unit.is_none() {
                        found.tell(line.number, ImportWarningKind::UnitAssumed);
                    }
                    found.add(line.number, characteristic(&row, name, labels(&row, &numbers), &figures));
                }
                Err(kind) => found.refuse(line.number, kind),
            }
        }
        true
    })
}
