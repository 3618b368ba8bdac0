//! What can be wrong with a mask, or with rendering it.

use crate::message::{Message, Say};

/// Why a mask cannot be read. Lines and columns count from 1, columns in characters.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum MaskError {
    /// There is nothing to print.
    #[error("the mask is empty")]
    Empty,
    /// More than any mask needs.
    #[error("the mask is larger than {most} KiB")]
    TooLarge {
        /// What is allowed.
        most: usize,
    },
    /// A line is neither record, keyword nor comment.
    #[error("line {line}, column {column}: {found} is no record, keyword or comment")]
    Unknown {
        /// Where.
        line: usize,
        /// Where in the line.
        column: usize,
        /// What stands there.
        found: String,
    },
    /// A quoted format does not end.
    #[error("line {line}, column {column}: the quotation mark is not closed")]
    UnclosedQuote {
        /// Where.
        line: usize,
        /// Where the quotation begins.
        column: usize,
    },
    /// A letter that is no format.
    #[error("line {line}, column {column}: {found} is no format, allowed are %S %RS %F %LF %D %I %%")]
    UnknownFormat {
        /// Where.
        line: usize,
        /// Where in the line.
        column: usize,
        /// What stands there.
        found: String,
    },
    /// A width or a number of digits beyond reason.
    #[error("line {line}, column {column}: {found} is too wide, at most {most}")]
    TooWide {
        /// Where.
        line: usize,
        /// Where in the line.
        column: usize,
        /// What stands there.
        found: String,
        /// What is allowed.
        most: usize,
    },
    /// More formats than parameters, or fewer.
    #[error("line {line}: {formats} formats and {parameters} parameters")]
    Count {
        /// Where.
        line: usize,
        /// How many formats need a parameter.
        formats: usize,
        /// How many parameters there are.
        parameters: usize,
    },
    /// A word that is no parameter.
    #[error(
        "line {line}, column {column}: {found} is no parameter, allowed are Q, QL, QR, QS with a number, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH"
    )]
    UnknownParameter {
        /// Where.
        line: usize,
        /// Where in the line.
        column: usize,
        /// What stands there.
        found: String,
    },
}

impl Say for MaskError {
    fn message(&self) -> Message {
        let at = |id, line: &usize, column: &usize| Message::new(id).text("line", line).text("column", column);
        match self {
            Self::Empty => Message::new("mask-empty"),
            Self::TooLarge { most } => Message::new("mask-too-large").text("most", most),
            Self::Unknown { line, column, found } => at("mask-unknown", line, column).text("found", found),
            Self::UnclosedQuote { line, column } => at("mask-unclosed-quote", line, column),
            Self::UnknownFormat { line, column, found } => at("mask-unknown-format", line, column).text("found", found),
            Self::TooWide { line, column, found, most } => {
                at("mask-too-wide", line, column).text("found", found).text("most", most)
            }
            Self::Count { line, formats, parameters } => {
                Message::new("mask-count").text("line", line).text("formats", formats).text("parameters", parameters)
            }
            Self::UnknownParameter { line, column, found } => {
                at("mask-unknown-parameter", line, column).text("found", found)
            }
        }
    }
}

/// What is odd about a mask that can still be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum MaskWarning {
    /// The record or keyword does not end in `;`, as in the first line of the seed's mask.
    #[error("line {line}: the ; at the end is missing")]
    NoSemicolon {
        /// Where.
        line: usize,
    },
    /// An `M_` or `L_` word that is not known; it has no effect.
    #[error("line {line}: {word} is not known and has no effect")]
    UnknownWord {
        /// Where.
        line: usize,
        /// The word.
        word: String,
    },
    /// Text behind the `;` that is no comment.
    #[error("line {line}: {found} behind the ; is passed over")]
    BehindSemicolon {
        /// Where.
        line: usize,
        /// What stands there.
        found: String,
    },
}

impl Say for MaskWarning {
    fn message(&self) -> Message {
        match self {
            Self::NoSemicolon { line } => Message::new("mask-no-semicolon").text("line", line),
            Self::UnknownWord { line, word } => Message::new("mask-unknown-word").text("line", line).text("word", word),
            Self::BehindSemicolon { line, found } => {
                Message::new("mask-behind-semicolon").text("line", line).text("found", found)
            }
        }
    }
}

/// Why a mask cannot be rendered.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RenderError {
    /// A parameter has no value.
    #[error("line {line}, column {column}: {name} is not defined")]
    Undefined {
        /// Where.
        line: usize,
        /// Where in the line.
        column: usize,
        /// The parameter.
        name: String,
    },
    /// A text under a number's format.
    #[error("line {line}, column {column}: {name} is a text, the format wants a number")]
    TextAsNumber {
        /// Where.
        line: usize,
        /// Where in the line.
        column: usize,
        /// The parameter.
        name: String,
    },
    /// A number under a text's format.
    #[error("line {line}, column {column}: {name} is a number, the format wants a text")]
    NumberAsText {
        /// Where.
        line: usize,
        /// Where in the line.
        column: usize,
        /// The parameter.
        name: String,
    },
    /// Infinite or not a number.
    #[error("line {line}, column {column}: {name} is not a finite number")]
    NotFinite {
        /// Where.
        line: usize,
        /// Where in the line.
        column: usize,
        /// The parameter.
        name: String,
    },
}

impl Say for RenderError {
    fn message(&self) -> Message {
        let (id, line, column, name) = match self {
            Self::Undefined { line, column, name } => ("mask-undefined", line, column, name),
            Self::TextAsNumber { line, column, name } => ("mask-text-as-number", line, column, name),
            Self::NumberAsText { line, column, name } => ("mask-number-as-text", line, column, name),
            Self::NotFinite { line, column, name } => ("mask-not-finite", line, column, name),
        };
        Message::new(id).text("line", line).text("column", column).text("name", name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{Language, Words};

    #[test]
    fn every_sentence_is_there_in_both_languages() {
        let found = || "%X".to_owned();
        let errors: Vec<Box<dyn Say>> = vec![
            Box::new(MaskError::Empty),
            Box::new(MaskError::TooLarge { most: 1024 }),
            Box::new(MaskError::Unknown { line: 1, column: 2, found: found() }),
            Box::new(MaskError::UnclosedQuote { line: 1, column: 2 }),
            Box::new(MaskError::UnknownFormat { line: 1, column: 2, found: found() }),
            Box::new(MaskError::TooWide { line: 1, column: 2, found: found(), most: 255 }),
            Box::new(MaskError::Count { line: 1, formats: 2, parameters: 3 }),
            Box::new(MaskError::UnknownParameter { line: 1, column: 2, found: found() }),
            Box::new(MaskWarning::NoSemicolon { line: 1 }),
            Box::new(MaskWarning::UnknownWord { line: 1, word: found() }),
            Box::new(MaskWarning::BehindSemicolon { line: 1, found: found() }),
            Box::new(RenderError::Undefined { line: 1, column: 2, name: found() }),
            Box::new(RenderError::TextAsNumber { line: 1, column: 2, name: found() }),
            Box::new(RenderError::NumberAsText { line: 1, column: 2, name: found() }),
            Box::new(RenderError::NotFinite { line: 1, column: 2, name: found() }),
        ];
        let (english, dutch) = (Words::new(Language::En), Words::new(Language::Nl));
        for error in errors {
            let message = error.message();
            assert_ne!(english.say(&message), message.id);
            assert_ne!(dutch.say(&message), message.id);
            assert_ne!(dutch.say(&message), english.say(&message));
        }
        let error = MaskError::Count { line: 1, formats: 2, parameters: 3 };
        assert_eq!(english.told(&error), error.to_string());
        let error = RenderError::Undefined { line: 1, column: 2, name: "Q1".into() };
        assert_eq!(english.told(&error), error.to_string());
        let error = MaskError::UnknownFormat { line: 1, column: 2, found: found() };
        assert_eq!(english.told(&error), error.to_string());
        let error = MaskError::UnknownParameter { line: 1, column: 2, found: found() };
        assert_eq!(english.told(&error), error.to_string());
    }
}
