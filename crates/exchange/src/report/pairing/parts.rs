//! Measured parts, with everything about them that has to be said.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Located, Message, Say};
use fitcheck_core::tolerance::{Feature, Limits};
use fitcheck_core::verdict::{Status, judge_size};

use crate::exchange::{ImportError, ImportErrorKind, Size, Sizes, SizesWarning};
use crate::journal::Record;

/// Where parts come from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PartsFrom {
    /// A file, as the user named it: a line of a part is a line of the file.
    File(String),
    /// Checks: a line of a part is the number of the check, the oldest first.
    Checks,
}

/// Holes or shafts.
#[derive(Debug, Clone, PartialEq)]
pub struct PairingParts {
    /// Where they come from.
    pub from: PartsFrom,
    /// The parts, in order of their lines.
    pub sizes: Vec<Size>,
    /// The size of each part, in the same order.
    pub measured: Vec<Length>,
    /// What could not be used.
    pub errors: Vec<Located<ImportError>>,
    /// What has to be said about the rest.
    pub notes: Vec<Note>,
}

/// Something that has to be said about parts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// The line, if it is about one.
    pub line: Option<usize>,
    pub what: Message,
}

/// What to check about parts.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "pairing-parts")]
pub enum PartsWarning {
    /// Checks with the same name.
    CheckedTwice {
        /// The first such name.
        id: String,
        /// The number of its first check.
        first: usize,
        /// The number of its second check.
        second: usize,
        /// How many checks have the name of an earlier one.
        rows: usize,
    },
    /// Parts outside their own limits.
    OutsideLimits {
        /// How many.
        count: usize,
    },
    /// Checks of simulated measurements.
    SimulatedChecks {
        /// How many.
        count: usize,
    },
}

impl PartsWarning {
    /// What is said of the rows of a file, of checks.
    fn of_checks(doubt: SizesWarning) -> Self {
        match doubt {
            SizesWarning::NamedTwice { id, first, second, rows } => Self::CheckedTwice { id, first, second, rows },
            SizesWarning::SimulatedRows { count } => Self::SimulatedChecks { count },
        }
    }
}

impl Note {
    /// Something about all parts.
    pub fn of(what: &impl Say) -> Self {
        Self { line: None, what: what.message() }
    }
}

impl PairingParts {
    pub fn of_file(file: impl Into<String>, read: Sizes) -> Self {
        let found = read.warnings.iter().map(|found| Note { line: found.place.line, what: found.what.message() });
        let notes = found.chain(read.doubts().iter().map(Note::of)).collect();
        Self::new(PartsFrom::File(file.into()), read, notes)
    }

    /// The holes or the shafts among checks; `records` are the oldest first.
    pub fn of_records<'a>(records: impl Iterator<Item = &'a Record>, feature: Feature) -> Self {
        let mut found = Sizes::default();
        for (line, record) in (1..).zip(records).filter(|(_, record)| record.limits.feature == Some(feature)) {
            let measured = record.measurement.diameter;
            if Length::ZERO < measured {
                let is_simulated = record.measurement.origin.is_simulated();
                found.measured.push(Size { line, id: record.id.clone(), measured, is_simulated });
            } else {
                let given = measured.to_string();
                let kind = ImportErrorKind::NotPositive { given: given.clone() };
                found.errors.push(Located::in_line(line, ImportError { kind, given }));
            }
        }
        let notes = found.doubts().into_iter().map(|doubt| Note::of(&PartsWarning::of_checks(doubt))).collect();
        Self::new(PartsFrom::Checks, found, notes)
    }

    fn new(from: PartsFrom, found: Sizes, notes: Vec<Note>) -> Self {
        let measured = found.measured.iter().map(|part| part.measured).collect();
        Self { from, sizes: found.measured, measured, errors: found.errors, notes }
    }

    /// The file's name, for machines; of checks the word that stands in its place.
    pub fn file(&self) -> &str {
        match &self.from {
            PartsFrom::File(file) => file,
            PartsFrom::Checks => "history",
        }
    }

    /// How many of them nobody measured.
    pub fn simulated(&self) -> usize {
        self.sizes.iter().filter(|part| part.is_simulated).count()
    }

    /// What is said where some of them are outside their own limits.
    pub fn outside(&self, limits: &Limits) -> Option<PartsWarning> {
        let is_out = |measured: &&Length| judge_size(limits, **measured).status != Status::Good;
        let count = self.measured.iter().filter(is_out).count();
        (0 < count).then_some(PartsWarning::OutsideLimits { count })
    }

    /// Where a note belongs: `holes.csv:4`, `holes.csv`.
    pub fn place_of(&self, note: &Note) -> String {
        note.line.map_or_else(|| self.file().to_owned(), |line| format!("{}:{line}", self.file()))
    }

    /// A note with its place, for machines.
    pub fn warning(&self, note: &Note) -> String {
        format!("{}: {}", self.place_of(note), note.what)
    }

    /// Every note with its place, for machines.
    pub fn warnings(&self) -> Vec<String> {
        self.notes.iter().map(|note| self.warning(note)).collect()
    }
}
