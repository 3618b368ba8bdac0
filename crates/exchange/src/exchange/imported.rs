//! What was read from a file: records, and everything that did not become one.

use fitcheck_core::length::Length;
use fitcheck_core::message::{FilePlace, Located, Say};
use fitcheck_core::part::NotFound;
use fitcheck_core::probing::cycle::ResultName;
use fitcheck_core::probing::{Contact, Origin, noted};
use fitcheck_core::tolerance::Limits;
use fitcheck_core::tolerance::fit::thermal::Correction;
use fitcheck_core::verdict::{PositionVerdict, Removal, SizeVerdict, Status, judge_size};
use jiff::civil::DateTime;

use super::claim::Claim;
use super::error::{ImportError, ImportErrorKind, ImportWarning, ImportWarningKind};
use super::no_place::NoPlace;
use super::quantity::Quantity;
use crate::journal::Record;

/// The most rows of a file that are kept in memory: a record takes some hundred bytes.
pub const MOST_ROWS: usize = 500_000;

/// What was read from a file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Imported {
    /// What could be judged, in the file's order.
    pub records: Vec<Record>,
    /// The line of each record, in the same order: a row's own line, a log's title.
    pub lines: Vec<usize>,
    /// What the file says of each record besides, in the same order.
    pub labels: Vec<Labels>,
    /// Measurements that make no record, because nothing says what they should be.
    pub unjudged: Vec<Unjudged>,
    /// Rows that could not be used, or the reason why the whole file could not be.
    pub errors: Vec<Located<ImportError>>,
    /// Warnings about what was still readable.
    pub warnings: Vec<Located<ImportWarning>>,
    /// The contacts of a file of contacts.
    pub contacts: Option<Vec<Contact>>,
    /// How many rows or logs were read: records, unjudged measurements and errors together.
    pub rows: usize,
}

/// What a file says of a value besides its name: which part it is of, who measured it, and where it lies.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Labels {
    /// The number of the characteristic; empty where it has none.
    pub number: String,
    /// Whether the number, or a name that is one, may be a running one: the file does not say that it is of a feature.
    pub may_be_running: bool,
    /// The part, such as its drawing number; empty where the file names none.
    pub part: String,
    /// The part's serial number; empty where the file has none.
    pub serial: String,
    /// What the file calls the column of the value, where parts stand side by side; empty otherwise.
    pub sample: String,
    /// Who measured; empty where the file does not say.
    pub who: String,
    /// When it was measured, where the file says so: other records have the time of import.
    pub time: Option<DateTime>,
    /// The batch; empty where the file has none.
    pub batch: String,
    /// The machine that made the part; empty where the file does not say.
    pub machine: String,
    /// What it was measured with; empty where the file does not say.
    pub gauge: String,
    /// Where the feature should lie, or else where it was found, as far as the file says: X, Y, Z.
    pub place: [Option<Length>; 3],
    /// Why the place that the file has is none for a measuring cycle; there is no place then.
    pub no_place: Option<NoPlace>,
    /// Whether the file has a place and cannot say along which axis the feature lies.
    pub is_axis_assumed: bool,
    /// Which of the two sides of a pocket or boss it is, from 0, where the file says so.
    pub side: Option<usize>,
    /// What the file says was measured: a diameter, a coordinate, another quantity.
    pub quantity: Option<Quantity>,
    /// What the file says of its status.
    pub claims: Vec<Claim>,
    /// Whether the file says that the value was brought to 20 °C, without saying from what.
    pub is_corrected: bool,
    /// How far the value may lie from its figures, where the file was printed with a known number of decimals: half of the last one. Zero
    /// where the figures are the value.
    pub rounded_by: Length,
}

/// Part and feature of a value in a journal, however it gets there: what its file or field calls it is the part where no part is named,
/// and the feature otherwise.
pub fn part_and_feature(part: &mut String, feature: &mut String, id: &str) {
    if part.is_empty() {
        id.clone_into(part);
    } else if feature.is_empty() {
        id.clone_into(feature);
    }
}

impl Labels {
    /// What tells the part from others of its kind: its serial number, or else its column among parts side by side.
    pub fn piece(&self) -> &str {
        if self.serial.is_empty() { &self.sample } else { &self.serial }
    }

    /// Why a value cannot be judged by limits although it has figures: a limit lies between the values that are printed so, and has more
    /// decimals than they have, or the file's own status is another one. On a limit with as many decimals the figures decide.
    pub(super) fn too_coarse(&self, limits: &Limits, measured: Length, status: Status) -> Option<WhyUnjudged> {
        let half = self.rounded_by;
        let unit = half.nanometres().checked_mul(2).filter(|unit| 0 < *unit)?;
        let is_within = |limit: &Length| limit.saturating_sub(measured).abs() <= half;
        let mut crossed = [limits.minimum(), limits.maximum()].into_iter().filter(is_within).peekable();
        crossed.peek()?;
        let is_finer = crossed.any(|limit| limit.nanometres() % unit != 0);
        let is_denied = || self.claims.iter().any(|claim| claim.differs(status).is_some());
        let from = measured.checked_sub(half)?;
        let to = measured.checked_add(half)?;
        let why = WhyUnjudged::Rounded { from, to };
        (is_finer || is_denied()).then_some(why)
    }
}

/// What a file says that a value should be, as far as it says it. Lengths are sizes or coordinates, not deviations.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct StatedLimits {
    /// The nominal size.
    pub nominal: Option<Length>,
    /// The smallest permitted value.
    pub minimum: Option<Length>,
    /// The largest permitted value.
    pub maximum: Option<Length>,
}

/// A measurement that makes no record.
#[derive(Debug, Clone, PartialEq)]
pub struct Unjudged {
    /// Its line, from 1.
    pub line: usize,
    /// Name of the feature or part, where there is one.
    pub id: String,
    /// What else the file says of it.
    pub labels: Labels,
    /// When it was measured, or imported.
    pub time: DateTime,
    /// The measured diameter or coordinate; `None` for contacts.
    pub measured: Option<Length>,
    /// Where the value comes from: a simulated one stays simulated.
    pub origin: Origin,
    /// The centre's position, where the control monitored it.
    pub position: Option<PositionVerdict>,
    /// What it should be, as far as the file says so besides the reason.
    pub asked: StatedLimits,
    /// How it was brought to 20 °C already, where it was.
    pub correction: Option<Correction>,
    /// Why it makes no record.
    pub why: WhyUnjudged,
}

impl Unjudged {
    /// What it should be, as far as the file says so.
    pub fn asked(&self) -> StatedLimits {
        match &self.why {
            WhyUnjudged::Coordinate(own) | WhyUnjudged::Point(own) | WhyUnjudged::Size { judged: own, .. } => {
                StatedLimits { nominal: own.nominal, minimum: Some(own.minimum), maximum: Some(own.maximum) }
            }
            WhyUnjudged::NoLimits { nominal } => StatedLimits { nominal: Some(*nominal), ..self.asked },
            _ => self.asked,
        }
    }
}

/// Why a measurement makes no record.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "exchange-unjudged")]
pub enum WhyUnjudged {
    /// The row has no callout.
    NoCallout,
    /// A value of zero or less without a callout: a plan may know that it is no diameter.
    #[say(id = "exchange-not-positive")]
    NotPositive {
        given: String,
        /// Its column, from 1.
        #[say(skip)]
        column: usize,
    },
    /// The log's limits of size are both 0: the control did not monitor the diameter.
    NoLimits {
        /// The log's nominal diameter.
        nominal: Length,
    },
    /// A coordinate is not a feature of size, but its log has limits.
    #[say(args(cycle = field_0.cycle))]
    Coordinate(#[say(skip)] Coordinate),
    /// A coordinate whose limits are both 0: the control did not monitor it.
    CoordinateWithoutLimits,
    /// A width or the side of a rectangle: judged by its limits, but not a hole or shaft.
    #[say(args(cycle = judged.cycle))]
    Size {
        /// What was measured.
        what: ResultName,
        /// Its limits, and its status by them.
        #[say(skip)]
        judged: Coordinate,
    },
    /// A width or side whose limits are both 0: the control did not monitor it.
    SizeWithoutLimits {
        /// What was measured.
        what: ResultName,
    },
    /// A point on a surface that was probed in 3-D: the measured value is its deviation along the normal, nominal 0.
    #[say(args(cycle = field_0.cycle))]
    Point(#[say(skip)] Coordinate),
    PointWithoutTolerance,
    /// A size with one limit alone.
    OneLimit,
    /// A characteristic without limits.
    NoTolerance,
    /// Limits of which the smaller one is the larger one.
    SwappedLimits {
        /// What the file calls the smallest permitted value.
        minimum: Length,
        /// What it calls the largest one.
        maximum: Length,
    },
    /// A value that was printed with so few decimals that it may lie on either side of a limit.
    Rounded {
        /// The smallest value that is printed so.
        from: Length,
        /// The largest one.
        to: Length,
    },
    /// A value that cannot be: the plan says what can.
    Implausible {
        /// As it was measured.
        measured: Length,
        /// The smallest value that can be.
        lower: Length,
        /// The largest one.
        upper: Length,
    },
    /// A characteristic that is no size of a hole or shaft, such as a position or a roundness.
    NotASize {
        /// What the file calls it.
        what: String,
    },
    /// The plan that it should be judged by has no feature for it, or not one alone.
    #[say(transparent)]
    NotInPlan(NotFound),
    /// A characteristic of AQDEF with another quantity than a diameter.
    Quantity {
        /// Its number, K2009.
        quantity: u32,
    },
    /// A characteristic of AQDEF that is not measured: parts or errors are counted.
    Kind {
        /// Its number, K2004.
        kind: u32,
    },
    /// A value of AQDEF with a mark whose meaning is not known.
    Attribute {
        /// The mark, K0002.
        given: String,
    },
    /// A value of which its file says that it is none, or that nobody knows.
    NotValid {
        /// As the file says it.
        said: String,
    },
    /// A characteristic with a declaration that cannot be used, which is an error of its own.
    Declaration {
        /// The line of the declaration.
        declaration: usize,
    },
    /// Contacts, and nothing else.
    Contacts {
        /// How many.
        count: usize,
    },
}

/// A value without a callout against its limits, judged as the control does: a coordinate, a deviation, a width, a side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Coordinate {
    /// The name of the cycle that measured it, as programs know it.
    pub cycle: &'static str,
    /// The nominal value, where the log has one.
    pub nominal: Option<Length>,
    /// The largest permitted value.
    pub maximum: Length,
    /// The smallest permitted value.
    pub minimum: Length,
    /// The status by these limits.
    pub status: Status,
    /// For rework, how much to remove.
    pub removal: Option<Removal>,
}

impl Coordinate {
    /// A value against its limits.
    pub(super) fn judged(cycle: &'static str, nominal: Option<Length>, limits: &Limits, measured: Length) -> Self {
        let SizeVerdict { status, removal, .. } = judge_size(limits, measured);
        Self { cycle, nominal, maximum: limits.maximum(), minimum: limits.minimum(), status, removal }
    }
}

/// What a file holds, one thing after the other, in the order of its lines.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// What could be judged.
    Record {
        line: usize,
        /// The check.
        record: Box<Record>,
        /// What else the file says of it.
        labels: Labels,
    },
    /// A measurement that makes no record.
    Unjudged(Box<Unjudged>),
    /// A row that could not be used, or why the whole file could not be.
    Error(Box<Located<ImportError>>),
    /// A warning; one about a row comes before the row.
    Warning(Located<ImportWarning>),
    /// The contacts of a file of contacts.
    Contacts(Vec<Contact>),
}

impl Item {
    /// Whether it is a row or log: a record, a measurement that makes none, or an error.
    pub const fn is_row(&self) -> bool {
        !matches!(self, Self::Warning(_) | Self::Contacts(_))
    }

    /// Whether its file does not say its unit; [`Format::takes_unit`](super::Format::takes_unit) says whether a mapping may.
    pub const fn lacks_unit(&self) -> bool {
        match self {
            Self::Error(error) => error.what.kind.lacks_unit(),
            Self::Warning(warning) => warning.what.kind.lacks_unit(),
            Self::Record { .. } | Self::Unjudged(_) | Self::Contacts(_) => false,
        }
    }
}

impl Imported {
    /// Whether its file does not say its unit; [`Format::takes_unit`](super::Format::takes_unit) says whether a mapping may.
    pub fn lacks_unit(&self) -> bool {
        self.errors.iter().any(|error| error.what.kind.lacks_unit())
            || self.warnings.iter().any(|warning| warning.what.kind.lacks_unit())
    }

    /// Keeps a thing that was read.
    pub(super) fn keep(&mut self, item: Item) {
        self.rows += usize::from(item.is_row());
        match item {
            Item::Record { line, record, labels } => {
                self.records.push(*record);
                self.lines.push(line);
                self.labels.push(labels);
            }
            Item::Unjudged(unjudged) => self.unjudged.push(*unjudged),
            Item::Error(error) => self.errors.push(*error),
            Item::Warning(warning) => self.warnings.push(warning),
            Item::Contacts(contacts) => self.contacts = Some(contacts),
        }
    }
}

/// Where readers put what they read.
pub(super) struct Sink<'a> {
    /// How many rows or logs there were: records, unjudged measurements and errors together.
    rows: usize,
    most: usize,
    /// Hears the first and the last line of what has several lines.
    units: &'a dyn Fn(usize, usize),
    take: &'a mut dyn FnMut(Item),
}

impl<'a> Sink<'a> {
    /// As many rows as there are.
    pub(super) fn new(take: &'a mut dyn FnMut(Item)) -> Self {
        Self::up_to(usize::MAX, take)
    }

    /// At most so many rows; an error says that there are more.
    pub(super) fn up_to(most: usize, take: &'a mut dyn FnMut(Item)) -> Self {
        Self { rows: 0, most, units: &|_first, _last| {}, take }
    }

    /// The same, and somebody hears of units of several lines.
    pub(super) fn telling(self, units: &'a dyn Fn(usize, usize)) -> Self {
        Self { units, ..self }
    }

    /// The first and the last line of a log, a print or a value of several lines, also of one that could not be read.
    pub(super) fn unit(&self, first: usize, last: usize) {
        (self.units)(first, last);
    }

    pub(super) const fn rows(&self) -> usize {
        self.rows
    }

    /// Counts a row that went elsewhere.
    pub(super) const fn count(&mut self) {
        self.rows += 1;
    }

    /// Whether no more is read, after an error that says so.
    pub(super) fn is_full(&mut self, line: usize) -> bool {
        let is_full = self.most <= self.rows;
        if is_full {
            self.refuse(FilePlace::line(line), ImportErrorKind::TooManyRows { most: self.most }, String::new());
        }
        is_full
    }

    fn row(&mut self, item: Item) {
        self.rows += 1;
        (self.take)(item);
    }

    /// How many more rows are read.
    pub(super) const fn left(&self) -> usize {
        self.most.saturating_sub(self.rows)
    }

    /// Passes on what another reader has read.
    pub(super) fn pass(&mut self, item: Item) {
        self.rows += usize::from(item.is_row());
        (self.take)(item);
    }

    /// A file that could not be used at all.
    pub(super) fn fail(&mut self, kind: ImportErrorKind) {
        self.refuse(FilePlace::line(1), kind, String::new());
    }

    pub(super) fn keep(&mut self, line: usize, record: Record, labels: Labels) {
        if let Some(differs) = record.callout.and_then(|callout| noted::differing(callout.notes(), &record.limits)) {
            self.warn(FilePlace::line(line), Some(line), ImportWarningKind::Callout(differs));
        }
        self.row(Item::Record { line, record: Box::new(record), labels });
    }

    pub(super) fn set_aside(&mut self, unjudged: Unjudged) {
        self.row(Item::Unjudged(Box::new(unjudged)));
    }

    pub(super) fn refuse(&mut self, place: FilePlace, kind: ImportErrorKind, given: String) {
        self.row(Item::Error(Box::new(Located { what: ImportError { kind, given }, place })));
    }

    pub(super) fn contacts(&mut self, contacts: Vec<Contact>) {
        (self.take)(Item::Contacts(contacts));
    }

    /// `row` is the line of the record or unjudged measurement that it belongs to.
    pub(super) fn warn(&mut self, place: FilePlace, row: Option<usize>, kind: ImportWarningKind) {
        (self.take)(Item::Warning(Located { what: ImportWarning { row, kind }, place }));
    }
}
