//! What lies in a folder, since when each file is unchanged, and whether its writer is done with it.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::{OsStr, OsString};
use std::fs::Metadata;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use fitcheck_exchange::journal::natural::Natural;
use fitcheck_files::{self as files, FileError, beside_path, folder_of, system};

use super::PATIENCE;
use super::closed::{Ear, Writer};
use super::note::is_note;

/// How long a file has to be unchanged before the last value of a format that shows nothing of its end counts as complete, where its writer
/// has closed it: some close a file after each line.
const SETTLED: Duration = Duration::from_secs(1);

/// How long a file has to be unchanged before all of it counts as complete, where the system does not say whether anybody writes it.
const LONG: Duration = Duration::from_secs(10);

/// What shows that a file was changed, or the file that is read together with it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Stamp {
    own: FileFingerprint,
    beside: FileFingerprint,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct FileFingerprint {
    length: u64,
    changed: Option<SystemTime>,
    /// Its device and its number there; zeros where it has none.
    number: (u64, u64),
    /// When anything about it was changed, in seconds and nanoseconds: a time of change can be set, this one not.
    touched: (i64, i64),
}

impl FileFingerprint {
    #[cfg(unix)]
    fn of(about: &Metadata) -> Self {
        use std::os::unix::fs::MetadataExt as _;
        let number = (about.dev(), about.ino());
        let touched = (about.ctime(), about.ctime_nsec());
        Self { length: about.len(), changed: about.modified().ok(), number, touched }
    }

    #[cfg(not(unix))]
    fn of(about: &Metadata) -> Self {
        Self { length: about.len(), changed: about.modified().ok(), ..Self::default() }
    }

    /// Whether the content may be another one: after a change of rights or names alone it is not.
    fn is_written(&self, before: &Self) -> bool {
        Self { touched: before.touched, ..*self } != *before
    }
}

/// What is to be done with a file; the machine is drawn in `mod.rs`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum FileState {
    /// There may be something to take.
    #[default]
    Open,
    /// Nothing of it could be taken at this stage; and whether it was told then, and unchanged for [`PATIENCE`]. It is read again when one
    /// of these has changed.
    Waits(Stage, [bool; 2]),
    /// Nothing is left to take of it as it is.
    Done,
}

/// What is known of a file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct KnownFile {
    stamp: Stamp,
    /// When it was seen with this stamp first.
    since: Duration,
    state: FileState,
    was_done: bool,
    writer: Writer,
}

/// A file as it was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct FoundFile {
    pub(super) path: PathBuf,
    /// Without the folder; bytes of it that are no text are written as such.
    pub(super) name: String,
    /// Since when it is unchanged.
    pub(super) quiet: Duration,
    /// Whether all of it was taken already, before it was changed.
    pub(super) was_done: bool,
    seen: KnownFile,
}

#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    seen: BTreeMap<PathBuf, KnownFile>,
    ear: Ear,
    /// Names of files that are left alone, and the files that are, by device and number.
    left_names: BTreeSet<OsString>,
    left_files: BTreeSet<(u64, u64)>,
}

impl Folder {
    pub(super) fn new(path: &Path) -> Self {
        let left_names = BTreeSet::new();
        let left_files = BTreeSet::new();
        Self { path: path.to_owned(), seen: BTreeMap::new(), ear: Ear::new(path), left_names, left_files }
    }

    /// Leaves a file alone, by its name where it is in the folder, and whatever it is called where the system numbers files.
    pub(super) fn leave(&mut self, path: &Path) {
        let whole = |folder: &Path| folder.canonicalize().ok();
        let is_inside = whole(folder_of(path)).is_some_and(|folder| whole(&self.path) == Some(folder));
        self.left_names.extend(path.file_name().filter(|_| is_inside).map(OsStr::to_owned));
        let about = std::fs::metadata(path).ok().filter(Metadata::is_file);
        self.left_files
            .extend(about.map(|about| FileFingerprint::of(&about).number).filter(|number| *number != (0, 0)));
    }

    fn is_left(&self, path: &Path, stamp: &Stamp) -> bool {
        let is_named = path.file_name().is_some_and(|name| self.left_names.contains(name));
        is_named || self.left_files.contains(&stamp.own.number)
    }

    /// The files that may have something to take, in the order in which they were written, and by name where that is the same. `renamed`
    /// hears which files got another name: the one before, and the new one.
    pub(super) fn look(
        &mut self,
        clock: Duration,
        renamed: &mut dyn FnMut(&str, &str),
    ) -> Result<Vec<FoundFile>, FileError> {
        let failed = |error: std::io::Error| system(&self.path, &error);
        let mut there = BTreeSet::new();
        let mut found = Vec::new();
        // What was closed before the folder is looked at was closed as it is seen now, or is written again.
        let written = self.ear.hear(&self.path, &mut |before, now| renamed(&name_of(before), &name_of(now)));
        for entry in std::fs::read_dir(&self.path).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            // A file that goes while the folder is read is gone.
            let Ok(about) = std::fs::metadata(&path) else { continue };
            there.insert(path.clone());
            let name = name_of(&path);
            let stamp = stamp(&path, &about);
            if !about.is_file() || is_passing(&name) || self.is_left(&path, &stamp) {
                continue;
            }
            let new = KnownFile { stamp, since: clock, ..KnownFile::default() };
            let seen = self.seen.entry(path.clone()).or_insert_with(|| new.clone());
            let is_heard = written.contains(&path);
            let is_done = seen.state == FileState::Done;
            // A file that is written within the same moment keeps its stamp.
            if seen.stamp != stamp || is_heard && is_done {
                let is_own = stamp.own.is_written(&seen.stamp.own);
                // Another machine has written it: nobody says whether it is done. Who writes the file beside it does not matter.
                if is_own && !is_heard {
                    self.ear.writers.remove(&path);
                }
                let is_written = is_heard || is_own || stamp.beside.is_written(&seen.stamp.beside);
                *seen = KnownFile { was_done: is_written && (is_done || seen.was_done), ..new };
            }
            let rests = SETTLED <= clock.saturating_sub(seen.since);
            let writer = self.ear.writer(&path, seen.writer, rests);
            // What was left of it while somebody wrote it is taken when it is closed.
            if seen.state == FileState::Done && seen.writer == Writer::Writes && writer != Writer::Writes {
                seen.state = FileState::Open;
            }
            seen.writer = writer;
            if seen.state != FileState::Done {
                let quiet = clock.saturating_sub(seen.since);
                let was_done = seen.was_done;
                let seen = seen.clone();
                found.push(FoundFile { path, name, quiet, was_done, seen });
            }
        }
        self.seen.retain(|path, _| there.contains(path));
        self.ear.writers.retain(|path, _| there.contains(path));
        found.sort_by_cached_key(|found| (found.changed(), Natural(found.name.clone())));
        Ok(found)
    }

    /// Sets the state of a file, unless it was changed since it was found.
    pub(super) fn set(&mut self, found: &FoundFile, state: FileState) {
        if let Some(seen) = self.seen.get_mut(&found.path).filter(|seen| seen.stamp == found.seen.stamp) {
            seen.state = state;
        }
    }
}

/// How much of a file counts as it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Stage {
    /// Whole lines that are followed by more, or whose format shows that they are complete.
    Begun,
    /// All its whole lines.
    Settled,
    /// All of it, a last line without its end, too.
    Final,
}

impl FoundFile {
    /// How much of it counts.
    pub(super) fn stage(&self) -> Stage {
        match self.seen.writer {
            // It came under its name as a whole.
            Writer::Moved => Stage::Final,
            Writer::Closed if PATIENCE <= self.quiet => Stage::Final,
            Writer::Closed if SETTLED <= self.quiet => Stage::Settled,
            Writer::Unknown if LONG <= self.quiet => Stage::Final,
            _ => Stage::Begun,
        }
    }

    /// Whether people are told what of it cannot be read.
    pub(super) fn is_told(&self) -> bool {
        self.stage() == Stage::Final || LONG <= self.quiet
    }

    /// The state of a file of which nothing could be taken.
    pub(super) fn waits(&self) -> FileState {
        FileState::Waits(self.stage(), [self.is_told(), PATIENCE <= self.quiet])
    }

    /// Whether nothing of it could be taken, and nothing has changed since.
    pub(super) fn is_waiting(&self) -> bool {
        self.seen.state == self.waits()
    }

    /// Whether it got its name when it was complete.
    pub(super) fn is_moved(&self) -> bool {
        self.seen.writer == Writer::Moved
    }

    /// When it was changed last.
    pub(super) fn changed(&self) -> Option<SystemTime> {
        self.seen.stamp.own.changed
    }

    /// Whether it is still as it was found.
    pub(super) fn is_unchanged(&self) -> bool {
        std::fs::metadata(&self.path).is_ok_and(|about| stamp(&self.path, &about) == self.seen.stamp)
    }
}

fn stamp(path: &Path, about: &Metadata) -> Stamp {
    // The values of an AQDEF file are read with their description, which may come later than they do.
    let is_dfx = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("dfx"));
    let beside = is_dfx.then(|| beside_path(path, "dfd").metadata()).and_then(Result::ok);
    Stamp {
        own: FileFingerprint::of(about),
        beside: beside.as_ref().map_or_else(FileFingerprint::default, FileFingerprint::of),
    }
}

/// A file's name as text; bytes that are none are written as such, so that no two names are the same.
fn name_of(path: &Path) -> String {
    let mut text = String::new();
    for chunk in files::name_of(path).as_encoded_bytes().utf8_chunks() {
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
