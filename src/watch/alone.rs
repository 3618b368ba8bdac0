//! That a folder is watched for a journal by one program alone: two of them would take every file twice.

use std::fs::{File, OpenOptions, TryLockError};
use std::path::Path;

use crate::files::{FileError, system};
use crate::journal::chain::Hash;

/// As long as it lives nobody else watches the folder for the journal; the system gives it back whatever ends the program.
#[derive(Debug)]
pub struct Alone(#[expect(dead_code, reason = "it is locked as long as it is open")] File);

impl Alone {
    /// Takes a folder for a journal; `None` where another program watches it for that. The lock is a file beside the journal.
    ///
    /// # Errors
    /// [`FileError`] where that file cannot be made, or where locks are not to be had.
    pub fn take(folder: &Path, journal: &Path) -> Result<Option<Self>, FileError> {
        let whole = folder.canonicalize().map_err(|error| system(folder, &error))?;
        let folder_hash = Hash::of_file(whole.as_os_str().as_encoded_bytes()).short();
        let mut name = journal.file_name().unwrap_or_default().to_owned();
        name.push(format!(".watch-{folder_hash}"));
        let path = journal.with_file_name(name);
        let failed = |error: std::io::Error| system(&path, &error);
        let file = OpenOptions::new().create(true).truncate(false).write(true).open(&path).map_err(failed)?;
        match file.try_lock() {
            Ok(()) => Ok(Some(Self(file))),
            Err(TryLockError::WouldBlock) => Ok(None),
            Err(TryLockError::Error(error)) => Err(failed(error)),
        }
    }
}
