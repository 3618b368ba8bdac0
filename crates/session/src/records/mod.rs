//! The records page: everything that the journal has, however much that is. Only what is in sight is read, and not here: the
//! page asks, and takes the answers as they come.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields |
//! | `command`, `apply` | what can be done, and doing it |
//! | `asking` | from the text of the question to what is asked |
//! | `listing` | which records are listed, and those that were read |
//! | `correcting` | from the form of a correction to the entry that makes it |
//! | `sending` | the form for the server of the shop |
//! | `walking` | the walk along the chain |
//! | `choosing` | the chosen records, as a report and on the clipboard |

mod actions;
mod apply;
mod asking;
mod choosing;
mod command;
mod correcting;
mod field;
mod listing;
mod sending;
mod walking;

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

pub use actions::{RECORDS, RecordsAction};
pub(crate) use asking::question;
pub use asking::{Filter, NOT_GOOD, Shorthand};
pub use choosing::{LeftOut, RowTexts};
pub use command::RecordsCommand;
pub use correcting::Correcting;
pub use field::RecordsField;
use fitcheck_core::message::Message;
use fitcheck_exchange::journal::chain::Head;
use fitcheck_exchange::journal::entry::{Entry, Moment};
use fitcheck_exchange::journal::query::{RecordId, TIME};
use jiff::Timestamp;
use jiff::civil::DateTime;
use jiff::tz::TimeZone;
pub use listing::{FoundNumbers, Listing, Numbers, PAGE};

use self::choosing::Gathering;
use self::correcting::Replacing;
use super::effect::Effect;

/// A record as it is read from the journal.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordRow {
    /// Its number and hash.
    pub head: Head,
    /// What it tells, or why that cannot be read.
    pub entry: Result<Entry, Message>,
    /// The entry that corrects it or takes it back.
    pub corrected_by: Option<u64>,
    /// Whether the station's clock stood earlier than for the entry before it.
    pub went_back: bool,
}

/// What a walk along the chain has found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verified {
    /// How many entries it has walked over.
    pub entries: u64,
    /// The newest of them.
    pub head: Head,
    /// What is wrong; empty where the chain is whole.
    pub problems: Vec<Message>,
}

/// A walk along the chain.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Walk {
    #[default]
    None,
    /// It goes on: so many entries of so many.
    Running {
        /// How many entries are done.
        done: u64,
        /// How many there are.
        of: u64,
    },
    /// It was stopped.
    Cancelled,
    /// It has ended.
    Done {
        /// What it has found.
        result: Result<Verified, Message>,
        /// When.
        at: DateTime,
    },
}

#[derive(Debug, Clone, PartialEq)]
pub struct OpenRecord {
    pub number: u64,
    /// The record, once it is read; or why it cannot be.
    pub row: Option<Result<Arc<RecordRow>, Message>>,
    /// The record that corrects it or takes it back, once that is read.
    pub by: Option<Arc<RecordRow>>,
    /// Whether that is asked for.
    asks_by: bool,
    /// The reports that show it, as far as they are read; or why they cannot be.
    pub reports: Result<Vec<Arc<RecordRow>>, Message>,
}

/// The state of the records page.
#[derive(Debug, Default)]
pub struct RecordsPage {
    texts: BTreeMap<RecordsField, String>,
    errors: BTreeMap<RecordsField, Message>,
    /// Where in the question an error shows.
    culprit: Option<Range<usize>>,
    /// The words of the question that have names.
    pub filters: Vec<Filter>,
    /// Whether the form for another one is open.
    pub is_filtering: bool,
    filter_key: Option<&'static str>,
    /// How many questions and walks there were.
    runs: u64,
    /// The number of the question that is asked.
    asks: u64,
    /// Which records are listed, and those that were read.
    pub listing: Listing,
    /// The newest number when the question was asked.
    asked_at: u64,
    /// The row of the list at which the keys are.
    pub cursor: Option<u64>,
    /// Goes up whenever the cursor has to come into sight.
    look: u64,
    chosen: BTreeMap<u64, Arc<RecordRow>>,
    /// What was listed when a report of all of it was asked for.
    gathered: BTreeMap<u64, Arc<RecordRow>>,
    /// What is being read of it.
    gathering: Option<Gathering>,
    /// The format of a report whose records are read: its dialog is opened.
    pub(super) report_soon: Option<usize>,
    /// Whether simulated checks are taken into the report.
    pub with_simulated: bool,
    pub open: Option<OpenRecord>,
    /// The correction that is being made.
    pub correcting: Option<Correcting>,
    /// Whether it is asked for and its record is being read.
    corrects_soon: bool,
    /// Corrections on their way to the journal, by their batch.
    replacing: BTreeMap<u64, Replacing>,
    /// What stood before a correction of the history.
    before: BTreeMap<RecordId, Entry>,
    /// The number of the walk that goes on.
    walks: u64,
    /// The walk along the chain.
    pub walk: Walk,
    errands: Vec<Effect>,
}

impl RecordsPage {
    /// Where to look: a number that goes up whenever a row has to come into sight, and its place.
    pub fn look(&self) -> (u64, Option<usize>) {
        (self.look, self.cursor.and_then(|number| self.listing.place_of(number)))
    }

    /// Whether a record is chosen for a report.
    pub fn is_chosen(&self, number: u64) -> bool {
        self.chosen.contains_key(&number)
    }

    /// The record that is open, where it could be read.
    pub fn opened_row(&self) -> Option<&Arc<RecordRow>> {
        self.open.as_ref()?.row.as_ref()?.as_ref().ok()
    }
}

/// Date and time as the station's clock showed them.
pub fn local_time(moment: &Moment) -> String {
    let minutes = i64::from(moment.offset_min);
    let local = minutes.checked_mul(60_000).and_then(|ahead| moment.utc_ms.checked_add(ahead));
    let local = local.and_then(|local| Timestamp::from_millisecond(local).ok());
    local.map_or_else(String::new, |local| TimeZone::UTC.to_datetime(local).strftime(TIME).to_string())
}
