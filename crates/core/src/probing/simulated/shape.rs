//! What can be probed, by its shape: the names in files, and what lies inside or outside.

use crate::tolerance::Feature;

/// What a cycle measures and a simulated workpiece has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Shape {
    /// A hole.
    Hole,
    /// A shaft that stands upright.
    Stud,
    /// A plane face.
    Face,
    /// A point of a free surface.
    Point,
    /// Two walls with space between them.
    Slot,
    /// Two walls with material between them.
    Ridge,
    /// Four walls with space between them.
    Pocket,
    /// Four walls with material between them.
    Boss,
}

impl Shape {
    /// All shapes.
    pub const ALL: [Self; 8] =
        [Self::Hole, Self::Stud, Self::Face, Self::Point, Self::Slot, Self::Ridge, Self::Pocket, Self::Boss];

    /// The table of a workpiece file: `bore` for `[bore]`.
    pub const fn table(self) -> &'static str {
        match self {
            Self::Hole => "bore",
            Self::Stud => "stud",
            Self::Face => "face",
            Self::Point => "point",
            Self::Slot => "slot",
            Self::Ridge => "ridge",
            Self::Pocket => "pocket",
            Self::Boss => "boss",
        }
    }

    /// Whether it is round.
    pub const fn is_round(self) -> bool {
        matches!(self, Self::Hole | Self::Stud)
    }

    /// How its sizes are judged: like those of a hole where there is space inside, else as an outside dimension.
    pub const fn feature(self) -> Feature {
        match self {
            Self::Hole | Self::Slot | Self::Pocket => Feature::Hole,
            Self::Stud | Self::Ridge | Self::Boss | Self::Face | Self::Point => Feature::Shaft,
        }
    }

    /// Whether its material lies inside, so that it is probed from outside.
    pub const fn is_outside(self) -> bool {
        matches!(self, Self::Stud | Self::Ridge | Self::Boss)
    }
}
