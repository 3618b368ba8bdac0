//! A copy of a journal at one moment, while it is in use.

use std::path::{Path, PathBuf};

use fitcheck_exchange::journal::chain::Head;
use fitcheck_files::{self as files, FileError};
use rusqlite::{Connection, params};

use super::{head_of, opening, verify};
use crate::error::StoreError;

/// Copies a journal to a file that does not exist yet, looks at every entry of the copy, and answers with its last one.
///
/// # Errors
/// [`StoreError`] where the copy is not whole; then there is none.
pub fn backup(path: &Path, to: &Path) -> Result<Head, StoreError> {
    if to.exists() {
        return Err(StoreError::File(FileError::Exists { path: to.to_owned() }));
    }
    let _which_version = opening::look_to_read(path)?;
    let connection = opening::to_read(path)?;
    let beside = with_ending(to, ".part");
    let made = copy(&connection, path, &beside).and_then(|()| {
        let found = verify(&beside, &[], &mut |_done, _all| std::ops::ControlFlow::Continue(()))?;
        if found.is_whole() {
            // A file that has appeared meanwhile is not replaced.
            std::fs::hard_link(&beside, to).map_err(|error| match error.kind() {
                std::io::ErrorKind::AlreadyExists => StoreError::File(FileError::Exists { path: to.to_owned() }),
                _ => StoreError::system(to, &error),
            })?;
            sync_folder(to);
            Ok(found.inspected.head)
        } else {
            Err(StoreError::Backup { path: path.to_owned() })
        }
    });
    for ending in ["", "-wal", "-shm"] {
        let _gone_or_never_there = std::fs::remove_file(with_ending(&beside, ending));
    }
    made
}

/// A copy beside an older journal, before it is brought to this version.
pub(super) fn before_migration(path: &Path, connection: &Connection) -> Result<PathBuf, StoreError> {
    let (_ours, version) = opening::version(connection).map_err(|error| StoreError::of(path, &error))?;
    for number in 1.. {
        let ending = if number == 1 { format!(".version-{version}") } else { format!(".version-{version}-{number}") };
        let copied = with_ending(path, &ending);
        if !copied.exists() {
            copy(connection, path, &copied)?;
            let there = opening::to_read(&copied)?;
            let head = |connection: &Connection| head_of(connection).map_err(|error| StoreError::of(path, &error));
            return if head(&there)? == head(connection)? {
                Ok(copied)
            } else {
                Err(StoreError::Backup { path: path.to_owned() })
            };
        }
    }
    Err(StoreError::Backup { path: path.to_owned() })
}

fn copy(connection: &Connection, path: &Path, to: &Path) -> Result<(), StoreError> {
    let _gone_or_never_there = std::fs::remove_file(to);
    let failed = |error: rusqlite::Error| match StoreError::of(to, &error) {
        // It is the journal that cannot be read.
        StoreError::Damaged { .. } | StoreError::NotAJournal { .. } => StoreError::Damaged { path: path.to_owned() },
        error => error,
    };
    let name = to.to_str().ok_or_else(|| StoreError::CannotOpen { path: to.to_owned() })?;
    connection.execute("VACUUM INTO ?1", params![name]).map_err(failed)?;
    // Windows makes nothing last that cannot be written.
    let file = std::fs::File::options().write(true).open(to).map_err(|error| StoreError::system(to, &error))?;
    file.sync_all().map_err(|error| StoreError::system(to, &error))
}

/// Makes a new name last, where the system has a way.
fn sync_folder(path: &Path) {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or_else(|| Path::new("."));
    let _not_everywhere = std::fs::File::open(folder).and_then(|folder| folder.sync_all());
}

fn with_ending(path: &Path, ending: &str) -> PathBuf {
    // SQLite takes no names but texts.
    let name = files::name_of(path).to_string_lossy();
    path.with_file_name(format!("{name}{ending}"))
}
