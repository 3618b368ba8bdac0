//! What lies in a folder, for a list to choose from.

use std::path::{Path, PathBuf};

use jiff::civil::DateTime;

use super::zone::zone_or_unknown;
use super::{FileError, system};

/// The most entries of a folder that are read: more do not help anyone to choose.
pub const MOST_ENTRIES: usize = 5000;

/// A file or folder in a folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    pub path: PathBuf,
    /// Its name as it can be shown; a name that is not text has signs of replacement.
    pub name: String,
    /// Whether it is a folder, or a link to one.
    pub is_folder: bool,
    /// How many bytes a file has.
    pub bytes: u64,
    /// When it was changed last, in local time; `None` where the system does not say.
    pub changed: Option<DateTime>,
}

impl Entry {
    /// Whether the system hides it.
    pub fn is_hidden(&self) -> bool {
        self.name.starts_with('.')
    }

    /// Whether its name has one of these endings, in capitals or not.
    pub fn ends_with(&self, endings: &[&str]) -> bool {
        let ending = self.path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        ending.is_some_and(|ending| endings.contains(&ending.as_str()))
    }
}

/// A folder with what lies in it: folders first, each by name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Listing {
    /// The folder, absolute.
    pub folder: PathBuf,
    /// As many entries as were asked for at most.
    pub entries: Vec<Entry>,
    /// Whether there are more entries.
    pub has_more: bool,
}

/// Reads a folder, up to [`MOST_ENTRIES`] entries.
///
/// # Errors
/// The path and the reason, where the folder cannot be read.
pub fn list(folder: &Path) -> Result<Listing, FileError> {
    list_up_to(folder, MOST_ENTRIES)
}

/// Reads a folder, up to `most` entries.
///
/// # Errors
/// The path and the reason, where the folder cannot be read.
pub fn list_up_to(folder: &Path, most: usize) -> Result<Listing, FileError> {
    let mut listing = Listing { folder: absolute(folder)?, entries: Vec::new(), has_more: false };
    let entries = std::fs::read_dir(&listing.folder).map_err(|error| system(folder, &error))?;
    let zone = zone_or_unknown();
    for entry in entries {
        if listing.entries.len() == most {
            listing.has_more = true;
            break;
        }
        // An entry that vanished meanwhile is not there; one that may not be looked at still has a name.
        let Ok(entry) = entry else { continue };
        let path = entry.path();
        let metadata = std::fs::metadata(&path).ok();
        let changed = metadata.as_ref().and_then(|metadata| metadata.modified().ok());
        let changed = changed.and_then(|changed| jiff::Timestamp::try_from(changed).ok());
        listing.entries.push(Entry {
            name: entry.file_name().to_string_lossy().into_owned(),
            is_folder: metadata.as_ref().is_some_and(std::fs::Metadata::is_dir),
            bytes: metadata.as_ref().map_or(0, std::fs::Metadata::len),
            changed: changed.map(|changed| changed.to_zoned(zone.clone()).datetime()),
            path,
        });
    }
    listing.entries.sort_by_cached_key(|entry| (!entry.is_folder, entry.name.to_lowercase(), entry.path.clone()));
    Ok(listing)
}

/// The path from the root on; `..` is resolved, since the folder above is the path without its last name.
fn absolute(folder: &Path) -> Result<PathBuf, FileError> {
    let path = std::path::absolute(folder).map_err(|error| system(folder, &error))?;
    let goes_up = path.components().any(|part| part == std::path::Component::ParentDir);
    if goes_up { dunce::canonicalize(&path).map_err(|error| system(folder, &error)) } else { Ok(path) }
}
