//! What lies in a folder, and since when each file is unchanged.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use super::note::is_note;
use crate::files::{FileError, system};
use crate::journal::natural::Natural;

/// How long a file and when it was changed last.
type Stamp = (u64, Option<SystemTime>);

/// A file as it was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Found {
    pub(super) path: PathBuf,
    /// Without the folder; a name that is not text has signs of replacement.
    pub(super) name: String,
    /// Since when it is unchanged.
    pub(super) quiet: Duration,
    stamp: Stamp,
}

#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    seen: BTreeMap<PathBuf, Seen>,
}

#[derive(Debug)]
struct Seen {
    stamp: Stamp,
    /// When it was seen with this stamp first.
    since: Duration,
    /// Whether nothing is left to take of it as it is.
    is_done: bool,
}

impl Folder {
    pub(super) fn new(path: &Path) -> Self {
        Self { path: path.to_owned(), seen: BTreeMap::new() }
    }

    /// The files that may have something to take, in the order in which they were written, and by name where that is the same.
    pub(super) fn look(&mut self, clock: Duration) -> Result<Vec<Found>, FileError> {
        let failed = |error: std::io::Error| system(&self.path, &error);
        let (mut there, mut found) = (BTreeSet::new(), Vec::new());
        for entry in std::fs::read_dir(&self.path).map_err(failed)? {
            let entry = entry.map_err(failed)?;
            let path = entry.path();
            let name = entry.file_name().to_string_lossy().into_owned();
            // A file that goes while the folder is read is gone.
            let Ok(about) = std::fs::metadata(&path) else { continue };
            if !about.is_file() || is_passing(&name) {
                continue;
            }
            let stamp = (about.len(), about.modified().ok());
            there.insert(path.clone());
            let seen = self.seen.entry(path.clone()).or_insert(Seen { stamp, since: clock, is_done: false });
            if seen.stamp != stamp {
                *seen = Seen { stamp, since: clock, is_done: false };
            }
            if !seen.is_done {
                found.push(Found { path, name, quiet: clock.saturating_sub(seen.since), stamp });
            }
        }
        self.seen.retain(|path, _| there.contains(path));
        found.sort_by_cached_key(|found| (found.stamp.1, Natural(found.name.clone())));
        Ok(found)
    }

    /// Nothing is left to take of a file as it was found.
    pub(super) fn done(&mut self, found: &Found) {
        if let Some(seen) = self.seen.get_mut(&found.path).filter(|seen| seen.stamp == found.stamp) {
            seen.is_done = true;
        }
    }
}

impl Found {
    /// Whether it is still as it was found.
    pub(super) fn is_unchanged(&self) -> bool {
        std::fs::metadata(&self.path).is_ok_and(|about| (about.len(), about.modified().ok()) == self.stamp)
    }
}

/// Whether a name is that of our own note, of a hidden file, of half a file, or of what programs write before they give a file its name.
fn is_passing(name: &str) -> bool {
    let lower = name.to_lowercase();
    // The description of an AQDEF file is read with its values, which stand in the .dfx beside it.
    let unfinished = [".tmp", ".part", ".partial", ".crdownload", ".filepart", "~", ".dfd"];
    is_note(name)
        || name.starts_with('.')
        || name.starts_with("~$")
        || unfinished.iter().any(|ending| lower.ends_with(ending))
}
