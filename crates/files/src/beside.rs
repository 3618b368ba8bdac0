//! The other half of what is two files: the same name with another ending.

use std::path::{Path, PathBuf};

/// The bytes of the file beside this one that has another ending, in small or in capital letters; `None` where there is none, or
/// where it cannot be read whole.
pub fn beside(path: &Path, ending: &str) -> Option<Vec<u8>> {
    super::read_file(&beside_path(path, ending)).ok()
}

/// Its path: the one with the ending in small letters where there is none.
pub fn beside_path(path: &Path, ending: &str) -> PathBuf {
    let capital = path.with_extension(ending.to_ascii_uppercase());
    let small = path.with_extension(ending);
    if !small.exists() && capital.exists() { capital } else { small }
}
