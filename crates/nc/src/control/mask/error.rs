//! What can be wrong with a mask or with rendering it, and where. Columns count characters, from 1.

use fitcheck_core::message::{Located, Say};

/// Why a mask cannot be read, with line and column.
pub type MaskError = Located<MaskFault>;

/// A warning about a mask that could still be read, with its line.
pub type MaskWarning = Located<MaskWarningKind>;

/// Why a mask cannot be rendered, with line and column.
pub type RenderError = Located<RenderFault>;

/// What is wrong with a mask.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "mask", error)]
pub enum MaskFault {
    /// There is nothing to print.
    Empty,
    /// Larger than any mask needs to be.
    TooLarge {
        /// What is allowed, in KiB.
        most: usize,
    },
    /// A line is neither record, keyword nor comment.
    Unknown { found: String },
    /// A quoted format does not end.
    UnclosedQuote,
    /// A letter that is not a format.
    UnknownFormat { found: String },
    /// A width or a number of digits that is too large.
    TooWide {
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
    UnknownParameter { found: String },
}

/// A warning about a mask that can still be read.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "mask")]
pub enum MaskWarningKind {
    /// The record or keyword does not end in `;`, as in the first line of the mask of NC-Solution 8255.
    NoSemicolon,
    /// An unknown `M_` or `L_` word; it has no effect.
    UnknownWord { word: String },
    /// Text after the `;` that is not a comment.
    BehindSemicolon { found: String },
}

/// Why a mask cannot be rendered.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "mask", error)]
pub enum RenderFault {
    /// A parameter has no value.
    Undefined {
        /// The parameter.
        name: String,
    },
    /// A text in a number's format.
    TextAsNumber {
        /// The parameter.
        name: String,
    },
    /// A number in a text's format.
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
