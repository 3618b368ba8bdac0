//! Why a text is no question, and where.

use std::ops::Range;

use fitcheck_core::message::{Message, Say, display, message, printed};
use fitcheck_core::tolerance::{CalloutError, ClassError};

/// Why a text is no question, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AskError {
    /// The reason.
    pub kind: AskErrorKind,
    /// The characters that are wrong, counted from 0.
    pub span: Range<usize>,
}

/// Why a text is no question.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "journal-ask", error)]
pub enum AskErrorKind {
    /// Nothing is asked for by this name.
    UnknownKey {
        /// What was given.
        key: String,
        known: String,
    },
    /// Nothing comes after the colon.
    NoValue {
        /// What was given.
        key: String,
    },
    /// Nothing is within the quotation marks.
    EmptyWord,
    Twice {
        key: String,
    },
    /// The second quotation mark is missing.
    NotClosed,
    /// Something else than a blank comes after the second quotation mark.
    AfterQuote {
        found: String,
    },
    /// Not a day, or not one that there is.
    Date {
        given: String,
    },
    /// Not a verdict.
    Verdict {
        given: String,
        known: String,
    },
    /// Not a callout.
    Callout {
        /// Why.
        error: CalloutError,
    },
    /// Not a tolerance class.
    Class {
        /// Why.
        error: ClassError,
    },
    /// The end is not after the beginning.
    Order,
    /// Simulated checks alone and measured checks alone.
    BothOrigins,
    /// Reports alone and checks alone.
    BothKinds,
    /// A text that nobody typed.
    TooLong {
        /// How many bytes it has.
        #[say(with = printed)]
        bytes: usize,
        /// How many it may have.
        #[say(with = printed)]
        most: usize,
    },
}

impl Say for AskError {
    fn message(&self) -> Message {
        let reason = self.kind.message();
        message!("journal-ask-at").message("reason", reason).count("at", self.span.start.saturating_add(1))
    }
}

display!(AskError);

impl std::error::Error for AskError {}
