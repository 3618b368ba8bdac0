//! What lies in a folder, since when each file is unchanged, and whether its writer is done with it.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::{OsStr, OsString};
use std::fs::Metadata;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use fitcheck_exchange::journal::natural::Natural;
use fitcheck_files::{FileError, beside_path, system};

use super::PATIENCE;
use super::alone::parent;
use super::closed::{Closed, Writer};
use super::note::is_note;

/// How long a file has to be unchanged before the last value of a format that shows nothing of its end counts as complete, where its writer
/// has closed it: some close a file after each line.
const SETTLED: Duration = Duration::from_secs(1);

/// The same for all that may be unfinished, where the system does not say whether anybody writes a file.
const LONG: Duration = Duration::from_secs(10);

/// What tells one state of a file from another, and of the file that is read with it.
type Stamp = [Sight; 2];

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Sight {
    length: u64,
    changed: Option<SystemTime>,
    /// Its number in the file system; 0 where it has none.
    number: u64,
    /// When anything about it was changed, in seconds and nanoseconds: a time of change can be set, this one not.
    touched: (i64, i64),
}

impl Sight {
    #[cfg(unix)]
    fn of(about: &Metadata) -> Self {
        use std::os::unix::fs::MetadataExt as _;
        let (number, touched) = (about.ino(), (about.ctime(), about.ctime_nsec()));
        Self { length: about.len(), changed: about.modified().ok(), number, touched }
    }

    #[cfg(not(unix))]
    fn of(about: &Metadata) -> Self {
        Self { length: about.len(), changed: about.modified().ok(), ..Self::default() }
    }

    /// Whether it is another one but for rights and names.
    fn is_written(&self, before: &Self) -> bool {
        Self { touched: before.touched, ..*self } != *before
    }
}

/// A file as it was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Found {
    pub(super) path: PathBuf,
    /// Without the folder; bytes of it that are no text are written as such.
    pub(super) name: String,
    /// Since when it is unchanged.
    pub(super) quiet: Duration,
    writer: Writer,
    /// Whether all of it was taken already, before it was changed.
    pub(super) was_done: bool,
    /// Whether nothing of it could be taken when it was looked into last, and nothing has changed.
    pub(super) waits: bool,
    stamp: Stamp,
}

#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    seen: BTreeMap<PathBuf, Seen>,
    closed: Closed,
    /// Names of files that are left alone, and the files that are, by device and number.
    left_names: BTreeSet<OsString>,
    left_files: BTreeSet<(u64, u64)>,
}

#[derive(Debug, Clone)]
struct Seen {
    stamp: Stamp,
    /// When it was seen with this stamp first.
    since: Duration,
    /// Whether nothing is left to take of it as it is, and whether that was so before.
    is_done: bool,
    was_done: bool,
    writer: Writer,
    /// How far it has come on the way to being final when nothing of it could be taken.
    waits: Option<[bool; 4]>,
}

impl Folder {
    pub(super) fn new(path: &Path) -> Self {
        let (left_names, left_files) = (BTreeSet::new(), BTreeSet::new());
        Self { path: path.to_owned(), seen: BTreeMap::new(), closed: Closed::new(path), left_names, left_files }
    }

    /// Leaves a file alone, by its name where it is in the folder, and whatever it is called where the system numbers files.
    pub(super) fn leave(&mut self, path: &Path) {
        let whole = |folder: &Path| folder.canonicalize().ok();
        let is_inside = whole(parent(path)).is_some_and(|folder| whole(&self.path) == Some(folder));
        self.left_names.extend(path.file_name().filter(|_| is_inside).map(OsStr::to_owned));
        let about = std::fs::metadata(path).ok().filter(Metadata::is_file);
        self.left_files.extend(about.as_ref().and_then(number_of));
    }

    fn is_left(&self, name: &OsStr, about: &Metadata) -> bool {
        self.left_names.contains(name)
            || !self.left_files.is_empty() && number_of(about).is_some_and(|number| self.left_files.contains(&number))
    }

    /// The files that got another name since this was asked: the one before, and the new one.
    pub(super) fn moves(&mut self) -> Vec<(String, String)> {
        let name = |path: &Path| path.file_name().map(text_of).unwrap_or_default();
        self.closed.moves().into_iter().map(|(before, now)| (name(&before), name(&now))).collect()
    }

    /// Nothing can be taken of a file until it is changed, or unchanged for longer.
    pub(super) fn wait(&mut self, found: &Found) {
        if let Some(seen) = self.seen.get_mut(&found.path).filter(|seen| seen.stamp == found.stamp) {
            seen.waits = Some(found.reached());
        }
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
            let name = text_of(&entry.file_name());
            // A file that goes while the folder is read is gone.
            let Ok(about) = std::fs::metadata(&path) else { continue };
            there.insert(path.clone());
            if !about.is_file() || is_passing(&name) || self.is_left(&entry.file_name(), &about) {
                continue;
            }
            let stamp = stamp(&path, &about);
            let new =
                Seen { stamp, since: clock, is_done: false, was_done: false, writer: Writer::Unknown, waits: None };
            let seen = self.seen.entry(path.clone()).or_insert_with(|| new.clone());
            let is_heard = self.closed.is_heard(&path);
            if seen.stamp != stamp {
                let is_written = is_heard || stamp.iter().zip(&seen.stamp).any(|(now, before)| now.is_written(before));
                let was_done = is_written && (seen.is_done || seen.was_done);
                // Another machine has written it: nobody says whether it is done. That of the file beside it is known or not as before.
                let ([own, _], [before, _]) = (&stamp, &seen.stamp);
                if own.is_written(before) && !is_heard {
                    self.closed.forget(&path);
                }
                *seen = Seen { was_done, ..new };
            } else if is_heard && seen.is_done {
                // It was written within the same moment.
                *seen = Seen { was_done: true, ..new };
            }
            let writer = self.closed.writer(&path);
            // What was left of it while somebody wrote it is taken when it is closed.
            seen.is_done &= writer == seen.writer || seen.writer != Writer::Writes;
            seen.writer = writer;
            if !seen.is_done {
                let was_done = seen.was_done;
                let quiet = clock.saturating_sub(seen.since);
                let mut file = Found { path, name, quiet, writer, was_done, stamp, waits: false };
                file.waits = seen.waits == Some(file.reached());
                found.push(file);
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
    /// Whether all of it counts as it is, a last line without its end, too: it came under its name as a whole, or was closed and is unchanged
    /// for a while.
    pub(super) fn is_final(&self) -> bool {
        match self.writer {
            Writer::Writes => false,
            Writer::Moved => true,
            Writer::Closed => PATIENCE <= self.quiet,
            Writer::Unknown => LONG <= self.quiet,
        }
    }

    /// Whether its whole lines count as they are, also where they show nothing of their end.
    pub(super) fn is_settled(&self) -> bool {
        self.is_final() || self.writer == Writer::Closed && SETTLED <= self.quiet
    }

    /// Whether it is said what of it cannot be read.
    pub(super) fn is_told(&self) -> bool {
        self.is_final() || LONG <= self.quiet
    }

    /// What it has reached of all that may change what is taken of it.
    fn reached(&self) -> [bool; 4] {
        [self.is_settled(), self.is_final(), self.is_told(), PATIENCE <= self.quiet]
    }

    /// Whether it got its name when it was complete.
    pub(super) fn is_moved(&self) -> bool {
        self.writer == Writer::Moved
    }

    /// Whether it was changed after a time.
    pub(super) fn is_changed_since(&self, time: SystemTime) -> bool {
        changed(self).is_some_and(|changed| time < changed)
    }

    /// Whether it is still as it was found.
    pub(super) fn is_unchanged(&self) -> bool {
        std::fs::metadata(&self.path).is_ok_and(|about| stamp(&self.path, &about) == self.stamp)
    }
}

fn stamp(path: &Path, about: &Metadata) -> Stamp {
    // The values of an AQDEF file are read with their description, which may come later than they do.
    let is_dfx = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("dfx"));
    let beside = is_dfx.then(|| beside_path(path, "dfd").metadata()).and_then(Result::ok);
    [Sight::of(about), beside.as_ref().map(Sight::of).unwrap_or_default()]
}

/// A name as text; bytes that are none are written as such, so that no two names are the same.
fn text_of(name: &OsStr) -> String {
    let mut text = String::new();
    for chunk in name.as_encoded_bytes().utf8_chunks() {
        text.push_str(chunk.valid());
        text.extend(chunk.invalid().iter().map(|byte| format!("\\x{byte:02X}")));
    }
    text
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

/// The device of a file and its number there.
#[cfg(unix)]
#[expect(clippy::unnecessary_wraps, reason = "not known on other systems")]
fn number_of(about: &Metadata) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt as _;
    Some((about.dev(), about.ino()))
}

/// Not known here.
#[cfg(not(unix))]
fn number_of(_about: &Metadata) -> Option<(u64, u64)> {
    None
}

/// When it was changed last.
fn changed(found: &Found) -> Option<SystemTime> {
    let [Sight { changed, .. }, _] = found.stamp;
    changed
}
