//! What is written beside a file that could not be taken, or not as a whole.

use std::path::{Path, PathBuf};

use crate::files::{self, FileError};
use crate::message::Message;

/// What a note's name has after that of its file.
pub const NOTE_ENDING: &str = ".why.txt";

/// How a note begins in every language: what does not begin so is somebody else's file.
pub(super) const HEAD: &str = "Fitcheck";

/// The most lines of a note; more problems are counted.
const MOST: usize = 200;

/// The note of a file.
pub fn note_of(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(NOTE_ENDING);
    path.with_file_name(name)
}

/// Whether a name is that of a note.
pub(super) fn is_note(name: &str) -> bool {
    name.ends_with(NOTE_ENDING)
}

/// Writes the note of a file, one problem a line below its head; where there is none, an old note goes. Another's file of that name stays.
pub(super) fn write(path: &Path, problems: &[Message], words: &dyn Fn(&Message) -> String) -> Result<(), FileError> {
    let note = note_of(path);
    let is_there = match files::read_head(&note, HEAD.len()) {
        Ok(head) if head != HEAD.as_bytes() => {
            return if problems.is_empty() { Ok(()) } else { Err(FileError::Exists { path: note }) };
        }
        Ok(_) => true,
        Err(FileError::Missing { .. }) => false,
        Err(error) => return Err(error),
    };
    if problems.is_empty() {
        return match std::fs::remove_file(&note) {
            Err(error) if is_there && error.kind() != std::io::ErrorKind::NotFound => Err(files::system(&note, &error)),
            _ => Ok(()),
        };
    }
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let head = words(&Message::new("watch-note").text("name", name));
    let more = (MOST < problems.len()).then(|| format!("… {}", problems.len()));
    let lines = problems.iter().take(MOST).map(words).chain(more);
    let text: Vec<String> = std::iter::once(head).chain(lines).collect();
    files::write(&note, (text.join("\n") + "\n").as_bytes())
}
