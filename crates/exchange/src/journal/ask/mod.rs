//! Questions to a journal: one language for window and command line.
//!
//! Words are apart by blanks, and every one of them narrows the question:
//!
//! | word | which checks |
//! |---|---|
//! | `part:Flange` `feature:B1` `who:Anna` `station:"Mill 3"` | of this name, whole; capital or small letters |
//! | `serial:17` `serial:17*` | of this serial number, or of all that begin so |
//! | `callout:"25 H7"` `class:H7` | of this callout, of this class: capital letters are holes |
//! | `verdict:scrap,rework` | with any of these verdicts: `good`, `rework`, `re-measure`, `scrap` |
//! | `from:2026-11-01` `to:2026-11-23` | recorded on these days, the last one included; also `2026-11-23T14:30`: from then on, before then |
//! | `today` `week` | recorded today; in this week, which begins on Monday |
//! | `simulated` `measured` | only simulated ones, only measured ones |
//! | `standing` | that no other one corrects and that were not withdrawn |
//! | `reports` `checks` `alarms` | only files that were written; only checks and what takes them back; only alarms of control charts and their answers, with `standing` those that nobody has answered |
//! | `good` `rework` `re-measure` `scrap` | with this verdict, or with any of several, and `standing`; also in the words of who asks |
//! | anything else | with a word that begins so, in names, callout, remark or reason, in a report's file or title; `88` is also record 88, `25.01` a measured value |
//!
//! What asks for a verdict, for simulated or measured checks or for `standing` finds checks alone, and no report or alarm.
//!
//! What has blanks or a colon goes in quotation marks, `""` within them is one; a word in quotation marks is never one of those above the
//! last.
//!
//! | file | what |
//! |---|---|
//! | here | a question |
//! | `reading` | from its text |
//! | `error` | why a text is no question, and where |
//! | `printing` | its text again |
//! | `finding` | whether it asks for an entry |
//!
//! To add a word to questions:
//!
//! 1. Add a field to [`Question`], its lines in `reading`, `printing` and `finding`, and its row above. `finding` answers for entries that
//!    are not indexed yet and for the server; `store/shop/reading.rs` may narrow what the server sends.
//! 2. Add what it needs to `journal/found.rs` and `body/brief.rs`.
//! 3. Add a column and a condition to `schema.rs` and `finding.rs` in `store/local`, and raise `schema::VERSION`. The next recording brings
//!    an older file up to date; until then nobody reads that file.
//! 4. Name the word in the help of `cli/journal/mod.rs`, in `records-page-help` and in `gui/records/asking_panel.rs`.
//! 5. Ask for it in `questions_find_what_a_look_at_every_entry_finds` (`tests/core/local_journal.rs`).

mod error;
mod finding;
mod printing;
mod reading;

pub use error::{AskError, AskErrorKind};
use fitcheck_core::verdict::Status;
use jiff::Timestamp;
use jiff::civil::Date;
use jiff::tz::TimeZone;
pub use printing::asking;
pub use reading::{KEYS, SWITCHES, verdict_of};

/// When and where somebody asks: what `today` is, and when a day begins.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LocalNow {
    /// The time now.
    pub now: Timestamp,
    /// The zone whose days are meant.
    pub zone: TimeZone,
}

impl LocalNow {
    /// The day that it is.
    fn today(&self) -> Date {
        self.now.to_zoned(self.zone.clone()).date()
    }
}

/// Which kinds of entries are asked for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum AskedKinds {
    /// Checks, what takes them back, files that were written, and alarms.
    #[default]
    All,
    /// Checks and what takes them back.
    Checks,
    /// Files that were written.
    Reports,
    /// Alarms of control charts and their answers.
    Alarms,
}

/// Which checks are asked for. What is not given asks for nothing: an empty question finds every check.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Question {
    /// The part, whole.
    pub part: Option<String>,
    /// The serial number, or with `*` at its end its beginning.
    pub serial: Option<String>,
    /// The feature, whole.
    pub feature: Option<String>,
    /// The callout, whole, such as `25 H7`.
    pub callout: Option<String>,
    /// The tolerance class, such as `H7`.
    pub class: Option<String>,
    /// Any of these verdicts; empty for every one.
    pub verdicts: Vec<Status>,
    /// Who measured, whole.
    pub who: Option<String>,
    /// The station, whole.
    pub station: Option<String>,
    /// From this instant on: milliseconds since 1970 in UTC.
    pub from_ms: Option<i64>,
    /// Before this instant.
    pub before_ms: Option<i64>,
    /// Simulated checks alone, or measured checks alone; `None` for both.
    pub simulated: Option<bool>,
    /// Only checks that stand: none that another one corrects or that was taken back. Of alarms those that nobody has answered.
    pub standing: bool,
    /// Which kinds of entries.
    pub kinds: AskedKinds,
    /// Words that the part, serial number, feature, callout, name, remark or reason has, or begins a word with: all of them. A plain number is
    /// also the number of the record, and one with a decimal sign the measured value.
    pub words: Vec<String>,
}
