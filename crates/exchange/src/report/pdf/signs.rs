//! Signs and outlines of verdicts: each differs without its colour.

use fitcheck_core::verdict::Status;

/// A sign beside the word of a verdict: those of the window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Sign {
    Good,
    Rework,
    ReMeasure,
    OutOfLimits,
    Scrap,
    None,
}

impl Sign {
    pub const fn of(status: Option<Status>) -> Self {
        match status {
            Some(Status::Good) => Self::Good,
            Some(Status::Rework) => Self::Rework,
            Some(Status::ReMeasure) => Self::ReMeasure,
            Some(Status::OutOfLimits) => Self::OutOfLimits,
            Some(Status::Scrap) => Self::Scrap,
            None => Self::None,
        }
    }

    /// Its place in the font of icons.
    pub const fn icon(self) -> char {
        match self {
            Self::Good => '\u{e182}',
            Self::Rework => '\u{e038}',
            Self::ReMeasure => '\u{e3f6}',
            Self::OutOfLimits => '\u{eb04}',
            Self::Scrap => '\u{e4f6}',
            Self::None => '\u{e32a}',
        }
    }
}

/// The outline of a balloon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Outline {
    Circle,
    Square,
    Diamond,
    Hexagon,
    Triangle,
}

impl Outline {
    /// Its corners round its middle, where it has straight sides.
    pub const fn corners(self) -> &'static [[f32; 2]] {
        match self {
            Self::Circle | Self::Square => &[],
            Self::Diamond => &[[0.0, -1.22], [1.22, 0.0], [0.0, 1.22], [-1.22, 0.0]],
            Self::Triangle => &[[0.0, -1.45], [1.4, 0.85], [-1.4, 0.85]],
            Self::Hexagon => &[[-0.58, -1.0], [0.58, -1.0], [1.16, 0.0], [0.58, 1.0], [-0.58, 1.0], [-1.16, 0.0]],
        }
    }

    pub const fn of(status: Option<Status>) -> Self {
        match status {
            Some(Status::Good) | None => Self::Circle,
            Some(Status::Rework) => Self::Square,
            Some(Status::Scrap) => Self::Diamond,
            Some(Status::ReMeasure) => Self::Hexagon,
            Some(Status::OutOfLimits) => Self::Triangle,
        }
    }
}
