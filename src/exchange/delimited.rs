//! Rows and cells of a text with separators, and the lines that they are on.
//!
//! The `csv` crate splits rows into cells. A quotation mark that is not closed would make it swallow the rows after it,
//! so each line is checked first: only the first row, which may be a header, may span several lines.

use csv::{ReaderBuilder, StringRecord};

/// The separators that are tried.
pub(super) const SEPARATORS: [u8; 4] = [b';', b'\t', b'|', b','];

/// How many lines a header may have within quotation marks.
const HEADER_LINES: usize = 8;

/// A row or what was found in its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Item<'a> {
    /// Cells, and the line where the row begins.
    Row { line: usize, cells: StringRecord },
    /// A line with a quotation mark that is not closed on it.
    OpenQuote { line: usize, text: &'a str },
}

/// The rows of a text, without empty lines.
pub(super) struct Rows<'a> {
    text: &'a str,
    separator: u8,
    segments: std::vec::IntoIter<Segment>,
    reader: Option<Reader<'a>>,
}

/// A stretch of a text.
#[derive(Debug, Clone, Copy)]
struct Segment {
    start: usize,
    end: usize,
    line: usize,
    open_quote: bool,
}

struct Reader<'a> {
    csv: csv::Reader<&'a [u8]>,
    text: &'a str,
    /// How far lines have been counted.
    byte: usize,
    line: usize,
}

impl<'a> Rows<'a> {
    /// The rows of a text whose first line has the number `line`.
    pub(super) fn new(text: &'a str, line: usize, separator: u8) -> Self {
        Self { text, separator, segments: segments(text, line, separator).into_iter(), reader: None }
    }
}

impl<'a> Iterator for Rows<'a> {
    type Item = Item<'a>;

    fn next(&mut self) -> Option<Item<'a>> {
        loop {
            if let Some(reader) = &mut self.reader {
                if let Some(item) = reader.next_row() {
                    return Some(item);
                }
                self.reader = None;
            }
            let segment = self.segments.next()?;
            let text = self.text.get(segment.start..segment.end)?;
            if segment.open_quote {
                return Some(Item::OpenQuote { line: segment.line, text: text.trim_end() });
            }
            let csv = ReaderBuilder::new()
                .has_headers(false)
                .flexible(true)
                .delimiter(self.separator)
                .buffer_capacity(text.len().min(64 << 10))
                .from_reader(text.as_bytes());
            self.reader = Some(Reader { csv, text, byte: 0, line: segment.line });
        }
    }
}

impl<'a> Reader<'a> {
    fn next_row(&mut self) -> Option<Item<'a>> {
        let mut cells = StringRecord::new();
        match self.csv.read_record(&mut cells) {
            Ok(true) => {}
            Ok(false) => return None,
            // The text is valid, so nothing should go wrong; if it does, the row is reported.
            Err(error) => {
                let line = error.position().map_or(self.line, |at| at.line().try_into().unwrap_or(self.line));
                return Some(Item::OpenQuote { line, text: "" });
            }
        }
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

/// Cuts a text at the lines whose quotation marks are not closed.
fn segments(text: &str, first_line: usize, separator: u8) -> Vec<Segment> {
    let mut segments = Vec::new();
    let mut start = Segment { start: 0, end: text.len(), line: first_line, open_quote: false };
    if !text.contains('"') {
        return vec![start];
    }
    let mut lines = lines(text, first_line).peekable();
    let mut is_first = true;
    while let Some((line, from, to)) = lines.next() {
        let row = text.get(from..to).unwrap_or_default();
        let mut open = ends_open(row, separator, false);
        if open && is_first {
            let mut header = self::lines(text.get(to..).unwrap_or_default(), 1).take(HEADER_LINES);
            let closes = header.find_map(|(number, from, end)| {
                let row = text.get(to + from..to + end).unwrap_or_default();
                (!ends_open(row, separator, true)).then_some(number)
            });
            if let Some(count) = closes {
                for _ in 0..count {
                    lines.next();
                }
                open = false;
            }
        }
        is_first = is_first && row.trim().is_empty();
        if open {
            segments.push(Segment { end: from, ..start });
            segments.push(Segment { start: from, end: to, line, open_quote: true });
            start = Segment { start: to, line: line + 1, ..start };
        }
    }
    segments.push(start);
    segments.retain(|segment| segment.start < segment.end);
    segments
}

/// The lines of a text with their numbers, beginnings and ends; a line includes its line end.
fn lines(text: &str, first: usize) -> impl Iterator<Item = (usize, usize, usize)> {
    let bytes = text.as_bytes();
    let mut from = 0;
    let mut number = first;
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

/// Whether a quoted cell is still open at the end of a line: quotes count only at a cell's beginning, and a doubled
/// one within a quoted cell is a quote.
fn ends_open(line: &str, separator: u8, open_before: bool) -> bool {
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
                Item::OpenQuote { line, text } => format!("{line}! {text}"),
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
        check("a;b\nc;\"d\ne;f\"\n", &["1: a|b", "2! c;\"d", "3: e|f\""]);
        check("\"a;b\nc;d\n", &["1! \"a;b", "2: c|d"]);
    }

    proptest::proptest! {
        /// Whatever the text, lines come in order and each row's first cell is where it says.
        #[test]
        fn lines_ascend(text in "[a;\"\n\r #,]{0,80}") {
            let count = lines(&text, 1).count();
            let mut before = 0;
            for item in Rows::new(&text, 1, b';') {
                let (Item::Row { line, .. } | Item::OpenQuote { line, .. }) = item;
                proptest::prop_assert!(before < line && line <= count, "{line} after {before} of {count}");
                before = line;
            }
        }
    }
}
