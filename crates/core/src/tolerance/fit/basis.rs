//! Hole basis or shaft basis: which part of a fit has its zone on the zero line.

use crate::message::Say;
use crate::tolerance::class::ToleranceClass;
use crate::tolerance::iso286::{self, Letter};

/// The system that a fit belongs to, in the words of ISO 286-1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Say)]
#[say(prefix = "fit-basis")]
pub enum Basis {
    /// The hole is an H: `H7/g6`.
    Hole,
    /// The shaft is an h: `G7/h6`.
    Shaft,
    /// H with h: `H7/h6` belongs to both.
    Both,
}

impl Basis {
    /// The word for machines, the same in every language.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Hole => "hole",
            Self::Shaft => "shaft",
            Self::Both => "both",
        }
    }

    pub(super) fn of_letters(hole: Letter, shaft: Letter) -> Option<Self> {
        match (hole, shaft) {
            (Letter::H, Letter::H) => Some(Self::Both),
            (Letter::H, _) => Some(Self::Hole),
            (_, Letter::H) => Some(Self::Shaft),
            _ => None,
        }
    }
}

/// The basis of a pair of classes; `None` where neither is an H, or a class is not in ISO 286.
pub fn basis(hole: ToleranceClass, shaft: ToleranceClass) -> Option<Basis> {
    Basis::of_letters(iso286::parts(hole)?.0, iso286::parts(shaft)?.0)
}
