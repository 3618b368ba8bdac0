//! What the rows are written as: one line here and one rendering each.

use crate::exchange::batch::{Csv, JsonLines, Layout, Take, Tsv};
use crate::length::Line;

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

/// Every form: its name on the command line, the endings of its files, and what it is.
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
}

/// Writes rows with their answers as bytes.
pub trait Rendering: Take {
    /// For the rows of a stream; `prefix` stands before the names of the added columns.
    fn new(layout: &Layout, prefix: &str) -> Self;

    /// What was written since it was cleared.
    fn out(&mut self) -> &mut Line;
}

impl Rendering for Csv {
    /// The names stand in the header alone.
    fn new(layout: &Layout, _prefix: &str) -> Self {
        Self::new(layout)
    }

    fn out(&mut self) -> &mut Line {
        &mut self.out
    }
}

impl Rendering for Tsv {
    /// The names stand in the header alone.
    fn new(layout: &Layout, _prefix: &str) -> Self {
        Self::new(layout)
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
