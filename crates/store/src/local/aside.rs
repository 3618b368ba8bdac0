//! A damaged journal makes room for another one: it is moved with all that belongs to it, and never changed.

use fitcheck_files as files;
use std::path::{Path, PathBuf};

use fitcheck_exchange::journal::entry::Moment;

use super::anchor::Anchor;
use crate::error::StoreError;

/// What belongs to one journal.
const ENDINGS: [&str; 3] = ["", "-wal", "-shm"];

/// Whether a file that could not be opened is a damaged journal. A file that is no database at all was one if its last entry is known.
pub(super) fn is_damage(error: &StoreError, known: Option<&Anchor>) -> bool {
    match error {
        StoreError::Damaged { .. } | StoreError::NoBeginning { .. } | StoreError::Altered { .. } => true,
        StoreError::NotAJournal { .. } => known.is_some(),
        _ => false,
    }
}

/// Moves a journal's files into a folder of their own beside them; returns the folder.
pub(super) fn set_aside(path: &Path, now: &Moment) -> Result<PathBuf, StoreError> {
    let parent = path.parent().unwrap_or_else(|| Path::new(""));
    // A clock beyond all calendars gives the folder a name all the same.
    let time = jiff::Timestamp::from_millisecond(now.utc_ms).unwrap_or(jiff::Timestamp::UNIX_EPOCH);
    let name = format!("damaged-{}", time.strftime("%Y%m%dT%H%M%SZ"));
    let failed = |error: &std::io::Error| StoreError::system(path, error);
    let mut folder = parent.join(&name);
    for number in 2.. {
        match std::fs::create_dir(&folder) {
            Ok(()) => break,
            Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {
                folder = parent.join(format!("{name}-{number}"));
            }
            Err(error) => return Err(failed(&error)),
        }
    }
    for ending in ENDINGS {
        let from = files::with_ending(path, ending);
        match std::fs::rename(&from, folder.join(files::name_of(&from))) {
            Ok(()) => {}
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => {}
            Err(error) => return Err(failed(&error)),
        }
    }
    Ok(folder)
}
