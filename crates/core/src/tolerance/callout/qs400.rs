//! The tolerance texts of cycle 444 (QS400): one or two deviations without a nominal size.

use super::band::{Deviation, Sign};
use super::error::CalloutError;
use super::kind::CalloutErrorKind;
use super::reading::{Grammar, Reader};
use super::scanner::TextSpan;
use crate::length::Length;
use crate::tolerance::Deviations;

/// The most characters that a string parameter of a control holds.
const LONGEST: usize = 255;

/// Reads the text of QS400: `0.4-0.1` is +0.4 and −0.1, `0.4` is +0.4 and 0, `-0.1` is 0 and −0.1.
///
/// A blank text, zero, and two deviations of the same sign (`0.1+0.1`) mean no tolerance, says the manual of cycle 444.
/// A text may have point or comma, keyboard hyphen, true minus or en dash; numbers are millimetres without a unit.
///
/// ```
/// use fitcheck_core::tolerance::callout::qs400;
///
/// let deviations = qs400("0,4–0,1")?.unwrap();
/// assert_eq!((deviations.upper().to_string(), deviations.lower().to_string()), ("0.4".into(), "-0.1".into()));
/// assert_eq!(qs400(" ")?, None);
/// # Ok::<(), fitcheck_core::tolerance::CalloutError>(())
/// ```
///
/// # Errors
/// [`CalloutError`] for any other text, and for more than 255 characters; nothing is ignored.
pub fn qs400(text: &str) -> Result<Option<Deviations>, CalloutError> {
    let mut reader = Reader::new(text, Grammar::Cycle);
    if let Some((start, _)) = text.char_indices().nth(LONGEST) {
        let beyond = TextSpan { start, end: text.len() };
        return Err(reader.error(beyond, CalloutErrorKind::TooLong { most: LONGEST }));
    }
    reader.scanner.skip_blanks();
    if reader.scanner.peek().is_none() {
        return Ok(None);
    }
    let first = deviation(&mut reader)?;
    reader.scanner.skip_blanks();
    if reader.scanner.peek().is_none() {
        return Ok(band(first.value, Length::ZERO));
    }
    let start = reader.scanner.offset();
    let second = deviation(&mut reader)?;
    reader.end()?;
    match (first.sign, second.sign) {
        (_, Sign::None) => Err(reader.no_sign(&second)),
        (Sign::Minus, Sign::Plus) => Err(reader.error(reader.scanner.place_from(start), CalloutErrorKind::BandOrder)),
        (Sign::Minus, _) | (_, Sign::Plus) => Ok(None),
        _ => Ok(band(first.value, second.value)),
    }
}

fn deviation<'a>(reader: &mut Reader<'a>) -> Result<Deviation<'a>, CalloutError> {
    let deviation = reader.deviation()?;
    reader.refuse_both_and_unit(&deviation)?;
    Ok(deviation)
}

/// A band of zero width around the nominal size means no tolerance.
fn band(one: Length, other: Length) -> Option<Deviations> {
    (one != other).then(|| Deviations::spanning(one, other))
}
