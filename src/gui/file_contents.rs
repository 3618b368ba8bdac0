//! What files are read with, and what is known of one that was read.

use std::path::Path;

use jiff::civil::DateTime;

use super::working::Job;
use crate::control::mask::Mask;
use crate::exchange::Remembered;
use crate::files;
use crate::journal::chain::Hash;
use crate::message::{Message, Say as _};
use crate::session::Command;
use crate::session::help::Sample;
use crate::tolerance::Sources;
use crate::tolerance::fit::thermal::Temperature;

/// What files are read with.
#[derive(Clone, Copy)]
pub(super) struct With<'a> {
    pub sources: &'a Sources,
    /// The columns of files as they were corrected.
    pub columns: &'a Remembered,
    /// The user's own mask.
    pub masks: &'a [(String, Mask)],
    /// From which temperature values are brought to 20 °C.
    pub temperature: Option<Temperature>,
    pub now: DateTime,
    /// Begins a file that is read, or written.
    pub begins: &'a dyn Fn(&Path, bool) -> Job,
}

/// What a file holds.
pub(super) struct FileContents {
    /// What is to be known before.
    pub before: Option<Command>,
    /// The command that takes it.
    pub command: Command,
    /// SHA-256 of the file where a record may name it.
    pub sha256: Option<Hash>,
}

/// The bytes of a file that a record may name.
pub(super) fn bytes_of(path: &Path, seen: &mut Option<Hash>) -> Result<Vec<u8>, Message> {
    let bytes = file_or_sample(path)?;
    *seen = Some(Hash::of_file(&bytes));
    Ok(bytes)
}

/// The bytes of a file, or of a sample, which lies in no folder.
pub(super) fn file_or_sample(path: &Path) -> Result<Vec<u8>, Message> {
    match Sample::bytes_at(path) {
        Some(bytes) => Ok(bytes.to_vec()),
        None => files::read_file(path).map_err(|error| error.message()),
    }
}

pub(super) fn name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// What was read, unless that was stopped: of half a file nothing is taken.
pub(super) fn whole<T>(read: T, job: &Job) -> Result<T, Message> {
    if job.is_stopped() { Err(job.stopped()) } else { Ok(read) }
}
