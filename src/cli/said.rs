//! What a subcommand says on standard error besides errors.

use crate::length::Length;
use crate::message::{IntoArg, Message, Say};
use crate::tolerance::ToleranceClass;

/// What there is to say about an answer, or beside it.
#[derive(Debug, Say)]
#[say(prefix = "cli-note")]
pub(super) enum Note<'a> {
    /// A file is written.
    Wrote { path: String },
    /// A file of several files is written.
    WroteFiles { path: String, count: usize },
    /// A column of a file of contacts.
    ColumnNotUsed { column: &'a str },
    /// A part can still be machined.
    Remove { limit: Length, middle: Length },
    /// The user's own table does not say what ISO 286 says.
    OwnTable { name: &'a str, upper: Length, lower: Length },
    /// Callouts without an answer.
    Refused { refused: usize, asked: usize },
    /// A search that found nothing.
    NoPair { nearest: String },
    /// A cell for which ISO 286 has no value, or several.
    EmptyCell {
        #[say(with = ToString::to_string)]
        class: ToleranceClass,
        over: Length,
        to: Length,
    },
    /// Recorded contacts that the cycle did not ask for.
    ContactsLeft { used: usize, count: usize },
    /// A cycle whose log is not known.
    LogUnknown { code: &'a str },
    /// A folder for logs and an input that wants none.
    LogOff,
    /// A folder for logs and a cycle without one.
    LogNone,
    /// A folder for logs and an input that shows it.
    LogOnScreen,
    /// The default that nobody chose.
    ClearanceHeight { height: Length },
}

/// `warning: …`
pub(super) fn warning(what: &impl Say) -> Message {
    Message::new("cli-warning").with("what", what)
}

/// `note: …`
pub(super) fn note(what: &impl Say) -> Message {
    Message::new("cli-note").with("what", what)
}

/// A sentence after what it is about.
pub(super) fn about(what: &(impl IntoArg + ?Sized), sentence: &impl Say) -> Message {
    Message::new("cli-about").with("what", what).with("error", sentence)
}
