//! What was taken already, by content: SHA-256 of whole files, and of the whole lines that a growing file had.

use std::collections::HashMap;
use std::io;

use crate::exchange::Body;
use crate::journal::chain::{FileHash, Hash};

/// The hashes of what was taken, and the name that each file had then.
#[derive(Debug, Clone, Default)]
pub struct Known(HashMap<Hash, String>);

/// How far a file goes, and how much of it is known.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Extent {
    /// How many bytes it has, and their hash.
    pub(super) end: u64,
    pub(super) hash: Hash,
    /// How many bytes its whole lines have, and their hash.
    pub(super) lines_end: u64,
    pub(super) lines_hash: Hash,
    /// How many lines and bytes at its beginning were taken before.
    pub(super) known_lines: usize,
    pub(super) known_end: u64,
    /// Whether all of it was.
    pub(super) is_known: bool,
}

impl Known {
    /// Remembers what was taken.
    pub fn add(&mut self, hash: Hash, name: &str) {
        self.0.insert(hash, name.to_owned());
    }

    /// The name under which something was taken; empty where nobody said it.
    pub(super) fn name_of(&self, hash: &Hash) -> Option<&str> {
        self.0.get(hash).map(String::as_str)
    }

    /// Remembers the files that an entry of a journal was made from, by its body: every SHA-256 in it that is named so. A budget or a
    /// program is no file of measurements, so it does no harm among them.
    pub fn see(&mut self, body: &[u8]) {
        const KEY: &[u8] = b"\",\"sha256\":\"";
        const NAME: &[u8] = b"\"name\":\"";
        for at in memchr::memmem::find_iter(body, KEY) {
            let hex = body.get(at + KEY.len()..).and_then(|rest| rest.get(..64));
            let hash = hex.and_then(|hex| std::str::from_utf8(hex).ok()).and_then(|hex| hex.parse().ok());
            let before = body.get(..at).unwrap_or_default();
            let name = memchr::memmem::rfind(before, NAME).and_then(|from| before.get(from + NAME.len()..));
            let name = name.map_or_else(String::new, |name| String::from_utf8_lossy(name).into_owned());
            self.0.extend(hash.map(|hash| (hash, name)));
        }
    }

    /// How many hashes there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether nothing was taken yet.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How much of a file is known; lines count where it `grows`, and only those that were taken from a file of its name: the first lines of
    /// another part's file may be the same, and are other measurements.
    pub(super) fn extent(&self, name: &str, body: &mut dyn Body, grows: bool) -> io::Result<Extent> {
        body.rewind()?;
        let (mut hash, mut extent, mut lines) = (FileHash::default(), Extent::default(), 0);
        let mut buffer = vec![0; 1 << 16];
        loop {
            let count = body.read(&mut buffer)?;
            let read = buffer.get(..count).unwrap_or_default();
            if read.is_empty() {
                break;
            }
            let mut from = 0;
            let ends = memchr::memchr_iter(b'\n', read).filter(|_| grows);
            for end in ends.map(|at| at + 1) {
                hash.see(read.get(from..end).unwrap_or_default());
                from = end;
                lines += 1;
                extent.lines_end = extent.end + u64::try_from(end).unwrap_or_default();
                extent.lines_hash = hash.clone().hash();
                if self.name_of(&extent.lines_hash) == Some(name) {
                    (extent.known_lines, extent.known_end) = (lines, extent.lines_end);
                }
            }
            hash.see(read.get(from..).unwrap_or_default());
            extent.end += u64::try_from(count).unwrap_or_default();
        }
        extent.hash = hash.hash();
        extent.is_known = self.0.contains_key(&extent.hash);
        body.rewind()?;
        Ok(extent)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    #[test]
    fn a_file_that_has_grown_is_known_up_to_the_lines_that_were_taken() {
        let mut known = Known::default();
        known.add(Hash::of_file(b"a\nb\n"), "a.csv");
        let extent = |text: &str, grows| known.extent("a.csv", &mut Cursor::new(text), grows).unwrap();
        assert!(extent("a\nb\n", true).is_known);
        let grown = extent("a\nb\nc\nd", true);
        assert_eq!((grown.known_lines, grown.known_end, grown.lines_end, grown.end), (2, 4, 6, 7));
        assert_eq!((grown.lines_hash, grown.hash), (Hash::of_file(b"a\nb\nc\n"), Hash::of_file(b"a\nb\nc\nd")));
        assert_eq!(extent("a\nB\nc\n", true).known_lines, 0);
        assert_eq!(extent("a\nb\nc\n", false).known_lines, 0);
        let other = known.extent("b.csv", &mut Cursor::new("a\nb\nc\n"), true).unwrap();
        assert_eq!(other.known_lines, 0, "another file that begins so");
    }
}
