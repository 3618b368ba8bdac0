//! What a file itself says of a value's status: told where the verdict is another one.

use super::error::{ImportWarningKind, shorten};
use crate::control::status::status_of;
use crate::verdict::Status;

/// What a file says of a value's status.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Claim {
    /// As the file says it.
    pub said: String,
    /// The verdicts that agree with it.
    pub agrees: &'static [Status],
}

impl Claim {
    /// A claim of one status.
    pub(super) fn of(said: &str, status: Status) -> Self {
        let agrees: &'static [Status] = match status {
            Status::Good => &[Status::Good],
            Status::Rework => &[Status::Rework],
            Status::Scrap => &[Status::Scrap],
            Status::ReMeasure => &[Status::ReMeasure],
        };
        Self { said: shorten(said), agrees }
    }

    /// That a value is out of its limits, or that something else is wrong with it.
    pub(super) fn out(said: &str) -> Self {
        // Whoever knows no rework calls it so as well.
        Self { said: shorten(said), agrees: &[Status::Rework, Status::Scrap] }
    }

    /// A claim that no verdict agrees with.
    pub(super) fn unknown(said: &str) -> Self {
        Self { said: shorten(said), agrees: &[] }
    }

    /// What a word of a table claims; `None` for one that is not known.
    pub(super) fn of_word(word: &str) -> Option<Self> {
        if let Some(status) = status_of(word) {
            return Some(Self::of(word, status));
        }
        let small: String = word.to_lowercase().chars().filter(|c| c.is_alphanumeric()).collect();
        match small.as_str() {
            "ok" | "pass" | "passed" | "accept" | "accepted" | "conform" | "conforms" | "io" | "inordnung" | "oke"
            | "akkoord" | "goedgekeurd" | "conforme" => Some(Self::of(word, Status::Good)),
            "nok" | "notok" | "ng" | "fail" | "failed" | "reject" | "rejected" | "nio" | "nichtinordnung"
            | "nietok" | "afgekeurd" | "nonconform" | "nonconforme" | "nonok" | "ko" | "bad" | "schlecht"
            | "slecht" | "scrapped" | "outoftolerance" | "oot" | "zurückgewiesen" | "gesperrt" => {
                Some(Self::out(word))
            }
            // "n.i.O. (scratch)", "rejected - burr"
            _ => {
                let (first, _) =
                    word.split_once(" (").or_else(|| word.split_once(" - ")).or_else(|| word.split_once(": "))?;
                Some(Self { said: shorten(word), ..Self::of_word(first)? })
            }
        }
    }

    /// The warning where a verdict is another one.
    pub(super) fn differs(&self, status: Status) -> Option<ImportWarningKind> {
        let warning =
            || ImportWarningKind::StatusDiffers { given: self.said.clone(), status: status.word().to_owned() };
        (!self.agrees.contains(&status)).then(warning)
    }
}
