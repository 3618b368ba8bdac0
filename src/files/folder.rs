//! Writes several files into one folder: all of them or none.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::{FileError, folder_of, system, write};

/// Writes whole files into a folder and returns their paths. A missing folder is made; its parent must exist.
///
/// Everything is first written beside its place. A new folder then appears with all its files at once. In an existing
/// one the files are renamed one after the other; after a failure, those already renamed are removed again, except for
/// files that were overwritten.
///
/// # Errors
/// [`FileError::Exists`] where a file already exists and `overwrite` is not set: then nothing is written.
pub fn write_folder(folder: &Path, files: &[(&str, &[u8])], overwrite: bool) -> Result<Vec<PathBuf>, FileError> {
    let paths: Vec<PathBuf> = files.iter().map(|(name, _)| folder.join(name)).collect();
    if folder.is_dir() {
        into_old(folder, &paths, files, overwrite)?;
    } else {
        into_new(folder, files)?;
    }
    Ok(paths)
}

/// Writes a file whole or not at all, and never over another one.
///
/// # Errors
/// [`FileError::Exists`] where the path already exists.
pub fn write_new(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    // A link that leads nowhere is something, too.
    if path.symlink_metadata().is_ok() {
        return Err(FileError::Exists { path: path.to_owned() });
    }
    let beside = beside(folder_of(path), bytes).map_err(|error| system(path, &error))?;
    persist(beside, path, false)
}

/// Writes a file whole or not at all; another one of its name is only replaced by leave (`replace`).
///
/// # Errors
/// [`FileError::IsFolder`] where the path is a folder, [`FileError::Exists`] where there is a file to be asked about.
pub fn save(path: &Path, bytes: &[u8], replace: bool) -> Result<(), FileError> {
    if path.is_dir() {
        return Err(FileError::IsFolder { path: path.to_owned() });
    }
    if replace { write(path, bytes) } else { write_new(path, bytes) }
}

/// Makes a folder where there is none; its parent must exist.
///
/// # Errors
/// [`FileError::Missing`] names the parent, [`FileError::Exists`] a file of that name.
pub fn make_folder(folder: &Path) -> Result<(), FileError> {
    if folder.is_dir() {
        return Ok(());
    }
    let parent = parent_of_new(folder)?;
    std::fs::create_dir(folder).map_err(|error| system(parent, &error))
}

/// The folder that a new one is made in; the error names it where it is missing.
fn parent_of_new(folder: &Path) -> Result<&Path, FileError> {
    if folder.symlink_metadata().is_ok() {
        return Err(FileError::Exists { path: folder.to_owned() });
    }
    let parent = folder_of(folder);
    if parent.is_dir() { Ok(parent) } else { Err(FileError::Missing { path: parent.to_owned() }) }
}

fn into_new(folder: &Path, files: &[(&str, &[u8])]) -> Result<(), FileError> {
    let parent = parent_of_new(folder)?;
    let whole = || -> std::io::Result<()> {
        let made = tempfile::Builder::new().prefix(".fitcheck-").tempdir_in(parent)?;
        for (name, bytes) in files {
            let beside = beside(made.path(), bytes)?;
            beside.persist_noclobber(made.path().join(name)).map_err(|error| error.error)?;
        }
        make_readable(made.path(), 0o755)?;
        std::fs::rename(made.path(), folder)?;
        // It now has another name, so there is nothing left to remove.
        let _renamed = made.keep();
        Ok(())
    };
    whole().map_err(|error| system(folder, &error))
}

fn into_old(folder: &Path, paths: &[PathBuf], files: &[(&str, &[u8])], overwrite: bool) -> Result<(), FileError> {
    for path in paths {
        if path.is_dir() {
            return Err(FileError::IsFolder { path: path.clone() });
        }
        if !overwrite && path.exists() {
            return Err(FileError::Exists { path: path.clone() });
        }
    }
    let beside = files.iter().map(|(_, bytes)| beside(folder, bytes)).collect::<std::io::Result<Vec<_>>>();
    let beside = beside.map_err(|error| system(folder, &error))?;
    let mut done: Vec<&PathBuf> = Vec::new();
    for (file, path) in beside.into_iter().zip(paths) {
        if let Err(error) = persist(file, path, overwrite) {
            if !overwrite {
                // A file that cannot be removed either is at least whole; the first error says what went wrong.
                for path in done {
                    drop(std::fs::remove_file(path));
                }
            }
            return Err(error);
        }
        done.push(path);
    }
    Ok(())
}

/// A temporary file with a name of its own in a folder, synced.
pub(super) fn beside(folder: &Path, bytes: &[u8]) -> std::io::Result<NamedTempFile> {
    let mut beside = tempfile::Builder::new().prefix(".fitcheck-").tempfile_in(folder)?;
    beside.write_all(bytes)?;
    beside.as_file().sync_all()?;
    make_readable(beside.path(), 0o644)?;
    Ok(beside)
}

/// Moves a finished file to its place.
pub(super) fn persist(beside: NamedTempFile, path: &Path, overwrite: bool) -> Result<(), FileError> {
    let done = if overwrite { beside.persist(path) } else { beside.persist_noclobber(path) };
    match done {
        Ok(_file) => Ok(()),
        Err(error) if error.error.kind() == std::io::ErrorKind::AlreadyExists => {
            Err(FileError::Exists { path: path.to_owned() })
        }
        // Some network folders know no move that refuses to replace. Nothing was there a moment ago.
        Err(error) if !overwrite && path.symlink_metadata().is_err() => match error.file.persist(path) {
            Ok(_file) => Ok(()),
            Err(error) => Err(system(path, &error.error)),
        },
        Err(error) => Err(system(path, &error.error)),
    }
}

/// Temporary files and folders are private; other people also read what a user saves.
fn make_readable(path: &Path, mode: u32) -> std::io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        std::fs::set_permissions(path, std::fs::Permissions::from_mode(mode))
    }
    #[cfg(not(unix))]
    {
        let (_, _) = (path, mode);
        Ok(())
    }
}
