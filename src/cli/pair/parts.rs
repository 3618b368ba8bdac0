//! The measured parts of a file, with everything about it that has to be said.

use std::path::Path;

use crate::cli::io::{Io, read_input};
use crate::cli::said::warning;
use crate::cli::{CliError, CliWarning};
use crate::exchange::{ImportError, Size, Sizes, sizes};
use crate::length::Length;
use crate::message::{Located, Message, Say as _};
use crate::tolerance::{Feature, Limits};
use crate::verdict::{Status, judge_size};

/// Holes or shafts of a file.
pub(in crate::cli) struct Parts {
    /// The file as the user named it.
    pub(in crate::cli) file: String,
    pub(in crate::cli) sizes: Vec<Size>,
    /// The size of each part, in the same order.
    pub(in crate::cli) measured: Vec<Length>,
    /// What could not be used.
    pub(in crate::cli) errors: Vec<Located<ImportError>>,
    /// What was said about the file.
    pub(in crate::cli) warnings: Vec<String>,
}

impl Parts {
    /// Reads a file; errors and warnings also go to standard error.
    pub(in crate::cli) fn read(path: &Path, feature: Feature, io: &mut Io<'_>) -> Result<Self, CliError> {
        let (name, bytes) = read_input(path, io)?;
        let file = if path.as_os_str() == "-" { name.clone() } else { path.display().to_string() };
        let read = sizes(&name, &bytes, feature);
        let doubts = read.doubts();
        let Sizes { measured: found, errors, warnings } = read;
        let mut notes: Vec<(Option<usize>, Message)> =
            warnings.iter().map(|found| (found.place.line, found.what.message())).collect();
        notes.extend(doubts.iter().map(|doubt| (None, doubt.message())));
        let mut warnings = Vec::new();
        for (line, what) in notes {
            let place = line.map_or_else(|| file.clone(), |line| format!("{file}:{line}"));
            io.tell(format_args!("{place}: {}", warning(&what)));
            warnings.push(format!("{place}: {what}"));
        }
        let measured = found.iter().map(|part| part.measured).collect();
        let read = Self { file, sizes: found, measured, errors, warnings };
        for error in &read.errors {
            io.tell(format_args!("{}: {}", read.place(error), error.what.kind));
        }
        Ok(read)
    }

    /// Warns of parts outside their own limits: a pair of them may still have a wanted clearance.
    pub(super) fn hold_to(&mut self, limits: &Limits, io: &mut Io<'_>) {
        let is_out = |measured: &&Length| judge_size(limits, **measured).status != Status::Good;
        let count = self.measured.iter().filter(is_out).count();
        if 0 < count {
            let what = CliWarning::OutsideLimits { count }.message();
            io.tell(format_args!("{}: {}", self.file, warning(&what)));
            self.warnings.push(format!("{}: {what}", self.file));
        }
    }

    /// `holes.csv:4:2`
    fn place(&self, error: &Located<ImportError>) -> String {
        let column = error.place.column.map_or(String::new(), |column| format!(":{column}"));
        format!("{}:{}{column}", self.file, error.place.line.unwrap_or(1))
    }
}
