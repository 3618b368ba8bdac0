//! What of an import is recorded, and which rows are not.

use std::sync::Arc;

use super::row::ImportRow;
use crate::cli::record::Recorder;
use crate::cli::said::Recorded;
use crate::cli::{CliError, Io};
use crate::journal::chain::Hash;
use crate::journal::entry::{FileRole, UsedFile};

/// So many rows are named; more are counted.
const MOST: usize = 20;

/// Collects the checks of all files, which are recorded together.
pub(super) struct Keeping {
    recorder: Recorder,
    /// What every check was made with, such as a budget.
    shared: Vec<UsedFile>,
    /// The same with the file that is read now.
    files: Vec<UsedFile>,
    /// How many checks were kept before this file.
    first: usize,
    /// Rows that are no checks, or that cannot be kept, and the first ones by file and line.
    without: usize,
    places: Vec<String>,
    /// Whether a judged row was no entry.
    has_refused: bool,
}

impl Keeping {
    pub(super) fn new(recorder: Recorder, io: &Io<'_>) -> Self {
        Self {
            recorder,
            shared: io.files(),
            files: Vec::new(),
            first: 0,
            without: 0,
            places: Vec::new(),
            has_refused: false,
        }
    }

    /// From here on rows are those of this file; its hash is known once it is read.
    pub(super) fn reads(&mut self, name: &str) {
        self.files.clone_from(&self.shared);
        self.files.push(UsedFile { role: FileRole::Measurements, name: name.into(), sha256: Hash::of_file(&[]) });
        self.first = self.recorder.count();
    }

    /// The file is read, and this is its hash.
    pub(super) fn has_read(&mut self, sha256: Hash) {
        self.recorder.hash_last_file(self.first, sha256);
    }

    /// A row: a check is kept.
    pub(super) fn see(&mut self, row: &ImportRow) {
        let place = || row.line.map_or_else(|| row.file.to_string(), |line| format!("{}:{line}", row.file));
        let why = match &row.judged {
            Some(record) => match self.recorder.size_of(Arc::clone(record), &row.labels, self.files.clone()) {
                Ok(()) => return,
                Err(error) => {
                    self.has_refused = true;
                    match error {
                        CliError::NotRecorded { error } => format!(" ({error})"),
                        error => format!(" ({error})"),
                    }
                }
            },
            None => String::new(),
        };
        self.without += 1;
        if self.places.len() < MOST {
            self.places.push(format!("{}{why}", place()));
        }
    }

    /// Records all of them or none; whether a check was no entry.
    pub(super) fn end(self, io: &mut Io<'_>) -> Result<bool, CliError> {
        let Self { recorder, without, mut places, has_refused, .. } = self;
        if MOST < without {
            places.push("…".to_owned());
        }
        if 0 < without {
            io.warn(&Recorded::Without { rows: without, places: places.join(", ") });
        }
        recorder.keep(io)?;
        Ok(has_refused)
    }
}
