//! Where the cells of some rows end.
//!
//! A quotation mark counts at the beginning of a cell only, and a doubled one within a quoted cell is a quotation mark (RFC
//! 4180; elsewhere it is a character, as in `5" pipe`). LF, CRLF and CR end a row.

use fitcheck_core::text::Within as _;
use wide::u8x16;

/// The longest row in bytes, 1 MiB: every cell takes memory, also an empty one.
pub(super) const LONGEST_ROW: usize = 1 << 20;

/// How many bytes are looked at in one step.
const STEP: usize = 16;

/// The most line ends within the quotation marks of a row: with more of them a mark is missing. It bounds how often a line is looked at.
const MOST_LINES: usize = 256;

/// The mark of an end that also ends its row.
const ROW: u32 = 1 << 31;

/// The ends of cells, in the order of the text; the last one of each row is marked.
#[derive(Debug, Default)]
pub(super) struct Index {
    /// The ends, and room behind them.
    ends: Vec<u32>,
    /// How many ends there are.
    count: usize,
}

/// Why the first row that is left is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Broken {
    /// A quotation mark on its first line is not closed, or closed in the middle of a later line.
    OpenQuote,
    /// It is longer than [`LONGEST_ROW`].
    TooLong,
}

/// How far whole rows reach, and what comes then.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Rows {
    /// Where the row begins that is not whole.
    pub(super) end: usize,
    /// Why it never will be; `None` where more of it may come.
    pub(super) broken: Option<Broken>,
}

impl Index {
    /// The rows of the index: the ends of their cells.
    pub(super) fn rows(&self) -> impl Iterator<Item = &[u32]> {
        self.ends.within(..self.count).split_inclusive(|end| end & ROW != 0)
    }

    /// Forgets all rows.
    pub(super) const fn clear(&mut self) {
        self.count = 0;
    }

    /// A cell ends here; with `is_last` its row, too.
    #[inline]
    pub(super) fn end_cell(&mut self, at: usize, is_last: bool) {
        self.push(at, if is_last { ROW } else { 0 });
    }

    fn push(&mut self, at: usize, mark: u32) {
        self.make_room();
        if let Some(place) = self.ends.get_mut(self.count) {
            // A block is far shorter than the mark is large; a place beyond it is none of its bytes.
            *place = u32::try_from(at).map_or(!ROW, |at| at) | mark;
            self.count += 1;
        }
    }

    /// Makes room for the ends of one step.
    #[inline]
    fn make_room(&mut self) {
        if self.ends.len() < self.count + STEP {
            self.ends.resize(2 * self.count + 64, 0);
        }
    }

    /// Finds the ends in whole rows without any quotation mark; where the last row has no line end, the text ends it.
    pub(super) fn find_plain(&mut self, text: &[u8], separator: u8) {
        self.count = 0;
        if memchr::memchr(b'\r', text).is_some() {
            self.find_slowly(text, separator);
        } else {
            self.find_fast(text, separator);
        }
        if text.last().is_some_and(|last| !matches!(last, b'\n' | b'\r')) {
            self.push(text.len(), ROW);
        }
    }

    /// Sixteen bytes at a time; LF alone ends rows.
    fn find_fast(&mut self, text: &[u8], separator: u8) {
        let (steps, rest) = text.as_chunks::<STEP>();
        let separators = u8x16::splat(separator);
        let line_ends = u8x16::splat(b'\n');
        let mut at = 0_u32;
        for step in steps {
            let step = u8x16::new(*step);
            // A bit for each byte.
            let lines = step.simd_eq(line_ends).to_bitmask();
            let mut hits = step.simd_eq(separators).to_bitmask() | lines;
            self.make_room();
            let Some(places) = self.ends.get_mut(self.count..).and_then(<[u32]>::first_chunk_mut::<STEP>) else {
                return;
            };
            for place in places {
                if hits == 0 {
                    break;
                }
                let bit = hits.trailing_zeros();
                *place = (at + bit) | (lines >> bit & 1) << 31;
                hits &= hits - 1;
                self.count += 1;
            }
            at += 16;
        }
        for (byte, at) in rest.iter().zip(wide(at)..) {
            if *byte == b'\n' {
                self.push(at, ROW);
            } else if *byte == separator {
                self.push(at, 0);
            }
        }
    }

    fn find_slowly(&mut self, text: &[u8], separator: u8) {
        let mut before = 0;
        for (at, &byte) in text.iter().enumerate() {
            if byte == separator {
                self.push(at, 0);
            } else if byte == b'\r' || byte == b'\n' && before != b'\r' {
                self.push(at, ROW);
            }
            before = byte;
        }
    }

    /// Finds the ends in a text that may have quotation marks, row by row as far as rows are whole.
    pub(super) fn find_quoted(&mut self, text: &[u8], separator: u8, is_all: bool) -> Rows {
        self.count = 0;
        let mut start = 0;
        while start < text.len() {
            let before = self.count;
            match self.quoted_row(text, start, separator, is_all) {
                Ok(next) => start = next,
                Err(broken) => {
                    self.count = before;
                    return Rows { end: start, broken };
                }
            }
        }
        Rows { end: start, broken: None }
    }

    /// Finds the ends of one row and where the next one begins; else why the row is not whole.
    pub(super) fn quoted_row(
        &mut self,
        text: &[u8],
        start: usize,
        separator: u8,
        is_all: bool,
    ) -> Result<usize, Option<Broken>> {
        let mut is_open = false;
        let mut is_first = true;
        let mut lines = 0;
        let mut at = start;
        let limit = start + LONGEST_ROW;
        loop {
            let Some(&byte) = text.get(at) else {
                return match (is_all, is_open) {
                    (true, true) => Err(Some(Broken::OpenQuote)),
                    (true, false) => {
                        self.push(at, ROW);
                        Ok(at)
                    }
                    (false, _) => Err(None),
                };
            };
            let next = text.get(at + 1).copied();
            let is_line_end = matches!(byte, b'\n' | b'\r');
            if limit <= at && (is_open || !is_line_end) {
                return Err(Some(if 0 < lines { Broken::OpenQuote } else { Broken::TooLong }));
            }
            if !is_all && next.is_none() && (byte == b'\r' || byte == b'"') {
                // What it means depends on what follows.
                return Err(None);
            }
            if is_open {
                lines += usize::from(is_line_end);
                if MOST_LINES < lines {
                    return Err(Some(Broken::OpenQuote));
                }
                if byte == b'"' && next == Some(b'"') {
                    at += 1;
                } else if byte == b'"' {
                    is_open = false;
                    let is_end = next.is_none_or(|next| next == separator || matches!(next, b'\n' | b'\r'));
                    if 0 < lines && !is_end {
                        return Err(Some(Broken::OpenQuote));
                    }
                }
                is_first = false;
            } else if is_line_end {
                self.push(at, ROW);
                return Ok(at + line_end(text, at));
            } else if byte == separator {
                self.push(at, 0);
                is_first = true;
            } else {
                is_open = is_first && byte == b'"';
                is_first = false;
            }
            at += 1;
        }
    }
}

/// Where the row that begins at a place ends, behind its line end, or why it is none; `None` where more of it may come.
pub fn row_end(text: &[u8], start: usize, separator: u8, is_all: bool) -> Option<Result<usize, Broken>> {
    match Index::default().quoted_row(text, start, separator, is_all) {
        Ok(next) => Some(Ok(next)),
        Err(broken) => broken.map(Err),
    }
}

/// A number of 32 bits as one of the machine.
pub(super) fn wide(number: u32) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}

/// Where a cell ends, without its mark.
pub(super) fn end(end: u32) -> usize {
    wide(end & !ROW)
}

/// How many bytes the line end at a place has: 0 at the end of the text.
pub(super) fn line_end(text: &[u8], at: usize) -> usize {
    match text.get(at..) {
        Some([b'\r', b'\n', ..]) => 2,
        Some([b'\r' | b'\n', ..]) => 1,
        _ => 0,
    }
}

/// Where the last whole line of a text without quotation marks ends, if it has one.
pub(super) fn last_line_end(text: &[u8], is_all: bool) -> Option<usize> {
    if let Some(at) = memchr::memrchr(b'\n', text) {
        return Some(at + 1);
    }
    // After the last byte there may come a LF, which belongs to the same line end.
    let known = text.len().saturating_sub(usize::from(!is_all));
    memchr::memrchr(b'\r', text.within(..known)).map(|at| at + 1)
}
