//! What can be done on the records page, what the journal answers, and what is said of who measures.

use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::tolerance::Feature;
use fitcheck_exchange::journal::chain::{Hash, Head};
use fitcheck_exchange::journal::entry::Reported;
use jiff::civil::DateTime;
use jiff::tz::TimeZone;

use super::{FoundNumbers, RecordRow, RecordsField, Shorthand, Verified};
use crate::recording::OpenJournal;
use crate::step::Step;

/// What can be done on the records page, and what comes back from the journal.
#[derive(Debug, Clone)]
pub enum RecordsCommand {
    /// Replaces the text of a field.
    Type(RecordsField, String),
    /// The window has begun.
    Begin {
        /// Where records are kept unless the state file names another file; `None` keeps none.
        usual: Option<PathBuf>,
        /// The name of the station.
        station: String,
        /// Where its days begin.
        zone: TimeZone,
    },
    /// The journal was opened, with its newest checks, the oldest of them first; or it cannot be opened.
    Opened(Result<(Box<OpenJournal>, Vec<RecordRow>), Message>),
    /// Entries are on disk with these numbers and hashes, or are not.
    Kept {
        /// Which entries: the number of their batch.
        run: u64,
        result: Result<Vec<Head>, Message>,
    },
    /// Writes again what could not be written.
    TryAgain,
    /// A file was read, and its bytes have this SHA-256: before the answer with what it holds.
    Measured {
        /// Its name without the folder.
        name: String,
        /// SHA-256 of its bytes.
        sha256: Hash,
    },
    /// A report was written, and is whole on disk.
    Reported(Box<Reported>),
    /// What is known of the server of the shop.
    Sent {
        /// How many entries it does not have yet; `None` where that is not known.
        unsent: Option<u64>,
        /// What is wrong, when something is.
        trouble: Option<Message>,
    },
    /// Opens the form for the server of the shop, or closes it.
    AskForServer(bool),
    /// Sends to the server whose address is in the field.
    TakeServer,
    /// Sends to no server any more.
    LeaveServer,
    /// Sends at once, whatever went wrong before.
    SendAgain,
    /// The address in the field is one, without its password; or it is none.
    Server(Result<String, Message>),
    /// Something that the user should know.
    Note(Message),
    /// Somebody of the list measures from now on.
    UseName(String),
    /// The name in the field measures from now on.
    TakeName,

    /// Puts a word of the language of questions into the question, or takes it out.
    Toggle(Shorthand),
    /// Takes a word out of the question.
    RemoveFilter(String),
    /// Opens the form for another filter, or closes it.
    AskForFilter(bool),
    /// What the form asks about, in the language of questions.
    FilterBy(&'static str),
    /// Puts the filter of the form into the question.
    AddFilter,
    /// Asks the question again, for what is new.
    AskAgain,
    /// These places of the list are in sight: their rows are read.
    See(Range<usize>),
    /// The reader has found records for a question, or cannot.
    Found {
        /// Which question.
        run: u64,
        /// What it has found since it last said something.
        result: Result<FoundNumbers, Message>,
    },
    /// Rows were read, or cannot be.
    Read {
        /// Those that were asked for.
        numbers: Vec<u64>,
        result: Result<Vec<Arc<RecordRow>>, Message>,
    },
    /// The reports that show a record were read, or cannot be.
    ReportsRead {
        /// The record.
        number: u64,
        result: Result<Vec<Arc<RecordRow>>, Message>,
    },
    /// Goes to another row.
    Move(Step),
    /// Opens a record by its number.
    Open(u64),
    /// Goes back to the list.
    CloseRecord,
    /// Chooses a record for the report, or not.
    Choose(u64, bool),
    /// Chooses all that are listed.
    ChooseAll,
    ChooseNone,
    /// Takes simulated checks into the report, or leaves them out.
    WithSimulated(bool),
    /// Reports the chosen records, or all that are listed, in a format of the report's list, by its number there.
    Report(usize),
    /// Puts the chosen records on the clipboard, or the one at which the keys are.
    Copy,
    /// Goes to the check page with what the open record asked for.
    MeasureAgain,
    /// Opens the form of a correction, or closes it.
    Correct(bool),
    /// The same for a record of this number, whichever is open.
    CorrectNumber(u64),
    /// Says whether a hole or a shaft is meant, for a callout of the form that does not say it.
    ChooseFeature(Feature),
    /// Whether the correction takes the record back, and puts nothing in its place.
    Withdraw(bool),
    /// Writes the correction.
    SendCorrection,
    /// Walks the chain from its first entry.
    Verify,
    /// Stops that.
    CancelVerify,
    /// The walk goes on.
    Verifying {
        run: u64,
        /// How many entries it has walked over.
        done: u64,
        /// Of how many.
        of: u64,
    },
    /// The walk has ended.
    Verified {
        run: u64,
        /// What it has found.
        result: Result<Verified, Message>,
        /// When.
        at: DateTime,
    },
}
