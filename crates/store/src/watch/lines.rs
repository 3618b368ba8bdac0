//! Where the lines of a file end, in its bytes.

use std::io::{self, Read as _};

use fitcheck_exchange::exchange::Body;
use fitcheck_exchange::exchange::pieces::utf16;

/// How much is read at a time: whole characters of UTF-16.
const READ: usize = 1 << 16;

/// The end of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct End {
    /// Where the line ends, and where the next one begins.
    pub(super) before: usize,
    pub(super) after: usize,
    /// Whether it is the LF that belongs to the CR before it.
    pub(super) is_rest: bool,
}

/// Finds the ends of lines in a file that is given piece by piece.
#[derive(Debug)]
pub(super) struct Lines {
    ends: &'static [u8],
    /// Whether the file is UTF-16, and whether its larger byte comes first.
    wide: Option<bool>,
    /// The last character, where it is a CR.
    was_return: bool,
}

impl Lines {
    /// Those of a file with this beginning, that end with one of these bytes.
    pub(super) fn new(head: &[u8], ends: &'static [u8]) -> Self {
        let wide = utf16(head).map(|encoding| encoding == encoding_rs::UTF_16BE);
        Self { ends, wide, was_return: false }
    }

    /// The ends in the next piece, which begins with a whole character.
    pub(super) fn ends(&mut self, piece: &[u8]) -> Vec<End> {
        if self.ends.is_empty() {
            return Vec::new();
        }
        let size = if self.wide.is_some() { 2 } else { 1 };
        let mut found = Vec::new();
        for (at, character) in piece.chunks(size).enumerate() {
            let byte = match (self.wide, character) {
                (None, [byte]) | (Some(true), [0, byte]) | (Some(false), [byte, 0]) => Some(*byte),
                _ => None,
            };
            let end = byte.filter(|byte| self.ends.contains(byte));
            if end.is_some() {
                let (before, after) = (at * size, (at + 1) * size);
                found.push(End { before, after, is_rest: self.was_return && end == Some(b'\n') });
            }
            self.was_return = end == Some(b'\r');
        }
        found
    }
}

/// Gives out a file from its beginning in pieces of whole characters.
///
/// # Errors
/// What the system says.
pub(super) fn each_piece(body: &mut dyn Body, see: &mut dyn FnMut(&[u8])) -> io::Result<()> {
    body.rewind()?;
    let mut piece = Vec::with_capacity(READ);
    loop {
        piece.clear();
        let most = u64::try_from(READ).unwrap_or(u64::MAX);
        body.take(most).read_to_end(&mut piece)?;
        if piece.is_empty() {
            return body.rewind();
        }
        see(&piece);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ends(text: &[u8]) -> Vec<(usize, usize, bool)> {
        let ends = Lines::new(text, b"\n\r").ends(text);
        ends.iter().map(|end| (end.before, end.after, end.is_rest)).collect()
    }

    #[test]
    fn lines_end_with_lf_cr_or_both() {
        assert_eq!(ends(b"a\nb"), [(1, 2, false)]);
        assert_eq!(ends(b"a\r\nb\r"), [(1, 2, false), (2, 3, true), (4, 5, false)]);
        assert_eq!(ends(b"\n\n"), [(0, 1, false), (1, 2, false)]);
    }

    #[test]
    fn in_utf_16_a_byte_of_a_character_is_no_end() {
        // U+0A0D is a letter of Gurmukhi.
        assert_eq!(ends(b"\xff\xfe\x0d\x0a\x0a\x00"), [(4, 6, false)]);
        assert_eq!(ends(b"\xfe\xff\x0a\x0d\x00\x0a"), [(4, 6, false)]);
    }
}
