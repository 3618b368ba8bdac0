//! The text of a file in pieces of whole lines, so that a file of any size takes the memory of one piece.
//!
//! UTF-16 with a byte order mark becomes UTF-8. In every other file a line that is not UTF-8 is Windows-1252, as in `batch`: which of the
//! two a file is cannot be known before its end.

use std::borrow::Cow;
use std::io::{self, Read};

use encoding_rs::Encoding;
use encoding_rs_io::DecodeReaderBytesBuilder;
use fitcheck_core::text::{Within as _, utf16, windows_1252};

use super::batch::{BLOCK, read};
use super::error::ImportErrorKind;
use super::index::LONGEST_ROW;

/// How much the first piece has: the longest row and a header, so that the columns are known by it.
const FIRST: usize = LONGEST_ROW + BLOCK;

/// A text of this encoding as UTF-8.
pub(crate) fn as_utf8<R: Read>(encoding: &'static Encoding, input: R) -> impl Read {
    DecodeReaderBytesBuilder::new().encoding(Some(encoding)).build(input)
}

/// Gives out a text piece by piece.
pub(super) struct Pieces<'a> {
    input: Box<dyn Read + 'a>,
    /// The bytes that end a line.
    ends: &'static [u8],
    /// How much is read at a time.
    step: usize,
    bytes: Vec<u8>,
    /// How many of them were given out.
    given: usize,
    is_ended: bool,
    /// Why nothing more can be read, told once the whole lines before it are given out.
    failed: Option<io::Error>,
}

impl<'a> Pieces<'a> {
    /// A text from its beginning; `head` has its first bytes. Each of the bytes `ends` ends a line, and CR LF is one end.
    pub(super) fn new(input: impl Read + 'a, head: &[u8], ends: &'static [u8]) -> Self {
        let input: Box<dyn Read + 'a> = match utf16(head) {
            Some(encoding) => Box::new(as_utf8(encoding, input)),
            None => Box::new(input),
        };
        Self { input, ends, step: FIRST, bytes: Vec::new(), given: 0, is_ended: false, failed: None }
    }

    /// The next lines with their ends; `None` at the end of the text. Of a line that is longer than a row may be, the beginning.
    ///
    /// # Errors
    /// [`ImportErrorKind::Read`] once the whole lines before it are given out.
    pub(super) fn next(&mut self) -> Result<Option<Cow<'_, str>>, ImportErrorKind> {
        let is_first = self.step == FIRST && self.given == 0;
        self.bytes.drain(..self.given);
        self.given = 0;
        while !self.is_ended {
            if let Some(error) = self.failed.take() {
                return Err(ImportErrorKind::read(&error));
            }
            self.fill();
            if self.is_ended {
                break;
            }
            if let Some(end) = self.last_end() {
                self.given = end;
                break;
            }
            if LONGEST_ROW + 1 < self.bytes.len() {
                self.skip();
            }
        }
        if self.is_ended {
            self.given = self.bytes.len();
        }
        self.step = BLOCK;
        let lines = self.bytes.within(..self.given);
        let lines = if is_first { lines.strip_prefix(b"\xef\xbb\xbf").unwrap_or(lines) } else { lines };
        Ok((!lines.is_empty()).then(|| text_of(lines)))
    }

    fn fill(&mut self) {
        match read(&mut self.input, self.step, true, &mut self.bytes) {
            Ok(goes_on) => self.is_ended = !goes_on,
            Err(error) => self.failed = Some(error),
        }
    }

    /// Where the last whole line ends.
    fn last_end(&self) -> Option<usize> {
        // After a CR there may come the LF that belongs to it.
        let is_end =
            |(at, byte): &(usize, &u8)| self.ends.contains(byte) && (**byte != b'\r' || at + 1 < self.bytes.len());
        let lines = self.bytes.iter().enumerate().rev();
        lines.into_iter().find(is_end).map(|(at, _)| at + 1 + usize::from(self.bytes.get(at..at + 2) == Some(b"\r\n")))
    }

    /// Drops the rest of a line that is too long, but for what shows that it is.
    fn skip(&mut self) {
        self.bytes.truncate(LONGEST_ROW + 1);
        let kept = self.bytes.len();
        while !self.is_ended && self.failed.is_none() {
            self.fill();
            let rest = self.bytes.within(kept..);
            if let Some(end) = rest.iter().position(|byte| self.ends.contains(byte)) {
                self.bytes.drain(kept..kept + end);
                return;
            }
            self.bytes.truncate(kept);
        }
    }
}

/// The text of some lines: UTF-8, and each line that is not Windows-1252.
fn text_of(lines: &[u8]) -> Cow<'_, str> {
    if let Ok(text) = std::str::from_utf8(lines) {
        return Cow::Borrowed(text);
    }
    let lines = lines.split_inclusive(|byte| matches!(byte, b'\n' | b'\r' | 0));
    let text_of = |line| std::str::from_utf8(line).map_or_else(|_| Cow::Owned(windows_1252(line)), Cow::Borrowed);
    Cow::Owned(lines.map(text_of).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pieces of a text that is read in small steps.
    fn pieces(bytes: &[u8], step: usize) -> Vec<String> {
        let mut pieces = Pieces { step, ..Pieces::new(bytes, bytes, b"\n\r") };
        let mut all = Vec::new();
        while let Some(piece) = pieces.next().unwrap() {
            all.push(piece.into_owned());
            pieces.step = step;
        }
        all
    }

    #[test]
    fn pieces_end_where_lines_end() {
        assert_eq!(pieces(b"a\nb\nc\nd", 3), ["a\n", "b\nc\n", "d"]);
        assert_eq!(pieces(b"a\r\nb\r\nc\r\n", 2), ["a\r\n", "b\r\n", "c\r\n"]);
        assert_eq!(pieces(b"a\rb\rc\rd", 2), ["a\r", "b\r", "c\rd"]);
        assert_eq!(pieces(b"", 2), [""; 0]);
    }

    #[test]
    fn each_line_has_its_own_encoding() {
        assert_eq!(pieces(b"\xd8 25\n\xc3\x98 26\n", 100).concat(), "Ø 25\nØ 26\n");
        assert_eq!(pieces(b"\xff\xfe\xd8\x00\n\x00", 100).concat(), "Ø\n");
    }

    #[test]
    fn a_line_of_any_length_takes_the_memory_of_one_row() {
        let text = [b"a\n".as_slice(), &vec![b'x'; 3 * LONGEST_ROW], b"\r\nb"].concat();
        let all = pieces(&text, BLOCK);
        assert!(all.iter().all(|piece| piece.len() < 2 * LONGEST_ROW));
        let all = all.concat();
        let lines: Vec<&str> = all.lines().collect();
        assert_eq!((lines[0], lines[1].len(), lines[2]), ("a", LONGEST_ROW + 1, "b"));
    }

    proptest::proptest! {
        #[test]
        fn pieces_are_the_whole_text_and_end_where_lines_end(text in "[a\n\rä]{0,60}", step in 1_usize..9) {
            let pieces = pieces(text.as_bytes(), step);
            let (_last, others) = pieces.split_last().unzip();
            let ends_in_line = |piece: &String| piece.ends_with(['\n', '\r']);
            proptest::prop_assert!(others.is_none_or(|others| others.iter().all(ends_in_line)), "{pieces:?}");
            proptest::prop_assert_eq!(pieces.concat(), text);
        }
    }
}
