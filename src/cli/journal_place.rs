//! Where a journal is: `--journal`, the variable, or the user's own.

use std::path::PathBuf;

use super::CliError;
use crate::files;
use crate::store::{is_server, local};

pub(super) const JOURNAL: &str =
    "Journal: a file, or the server of a shop (postgres://…); default: FITCHECK_JOURNAL, or your own journal";

/// Where a journal is.
#[derive(Debug, Clone, clap::Args)]
pub(super) struct JournalArgs {
    #[arg(long, help = JOURNAL, value_name = "FILE|ADDRESS")]
    journal: Option<String>,
}

/// Where a journal is.
pub(super) enum JournalPlace {
    /// The file of a station.
    File(PathBuf),
    /// The server of a shop. Its address may hold a password.
    Server(String),
}

impl JournalPlace {
    /// The journal that was named, or else the user's own.
    pub(super) fn of(given: Option<&str>) -> Result<Self, CliError> {
        match given.map(str::to_owned).or_else(of_variable) {
            Some(text) if is_server(&text) => Ok(Self::Server(text)),
            Some(text) => Ok(Self::File(PathBuf::from(text))),
            None => own().map(Self::File),
        }
    }
}

fn of_variable() -> Option<String> {
    std::env::var("FITCHECK_JOURNAL").ok().filter(|text| !text.is_empty())
}

/// The user's own journal.
pub(super) fn own() -> Result<PathBuf, CliError> {
    Ok(files::journal_folder().ok_or(CliError::NoJournalFolder)?.join(local::FILE))
}

impl JournalArgs {
    /// The file or the server.
    pub(super) fn place(&self) -> Result<JournalPlace, CliError> {
        JournalPlace::of(self.journal.as_deref())
    }

    /// Whether one is named, here or by the variable.
    pub(super) fn is_given(&self) -> bool {
        self.journal.is_some() || of_variable().is_some()
    }

    /// The file, for what a server cannot do.
    pub(super) fn file(&self) -> Result<PathBuf, CliError> {
        match self.place()? {
            JournalPlace::File(file) => Ok(file),
            JournalPlace::Server(_) => Err(CliError::JournalIsServer),
        }
    }
}
