//! Rows of any kind, judged into text of any form.

use std::io::{self, Write};

use super::parquet;
use crate::batch::{self, Failed, Input, Manner, Rendering, Summary, Watch, WithRendering};
use crate::exchange::batch::{Court, Layout};

/// The rows of an input.
pub(super) enum Rows<'a> {
    Text(Input<'a>),
    Parquet(parquet::File),
}

/// Rows that are judged and written as text.
pub(super) struct Judging<'a> {
    pub rows: Rows<'a>,
    pub court: &'a Court<'a>,
    pub manner: Manner<'a>,
    pub out: &'a mut (dyn Write + Send),
    pub watch: &'a Watch,
    pub tick: &'a mut dyn FnMut(&Watch),
}

impl WithRendering for Judging<'_> {
    type Made = Result<Summary, Failed>;

    fn rendering<R: Rendering>(self) -> Self::Made {
        let Self { rows, court, manner, out, watch, tick } = self;
        match rows {
            Rows::Text(input) => batch::run::<R>(input, court, manner, out, watch, tick),
            Rows::Parquet(file) => parquet::into_text::<R>(file, court, manner, out, watch, tick),
        }
    }
}

/// What stands above the rows of an input is written.
pub(super) struct Above<'a> {
    pub layout: &'a Layout,
    pub manner: Manner<'a>,
    pub is_first: bool,
    pub out: &'a mut (dyn Write + Send),
}

impl WithRendering for Above<'_> {
    type Made = io::Result<()>;

    fn rendering<R: Rendering>(self) -> Self::Made {
        let Self { layout, manner, is_first, out } = self;
        let text = if is_first { R::above(layout, manner.prefix) } else { R::between(layout).to_vec() };
        let mut packed = Vec::new();
        if text.is_empty() { Ok(()) } else { out.write_all(manner.packing.pack(&text, &mut packed)?) }
    }
}
