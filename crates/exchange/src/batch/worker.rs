//! A worker of a run: it makes something of each portion, which is written in the order of the rows.

use std::io;
use std::marker::PhantomData;

use super::Work;
use crate::exchange::batch::{Judge, StreamJudging, Tally};

/// What a worker keeps from one portion to the next, how it judges one, and how it writes what it made of it.
pub(super) struct Worker<'c, P, M, J, W, K: ?Sized> {
    judge: Judge<'c>,
    made: M,
    of_portion: J,
    into: W,
    portions: PhantomData<fn(P)>,
    sink: PhantomData<fn(&K)>,
}

impl<'c, P, M, J, W, K> Worker<'c, P, M, J, W, K>
where
    J: Fn(&mut P, &mut Judge<'_>, &mut M) -> Tally,
    W: Fn(&mut M, &P, &Tally, &mut K) -> io::Result<()>,
    K: ?Sized,
{
    pub(super) fn new(court: &'c StreamJudging<'_>, made: M, of_portion: J, into: W) -> Self {
        Self { judge: court.judge(), made, of_portion, into, portions: PhantomData, sink: PhantomData }
    }
}

impl<'c, P, M, J, W, K> Work<'c> for Worker<'c, P, M, J, W, K>
where
    J: Fn(&mut P, &mut Judge<'_>, &mut M) -> Tally,
    W: Fn(&mut M, &P, &Tally, &mut K) -> io::Result<()>,
    K: ?Sized + Send,
{
    type Portion = P;
    type Sink = K;

    fn judge(&mut self, portion: &mut P) -> Tally {
        (self.of_portion)(portion, &mut self.judge, &mut self.made)
    }

    fn write(&mut self, portion: &P, tally: &Tally, sink: &mut K) -> io::Result<()> {
        (self.into)(&mut self.made, portion, tally, sink)
    }

    fn end(self) -> Judge<'c> {
        self.judge
    }
}
