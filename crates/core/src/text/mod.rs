//! From the bytes of a text file to text, and pieces of texts and lists.
//!
//! Controls write UTF-8 or Windows-1252, with LF, CRLF, CR or byte 0 between lines: text transfer over LSV2 separates
//! lines with byte 0 (`docs/SOURCES.md`).

mod within;

use std::borrow::Cow;

use encoding_rs::Encoding;

pub use within::{Within, long};

/// The encoding of a text that begins with the byte order mark of UTF-16.
pub fn utf16(head: &[u8]) -> Option<&'static Encoding> {
    match head {
        [0xff, 0xfe, ..] => Some(encoding_rs::UTF_16LE),
        [0xfe, 0xff, ..] => Some(encoding_rs::UTF_16BE),
        _ => None,
    }
}

/// Text of a file: UTF-16 with its byte order mark, else UTF-8 if it is valid (a byte order mark is dropped), else Windows-1252. Never fails.
pub fn decode(bytes: &[u8]) -> Cow<'_, str> {
    if let Some(encoding) = utf16(bytes) {
        return encoding.decode_with_bom_removal(bytes).0;
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_not_utf8) => Cow::Owned(windows_1252(bytes)),
    }
}

/// The text of bytes in Windows-1252: one character per byte.
pub fn windows_1252(bytes: &[u8]) -> String {
    encoding_rs::WINDOWS_1252.decode_without_bom_handling(bytes).0.into_owned()
}

/// A whole number in groups of three digits, with spaces that do not break.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if 0 < at && (digits.len() - at).is_multiple_of(3) {
            text.push('\u{a0}');
        }
        text.push(digit);
    }
    text
}

/// The beginning of a text, short enough for a message: at most 40 characters.
pub fn beginning(text: &str) -> String {
    cut(text.trim(), 40)
}

/// A text from a byte on; nothing where the text ends before it.
pub fn behind(text: &str, at: usize) -> &str {
    text.split_at_checked(at).map_or("", |(_, behind)| behind)
}

/// A text up to a byte; nothing where the text ends before it.
pub fn before(text: &str, at: usize) -> &str {
    text.split_at_checked(at).map_or("", |(before, _)| before)
}

/// The part of a text between two bytes; nothing where the text ends before the second.
pub fn part(text: &str, start: usize, end: usize) -> &str {
    behind(before(text, end), start)
}

/// A text up to the first sign of a kind, or to its end.
pub fn until(text: &str, sign: char) -> &str {
    text.split_once(sign).map_or(text, |(before, _)| before)
}

/// The first word of a text; nothing where there is none.
pub fn first_word(text: &str) -> &str {
    text.split_whitespace().next().map_or("", |word| word)
}

/// A text as a sentence of its own: it begins with a capital letter.
pub fn sentence(text: &str) -> String {
    let mut rest = text.chars();
    rest.next().map_or_else(String::new, |first| first.to_uppercase().chain(rest).collect())
}

/// At most this many characters of a text, and a sign if there are more.
pub fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", before(text, end)),
        None => text.to_owned(),
    }
}

/// What ends a line; CR LF is one end.
pub const LINE_ENDS: [char; 3] = ['\n', '\r', '\0'];

/// What ends a line in formats of other programs than a control's.
pub const PLAIN_LINE_ENDS: [char; 2] = ['\n', '\r'];

/// The same as bytes.
pub const PLAIN_LINE_END_BYTES: &[u8] = b"\n\r";

/// The bytes of [`LINE_ENDS`].
pub const LINE_END_BYTES: &[u8] = b"\n\r\0";

/// The lines of a text, numbered from 1, without their ends: LF, CRLF, CR or byte 0.
pub fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    lines_from(text, 1)
}

/// The same for a text whose first line has this number.
pub fn lines_from(text: &str, first: usize) -> impl Iterator<Item = (usize, &str)> {
    lines_ended_by(text, first, &LINE_ENDS)
}

/// The same of formats that know no byte 0: a line that has one was not written to its end.
pub fn plain_lines_from(text: &str, first: usize) -> impl Iterator<Item = (usize, &str)> {
    lines_ended_by(text, first, &PLAIN_LINE_ENDS)
}

/// The lines of a control's text, each with whether text may be missing behind it: where it has no end, and where its end is byte 0, as
/// in a file that was not written to its end.
pub fn lines_open_from(text: &str, first: usize) -> impl Iterator<Item = (usize, &str, bool)> {
    let mut at = 0;
    lines_from(text, first).map(move |(number, line)| {
        let behind = behind(text, at + line.len());
        at += line.len() + if behind.starts_with("\r\n") { 2 } else { 1 };
        (number, line, !behind.starts_with(PLAIN_LINE_ENDS))
    })
}

fn lines_ended_by<'t>(text: &'t str, first: usize, ends: &'static [char]) -> impl Iterator<Item = (usize, &'t str)> {
    let mut rest = Some(text);
    let mut number = first.saturating_sub(1);
    std::iter::from_fn(move || {
        let text = rest.filter(|text| !text.is_empty())?;
        number += 1;
        let (line, after) = match text.find(ends) {
            Some(end) => {
                let (line, after) = text.split_at_checked(end)?;
                (line, after.strip_prefix("\r\n").or_else(|| after.get(1..))?)
            }
            None => (text, ""),
        };
        rest = Some(after);
        Some((number, line))
    })
}

#[cfg(test)]
mod tests {
    use super::beginning;

    #[test]
    fn long_texts_are_cut_in_messages() {
        assert_eq!(beginning("  short "), "short");
        assert_eq!(beginning(&"ß".repeat(41)), format!("{}…", "ß".repeat(40)));
    }
}
