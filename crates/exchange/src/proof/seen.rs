//! A report that is seen while it is written: what is hashed is what went into the file, whoever changes that later.

use std::io::{self, Write};

use fitcheck_core::text::long;

use crate::journal::chain::{FileHash, Hash};
use crate::journal::entry::{Reported, Shown};
use crate::report::Rendering;

/// A stream that is counted and hashed on its way.
#[derive(Debug)]
pub struct Seen<W> {
    out: W,
    hash: FileHash,
    bytes: u64,
}

/// What went into a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SeenFile {
    pub sha256: Hash,
    /// How many bytes.
    pub bytes: u64,
}

impl<W: Write> Seen<W> {
    pub fn new(out: W) -> Self {
        Self { out, hash: FileHash::default(), bytes: 0 }
    }

    /// What went through it.
    pub fn finish(self) -> SeenFile {
        SeenFile { sha256: self.hash.hash(), bytes: self.bytes }
    }
}

impl<W: Write> Write for Seen<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.out.write(bytes)?;
        self.hash.see(bytes.get(..count).unwrap_or(bytes));
        self.bytes = self.bytes.saturating_add(long(count));
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

impl SeenFile {
    /// What the journal is told of it, once the file is whole: its name without its folder, and what it shows.
    pub fn reported(self, name: String, rendering: &Rendering, title: &str, shown: Shown) -> Reported {
        let Self { sha256, bytes } = self;
        Reported { name, format: rendering.name.to_owned(), sha256, bytes, title: title.to_owned(), shown }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_went_through_is_counted_and_hashed() {
        let mut out = Vec::new();
        let mut seen = Seen::new(&mut out);
        seen.write_all(b"25 H7").unwrap();
        seen.write_all(b"\n").unwrap();
        assert_eq!(seen.finish(), SeenFile { sha256: Hash::of_file(b"25 H7\n"), bytes: 6 });
        assert_eq!(out, b"25 H7\n");
    }
}
