//! What the pages of a report are printed on.

/// A size of paper.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Paper {
    /// ISO 216, 210 × 297 mm.
    #[default]
    A4,
    /// North American letter, 8.5 × 11 inches.
    Letter,
}

impl Paper {
    /// Every size.
    pub const ALL: &[Self] = &[Self::A4, Self::Letter];

    /// Its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::A4 => "a4",
            Self::Letter => "letter",
        }
    }

    /// Width and height in points, 72 of which are an inch.
    pub const fn points(self) -> [f32; 2] {
        match self {
            Self::A4 => [595.276, 841.89],
            Self::Letter => [612.0, 792.0],
        }
    }
}
