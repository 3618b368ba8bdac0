//! Reading and writing files: bounded, whole or not at all.
//!
//! Used at the edges (command line, window). Errors name what happened and, last, the path.

mod folder;
mod folders;
mod listing;
mod names;
mod tables;

use std::io::Read as _;
use std::path::{Path, PathBuf};

use folder::{beside, persist};
pub use folder::{make_folder, save, write_folder, write_new};
pub use folders::Folders;
pub use listing::{Entry, Listing, MOST_ENTRIES, list, list_up_to};
pub use tables::{OwnTables, OwnTablesError, read_tables};

use crate::message::Say;

/// The largest file that is read whole, 64 MiB: a table, a mask or a log is a thousandth of that.
pub const LARGEST: u64 = 64 << 20;

/// Why a file could not be read or written.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "file", error)]
pub enum FileError {
    /// The path is a folder.
    IsFolder {
        /// The path.
        path: PathBuf,
    },
    /// There is nothing at the path.
    Missing {
        /// The path.
        path: PathBuf,
    },
    /// There is already something at the path.
    Exists {
        /// The path.
        path: PathBuf,
    },
    /// The file is larger than [`LARGEST`].
    #[say(args(limit = LARGEST >> 20))]
    TooLarge {
        /// The path.
        path: PathBuf,
    },
    /// The system reports an error.
    System {
        /// What the system says.
        reason: String,
        /// The path.
        path: PathBuf,
    },
}

/// The error of a path from what the system says.
pub(crate) fn system(path: &Path, error: &std::io::Error) -> FileError {
    let path = path.to_owned();
    match error.kind() {
        std::io::ErrorKind::NotFound => FileError::Missing { path },
        std::io::ErrorKind::IsADirectory => FileError::IsFolder { path },
        _ => FileError::System { reason: error.to_string(), path },
    }
}

/// The bytes of a file of at most [`LARGEST`]: a larger one is refused before it fills the memory.
pub fn read(path: &Path) -> Result<Vec<u8>, FileError> {
    let metadata = std::fs::metadata(path).map_err(|error| system(path, &error))?;
    if metadata.is_dir() {
        return Err(FileError::IsFolder { path: path.to_owned() });
    }
    if LARGEST < metadata.len() {
        return Err(FileError::TooLarge { path: path.to_owned() });
    }
    let file = std::fs::File::open(path).map_err(|error| system(path, &error))?;
    let mut bytes = Vec::new();
    // A pipe or a growing file has no length beforehand: read one byte more than allowed to find out.
    file.take(LARGEST + 1).read_to_end(&mut bytes).map_err(|error| system(path, &error))?;
    if LARGEST < bytes.len().try_into().unwrap_or(u64::MAX) {
        return Err(FileError::TooLarge { path: path.to_owned() });
    }
    Ok(bytes)
}

/// The first bytes of a file, at most this many.
pub fn read_head(path: &Path, most: usize) -> Result<Vec<u8>, FileError> {
    let file = std::fs::File::open(path).map_err(|error| system(path, &error))?;
    let mut bytes = Vec::new();
    file.take(most.try_into().unwrap_or(LARGEST)).read_to_end(&mut bytes).map_err(|error| system(path, &error))?;
    Ok(bytes)
}

/// Writes a file whole or not at all: to a temporary file beside it, synced, then renamed over it.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    if path.is_dir() {
        return Err(FileError::IsFolder { path: path.to_owned() });
    }
    let beside = beside(folder_of(path), bytes).map_err(|error| system(path, &error))?;
    persist(beside, path, true)
}

/// The same for a file that is written piece by piece, so that it need not be in memory.
pub fn write_with(
    path: &Path,
    fill: impl FnOnce(&mut dyn std::io::Write) -> std::io::Result<()>,
) -> Result<(), FileError> {
    save_with(path, true, fill)
}

/// Writes a file piece by piece, whole or not at all; another one of its name is only replaced by leave (`replace`).
pub fn save_with(
    path: &Path,
    replace: bool,
    fill: impl FnOnce(&mut dyn std::io::Write) -> std::io::Result<()>,
) -> Result<(), FileError> {
    if path.is_dir() {
        return Err(FileError::IsFolder { path: path.to_owned() });
    }
    if !replace && path.symlink_metadata().is_ok() {
        return Err(FileError::Exists { path: path.to_owned() });
    }
    let filled = || -> std::io::Result<tempfile::NamedTempFile> {
        let mut beside = beside(folder_of(path), &[])?;
        let mut out = std::io::BufWriter::new(beside.as_file_mut());
        fill(&mut out)?;
        std::io::Write::flush(&mut out)?;
        drop(out);
        beside.as_file().sync_all()?;
        Ok(beside)
    };
    persist(filled().map_err(|error| system(path, &error))?, path, replace)
}

/// The folder of a path.
fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or_else(|| Path::new("."))
}

/// Sets a broken file aside under another name and returns that name.
pub fn set_aside(path: &Path) -> Result<PathBuf, FileError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    for number in 1..1000 {
        let aside = path.with_file_name(format!("{name}.broken-{number}"));
        if !aside.exists() {
            std::fs::rename(path, &aside).map_err(|error| system(path, &error))?;
            return Ok(aside);
        }
    }
    Err(FileError::System { reason: "too many broken files were set aside".to_owned(), path: path.to_owned() })
}
