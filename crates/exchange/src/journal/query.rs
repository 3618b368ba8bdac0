//! Which records are listed, and in which order: a question that memory answers today and a database can answer
//! tomorrow.
//!
//! A list asks for the rows in sight and nothing else. A record is named by its [`RecordId`], never by its place, since
//! its place changes with the order and the filter.

use std::ops::Range;
use std::sync::Arc;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::probing::Origin;
use fitcheck_core::verdict::Status;
use jiff::civil::DateTime;

use super::Record;
use super::natural::Natural;

/// Names a record for as long as there is a journal: a later record has a larger number, and none is given twice.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RecordId(pub u64);

/// What records are listed by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Column {
    /// Date and time of the check.
    Time,
    /// Name of the feature or part.
    Part,
    /// The callout: by nominal size, then by class.
    Callout,
    /// The measured diameter.
    Measured,
    /// The deviation from the nominal size.
    Deviation,
    /// The verdict, best first.
    Status,
    /// Where the measured value comes from.
    From,
}

impl Column {
    /// Every column, from left to right.
    pub const ALL: [Self; 7] =
        [Self::Time, Self::Part, Self::Callout, Self::Measured, Self::Deviation, Self::Status, Self::From];

    /// What records are compared by in this column.
    pub fn key(self, record: &Record) -> Key {
        match self {
            Self::Time => Key::Time(record.time),
            Self::Part => Key::Text(0, Natural(record.id.clone())),
            Self::Callout => Key::Text(record.limits.nominal.nanometres(), Natural(callout(record))),
            Self::Measured => Key::Length(record.measurement.diameter),
            Self::Deviation => Key::Length(record.verdict.size.deviation),
            Self::Status => Key::Status(record.verdict.status()),
            Self::From => {
                let (kind, text) = match &record.measurement.origin {
                    Origin::Typed => (0, String::new()),
                    Origin::Imported { file } => (1, file.to_string()),
                    Origin::Contacts { file } => (2, file.to_string()),
                    Origin::ImportedSimulation { file } => (3, file.to_string()),
                    Origin::Simulated { cycle, seed } => (4, format!("{cycle} {seed}")),
                };
                Key::Text(kind, Natural(text))
            }
        }
    }
}

/// What records are compared by; only keys of one column are comparable in a useful way.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Key {
    Time(DateTime),
    Length(Length),
    /// A verdict.
    Status(Status),
    /// A text, and a number that counts before it.
    Text(i64, Natural),
}

/// An order by a column. Records that are equal there are in the order in which they were added.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sort {
    pub column: Column,
    /// Smallest first; otherwise the whole order is reversed.
    pub ascending: bool,
}

/// A word of a filter: a record must have it somewhere.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct FilterWord {
    /// As it was typed.
    given: String,
    /// As it is looked for.
    folded: String,
    /// Statuses whose names have it, in the user's language.
    pub statuses: Vec<Status>,
    /// Whether the name for a simulated value has it.
    pub simulated: bool,
    /// Whether the name for a typed value has it.
    pub typed: bool,
}

impl FilterWord {
    /// A word that is looked for in parts, callouts, values, dates and file names.
    pub fn new(word: &str) -> Self {
        Self { given: word.to_owned(), folded: folded(word), ..Self::default() }
    }

    /// Whether a text has it, such as the name of a status.
    pub fn is_in(&self, text: &str) -> bool {
        folded(text).contains(&self.folded)
    }

    /// The same of a text that is folded already.
    pub(crate) fn is_in_folded(&self, text: &str) -> bool {
        text.contains(&self.folded)
    }

    /// In a callout a capital letter means a hole: `H7` does not find `h7`. Small letters find both.
    pub(crate) fn is_in_callout(&self, callout: &str) -> bool {
        if self.given.chars().any(char::is_uppercase) { callout.contains(&self.given) } else { self.is_in(callout) }
    }
}

/// A point and a comma are one decimal sign, a hyphen and a minus sign one sign; case does not count.
pub(crate) fn folded(text: &str) -> String {
    text.to_lowercase().replace(',', ".").replace('\u{2212}', "-")
}

/// The texts of a record in which words are looked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Searched {
    text: Box<str>,
    callout: Box<str>,
}

impl Searched {
    pub fn of(record: &Record) -> Self {
        let file = match &record.measurement.origin {
            Origin::Contacts { file } | Origin::Imported { file } | Origin::ImportedSimulation { file } => {
                file.as_ref()
            }
            Origin::Simulated { .. } | Origin::Typed => "",
        };
        let measured = record.measurement.diameter.exact(Unit::Millimetre, 4);
        let time = record.time.strftime(TIME);
        let um = record.verdict.size.deviation.signed_um();
        let text = folded(&format!("{}\n{measured}\n{um}\n{time}\n{file}", record.id));
        Self { text: text.into(), callout: callout(record).into() }
    }
}

/// Date and time as they are listed, the same in every language.
pub const TIME: &str = "%Y-%m-%d %H:%M:%S";

/// The callout, or the nominal size where limits came from a log without one.
pub fn callout(record: &Record) -> String {
    record.callout.map_or_else(|| format!("Ø {}", record.limits.nominal), |callout| callout.to_string())
}

/// Which records are listed, and in which order.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Query {
    /// Words that a record must have, all of them.
    pub words: Vec<FilterWord>,
    /// Whether good ones are left out.
    pub only_bad: bool,
    /// The order; `None` is the order in which records were added, the newest first.
    pub sort: Option<Sort>,
}

impl Query {
    /// Whether it finds a record with these texts.
    pub fn finds(&self, record: &Record, texts: &Searched) -> bool {
        let status = record.verdict.status();
        let origin = &record.measurement.origin;
        let has = |wanted: &FilterWord| {
            texts.text.contains(&wanted.folded)
                || wanted.is_in_callout(&texts.callout)
                || wanted.statuses.contains(&status)
                || (wanted.simulated && origin.is_simulated())
                || (wanted.typed && *origin == Origin::Typed)
        };
        (!self.only_bad || record.verdict.asks_for_a_look()) && self.words.iter().all(has)
    }

    /// What a record is compared by, and then its number.
    pub(super) fn key(&self, id: RecordId, record: &Record) -> (Option<Key>, RecordId) {
        (self.sort.map(|sort| sort.column.key(record)), id)
    }

    /// Whether the largest key comes first.
    pub(super) fn is_reversed(&self) -> bool {
        self.sort.is_none_or(|sort| !sort.ascending)
    }

    /// Puts records in its order, without leaving any out.
    pub fn arrange(&self, records: &mut [(RecordId, Arc<Record>)]) {
        records.sort_by_cached_key(|(id, record)| self.key(*id, record));
        if self.is_reversed() {
            records.reverse();
        }
    }
}

/// Where records are kept.
///
/// The answers are about the query that was asked last. They are ready: no frame waits for a sort.
pub trait Records {
    fn ask(&mut self, query: Query);

    /// The query that was asked last.
    fn query(&self) -> &Query;

    /// How many records it finds.
    fn count(&self) -> usize;

    /// How many of them stand and have each status, in the order of [`Status::ALL`].
    fn counts(&self) -> [usize; Status::ALL.len()];

    /// How many of them stand and ask for a look.
    fn bad(&self) -> usize;

    /// The records at these places of its answer; places beyond the last are left out.
    fn page(&self, places: Range<usize>) -> Vec<(RecordId, Arc<Record>)>;

    /// The place of a record in its answer; `None` where the query does not find it.
    fn place_of(&self, id: RecordId) -> Option<usize>;

    /// A record, whether the query finds it or not.
    fn get(&self, id: RecordId) -> Option<Arc<Record>>;

    /// How many records there are.
    fn len(&self) -> usize;

    /// Whether there is none.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
