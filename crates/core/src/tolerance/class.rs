//! Tolerance classes: letters and a grade, `H7` for a hole, `h7` for a shaft, and own columns of other names, `PF`.

use std::fmt;
use std::str::FromStr;

use super::iso286::Grade;
use super::iso2768::GeneralClass;
use crate::message::{Say, as_text};

/// Which side of the material is measured.
///
/// ISO 286-1 calls any inner feature of linear size a hole and any outer one a shaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Feature {
    /// An inner feature.
    Hole,
    /// An outer feature.
    Shaft,
}

impl Feature {
    /// The other side.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Hole => Self::Shaft,
            Self::Shaft => Self::Hole,
        }
    }

    /// The lower-case English word, as in JSON.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Hole => "hole",
            Self::Shaft => "shaft",
        }
    }
}

impl fmt::Display for Feature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

as_text!(Feature, ToleranceClass);

/// The longest name of a class or a user's own table column.
const LONGEST: usize = 8;

/// Names that are no class, in either case, though their letters would do: behind a number they are a unit or a word of drawings, or they are a
/// column of a control's table that holds no deviations.
const NO_CLASSES: [&str; 26] = [
    "mm", "cm", "dm", "km", "nm", "um", "in", "inch", "inches", "zoll", "pollici", "ft", "mil", "mils", "thou",
    "micron", "microns", "nr", "bereich", "bereik", "min", "max", "ref", "ted", "basic", "bsc",
];

/// A tolerance class: the name of a column in a table of deviations.
///
/// A letter, then letters and digits, at most eight in all: `H7`, `js13`, and a user's own columns such as `U1` and `PF`.
/// The letters have one case, and it decides between hole and shaft, because program 82551 of NC-Solution 8255 compares
/// the text with `a`. No class are names of units, the general classes `f`, `m`, `c`, `v` of ISO 2768-1, and the columns
/// of row numbers and size ranges, all of them in either case. `docs/SOURCES.md`, tables, says why.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ToleranceClass {
    /// ASCII, padded with zero bytes.
    text: [u8; LONGEST],
}

/// Why a text is not a tolerance class.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "class", error)]
pub enum ClassError {
    /// There is no class.
    Missing,
    /// Upper and lower case in one class: neither hole nor shaft.
    MixedCase {
        /// What was given.
        text: String,
        /// The same in capitals.
        upper: String,
        /// The same in small letters.
        lower: String,
    },
    /// The text is neither letters and a grade nor a name that an own column may have.
    Malformed {
        /// What was given.
        text: String,
    },
}

impl ToleranceClass {
    /// The text, `H7`.
    pub fn as_str(&self) -> &str {
        // Every byte is ASCII, so it is a text.
        std::str::from_utf8(&self.text).map_or("", |text| text.trim_end_matches('\0'))
    }

    /// Hole for capitals, shaft for small letters.
    pub const fn feature(self) -> Feature {
        // The first letter is enough: mixed case is refused when parsing.
        if self.text[0].is_ascii_uppercase() { Feature::Hole } else { Feature::Shaft }
    }

    /// The same letters and grade on the other side of the material: `h7` for `H7`.
    #[must_use]
    pub fn other_case(self) -> Self {
        let mut text = self.text;
        match self.feature() {
            Feature::Hole => text.make_ascii_lowercase(),
            Feature::Shaft => text.make_ascii_uppercase(),
        }
        Self { text }
    }

    /// The class of a letter of ISO 286 (in small letters) and a grade: at most two letters and two digits.
    pub(super) fn of_parts(feature: Feature, letters: &str, grade: Grade) -> Self {
        let mut text = [0; LONGEST];
        let digits = grade.digits();
        let bytes = letters.bytes().map(|letter| match feature {
            Feature::Hole => letter.to_ascii_uppercase(),
            Feature::Shaft => letter,
        });
        for (place, byte) in text.iter_mut().zip(bytes.chain(digits.into_iter().filter(|digit| *digit != 0))) {
            *place = byte;
        }
        Self { text }
    }

    /// The letters without the grade: `JS` of `JS7`. Of an own column its name without the digits at its end: `PF`, `U1Z`
    /// of `U1Z1`.
    pub fn letters(&self) -> &str {
        self.as_str().trim_end_matches(|c: char| c.is_ascii_digit())
    }

    /// Whether it is letters and one or two digits, as every class of ISO 286 is; `PF` and `U1Z1` are not.
    pub fn has_grade(self) -> bool {
        let digits = self.as_str().len() - self.letters().len();
        (1..=2).contains(&digits) && self.letters().bytes().all(|byte| byte.is_ascii_alphabetic())
    }
}

impl FromStr for ToleranceClass {
    type Err = ClassError;

    fn from_str(text: &str) -> Result<Self, ClassError> {
        let given = text.trim();
        if given.is_empty() {
            return Err(ClassError::Missing);
        }
        let malformed = || ClassError::Malformed { text: given.to_owned() };
        let is_name = given.starts_with(|c: char| c.is_ascii_alphabetic())
            && given.bytes().all(|byte| byte.is_ascii_alphanumeric())
            && given.len() <= LONGEST;
        if !is_name || means_something_else(given) {
            return Err(malformed());
        }
        let is_mixed = |text: &str| {
            let has = |case: fn(&u8) -> bool| text.bytes().any(|byte| case(&byte));
            has(u8::is_ascii_uppercase) && has(u8::is_ascii_lowercase)
        };
        let beginning = given.split(|c: char| c.is_ascii_digit()).next().unwrap_or(given);
        if is_mixed(beginning) {
            return Err(ClassError::MixedCase {
                text: given.to_owned(),
                upper: given.to_ascii_uppercase(),
                lower: given.to_ascii_lowercase(),
            });
        }
        // "H7x" is rather a slip of the keyboard than a column H7X.
        if is_mixed(given) {
            return Err(malformed());
        }
        let mut text = [0; LONGEST];
        text.get_mut(..given.len()).ok_or_else(malformed)?.copy_from_slice(given.as_bytes());
        Ok(Self { text })
    }
}

/// Whether a name is a unit, a general class or a column without deviations.
fn means_something_else(name: &str) -> bool {
    NO_CLASSES.iter().any(|other| name.eq_ignore_ascii_case(other))
        || name.len() == 1 && GeneralClass::from_letter(&name.to_ascii_lowercase()).is_some()
}

impl fmt::Display for ToleranceClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

impl fmt::Debug for ToleranceClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}
