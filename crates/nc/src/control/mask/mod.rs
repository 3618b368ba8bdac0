//! FN 16 masks: how a control prints its parameters to the screen or to a file.
//!
//! | file | what |
//! |---|---|
//! | `read` | text to mask, with warnings |
//! | `render` | mask and parameters to text |
//! | `inverse` | what a mask printed, back to the values; `inverse/search` has the ways to read some lines |
//! | `error` | what can be wrong |
//!
//! A mask is a list of lines: records (a quoted format and its parameters), keywords and language sections. The grammar
//! is that of the control's manuals and of the mask of NC-Solution 8255. Where they say nothing, our rule applies: a
//! missing `;` is a warning, anything else that cannot be read is an error with line and column.

mod error;
mod inverse;
mod read;
mod render;

pub use error::{MaskError, MaskFault, MaskWarning, MaskWarningKind, RenderError, RenderFault};
pub use inverse::{FieldContent, Inverse, InverseError, InverseFault, PrintMatch, Printed, Slot};
pub(crate) use render::decimal;
pub use render::{Context, FileUse, Output};

use fitcheck_core::message::Say;
use fitcheck_core::words::Dialogue;

use super::variables::Parameter;

/// A mask that can be rendered.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mask {
    lines: Vec<Line>,
}

impl Mask {
    /// Whether it has text in `L_` sections, and none of them is for this language.
    pub fn other_languages(&self, wanted: Dialogue) -> Option<OtherLanguages> {
        let wanted = &wanted.words().mask_language;
        let mut section = None;
        let mut languages = Vec::new();
        for line in &self.lines {
            match line {
                Line::Language(language) => section = language.as_deref(),
                Line::Record(_) => match section {
                    Some(language) if language == wanted => return None,
                    Some(language) if !languages.contains(&language) => languages.push(language),
                    Some(_) | None => {}
                },
                Line::Keyword(_) => {}
            }
        }
        (!languages.is_empty()).then(|| OtherLanguages { languages: languages.join(", "), wanted: wanted.clone() })
    }

    /// The parameters that it prints, those of every language.
    pub fn parameters(&self) -> impl Iterator<Item = Parameter> {
        let records = self.lines.iter().filter_map(|line| match line {
            Line::Record(record) => Some(record),
            Line::Keyword(_) | Line::Language(_) => None,
        });
        records.flat_map(|record| &record.parts).filter_map(|part| match part {
            Part::Field { name: Name::Parameter(parameter), .. } => Some(*parameter),
            Part::Field { .. } | Part::Text(_) => None,
        })
    }
}

/// A mask has text in sections of other languages, and none in one of the language that it is printed in.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(id = "mask-other-languages")]
pub struct OtherLanguages {
    /// The languages that it has text for.
    pub languages: String,
    /// The language that it is printed in.
    pub wanted: String,
}

/// One line that has an effect.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Line {
    /// `"text %S", QS1;`
    Record(Record),
    /// `M_CLOSE;` and similar words.
    Keyword(Keyword),
    /// `L_GERMAN;`: what follows is printed in this dialogue language only. `None` is `L_ALL`.
    Language(Option<String>),
}

/// A quoted format with its parameters filled in.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Record {
    /// From 1.
    line: usize,
    parts: Vec<Part>,
}

/// A piece of a record.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Part {
    /// Printed as it is.
    Text(String),
    /// A parameter in a format.
    Field { format: Format, name: Name, column: usize },
}

/// What follows a `%`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "four flags that may stand together in any combination")]
struct Format {
    left: bool,
    plus: bool,
    blank: bool,
    zeros: bool,
    width: usize,
    digits: Option<usize>,
    kind: FormatLetter,
}

/// The letter of a format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum FormatLetter {
    /// `%S`: text.
    Text,
    /// `%RS`: text, unchanged.
    Raw,
    /// `%F`, `%LF`: number.
    Decimal,
    /// `%D`, `%I`: whole number.
    Whole,
}

/// What a field prints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Name {
    Parameter(Parameter),
    Day,
    Month,
    Year2,
    Year4,
    Hour,
    Minute,
    Second,
    CallPath,
}

/// What a mask prints besides parameters, by its word.
const NAMES: [(&str, Name); 8] = [
    ("DAY", Name::Day),
    ("MONTH", Name::Month),
    ("YEAR2", Name::Year2),
    ("YEAR4", Name::Year4),
    ("HOUR", Name::Hour),
    ("MIN", Name::Minute),
    ("SEC", Name::Second),
    ("CALL_PATH", Name::CallPath),
];

/// An instruction about the output file or about empty texts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Keyword {
    Close,
    File(FileUse),
    EmptyHide,
    EmptyShow,
}
