//! What is written beside a file that could not be taken, or not as a whole.

use std::path::{Path, PathBuf};

use crate::files::{self, FileError};

/// What a note's name has after that of its file.
pub const NOTE_ENDING: &str = ".why.txt";

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

/// Writes the note, one problem a line; where there is none, an old note goes.
pub(super) fn write(path: &Path, problems: &[String]) -> Result<(), FileError> {
    let note = note_of(path);
    if problems.is_empty() {
        return match std::fs::remove_file(&note) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(files::system(&note, &error)),
            _ => Ok(()),
        };
    }
    let more = (MOST < problems.len()).then(|| format!("… {}", problems.len()));
    let lines: Vec<&str> = problems.iter().take(MOST).chain(&more).map(String::as_str).collect();
    files::write(&note, (lines.join("\n") + "\n").as_bytes())
}
