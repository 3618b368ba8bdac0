//! Hole basis or shaft basis: which part of a fit has its zone on the zero line.

use std::fmt;

use crate::message::{Message, Say};
use crate::tolerance::class::ToleranceClass;
use crate::tolerance::iso286::{self, Letter};

/// The system that a fit belongs to, in the words of ISO 286-1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Basis {
    /// The hole is an H: `H7/g6`.
    Hole,
    /// The shaft is an h: `G7/h6`.
    Shaft,
    /// H with h: `H7/h6` belongs to both.
    Both,
}

impl Basis {
    /// The word for machines, in every language the same.
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

/// The basis of a pair of classes; `None` where neither is an H, or a class is none of ISO 286.
pub fn basis(hole: ToleranceClass, shaft: ToleranceClass) -> Option<Basis> {
    Basis::of_letters(iso286::parts(hole)?.0, iso286::parts(shaft)?.0)
}

impl fmt::Display for Basis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Hole => "hole basis",
            Self::Shaft => "shaft basis",
            Self::Both => "hole and shaft basis",
        })
    }
}

impl Say for Basis {
    fn message(&self) -> Message {
        Message::new(match self {
            Self::Hole => "fit-basis-hole",
            Self::Shaft => "fit-basis-shaft",
            Self::Both => "fit-basis-both",
        })
    }
}
