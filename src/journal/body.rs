//! An entry as the bytes that are hashed and kept.

use super::entry::Entry;
use crate::message::Say;

/// Why bytes are no entry, or an entry cannot be written.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "journal-body", error)]
pub enum BodyError {
    /// Not the JSON of an entry.
    Json {
        /// What the reader says.
        reason: String,
    },
}

/// The bytes of an entry.
///
/// # Errors
/// [`BodyError`] where a text is too long or has control characters.
pub fn write(_entry: &Entry) -> Result<Vec<u8>, BodyError> {
    Err(BodyError::Json { reason: String::new() })
}

/// The entry in bytes.
///
/// # Errors
/// [`BodyError`] where they are no entry that this version can read.
pub fn read(_bytes: &[u8]) -> Result<Entry, BodyError> {
    Err(BodyError::Json { reason: String::new() })
}
