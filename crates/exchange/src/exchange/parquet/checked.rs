//! Pages that are looked at before they are decoded.
//!
//! The decoders of the `parquet` crate trust two things that a damaged file may not keep, and end the program otherwise: that
//! a page with numbers of words comes after a page with words, and that texts in the plain encoding are as many and as long
//! as they say.

use bytes::Bytes;
use parquet::basic::Encoding;
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::errors::ParquetError;

/// Gives the pages of a column, and refuses those that cannot be decoded.
pub(super) struct Checked {
    pub(super) pages: Box<dyn PageReader>,
    /// Whether the values are texts, each behind its length.
    pub(super) has_texts: bool,
    /// Whether a row may have no value.
    pub(super) has_gaps: bool,
    /// Whether words have come.
    pub(super) has_words: bool,
}

impl Iterator for Checked {
    type Item = Result<Page, ParquetError>;

    fn next(&mut self) -> Option<Self::Item> {
        self.get_next_page().transpose()
    }
}

impl PageReader for Checked {
    fn get_next_page(&mut self) -> Result<Option<Page>, ParquetError> {
        let page = self.pages.get_next_page()?;
        if let Some(page) = &page {
            self.check(page)?;
        }
        Ok(page)
    }

    fn peek_next_page(&mut self) -> Result<Option<PageMetadata>, ParquetError> {
        self.pages.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Result<(), ParquetError> {
        self.pages.skip_next_page()
    }
}

impl Checked {
    fn check(&mut self, page: &Page) -> Result<(), ParquetError> {
        let damaged = |what: &str| Err(ParquetError::General(format!("a page is damaged: {what}")));
        let encoding = page.encoding();
        if page.is_dictionary_page() {
            self.has_words = true;
        } else if matches!(encoding, Encoding::PLAIN_DICTIONARY | Encoding::RLE_DICTIONARY) && !self.has_words {
            return damaged("it has numbers of words, and there are no words");
        }
        let is_plain = encoding == Encoding::PLAIN || page.is_dictionary_page();
        if !self.has_texts || !is_plain {
            return Ok(());
        }
        match self.texts(page) {
            Some((wanted, values)) if has_texts(&values, wanted) => Ok(()),
            _ => damaged("its texts are fewer or shorter than it says"),
        }
    }

    /// How many texts a page should have, and its bytes behind the levels.
    fn texts(&self, page: &Page) -> Option<(usize, Bytes)> {
        let count = usize::try_from(page.num_values()).ok()?;
        let buffer = page.buffer();
        if page.is_dictionary_page() || !self.has_gaps {
            return Some((count, buffer.clone()));
        }
        let (levels, values) = match page {
            Page::DataPageV2 { def_levels_byte_len, rep_levels_byte_len, .. } => {
                let before = usize::try_from(*rep_levels_byte_len).ok()?;
                let end = before.checked_add(usize::try_from(*def_levels_byte_len).ok()?)?;
                (buffer.get(before..end)?, end)
            }
            Page::DataPage { def_level_encoding: Encoding::RLE, .. } => {
                let (length, rest) = buffer.split_first_chunk()?;
                let length = usize::try_from(u32::from_le_bytes(*length)).ok()?;
                (rest.get(..length)?, length + 4)
            }
            // An older encoding of levels.
            _ => return None,
        };
        Some((ones(levels, count)?, buffer.slice(values..)))
    }
}

/// Whether there are so many texts, each whole.
fn has_texts(mut values: &[u8], count: usize) -> bool {
    for _ in 0..count {
        let Some((length, rest)) = values.split_first_chunk() else { return false };
        let length = usize::try_from(u32::from_le_bytes(*length)).unwrap_or(usize::MAX);
        let Some(rest) = rest.get(length..) else { return false };
        values = rest;
    }
    true
}

/// How many of the first `count` levels are 1, in runs and packed bits.
fn ones(mut bytes: &[u8], mut count: usize) -> Option<usize> {
    let mut ones = 0;
    while 0 < count {
        let (header, rest) = varint(bytes)?;
        let number = usize::try_from(header >> 1).ok()?;
        if header & 1 == 0 {
            let (level, rest) = rest.split_first()?;
            let run = number.min(count);
            ones += if level & 1 == 1 { run } else { 0 };
            count -= run;
            bytes = rest;
            if number == 0 {
                return None;
            }
        } else {
            // The last group may be cut where no level is left.
            let (groups, rest) = rest.split_at(number.min(rest.len()));
            for group in groups {
                let of_group = count.min(8);
                let mask = u8::try_from((1_u16 << of_group) - 1).ok()?;
                ones += usize::try_from((group & mask).count_ones()).ok()?;
                count -= of_group;
            }
            bytes = rest;
            if groups.is_empty() {
                return None;
            }
        }
    }
    Some(ones)
}

fn varint(bytes: &[u8]) -> Option<(u64, &[u8])> {
    let mut number = 0_u64;
    for (at, byte) in bytes.iter().enumerate().take(9) {
        number |= u64::from(byte & 0x7f) << (7 * at);
        if byte & 0x80 == 0 {
            return Some((number, bytes.get(at + 1..)?));
        }
    }
    None
}
