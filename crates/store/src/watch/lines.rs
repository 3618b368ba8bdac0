//! Where the lines of a file end, and the hash of everything up to there.

use fitcheck_core::text::{Within as _, utf16};
use std::io::{self, Read as _};

use fitcheck_exchange::exchange::Body;
use fitcheck_exchange::journal::chain::{FileHash, Hash};

/// How much is read at a time: whole characters of UTF-16.
const READ: u64 = 1 << 16;

/// A place in a file, how many lines come before it, and the hash of all of that.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Mark {
    pub(super) end: u64,
    pub(super) lines: usize,
    pub(super) hash: Hash,
}

/// On which side of a line end a mark is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Before,
    /// CR LF has two such marks, one after each of its bytes.
    After,
}

/// Shows a mark before and after each line end of a file; lines end with one of these bytes. Returns the mark of the whole file: a last line
/// without a line end is not counted.
pub(super) fn each_mark(body: &mut dyn Body, line_ends: &[u8], see: &mut dyn FnMut(Side, Mark)) -> io::Result<Mark> {
    let mut hash = FileHash::default();
    let mut so_far = Mark::default();
    let mut piece = Vec::new();
    // Of UTF-16, whether the larger byte of a character comes first.
    let mut is_big_first = None;
    let mut was_return = false;
    body.rewind()?;
    while 0 < body.take(READ).read_to_end(&mut piece)? {
        if so_far.end == 0 {
            is_big_first = utf16(&piece).map(|encoding| encoding == encoding_rs::UTF_16BE);
        }
        let size = if is_big_first.is_some() { 2 } else { 1 };
        let mut from = 0;
        for (at, character) in piece.chunks(size).enumerate() {
            let byte = match (is_big_first, character) {
                (None, [byte]) | (Some(true), [0, byte]) | (Some(false), [byte, 0]) => Some(*byte),
                _ => None,
            };
            let line_end = byte.filter(|byte| line_ends.contains(byte));
            // The LF of CR LF ends no line of its own.
            let is_rest = was_return && line_end == Some(b'\n');
            was_return = line_end == Some(b'\r');
            if line_end.is_none() {
                continue;
            }
            let sides = [(Side::Before, at * size), (Side::After, (at + 1) * size)];
            for (side, to) in sides.into_iter().skip(usize::from(is_rest)) {
                hash.see(piece.within(from..to));
                from = to;
                so_far.lines += usize::from(side == Side::Before);
                see(side, Mark { end: so_far.end + wide(to), hash: hash.clone().hash(), ..so_far });
            }
        }
        hash.see(piece.within(from..));
        so_far.end += wide(piece.len());
        piece.clear();
    }
    body.rewind()?;
    Ok(Mark { hash: hash.hash(), ..so_far })
}

/// A length as a place in a file.
fn wide(length: usize) -> u64 {
    u64::try_from(length).unwrap_or(u64::MAX)
}

/// Everything up to and with the line of this number, from 1; `None` where no such line has an end.
pub(super) fn until(body: &mut dyn Body, line_ends: &[u8], line: usize) -> io::Result<Option<Mark>> {
    let mut found = None;
    each_mark(body, line_ends, &mut |side, mark| {
        if side == Side::After && mark.lines == line {
            found = Some(mark);
        }
    })?;
    Ok(found)
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    /// Where each line ends and the next one begins.
    fn ends(text: &[u8]) -> Vec<(Side, u64)> {
        let mut ends = Vec::new();
        each_mark(&mut Cursor::new(text), b"\n\r", &mut |side, mark| {
            ends.push((side, mark.end));
            let before = &text[..usize::try_from(mark.end).unwrap()];
            assert_eq!(mark.hash, Hash::of_file(before), "of everything before");
        })
        .unwrap();
        ends
    }

    #[test]
    fn lines_end_with_lf_cr_or_both() {
        use Side::{After, Before};
        assert_eq!(ends(b"a\nb"), [(Before, 1), (After, 2)]);
        assert_eq!(ends(b"a\r\nb\r"), [(Before, 1), (After, 2), (After, 3), (Before, 4), (After, 5)]);
        assert_eq!(ends(b"\n\n"), [(Before, 0), (After, 1), (Before, 1), (After, 2)]);
    }

    #[test]
    fn in_utf_16_a_byte_of_a_character_is_no_end() {
        use Side::{After, Before};
        // U+0A0D is a letter of Gurmukhi.
        assert_eq!(ends(b"\xff\xfe\x0d\x0a\x0a\x00"), [(Before, 4), (After, 6)]);
        assert_eq!(ends(b"\xfe\xff\x0a\x0d\x00\x0a"), [(Before, 4), (After, 6)]);
    }
}
