//! Parquet in and out.

use std::io::{self, Write};

use super::text::{Blocks, Text};
use super::worker::Worker;
use super::{Failed, Input, Manner, Rendering, Source, Summary, Watch, Watched, take_turns};
use crate::exchange::batch::{Answers, Block, Judge, Purpose, StreamJudging, Tally, Typed};
use crate::exchange::parquet::{ChunkReader, Field, Group, Reader, Writer};

/// How a run that writes Parquet is done.
#[derive(Debug, Clone, Copy)]
pub struct Columns<'a> {
    /// The columns of the output.
    pub columns: &'a [Field],
    /// How many workers judge at the same time, at least one.
    pub workers: usize,
}

/// The rows of a file.
struct Portions<R: ChunkReader> {
    file: Reader<R>,
    purpose: Purpose,
}

impl<R: ChunkReader + 'static> Source for Portions<R>
where
    Reader<R>: Send,
{
    type Portion = Typed;

    fn next(&mut self, portion: &mut Typed) -> io::Result<bool> {
        portion.read(&mut self.file, self.purpose)
    }

    fn bytes(&self) -> u64 {
        self.file.bytes()
    }
}

/// Judges all rows of a Parquet file and writes them as text, in their order.
///
/// # Errors
/// [`Failed`] says which side failed first.
pub fn into_text<R: Rendering, F: ChunkReader + 'static>(
    file: Reader<F>,
    court: &StreamJudging<'_>,
    manner: Manner<'_>,
    out: &mut (dyn Write + Send),
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    let fields = file.fields().to_vec();
    let source = Portions { file, purpose: Purpose::Text };
    take_turns(source, out, manner.workers, Watched { watch, tick }, || {
        let judge = |typed: &mut Typed, judge: &mut Judge<'_>, text: &mut Text<R>| {
            text.of(|rows| typed.judge(&fields, Purpose::Text, judge, rows))
        };
        Worker::new(court, Text::new(court, manner), judge, |text, _, _, out| text.write(out))
    })
}

/// Judges all rows of a Parquet file and writes them as row groups with these columns, in their order.
///
/// # Errors
/// [`Failed`] says which side failed first.
pub fn through<F: ChunkReader + 'static, W: Write + Send>(
    file: Reader<F>,
    court: &StreamJudging<'_>,
    manner: Columns<'_>,
    out: &mut Writer<W>,
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    let fields = file.fields().to_vec();
    let source = Portions { file, purpose: Purpose::Columns };
    take_turns(source, out, manner.workers, Watched { watch, tick }, || {
        let judge = |typed: &mut Typed, judge: &mut Judge<'_>, rows: &mut RowGroup| {
            rows.of(|answers| (typed.judge(&fields, Purpose::Columns, judge, answers), answers.group(Some(typed))))
        };
        Worker::new(court, RowGroup::new(manner, 0), judge, |rows, _, _, out| rows.write(out))
    })
}

/// Judges all rows of a stream of CSV and writes them as row groups with these columns, in their order.
///
/// # Errors
/// [`Failed`] says which side failed first.
pub fn from_text<W: Write + Send>(
    input: Input<'_>,
    court: &StreamJudging<'_>,
    manner: Columns<'_>,
    out: &mut Writer<W>,
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    let texts = court.layout().names.len();
    let source = Blocks { input, bytes: 0 };
    take_turns(source, out, manner.workers, Watched { watch, tick }, || {
        let judge = |block: &mut Block, judge: &mut Judge<'_>, rows: &mut RowGroup| {
            rows.of(|answers| (judge.block(block, answers), answers.group(None)))
        };
        Worker::new(court, RowGroup::new(manner, texts), judge, |rows, _, _, out| rows.write(out))
    })
}

/// The row group of a portion.
struct RowGroup {
    answers: io::Result<Answers>,
    group: io::Result<Option<Group>>,
}

impl RowGroup {
    /// `texts` of the columns come from text.
    fn new(manner: Columns<'_>, texts: usize) -> Self {
        Self { answers: Answers::new(manner.columns, texts), group: Ok(None) }
    }

    /// `make` judges the rows and makes a row group of them.
    fn of(&mut self, make: impl FnOnce(&mut Answers) -> (Tally, io::Result<Option<Group>>)) -> Tally {
        match &mut self.answers {
            Ok(answers) => {
                let (tally, group) = make(answers);
                self.group = group;
                tally
            }
            Err(error) => {
                self.group = Err(io::Error::new(error.kind(), error.to_string()));
                Tally::default()
            }
        }
    }

    fn write<W: Write + Send>(&mut self, out: &mut Writer<W>) -> io::Result<()> {
        match std::mem::replace(&mut self.group, Ok(None))? {
            Some(group) => out.write(group),
            None => Ok(()),
        }
    }
}
