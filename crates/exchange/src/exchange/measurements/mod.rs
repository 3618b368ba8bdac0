//! CSV of id, callout and measured value, with or without a header.
//!
//! Separator, decimal sign and columns are detected by the first rows; what could be meant in two ways is refused. The text is read in
//! pieces of whole lines, and a row that spans two of them is read with the second: a file of any size takes the memory of one piece.
//!
//! | file | what |
//! |---|---|
//! | here | the file as a whole |
//! | `reader` | its rows |
//! | `time` | when they were measured |

mod reader;
mod time;

use crate::exchange::columns::Columns;
use crate::exchange::delimited::{Rows, without_separator_line};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::imported::Sink;
use crate::exchange::mapping::Mapping;
use crate::exchange::pieces::Pieces;
use crate::exchange::sample::{NO_SEPARATOR, Sample};
use crate::exchange::size::SizesOf;
use crate::exchange::source::{Context, Source, WHOLE};
use crate::exchange::{Format, stated};
use csv::StringRecord;
use reader::{NOTHING, Reader};
use std::borrow::Cow;
pub(super) use time::date_time;

/// The bytes that end a row.
pub(super) const LINE_ENDS: &[u8] = b"\n\r";

pub(super) const FORMAT: Format = Format {
    name: "measurements",
    endings: &["csv", "tsv", "txt"],
    description: "exchange-format-measurements",
    recognises: |beginning| is_text(&beginning.text()),
    read,
    plan: None,
    line_ends: LINE_ENDS,
    has_marks: false,
    shows_end: true,
};

/// Text, not arbitrary bytes: at most one of fifty characters is a control character.
fn is_text(head: &str) -> bool {
    let odd = head.chars().filter(|c| c.is_control() && !"\t\r\n".contains(*c)).count();
    odd * 50 <= head.chars().count()
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    read_rows(source, sink, None)
}

/// Reads the measured sizes alone: limits are not looked up.
pub(super) fn read_sizes(
    source: &mut Source<'_>,
    sink: &mut Sink<'_>,
    sizes: SizesOf<'_>,
) -> Result<(), ImportErrorKind> {
    read_rows(source, sink, Some(sizes))
}

fn read_rows(source: &mut Source<'_>, sink: &mut Sink<'_>, sizes: Option<SizesOf<'_>>) -> Result<(), ImportErrorKind> {
    let context = source.context.clone();
    let mapping = source.given.mapping;
    let detects = Mapping::default();
    let has_plan = source.given.has_plan;
    // What is stated behind the last row holds for the first one as well.
    let unit_lines = stated::unit_lines(&mut source.pieces(LINE_ENDS)?);
    let mut pieces = source.pieces(LINE_ENDS)?;
    let head = head(&mut pieces)?;
    let (text, first_line, separator) = without_separator_line(&head);
    let mapping = mapping.unwrap_or(&detects);
    let mut sample = Sample::of(text, first_line, mapping.separator().or(separator));
    let separator = sample.separator;
    let columns = mapping.columns(&mut sample)?;
    stated::agree(&columns, &unit_lines)?;
    // The first rows are read once more with the rest.
    drop(sample);
    let mut reader = Reader::new(&context, (&columns, separator, has_plan), sink).of(sizes);
    reader.warn_of_columns(first_line);
    let mut rows = Rows::new(text, first_line, separator).going_on(true);
    let mut next = reader.rows(&mut rows);
    let mut rest = rows.rest().to_owned();
    drop(head);
    let mut goes_on = true;
    while goes_on && let Some(line) = next {
        let piece = pieces.next()?;
        goes_on = piece.is_some();
        // Behind the last piece only the rest of it is left.
        let piece = piece.unwrap_or(Cow::Borrowed(""));
        let text = if rest.is_empty() { piece } else { Cow::Owned(std::mem::take(&mut rest) + &piece) };
        let mut rows = Rows::after(&text, line, separator).going_on(goes_on);
        next = reader.rows(&mut rows);
        rows.rest().clone_into(&mut rest);
    }
    if reader.sink.rows() == 0 {
        reader.refuse(first_line, NOTHING, ImportErrorKind::NoRows);
    }
    reader.tell_all_nominal(first_line);
    Ok(())
}

/// Reads the rows of a file that has cells as such; a row is not known to be the last one.
pub(super) struct CellsReader<'a, 's, 'z>(Reader<'a, 's, 'z>);

impl<'a, 's, 'z> CellsReader<'a, 's, 'z> {
    pub(super) fn new(
        source: &'a Context<'a>,
        columns: &'a Columns,
        has_plan: bool,
        sink: &'a mut Sink<'s>,
        sizes: Option<SizesOf<'z>>,
    ) -> Self {
        let separator = NO_SEPARATOR;
        let mut reader = Reader::new(source, (columns, separator, has_plan), sink).of(sizes);
        reader.warn_of_columns(1);
        Self(reader)
    }

    /// Reads a row; `false` where no more are wanted.
    pub(super) fn row(&mut self, line: usize, cells: &StringRecord) -> bool {
        if self.0.sink.is_full(line) {
            return false;
        }
        self.0.row(line, cells);
        true
    }

    /// Tells it where no row held anything.
    pub(super) fn end(mut self) {
        if self.0.sink.rows() == 0 {
            self.0.refuse(1, NOTHING, ImportErrorKind::NoRows);
        }
        self.0.tell_all_nominal(1);
    }
}

/// Reads some rows of a file of which no more are known.
pub(super) fn read_these<'r>(
    source: &Context<'_>,
    (columns, separator, has_plan): (&Columns, u8, bool),
    rows: impl Iterator<Item = &'r (usize, StringRecord)>,
    sink: &mut Sink<'_>,
) {
    let mut reader = Reader::new(source, (columns, separator, has_plan), sink);
    for (line, cells) in rows {
        reader.row(*line, cells);
    }
}

/// The beginning of a text, by which its columns are known: down to rows below comments and header.
pub(super) fn head(pieces: &mut Pieces<'_>) -> Result<String, ImportErrorKind> {
    let most = WHOLE.try_into().unwrap_or(usize::MAX);
    let mut head = String::new();
    while let Some(piece) = pieces.next()? {
        head.push_str(&piece);
        let (text, first_line, separator) = without_separator_line(&head);
        if most < head.len() || Sample::of(text, first_line, separator).has_data() {
            break;
        }
    }
    Ok(head)
}

/// Reads a single row whose columns are known, as one of a whole file.
pub(super) fn read_row(
    source: &Context<'_>,
    (columns, separator): (&Columns, u8),
    (line, cells): (usize, &StringRecord),
    sink: &mut Sink<'_>,
) {
    let mut reader = Reader::new(source, (columns, separator, false), sink);
    if let Err((cell, reason)) = reader.measurement(line, cells) {
        reader.refuse(line, cell, reason);
    }
}
