//! The text fields of all pages.

use super::cycles::WorkpieceField;
use super::page::pages;
use super::parts::{PartsField, PlanField, WalkField};

macro_rules! field {
    ($($(#[$doc:meta])* $page:ident: $folder:ident, $State:ident, $Command:ident, $Field:ident, $Action:ident, $name:literal, $manual:literal;)+) => {
        /// A text field of the window.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Field {
            $($(#[$doc])* $page(super::$folder::$Field),)+
            /// A figure of the simulated workpiece, which the cycles page and the program page share.
            Workpiece(WorkpieceField),
        }

        $(impl From<super::$folder::$Field> for Field {
            fn from(field: super::$folder::$Field) -> Self {
                Self::$page(field)
            }
        })+
    };
}

pages!(field);
from_variants!(Field: Workpiece(WorkpieceField));

impl From<WalkField> for Field {
    fn from(field: WalkField) -> Self {
        Self::Parts(PartsField::Walk(field))
    }
}

impl From<PlanField> for Field {
    fn from(field: PlanField) -> Self {
        Self::Parts(PartsField::Plan(field))
    }
}
