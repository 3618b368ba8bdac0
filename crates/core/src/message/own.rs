//! Texts of the user's own in place of built-in ones: one Fluent file for one language.
//!
//! The form is that of the files of `assets/locales` (Fluent 1.0, projectfluent.org): a name at the beginning of its line, `=`, and the
//! text; the rest of a text is indented. A text that could say less than the built-in one, or another verdict, is refused, and the
//! built-in one is said. Files of machines have no such texts, so nothing of this reaches them.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{FilePlace, Located, Say};

/// The largest such file, bytes: the built-in ones of a language have a quarter of that.
pub const LARGEST_TEXTS: usize = 1 << 20;

/// As long is a text at most, characters, so that no list of variants takes long to look through.
pub(super) const LONGEST: usize = 10_000;

/// As deep are braces and parentheses in each other at most: Fluent's reader goes down with each.
pub(super) const DEEPEST: usize = 12;

/// As many refused texts are told one by one.
const MOST_TOLD: usize = 200;

/// Texts by which a value is known again in a file that Fitcheck wrote: whether somebody measured it. In order: contacts of a file, an
/// imported value, a typed one, an imported simulation, a simulation.
pub const READ_BACK: [&str; 5] =
    ["origin-contacts", "origin-imported", "origin-typed", "origin-imported-simulation", "origin-simulated"];

/// Why a file of own texts, or one of its texts, does not count.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "own-text", error)]
#[expect(missing_docs, reason = "the fields are what the texts of the variants show")]
pub enum OwnTextFault {
    /// Its name begins with no code of a language.
    Language { given: String, codes: String },
    /// More bytes than [`LARGEST_TEXTS`].
    TooLarge { bytes: usize, most: usize },
    /// A byte that is no UTF-8.
    NotUtf8 { byte: String },
    /// What Fluent cannot read; the reason is its own.
    Syntax { given: String, reason: String },
    /// A term, or something with attributes.
    NotAText { given: String },
    /// A name that no built-in text has, nor one like it.
    Unknown { name: String },
    /// An unknown name that is nearly one.
    Misspelt { name: String, nearest: &'static str },
    /// Neither counts.
    Twice { name: &'static str, first: usize },
    /// Nothing to be seen, at least in one variant.
    Empty { given: String },
    /// A control character, or one that turns the direction of a line.
    Control { given: String, code: String },
    /// Longer than a text may be, deeper than braces may be, or with too many variants.
    TooMuch { given: String, longest: usize, deepest: usize },
    /// A placeable that the built-in text has not.
    Surplus { name: &'static str, given: String, allowed: String },
    /// A placeable where the built-in text has none at all.
    SurplusOfNone { name: &'static str, given: String },
    /// A placeable that only the built-in text has, in one of its variants at least.
    Lost { name: &'static str, lost: String },
    /// One of [`READ_BACK`].
    ReadBack { name: &'static str },
    /// What a language says of itself.
    Property { name: &'static str },
    /// A word of a verdict that says, or is beside one that says, what another verdict says.
    SameVerdict { name: &'static str, clash: &'static str, word: String, other: &'static str },
}

/// The user's own texts of one language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OwnTexts {
    pub(super) code: &'static str,
    pub(super) file: Arc<str>,
    /// By their names, each with the line in which it begins and as Fluent reads it, the name included.
    pub(super) texts: BTreeMap<&'static str, (usize, String)>,
    pub(super) refused: Vec<Located<OwnTextFault>>,
    pub(super) refused_count: usize,
}

impl OwnTexts {
    /// The code of their language.
    pub const fn code(&self) -> &'static str {
        self.code
    }

    /// The file as the user named it.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// How many texts count.
    pub fn count(&self) -> usize {
        self.texts.len()
    }

    /// Why others do not count, by their places: the first ones of many.
    pub fn refused(&self) -> &[Located<OwnTextFault>] {
        &self.refused
    }

    /// How many do not count.
    pub const fn refused_count(&self) -> usize {
        self.refused_count
    }

    /// The entry of a name as Fluent reads it.
    pub(super) fn entry(&self, name: &str) -> Option<&str> {
        self.texts.get(name).map(|(_, entry)| entry.as_str())
    }

    pub(super) fn refuse(&mut self, what: OwnTextFault, line: usize, column: usize) {
        self.refused_count = self.refused_count.saturating_add(1);
        if self.refused.len() < MOST_TOLD {
            self.refused.push(Located { what, place: FilePlace::in_file(&self.file, line, column) });
        }
    }
}
