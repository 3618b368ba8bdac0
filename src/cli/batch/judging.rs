//! Rows of any kind, judged into text of any form.

use std::io::{self, Write};

use super::parquet;
use crate::batch::{self, Failed, Input, Manner, Rendering, Summary, Watch, WithRendering};
use crate::exchange::batch::{Layout, StreamJudging};

/// The rows of an input.
pub(super) enum Rows<'a> {
    Text(Input<'a>),
    Parquet(parquet::File),
}

/// Rows that are judged and written as text.
pub(super) struct TextJudging<'a> {
    pub rows: Rows<'a>,
    pub court: &'a StreamJudging<'a>,
    pub manner: Manner<'a>,
    pub out: &'a mut (dyn Write + Send),
    pub watch: &'a Watch,
    pub tick: &'a mut dyn FnMut(&Watch),
}

impl WithRendering for TextJudging<'_> {
    type Rendered = Result<Summary, Failed>;

    fn rendering<R: Rendering>(self) -> Self::Rendered {
        let Self { rows, court, manner, out, watch, tick } = self;
        match rows {
            Rows::Text(input) => batch::run::<R>(input, court, manner, out, watch, tick),
            Rows::Parquet(file) => parquet::into_text::<R>(file, court, manner, out, watch, tick),
        }
    }
}

/// What stands above the rows of an input is written.
pub(super) struct TextHeading<'a> {
    pub layout: &'a Layout,
    pub manner: Manner<'a>,
    pub is_first: bool,
    pub out: &'a mut (dyn Write + Send),
}

impl WithRendering for TextHeading<'_> {
    type Rendered = io::Result<()>;

    fn rendering<R: Rendering>(self) -> Self::Rendered {
        let Self { layout, manner, is_first, out } = self;
        let text = if is_first { R::above(layout, manner.prefix) } else { R::between(layout).to_vec() };
        let mut packed = Vec::new();
        if text.is_empty() { Ok(()) } else { out.write_all(manner.packing.pack(&text, &mut packed)?) }
    }
}
