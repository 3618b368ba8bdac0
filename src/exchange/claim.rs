//! What a file itself says of a value's status: told where the verdict is another one.

use super::error::{ImportWarningKind, shorten};
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

    /// The warning where a verdict is another one.
    pub(super) fn differs(&self, status: Status) -> Option<ImportWarningKind> {
        let warning =
            || ImportWarningKind::StatusDiffers { given: self.said.clone(), status: status.word().to_owned() };
        (!self.agrees.contains(&status)).then(warning)
    }
}
