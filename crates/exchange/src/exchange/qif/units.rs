//! Lengths of a QIF file in whole nanometres: units of length, and decimal numbers of any fineness.

use std::collections::HashMap;

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::message::shortened;

use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::xml::Element;

/// A decimal number: `digits` · 10^-`scale`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Decimal {
    digits: i128,
    scale: i32,
}

/// Digits that are read of a number: more are beyond any measurement.
const MOST_DIGITS: usize = 18;

/// The longest number, or three of them, in characters.
const LONGEST: usize = 200;

/// Exponents that are read.
const MOST_EXPONENT: i32 = 30;

impl Decimal {
    /// A number as XML writes it, with a point; measuring software also gives it an exponent.
    fn read(text: &str) -> Option<Self> {
        let (number, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let exponent: i32 = exponent.parse().ok().filter(|exponent: &i32| exponent.abs() <= MOST_EXPONENT)?;
        let is_negative = number.starts_with('-');
        let number = number.strip_prefix(['-', '+']).unwrap_or(number);
        let (whole, behind) = number.split_once('.').unwrap_or((number, ""));
        let behind = behind.trim_end_matches('0');
        let is_number = [whole, behind].iter().all(|part| part.bytes().all(|byte| byte.is_ascii_digit()));
        let whole = whole.trim_start_matches('0');
        if !is_number || number.bytes().all(|byte| byte == b'.') || MOST_DIGITS < whole.len() {
            return None;
        }
        // A double has 17 digits: what comes later is nothing.
        let behind = behind.get(..behind.len().min(MOST_DIGITS)).unwrap_or(behind);
        let digits: i128 = format!("0{whole}{behind}").parse().ok()?;
        let scale = i32::try_from(behind.len()).ok()? - exponent;
        Some(Self { digits: if is_negative { -digits } else { digits }, scale }.reduced())
    }

    /// Without zeros at its end.
    fn reduced(mut self) -> Self {
        while self.digits != 0 && self.digits % 10 == 0 {
            self.digits /= 10;
            self.scale -= 1;
        }
        if self.digits == 0 { Self { digits: 0, scale: 0 } } else { self }
    }

    /// So many metres as whole nanometres, and whether that is exact; `None` beyond all lengths.
    fn nanometres(self, metres: Self) -> Option<(i64, bool)> {
        let digits = self.digits.checked_mul(metres.digits)?;
        let down = self.scale + metres.scale - 9;
        let power = 10_i128.checked_pow(down.unsigned_abs());
        let (nm, is_exact) = if down <= 0 {
            (digits.checked_mul(power?)?, true)
        } else if let Some(power) = power {
            let half = if digits < 0 { -power / 2 } else { power / 2 };
            ((digits.checked_add(half)?) / power, digits % power == 0)
        } else {
            (0, digits == 0)
        };
        Some((i64::try_from(nm).ok()?, is_exact))
    }
}

/// The metres of a unit by its name.
fn known(name: &str) -> Option<Decimal> {
    let (digits, scale) = match name.trim().to_lowercase().as_str() {
        "m" | "meter" | "metre" | "meters" | "metres" => (1, 0),
        "dm" | "decimeter" | "decimetre" => (1, 1),
        "cm" | "centimeter" | "centimetre" | "centimeters" | "centimetres" => (1, 2),
        "mm" | "millimeter" | "millimetre" | "millimeters" | "millimetres" => (1, 3),
        "\u{b5}m" | "\u{3bc}m" | "um" | "micron" | "microns" | "micrometer" | "micrometre" | "micrometers" => (1, 6),
        "nm" | "nanometer" | "nanometre" => (1, 9),
        "in" | "inch" | "inches" | "\"" => (254, 4),
        "ft" | "foot" | "feet" => (3048, 4),
        _ => return None,
    };
    Some(Decimal { digits, scale })
}

/// A unit of length as a file declares it: its name and how many metres it has.
///
/// # Errors
/// [`ImportErrorKind::QifUnit`] where nothing says that, or its name and its factor contradict each other.
fn declared(unit: &Element) -> Result<(String, Decimal), ImportErrorKind> {
    let name = unit.text_at(&["UnitName"]);
    let si = unit.text_at(&["SIUnitName"]);
    let factor = unit.text_at(&["UnitConversion", "Factor"]);
    let offset = unit.text_at(&["UnitConversion", "Offset"]);
    let refused = || {
        let said = [name, factor, offset, si].into_iter().filter(|text| !text.is_empty());
        ImportErrorKind::QifUnit { unit: shorten(&said.collect::<Vec<_>>().join(" ")) }
    };
    let has_offset = !offset.is_empty() && Decimal::read(offset).is_none_or(|offset| offset.digits != 0);
    let is_length = si.is_empty() || matches!(si.to_lowercase().as_str(), "meter" | "metre");
    let by_name = known(name);
    let metres = if factor.is_empty() { by_name } else { Decimal::read(factor).filter(|read| 0 < read.digits) };
    let agrees = by_name.is_none() || by_name == metres;
    match metres {
        Some(metres) if agrees && is_length && !has_offset => Ok((name.to_owned(), metres)),
        _ => Err(refused()),
    }
}

/// The units of length of a file.
#[derive(Debug, Clone)]
pub(super) struct Units {
    /// That of features.
    plain: Decimal,
    /// That of characteristics and their values, which may have one of their own.
    pmi: Decimal,
    /// Those that a value may name.
    named: HashMap<String, Decimal>,
}

/// Which of the two primary units a number is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum UnitOwner {
    Feature,
    Characteristic,
}

/// A number as it stands in the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Number {
    pub(super) text: String,
    /// The unit that it names; empty for the primary one.
    unit: String,
}

impl Number {
    /// The text of an element, and the unit that it names; `None` where it has no text.
    pub(super) fn of(element: &Element) -> Option<Self> {
        let unit = element.start.attribute("linearUnit").to_owned();
        (!element.text.is_empty()).then(|| Self { text: shortened(&element.text, LONGEST), unit })
    }

    /// The same number with another text.
    pub(super) fn with(&self, text: &str) -> Self {
        Self { text: shorten(text), unit: self.unit.clone() }
    }
}

/// Why a number is not a length.
pub(super) enum NotALength {
    Number(LengthError),
    Unit(ImportErrorKind),
}

impl Units {
    /// The units of the element `FileUnits`.
    ///
    /// # Errors
    /// [`ImportErrorKind::QifUnit`] or [`ImportErrorKind::QifNoUnit`].
    pub(super) fn of(units: &Element) -> Result<Self, ImportErrorKind> {
        let primary = units.child("PrimaryUnits");
        let unit = |name: &str| primary.and_then(|primary| primary.child(name)).map(declared).transpose();
        let plain = unit("LinearUnit")?;
        let pmi = unit("PMILinearUnit")?;
        let mut named = HashMap::new();
        let others = units.child("OtherUnits").into_iter().flat_map(Element::children);
        let others: Result<Vec<_>, _> = others.filter(|unit| unit.start.name == "LinearUnit").map(declared).collect();
        named.extend(others?.into_iter().chain(plain.clone()).chain(pmi.clone()));
        let pmi = pmi.or_else(|| plain.clone()).ok_or(ImportErrorKind::QifNoUnit)?.1;
        Ok(Self { plain: plain.map_or(pmi, |(_, metres)| metres), pmi, named })
    }

    /// A number as a length, and whether it is exactly that: files hold doubles, with figures beyond the nanometre.
    pub(super) fn length(&self, number: &Number, of: UnitOwner) -> Result<(Length, bool), NotALength> {
        let metres = match (number.unit.as_str(), of) {
            ("", UnitOwner::Feature) => self.plain,
            ("", UnitOwner::Characteristic) => self.pmi,
            (name, _) => self
                .named
                .get(name)
                .copied()
                .or_else(|| known(name))
                .ok_or_else(|| NotALength::Unit(ImportErrorKind::QifUnit { unit: number.unit.clone() }))?,
        };
        let text = || number.text.clone();
        let read =
            Decimal::read(&number.text).ok_or_else(|| NotALength::Number(LengthError::NotANumber { text: text() }))?;
        let too_large = || NotALength::Number(LengthError::TooLarge { text: text() });
        let (nm, is_exact) = read.nanometres(metres).ok_or_else(too_large)?;
        Ok((Length::from_nanometres(nm).map_err(|_range| too_large())?, is_exact))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_units_are_whole_nanometres() {
        for (text, unit, expected) in [
            ("25.0123", "mm", Some((25_012_300, true))),
            ("25.012300000000001", "mm", Some((25_012_300, false))),
            ("-0.5", "mm", Some((-500_000, true))),
            ("1", "inch", Some((25_400_000, true))),
            ("0.98473622", "inch", Some((25_012_300, false))),
            ("0.025", "m", Some((25_000_000, true))),
            ("2.5E1", "mm", Some((25_000_000, true))),
            ("1e-30", "mm", Some((0, false))),
            ("0.0000000", "mm", Some((0, true))),
            ("7", "\u{b5}m", Some((7_000, true))),
            ("1e30", "mm", None),
            ("1e31", "mm", None),
            ("25,0", "mm", None),
            ("INF", "mm", None),
            ("", "mm", None),
            (".", "mm", None),
        ] {
            let metres = known(unit).unwrap();
            assert_eq!(Decimal::read(text).and_then(|read| read.nanometres(metres)), expected, "{text} {unit}");
        }
    }
}
