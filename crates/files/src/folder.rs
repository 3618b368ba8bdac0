//! Writes several files into one folder: all of them or none.

use std::fs::File;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use super::unfinished::Unfinished;
use super::{FileError, folder_of, system, whole};

/// Holds the files of a set while they are written.
const GROWING: &str = ".fitcheck-new";
/// Holds the files of a whole set that still have to be moved to their places. Where it is found, the folder holds files
/// of two sets.
const MOVING: &str = ".fitcheck-set";

/// Writes whole files into a folder and returns their paths. A missing folder is made; its parent must exist.
///
/// A new folder appears with all its files at once. In an existing one they are first written into a folder of their own
/// and then moved. If the program or the machine ends between the moves, the next call first moves the rest and returns
/// its paths too; [`no_half_set`] names the folder until then.
///
/// # Errors
/// [`FileError::Exists`] where a file already exists and `overwrite` is not set: then nothing is written.
pub fn write_folder(folder: &Path, files: &[(&str, &[u8])], overwrite: bool) -> Result<Vec<PathBuf>, FileError> {
    if folder.is_dir() {
        return write_into(folder, files, overwrite);
    }
    into_new(folder, files)?;
    Ok(files.iter().map(|(name, _)| folder.join(name)).collect())
}

/// Writes whole files into a folder that is there, like [`write_folder`]; an empty path is the current folder.
///
/// # Errors
/// As for [`write_folder`]; the system's where there is no such folder.
pub fn write_into(folder: &Path, files: &[(&str, &[u8])], overwrite: bool) -> Result<Vec<PathBuf>, FileError> {
    let mut paths: Vec<PathBuf> = files.iter().map(|(name, _)| folder.join(name)).collect();
    let mut rest = into_old(folder, &paths, files, overwrite)?;
    rest.retain(|path| !paths.contains(path));
    paths.append(&mut rest);
    Ok(paths)
}

/// Whether a folder is free of half written sets.
///
/// # Errors
/// [`FileError::HalfSet`] where writing a set was interrupted: some files are old and some are new.
pub fn no_half_set(folder: &Path) -> Result<(), FileError> {
    let moving = folder.join(MOVING);
    if moving.is_dir() { Err(FileError::HalfSet { path: moving }) } else { Ok(()) }
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

/// Whether files can be written into a folder, or, where it is not there yet, whether it can be made. Nothing stays behind.
///
/// # Errors
/// What the system says of the folder, or of the nearest one above it that is there.
pub fn takes_files(folder: &Path) -> Result<(), FileError> {
    let there = folder.ancestors().find(|above| above.symlink_metadata().is_ok()).unwrap_or(folder);
    let name = whole::unfinished_name(&there.join("fitcheck"));
    let made = File::options().write(true).create_new(true).open(&name);
    made.map(|_file| drop(Unfinished::at(name))).map_err(|error| system(there, &error))
}

fn into_new(folder: &Path, files: &[(&str, &[u8])]) -> Result<(), FileError> {
    parent_of_new(folder)?;
    let all = || -> io::Result<()> {
        let growing = fill(whole::unfinished_name(folder), files)?;
        std::fs::rename(growing.path(), folder)?;
        growing.finished();
        whole::sync_folder(folder);
        Ok(())
    };
    all().map_err(|error| system(folder, &error))
}

fn into_old(
    folder: &Path,
    paths: &[PathBuf],
    files: &[(&str, &[u8])],
    overwrite: bool,
) -> Result<Vec<PathBuf>, FileError> {
    let failed = |error: io::Error| system(folder, &error);
    let rest = move_rest(folder, Links::Replaced).map_err(failed)?;
    for path in paths {
        if path.is_dir() {
            return Err(FileError::IsFolder { path: path.clone() });
        }
    }
    let growing = fill(folder.join(GROWING), files).map_err(failed)?;
    let there = paths.iter().find(|path| path.symlink_metadata().is_ok());
    if let Some(path) = there.filter(|_| !overwrite) {
        return Err(FileError::Exists { path: path.clone() });
    }
    std::fs::rename(growing.path(), folder.join(MOVING)).map_err(failed)?;
    growing.finished();
    move_rest(folder, Links::Followed).map_err(failed)?;
    Ok(rest)
}

/// A folder with files in it, synced. What a broken run left under its name goes first.
fn fill(growing: PathBuf, files: &[(&str, &[u8])]) -> io::Result<Unfinished> {
    if growing.symlink_metadata().is_ok() {
        super::unfinished::remove(&growing);
    }
    std::fs::create_dir(&growing)?;
    let growing = Unfinished::at(growing);
    for (name, bytes) in files {
        let mut file = File::options().write(true).create_new(true).open(growing.path().join(name))?;
        file.write_all(bytes)?;
        file.sync_all()?;
    }
    Ok(growing)
}

/// What becomes of a link in the place of a file.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Links {
    /// It stays, and what it leads to is written.
    Followed,
    /// The file takes its place: a set that was found may have come with a folder from somebody else, who would
    /// otherwise choose what is written where.
    Replaced,
}

/// Moves the files of a whole set to their places, if there is one that waits, and returns where they are now.
fn move_rest(folder: &Path, links: Links) -> io::Result<Vec<PathBuf>> {
    let moving = folder.join(MOVING);
    match moving.symlink_metadata() {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        // A link would bring in the files of another folder.
        metadata => {
            if !metadata?.is_dir() {
                return Err(io::Error::new(io::ErrorKind::InvalidData, format!("{MOVING} is not a folder")));
            }
        }
    }
    let entries = std::fs::read_dir(&moving)?;
    let mut moved = Vec::new();
    for entry in entries {
        let entry = entry?;
        if !entry.file_type()?.is_file() {
            return Err(io::Error::new(io::ErrorKind::InvalidData, format!("{MOVING} holds more than files")));
        }
        let target = folder.join(entry.file_name());
        match target.symlink_metadata() {
            Ok(metadata) if metadata.is_file() => {
                whole::keep_owner(&metadata, &File::open(entry.path())?)?;
                std::fs::rename(entry.path(), &target)?;
            }
            Ok(_) if links == Links::Followed => {
                let bytes = std::fs::read(entry.path())?;
                whole::write(&target, &mut |out| out.write_all(&bytes))?;
                std::fs::remove_file(entry.path())?;
            }
            _ => std::fs::rename(entry.path(), &target)?,
        }
        moved.push(target);
    }
    whole::sync_folder(&moving);
    std::fs::remove_dir(&moving)?;
    Ok(moved)
}
