//! Parquet in and out.

use std::io::{self, Write};

use super::text::{Blocks, Texts};
use super::{Failed, Input, Manner, Rendering, Source, Summary, Watch, Watched, Work, take_turns};
use crate::exchange::batch::{Answers, Block, Court, Judge, Purpose, Tally, Typed};
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
    court: &Court<'_>,
    manner: Manner<'_>,
    out: &mut (dyn Write + Send),
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    let fields = file.fields().to_vec();
    let judge =
        |typed: &mut Typed, judge: &mut Judge<'_>, take: &mut R| typed.judge(&fields, Purpose::Text, judge, take);
    let source = Portions { file, purpose: Purpose::Text };
    let mut out = out;
    take_turns(source, &mut out, manner.workers, Watched { watch, tick }, || Texts::new(court, manner, judge))
}

/// Judges all rows of a Parquet file and writes them as row groups with these columns, in their order.
///
/// # Errors
/// [`Failed`] says which side failed first.
pub fn through<F: ChunkReader + 'static, W: Write + Send>(
    file: Reader<F>,
    court: &Court<'_>,
    manner: Columns<'_>,
    out: &mut Writer<W>,
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    let fields = file.fields().to_vec();
    let make = |typed: &mut Typed, judge: &mut Judge<'_>, answers: &mut Answers| {
        let tally = typed.judge(&fields, Purpose::Columns, judge, answers);
        (tally, answers.group(Some(typed)))
    };
    let source = Portions { file, purpose: Purpose::Columns };
    take_turns(source, out, manner.workers, Watched { watch, tick }, || Groups::new(court, manner, 0, make))
}

/// Judges all rows of a stream of CSV and writes them as row groups with these columns, in their order.
///
/// # Errors
/// [`Failed`] says which side failed first.
pub fn from_text<W: Write + Send>(
    input: Input<'_>,
    court: &Court<'_>,
    manner: Columns<'_>,
    out: &mut Writer<W>,
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    let texts = court.layout().names.len();
    let make = |block: &mut Block, judge: &mut Judge<'_>, answers: &mut Answers| {
        let tally = judge.block(block, answers);
        (tally, answers.group(None))
    };
    let source = Blocks { input, bytes: 0 };
    take_turns(source, out, manner.workers, Watched { watch, tick }, || Groups::new(court, manner, texts, make))
}

/// A worker that writes row groups: one of each portion.
struct Groups<'c, P, M, W> {
    judge: Judge<'c>,
    answers: io::Result<Answers>,
    group: io::Result<Option<Group>>,
    make: M,
    streams: std::marker::PhantomData<fn(P, W)>,
}

impl<'c, P, M, W> Groups<'c, P, M, W>
where
    M: Fn(&mut P, &mut Judge<'_>, &mut Answers) -> (Tally, io::Result<Option<Group>>),
{
    /// `texts` of the columns come from text; `make` judges a portion and makes its row group.
    fn new(court: &'c Court<'_>, manner: Columns<'_>, texts: usize, make: M) -> Self {
        let answers = Answers::new(manner.columns, texts);
        Self { judge: court.judge(), answers, group: Ok(None), make, streams: std::marker::PhantomData }
    }
}

impl<'c, P, M, W> Work<'c> for Groups<'c, P, M, W>
where
    M: Fn(&mut P, &mut Judge<'_>, &mut Answers) -> (Tally, io::Result<Option<Group>>),
    W: Write + Send,
{
    type Portion = P;
    type Sink = Writer<W>;

    fn judge(&mut self, portion: &mut P) -> Tally {
        match &mut self.answers {
            Ok(answers) => {
                let (tally, group) = (self.make)(portion, &mut self.judge, answers);
                self.group = group;
                tally
            }
            Err(error) => {
                self.group = Err(io::Error::new(error.kind(), error.to_string()));
                Tally::default()
            }
        }
    }

    fn write(&mut self, _portion: &P, _tally: &Tally, sink: &mut Writer<W>) -> io::Result<()> {
        match std::mem::replace(&mut self.group, Ok(None))? {
            Some(group) => sink.write(group),
            None => Ok(()),
        }
    }

    fn end(self) -> Judge<'c> {
        self.judge
    }
}
