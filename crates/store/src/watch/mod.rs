//! A folder that controls and gauges drop files into: each file is taken once, completely written or not at all.
//!
//! | file | what |
//! |---|---|
//! | here | one look at the folder: which files are ready, and what they hold |
//! | `folder`, `closed` | what lies in the folder, since when it is unchanged, and whether anybody still writes it |
//! | `reading`, `units` | what of a file is taken now: what is complete and new; the lines of each thing in it |
//! | `known`, `lines` | what was taken already, by content; how much of a file that has grown |
//! | `note` | what is written beside a file that could not be taken whole |
//! | `alone` | that one program watches a folder for a journal |
//!
//! The folder is looked at again and again: shares of a network send no notifications. Nothing is moved or deleted in it. What was taken is
//! remembered by the SHA-256 of its bytes, which the journal keeps with every entry, so that a restart needs no other memory and a renamed
//! file is not taken twice.
//!
//! Each file is in one of three states (`folder::FileState`):
//!
//! ```text
//!                    nothing of it is complete
//!          ┌──────┐ ──────────────────────────▶ ┌───────┐
//!  new ──▶ │ Open │                             │ Waits │
//!          └──────┘ ◀────────────────────────── └───────┘
//!           │    ▲   unchanged for longer, closed, written
//!           │    │
//!           │    └─ written again, or closed by the writer that had it open
//!           ▼
//!          ┌──────┐
//!          │ Done │  all of it was taken before, is recorded now, or cannot be used
//!          └──────┘
//! ```
//!
//! A file that is open and unchanged for `QUIET` is read. What of it is taken depends on how it stands to what was taken from files of its
//! name (`known::FileStanding`), by the hash of all that comes before each line end:
//!
//! | it | then |
//! |---|---|
//! | is `New`, or `Another` than what was taken before this program began | all of it is taken |
//! | is `TakenFiles` | nothing is taken; it is done |
//! | has `Grown`, or has an `Older` beginning | the lines behind that are taken |
//! | was `Replaced` | all of it is taken; it is said how many of its first lines were there before |
//! | was `Cut`: only the first of its lines are left | its writer may not be done; after [`PATIENCE`] nothing is taken, and it is done |
//! | was `CutWithinLine` | its writer may not be done; once it is final, it counts as replaced |
//!
//! A file of lines (a log, a CSV, prints, AQDEF) may grow: of such a file the whole lines are taken, and when it has grown, the lines that are
//! new. Its last line without a line end may be cut off in the middle of a number, so it waits until nothing was written for a while. A file
//! of another form (XML, a workbook) is taken when it can be read to its end. What shows nothing of its end (AQDEF, CALYPSO, contacts) is taken
//! when its writer has closed it, or where that is not known, when it was unchanged for a while: these are the stages of a file
//! (`folder::Stage`).

mod alone;
mod closed;
mod folder;
mod known;
mod lines;
mod note;
mod reading;
mod units;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::Duration;

use jiff::civil::DateTime;

pub use alone::Alone;
use fitcheck_core::message::{Message, Say};
use fitcheck_core::part::Plan;
use fitcheck_core::tolerance::Sources;
use fitcheck_core::tolerance::fit::thermal::Temperature;
use fitcheck_exchange::exchange::{Item, Remembered};
use fitcheck_exchange::journal::chain::Hash;
use fitcheck_files::{self as files, FileError};
use fitcheck_nc::control::mask::Mask;
use folder::{FileState, Folder, FoundFile};
pub use known::TakenFiles;
use known::TakenLines;
pub use note::{NOTE_ENDING, note_of};
use reading::Nothing;
use units::is_value;

/// How long a file has to be unchanged before it is looked into.
const QUIET: Duration = Duration::from_millis(100);

/// How long a file has to be unchanged before what is unfinished of it counts as it is: a last line without a line end is taken, and of a
/// file that cannot be read it is said why.
pub const PATIENCE: Duration = Duration::from_secs(3);

/// How often the folder should be looked at.
pub const EVERY: Duration = Duration::from_millis(100);

/// The most files that one look takes: they are recorded together.
const MOST_FILES: usize = 100;

/// What a file's values are judged with.
#[derive(Debug, Clone, Copy)]
pub struct FileJudging<'a> {
    /// The plan; without one the files' own callouts and limits count.
    pub plan: Option<&'a Plan>,
    /// Where limits are looked up.
    pub sources: &'a Sources,
    /// Masks of a control: a text that one of them printed is read back through it.
    pub masks: &'a [(String, Mask)],
    /// The columns of files as the user corrected them, by the shape of the file.
    pub columns: Option<&'a Remembered>,
    /// The time of values whose file has none.
    pub now: DateTime,
    /// From which temperature values are brought to 20 °C; what a file says of it is compared.
    pub temperature: Option<Temperature>,
}

/// What is ready to be recorded of a file: it is [`Watcher::taken`] once it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Batch {
    /// The file.
    pub path: PathBuf,
    /// Its name without the folder.
    pub name: String,
    /// The SHA-256 of what was read: of the whole file, or of its whole lines so far.
    pub sha256: Hash,
    /// What it holds, judged by the plan; of a file that has grown, what is new.
    pub items: Vec<Item>,
    /// Everything of it that is no check, in words: rows that cannot be used or judged, or why nothing can.
    pub problems: Vec<Message>,
    /// What else is to be said: values that were taken before from another file, or from the same one before it was replaced.
    pub remarks: Vec<Message>,
    /// How it was when it was read.
    found: FoundFile,
    /// Whether there is, or may be, more of it.
    is_open: bool,
    /// The lines that are known once it is taken.
    lines: TakenLines,
    /// What is said of values that were taken too early.
    late: Vec<Message>,
}

impl Batch {
    /// Whether anything was measured.
    fn has_values(&self) -> bool {
        self.items.iter().any(is_value)
    }
}

/// Why a file is waited for.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "watch")]
pub enum Waiting {
    /// It is being written.
    Written,
    /// Another program holds it.
    Locked {
        /// What the system says.
        reason: String,
    },
    /// It could not be read for a while: it is tried again, and nobody waits for it.
    Refused {
        /// What the system says.
        reason: String,
    },
}

/// What one look at the folder has found.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FolderScan {
    /// Files to be recorded, in the order in which they were written.
    pub ready: Vec<Batch>,
    /// Files that are not ready yet, by name.
    pub waiting: Vec<(String, Waiting)>,
    /// Files of which nothing is taken, because their content was taken before: the name, and the name that it had then, the same one where
    /// the file was written again.
    pub same: Vec<(String, String)>,
}

impl FolderScan {
    /// Whether nothing is left to do.
    pub fn is_idle(&self) -> bool {
        self.ready.is_empty() && self.waiting.iter().all(|(_, why)| matches!(why, Waiting::Refused { .. }))
    }
}

/// Looks at a folder again and again.
#[derive(Debug)]
pub struct Watcher {
    folder: Folder,
    known: TakenFiles,
    /// What notes are to say now; nothing where one goes.
    notes: Vec<(PathBuf, Vec<Message>)>,
    /// The files whose note says that they cannot be read.
    refused: BTreeSet<PathBuf>,
    /// The clock at the first look.
    begun: Option<Duration>,
}

impl Watcher {
    /// A folder, and what was taken from it or elsewhere before.
    pub fn new(folder: &Path, known: TakenFiles) -> Self {
        let notes = Vec::new();
        let refused = BTreeSet::new();
        Self { folder: Folder::new(folder), known, notes, refused, begun: None }
    }

    /// Leaves a file alone, such as the one that the verdicts go to, or the journal.
    pub fn leave(&mut self, file: &Path) {
        self.folder.leave(file);
    }

    /// Leaves a journal alone, with all that belongs to it.
    pub fn leave_journal(&mut self, journal: &Path) {
        for ending in ["", "-wal", "-shm", "-journal", "-lock"] {
            self.leave(&files::with_ending(journal, ending));
        }
    }

    /// One look; `clock` is any clock that only goes forward.
    ///
    /// # Errors
    /// [`FileError`] where the folder cannot be read: a share may be gone for a while, and the next look tries again.
    pub fn look(&mut self, judging: FileJudging<'_>, clock: Duration) -> Result<FolderScan, FileError> {
        let mut look = FolderScan::default();
        let is_young = clock.saturating_sub(*self.begun.get_or_insert(clock)) < PATIENCE;
        let known = &mut self.known;
        for found in self.folder.look(clock, &mut |before, now| known.rename(before, now))? {
            if found.is_waiting() || found.quiet < QUIET || MOST_FILES <= look.ready.len() {
                look.waiting.push((found.name, Waiting::Written));
                continue;
            }
            let read = reading::read(&found, judging, &mut self.known, is_young);
            if !matches!(read, Err(Nothing::Yet(Waiting::Locked { .. }))) {
                self.refused.remove(&found.path);
            }
            let waiting = match read {
                // A copy of what is ready now is told when that is taken.
                Ok(batch) if look.ready.iter().any(|ready| ready.sha256 == batch.sha256 && ready.has_values()) => {
                    Waiting::Written
                }
                Ok(batch) => {
                    look.ready.push(batch);
                    continue;
                }
                Err(Nothing::Left { same, note }) => {
                    self.folder.set(&found, FileState::Done);
                    self.notes.extend(note.map(|note| (found.path, note)));
                    look.same.extend(same.map(|same| (found.name, same)));
                    continue;
                }
                Err(Nothing::Yet(Waiting::Locked { reason })) if PATIENCE <= found.quiet => {
                    let waiting = Waiting::Refused { reason };
                    if self.refused.insert(found.path.clone()) {
                        self.notes.push((found.path, vec![waiting.message()]));
                    }
                    waiting
                }
                Err(Nothing::Yet(waiting)) => {
                    if waiting == Waiting::Written {
                        self.folder.set(&found, found.waits());
                    }
                    waiting
                }
            };
            look.waiting.push((found.name, waiting));
        }
        Ok(look)
    }

    /// Writes beside files of which a look has taken nothing why that is so, and takes away what is no longer true. `words` puts it into
    /// people's language.
    ///
    /// # Errors
    /// The first [`FileError`] where a note cannot be written: it is not tried again.
    pub fn tell(&mut self, words: &dyn Fn(&Message) -> String) -> Result<(), FileError> {
        let notes = std::mem::take(&mut self.notes);
        notes.iter().map(|(path, problems)| note::write(path, problems, words)).fold(Ok(()), Result::and)
    }

    /// What was ready is recorded: it is not taken again. What could not be used is written beside the file, for people; a note of an
    /// earlier try goes. `words` puts it into their language.
    ///
    /// # Errors
    /// [`FileError`] where the note cannot be written; the file counts as taken all the same.
    pub fn taken(&mut self, batch: &Batch, words: &dyn Fn(&Message) -> String) -> Result<(), FileError> {
        // What could not be read may be read another time: with the file beside it, with another mask, when there is more of it. Lines
        // without a value, such as an empty one, are not looked at again when there is more behind them.
        let past = self.known.past(&batch.name);
        past.late.clone_from(&batch.late);
        if batch.has_values() || batch.is_open {
            past.lines = Some(batch.lines.clone());
            self.known.add(batch.sha256, &batch.name);
        }
        if !batch.is_open {
            self.folder.set(&batch.found, FileState::Done);
        }
        note::write(&batch.path, &batch.problems, words)
    }
}
