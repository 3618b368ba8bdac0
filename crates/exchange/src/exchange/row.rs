//! A row of a block: its bytes and its cells.

use std::borrow::Cow;

use csv::StringRecord;
use fitcheck_core::length::{Length, Unit};

use super::index::{self, Index};
use fitcheck_core::text::Within as _;

/// A row within a text.
#[derive(Debug, Clone, Copy)]
pub struct TextRow<'a> {
    pub(super) text: &'a [u8],
    pub(super) start: usize,
    /// Where its last cell ends.
    pub(super) end: usize,
    /// The ends of its cells, marked as the index has them.
    ends: &'a [u32],
}

impl<'a> TextRow<'a> {
    /// The row that begins at a place of a text, with the ends of its cells.
    #[inline]
    pub(super) fn new(text: &'a [u8], start: usize, ends: &'a [u32]) -> Self {
        Self { text, start, end: ends.last().map_or(start, |end| index::end(*end)), ends }
    }

    /// How many cells it has.
    pub(super) const fn len(&self) -> usize {
        self.ends.len()
    }

    /// Where the next row begins.
    #[inline]
    pub(super) fn next(&self) -> usize {
        if self.text.get(self.end) == Some(&b'\n') {
            return self.end + 1;
        }
        self.end + index::line_end(self.text, self.end)
    }

    /// Its bytes without the line end.
    #[inline]
    pub(super) fn bytes(&self) -> &'a [u8] {
        self.text.within(self.start..self.end)
    }

    /// Its line end; nothing where the text ends with it.
    #[inline]
    pub(super) fn line_end(&self) -> &'a [u8] {
        self.text.within(self.end..self.end + index::line_end(self.text, self.end))
    }

    /// A cell as it stands there, with its quotation marks.
    #[inline]
    pub(super) fn cell(&self, at: usize) -> Option<&'a [u8]> {
        self.part(at).map(Part::bytes)
    }

    /// A cell as it stands there, within the text.
    #[inline]
    pub(super) fn part(&self, at: usize) -> Option<Part<'a>> {
        let end = index::end(*self.ends.get(at)?);
        let start = match at.checked_sub(1) {
            Some(before) => index::end(*self.ends.get(before)?) + 1,
            None => self.start,
        };
        Some(Part { text: self.text, start, end })
    }

    /// All cells as they stand there.
    pub(super) fn cells(self) -> impl Iterator<Item = &'a [u8]> {
        (0..self.len()).filter_map(move |at| self.cell(at))
    }

    /// The first cells, as many as are asked for, with the separators between them.
    pub(super) fn first_cells(&self, count: usize) -> &'a [u8] {
        let end = count.checked_sub(1).and_then(|last| self.ends.get(last)).map_or(self.start, |end| index::end(*end));
        self.text.within(self.start..end)
    }

    /// How many lines it runs over.
    pub(super) fn lines(&self) -> usize {
        let bytes = self.bytes();
        if memchr::memchr(b'"', bytes).is_none() {
            return 1;
        }
        let ends = memchr::memchr2_iter(b'\n', b'\r', bytes);
        1 + ends.filter(|&at| bytes.get(at..at + 2) != Some(b"\r\n")).count()
    }

    /// Its cells without quotation marks, as `import` reads them. The text is UTF-8.
    pub(super) fn record(&self) -> StringRecord {
        self.cells().map(unquoted).collect()
    }
}

/// The cells of a text that is one row, without quotation marks; `None` where it is none.
pub fn cells_of(text: &str, separator: u8) -> Option<StringRecord> {
    let mut index = Index::default();
    index.quoted_row(text.as_bytes(), 0, separator, true).ok()?;
    index.rows().next().map(|ends| TextRow::new(text.as_bytes(), 0, ends).record())
}

/// A part of a text. What stands around it is at hand, because eight bytes at a time are read faster than two.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part<'a> {
    text: &'a [u8],
    start: usize,
    end: usize,
}

impl<'a> Part<'a> {
    #[inline]
    pub(super) fn bytes(self) -> &'a [u8] {
        self.text.within(self.start..self.end)
    }

    /// It as a number, where it is a plain one, and its decimal sign.
    #[inline]
    pub(super) fn number(self, unit: Unit) -> Option<(Length, Option<u8>)> {
        Length::plain(self.text, self.start, self.end, unit)
    }

    /// Up to eight bytes as one number.
    #[inline]
    pub(super) fn packed(self) -> Option<u64> {
        let length = self.end.checked_sub(self.start).filter(|length| (1..=8).contains(length))?;
        let Some(last) = self.end.checked_sub(8).and_then(|first| self.text.get(first..)?.first_chunk()) else {
            return Some(self.bytes().iter().fold(0, |key, byte| key << 8 | u64::from(*byte)));
        };
        Some(u64::from_be_bytes(*last) & u64::MAX >> (8 * (8 - length)))
    }

    /// It without one pair of quotation marks and without blanks; `None` where there is more to undo.
    #[inline]
    pub(super) fn plain(self) -> Option<Self> {
        let Self { text, start, end } = self;
        let (start, end) = match self.bytes() {
            [first, .., last] if b'"' < *first && b' ' < *last => return Some(self),
            [b'"', inner @ .., b'"'] if !inner.contains(&b'"') => (start + 1, end - 1),
            [b'"', ..] => return None,
            _ => (start, end),
        };
        let inner = text.get(start..end)?.trim_ascii_start();
        Some(Self { text, start: end - inner.len(), end: end - inner.len() + inner.trim_ascii_end().len() })
    }

    /// It without the spaces at its end.
    #[inline]
    pub(super) fn without_spaces_behind(self) -> Self {
        let spaces = self.bytes().iter().rev().take_while(|byte| **byte == b' ').count();
        Self { end: self.end - spaces, ..self }
    }

    /// Both sides of a place in it.
    #[inline]
    pub(super) fn split(self, at: usize) -> (Self, Self) {
        let at = (self.start + at).min(self.end);
        (Self { end: at, ..self }, Self { start: at, ..self })
    }
}

/// A cell without its quotation marks; what comes after the closing one stays as it is.
pub(super) fn unquoted(cell: &[u8]) -> Cow<'_, str> {
    let Ok(text) = std::str::from_utf8(cell) else { return String::from_utf8_lossy(cell) };
    let Some(inner) = text.strip_prefix('"') else { return Cow::Borrowed(text) };
    if let Some((inner, rest)) = inner.split_once('"')
        && rest.is_empty()
    {
        return Cow::Borrowed(inner);
    }
    let mut out = String::new();
    let mut rest = inner;
    while let Some((before, after)) = rest.split_once('"') {
        out.push_str(before);
        let Some(after) = after.strip_prefix('"') else {
            out.push_str(after);
            return Cow::Owned(out);
        };
        out.push('"');
        rest = after;
    }
    out.push_str(rest);
    Cow::Owned(out)
}
