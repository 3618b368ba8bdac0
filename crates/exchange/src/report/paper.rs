//! What the pages of a report are printed on.

use serde::{Deserialize, Serialize};

/// A size of paper, or of a label.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Paper {
    /// ISO 216, 210 × 297 mm.
    #[default]
    A4,
    /// North American letter, 8.5 × 11 inches.
    Letter,
    /// 62 × 29 mm, of a roll.
    SmallLabel,
    /// 100 × 50 mm.
    LargeLabel,
}

impl Paper {
    /// Every size.
    pub const ALL: &[Self] = &[Self::A4, Self::Letter, Self::SmallLabel, Self::LargeLabel];

    /// Its name on the command line and in a template.
    pub const fn name(self) -> &'static str {
        match self {
            Self::A4 => "a4",
            Self::Letter => "letter",
            Self::SmallLabel => "small-label",
            Self::LargeLabel => "large-label",
        }
    }

    /// The name of its text.
    pub const fn text(self) -> &'static str {
        match self {
            Self::A4 => "report-paper-a4",
            Self::Letter => "report-paper-letter",
            Self::SmallLabel => "report-paper-small-label",
            Self::LargeLabel => "report-paper-large-label",
        }
    }

    /// Width and height in points, 72 of which are an inch.
    pub const fn points(self) -> [f32; 2] {
        match self {
            Self::A4 => [595.276, 841.89],
            Self::Letter => [612.0, 792.0],
            Self::SmallLabel => [175.748, 82.205],
            Self::LargeLabel => [283.465, 141.732],
        }
    }

    /// Width and height of a label in millimetres; `None` for a page.
    pub const fn label_mm(self) -> Option<[u32; 2]> {
        match self {
            Self::A4 | Self::Letter => None,
            Self::SmallLabel => Some([62, 29]),
            Self::LargeLabel => Some([100, 50]),
        }
    }

    /// Whether only the answer has room on it.
    pub const fn is_label(self) -> bool {
        self.label_mm().is_some()
    }
}
