//! The cell of a tolerance beside a nominal size: `±0.05`, `+0.021 0`, `0.021/-0.000`.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::Deviations;
use fitcheck_core::tolerance::callout::band;

use super::cells;
use super::error::ImportErrorKind;
use super::given::shorten;

/// Whether a text has deviations and no size before them.
pub(super) fn is_one(text: &str) -> bool {
    let has_sign = text.starts_with(['±', '+', '-', '\u{2212}', '\u{2013}']);
    has_sign || cells::is_number(text) || text.split_once('/').is_some_and(|(upper, lower)| is_upper(upper, lower))
}

/// Whether two texts are an upper deviation without its plus, and a lower one.
fn is_upper(upper: &str, lower: &str) -> bool {
    let is_zero = |text: &str| cells::length(text, Unit::Millimetre).is_ok_and(|length| length == Length::ZERO);
    let lower = lower.trim();
    let is_signed = lower.starts_with(['-', '+', '\u{2212}', '\u{2013}']);
    upper.trim().starts_with(|c: char| c.is_ascii_digit()) && cells::is_number(upper) && (is_signed || is_zero(lower))
}

/// The deviations of a text; with `goes_both_ways` a number without a sign is one of both.
///
/// # Errors
/// A number that may be both deviations or the width of the zone, and what is no deviation.
pub(super) fn read(text: &str, goes_both_ways: bool) -> Result<Deviations, ImportErrorKind> {
    let signed = match text.split_once('/') {
        Some((upper, lower)) if is_upper(upper, lower) => format!("+{} {}", upper.trim(), lower.trim()),
        _ if text.starts_with(|c: char| c.is_ascii_digit()) && goes_both_ways => format!("±{text}"),
        _ if text.starts_with(|c: char| c.is_ascii_digit()) => {
            return Err(ImportErrorKind::ToleranceUnsigned { given: shorten(text) });
        }
        _ => text.to_owned(),
    };
    band(&signed).map_err(ImportErrorKind::Callout)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tolerance_beside_a_nominal_size_is_two_deviations() {
        for (text, expected) in [
            ("±0,02", Some(("0.02", "-0.02"))),
            ("+/-0.05", Some(("0.05", "-0.05"))),
            ("+0,01/-0,02", Some(("0.01", "-0.02"))),
            ("+0.01 -0.02", Some(("0.01", "-0.02"))),
            ("+0.021 0", Some(("0.021", "0"))),
            ("0.021/-0.000", Some(("0.021", "0"))),
            ("0.021/0", Some(("0.021", "0"))),
            ("-0.007 -0.020", Some(("-0.007", "-0.02"))),
            ("0.05", None),
        ] {
            assert!(is_one(text), "{text}");
            let read = read(text, false).ok().map(|band| (band.upper().to_string(), band.lower().to_string()));
            assert_eq!(read, expected.map(|(upper, lower)| (upper.to_owned(), lower.to_owned())), "{text}");
        }
        for text in ["25 H7", "25 ±0.02", "25.021/25.000", "Ø12 +0.018/-0"] {
            assert!(!is_one(text), "{text}");
        }
    }
}
