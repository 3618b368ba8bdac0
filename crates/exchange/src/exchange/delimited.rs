//! Rows and cells of a text with separators, and the lines that they are on.
//!
//! The `csv` crate splits rows into cells. A quotation mark that is not closed would make it swallow the rows after it, so each line is
//! checked first: a row that spans several lines is given out as such, unless it is the first one, which may be a header.

use csv::{ReaderBuilder, StringRecord};

use super::index::{LONGEST_ROW, row_end};
use super::row::cells_of;
use fitcheck_core::text::Within as _;

/// The separators that are tried.
pub(super) const SEPARATORS: [u8; 4] = [b';', b'\t', b'|', b','];

/// How many lines a header may have within quotation marks.
const HEADER_LINES: usize = 8;

/// How much of a text is handed to the `csv` crate at a time.
const SEGMENT: usize = 1 << 20;

/// How much at first: often a few rows are enough.
const FIRST_SEGMENT: usize = 1 << 14;

/// A row or what was found in its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Item<'a> {
    /// Cells, and the line where the row begins.
    Row { line: usize, cells: StringRecord },
    /// Cells of a row that spans several lines, the line where it begins, and the lines.
    Lines { line: usize, text: &'a str, cells: StringRecord },
    /// A line with a quotation mark that is not closed on it, nor at the end of a cell further down.
    OpenQuote { line: usize, text: &'a str },
    /// A line longer than [`LONGEST_ROW`].
    TooLong { line: usize },
}

impl Item<'_> {
    /// The line where it begins.
    pub(super) const fn line(&self) -> usize {
        let (Self::Row { line, .. } | Self::Lines { line, .. } | Self::OpenQuote { line, .. } | Self::TooLong { line }) =
            self;
        *line
    }
}

/// The rows of a text, without empty lines. Only the part at which they are is in memory a second time.
pub(super) struct Rows<'a> {
    text: &'a str,
    separator: u8,
    /// How far the lines were looked at, and the number of the line there.
    at: usize,
    line: usize,
    /// Whether only blank lines came before.
    is_first: bool,
    /// Whether more of the text may come, and how much of this one has to be read again with it.
    goes_on: bool,
    rest: &'a str,
    /// What comes after the rows of the reader.
    waiting: Option<Item<'a>>,
    reader: Option<Reader<'a>>,
}

struct Reader<'a> {
    csv: csv::Reader<&'a [u8]>,
    text: &'a str,
    /// How far lines have been counted.
    byte: usize,
    line: usize,
    /// How many bytes and cells a row has had so far, at most.
    room: (usize, usize),
}

impl<'a> Rows<'a> {
    /// The rows of a text whose first line has the number `line`.
    pub(super) const fn new(text: &'a str, line: usize, separator: u8) -> Self {
        Self { text, separator, at: 0, line, is_first: true, goes_on: false, rest: "", waiting: None, reader: None }
    }

    /// The rows of a text that comes after other rows, so that none of them is a header.
    pub(super) fn after(text: &'a str, line: usize, separator: u8) -> Self {
        Self { is_first: false, ..Self::new(text, line, separator) }
    }

    /// The same rows of a text of which more may come: a last row of several lines is left for it.
    pub(super) fn going_on(self, goes_on: bool) -> Self {
        Self { goes_on, ..self }
    }

    /// The number of the line after the rows, once all were read.
    pub(super) const fn next_line(&self) -> usize {
        self.line
    }

    /// What is left behind the rows, once all were read, to be read with what follows the text.
    pub(super) const fn rest(&self) -> &'a str {
        self.rest
    }

    /// Whether the rows do not end where a line ends.
    pub(super) fn is_open(&self) -> bool {
        self.rest.is_empty() && !self.text.ends_with(['\n', '\r'])
    }

    /// Looks at lines up to one that is not a row, or far enough: the lines before it are for the reader.
    fn look_ahead(&mut self) {
        let start = self.at;
        let first = self.line;
        let mut end = start;
        let most = if start == 0 { FIRST_SEGMENT } else { SEGMENT };
        while self.waiting.is_none() && end < start + most {
            let Some((line, from, to)) = lines(self.text, self.at, self.line).next() else { break };
            let row = self.text.within(from..to);
            self.at = to;
            self.line = line + 1;
            if LONGEST_ROW < row.len() {
                self.waiting = Some(Item::TooLong { line });
            } else if ends_open(row, self.separator, false) && !(self.is_first && self.take_header(from)) {
                match row_end(self.text.as_bytes(), from, self.separator, !self.goes_on) {
                    Some(Ok(next)) => self.take_lines(line, from, next),
                    Some(Err(_)) => self.waiting = Some(Item::OpenQuote { line, text: row.trim_end() }),
                    None => {
                        self.rest = self.text.within(from..);
                        self.at = self.text.len();
                        self.line = line;
                        break;
                    }
                }
            } else {
                end = self.at;
            }
            self.is_first = self.is_first && row.trim().is_empty();
        }
        let Some(text) = self.text.get(start..end).filter(|text| !text.is_empty()) else { return };
        self.reader = Some(Reader { csv: csv_reader(text, self.separator), text, byte: 0, line: first, room: (0, 0) });
    }

    /// A row of several lines waits for the reader of those before it.
    fn take_lines(&mut self, line: usize, from: usize, next: usize) {
        let text = self.text.within(from..next);
        self.at = next;
        self.line = line + lines(text, 0, 0).count();
        self.waiting = Some(match cells_of(text, self.separator) {
            Some(cells) => Item::Lines { line, text, cells },
            None => Item::OpenQuote { line, text },
        });
    }

    /// Takes the lines in which a quotation mark of the line before is closed; `false` if there are none.
    fn take_header(&mut self, begin: usize) -> bool {
        let further = lines(self.text, self.at, self.line).take(HEADER_LINES);
        let mut further = further.take_while(|(_, _, to)| to - begin <= LONGEST_ROW);
        let closed = further.find(|&(_, from, to)| !ends_open(self.text.within(from..to), self.separator, true));
        let Some((line, _, to)) = closed else { return false };
        self.at = to;
        self.line = line + 1;
        true
    }
}

fn csv_reader(text: &str, separator: u8) -> csv::Reader<&[u8]> {
    ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .delimiter(separator)
        .buffer_capacity(text.len().min(64 << 10))
        .from_reader(text.as_bytes())
}

impl<'a> Iterator for Rows<'a> {
    type Item = Item<'a>;

    fn next(&mut self) -> Option<Item<'a>> {
        loop {
            if let Some(item) = self.reader.as_mut().and_then(Reader::next_row) {
                return Some(item);
            }
            self.reader = None;
            if let Some(item) = self.waiting.take() {
                return Some(item);
            }
            if self.text.len() <= self.at {
                return None;
            }
            self.look_ahead();
        }
    }
}

impl<'a> Reader<'a> {
    fn next_row(&mut self) -> Option<Item<'a>> {
        // As much room as the row before has needed.
        let (bytes, count) = self.room;
        let mut cells = StringRecord::with_capacity(bytes, count);
        match self.csv.read_record(&mut cells) {
            Ok(true) => {}
            Ok(false) => return None,
            // The text is valid, so nothing should go wrong; if it does, the row is reported.
            Err(error) => {
                let line = error.position().map_or(self.line, |at| at.line().try_into().unwrap_or(self.line));
                return Some(Item::OpenQuote { line, text: "" });
            }
        }
        self.room = (self.room.0.max(cells.as_slice().len()), self.room.1.max(cells.len()));
        // The position is the end of the row before: empty lines may come between.
        let start = cells.position().map_or(0, csv::Position::byte);
        self.count_to(start.try_into().unwrap_or(usize::MAX));
        while self.text.as_bytes().get(self.byte).is_some_and(|byte| b"\r\n".contains(byte)) {
            self.count_to(self.byte + 1);
        }
        Some(Item::Row { line: self.line, cells })
    }

    /// Counts line ends up to a byte: LF, CRLF or CR.
    fn count_to(&mut self, end: usize) {
        let bytes = self.text.as_bytes();
        while self.byte < end
            && let Some(&byte) = bytes.get(self.byte)
        {
            let is_end = byte == b'\n' || byte == b'\r' && bytes.get(self.byte + 1) != Some(&b'\n');
            self.line += usize::from(is_end);
            self.byte += 1;
        }
    }
}

/// The lines of a text from a byte on, with their numbers, beginnings and ends; a line includes its line end.
pub(super) fn lines(text: &str, mut from: usize, mut number: usize) -> impl Iterator<Item = (usize, usize, usize)> {
    let bytes = text.as_bytes();
    std::iter::from_fn(move || {
        let rest = bytes.get(from..).filter(|rest| !rest.is_empty())?;
        let end = match rest.iter().position(|&byte| byte == b'\n' || byte == b'\r') {
            Some(end) if rest.get(end..).is_some_and(|end| end.starts_with(b"\r\n")) => end + 2,
            Some(end) => end + 1,
            None => rest.len(),
        };
        let line = (number, from, from + end);
        from += end;
        number += 1;
        Some(line)
    })
}

/// The text after a line `sep=;`, which spreadsheets put first.
pub(super) fn without_separator_line(text: &str) -> (&str, usize, Option<u8>) {
    let separator =
        text.get(..4).filter(|start| start.eq_ignore_ascii_case("sep=")).and_then(|_| text.as_bytes().get(4));
    let (Some(&separator), Some(rest)) = (separator, text.get(5..)) else { return (text, 1, None) };
    match rest.strip_prefix("\r\n").or_else(|| rest.strip_prefix(['\n', '\r'])) {
        Some(rest) if separator.is_ascii() => (rest, 2, Some(separator)),
        _ => (text, 1, None),
    }
}

/// Whether a quoted cell is still open at the end of a line: quotes count only at a cell's beginning, and a doubled
/// one within a quoted cell is a quote.
fn ends_open(line: &str, separator: u8, open_before: bool) -> bool {
    if !line.contains('"') {
        return open_before;
    }
    let mut open = open_before;
    let mut at_start = !open_before;
    let mut bytes = line.bytes().peekable();
    while let Some(byte) = bytes.next() {
        if open {
            if byte == b'"' && bytes.next_if_eq(&b'"').is_none() {
                open = false;
            }
        } else if byte == b'"' && at_start {
            open = true;
        }
        at_start = !open && byte == separator;
    }
    open
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &[&str]) {
        let said: Vec<String> = Rows::new(text, 1, b';')
            .map(|item| match item {
                Item::Row { line, cells } => format!("{line}: {}", cells.iter().collect::<Vec<_>>().join("|")),
                Item::Lines { line, cells, .. } => format!("{line}+ {}", cells.iter().collect::<Vec<_>>().join("|")),
                Item::OpenQuote { line, text } => format!("{line}! {text}"),
                Item::TooLong { line } => format!("{line} too long"),
            })
            .collect();
        assert_eq!(said, expected);
    }

    #[test]
    fn rows_know_their_lines() {
        check("a;b\nc;d\n", &["1: a|b", "2: c|d"]);
        check("a;b\r\nc;d", &["1: a|b", "2: c|d"]);
        check("a\rb\r\rc", &["1: a", "2: b", "4: c"]);
        check("\n\n# x\n\r\na;b\r\n\r\n\r\nc\n", &["3: # x", "5: a|b", "8: c"]);
        check("", &[]);
        check("\n", &[]);
    }

    #[test]
    fn quoted_cells_hold_separators_and_quotes() {
        check("\"a;b\";\"c\"\"d\"\n1;2\n", &["1: a;b|c\"d", "2: 1|2"]);
        check("5\" pipe;b\n1;2\n", &["1: 5\" pipe|b", "2: 1|2"]);
    }

    #[test]
    fn a_header_may_run_over_lines() {
        check("id;\"measured\n[mm]\"\r\n1;2\n", &["1: id|measured\n[mm]", "3: 1|2"]);
        check("\nid;\"measured\r\n[mm]\"\r\n1;2\n", &["2: id|measured\r\n[mm]", "4: 1|2"]);
    }

    #[test]
    fn an_open_quote_costs_its_own_line_only() {
        check("a;b\n\"c;d\ne;f\n\"g\";h\n", &["1: a|b", "2! \"c;d", "3: e|f", "4: g|h"]);
        check("a;b\nc;\"d\ne;f\" g\n", &["1: a|b", "2! c;\"d", "3: e|f\" g"]);
        check("\"a;b\nc;d\n", &["1! \"a;b", "2: c|d"]);
    }

    #[test]
    fn a_row_of_several_lines_is_one() {
        check("a;b\nc;\"d\ne;f\"\ng;h\n", &["1: a|b", "2+ c|d\ne;f", "4: g|h"]);
        check("a\n\"b\r\n\r\n\"\"\";c\r\nd", &["1: a", "2+ b\r\n\r\n\"|c", "5: d"]);
    }

    #[test]
    fn a_row_of_several_lines_that_goes_on_is_left_for_what_follows() {
        for (text, rest) in [("a\nb;\"c\nd\n", "b;\"c\nd\n"), ("a\nb;\"c\nd\"\n", ""), ("a\nb\n", "")] {
            let mut rows = Rows::new(text, 1, b';').going_on(true);
            let count = rows.by_ref().count();
            assert_eq!((count, rows.rest()), (if rest.is_empty() { 2 } else { 1 }, rest));
            assert_eq!(rows.next_line(), 1 + lines(text.strip_suffix(rest).unwrap(), 0, 0).count());
        }
    }

    #[test]
    fn a_line_that_is_too_long_costs_itself_only() {
        let long = ";".repeat(LONGEST_ROW + 1);
        check(&format!("a;b\n{long}\nc;d"), &["1: a|b", "2 too long", "3: c|d"]);
        check(&format!("\"a\n{long}\"\nc"), &["1! \"a", "2 too long", "3: c"]);
        let rows = 3 * SEGMENT / 4;
        let text = "a;b\n".repeat(rows);
        assert!(Rows::new(&text, 1, b';').map(|item| item.line()).eq(1..=rows));
    }

    proptest::proptest! {
        /// Whatever the text, lines come in order and each row's first cell is where it says.
        #[test]
        fn lines_ascend(text in "[a;\"\n\r #,]{0,80}") {
            let count = lines(&text, 0, 1).count();
            let mut before = 0;
            for item in Rows::new(&text, 1, b';') {
                let line = item.line();
                proptest::prop_assert!(before < line && line <= count, "{line} after {before} of {count}");
                before = line;
            }
        }
    }
}
