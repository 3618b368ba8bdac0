//! The cells of the table: what the columns are, and a row, a size and its value in words.

use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::bands::BandShape;
use crate::report::template::Column;

/// Between a cell's edge and its text.
pub(super) const PAD: f32 = 3.5;
/// What the sign and the edges of a verdict take beside its word.
pub(super) const CHIP_MORE: f32 = 22.0;

/// What stands above a column.
pub(super) fn head(column: Column, words: &Words) -> String {
    words.get(column.text())
}

/// The unit of its numbers.
pub(super) const fn unit(column: Column) -> Option<&'static str> {
    match column {
        Column::Minimum | Column::Maximum | Column::Measured | Column::Blank => Some("mm"),
        Column::Deviation => Some("µm"),
        _ => None,
    }
}

/// Whether its texts end at the right edge.
pub(super) const fn is_number(column: Column) -> bool {
    unit(column).is_some()
}

/// Whether its texts may be broken where there is little room.
pub(super) const fn is_text(column: Column) -> bool {
    matches!(column, Column::Feature | Column::Callout | Column::From | Column::Instrument | Column::Remark)
}

/// A row: a size and its value.
#[derive(Debug, Clone, Default)]
pub(super) struct Row {
    pub label: String,
    pub status: Option<Status>,
    pub is_simulated: bool,
    pub name: String,
    pub callout: String,
    pub minimum: String,
    pub maximum: String,
    pub measured: String,
    pub deviation: String,
    /// The limit band, and what it shows in words.
    pub band: Option<(BandShape, String)>,
    pub word: String,
    pub source: String,
    /// What it is measured with.
    pub instrument: String,
    pub remark: String,
    /// What is special about it.
    pub notes: Vec<String>,
}

impl Row {
    /// The text of a column.
    pub fn text(&self, column: Column) -> &str {
        match column {
            Column::Number => &self.label,
            Column::Feature => &self.name,
            Column::Callout => &self.callout,
            Column::Minimum => &self.minimum,
            Column::Maximum => &self.maximum,
            Column::Measured => &self.measured,
            Column::Deviation => &self.deviation,
            Column::Band | Column::Blank => "",
            Column::Verdict => &self.word,
            Column::From => &self.source,
            Column::Instrument => &self.instrument,
            Column::Remark => &self.remark,
        }
    }
}

/// A small number, for lengths.
pub(super) fn count(count: usize) -> f32 {
    u16::try_from(count).map_or(f32::from(u16::MAX), f32::from)
}
