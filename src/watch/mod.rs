//! A folder that controls and gauges drop files into: each file is taken once, completely written or not at all.
//!
//! | file | what |
//! |---|---|
//! | here | one look at the folder: which files are ready, and what they hold |
//! | `folder` | what lies in the folder, and since when it is unchanged |
//! | `known` | what was taken already, by content; how much of a file that has grown |
//! | `part` | the first bytes of a file as a file of their own |
//! | `note` | what is written beside a file that could not be taken whole |
//!
//! The folder is looked at again and again: shares of a network send no notifications. Nothing is moved or deleted in it. What was taken is
//! remembered by the SHA-256 of its bytes, which the journal keeps with every entry, so that a restart needs no other memory and a renamed
//! file is not taken twice.
//!
//! A file of lines (a log, a CSV, AQDEF) may grow: of such a file the whole lines are taken, and when it has grown, the lines that are new.
//! Its last line without a line end may be cut off in the middle of a number, so it waits until nothing was written for a while. A file of
//! another form (XML, a workbook, a table with an end mark) is taken when it can be read to its end.

mod folder;
mod known;
mod note;
mod part;

use std::io::{Read as _, Seek as _};
use std::path::{Path, PathBuf};
use std::time::Duration;

use jiff::civil::DateTime;

use crate::control::mask::Mask;
use crate::exchange::{ByPlan, FirstRows, Given, Item, MOST_ROWS, Mapping, Remembered, WHOLE, import_from, recognised};
use crate::files::{self, FileError};
use crate::journal::chain::Hash;
use crate::message::{Message, Say};
use crate::part::Plan;
use crate::tolerance::Sources;
use folder::{Folder, Found};
pub use known::Known;
pub use note::{NOTE_ENDING, note_of};
use part::Beginning;

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
pub struct Judging<'a> {
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
    /// How it was when it was read.
    found: Found,
    /// Whether its last line is still waited for.
    is_open: bool,
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
}

/// What one look at the folder has found.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Look {
    /// Files to be recorded, in the order in which they were written.
    pub ready: Vec<Batch>,
    /// Files that are not ready yet, by name.
    pub waiting: Vec<(String, Waiting)>,
    /// Files of which nothing is taken, because their content was taken before under another name: the name, and that one.
    pub same: Vec<(String, String)>,
}

impl Look {
    /// Whether nothing is left to do.
    pub const fn is_idle(&self) -> bool {
        self.ready.is_empty() && self.waiting.is_empty()
    }
}

/// Looks at a folder again and again.
#[derive(Debug)]
pub struct Watcher {
    folder: Folder,
    known: Known,
}

impl Watcher {
    /// A folder, and what was taken from it or elsewhere before.
    pub fn new(folder: &Path, known: Known) -> Self {
        Self { folder: Folder::new(folder), known }
    }

    /// One look; `clock` is any clock that only goes forward.
    ///
    /// # Errors
    /// [`FileError`] where the folder cannot be read: a share may be gone for a while, and the next look tries again.
    pub fn look(&mut self, judging: Judging<'_>, clock: Duration) -> Result<Look, FileError> {
        let mut look = Look::default();
        for found in self.folder.look(clock)? {
            if found.quiet < QUIET {
                look.waiting.push((found.name.clone(), Waiting::Written));
                continue;
            }
            if MOST_FILES <= look.ready.len() {
                look.waiting.push((found.name.clone(), Waiting::Written));
                continue;
            }
            let name = found.name.clone();
            match self.read(found, judging, &mut look.same) {
                Ok(Some(batch)) => look.ready.push(batch),
                Ok(None) => {}
                Err(waiting) => look.waiting.push((name, waiting)),
            }
        }
        Ok(look)
    }

    /// What was ready is recorded: it is not taken again. What could not be used is written beside the file, for people; a note of an
    /// earlier try goes. `words` puts it into their language.
    ///
    /// # Errors
    /// [`FileError`] where the note cannot be written; the file counts as taken all the same.
    pub fn taken(&mut self, batch: &Batch, words: &dyn Fn(&Message) -> String) -> Result<(), FileError> {
        self.known.add(batch.sha256, &batch.name);
        if !batch.is_open {
            self.folder.done(&batch.found);
        }
        let problems: Vec<String> = batch.problems.iter().map(words).collect();
        note::write(&batch.path, &problems)
    }

    /// Looks into a file; `None` where all of it was taken before, or it is gone.
    fn read(
        &mut self,
        found: Found,
        judging: Judging<'_>,
        same: &mut Vec<(String, String)>,
    ) -> Result<Option<Batch>, Waiting> {
        let path = found.path.clone();
        let file = match files::open(&path) {
            Ok((file, _)) => file,
            Err(FileError::Missing { .. }) => return Ok(None),
            Err(error) => return Err(Waiting::Locked { reason: error.to_string() }),
        };
        let is_patient = PATIENCE <= found.quiet;
        let locked = |error: &std::io::Error| Waiting::Locked { reason: error.to_string() };
        let mut body = &file;
        let format = recognised(&found.name, &mut body).map_err(|error| locked(&error))?;
        let grows = format.is_some_and(|format| format.grows);
        // What neither grows line by line nor shows its end may be cut off anywhere, also where it can be read.
        if !grows && !is_patient && format.is_some_and(|format| !format.is_closed) {
            return Err(Waiting::Written);
        }
        let extent = self.known.extent(&found.name, &mut body, grows).map_err(|error| locked(&error))?;
        if extent.is_known {
            let known = self.known.name_of(&extent.hash).filter(|known| !known.is_empty() && *known != found.name);
            same.extend(known.map(|known| (found.name.clone(), known.to_owned())));
            self.folder.done(&found);
            return Ok(None);
        }
        // A last line without its end may be half a number.
        let ends_in_line = grows && extent.lines_end < extent.end && !is_patient;
        let (end, sha256) =
            if ends_in_line { (extent.lines_end, extent.lines_hash) } else { (extent.end, extent.hash) };
        if ends_in_line && end <= extent.known_end {
            return Err(Waiting::Written);
        }
        let has_marks = format.is_some_and(|format| format.has_marks);
        let masks = if has_marks { &[] } else { judging.masks };
        let all = read_all(&file, &found, end, Judging { masks, ..judging });
        // What no mask has printed may be a table of its own.
        let is_printed = masks.is_empty() || all.iter().any(|item| !matches!(item, Item::Error(_) | Item::Warning(_)));
        let all = if is_printed { all } else { read_all(&file, &found, end, Judging { masks: &[], ..judging }) };
        // A note tells of the whole file, also of what was taken before.
        let problems: Vec<Message> = all.iter().filter_map(problem).collect();
        let is_new = |item: &Item| extent.known_lines == 0 || extent.known_lines < line_of(item);
        let items: Vec<Item> = all.into_iter().filter(is_new).collect();
        // What changed while it was read may be half old and half new.
        if !found.is_unchanged() {
            return Err(Waiting::Written);
        }
        // An unfinished file cannot be told from a broken one but by waiting.
        let is_unfinished = |item: &Item| matches!(item, Item::Error(_));
        let waits = if grows { items.last().is_some_and(is_unfinished) } else { items.iter().any(is_unfinished) };
        if waits && !is_patient {
            return Err(Waiting::Written);
        }
        Ok(Some(Batch { path, name: found.name.clone(), sha256, items, problems, found, is_open: ends_in_line }))
    }
}

/// What the first bytes of a file hold, judged by the plan.
fn read_all(file: &std::fs::File, found: &Found, end: u64, judging: Judging<'_>) -> Vec<Item> {
    let beside = |ending: &str| files::beside(&found.path, ending);
    let usual = Given::new(judging.sources, judging.now);
    let (masks, has_plan, mapping) = (judging.masks, judging.plan.is_some(), remembered(file, found, end, judging));
    let mapping = mapping.as_ref();
    let given = Given { beside: &beside, masks, mapping, most_rows: MOST_ROWS, has_plan, ..usual };
    let (mut items, mut by_plan) = (Vec::new(), judging.plan.map(ByPlan::new));
    import_from(&found.name, &mut Beginning::new(file, end), given, &mut |item| match &mut by_plan {
        Some(by_plan) => by_plan.item(item, &mut |item| items.push(item)),
        None => items.push(item),
    });
    items
}

/// The columns of a file as the user corrected them for files of its shape.
fn remembered(file: &std::fs::File, found: &Found, end: u64, judging: Judging<'_>) -> Option<Mapping> {
    let columns = judging.columns.filter(|columns| !columns.is_empty() && judging.masks.is_empty())?;
    let (mut body, mut bytes) = (Beginning::new(file, end), Vec::new());
    body.rewind().ok()?;
    body.take(WHOLE).read_to_end(&mut bytes).ok()?;
    let first = FirstRows::of(&found.name, &bytes)?;
    columns.find(&first).map(|(.., mapping)| mapping)
}

/// The line of a thing in its file.
fn line_of(item: &Item) -> usize {
    match item {
        Item::Record { line, .. } => *line,
        Item::Unjudged(unjudged) => unjudged.line,
        Item::Error(error) => error.place.line.unwrap_or(usize::MAX),
        Item::Warning(warning) => warning.what.row.or(warning.place.line).unwrap_or(usize::MAX),
        Item::Contacts(_) => usize::MAX,
    }
}

/// What is to be said of a thing that is no check.
fn problem(item: &Item) -> Option<Message> {
    match item {
        Item::Record { .. } | Item::Warning(_) | Item::Contacts(_) => None,
        Item::Error(error) => Some(error.message()),
        Item::Unjudged(unjudged) => {
            let at = crate::message::Located::in_line(unjudged.line, unjudged.why.clone());
            Some(at.message())
        }
    }
}
