//! CSV in; CSV, TSV, JSON lines and what else is made of its rows out.

use std::io::{self, Read, Write};
use std::marker::PhantomData;

use super::{Failed, Manner, Packing, Rendering, Source, Summary, Watch, Watched, Work, take_turns};
use crate::exchange::batch::{Block, Court, Cutter, Judge, Marks, Take, Tally};
use crate::within::long;

/// Where the rows come from.
pub struct Input<'a> {
    /// The stream, from its first row on.
    pub stream: &'a mut (dyn Read + Send),
    /// What cuts it into blocks.
    pub cutter: Cutter,
}

/// Judges all rows of a stream and writes them in their order. `tick` is called ten times a second meanwhile.
///
/// # Errors
/// [`Failed`] says which side failed first.
pub fn run<R: Rendering>(
    input: Input<'_>,
    court: &Court<'_>,
    manner: Manner<'_>,
    out: &mut (dyn Write + Send),
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    let source = Blocks { input, bytes: 0 };
    let judge = |portion: &mut Block, judge: &mut Judge<'_>, take: &mut R| judge.block(portion, take);
    let mut out = out;
    take_turns(source, &mut out, manner.workers, Watched { watch, tick }, || Texts::new(court, manner, judge))
}

/// What a worker makes of each block.
pub trait Making: Take {
    /// Begins a block.
    fn begin(&mut self);
}

impl Making for Marks {
    fn begin(&mut self) {
        self.clear();
    }
}

/// Where that goes, block by block in the order of the stream.
pub trait Sink<M: Making>: Send {
    /// Takes what was made of a block.
    ///
    /// # Errors
    /// Why nothing more can be taken.
    fn take(&mut self, made: &mut M, block: &Block, tally: &Tally) -> io::Result<()>;
}

/// Judges all rows of a stream: each worker makes something of its blocks, and a sink takes it in the order of the
/// stream. `tick` is called ten times a second meanwhile.
///
/// # Errors
/// [`Failed`] says which side failed first.
pub fn run_into<M: Making, S: Sink<M>>(
    input: Input<'_>,
    court: &Court<'_>,
    (workers, making): (usize, &(dyn Fn() -> M + Sync)),
    sink: &mut S,
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    let hire = || Maker { judge: court.judge(), made: making(), sinks: PhantomData };
    take_turns(Blocks { input, bytes: 0 }, sink, workers, Watched { watch, tick }, hire)
}

/// A worker that makes something.
struct Maker<'c, M, S> {
    judge: Judge<'c>,
    made: M,
    sinks: PhantomData<fn(S)>,
}

impl<'c, M: Making, S: Sink<M>> Work<'c> for Maker<'c, M, S> {
    type Portion = Block;
    type Sink = S;

    fn judge(&mut self, portion: &mut Block) -> Tally {
        self.made.begin();
        self.judge.block(portion, &mut self.made)
    }

    fn write(&mut self, portion: &Block, tally: &Tally, sink: &mut S) -> io::Result<()> {
        sink.take(&mut self.made, portion, tally)
    }

    fn end(self) -> Judge<'c> {
        self.judge
    }
}

/// A stream in blocks.
pub(super) struct Blocks<'a> {
    pub(super) input: Input<'a>,
    pub(super) bytes: u64,
}

impl Source for Blocks<'_> {
    type Portion = Block;

    fn next(&mut self, portion: &mut Block) -> io::Result<bool> {
        let Input { stream, cutter } = &mut self.input;
        let is_there = cutter.next(*stream, portion)?;
        self.bytes += long(portion.len());
        Ok(is_there)
    }

    fn bytes(&self) -> u64 {
        self.bytes
    }
}

/// A worker that writes text.
pub(super) struct Texts<'c, 'o, R, P, J> {
    judge: Judge<'c>,
    rendering: R,
    packing: Packing,
    packed: Vec<u8>,
    failed: Option<io::Error>,
    of_portion: J,
    streams: PhantomData<fn(P, &'o ())>,
}

impl<'c, R: Rendering, P, J: Fn(&mut P, &mut Judge<'_>, &mut R) -> Tally> Texts<'c, '_, R, P, J> {
    /// `of_portion` judges the rows of a portion.
    pub(super) fn new(court: &'c Court<'_>, manner: Manner<'_>, of_portion: J) -> Self {
        Self {
            judge: court.judge(),
            rendering: R::new(court.layout(), manner.prefix),
            packing: manner.packing,
            packed: Vec::new(),
            failed: None,
            of_portion,
            streams: PhantomData,
        }
    }
}

impl<'c, 'o, R: Rendering, P, J: Fn(&mut P, &mut Judge<'_>, &mut R) -> Tally> Work<'c> for Texts<'c, 'o, R, P, J> {
    type Portion = P;
    type Sink = &'o mut (dyn Write + Send);

    fn judge(&mut self, portion: &mut P) -> Tally {
        self.rendering.out().clear();
        let tally = (self.of_portion)(portion, &mut self.judge, &mut self.rendering);
        self.failed = self.packing.pack(self.rendering.out().bytes(), &mut self.packed).err();
        tally
    }

    fn write(&mut self, _portion: &P, _tally: &Tally, sink: &mut Self::Sink) -> io::Result<()> {
        if let Some(error) = self.failed.take() {
            return Err(error);
        }
        let text = if self.packing == Packing::Plain { self.rendering.out().bytes() } else { &self.packed };
        // Whoever waits at the other end of a pipe gets what is there.
        sink.write_all(text).and_then(|()| sink.flush())
    }

    fn end(self) -> Judge<'c> {
        self.judge
    }
}
