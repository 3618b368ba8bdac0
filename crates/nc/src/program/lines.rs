//! Lines of a program, and the parts of each.

use std::ops::Range;

use fitcheck_core::text::behind;

use super::place::TextPlace;

/// Where lines begin and end in a text: LF, CRLF, CR or byte 0 ends one (as in [`fitcheck_core::text::lines`]).
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Lines(Vec<(u32, u32)>);

impl Lines {
    /// Finds the lines; `None` where there are more than `most`.
    pub(super) fn of(text: &str, most: usize) -> Option<Self> {
        let mut found = Vec::new();
        let mut start = 0;
        while start < text.len() {
            let rest = text.get(start..)?;
            let length = rest.find(['\n', '\r', '\0']).unwrap_or(rest.len());
            if most <= found.len() {
                return None;
            }
            found.push((u32::try_from(start).ok()?, u32::try_from(start + length).ok()?));
            let is_pair = rest.get(length..).is_some_and(|end| end.starts_with("\r\n"));
            start += length + if is_pair { 2 } else { 1 };
        }
        Some(Self(found))
    }

    pub(super) const fn count(&self) -> usize {
        self.0.len()
    }

    /// The range of a line in the text, without its end.
    pub(super) fn range(&self, line: usize) -> Option<Range<usize>> {
        let &(start, end) = self.0.get(line)?;
        Some(usize::try_from(start).ok()?..usize::try_from(end).ok()?)
    }

    /// A place in a line: bytes turned into characters.
    pub(super) fn place(&self, text: &str, line: usize, at: usize) -> TextPlace {
        let before = self.line(text, line).get(..at).map_or(0, |before| before.chars().count());
        TextPlace { line: line + 1, column: before + 1 }
    }

    /// A line of the text; empty beyond the last.
    pub(super) fn line<'a>(&self, text: &'a str, line: usize) -> &'a str {
        self.range(line).and_then(|range| text.get(range)).map_or("", |line| line)
    }
}

/// Whether a character is skipped at both ends of a line; U+001A ends files of old systems.
fn is_blank(c: char) -> bool {
    c.is_whitespace() || c == '\u{1a}' || c == '\u{feff}'
}

/// A line without blanks around it.
pub(super) fn trimmed(line: &str) -> &str {
    line.trim_matches(is_blank)
}

/// The parts of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Piece<'a> {
    /// The line, from 0.
    pub line: usize,
    /// Where `code` begins in the line, in bytes.
    pub start: usize,
    /// The code, without comment, `~` and blanks around it.
    pub code: &'a str,
    /// The comment without `;`, `~` and blanks around it.
    pub comment: Option<&'a str>,
    /// Whether a `~` ends the line.
    pub goes_on: bool,
    /// The place of a quotation mark that is not closed, in bytes from the line's beginning.
    pub open_quote: Option<usize>,
}

/// Parses the first line of a block; skips the first `from` bytes (block number and skip mark).
pub(super) fn first(text: &str, line: usize, from: usize) -> Piece<'_> {
    let piece = next(text, line, from);
    // In a heading quotation marks and semicolons are text.
    let code = text.get(piece.start..).map_or("", |code| without_tilde(code).0);
    if code.starts_with('*') { Piece { code, comment: None, open_quote: None, ..piece } } else { piece }
}

/// A text without blanks at its end and the `~` there, and whether there was one.
fn without_tilde(text: &str) -> (&str, bool) {
    let text = text.trim_end_matches(is_blank);
    text.strip_suffix('~').map_or((text, false), |before| (before.trim_end_matches(is_blank), true))
}

/// Parses a further line of a block.
pub(super) fn next(text: &str, line: usize, from: usize) -> Piece<'_> {
    let (rest, goes_on) = without_tilde(behind(text, from));
    let begins = rest.len() - rest.trim_start_matches(is_blank).len();
    let (end, open_quote) = comment_begins(rest);
    let (code, comment) = rest.split_at_checked(end).unwrap_or((rest, ""));
    // In programs that were written by hand, the ~ may come before the comment.
    let (code, goes_on_before) = without_tilde(code);
    Piece {
        line,
        start: from + begins,
        code: trimmed(code),
        comment: comment.strip_prefix(';').map(trimmed),
        goes_on: goes_on || goes_on_before,
        open_quote: open_quote.map(|at| from + at),
    }
}

/// Where the comment begins: at the first `;` that is not within quotation marks. A mark that is not closed has no
/// effect; its place is returned.
fn comment_begins(text: &str) -> (usize, Option<usize>) {
    let mut at = 0;
    while let Some(found) = text.get(at..).and_then(|rest| rest.find([';', '"'])) {
        let place = at + found;
        if text.get(place..).is_some_and(|rest| rest.starts_with(';')) {
            return (place, None);
        }
        let Some(length) = text.get(place + 1..).and_then(|rest| rest.find('"')) else {
            let end = text.get(place..).and_then(|rest| rest.find(';')).map_or(text.len(), |found| place + found);
            return (end, Some(place));
        };
        at = place + length + 2;
    }
    (text.len(), None)
}

/// What precedes a block: the number, the skip mark on either side of it, and where the rest begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Front {
    /// The block number.
    pub number: Option<u32>,
    pub may_be_skipped: bool,
    /// Where the rest begins, in bytes.
    pub end: usize,
}

/// Reads what precedes a block.
pub(super) fn front(line: &str) -> Front {
    front_of(line, is_blank, |rest| Some(rest))
}

/// Reads what precedes a block where `digits` takes what stands before the figures of its number, if that is there.
pub(super) fn front_of(line: &str, is_blank: fn(char) -> bool, digits: fn(&str) -> Option<&str>) -> Front {
    let mut rest = line.trim_start_matches(is_blank);
    let mut may_be_skipped = false;
    let mut skip = |rest: &mut &str| {
        if let Some(behind) = rest.strip_prefix('/') {
            may_be_skipped = true;
            *rest = behind.trim_start_matches(is_blank);
        }
    };
    skip(&mut rest);
    let numbered = digits(rest).and_then(|digits| {
        let behind = digits.trim_start_matches(|c: char| c.is_ascii_digit());
        Some((digits.strip_suffix(behind)?.parse().ok()?, behind))
    });
    if let Some((_, behind)) = numbered {
        rest = behind.trim_start_matches(is_blank);
        skip(&mut rest);
    }
    Front { number: numbered.map(|(number, _)| number), may_be_skipped, end: line.len() - rest.len() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_those_of_the_room() {
        for text in ["", "a", "a\n", "a\nb\r\nc\rd\0e\n\nf", "\r\n\r\n", "\n\r\n\r"] {
            let lines = Lines::of(text, 100).unwrap();
            let ours: Vec<&str> = (0..lines.count()).map(|line| lines.line(text, line)).collect();
            let theirs: Vec<&str> = fitcheck_core::text::lines(text).map(|(_, line)| line).collect();
            assert_eq!(ours, theirs, "{text:?}");
        }
        assert_eq!(Lines::of("a\nb\nc", 2), None);
    }

    #[track_caller]
    fn check(line: &str, code: &str, comment: Option<&str>, goes_on: bool) {
        let found = first(line, 3, front(line).end);
        assert_eq!((found.code, found.comment, found.goes_on), (code, comment, goes_on), "{line}");
        assert!(line.get(found.start..).unwrap().starts_with(code));
    }

    #[test]
    fn a_line_is_taken_apart() {
        check("5  L  X+1 R0 ;go ", "L  X+1 R0", Some("go"), false);
        check("    Q263=+20   ;1. PUNTO ~ ", "Q263=+20", Some("1. PUNTO"), true);
        check("TCH PROBE 427 A~", "TCH PROBE 427 A", None, true);
        check("3 DECLARE STRING QS1 = \"a;b\" ; \"c", "DECLARE STRING QS1 = \"a;b\"", Some("\"c"), false);
        check("7 * - a \"heading; this", "* - a \"heading; this", None, false);
        check("CYCL DEF 247 A ~ ;hand", "CYCL DEF 247 A", Some("hand"), true);
        check("8 ; only a comment ~", "", Some("only a comment"), true);
        check("9", "", None, false);
        check("\u{1a}", "", None, false);
        check("3 CALL PGM \"a;b", "CALL PGM \"a", Some("b"), false);
        assert_eq!(first("3 CALL PGM \"a;b", 0, 2).open_quote, Some(11));
    }

    #[test]
    fn numbers_and_skip_marks() {
        let check = |line: &str, number, may_be_skipped, end| {
            assert_eq!(front(line), Front { number, may_be_skipped, end }, "{line}");
        };
        check("0  BEGIN", Some(0), false, 3);
        check("/43 L", Some(43), true, 4);
        check("12 /L", Some(12), true, 4);
        check(" / L", None, true, 3);
        check("L X1", None, false, 0);
        check("99999999999 L", None, false, 0);
    }
}
