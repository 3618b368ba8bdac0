//! Files of measurements that are read piece by piece, whatever their size.

use std::fs::File;
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::path::Path;
use std::time::SystemTime;

use fitcheck_core::text::{Within as _, long};

use crate::exchange::{Body, ImportErrorKind, Item};
use crate::files::{self, FileError};
use crate::journal::chain::{FileHash, Hash};

/// A file of measurements, open.
#[derive(Debug)]
pub(super) enum Measured {
    /// A file that is read as often as it is wanted, and what tells whether it stays the same.
    File(File, Option<(u64, SystemTime)>),
    /// What a pipe gave: it is read once.
    Bytes(Vec<u8>),
}

impl Measured {
    /// Opens a file of any size; of a pipe, no more is read than of a file that is kept in memory.
    pub(super) fn open(path: &Path) -> Result<Self, FileError> {
        let (file, length) = files::open(path)?;
        if length.is_none() {
            return Ok(Self::Bytes(files::read_opened(file, path)?));
        }
        let stamp = stamp(&file);
        Ok(Self::File(file, stamp))
    }

    /// How many bytes it has, where that is known.
    pub(super) fn size(&self) -> Option<u64> {
        match self {
            Self::File(_, stamp) => stamp.map(|(length, _)| length),
            Self::Bytes(bytes) => u64::try_from(bytes.len()).ok(),
        }
    }

    /// Reads it from its beginning.
    pub(super) fn read<T>(&self, read: impl FnOnce(&mut dyn Body) -> T) -> T {
        match self {
            Self::File(file, _) => read(&mut &*file),
            Self::Bytes(bytes) => read(&mut Cursor::new(bytes.as_slice())),
        }
    }

    /// Whether it has the length and the time of change that it had when it was opened.
    pub(super) fn is_unchanged(&self) -> bool {
        match self {
            Self::File(file, before) => stamp(file) == *before,
            Self::Bytes(_) => true,
        }
    }
}

fn stamp(file: &File) -> Option<(u64, SystemTime)> {
    let about = file.metadata().ok()?;
    Some((about.len(), about.modified().ok()?))
}

/// That the system cannot read a file to its end: what it holds besides is not known, and another look at it may find more.
pub(super) fn unreadable(path: &Path, item: &Item) -> Option<FileError> {
    match item {
        Item::Error(error) => match &error.what.kind {
            ImportErrorKind::Read { reason } => {
                Some(FileError::System { reason: reason.clone(), path: path.to_owned() })
            }
            _ => None,
        },
        _ => None,
    }
}

/// A file whose hash is found while it is read: the hash of what was read, whatever becomes of the file later.
pub(super) struct Hashing<'a> {
    body: &'a mut dyn Body,
    /// Where it is read next.
    at: u64,
    /// How far the hash has come.
    hashed: u64,
    hash: FileHash,
}

impl<'a> Hashing<'a> {
    pub(super) fn new(body: &'a mut dyn Body) -> Self {
        Self { body, at: 0, hashed: 0, hash: FileHash::default() }
    }

    /// The hash of the whole file: the rest of it is read.
    pub(super) fn end(mut self) -> io::Result<Hash> {
        self.seek(SeekFrom::Start(self.hashed))?;
        io::copy(&mut self, &mut io::sink())?;
        Ok(self.hash.hash())
    }
}

impl Read for Hashing<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.body.read(buffer)?;
        let end = self.at + long(count);
        if self.at <= self.hashed && self.hashed < end {
            let seen = usize::try_from(self.hashed - self.at).unwrap_or(usize::MAX);
            self.hash.see(buffer.within(seen..count));
            self.hashed = end;
        }
        self.at = end;
        Ok(count)
    }
}

impl Seek for Hashing<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.at = self.body.seek(to)?;
        Ok(self.at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_that_of_the_whole_file_however_it_is_read() {
        let bytes: Vec<u8> = (0..=255).cycle().take(100_000).collect();
        let mut cursor = Cursor::new(bytes.as_slice());
        let mut hashing = Hashing::new(&mut cursor);
        let mut some = [0; 1000];
        hashing.seek(SeekFrom::End(0)).unwrap();
        hashing.rewind().unwrap();
        hashing.read_exact(&mut some).unwrap();
        hashing.rewind().unwrap();
        hashing.read_exact(&mut some[..10]).unwrap();
        hashing.seek(SeekFrom::Start(5_000)).unwrap();
        hashing.read_exact(&mut some).unwrap();
        assert_eq!(hashing.end().unwrap(), Hash::of_file(&bytes));
    }
}
