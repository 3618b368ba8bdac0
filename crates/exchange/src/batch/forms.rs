//! What the rows are written as.
//!
//! To add a form of text:
//!
//! 1. Write a file in `exchange/batch` that implements [`Take`]. Add its `mod` and `pub use` lines and its row in `mod.rs` there.
//! 2. Add here its variant, its line in [`FORMS`], its [`Rendering`] and an arm in each question about a form. The compiler names the
//!    arms. Elsewhere `cli/batch/mod.rs` alone names forms: CSV is the default, and Parquet is not packed.
//! 3. Judge the same rows into it with `judged::<R>` in `tests/core/batch.rs` and in `fuzz/src/targets/batch.rs`.
//! 4. Name its ending in the help of `cli/batch/mod.rs`, in `docs/manual/batch.md` and in `CHANGELOG.md`.
//! 5. Add a call to `tests/data/corpus/batch.txt` and record the answers (`tests/core/corpus.rs`).
//!
//! A form that is not text is made as `parquet` is. Rows that do not come as text become the text of a CSV (`exchange/batch/typed.rs`),
//! so that one judge reads all rows.

use fitcheck_core::length::Line;

use crate::exchange::batch::{Csv, JsonLines, Layout, Take, Tsv};

/// A form of the answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// The rows as they came, with columns added.
    Csv,
    /// The cells of the rows between tabs, without quotation marks, with columns added.
    Tsv,
    /// An object a line.
    JsonLines,
    /// Columns of typed values; written by programs with the feature `parquet`.
    Parquet,
}

/// Every form: its name on the command line, and the endings of its files.
pub const FORMS: &[(Form, &str, &[&str])] = &[
    (Form::Csv, "csv", &["csv", "txt"]),
    (Form::Tsv, "tsv", &["tsv"]),
    (Form::JsonLines, "jsonl", &["jsonl", "ndjson"]),
    (Form::Parquet, "parquet", &["parquet", "pq"]),
];

impl Form {
    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        FORMS.iter().find(|(form, ..)| *form == self).map_or("", |(_, name, _)| name)
    }

    /// The form that an ending names, without its point.
    pub fn of_ending(ending: &str) -> Option<Self> {
        let ending = ending.to_ascii_lowercase();
        FORMS.iter().find(|(_, _, endings)| endings.contains(&ending.as_str())).map(|(form, ..)| *form)
    }

    /// Hands over what writes the form as text; `None` for a form that is none.
    pub fn with_rendering<W: WithRendering>(self, with: W) -> Option<W::Rendered> {
        match self {
            Self::Csv => Some(with.rendering::<Csv>()),
            Self::Tsv => Some(with.rendering::<Tsv>()),
            Self::JsonLines => Some(with.rendering::<JsonLines>()),
            Self::Parquet => None,
        }
    }

    /// Whether the rows stay as they came, so that all inputs need the same separator.
    pub const fn keeps_separators(self) -> bool {
        match self {
            Self::Csv => true,
            Self::Tsv | Self::JsonLines | Self::Parquet => false,
        }
    }

    /// Whether a cell is found by the name of its column, so that no two columns may have the same.
    pub const fn finds_by_name(self) -> bool {
        match self {
            Self::Csv | Self::Tsv => false,
            Self::JsonLines | Self::Parquet => true,
        }
    }

    /// Whether the columns keep their types, so that all inputs need the same.
    pub const fn keeps_types(self) -> bool {
        match self {
            Self::Csv | Self::Tsv | Self::JsonLines => false,
            Self::Parquet => true,
        }
    }
}

/// Something that is done with any form of text.
pub trait WithRendering {
    /// What it makes.
    type Rendered;

    /// Does it.
    fn rendering<R: Rendering>(self) -> Self::Rendered;
}

/// Writes rows with their answers as text.
pub trait Rendering: Take {
    /// For the rows of a stream; `prefix` stands before the names of the added columns.
    fn new(layout: &Layout, prefix: &str) -> Self;

    /// What stands above all rows.
    fn above(_layout: &Layout, _prefix: &str) -> Vec<u8> {
        Vec::new()
    }

    /// What stands above the rows of an input that is not the first one.
    fn between(_layout: &Layout) -> &[u8] {
        &[]
    }

    /// What was written since it was cleared.
    fn out(&mut self) -> &mut Line;
}

impl Rendering for Csv {
    fn new(layout: &Layout, _prefix: &str) -> Self {
        Self::new(layout)
    }

    fn above(layout: &Layout, prefix: &str) -> Vec<u8> {
        Self::header(layout, prefix)
    }

    fn between(layout: &Layout) -> &[u8] {
        Self::comments(layout)
    }

    fn out(&mut self) -> &mut Line {
        &mut self.out
    }
}

impl Rendering for Tsv {
    fn new(layout: &Layout, _prefix: &str) -> Self {
        Self::new(layout)
    }

    fn above(layout: &Layout, prefix: &str) -> Vec<u8> {
        Self::header(layout, prefix)
    }

    fn out(&mut self) -> &mut Line {
        &mut self.out
    }
}

impl Rendering for JsonLines {
    fn new(layout: &Layout, prefix: &str) -> Self {
        Self::new(layout, prefix)
    }

    fn out(&mut self) -> &mut Line {
        &mut self.out
    }
}
