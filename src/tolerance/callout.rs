//! Callouts: a nominal size and a tolerance class as an operator types them.

use std::fmt;
use std::str::FromStr;

use super::class::{ClassError, Feature, ToleranceClass};
use crate::length::{Length, LengthError, signed_mm};
use crate::words::{Message, Say};

/// A nominal size above zero and a tolerance class.
///
/// ```
/// use fitcheck::tolerance::{Callout, Feature};
///
/// let callout: Callout = "Ø25,0H7".parse()?;
/// assert_eq!(callout.to_string(), "25 H7");
/// assert_eq!(callout.feature(), Feature::Hole);
/// # Ok::<(), fitcheck::tolerance::CalloutError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Callout {
    nominal: Length,
    class: ToleranceClass,
}

/// Why a text is no callout.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CalloutError {
    /// There is no text.
    #[error("a callout is missing: write a nominal size and a tolerance class, such as 25 H7")]
    Empty,
    /// The text does not begin with a size.
    #[error("{text} does not begin with a nominal size: write one, such as 25 H7")]
    NoNominal {
        /// What was given.
        text: String,
    },
    /// The nominal size cannot be read.
    #[error("nominal size: {0}")]
    Nominal(LengthError),
    /// ISO 286 and the control's tables begin above 0 mm. Program 8255 has no such check: a size of 0 or less would
    /// read its table's first row.
    #[error("nominal size {nominal} mm is not above 0")]
    NotPositive {
        /// What was given.
        nominal: Length,
    },
    /// The class cannot be read.
    #[error("{0}")]
    Class(ClassError),
}

impl Say for CalloutError {
    fn message(&self) -> Message {
        match self {
            Self::Empty => Message::new("callout-empty"),
            Self::NoNominal { text } => Message::new("callout-no-nominal").text("text", text),
            Self::Nominal(error) => Message::new("callout-nominal").message("error", error.message()),
            Self::NotPositive { nominal } => {
                signed_mm(Message::new("callout-not-positive"), "nominal-sign", "nominal", *nominal)
            }
            Self::Class(error) => error.message(),
        }
    }
}

impl Callout {
    /// A callout of its two parts.
    ///
    /// # Errors
    /// [`CalloutError::NotPositive`] for a size of zero or less.
    pub fn new(nominal: Length, class: ToleranceClass) -> Result<Self, CalloutError> {
        if nominal <= Length::ZERO {
            return Err(CalloutError::NotPositive { nominal });
        }
        Ok(Self { nominal, class })
    }

    /// The nominal size in millimetres above zero.
    pub const fn nominal(&self) -> Length {
        self.nominal
    }

    /// The tolerance class.
    pub const fn class(&self) -> ToleranceClass {
        self.class
    }

    /// Hole or shaft, by the case of the class.
    pub const fn feature(&self) -> Feature {
        self.class.feature()
    }
}

impl FromStr for Callout {
    type Err = CalloutError;

    /// Reads `25 H7`, `25H7`, `Ø25 H7`, `25,0 H7`, with or without `mm` behind the size.
    fn from_str(text: &str) -> Result<Self, CalloutError> {
        let given = text.trim();
        if given.is_empty() {
            return Err(CalloutError::Empty);
        }
        let bare = given.trim_start_matches(['Ø', 'ø', '⌀', '\u{2300}']).trim_start();
        let is_number = |c: char| c.is_ascii_digit() || ".,+-\u{2212}".contains(c);
        let size = bare.find(|c| !is_number(c)).unwrap_or(bare.len());
        let (number, rest) = bare.split_at_checked(size).unwrap_or((bare, ""));
        if number.is_empty() {
            return Err(CalloutError::NoNominal { text: given.to_owned() });
        }
        let nominal = number.parse().map_err(CalloutError::Nominal)?;
        let rest = rest.trim_start();
        // "25 mm H7": the unit ends at a blank, so that "25m6" stays the class m6.
        let class = rest.strip_prefix("mm ").unwrap_or(rest);
        Self::new(nominal, class.parse().map_err(CalloutError::Class)?)
    }
}

/// As the control prints it in QS2: the nominal size with only the decimals it has, a blank, the class.
impl fmt::Display for Callout {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&format!("{} {}", self.nominal, self.class))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        let said = match Callout::from_str(text) {
            Ok(callout) => callout.to_string(),
            Err(error) => format!("! {error}"),
        };
        assert_eq!(said, expected, "for {text:?}");
    }

    #[test]
    fn reads_callouts_as_people_type_them() {
        check("25 H7", "25 H7");
        check("25H7", "25 H7");
        check("  Ø25 H7 ", "25 H7");
        check("⌀ 25 h7", "25 h7");
        check("25,0 H7", "25 H7");
        check("25.50JS13", "25.5 JS13");
        check("10m6", "10 m6");
        check("25 mm H7", "25 H7");
        check("+3.001 K7", "3.001 K7");
    }

    #[test]
    fn every_error_is_said_in_english_and_in_dutch() {
        use crate::words::{Language, Words};
        for text in ["", "H7", "0 H7", "-5.5 H7", "7.5.2 H7", "25"] {
            let error = Callout::from_str(text).unwrap_err();
            assert_eq!(Words::new(Language::En).told(&error), error.to_string());
            let dutch = Words::new(Language::Nl).told(&error);
            assert!(dutch != error.message().id && dutch != error.to_string(), "{dutch}");
        }
        let negative = Callout::from_str("-5.5 H7").unwrap_err();
        assert_eq!(Words::new(Language::Nl).told(&negative), "nominale maat -5,5 mm is niet groter dan 0");
    }

    #[test]
    fn refuses_what_is_no_callout() {
        check("", "! a callout is missing: write a nominal size and a tolerance class, such as 25 H7");
        check("H7", "! H7 does not begin with a nominal size: write one, such as 25 H7");
        check("25", "! a tolerance class is missing, such as H7 for a hole or h7 for a shaft");
        check("0 H7", "! nominal size 0 mm is not above 0");
        check("-5 H7", "! nominal size -5 mm is not above 0");
        check("\u{2212}5 H7", "! nominal size -5 mm is not above 0");
        check("7.5.2 H7", "! nominal size: 7.5.2 is not a number");
        check("1.234,5 H7", "! nominal size: 1.234,5 is ambiguous: write one decimal sign and no thousands separator");
        check("25 Hh7", "! Hh7 mixes upper and lower case: write HH7 for a hole or hh7 for a shaft");
        check("10m", "! m is not a tolerance class: write letters and a grade, such as H7 or js13");
        check("25 H7/g6", "! H7/g6 is not a tolerance class: write letters and a grade, such as H7 or js13");
        check("NaN H7", "! NaN H7 does not begin with a nominal size: write one, such as 25 H7");
    }
}
