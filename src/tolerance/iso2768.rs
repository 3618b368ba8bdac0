//! General tolerances of ISO 2768-1 for linear sizes: `10m`.
//!
//! The deviations of the four classes by size (table 1). Radii, chamfers and angles have tables of their own and are not
//! here.

use std::fmt;

use super::limits::Deviations;
use crate::length::{Length, signed_mm};
use crate::message::{Message, Say};

/// A class of ISO 2768-1, told by its small letter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum GeneralClass {
    /// `f`.
    Fine,
    /// `m`.
    Medium,
    /// `c`.
    Coarse,
    /// `v`.
    VeryCoarse,
}

/// A cell of the table: deviations, and the size range they belong to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GeneralCell {
    /// As much above as below.
    pub deviations: Deviations,
    /// Above this size; the first range begins with 0.5 mm itself.
    pub over: Length,
    /// Up to and including this size.
    pub to: Length,
}

/// Why a size has no general tolerance.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GeneralError {
    /// Below 0.5 mm the drawing must say the deviations.
    #[error("nominal size {nominal} mm is below {FIRST} mm, where ISO 2768-1 begins: write the deviations at the size")]
    TooSmall {
        /// The size that was asked for.
        nominal: Length,
    },
    /// The size is beyond the last range.
    #[error("nominal size {nominal} mm is beyond ISO 2768-1, which ends with {last} mm", last = last())]
    TooLarge {
        /// The size that was asked for.
        nominal: Length,
    },
    /// The class has no value in this range.
    #[error(
        "there is no class {class} of ISO 2768-1 {}; it is defined {}",
        range_text(*.over, *.to),
        range_text(*.defined_over, *.defined_to)
    )]
    NotDefined {
        /// The class that was asked for.
        class: GeneralClass,
        /// The range of the size: above this,
        over: Length,
        /// up to and including this.
        to: Length,
        /// Where the class is defined: above this,
        defined_over: Length,
        /// up to and including this.
        defined_to: Length,
    },
}

/// Where the first range begins; this size belongs to it.
const FIRST: Length = Length::from_micrometres(500);

/// Ends of the size ranges and half widths of `f`, `m`, `c` and `v`, in micrometres.
const ROWS: [(i32, [Option<i32>; 4]); 8] = [
    (3_000, [Some(50), Some(100), Some(200), None]),
    (6_000, [Some(50), Some(100), Some(300), Some(500)]),
    (30_000, [Some(100), Some(200), Some(500), Some(1_000)]),
    (120_000, [Some(150), Some(300), Some(800), Some(1_500)]),
    (400_000, [Some(200), Some(500), Some(1_200), Some(2_500)]),
    (1_000_000, [Some(300), Some(800), Some(2_000), Some(4_000)]),
    (2_000_000, [Some(500), Some(1_200), Some(3_000), Some(6_000)]),
    (4_000_000, [None, Some(2_000), Some(4_000), Some(8_000)]),
];

impl GeneralClass {
    /// Every class, from fine to very coarse.
    pub const ALL: [Self; 4] = [Self::Fine, Self::Medium, Self::Coarse, Self::VeryCoarse];

    /// The letter, as in `10m`.
    pub const fn letter(self) -> char {
        match self {
            Self::Fine => 'f',
            Self::Medium => 'm',
            Self::Coarse => 'c',
            Self::VeryCoarse => 'v',
        }
    }

    /// The class of a small letter.
    pub fn from_letter(letter: &str) -> Option<Self> {
        match letter {
            "f" => Some(Self::Fine),
            "m" => Some(Self::Medium),
            "c" => Some(Self::Coarse),
            "v" => Some(Self::VeryCoarse),
            _ => None,
        }
    }

    fn half_width(self, [fine, medium, coarse, very_coarse]: [Option<i32>; 4]) -> Option<Length> {
        let micrometres = match self {
            Self::Fine => fine,
            Self::Medium => medium,
            Self::Coarse => coarse,
            Self::VeryCoarse => very_coarse,
        };
        micrometres.map(Length::from_micrometres)
    }
}

impl fmt::Display for GeneralClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.letter().encode_utf8(&mut [0; 4]))
    }
}

/// The general tolerance of a size: 0.5 mm up to 4000 mm, each range above its lower end and up to its upper one.
///
/// ```
/// use fitcheck::tolerance::iso2768::{GeneralClass, deviations};
///
/// let cell = deviations(GeneralClass::Medium, "10".parse().unwrap())?;
/// assert_eq!(cell.deviations.upper().to_string(), "0.2");
/// assert_eq!(cell.deviations.lower().to_string(), "-0.2");
/// # Ok::<(), fitcheck::tolerance::iso2768::GeneralError>(())
/// ```
///
/// # Errors
/// [`GeneralError`]: below 0.5 mm, above 4000 mm, and where the class has no value, with where it has one.
pub fn deviations(class: GeneralClass, nominal: Length) -> Result<GeneralCell, GeneralError> {
    if nominal < FIRST {
        return Err(GeneralError::TooSmall { nominal });
    }
    let Some((over, to, half)) = ranges(class).find(|&(_, to, _)| nominal <= to) else {
        return Err(GeneralError::TooLarge { nominal });
    };
    let Some(half) = half else {
        let defined = || ranges(class).filter(|(.., half)| half.is_some());
        let defined_over = defined().map(|(over, ..)| over).min().unwrap_or(FIRST);
        let defined_to = defined().map(|(_, to, _)| to).max().unwrap_or(FIRST);
        return Err(GeneralError::NotDefined { class, over, to, defined_over, defined_to });
    };
    Ok(GeneralCell { deviations: Deviations::spanning(half, half.negated()), over, to })
}

/// Above, up to, and half the width where the class has one; ascending.
fn ranges(class: GeneralClass) -> impl Iterator<Item = (Length, Length, Option<Length>)> {
    ROWS.iter().scan(FIRST, move |before, &(end, half_widths)| {
        let (over, to) = (*before, Length::from_micrometres(end));
        *before = to;
        Some((over, to, class.half_width(half_widths)))
    })
}

fn last() -> Length {
    Length::from_micrometres(ROWS.iter().map(|&(end, _)| end).max().unwrap_or_default())
}

/// The first range holds its lower end, every other one begins above it.
fn range_text(over: Length, to: Length) -> String {
    let from = if over == FIRST { "from" } else { "over" };
    format!("{from} {over} up to {to} mm")
}

fn range_message(over: Length, to: Length) -> Message {
    let id = if over == FIRST { "general-range-from" } else { "limits-range" };
    Message::new(id).mm("over", over).mm("to", to)
}

impl Say for GeneralError {
    fn message(&self) -> Message {
        match self {
            Self::TooSmall { nominal } => {
                let message = Message::new("general-too-small").mm("first", FIRST);
                signed_mm(message, "nominal-sign", "nominal", *nominal)
            }
            Self::TooLarge { nominal } => Message::new("general-too-large").mm("nominal", *nominal).mm("last", last()),
            Self::NotDefined { class, over, to, defined_over, defined_to } => Message::new("general-not-defined")
                .text("class", class)
                .message("range", range_message(*over, *to))
                .message("defined", range_message(*defined_over, *defined_to)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(size: &str, letter: &str, expected: &str) {
        let said = match deviations(GeneralClass::from_letter(letter).unwrap(), size.parse().unwrap()) {
            Ok(cell) => format!("±{} over {} up to {}", cell.deviations.upper(), cell.over, cell.to),
            Err(error) => error.to_string(),
        };
        assert_eq!(said, expected, "for {size}{letter}");
    }

    #[test]
    fn a_size_has_the_tolerance_of_its_range() {
        check("10", "f", "±0.1 over 6 up to 30");
        check("0.5", "m", "±0.1 over 0.5 up to 3");
        check("4000", "v", "±8 over 2000 up to 4000");
    }

    #[test]
    fn refusals_say_where_the_class_is_defined() {
        check(
            "0.499999",
            "m",
            "nominal size 0.499999 mm is below 0.5 mm, where ISO 2768-1 begins: write the deviations at the size",
        );
        check("3", "v", "there is no class v of ISO 2768-1 from 0.5 up to 3 mm; it is defined over 3 up to 4000 mm");
        check(
            "2500",
            "f",
            "there is no class f of ISO 2768-1 over 2000 up to 4000 mm; it is defined from 0.5 up to 2000 mm",
        );
        check("4000.000001", "m", "nominal size 4000.000001 mm is beyond ISO 2768-1, which ends with 4000 mm");
    }

    #[test]
    fn every_error_is_said_in_english_and_in_dutch() {
        use crate::words::{Language, Words};
        for (class, size) in [("m", "0.1"), ("v", "3"), ("f", "2500"), ("c", "5000"), ("m", "-1")] {
            let error = deviations(GeneralClass::from_letter(class).unwrap(), size.parse().unwrap()).unwrap_err();
            assert_eq!(Words::new(Language::En).told(&error), error.to_string());
            let dutch = Words::new(Language::Nl).told(&error);
            assert!(dutch != error.message().id && dutch != error.to_string(), "{dutch}");
        }
    }
}
