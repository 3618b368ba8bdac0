//! The other half of what is two files: the same name with another ending.

use std::path::Path;

/// The bytes of the file beside this one that has another ending, in small or in capital letters; `None` where there is none, or
/// where it cannot be read whole.
pub fn beside(path: &Path, ending: &str) -> Option<Vec<u8>> {
    let endings = [ending.to_owned(), ending.to_ascii_uppercase()];
    endings.iter().find_map(|ending| super::read_file(&path.with_extension(ending)).ok())
}
