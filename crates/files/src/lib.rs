//! Reading and writing files: bounded, whole or not at all.
//!
//! Used at the edges (command line, window). Errors name what happened and, last, the path.

mod beside;
mod folder;
mod hearing;
mod listing;
mod places;
mod stopping;
mod straight;
mod unfinished;
mod whole;
mod zone;

use std::ffi::OsStr;
use std::io::{Read as _, Write};
use std::path::{Path, PathBuf};

use fitcheck_core::message::Say;

pub use beside::{beside, beside_path};
pub use folder::{make_folder, no_half_set, takes_files, write_folder, write_into};
pub use listing::{Entry, Listing, MOST_ENTRIES, list, list_up_to};
pub use places::{carried_folder, journal_folder, settings_folder};
pub use stopping::Stop;
pub use zone::{ZoneError, now, zone, zone_name, zone_or_unknown};

/// The largest file that is read whole, 64 MiB: a table, a mask or a log is a thousandth of that.
pub const LARGEST: u64 = 64 << 20;

/// Why a file could not be read or written.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "file", error)]
pub enum FileError {
    /// The path is a folder.
    IsFolder { path: PathBuf },
    /// There is nothing at the path.
    Missing { path: PathBuf },
    /// There is already something at the path.
    Exists { path: PathBuf },
    /// A pipe or a device, where only a file will do.
    NotAFile { path: PathBuf },
    /// A set of files was written only in part: some files of the folder above are old and some are new.
    HalfSet {
        /// The folder with the files that still have to be moved.
        path: PathBuf,
    },
    /// A file that is read several times is another one than at first.
    Changed { path: PathBuf },
    /// Another program has it open and lets nobody else in, as on Windows a spreadsheet does.
    Busy { path: PathBuf },
    /// It was written no further, as somebody wished.
    Stopped { path: PathBuf },
    /// The file is larger than [`LARGEST`].
    #[say(args(limit = LARGEST >> 20))]
    TooLarge { path: PathBuf },
    /// The system reports an error.
    System {
        /// What the system says.
        reason: String,
        path: PathBuf,
    },
}

/// The error of a path from what the system says.
pub fn system(path: &Path, error: &std::io::Error) -> FileError {
    let path = path.to_owned();
    match error.kind() {
        std::io::ErrorKind::NotFound => FileError::Missing { path },
        std::io::ErrorKind::AlreadyExists => FileError::Exists { path },
        std::io::ErrorKind::IsADirectory => FileError::IsFolder { path },
        std::io::ErrorKind::ResourceBusy => FileError::Busy { path },
        // ERROR_SHARING_VIOLATION and ERROR_LOCK_VIOLATION, which have no kind of their own.
        _ if cfg!(windows) && matches!(error.raw_os_error(), Some(32 | 33)) => FileError::Busy { path },
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
    read_opened(std::fs::File::open(path).map_err(|error| system(path, &error))?, path)
}

/// The bytes of a file that is open, at most [`LARGEST`].
pub fn read_opened(file: std::fs::File, path: &Path) -> Result<Vec<u8>, FileError> {
    let mut bytes = Vec::new();
    // A pipe or a growing file has no length beforehand: read one byte more than allowed to find out.
    file.take(LARGEST + 1).read_to_end(&mut bytes).map_err(|error| system(path, &error))?;
    if LARGEST < bytes.len().try_into().unwrap_or(u64::MAX) {
        return Err(FileError::TooLarge { path: path.to_owned() });
    }
    Ok(bytes)
}

/// A file to be read piece by piece, and how many bytes it has; `None` for a pipe or a device.
pub fn open(path: &Path) -> Result<(std::fs::File, Option<u64>), FileError> {
    let metadata = std::fs::metadata(path).map_err(|error| system(path, &error))?;
    if metadata.is_dir() {
        return Err(FileError::IsFolder { path: path.to_owned() });
    }
    let file = std::fs::File::open(path).map_err(|error| system(path, &error))?;
    Ok((file, metadata.is_file().then_some(metadata.len())))
}

/// The first bytes of a file, at most this many.
pub fn read_head(path: &Path, most: usize) -> Result<Vec<u8>, FileError> {
    let file = std::fs::File::open(path).map_err(|error| system(path, &error))?;
    let mut bytes = Vec::new();
    file.take(most.try_into().unwrap_or(LARGEST)).read_to_end(&mut bytes).map_err(|error| system(path, &error))?;
    Ok(bytes)
}

/// The bytes of a file, as [`read`] gives them; a pipe or a device is refused instead of waited for.
pub fn read_file(path: &Path) -> Result<Vec<u8>, FileError> {
    if is_special(path) {
        return Err(FileError::NotAFile { path: path.to_owned() });
    }
    read(path)
}

/// Whether a path leads to a pipe or a device.
fn is_special(path: &Path) -> bool {
    path.metadata().is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

/// Writes a file whole or not at all. An existing one keeps its mode and, where the system allows it, its owner and group;
/// a link stays, and what it leads to is written. A pipe or a device is written to.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    write_with(path, &mut |out| out.write_all(bytes))
}

/// Writes a file like [`write()`], with what is written piece by piece.
pub fn write_with(
    path: &Path,
    fill: &mut dyn FnMut(&mut (dyn Write + Send)) -> std::io::Result<()>,
) -> Result<(), FileError> {
    whole::write(path, fill).map_err(|error| system(path, &error))
}

/// Writes a file whole or not at all, and never over another one.
///
/// # Errors
/// [`FileError::Exists`] where the path already exists.
pub fn write_new(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    whole::write_new(path, &mut |out| out.write_all(bytes)).map_err(|error| system(path, &error))
}

/// Writes a file that a user has named; another one of its name is only replaced by leave (`replace`).
///
/// # Errors
/// [`FileError::IsFolder`] where the path is a folder, [`FileError::NotAFile`] where it is a pipe or a device,
/// [`FileError::Exists`] where there is a file to be asked about.
pub fn save(path: &Path, bytes: &[u8], replace: bool) -> Result<(), FileError> {
    save_with(path, replace, &mut |out| out.write_all(bytes))
}

/// Writes a file like [`save`], with what is written piece by piece.
///
/// # Errors
/// As for [`save`].
pub fn save_with(
    path: &Path,
    replace: bool,
    fill: &mut dyn FnMut(&mut (dyn Write + Send)) -> std::io::Result<()>,
) -> Result<(), FileError> {
    if path.is_dir() {
        return Err(FileError::IsFolder { path: path.to_owned() });
    }
    if is_special(path) {
        return Err(FileError::NotAFile { path: path.to_owned() });
    }
    if replace {
        return write_with(path, fill);
    }
    whole::write_new(path, fill).map_err(|error| system(path, &error))
}

/// The folder of a path; for a bare name, the current folder.
pub fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or_else(|| Path::new("."))
}

/// The name of a file without its folder; empty where a path has none, such as one that ends in `..`.
pub fn name_of(path: &Path) -> &OsStr {
    path.file_name().unwrap_or_else(|| OsStr::new(""))
}

/// A file beside another one, whose name goes on like this.
pub fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut name = name_of(path).to_owned();
    name.push(ending);
    path.with_file_name(name)
}

/// Sets a broken file aside under another name and returns that name. A link stays, and what it leads to gets the name.
pub fn set_aside(path: &Path) -> Result<PathBuf, FileError> {
    let behind = path.is_symlink().then(|| path.canonicalize().ok()).flatten();
    let path = behind.as_deref().unwrap_or(path);
    let name = name_of(path).to_string_lossy().into_owned();
    for number in 1..1000 {
        let aside = path.with_file_name(format!("{name}.broken-{number}"));
        if !aside.exists() {
            std::fs::rename(path, &aside).map_err(|error| system(path, &error))?;
            return Ok(aside);
        }
    }
    Err(FileError::System { reason: "too many broken files were set aside".to_owned(), path: path.to_owned() })
}
