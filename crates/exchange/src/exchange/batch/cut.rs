//! A stream cut into blocks of whole rows, one after the other, so that nothing about a block has to be guessed.

use std::io::{self, Read};

use crate::exchange::index::{Broken, Index, LONGEST_ROW, last_line_end, line_end};
use fitcheck_core::text::{Within as _, long};

/// How much is read at a time, 256 KiB: larger blocks are no faster and only take memory.
pub const BLOCK: usize = 256 << 10;

/// Rows that belong together: whole ones, or a single broken one.
#[derive(Debug, Default)]
pub struct Block {
    /// Where it begins, in bytes from the stream's first row on.
    pub(super) start: u64,
    pub(super) text: Vec<u8>,
    /// The ends of the cells, where quotation marks made it necessary to find them already.
    pub(super) index: Option<Index>,
    pub(super) broken: Option<Broken>,
    /// What an earlier block needed, kept for the next one with quotation marks.
    spare: Index,
}

impl Block {
    /// How many bytes of the stream it has.
    pub const fn len(&self) -> usize {
        self.text.len()
    }

    /// Where it begins, in bytes from the stream's first row on.
    pub const fn start(&self) -> u64 {
        self.start
    }

    /// The same bytes, read once more: they are cut at the same places.
    pub(crate) fn again(text: Vec<u8>, separator: u8, broken: Option<Broken>) -> Self {
        let mut block = Self { text, broken, ..Self::default() };
        if broken.is_none() && memchr::memchr(b'"', &block.text).is_some() {
            let mut index = Index::default();
            let _whole = index.find_quoted(&block.text, separator, true);
            block.index = Some(index);
        }
        block
    }

    /// Whether there is nothing in it.
    pub const fn is_empty(&self) -> bool {
        self.text.is_empty()
    }
}

/// Cuts a stream into blocks.
#[derive(Debug)]
pub struct Cutter {
    separator: u8,
    /// How much is read at a time.
    step: usize,
    /// Whether a block waits until it is full, as for files, or takes what has come, as for pipes.
    is_patient: bool,
    /// What was read and is in no block yet.
    rest: Vec<u8>,
    /// How many bytes were read.
    read: u64,
    is_ended: bool,
    /// Why nothing more can be read.
    failed: Option<io::Error>,
    /// The row was too long, and the rest of its line goes.
    is_skipping: bool,
}

impl Cutter {
    /// A stream from its first row on. `step` is usually [`BLOCK`].
    pub const fn new(separator: u8, step: usize, is_patient: bool) -> Self {
        Self {
            separator,
            step,
            is_patient,
            rest: Vec::new(),
            read: 0,
            is_ended: false,
            failed: None,
            is_skipping: false,
        }
    }

    /// Fills a block with the next rows; `false` at the end of the stream.
    ///
    /// # Errors
    /// What the stream reports, once the whole rows before it are given out; of a row that was cut off, nothing is.
    pub fn next(&mut self, input: &mut dyn Read, block: &mut Block) -> io::Result<bool> {
        block.text.clear();
        if let Some(index) = block.index.take() {
            block.spare = index;
        }
        block.broken = None;
        std::mem::swap(&mut block.text, &mut self.rest);
        // What was left over may hold rows already.
        let mut wants_more = block.text.len() < self.step && (self.is_patient || block.text.is_empty());
        loop {
            if wants_more && !self.is_ended {
                // What came before the failure may hold whole rows.
                if let Some(error) = self.failed.take() {
                    return Err(error);
                }
                self.fill(input, &mut block.text);
            }
            wants_more = true;
            if self.is_skipping && !self.skip(&mut block.text) {
                if self.is_ended {
                    return Ok(false);
                }
                continue;
            }
            if block.text.is_empty() && self.is_ended {
                return Ok(false);
            }
            if let Some(end) = self.border(block) {
                self.rest.extend_from_slice(block.text.within(end..));
                block.text.truncate(end);
                let after = long(self.rest.len() + end);
                block.start = self.read.saturating_sub(after);
                return Ok(true);
            }
        }
    }

    /// Where the block ends that may be judged; `None` where more must be read first.
    fn border(&mut self, block: &mut Block) -> Option<usize> {
        let text = &block.text;
        if memchr::memchr(b'"', text).is_none() {
            return match last_line_end(text, self.is_ended) {
                Some(end) if !self.is_ended => Some(end),
                _ if self.is_ended => Some(text.len()),
                // The last byte may be half of a line end.
                _ if LONGEST_ROW + 1 < text.len() => Some(self.give_up(block, Broken::TooLong)),
                _ => None,
            };
        }
        let mut index = std::mem::take(&mut block.spare);
        let rows = index.find_quoted(text, self.separator, self.is_ended);
        if 0 < rows.end {
            block.index = Some(index);
            return Some(rows.end);
        }
        block.spare = index;
        rows.broken.map(|broken| self.give_up(block, broken))
    }

    /// Where the line ends that is given out as broken.
    fn give_up(&mut self, block: &mut Block, broken: Broken) -> usize {
        block.broken = Some(broken);
        let text = &block.text;
        let line = memchr::memchr2(b'\n', b'\r', text).map(|at| at + line_end(text, at));
        match (broken, line) {
            (Broken::OpenQuote, Some(end)) => end,
            (Broken::OpenQuote, None) => text.len(),
            (Broken::TooLong, _) => {
                self.is_skipping = true;
                LONGEST_ROW.min(text.len())
            }
        }
    }

    /// Drops the rest of a line that is too long; `false` where it does not end here.
    fn skip(&mut self, text: &mut Vec<u8>) -> bool {
        let Some(at) = memchr::memchr2(b'\n', b'\r', text) else {
            text.clear();
            return false;
        };
        if text.get(at) == Some(&b'\r') && at + 1 == text.len() && !self.is_ended {
            text.drain(..at);
            return false;
        }
        text.drain(..at + line_end(text, at));
        self.is_skipping = false;
        true
    }

    /// Reads once from a pipe, and until there is enough from a file.
    fn fill(&mut self, input: &mut dyn Read, text: &mut Vec<u8>) {
        // A row that is still not whole is not looked at again for every few bytes of it.
        let wanted = self.step.max(text.len() / 2);
        let before = text.len();
        let is_patient = self.is_patient || self.step <= before;
        let read = read(input, wanted, is_patient, text);
        self.read += long(text.len() - before);
        match read {
            Ok(goes_on) => self.is_ended = !goes_on,
            Err(error) => self.failed = Some(error),
        }
    }
}

/// Appends as much of a stream as is wanted, or as one read gives. `false` at its end, which is known early to the patient.
///
/// # Errors
/// What the stream reports; what came before is appended.
pub fn read(input: &mut dyn Read, wanted: usize, is_patient: bool, text: &mut Vec<u8>) -> io::Result<bool> {
    if is_patient {
        // With room for one more byte nobody asks whether there is one.
        text.reserve(wanted + 1);
        return Ok(input.take(long(wanted)).read_to_end(text)? == wanted);
    }
    let before = text.len();
    text.resize(before + wanted, 0);
    let read = loop {
        match input.read(text.split_at_mut(before).1) {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            other => break other,
        }
    };
    let count = read.as_ref().map_or(0, |count| *count);
    text.truncate(before + count);
    Ok(0 < read?)
}
