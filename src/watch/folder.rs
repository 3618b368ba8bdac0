//! What lies in a folder, since when each file is unchanged, and whether its writer is done with it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::Metadata;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use super::closed::Closed;
use super::note::is_note;
use crate::files::{FileError, beside_path, system};
use crate::journal::natural::Natural;

/// How long a file and when it was changed last, and the same of the file that is read with it.
type Stamp = [(u64, Option<SystemTime>); 2];

/// A file as it was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Found {
    pub(super) path: PathBuf,
    /// Without the folder; a name that is not text has signs of replacement.
    pub(super) name: String,
    /// Since when it is unchanged.
    pub(super) quiet: Duration,
    /// Whether nobody writes it any more. `false` where that is not known.
    pub(super) is_closed: bool,
    /// Whether all of it was taken already, before it was changed.
    pub(super) was_done: bool,
    stamp: Stamp,
}

#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    seen: BTreeMap<PathBuf, Seen>,
    closed: Closed,
}

#[derive(Debug, Clone)]
struct Seen {
    stamp: Stamp,
    /// When it was seen with this stamp first.
    since: Duration,
    /// Whether nothing is left to take of it as it is, and whether that was so before.
    is_done: bool,
    was_done: bool,
}

impl Folder {
    pub(super) fn new(path: &Path) -> Self {
        Self { path: path.to_owned(), seen: BTreeMap::new(), closed: Closed::new(path) }
    }

    /// The files that may have something to take, in the order in which they were written, and by name where that is the same.
    pub(super) fn look(&mut self, clock: Duration) -> Result<Vec<Found>, FileError> {
        let failed = |error: std::io::Error| system(&self.path, &error);
        let (mut there, mut found) = (BTreeSet::new(), Vec::new());
        // What was closed before the folder is looked at was closed as it is seen now, or is written again.
        self.closed.hear();
        for entry in std::fs::read_dir(&self.path).map_err(failed)? {
            let entry = entry.map_err(failed)?;
            let path = entry.path();
            let name = entry.file_name().to_string_lossy().into_owned();
            // A file that goes while the folder is read is gone.
            let Ok(about) = std::fs::metadata(&path) else { continue };
            if !about.is_file() || is_passing(&name) {
                continue;
            }
            let stamp = stamp(&path, &about);
            there.insert(path.clone());
            let new = Seen { stamp, since: clock, is_done: false, was_done: false };
            let seen = self.seen.entry(path.clone()).or_insert_with(|| new.clone());
            if seen.stamp != stamp {
                *seen = Seen { was_done: seen.is_done || seen.was_done, ..new };
            }
            if !seen.is_done {
                let (is_closed, was_done) = (self.closed.is_closed(&path), seen.was_done);
                found.push(Found { path, name, quiet: clock.saturating_sub(seen.since), is_closed, was_done, stamp });
            }
        }
        self.seen.retain(|path, _| there.contains(path));
        self.closed.forget_all_but(&there);
        found.sort_by_cached_key(|found| (changed(found), Natural(found.name.clone())));
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
        std::fs::metadata(&self.path).is_ok_and(|about| stamp(&self.path, &about) == self.stamp)
    }
}

fn stamp(path: &Path, about: &Metadata) -> Stamp {
    let of = |about: &Metadata| (about.len(), about.modified().ok());
    // The values of an AQDEF file are read with their description, which may come later than they do.
    let is_dfx = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("dfx"));
    let beside = is_dfx.then(|| beside_path(path, "dfd").metadata()).and_then(Result::ok);
    [of(about), beside.as_ref().map(of).unwrap_or_default()]
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

/// When it was changed last.
fn changed(found: &Found) -> Option<SystemTime> {
    let [(_, changed), _] = found.stamp;
    changed
}
