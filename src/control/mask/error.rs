//! What can be wrong with a mask, or with rendering it, and where. Columns count characters, from 1.

use crate::message::{Located, Say};

/// Why a mask cannot be read, with line and column.
pub type MaskError = Located<MaskFault>;

/// What was odd about a mask that could still be read, with its line.
pub type MaskWarning = Located<MaskWarningKind>;

/// Why a mask cannot be rendered, with line and column.
pub type RenderError = Located<RenderFault>;

/// What is wrong with a mask.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "mask", error)]
pub enum MaskFault {
    /// There is nothing to print.
    Empty,
    /// More than any mask needs.
    TooLarge {
        /// What is allowed, in KiB.
        most: usize,
    },
    /// A line is neither record, keyword nor comment.
    Unknown {
        /// What stands there.
        found: String,
    },
    /// A quoted format does not end.
    UnclosedQuote,
    /// A letter that is not a format.
    UnknownFormat {
        /// What stands there.
        found: String,
    },
    /// A width or a number of digits beyond reason.
    TooWide {
        /// What stands there.
        found: String,
        /// What is allowed.
        most: usize,
    },
    /// More formats than parameters, or fewer.
    Count {
        /// How many formats need a parameter.
        formats: usize,
        /// How many parameters there are.
        parameters: usize,
    },
    /// A word that is not a parameter.
    UnknownParameter {
        /// What stands there.
        found: String,
    },
}

/// What is odd about a mask that can still be read.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "mask")]
pub enum MaskWarningKind {
    /// The record or keyword does not end in `;`, as in the first line of the mask of NC-Solution 8255.
    NoSemicolon,
    /// An `M_` or `L_` word that is not known; it has no effect.
    UnknownWord {
        /// The word.
        word: String,
    },
    /// Text behind the `;` that is not a comment.
    BehindSemicolon {
        /// What stands there.
        found: String,
    },
}

/// What keeps a mask from being rendered.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "mask", error)]
pub enum RenderFault {
    /// A parameter has no value.
    Undefined {
        /// The parameter.
        name: String,
    },
    /// A text under a number's format.
    TextAsNumber {
        /// The parameter.
        name: String,
    },
    /// A number under a text's format.
    NumberAsText {
        /// The parameter.
        name: String,
    },
    /// Infinite or not a number.
    NotFinite {
        /// The parameter.
        name: String,
    },
}
