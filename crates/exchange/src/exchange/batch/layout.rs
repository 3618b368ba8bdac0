//! What the first rows of a stream say: where the rows begin and what their columns are.

use std::borrow::Cow;
use std::ops::Range;

use fitcheck_core::text::{Within as _, windows_1252};
use fitcheck_nc::control::simulated::is_mark;

use crate::exchange::cell::single_blanks;
use crate::exchange::column::listed;
use crate::exchange::columns::Columns;
use crate::exchange::delimited::without_separator_line;
use crate::exchange::error::{ImportErrorKind, ImportWarningKind};
use crate::exchange::index::{Index, LONGEST_ROW, last_line_end};
use crate::exchange::limits::LimitColumns;
use crate::exchange::mapping::Mapping;
use crate::exchange::row::TextRow;
use crate::exchange::sample::Sample;
use crate::exchange::{cells, known_format, left_out};

/// How much of a stream decides at most what its columns are: the longest row and a header.
pub const HEAD: usize = LONGEST_ROW + (256 << 10);

const MARK: &[u8] = b"\xef\xbb\xbf";

/// What is known of a stream before its rows are judged.
#[derive(Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each answers another question about the stream")]
pub struct Layout {
    pub(super) columns: Columns,
    pub(super) separator: u8,
    /// The names of the columns, or their numbers where the stream has no header.
    pub names: Vec<String>,
    /// Everything above the first row, with the header: UTF-8 with all line ends, and a byte order mark if there was one.
    pub(super) above: Vec<u8>,
    /// The comments in that: without what says how to read the stream, and without its header.
    pub(super) comments: Range<usize>,
    /// How many bytes stand above the first row in the stream.
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
    /// Whether the rows come from columns with types: what stands in a cell is a cell, whatever its signs would mean in CSV.
    pub(super) is_typed: bool,
    /// What is to be said of lines above the rows, which are passed on as they are, and of columns that no verdict depends on: the
    /// line, and a warning.
    pub warnings: Vec<(usize, ImportWarningKind)>,
}

/// Refuses values side by side: a row has one answer.
fn one_value(columns: &Columns) -> Result<(), ImportErrorKind> {
    let Some(first) = columns.sample_places().first().copied() else { return Ok(()) };
    Err(ImportErrorKind::SamplesSideBySide { columns: columns.samples_named.clone(), first: first + 1 })
}

impl Layout {
    /// The layout of a stream by its first bytes, which are all of it where `is_all`. Only whole lines count.
    ///
    /// # Errors
    /// Why nothing in it can be judged; with more of the stream, up to [`HEAD`], that may change.
    pub fn of(head: &[u8], is_all: bool, file_name: &str) -> Result<Self, ImportErrorKind> {
        Self::mapped(head, is_all, file_name, None)
    }

    /// The same with what the user says of the columns.
    ///
    /// # Errors
    /// As above, and what contradicts the mapping.
    pub fn mapped(
        head: &[u8],
        is_all: bool,
        file_name: &str,
        mapping: Option<&Mapping>,
    ) -> Result<Self, ImportErrorKind> {
        let open = Mapping::default();
        // Before the first line end nothing is whole.
        let end = if is_all { head.len() } else { last_line_end(head, false).unwrap_or(0) };
        let head = head.within(..end);
        let body = head.strip_prefix(MARK).unwrap_or(head);
        if body.trim_ascii().is_empty() {
            return Err(ImportErrorKind::Empty);
        }
        if mapping.is_none() {
            is_judged_by_rows(head, file_name)?;
        }
        let mapping = mapping.unwrap_or(&open);
        let decoded = utf8(body);
        let (text, first_line, separator) = without_separator_line(&decoded);
        let mut sample = Sample::of(text, first_line, mapping.separator().or(separator));
        let mut columns = mapping.columns(&mut sample)?;
        one_value(&columns)?;
        let separator = sample.separator;
        let above_header = decoded.len() - text.len();
        let rows = text.as_bytes();
        let Above { length, line, header, header_start, mut warnings } = match columns.header {
            Some(header) => Above::of(rows, separator, first_line, header),
            None => Above { line: first_line, ..Above::default() },
        };
        // Names over two rows are one.
        let merged = sample.rows.iter().find(|(line, _)| sample.top.is_some() && Some(*line) == columns.header);
        let header = merged.map_or(header, |(_, names)| names.iter().map(str::to_owned).collect());
        // A line with other names, or a title.
        let has_header = columns.header.is_some() && (columns.names_known || header.len() == columns.count);
        let names = (0..columns.count).map(|at| {
            let name = header.get(at).map_or("", |name| name.trim());
            let name = single_blanks(name);
            if name.is_empty() || !has_header { format!("column_{}", at + 1) } else { name }
        });
        let names = names.collect();
        let line_end = match memchr::memchr2(b'\n', b'\r', rows).map(|at| rows.within(at..)) {
            Some([b'\r', b'\n', ..]) => b"\r\n".as_slice(),
            Some([b'\r', ..]) => b"\r",
            _ => b"\n",
        };
        // The same bytes in the stream; where it is not UTF-8 each character of it was one byte.
        let above = decoded.within(..above_header + length);
        let mark = head.len() - body.len();
        let is_utf8 = matches!(decoded, Cow::Borrowed(_)) || above.is_ascii();
        let skip = mark + if let Cow::Borrowed(_) = decoded { above.len() } else { above.chars().count() };
        let above = [if mark == 0 { &[] } else { MARK }, above.as_bytes()].concat();
        // Without a header the comments above the first row are no lines above the rows.
        let is_above = |line: &&str| line.trim().is_empty() || line.trim_start().starts_with('#');
        columns.evidence.are_simulated =
            above.split(|byte| matches!(byte, b'\n' | b'\r')).any(|line| is_mark(&utf8(line)))
                || text.split(['\n', '\r']).take_while(is_above).any(is_mark);
        let comments = mark + above_header..mark + above_header + if has_header { header_start } else { length };
        if has_header {
            // It is used after all.
            warnings.retain(|(at, _)| Some(*at) != columns.header && Some(*at) != columns.top);
        }
        let told = columns.stated.told(columns.measured);
        warnings.retain(|(at, _)| told.as_ref().is_none_or(|(told, _)| told != at));
        warnings.extend(told);
        warnings.extend(skipped(&columns, first_line));
        Ok(Self {
            columns,
            separator,
            names,
            above,
            comments,
            skip,
            line,
            has_rows: skip < head.len(),
            has_header,
            line_end,
            is_utf8,
            is_typed: false,
            warnings,
        })
    }

    /// The layout of rows from columns with these names. `sample` has some of the rows as CSV with commas, under a line with
    /// the names, as all of `above`.
    ///
    /// # Errors
    /// Why nothing in them can be judged.
    pub(super) fn of_columns(names: Vec<String>, above: Vec<u8>, sample: &[u8]) -> Result<Self, ImportErrorKind> {
        // Other separators may occur in cells.
        let head = [b"sep=,\n", sample].concat();
        is_judged_by_rows(&head, "")?;
        let text = utf8(sample);
        let columns = Sample::of(&text, 1, Some(b',')).columns()?;
        one_value(&columns)?;
        let warnings = columns.stated.told(columns.measured).into_iter().chain(skipped(&columns, 1)).collect();
        Ok(Self {
            columns: Columns { count: names.len(), ..columns },
            separator: b',',
            names,
            above,
            comments: 0..0,
            skip: 0,
            line: 1,
            has_rows: true,
            has_header: true,
            line_end: b"\n",
            is_utf8: true,
            is_typed: true,
            warnings,
        })
    }

    /// Whether a decimal comma may have become a separator of cells.
    pub(super) const fn has_commas(&self) -> bool {
        self.separator == b',' && !self.is_typed
    }

    /// Whether a column gives limits; where none does, no row is judged.
    pub fn has_limits(&self) -> bool {
        self.columns.have_limits()
    }

    /// The number and name of a column of no known name that looks as if it had the callouts, where nothing else has limits.
    pub fn callouts_unnamed(&self) -> Option<&str> {
        self.columns.callouts_unnamed.as_deref()
    }

    /// Whether a verdict, or what is told of it, depends on what is in a column.
    pub fn is_judged(&self, at: usize) -> bool {
        let columns = &self.columns;
        columns.measured.at == at
            || columns.tolerance == Some(at)
            || columns.simulated == Some(at)
            || columns.evidence.origin == Some(at)
            || columns.own.deciding().contains(&Some(at))
            || columns.stated.columns.contains(&at)
            || columns.nominal.is_some_and(|nominal| nominal.at == at)
            || columns.limits.iter().flat_map(LimitColumns::iter).any(|column| column.at == at)
            || columns.evidence.word == Some(at)
            || columns.quantities.iter().any(|column| column.at == at)
            || columns.beside.iter().any(|column| column.at() == at)
    }

    /// Whether the judge reads a column with types: it is judged, or its text may say something against a value.
    pub fn needs(&self, at: usize, is_text: bool) -> bool {
        self.is_judged(at) || is_text && self.may_say(at)
    }

    /// Whether a column has a text that may say something against a value.
    fn may_say(&self, at: usize) -> bool {
        self.columns.remarks.iter().any(|column| column.at == at)
    }

    /// Whether the mark of a simulation stands above its rows.
    pub const fn are_simulated(&self) -> bool {
        self.columns.evidence.are_simulated
    }

    /// The separator of its cells.
    pub const fn separator(&self) -> u8 {
        self.separator
    }
}

/// The columns that are skipped or say nothing known, with the line of their names.
fn skipped(columns: &Columns, first_line: usize) -> impl Iterator<Item = (usize, ImportWarningKind)> {
    let names = listed(&columns.ignored);
    let warning = ImportWarningKind::IgnoredColumns { columns: names };
    let ignored = (!columns.ignored.is_empty()).then_some(warning);
    let line = columns.header.unwrap_or(first_line);
    ignored.into_iter().chain(columns.taken_as_sizes()).map(move |warning| (line, warning))
}

/// Whether a text is of the one format that can be judged row by row.
fn is_judged_by_rows(head: &[u8], file_name: &str) -> Result<(), ImportErrorKind> {
    match known_format(head, file_name) {
        Some(("measurements", _)) => Ok(()),
        Some((_, format)) => Err(ImportErrorKind::OtherFormat { format }),
        None => Err(ImportErrorKind::NotRecognised),
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
    /// Where it begins.
    header_start: usize,
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
            let row = TextRow::new(text, above.length, ends);
            let cells = row.record();
            if cells::is_comment(&cells) {
                let told = if cells::is_data(&cells) {
                    Some(ImportWarningKind::Comment)
                } else {
                    left_out::said_against(&cells, None)
                };
                above.warnings.extend(told.map(|told| (above.line, told)));
            } else if !cells::is_blank(&cells) {
                above.warnings.push((above.line, left_out::not_used(&cells, None)));
            }
            above.header_start = above.length;
            above.header = cells.iter().map(str::to_owned).collect();
            above.length = row.next();
            above.line += row.lines();
        }
        above
    }
}
