//! Files of other tools: one source file per format, bytes in and bytes out.
//!
//! | file | what |
//! |---|---|
//! | `source` | a file that is read, piece by piece or whole |
//! | `pieces` | the text of a file in pieces of whole lines |
//! | `imported` | what was read from a file: records, and everything that did not become one |
//! | `by_plan` | values judged by a plan: each finds its feature |
//! | `characteristic` | what files of other tools declare: a name, a nominal size, limits; its values judged by them |
//! | `error`, `warning` | errors and warnings, with their places |
//! | `given` | what was given, as messages repeat it |
//! | `role` | what a column can be |
//! | `no_place` | why the place of a feature is no position for a cycle |
//! | `logs` | HEIDENHAIN measuring logs as records |
//! | `plans` | part plans from files of other tools |
//! | `plan_tables` | part plans from tables |
//! | `point_log` | logs of points as deviations along the normal |
//! | `aqdef` | AQDEF of Q-DAS: `.dfq`, or `.dfd` and `.dfx` |
//! | `calypso` | tables of characteristics of CALYPSO |
//! | `protocol` | printed reports of CALYPSO |
//! | `geopak` | tolerances of GEOPAK (MCOSMOS) |
//! | `pcdmis` | text reports of PC-DMIS |
//! | `probed` | what probing macros of a control print |
//! | `printed` | what reports that were printed have in common |
//! | `foreign` | files that are known and not read |
//! | `qif` | QIF 2.0, 2.1 and 3.0: results and plans of measuring software |
//! | `xlsx` | workbooks of spreadsheets, read as rows of CSV |
//! | `gauge` | what a gauge types, and its lines in a file |
//! | `guarded` | a panic of a decoder as an error |
//! | `xml` | XML piece by piece, with lines and columns |
//! | `fn16` | what a control printed, read back through the mask that printed it |
//! | `contacts` | CSV of x, y and optionally z |
//! | `measurements`, `rules` | CSV of id, callout and measured value; what one row of it says |
//! | `refused` | a cell that cannot be used |
//! | `size`, `sizes` | what was measured alone, of holes or of shafts |
//! | `vocabulary`, `units`, `words` | the words of names of columns, the units beside them, what a name says |
//! | `series` | a series of parts: what words say of a part and of its values |
//! | `series_table` | tables of a control with a row for each part |
//! | `samples` | measured values side by side, in columns that are counted |
//! | `sample`, `column` | the first rows of a CSV; one column of it |
//! | `columns` | which column of a CSV is which, by header or content |
//! | `band` | the cell of a tolerance beside a nominal size |
//! | `beside`, `claim` | what stands beside a value and is compared with its answer: a status, limits, a deviation; its words |
//! | `warmth` | the temperature that a file says of a value, or of all |
//! | `evidence` | columns that say whether somebody measured, and whether a value is at 20 °C |
//! | `limits` | limits in columns of their own: as sizes or as deviations |
//! | `left_out` | what a line beside the measurements says against them |
//! | `remarks` | columns of no known name, in which a row may say something against its value |
//! | `head` | what the lines above a header say of all values |
//! | `headers` | a header among the rows, below which the columns may be others |
//! | `rivals` | which of several columns is the measured value, the nominal size, the callout: one, or none in silence |
//! | `quantity` | what a row says that was measured of its feature |
//! | `stated` | what a file states about units beside the names of its columns |
//! | `mapping` | which column is which as the user says |
//! | `lookup` | callouts that are read, and limits that are looked up, once for many rows |
//! | `own` | what a CSV of Fitcheck says of its values beside them |
//! | `cells` | what a cell or a row of a CSV seems to hold |
//! | `tables` | tables of deviations for controls and other tools |
//! | `sql` | limits and verdicts as plain SQL |
//! | `delimited` | rows and cells, with their lines |
//! | `index`, `row` | where the cells of some rows end; one row of them |
//! | `typed_value` | a value of a column with types, as text |
//! | `parquet` | columns of such values, with the feature of that name |
//! | `batch` | a verdict for every row of a stream of any length |
//!
//! Nothing here opens a file: a name, bytes, tables and the time come in as arguments.
//!
//! To add a reader of measurements:
//!
//! 1. Write a file or folder with its `FORMAT`. Add its `mod` line, its row above and its line in [`FORMATS`], before
//!    formats that would take its files, too: the first that recognises a file reads it.
//!    `calypso` is a small one to read first.
//! 2. Add `exchange-format-NAME` to `exchange.ftl` in every folder of `assets/locales`. An error that no variant of [`ImportErrorKind`]
//!    (`error.rs`) says is a new variant there, with its text.
//! 3. For every row, ask `sink.is_full(line)`, refuse a line beyond `LONGEST_ROW`, and hand out a record, something set aside or an error.
//!    Hand out `NoRows` where there was none.
//! 4. Give a value with limits of its own to `Characteristic::judge`; `context.lookup` finds the limits of a callout. Set a value without limits aside as [`WhyUnjudged::NoCallout`], or
//!    as `NotPositive` where it is zero or less: a plan judges it. `by_plan::is_plain` lists the reasons that a plan may overrule.
//! 5. Put what a device says of the status into the labels as a [`Claim`]; a contradiction is then reported by itself. Put what the file
//!    says was measured into `Labels::quantity`, so that no plan takes a width for a diameter.
//! 6. Set three fields for the watched folder:
//!
//!    | a file | `line_ends` | `has_marks` | `shows_end` |
//!    |---|---|---|---|
//!    | of lines, and may grow | `LINE_END_BYTES` | whether its content says what it is | true: a line without an end is not complete |
//!    | of lines, and may grow, but a line does not show that its value is complete (AQDEF) | `PLAIN_LINE_END_BYTES` | true | false |
//!    | read whole, and refused when it is cut off | none | true | true |
//!    | that shows nothing of its end | none | true | false |
//!
//! 7. Test it in `tests/core`, add a fuzz target (`fuzz/src/targets/mod.rs`), and add calls to `import.txt` and `plan.txt` of the corpus
//!    (`tests/core/corpus.rs`). No test asks for these calls.
//! 8. Describe it in `docs/manual/formats.md`, `docs/SOURCES.md` and `CHANGELOG.md`.
//!
//! Help, dialogs, `fitcheck watch` and the search for features by a plan follow. A format that declares characteristics is a reader that
//! makes `Characteristic`s and also gives them by `plan` of its [`Format`]; plans and the comparison of limits follow.
//!
//! Other formats: `tables` writes tables of deviations, `sql` dialects, `report` renderings.

pub mod aqdef;
mod band;
pub mod batch;
mod beside;
mod by_plan;
pub mod calypso;
mod cell;
mod cells;
mod characteristic;
pub mod claim;
mod column;
mod columns;
pub mod contacts;
mod delimited;
pub mod error;
mod evidence;
mod fn16;
mod foreign;
pub mod gauge;
mod geopak;
mod given;
mod guarded;
mod head;
pub mod headers;
mod imported;
mod index;
mod left_out;
mod limits;
mod logs;
mod lookup;
mod mapping;
mod measurements;
pub mod no_place;
mod own;
#[cfg(feature = "parquet")]
pub mod parquet;
mod pcdmis;
pub mod pieces;
mod plan_tables;
mod plans;
mod point_log;
mod printed;
mod probed;
mod protocol;
mod qif;
mod quantity;
mod refused;
mod remarks;
mod rivals;
mod role;
mod row;
mod rules;
mod sample;
mod samples;
mod series;
mod series_table;
mod size;
mod sizes;
mod source;
pub mod sql;
mod stated;
pub mod tables;
pub mod typed_value;
mod units;
mod vocabulary;
mod warmth;
mod warning;
mod words;
mod xlsx;
mod xml;

use std::io::Read as _;
use std::sync::Arc;

use jiff::civil::DateTime;

pub use by_plan::ByPlan;
use characteristic::Characteristics;
pub use claim::Claim;
pub use error::{ImportError, ImportErrorKind, ImportWarning, ImportWarningKind};
use fitcheck_core::message::{Message, Say, display};
use fitcheck_core::probing::Origin;
use fitcheck_core::tolerance::Sources;
use fitcheck_nc::control::mask::Mask;
use imported::Sink;
pub use imported::{
    Coordinate, Imported, Item, Labels, MOST_ROWS, StatedLimits, Unjudged, WhyUnjudged, part_and_feature,
};
pub use mapping::{
    Choice, ColumnUnit, DecimalSign, Detected, FirstRows, Kept, MOST_KEPT, Mapping, MappingError, Remembered, Separator,
};
pub use plans::{PLAN_ENDINGS, read_plan};
pub use quantity::Quantity;
pub use role::Role;
pub use size::Size;
pub use sizes::{Sizes, SizesWarning, sizes, sizes_from};
use source::{Beginning, Source};
pub use source::{Body, ImportInputs, WHOLE};

/// A format that measurements are read from.
#[derive(Debug, Clone, Copy)]
pub struct Format {
    /// The name on the command line.
    pub name: &'static str,
    /// File endings in lower case, without the point.
    pub endings: &'static [&'static str],
    /// The id of its one-line description.
    description: &'static str,
    recognises: fn(&Beginning<'_>) -> bool,
    /// Reads all of a file; an error is that of the whole file, and what was read before it counts.
    read: fn(&mut Source<'_>, &mut Sink<'_>) -> Result<(), ImportErrorKind>,
    /// The characteristics that a file of the format declares: the features of a plan.
    plan: Option<Declares>,
    /// The bytes that end a line (CR LF is one end) of a file that may grow: what stands in its lines stays there, and more lines come
    /// behind them. Nothing where no file grows so.
    pub line_ends: &'static [u8],
    /// Whether a file says by its content what it is; any text could be a table or contacts.
    pub has_marks: bool,
    /// Whether a file shows what of it is complete: what is cut off cannot be read, or is a line without an end.
    pub shows_end: bool,
}

/// Reads the characteristics that a file declares; an error is that of the whole file.
type Declares = fn(&mut Source<'_>, &mut Characteristics) -> Result<(), ImportErrorKind>;

/// Every format, in the order in which they are asked whether they know a file.
pub const FORMATS: &[Format] = &[
    fn16::FORMAT,
    xlsx::FORMAT,
    point_log::FORMAT,
    qif::FORMAT,
    aqdef::FORMAT,
    calypso::FORMAT,
    protocol::FORMAT,
    pcdmis::FORMAT,
    probed::FORMAT,
    logs::FORMAT,
    series_table::FORMAT,
    geopak::FORMAT,
    gauge::FORMAT,
    CONTACTS,
    measurements::FORMAT,
];

/// A format without its readers.
#[derive(Clone, Copy)]
struct Known {
    name: &'static str,
    description: &'static str,
    recognises: fn(&Beginning<'_>) -> bool,
}

/// Those of [`FORMATS`], in their order: where it is only asked of which one a file is, the readers of all are not compiled in.
static KNOWN: [Known; FORMATS.len()] = {
    let mut all = [Known { name: "", description: "", recognises: |_| false }; FORMATS.len()];
    let (mut formats, mut places) = (FORMATS, all.as_mut_slice());
    while let ([Format { name, description, recognises, .. }, more @ ..], [place, others @ ..]) = (formats, places) {
        *place = Known { name, description, recognises: *recognises };
        (formats, places) = (more, others);
    }
    all
};

/// The name of the format that a file seems to be of, by its first 64 KiB and its name, and what it is.
fn known_format(bytes: &[u8], file_name: &str) -> Option<(&'static str, Message)> {
    let beginning = Beginning::new(file_name, bytes);
    let known = KNOWN.iter().find(|format| (format.recognises)(&beginning))?;
    Some((known.name, Message::new(known.description)))
}

/// Contacts of a probe: recognised here, read by their own file.
const CONTACTS: Format = Format {
    name: "contacts",
    endings: &["csv", "txt"],
    description: "exchange-format-contacts",
    recognises: |beginning| contacts::are_contacts(&beginning.text()),
    read: read_contacts,
    plan: None,
    line_ends: b"",
    has_marks: false,
    shows_end: false,
};

impl Format {
    /// The masks that a file of it is read back through: these where a control printed it, else none.
    pub fn masks_of<'a>(&self, masks: &'a [(String, Mask)]) -> &'a [(String, Mask)] {
        if self.name == fn16::FORMAT.name { masks } else { &[] }
    }

    /// Whether a file of it may say no unit, and a mapping of the unit alone says it.
    pub fn takes_unit(&self) -> bool {
        MAY_SAY_NO_UNIT.iter().any(|format| format.name == self.name)
    }

    /// Whether the file seems to be of this format, by its first 64 KiB and its name.
    pub fn recognises(&self, bytes: &[u8], file_name: &str) -> bool {
        (self.recognises)(&Beginning::new(file_name, bytes))
    }
}

impl Say for Format {
    fn message(&self) -> Message {
        Message::new(self.description)
    }
}

display!(Format);

/// Reads measurements from a file of any known format and judges them.
///
/// Good rows become records; what cannot be used becomes an error with its line, and what cannot be judged is kept
/// apart: `rows` is the sum of the three, so nothing is lost. `now` is the time of records whose file has none. All of it is kept in
/// memory, so no more than [`MOST_ROWS`] rows are read; an error says so.
///
/// ```
/// use fitcheck_core::tolerance::Sources;
///
/// let csv = b"id;callout;measured\nbore 1;25 H7;25,0l2\n";
/// let now = jiff::civil::date(2024, 3, 14).at(8, 5, 9, 0);
/// let imported = fitcheck_exchange::exchange::import("bores.csv", csv, &Sources::default(), now);
/// let error = imported.errors.first().map(ToString::to_string);
/// assert_eq!(error.as_deref(), Some("line 2, column 3: measured: 25,0l2 is not a number"));
/// ```
pub fn import(file_name: &str, bytes: &[u8], sources: &Sources, now: DateTime) -> Imported {
    import_given(file_name, &mut std::io::Cursor::new(bytes), ImportInputs::new(sources, now))
}

/// The same of a file that may have another one beside it.
pub fn import_given(file_name: &str, body: &mut dyn Body, given: ImportInputs<'_>) -> Imported {
    let mut imported = Imported::default();
    let given = ImportInputs { most_rows: MOST_ROWS, ..given };
    import_from(file_name, body, given, &mut |item| imported.keep(item));
    imported
}

/// The same one by one, in the order of the file: memory stays the same however many rows there are.
pub fn import_each(file_name: &str, bytes: &[u8], sources: &Sources, now: DateTime, take: &mut dyn FnMut(Item)) {
    import_from(file_name, &mut std::io::Cursor::new(bytes), ImportInputs::new(sources, now), take);
}

/// The same from a file that is read piece by piece, where its format allows it.
pub fn import_from(file_name: &str, body: &mut dyn Body, given: ImportInputs<'_>, take: &mut dyn FnMut(Item)) {
    let now = given.now;
    let mut take = |mut item: Item| {
        match &mut item {
            Item::Record { record, labels, .. } => labels.time = Some(record.time).filter(|time| *time != now),
            Item::Unjudged(unjudged) => unjudged.labels.time = Some(unjudged.time).filter(|time| *time != now),
            Item::Error(_) | Item::Warning(_) | Item::Contacts(_) => {}
        }
        take(item);
    };
    let mut sink = Sink::up_to(given.most_rows, &mut take).telling(given.units);
    let read = Source::new(file_name, body, given).and_then(|mut source| {
        if source.is_blank() {
            return Err(ImportErrorKind::Empty);
        }
        let format = match given.masks {
            [] if let Some(mapping) = given.mapping => {
                of_mapping(mapping).into_iter().find(|format| (format.recognises)(&source.beginning()))
            }
            [] => FORMATS.iter().find(|format| (format.recognises)(&source.beginning())),
            _ => Some(&fn16::FORMAT),
        };
        let foreign = foreign::known(&source.beginning());
        match (format, foreign.filter(|_| format.is_none_or(|format| !format.has_marks))) {
            (_, Some(foreign)) => Err(foreign),
            (Some(format), None) => (format.read)(&mut source, &mut sink),
            (None, None) => Err(ImportErrorKind::NotRecognised),
        }
    });
    if let Err(kind) = read {
        sink.fail(kind);
    }
}

/// The formats whose files may say no unit.
const MAY_SAY_NO_UNIT: [&Format; 7] = [
    &calypso::FORMAT,
    &protocol::FORMAT,
    &pcdmis::FORMAT,
    &probed::FORMAT,
    &geopak::FORMAT,
    &gauge::FORMAT,
    &series_table::FORMAT,
];

/// The formats that a mapping can be of: tables, and where it says the unit alone those that may say none.
fn of_mapping(mapping: &Mapping) -> Vec<&'static Format> {
    let by_unit: &[&Format] = if mapping.says_unit_alone() { &MAY_SAY_NO_UNIT } else { &[] };
    [&xlsx::FORMAT].into_iter().chain(by_unit.iter().copied()).chain([&measurements::FORMAT]).collect()
}

/// The cells of the first sheet of a workbook (XLSX) that has any, as texts: each row with its number from 1.
///
/// # Errors
/// Why the bytes are not a workbook, or cannot be read.
pub fn sheet_rows(bytes: &[u8]) -> Result<Vec<(usize, Vec<String>)>, ImportErrorKind> {
    let mut body = std::io::Cursor::new(bytes);
    let sources = Sources::default();
    xlsx::sheet_rows(&mut Source::new("", &mut body, ImportInputs::new(&sources, DateTime::MIN))?)
}

fn read_contacts(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let bytes = source.whole()?;
    let read = contacts::read(&bytes).map_err(|error| ImportErrorKind::Contacts(Box::new(error)))?;
    sink.set_aside(Unjudged {
        line: 1,
        id: String::new(),
        labels: Labels::default(),
        time: source.context.now,
        measured: None,
        origin: Origin::Contacts { file: Arc::clone(&source.context.file) },
        position: None,
        asked: StatedLimits::default(),
        correction: None,
        why: WhyUnjudged::Contacts { count: read.contacts.len() },
    });
    if let Some(told) = read.told_of_temperature(source.context.counted) {
        sink.warn(fitcheck_core::message::FilePlace::default(), None, told);
    }
    sink.contacts(read.contacts);
    Ok(())
}

/// The format that a file seems to be of; that of prints where one of the masks, or several, seem to have printed it. It is at its
/// beginning afterwards.
///
/// # Errors
/// What the system says.
pub fn recognised(
    file_name: &str,
    body: &mut dyn Body,
    masks: &[(String, Mask)],
) -> std::io::Result<Option<&'static Format>> {
    let mut head = Vec::new();
    body.rewind()?;
    let most = source::HEAD.try_into().unwrap_or(u64::MAX);
    body.take(most).read_to_end(&mut head)?;
    body.rewind()?;
    let format = FORMATS.iter().find(|format| format.recognises(&head, file_name));
    let is_printed =
        !format.is_some_and(|format| format.has_marks) && fn16::fits(masks, &Beginning::new(file_name, &head));
    Ok(if is_printed { Some(&fn16::FORMAT) } else { format })
}

/// The endings of all formats, each once, for file dialogs.
pub fn endings() -> Vec<&'static str> {
    let mut endings: Vec<&str> = FORMATS.iter().flat_map(|format| format.endings.iter().copied()).collect();
    endings.sort_unstable();
    endings.dedup();
    endings
}
