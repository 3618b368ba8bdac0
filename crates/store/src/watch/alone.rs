//! That a folder is watched for a journal by one program alone: two of them would take every file twice.

use std::fs::{File, OpenOptions, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use fitcheck_exchange::journal::chain::Hash;
use fitcheck_files::{self as files, FileError, folder_of, system};

/// As long as it lives nobody else watches the folder for the journal; the system gives it back whatever ends the program.
#[derive(Debug)]
pub struct Alone {
    #[expect(dead_code, reason = "it is locked as long as it is open")]
    locked: File,
    path: PathBuf,
}

impl Alone {
    /// Takes a folder for a journal; `None` where another program watches it for that. The lock is a file beside the journal.
    ///
    /// # Errors
    /// [`FileError`] where that file cannot be made, or where locks are not to be had.
    pub fn take(folder: &Path, journal: &Path) -> Result<Option<Self>, FileError> {
        let failed = |error: io::Error| system(folder, &error);
        let whole = folder.canonicalize().map_err(failed)?;
        let folder_hash = Hash::of_file(whole.as_os_str().as_encoded_bytes()).short();
        // A journal has one lock, whatever links lead to it.
        let journal = journal.canonicalize().or_else(|_not_yet| {
            let folder = folder_of(journal).canonicalize().map_err(failed)?;
            Ok(folder.join(files::name_of(journal)))
        })?;
        let path = files::with_ending(&journal, &format!(".watch-{folder_hash}"));
        let failed = |error: io::Error| system(&path, &error);
        let file = OpenOptions::new().create(true).truncate(false).write(true).open(&path).map_err(failed)?;
        match file.try_lock() {
            Ok(()) => Ok(Some(Self { locked: file, path })),
            Err(TryLockError::WouldBlock) => Ok(None),
            Err(TryLockError::Error(error)) => Err(failed(error)),
        }
    }

    /// The file that is locked.
    pub fn file(&self) -> &Path {
        &self.path
    }
}
