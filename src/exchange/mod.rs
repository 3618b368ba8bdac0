//! Files of other tools: one source file per format, bytes in and bytes out.
//!
//! | file | what |
//! |---|---|
//! | `imported` | what was read from a file: records, and everything that did not become one |
//! | `error` | errors and warnings, with their places |
//! | `logs` | HEIDENHAIN measuring logs as records |
//! | `point_log` | logs of points as deviations along the normal |
//! | `contacts` | CSV of x, y and optionally z |
//! | `measurements`, `rules` | CSV of id, callout and measured value; what one row of it says |
//! | `sizes` | what was measured alone, of holes or of shafts |
//! | `columns`, `words`, `units` | which column of a CSV is which, by header or content; its unit |
//! | `own` | what a CSV of Fitcheck says of its values beside them |
//! | `cells` | what a cell or a row of a CSV seems to hold |
//! | `tables` | tables of deviations for controls and other tools |
//! | `sql` | limits and verdicts as plain SQL |
//! | `delimited` | rows and cells, with their lines |
//! | `parquet` | columns of typed values, with the feature of that name |
//! | `batch` | a verdict for every row of a stream of any length |
//!
//! A new format is one file here, its `mod` line and one in [`FORMATS`]; command line, dialogs and README follow from the list.
//! Nothing here opens a file: a name, bytes, tables and the time come in as arguments.

pub mod batch;
mod cells;
mod columns;
pub mod contacts;
mod delimited;
pub mod error;
pub mod imported;
mod logs;
mod measurements;
mod own;
#[cfg(feature = "parquet")]
pub mod parquet;
mod point_log;
mod rules;
mod sizes;
pub mod sql;
pub mod tables;
mod units;
mod words;

use std::borrow::Cow;
use std::sync::Arc;

use jiff::civil::DateTime;

pub use error::{ImportError, ImportErrorKind, ImportWarning, ImportWarningKind};
use imported::Sink;
pub use imported::{Coordinate, Imported, Item, Unjudged, WhyUnjudged};
pub use sizes::{Size, Sizes, SizesWarning, sizes};

use crate::control::text;
use crate::message::{Message, Say, display};
use crate::tolerance::Sources;

/// A format that measurements are read from.
#[derive(Debug, Clone, Copy)]
pub struct Format {
    /// The name on the command line.
    pub name: &'static str,
    /// File endings in lower case, without the point.
    pub endings: &'static [&'static str],
    /// The id of its one-line description.
    description: &'static str,
    recognises: fn(&Source<'_>) -> bool,
    read: fn(&Source<'_>, &mut Sink<'_>),
}

/// Every format, in the order in which they are asked whether they know a file.
pub const FORMATS: &[Format] = &[point_log::FORMAT, logs::FORMAT, CONTACTS, measurements::FORMAT];

/// Contacts of a probe: recognised here, read by their own file.
const CONTACTS: Format = Format {
    name: "contacts",
    endings: &["csv", "txt"],
    description: "exchange-format-contacts",
    recognises: |source| columns::are_contacts(&source.head()),
    read: read_contacts,
};

impl Format {
    /// Whether the file seems to be of this format, by its first 64 KiB and its name.
    pub fn recognises(&self, bytes: &[u8], file_name: &str) -> bool {
        let sources = Sources::default();
        (self.recognises)(&Source {
            file: file_name.into(),
            bytes,
            sources: &sources,
            now: DateTime::constant(1, 1, 1, 0, 0, 0, 0),
        })
    }
}

impl Say for Format {
    fn message(&self) -> Message {
        Message::new(self.description)
    }
}

display!(Format);

/// A file and what is needed to judge its contents.
struct Source<'a> {
    /// The file's name without its folder.
    file: Arc<str>,
    bytes: &'a [u8],
    sources: &'a Sources,
    now: DateTime,
}

/// How much of a file is examined to recognise it.
const HEAD: usize = 64 << 10;

impl Source<'_> {
    /// The text of the whole file: UTF-16 with a byte order mark, UTF-8, else Windows-1252.
    fn text(&self) -> Cow<'_, str> {
        decode(self.bytes)
    }

    /// The text of the file's beginning, in whole lines.
    fn head(&self) -> Cow<'_, str> {
        let Some(head) = self.bytes.get(..HEAD) else { return decode(self.bytes) };
        let end = head.iter().rposition(|&byte| byte == b'\n').map_or(HEAD, |end| end + 1);
        decode(head.get(..end).unwrap_or(head))
    }
}

fn decode(bytes: &[u8]) -> Cow<'_, str> {
    match encoding_rs::Encoding::for_bom(bytes) {
        // Spreadsheets save "Unicode text" this way.
        Some((encoding, _)) if encoding != encoding_rs::UTF_8 => encoding.decode(bytes).0,
        _ => text::decode(bytes),
    }
}

/// Reads measurements from a file of any known format and judges them.
///
/// Good rows become records; what cannot be used becomes an error with its line, and what cannot be judged is kept
/// apart: `rows` is the sum of the three, so nothing is lost. `now` is the time of records whose file has none.
///
/// ```
/// use fitcheck::tolerance::Sources;
///
/// let csv = b"id;callout;measured\nbore 1;25 H7;25,0l2\n";
/// let now = jiff::civil::date(2024, 3, 14).at(8, 5, 9, 0);
/// let imported = fitcheck::exchange::import("bores.csv", csv, &Sources::default(), now);
/// let error = imported.errors.first().map(ToString::to_string);
/// assert_eq!(error.as_deref(), Some("line 2, column 3: measured: 25,0l2 is not a number"));
/// ```
pub fn import(file_name: &str, bytes: &[u8], sources: &Sources, now: DateTime) -> Imported {
    let mut imported = Imported::default();
    import_each(file_name, bytes, sources, now, &mut |item| imported.keep(item));
    imported
}

/// The same one by one, in the order of the file: memory stays the same however many rows there are.
pub fn import_each(file_name: &str, bytes: &[u8], sources: &Sources, now: DateTime, take: &mut dyn FnMut(Item)) {
    let source = Source { file: file_name.into(), bytes, sources, now };
    let mut sink = Sink::new(take);
    if source.head().trim().is_empty() && bytes.len() <= HEAD {
        return sink.fail(ImportErrorKind::Empty);
    }
    match FORMATS.iter().find(|format| (format.recognises)(&source)) {
        Some(format) => (format.read)(&source, &mut sink),
        None => sink.fail(ImportErrorKind::NotRecognised),
    }
}

fn read_contacts(source: &Source<'_>, sink: &mut Sink<'_>) {
    match contacts::read(source.bytes) {
        Ok(read) => {
            let count = read.contacts.len();
            let unjudged = Unjudged {
                line: 1,
                id: String::new(),
                time: source.now,
                measured: None,
                position: None,
                why: WhyUnjudged::Contacts { count },
            };
            sink.set_aside(unjudged);
            sink.contacts(read.contacts);
        }
        Err(error) => sink.fail(ImportErrorKind::Contacts(Box::new(error))),
    }
}

/// The endings of all formats, each once, for file dialogs.
pub fn endings() -> Vec<&'static str> {
    let mut endings: Vec<&str> = FORMATS.iter().flat_map(|format| format.endings.iter().copied()).collect();
    endings.sort_unstable();
    endings.dedup();
    endings
}
