//! Parquet in and out of `fitcheck batch`.

use std::io::{self, Write};

use crate::batch::parquet::Columns;
use crate::batch::{Failed, Input, Manner, Rendering, Summary, Watch, parquet};
use crate::exchange::ImportErrorKind;
use crate::exchange::batch::{Layout, StreamJudging, layout_of, output_fields};
use crate::exchange::parquet::{Field, Reader};

/// Whether this program knows Parquet.
pub(super) const IS_KNOWN: bool = true;

/// A file that can be read.
pub(super) type File = Reader<std::fs::File>;

/// Looks at the columns of a file and at its first rows.
pub(super) fn open(file: std::fs::File) -> Result<(File, Layout), ImportErrorKind> {
    let again = file.try_clone().map_err(|error| ImportErrorKind::Parquet { reason: error.to_string() })?;
    Ok((Reader::new(file)?, layout_of(Reader::new(again)?)?))
}

/// The declarations of the columns.
pub(super) fn types(file: &File) -> Vec<String> {
    file.fields().iter().map(Field::declaration).collect()
}

/// The columns that are judged and have binary fractions.
pub(super) fn floats(file: &File, layout: &Layout) -> Vec<String> {
    let judged = (0..).zip(file.fields()).filter(|(at, field)| layout.is_judged(*at) && field.is_float());
    judged.map(|(_, field)| field.name().to_owned()).collect()
}

/// Judges all rows of a file and writes them as text.
pub(super) fn into_text<R: Rendering>(
    file: File,
    court: &StreamJudging<'_>,
    manner: Manner<'_>,
    out: &mut (dyn Write + Send),
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    parquet::into_text::<R, _>(file, court, manner, out, watch, tick)
}

/// Writes a Parquet file.
pub(super) struct Writer<'o> {
    out: crate::exchange::parquet::Writer<&'o mut (dyn Write + Send)>,
    columns: Vec<Field>,
}

impl<'o> Writer<'o> {
    /// The columns of an input and those that are added.
    pub(super) fn new(
        out: &'o mut (dyn Write + Send),
        layout: &Layout,
        file: Option<&File>,
        prefix: &str,
    ) -> io::Result<Self> {
        let columns = output_fields(layout, file.map(Reader::fields), prefix)?;
        Ok(Self { out: crate::exchange::parquet::Writer::new(out, &columns)?, columns })
    }

    /// Judges all rows of a stream of CSV and writes them.
    pub(super) fn add_text(
        &mut self,
        input: Input<'_>,
        court: &StreamJudging<'_>,
        workers: usize,
        watch: &Watch,
        tick: &mut dyn FnMut(&Watch),
    ) -> Result<Summary, Failed> {
        let manner = Columns { columns: &self.columns, workers };
        parquet::from_text(input, court, manner, &mut self.out, watch, tick)
    }

    /// Judges all rows of a file and writes them.
    pub(super) fn add(
        &mut self,
        file: File,
        court: &StreamJudging<'_>,
        workers: usize,
        watch: &Watch,
        tick: &mut dyn FnMut(&Watch),
    ) -> Result<Summary, Failed> {
        let manner = Columns { columns: &self.columns, workers };
        parquet::through(file, court, manner, &mut self.out, watch, tick)
    }

    /// The end of the file.
    pub(super) fn finish(self) -> io::Result<()> {
        self.out.finish()
    }
}
