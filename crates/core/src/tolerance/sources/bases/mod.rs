//! The list of sources that are asked after the user's own tables.
//!
//! To add a source:
//!
//! 1. Write a file in `bases/` with its `DECLARATION`. Add its lines here: `mod`, variant, `ALL` with its length, `declaration`.
//! 2. Add its texts to every folder of `assets/locales`: its name in the menu (`source-choice-NAME`), what an answer says of its
//!    origin, and why it has no limits. [`LimitsError::Standard`] takes any message.
//! 3. Add a call with `--source NAME` to the corpus and record the answers (`tests/core/corpus.rs`).
//!
//! `--source`, the window's menu, the state file, the map of classes, the search for fits and every look-up follow.

mod control_tables;
mod iso286;

use serde::{Deserialize, Serialize};

use super::LimitsError;
use crate::length::Length;
use crate::tolerance::class::{Feature, ToleranceClass};
use crate::tolerance::deviations::Deviations;
use crate::tolerance::iso286::Options;
use crate::tolerance::limits::Source;

/// The source that is asked after the user's own tables. A state file keeps it by its name in kebab case.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Base {
    /// The standard: every class from above 0 up to 3150 mm.
    #[default]
    Iso286,
    /// Tables as on a control. A user's own table replaces the one with the same name.
    ControlTables,
}

/// What a source declares about itself.
pub(super) struct Declaration {
    /// Its name on the command line.
    pub name: &'static str,
    /// Its text in the command line's help.
    pub help: &'static str,
    /// The id of its text in the window's menu.
    pub text: &'static str,
    /// What it answers by itself; `None` where the control's tables answer.
    pub standard: Option<Standard>,
}

/// The limit deviations of a class, and where they come from; or why it has none.
type Answer = Result<(Deviations, Source), LimitsError>;

/// Classes at a size, with their deviations.
type Classes = Box<dyn Iterator<Item = (ToleranceClass, Deviations)>>;

/// What a source answers by itself.
pub(super) struct Standard {
    /// The limit deviations of a class at a size, and where they come from.
    pub deviations: fn(ToleranceClass, Length, Options) -> Answer,
    /// Whether it has a class at some size.
    pub knows: fn(ToleranceClass) -> bool,
    /// Every class that it has at a size, by letter and then by grade.
    pub classes_at: fn(Feature, Length, Options) -> Classes,
    /// The classes that are offered first.
    pub usual_classes: fn(Feature) -> Vec<ToleranceClass>,
}

impl Base {
    /// Every source, in the order of menu and help.
    pub const ALL: [Self; 2] = [Self::Iso286, Self::ControlTables];

    const fn declaration(self) -> &'static Declaration {
        match self {
            Self::Iso286 => &iso286::DECLARATION,
            Self::ControlTables => &control_tables::DECLARATION,
        }
    }

    /// Its name on the command line.
    pub const fn name(self) -> &'static str {
        self.declaration().name
    }

    /// Its text in the command line's help.
    pub const fn help(self) -> &'static str {
        self.declaration().help
    }

    /// The id of its text in the window's menu.
    pub const fn text(self) -> &'static str {
        self.declaration().text
    }

    /// Whether it is a standard, which answers by itself, and not the control's tables.
    pub const fn is_standard(self) -> bool {
        self.standard().is_some()
    }

    pub(super) const fn standard(self) -> Option<&'static Standard> {
        self.declaration().standard.as_ref()
    }
}
