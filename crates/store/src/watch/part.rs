//! The first bytes of a file as a file of their own.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};

/// A file up to a byte: what is written behind it meanwhile is not seen.
pub(super) struct Beginning<'a> {
    file: &'a File,
    end: u64,
    at: u64,
}

impl<'a> Beginning<'a> {
    pub(super) const fn new(file: &'a File, end: u64) -> Self {
        Self { file, end, at: 0 }
    }
}

impl Read for Beginning<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let left = usize::try_from(self.end.saturating_sub(self.at)).unwrap_or(usize::MAX);
        let most = buffer.len().min(left);
        let count = self.file.read(buffer.get_mut(..most).unwrap_or_default())?;
        self.at += u64::try_from(count).unwrap_or_default();
        Ok(count)
    }
}

impl Seek for Beginning<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let to = match to {
            SeekFrom::End(offset) => SeekFrom::Start(self.end.saturating_add_signed(offset)),
            to => to,
        };
        self.at = self.file.seek(to)?;
        Ok(self.at)
    }
}
