//! What was read from a file: records, and everything that did not become one.

use jiff::civil::DateTime;

use super::error::{ImportError, ImportErrorKind, ImportWarning, ImportWarningKind};
use crate::journal::Record;
use crate::length::Length;
use crate::message::{Located, Place, Say};
use crate::probing::Contact;
use crate::probing::cycle::FoundName;
use crate::tolerance::Limits;
use crate::verdict::{PositionVerdict, Removal, SizeVerdict, Status, judge_size};

/// The most rows that are read from one file: a record takes some hundred bytes, so this bounds the memory.
pub const MOST_ROWS: usize = 500_000;

/// What was read from a file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Imported {
    /// What could be judged, in the file's order.
    pub records: Vec<Record>,
    /// The line of each record, in the same order: a row's own line, a log's title.
    pub lines: Vec<usize>,
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

/// A measurement that makes no record.
#[derive(Debug, Clone, PartialEq)]
pub struct Unjudged {
    /// Its line, from 1.
    pub line: usize,
    /// Name of the feature or part, where there is one.
    pub id: String,
    /// When it was measured, or imported.
    pub time: DateTime,
    /// The measured diameter or coordinate; `None` for contacts.
    pub measured: Option<Length>,
    /// The centre's position, where the control monitored it.
    pub position: Option<PositionVerdict>,
    /// Why it makes no record.
    pub why: WhyUnjudged,
}

/// Why a measurement makes no record.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "exchange-unjudged")]
pub enum WhyUnjudged {
    /// The row has no callout.
    NoCallout,
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
        what: FoundName,
        /// Its limits, and its status by them.
        #[say(skip)]
        judged: Coordinate,
    },
    /// A width or side whose limits are both 0: the control did not monitor it.
    SizeWithoutLimits {
        /// What was measured.
        what: FoundName,
    },
    /// A point on a surface that was probed in 3-D: the measured value is its deviation along the normal, nominal 0.
    #[say(args(cycle = field_0.cycle))]
    Point(#[say(skip)] Coordinate),
    /// Such a point without a tolerance.
    PointWithoutTolerance,
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

impl Imported {
    /// A file that could not be used at all.
    pub(super) fn failed(kind: ImportErrorKind) -> Self {
        let mut imported = Self::default();
        imported.refuse(Place::line(1), kind, String::new());
        imported
    }

    pub(super) fn keep(&mut self, line: usize, record: Record) {
        self.rows += 1;
        self.records.push(record);
        self.lines.push(line);
    }

    pub(super) fn set_aside(&mut self, unjudged: Unjudged) {
        self.rows += 1;
        self.unjudged.push(unjudged);
    }

    pub(super) fn refuse(&mut self, place: Place, kind: ImportErrorKind, given: String) {
        self.rows += 1;
        self.errors.push(Located { what: ImportError { kind, given }, place });
    }

    /// `row` is the line of the record or unjudged measurement that it belongs to.
    pub(super) fn warn(&mut self, line: usize, row: Option<usize>, kind: ImportWarningKind) {
        self.warnings.push(Located::in_line(line, ImportWarning { row, kind }));
    }
}
