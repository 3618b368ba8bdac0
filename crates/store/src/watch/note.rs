//! What is written beside a file that could not be taken, or not as a whole.

use std::path::{Path, PathBuf};
use std::time::SystemTime;

use fitcheck_core::message::{Message, message};
use fitcheck_files::{self as files, FileError};

/// What a note's name has after that of its file.
pub const NOTE_ENDING: &str = ".why.txt";

/// How a note begins in every language: what does not begin so is somebody else's file.
const HEAD: &str = "Fitcheck";

/// The most lines of a note; more problems are counted.
const MOST: usize = 200;

/// The note of a file.
pub fn note_of(path: &Path) -> PathBuf {
    files::with_ending(path, NOTE_ENDING)
}

/// Whether a name is that of a note.
pub(super) fn is_note(name: &str) -> bool {
    name.ends_with(NOTE_ENDING)
}

/// Whether a file has a note of ours: somebody else's file, a link or a folder of that name is none. Nothing but a file is opened: a pipe
/// would be waited for. [`FileError::Exists`] where it is something else.
fn is_ours(note: &Path) -> Result<bool, FileError> {
    match note.symlink_metadata() {
        Ok(about) if about.is_file() && files::read_head(note, HEAD.len())? == HEAD.as_bytes() => Ok(true),
        Ok(_) => Err(FileError::Exists { path: note.to_owned() }),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(files::system(note, &error)),
    }
}

/// When the note of a file was written; `None` where it has none of ours.
pub(super) fn written(path: &Path) -> Option<SystemTime> {
    let note = note_of(path);
    let changed = note.symlink_metadata().ok()?.modified().ok()?;
    is_ours(&note).is_ok_and(|is_ours| is_ours).then_some(changed)
}

/// Writes the note of a file, one problem a line below its head; where there is none, an old note goes. Another's file of that name stays,
/// and what a link of that name leads to, too.
pub(super) fn write(path: &Path, problems: &[Message], words: &dyn Fn(&Message) -> String) -> Result<(), FileError> {
    let note = note_of(path);
    let is_there = match is_ours(&note) {
        Err(FileError::Exists { .. }) if problems.is_empty() => return Ok(()),
        is_ours => is_ours?,
    };
    if problems.is_empty() {
        return match std::fs::remove_file(&note) {
            Err(error) if is_there && error.kind() != std::io::ErrorKind::NotFound => Err(files::system(&note, &error)),
            _ => Ok(()),
        };
    }
    let name = files::name_of(path).to_string_lossy().into_owned();
    let head = words(&message!("watch-note").text("name", name));
    let more = (MOST < problems.len()).then(|| format!("… {}", problems.len()));
    let lines = problems.iter().take(MOST).map(words).chain(more);
    let text: Vec<String> = std::iter::once(head).chain(lines).collect();
    files::write(&note, (text.join("\n") + "\n").as_bytes())
}
