//! In place of `parquet` in programs built without the feature of that name: there is no file that can be read or written.

use std::io::{self, Write};

use crate::batch::{Failed, Input, Manner, Rendering, Summary, Watch};
use crate::exchange::ImportErrorKind;
use crate::exchange::batch::{Layout, StreamJudging};

/// Whether this program knows Parquet.
pub(super) const IS_KNOWN: bool = false;

/// There is none.
pub(super) enum File {}

/// Refuses a file.
pub(super) fn open(_file: std::fs::File) -> Result<(File, Layout), ImportErrorKind> {
    Err(ImportErrorKind::ParquetUnknown)
}

pub(super) fn types(file: &File) -> Vec<String> {
    match *file {}
}

pub(super) fn floats(file: &File, _layout: &Layout) -> Vec<String> {
    match *file {}
}

pub(super) fn into_text<R: Rendering>(
    file: File,
    _court: &StreamJudging<'_>,
    _manner: Manner<'_>,
    _out: &mut (dyn Write + Send),
    _watch: &Watch,
    _tick: &mut dyn FnMut(&Watch),
) -> Result<Summary, Failed> {
    match file {}
}

/// There is none.
pub(super) struct Writer<'o> {
    none: File,
    _out: &'o mut (dyn Write + Send),
}

impl<'o> Writer<'o> {
    /// Refuses; the command line has done so before.
    pub(super) fn new(
        _out: &'o mut (dyn Write + Send),
        _layout: &Layout,
        _file: Option<&File>,
        _prefix: &str,
    ) -> io::Result<Self> {
        Err(io::Error::other(ImportErrorKind::ParquetUnknown.to_string()))
    }

    pub(super) fn add_text(
        &mut self,
        _input: Input<'_>,
        _court: &StreamJudging<'_>,
        _workers: usize,
        _watch: &Watch,
        _tick: &mut dyn FnMut(&Watch),
    ) -> Result<Summary, Failed> {
        match self.none {}
    }

    pub(super) fn add(
        &mut self,
        file: File,
        _court: &StreamJudging<'_>,
        _workers: usize,
        _watch: &Watch,
        _tick: &mut dyn FnMut(&Watch),
    ) -> Result<Summary, Failed> {
        match file {}
    }

    pub(super) fn finish(self) -> io::Result<()> {
        match self.none {}
    }
}
