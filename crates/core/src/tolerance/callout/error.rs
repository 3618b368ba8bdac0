//! Why a text is not a callout: the reason, and the character where the error is.

use std::ops::Range;

use super::kind::CalloutErrorKind;
use super::scanner::TextSpan;
use crate::length::LengthError;
use crate::message::{Message, Say, display, message, shortened};
use crate::tolerance::ClassError;

/// The most characters of a given text that an error repeats.
const LONGEST_GIVEN: usize = 80;

/// Why a text is not a callout, and where.
///
/// ```
/// use fitcheck_core::tolerance::Callout;
///
/// let error = "12 +0.1 -0.2 H7".parse::<Callout>().unwrap_err();
/// assert_eq!(error.to_string(), "H7 is not expected here: the text is complete without it (character 14)");
/// assert_eq!(error.span(), Some(13..15));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CalloutError {
    /// What was given, without blanks around it and at most 80 characters of it; empty where no text was read.
    pub text: String,
    /// The character where the error begins, counted from 1 in the text as given; 0 where no text was read.
    pub at: usize,
    /// How many characters are wrong; 0 where something is missing.
    pub length: usize,
    /// The reason.
    pub kind: CalloutErrorKind,
}

impl CalloutError {
    /// An error at a place in a text.
    pub(super) fn at(text: &str, place: TextSpan, kind: CalloutErrorKind) -> Self {
        let count = |range: Range<usize>| text.get(range).map_or(0, |part| part.chars().count());
        let at = count(0..place.start) + 1;
        let length = count(place.start..place.end);
        Self { text: shorten(text.trim()), at, length, kind }
    }

    /// The same error at a place in a text.
    pub(super) fn placed(self, text: &str, place: TextSpan) -> Self {
        Self::at(text, place, self.kind)
    }

    /// The characters that are wrong, counted from 0 in the text as given; an empty range where something is missing.
    /// `None` where no text was read.
    pub fn span(&self) -> Option<Range<usize>> {
        let start = self.at.checked_sub(1)?;
        Some(start..start.saturating_add(self.length))
    }

    /// The character that the message names, where the reason alone does not show the place.
    fn told_place(&self) -> Option<usize> {
        (0 < self.at && self.kind.needs_place()).then_some(self.at)
    }
}

impl From<CalloutErrorKind> for CalloutError {
    /// An error in values, not in a text.
    fn from(kind: CalloutErrorKind) -> Self {
        Self { text: String::new(), at: 0, length: 0, kind }
    }
}

impl From<ClassError> for CalloutError {
    /// An error in a class on its own.
    fn from(error: ClassError) -> Self {
        CalloutErrorKind::Class(Box::new(error)).into()
    }
}

display!(CalloutError);

impl Say for CalloutError {
    fn message(&self) -> Message {
        match self.told_place() {
            Some(at) => message!("callout-at").with("reason", &self.kind).with("at", &at),
            None => self.kind.message(),
        }
    }
}

impl std::error::Error for CalloutError {}

/// The same error with at most 80 characters of its text.
pub(super) fn shorten_length(error: LengthError) -> LengthError {
    match error {
        LengthError::Empty => LengthError::Empty,
        LengthError::NotANumber { text } => LengthError::NotANumber { text: shorten(&text) },
        LengthError::Ambiguous { text } => LengthError::Ambiguous { text: shorten(&text) },
        LengthError::TooFine { text } => LengthError::TooFine { text: shorten(&text) },
        LengthError::TooLarge { text } => LengthError::TooLarge { text: shorten(&text) },
    }
}

/// At most 80 characters of a text, without control characters.
pub(super) fn shorten(text: &str) -> String {
    shortened(text, LONGEST_GIVEN)
}
