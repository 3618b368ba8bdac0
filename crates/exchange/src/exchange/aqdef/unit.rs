//! The unit of a characteristic, K2142: those of all formats, and centimetres and metres besides.

use fitcheck_core::length::{Length, LengthError, Unit};

use crate::exchange::units;

/// A unit of lengths, moved by powers of ten.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct FileUnit {
    unit: Unit,
    tens: i32,
}

impl FileUnit {
    pub(super) const MILLIMETRE: Self = Self { unit: Unit::Millimetre, tens: 0 };

    /// The unit of this name; `None` where it is none that is read.
    pub(super) fn named(text: &str) -> Option<Self> {
        let tens = match text.trim() {
            "cm" => 1,
            "m" => 3,
            text => return units::known(text).map(|unit| Self { unit, tens: 0 }),
        };
        Some(Self { unit: Unit::Millimetre, tens })
    }

    /// A length in it, to the nearest nanometre, and whether it was rounded.
    ///
    /// # Errors
    /// [`LengthError`] where the text is no length.
    pub(super) fn parse(self, text: &str) -> Result<(Length, bool), LengthError> {
        if self.tens == 0 {
            return Length::parse_rounded(text, self.unit);
        }
        let (number, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let moved = exponent.parse::<i32>().ok().and_then(|exponent| exponent.checked_add(self.tens));
        match moved {
            Some(exponent) => Length::parse_rounded(&format!("{number}E{exponent}"), self.unit),
            None => Length::parse_rounded(text, self.unit),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn centimetres_and_metres_are_exact() {
        for (unit, text, nanometres) in [
            ("cm", "2.5012", 25_012_000),
            ("cm", "2.50120000000000E+0000", 25_012_000),
            ("cm", "-1.5E-1", -1_500_000),
            ("m", "0.025", 25_000_000),
            ("mm", "25.012", 25_012_000),
            ("in", "1", 25_400_000),
        ] {
            let read = FileUnit::named(unit).unwrap().parse(text);
            assert_eq!(read.map(|(length, _)| length.nanometres()), Ok(nanometres), "{text} {unit}");
        }
        assert_eq!(FileUnit::named("km"), None);
        assert!(FileUnit::named("cm").unwrap().parse("2.5x").is_err());
    }
}
