//! CSV in; CSV, TSV, JSON lines and what else is made of its rows out.

use std::io::{self, Read, Write};

use super::worker::Worker;
use super::{Failed, Manner, Packing, Rendering, Source, Summary, Watch, Watched, take_turns};
use crate::exchange::batch::{Block, Cutter, Judge, Marks, StreamJudging, Take, Tally};
use fitcheck_core::text::long;

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
    court: &StreamJudging<'_>,
    manner: Manner<'_>,
    out: &mut (dyn Write + Send),
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    let source = Blocks { input, bytes: 0 };
    take_turns(source, out, manner.workers, Watched { watch, tick }, || {
        let judge =
            |block: &mut Block, judge: &mut Judge<'_>, text: &mut Text<R>| text.of(|rows| judge.block(block, rows));
        Worker::new(court, Text::new(court, manner), judge, |text, _, _, out| text.write(out))
    })
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
    court: &StreamJudging<'_>,
    (workers, making): (usize, &(dyn Fn() -> M + Sync)),
    sink: &mut S,
    watch: &Watch,
    tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    take_turns(Blocks { input, bytes: 0 }, sink, workers, Watched { watch, tick }, || {
        let judge = |block: &mut Block, judge: &mut Judge<'_>, made: &mut M| {
            made.begin();
            judge.block(block, made)
        };
        Worker::new(court, making(), judge, |made, block, tally, sink: &mut S| sink.take(made, block, tally))
    })
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

/// The text of a portion's rows, packed as the output is.
pub(super) struct Text<R> {
    rendering: R,
    packing: Packing,
    packed: Vec<u8>,
    failed: Option<io::Error>,
}

impl<R: Rendering> Text<R> {
    pub(super) fn new(court: &StreamJudging<'_>, manner: Manner<'_>) -> Self {
        let rendering = R::new(court.layout(), manner.prefix);
        Self { rendering, packing: manner.packing, packed: Vec::new(), failed: None }
    }

    /// Begins with the rows that are judged now.
    pub(super) fn of(&mut self, judge: impl FnOnce(&mut R) -> Tally) -> Tally {
        self.rendering.out().clear();
        let tally = judge(&mut self.rendering);
        self.failed = self.packing.pack(self.rendering.out().bytes(), &mut self.packed).err();
        tally
    }

    pub(super) fn write<W: Write + ?Sized>(&mut self, out: &mut W) -> io::Result<()> {
        if let Some(error) = self.failed.take() {
            return Err(error);
        }
        let text = if self.packing == Packing::Plain { self.rendering.out().bytes() } else { &self.packed };
        // Whoever waits at the other end of a pipe gets what is there.
        out.write_all(text).and_then(|()| out.flush())
    }
}
