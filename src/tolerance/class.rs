//! Tolerance classes: letters and a grade, `H7` for a hole, `h7` for a shaft.

use std::fmt;
use std::str::FromStr;

use super::iso286::Grade;
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

/// A tolerance class: the name of a column in a table of deviations.
///
/// One or more letters, then one or two digits: `H7`, `js13`, and a user's own columns such as `U1`. Only the case of
/// the letters decides between hole and shaft, because program 82551 of NC-Solution 8255 compares the text with `a`.
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
    /// The text is not letters and a grade.
    Malformed {
        /// What was given.
        text: String,
    },
}

impl ToleranceClass {
    /// The text, `H7`.
    pub fn as_str(&self) -> &str {
        let length = self.text.iter().position(|&byte| byte == 0).unwrap_or(LONGEST);
        self.text.get(..length).and_then(|bytes| std::str::from_utf8(bytes).ok()).unwrap_or_default()
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

    /// The letters without the grade: `JS` of `JS7`.
    pub fn letters(&self) -> &str {
        self.as_str().trim_end_matches(|c: char| c.is_ascii_digit())
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
        let letters = given.trim_end_matches(|c: char| c.is_ascii_digit());
        let digits = given.len() - letters.len();
        let ascii = letters.bytes().all(|byte| byte.is_ascii_alphabetic());
        if !ascii || letters.is_empty() || !(1..=2).contains(&digits) {
            return Err(malformed());
        }
        let capitals = letters.bytes().filter(u8::is_ascii_uppercase).count();
        if 0 < capitals && capitals < letters.len() {
            return Err(ClassError::MixedCase {
                text: given.to_owned(),
                upper: given.to_ascii_uppercase(),
                lower: given.to_ascii_lowercase(),
            });
        }
        let mut text = [0; LONGEST];
        text.get_mut(..given.len()).ok_or_else(malformed)?.copy_from_slice(given.as_bytes());
        Ok(Self { text })
    }
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
