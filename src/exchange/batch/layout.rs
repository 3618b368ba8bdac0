//! What the first rows of a stream say: where the rows begin and what their columns are.

use std::borrow::Cow;

use super::index::Index;
use super::row::Row;
use super::{LONGEST_ROW, index};
use crate::control::text::windows_1252;
use crate::exchange::columns::{self, Columns, Sample};
use crate::exchange::delimited::without_separator_line;
use crate::exchange::error::{ImportErrorKind, ImportWarningKind};
use crate::exchange::{FORMATS, Source};
use crate::message::Say as _;
use crate::tolerance::Sources;

/// How much of a stream decides at most what its columns are: the longest row and a header.
pub const HEAD: usize = LONGEST_ROW + (256 << 10);

const MARK: &[u8] = b"\xef\xbb\xbf";

/// What is known of a stream before its rows are judged.
#[derive(Debug)]
pub struct Layout {
    pub(super) columns: Columns,
    pub(super) separator: u8,
    /// The names of the columns, or their numbers where the stream has no header.
    pub names: Vec<String>,
    /// Everything above the first row, with the header: UTF-8 with all line ends, and a byte order mark if there was one.
    pub(super) above: Vec<u8>,
    /// How many bytes that is in the stream.
    pub skip: usize,
    /// The line of the first row.
    pub line: usize,
    /// Whether a row follows in what was looked at.
    pub has_rows: bool,
    /// Whether the columns have names.
    pub has_header: bool,
    /// The line end of the header, or of the first row.
    pub(super) line_end: &'static [u8],
    /// Whether what is above the rows was UTF-8; it is passed on as such.
    pub is_utf8: bool,
    /// What is to be said of lines above the rows, which are passed on as they are: the line, and a warning.
    pub warnings: Vec<(usize, ImportWarningKind)>,
}

impl Layout {
    /// The layout of a stream by its first bytes, which are all of it where `is_all`. Only whole lines count.
    ///
    /// # Errors
    /// Why nothing in it can be judged; with more of the stream, up to [`HEAD`], that may change.
    pub fn of(head: &[u8], is_all: bool, file_name: &str) -> Result<Self, ImportErrorKind> {
        let end = if is_all { head.len() } else { index::last_line_end(head, false).unwrap_or_default() };
        let head = head.get(..end).unwrap_or_default();
        let body = head.strip_prefix(MARK).unwrap_or(head);
        if body.trim_ascii().is_empty() {
            return Err(ImportErrorKind::Empty);
        }
        let source = Source {
            file: file_name.into(),
            bytes: head,
            sources: &Sources::default(),
            now: jiff::civil::DateTime::MIN,
        };
        match FORMATS.iter().find(|format| (format.recognises)(&source)) {
            Some(format) if format.name == "measurements" => {}
            Some(format) => return Err(ImportErrorKind::OtherFormat { format: format.message() }),
            None => return Err(ImportErrorKind::NotRecognised),
        }
        let decoded = utf8(body);
        let (text, first_line, separator) = without_separator_line(&decoded);
        let sample = Sample::of(text, first_line, separator);
        let columns = sample.columns()?;
        let separator = sample.separator;
        let above_header = decoded.len() - text.len();
        let rows = text.as_bytes();
        let Above { length, line, header, mut warnings } = match columns.header {
            Some(header) => Above::of(rows, separator, first_line, header),
            None => Above { line: first_line, ..Above::default() },
        };
        // A line with other names, or a title.
        let has_header = columns.header.is_some() && (columns.names_known || header.len() == columns.count);
        let names = (0..columns.count).map(|at| {
            let name = header.get(at).map(String::as_str).unwrap_or_default().trim();
            let name = name.split_whitespace().collect::<Vec<_>>().join(" ");
            if name.is_empty() || !has_header { format!("column_{}", at + 1) } else { name }
        });
        let names = names.collect();
        let line_end = match memchr::memchr2(b'\n', b'\r', rows).map(|at| rows.get(at..).unwrap_or_default()) {
            Some([b'\r', b'\n', ..]) => b"\r\n".as_slice(),
            Some([b'\r', ..]) => b"\r",
            _ => b"\n",
        };
        // The same bytes in the stream; where it is not UTF-8 each character of it was one byte.
        let above = decoded.get(..above_header + length).unwrap_or_default();
        let mark = head.len() - body.len();
        let is_utf8 = matches!(decoded, Cow::Borrowed(_)) || above.is_ascii();
        let skip = mark + if let Cow::Borrowed(_) = decoded { above.len() } else { above.chars().count() };
        let above = [if mark == 0 { &[] } else { MARK }, above.as_bytes()].concat();
        if has_header {
            // It is used after all.
            warnings.retain(|(at, _)| Some(*at) != columns.header);
        }
        Ok(Self {
            columns,
            separator,
            names,
            above,
            skip,
            line,
            has_rows: skip < head.len(),
            has_header,
            line_end,
            is_utf8,
            warnings,
        })
    }

    /// The separator of its cells.
    pub const fn separator(&self) -> u8 {
        self.separator
    }
}

/// Text of bytes: UTF-8 if they are, else Windows-1252.
pub(super) fn utf8(bytes: &[u8]) -> Cow<'_, str> {
    std::str::from_utf8(bytes).map_or_else(|_| Cow::Owned(windows_1252(bytes)), Cow::Borrowed)
}

/// The rows down to a header.
#[derive(Default)]
struct Above {
    /// How many bytes they have.
    length: usize,
    /// The line after them.
    line: usize,
    /// The cells of the header.
    header: Vec<String>,
    warnings: Vec<(usize, ImportWarningKind)>,
}

impl Above {
    fn of(text: &[u8], separator: u8, first_line: usize, header: usize) -> Self {
        /// A header is seldom further from the beginning.
        const MOSTLY: usize = 1 << 14;
        let mut ends = Index::default();
        let begin = text.get(..MOSTLY).unwrap_or(text);
        let _whole = ends.find_quoted(begin, separator, begin.len() == text.len());
        if ends.rows().count() <= header - first_line {
            let _whole = ends.find_quoted(text, separator, true);
        }
        let mut above = Self { line: first_line, ..Self::default() };
        for ends in ends.rows() {
            if header < above.line {
                break;
            }
            let row = Row::new(text, above.length, ends);
            let cells = row.record();
            if columns::is_comment(&cells) {
                if columns::is_data(&cells) {
                    above.warnings.push((above.line, ImportWarningKind::Comment));
                }
            } else if !columns::is_blank(&cells) {
                above.warnings.push((above.line, ImportWarningKind::not_used(&cells)));
            }
            above.header = cells.iter().map(str::to_owned).collect();
            above.length = row.next();
            above.line += row.lines();
        }
        above
    }
}
