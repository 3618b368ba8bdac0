//! Numbers as other programs print their floating-point numbers: with an exponent, or with figures beyond the nanometre.

use super::{Length, LengthError, Unit, decimal_parts};

/// The most figures of a number; a program that prints more has none behind them.
const MOST_FIGURES: usize = 30;

/// The largest exponent, either way: far beyond any length.
const MOST_EXPONENT: i32 = 60;

impl Length {
    /// Reads a number like [`Length::parse_in`], also with an exponent (`1.00283E+0001`), to the nearest nanometre; and whether it was
    /// rounded. Halves go away from zero.
    ///
    /// # Errors
    /// [`LengthError`] says what is wrong with the text.
    pub fn parse_rounded(text: &str, unit: Unit) -> Result<(Self, bool), LengthError> {
        match Self::parse_in(text, unit) {
            Ok(length) => Ok((length, false)),
            Err(LengthError::NotANumber { .. } | LengthError::TooFine { .. }) => rounded(text.trim(), unit),
            Err(error) => Err(error),
        }
    }
}

fn rounded(given: &str, unit: Unit) -> Result<(Length, bool), LengthError> {
    let not_a_number = || LengthError::NotANumber { text: given.to_owned() };
    let too_large = || LengthError::TooLarge { text: given.to_owned() };
    let (number, exponent) = match given.split_once(['e', 'E']) {
        Some((number, exponent)) => (number, read_exponent(exponent).ok_or_else(not_a_number)?),
        None => (given, 0),
    };
    let is_negative = number.starts_with(['-', '\u{2212}']);
    let digits = number.strip_prefix(['+', '-', '\u{2212}']).unwrap_or(number);
    let (whole, decimals) = decimal_parts(digits).ok_or_else(not_a_number)?;
    let decimals = decimals.trim_end_matches('0');
    let figures = format!("{whole}{decimals}");
    let figures = figures.trim_start_matches('0');
    if MOST_FIGURES < figures.len() {
        return Err(LengthError::TooFine { text: given.to_owned() });
    }
    let figures: i128 = if figures.is_empty() { 0 } else { figures.parse().map_err(|_range| too_large())? };
    // A unit is a whole number times a power of ten.
    let (factor, power) = match unit {
        Unit::Millimetre => (1, 6),
        Unit::Micrometre => (1, 3),
        Unit::Inch => (254, 5),
    };
    let decimals = i32::try_from(decimals.len()).map_err(|_range| not_a_number())?;
    let scaled = figures * factor;
    let (nanometres, is_rounded) = scale(scaled, exponent - decimals + power).ok_or_else(too_large)?;
    let nanometres = i64::try_from(nanometres).map_err(|_range| too_large())?;
    let length = Length::from_nanometres(if is_negative { -nanometres } else { nanometres });
    Ok((length.map_err(|_range| too_large())?, is_rounded))
}

fn read_exponent(text: &str) -> Option<i32> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let exponent: i32 = text.parse().ok()?;
    (exponent.abs() <= MOST_EXPONENT).then_some(exponent)
}

/// A number that is not negative times a power of ten, to the nearest whole one; and whether it was rounded.
fn scale(number: i128, power: i32) -> Option<(i128, bool)> {
    let ten = 10_i128.checked_pow(power.unsigned_abs());
    if 0 <= power {
        return match ten {
            Some(ten) => Some((number.checked_mul(ten)?, false)),
            None => (number == 0).then_some((0, false)),
        };
    }
    // A number of so few figures is nothing where the power has no room.
    let Some(ten) = ten else { return Some((0, number != 0)) };
    let quotient = number / ten;
    let rest = number % ten;
    Some((quotient + i128::from(ten - rest <= rest), rest != 0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, unit: Unit, expected: Option<(i64, bool)>) {
        let found =
            Length::parse_rounded(text, unit).ok().map(|(length, is_rounded)| (length.nanometres(), is_rounded));
        assert_eq!(found, expected, "{text}");
    }

    #[test]
    fn numbers_of_other_programs_are_read_to_the_nearest_nanometre() {
        check("25.0123", Unit::Millimetre, Some((25_012_300, false)));
        check("1.00283074000000E+0001", Unit::Millimetre, Some((10_028_307, true)));
        check("1.00283070000000E+0001", Unit::Millimetre, Some((10_028_307, false)));
        check("-2.5e1", Unit::Millimetre, Some((-25_000_000, false)));
        check("2.5E-1", Unit::Inch, Some((6_350_000, false)));
        check("24.987100000000002", Unit::Millimetre, Some((24_987_100, true)));
        check("0.0000005", Unit::Millimetre, Some((1, true)));
        check("-0.0000005", Unit::Millimetre, Some((-1, true)));
        check("0.00000049", Unit::Millimetre, Some((0, true)));
        check("1.0005", Unit::Micrometre, Some((1_001, true)));
        check("1E-60", Unit::Millimetre, Some((0, true)));
        check("0E60", Unit::Millimetre, Some((0, false)));
    }

    #[test]
    fn what_is_no_length_is_refused() {
        for text in ["", "E5", "1E", "1E+", "1E5.0", "1E61", "1E60", "0x10", "1.2.3", "nan", "inf", "1e5e5", "1,5.0E1"]
        {
            check(text, Unit::Millimetre, None);
        }
        check(&"9".repeat(31), Unit::Millimetre, None);
        check(&format!("1.{}1", "0".repeat(30)), Unit::Millimetre, None);
    }
}
