//! The columns of the table, and a row: a size and its value, in words.

use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::bands::BandShape;

/// Between a cell's edge and its text.
pub(super) const PAD: f32 = 3.5;
/// What the sign and the edges of a verdict take beside its word.
pub(super) const CHIP_MORE: f32 = 22.0;

/// A column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Column {
    Label,
    Name,
    Callout,
    Minimum,
    Maximum,
    Measured,
    Deviation,
    Band,
    Word,
    Source,
}

impl Column {
    /// All of them, from left to right.
    pub const ALL: [Self; 10] = [
        Self::Label,
        Self::Name,
        Self::Callout,
        Self::Minimum,
        Self::Maximum,
        Self::Measured,
        Self::Deviation,
        Self::Band,
        Self::Word,
        Self::Source,
    ];

    /// Its place among them.
    pub const fn at(self) -> usize {
        match self {
            Self::Label => 0,
            Self::Name => 1,
            Self::Callout => 2,
            Self::Minimum => 3,
            Self::Maximum => 4,
            Self::Measured => 5,
            Self::Deviation => 6,
            Self::Band => 7,
            Self::Word => 8,
            Self::Source => 9,
        }
    }

    /// What stands above it.
    pub fn head(self, words: &Words) -> String {
        words.get(match self {
            Self::Label => "report-contact",
            Self::Name => "report-id",
            Self::Callout => "report-callout",
            Self::Minimum => "report-minimum",
            Self::Maximum => "report-maximum",
            Self::Measured => "report-measured",
            Self::Deviation => "report-deviation",
            Self::Band => "report-pdf-band",
            Self::Word => "report-verdict",
            Self::Source => "report-from",
        })
    }

    /// The unit of its numbers.
    pub const fn unit(self) -> Option<&'static str> {
        match self {
            Self::Minimum | Self::Maximum | Self::Measured => Some("mm"),
            Self::Deviation => Some("µm"),
            _ => None,
        }
    }

    /// Whether its texts end at the right edge.
    pub const fn is_number(self) -> bool {
        self.unit().is_some()
    }

    /// Whether its texts may be broken where there is little room.
    pub const fn is_text(self) -> bool {
        matches!(self, Self::Name | Self::Callout | Self::Source)
    }
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
    /// What is special about it.
    pub notes: Vec<String>,
}

impl Row {
    /// The text of a column.
    pub fn text(&self, column: Column) -> &str {
        match column {
            Column::Label => &self.label,
            Column::Name => &self.name,
            Column::Callout => &self.callout,
            Column::Minimum => &self.minimum,
            Column::Maximum => &self.maximum,
            Column::Measured => &self.measured,
            Column::Deviation => &self.deviation,
            Column::Band => "",
            Column::Word => &self.word,
            Column::Source => &self.source,
        }
    }
}

/// A small number, for lengths.
pub(super) fn count(count: usize) -> f32 {
    u16::try_from(count).map_or(f32::from(u16::MAX), f32::from)
}
