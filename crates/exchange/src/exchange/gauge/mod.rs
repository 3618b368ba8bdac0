//! What a gauge types: digits of a caliper that types like a keyboard, and the lines of gauges and their boxes.
//!
//! One reader takes them all and says what it took. Nothing is guessed: a text with a second number, or with anything that is not known, is
//! refused, and so is the text by which a gauge tells an error.
//!
//! | text | what |
//! |---|---|
//! | `25,012` `+0025.012` | millimetres, with comma or point, sign and leading zeros |
//! | `01A+0000.123` | a channel and its value, millimetres |
//! | `01A+00.12345` | the same in inches: two digits before the point and five after it |
//! | `+  2.1380, MM` | millimetres, or inches with `IN` |
//! | `25.012 mm =` `25.012<` | a unit, and the gauge's own opinion of its limits, which is told and decides nothing |
//! | STX, ETX, CR, LF | left out at the ends; within a text they are between two numbers |
//! | `911` to `919` | an error of a Mitutoyo gauge or its box, and no value, unless the size asked for is near it |
//!
//! What is typed without a unit is in millimetres; of a line from a port [`LineUnit`] says so. Lines of no form above are learnt from an
//! example: `taught`. Lines that were saved in a file are read by `saved`.

mod saved;
mod shape;
mod taught;

use fitcheck_core::length::{Length, LengthError, Unit};
use fitcheck_core::message::Say;
use serde::{Deserialize, Serialize};

pub(super) use saved::FORMAT;
pub use taught::{Taught, TaughtBy, TeachError};

/// What was taken from a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Gauged {
    pub value: Length,
    /// What was more than a number in millimetres, in its order; none for a plain number.
    pub remarks: Vec<GaugeRemark>,
}

/// What a text had besides a number.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "gauge")]
pub enum GaugeRemark {
    /// Signs that frame a line were left out.
    Frame,
    /// It names the channel of the gauge.
    Channel {
        channel: String,
    },
    Inches {
        given: String,
    },
    /// The gauge's own limits: within, above or below them. Fitcheck's limits decide.
    Opinion {
        sign: char,
    },
}

/// Why a text is no value.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "gauge", error)]
pub enum GaugeError {
    /// It is no number, or more than one.
    #[say(transparent)]
    Number(#[from] LengthError),
    /// It may be the number of an error: the gauge has not measured.
    ErrorText { given: String },
    /// It names no unit, and nobody has said which one the gauge sends.
    NoUnit { given: String },
    /// It differs from the taught line in more than digits and blanks.
    OtherForm { given: String, example: String },
    /// The number has more or fewer decimals than that of the taught line: another unit, or a part of a number.
    OtherDecimals { given: String, decimals: usize, taught: usize },
}

/// What a number without a unit is in.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LineUnit {
    /// Nothing: the line says its unit, or is refused.
    #[default]
    Said,
    Mm,
    Inch,
}

impl LineUnit {
    pub const ALL: [Self; 3] = [Self::Said, Self::Mm, Self::Inch];
}

/// How far the size asked for may be from a number that could be that of an error, 10 mm.
const NEAR: Length = Length::from_micrometres(10_000);

/// Reads what a gauge has typed.
///
/// ```
/// use fitcheck_exchange::exchange::gauge;
///
/// assert_eq!(gauge::read("\u{2}01A+0025.012\u{3}", None)?.value, "25.012".parse()?);
/// assert_eq!(gauge::read("25,012 mm =", None)?.value, "25.012".parse()?);
/// assert!(gauge::read("25,012 25,013", None).is_err());
/// // A number that could be that of an error is one, unless such a size is asked for.
/// assert!(gauge::read("911", Some("25".parse()?)).is_err());
/// assert!(gauge::read("911", Some("910".parse()?)).is_ok());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`GaugeError`] with what was given.
pub fn read(text: &str, asked: Option<Length>) -> Result<Gauged, GaugeError> {
    read_line(text, LineUnit::Mm, asked)
}

/// Reads a line of a gauge of which is known what its numbers without a unit are in.
///
/// ```
/// use fitcheck_exchange::exchange::gauge::{self, LineUnit};
///
/// assert!(gauge::read_line("0.98472", LineUnit::Said, None).is_err());
/// assert_eq!(gauge::read_line("0.98472", LineUnit::Inch, None)?.value, "25.011888".parse()?);
/// assert_eq!(gauge::read_line("25.012 mm", LineUnit::Inch, None)?.value, "25.012".parse()?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`GaugeError`] with what was given.
pub fn read_line(text: &str, unit: LineUnit, asked: Option<Length>) -> Result<Gauged, GaugeError> {
    let gauged = number(text, unit)?;
    not_an_error(text, gauged, asked)
}

/// A value, unless its text may be the number of an error.
fn not_an_error(text: &str, gauged: Gauged, asked: Option<Length>) -> Result<Gauged, GaugeError> {
    let bare = text.trim_matches(FRAME);
    let is_near = asked.is_some_and(|asked| asked.saturating_sub(gauged.value).abs() <= NEAR);
    if is_error_text(bare) && !is_near {
        return Err(GaugeError::ErrorText { given: bare.to_owned() });
    }
    Ok(gauged)
}

/// The signs around a line, and blanks.
const FRAME: [char; 6] = ['\u{2}', '\u{3}', '\r', '\n', '\t', ' '];

/// Three digits that begin with 91, and nothing else.
fn is_error_text(bare: &str) -> bool {
    bare.len() == 3 && bare.starts_with("91") && bare.bytes().all(|byte| byte.is_ascii_digit())
}

fn number(text: &str, unit: LineUnit) -> Result<Gauged, GaugeError> {
    let mut remarks = Vec::new();
    let bare = text.trim_matches(FRAME);
    if bare.contains(char::is_control) {
        return Err(LengthError::NotANumber { text: bare.replace(char::is_control, " ") }.into());
    }
    if bare.len() != text.trim_matches(['\r', '\n', '\t', ' ']).len() {
        remarks.push(GaugeRemark::Frame);
    }
    let (channel, rest) = channel(bare.trim());
    remarks.extend(channel.map(|channel| GaugeRemark::Channel { channel: channel.to_owned() }));
    let mut number = rest;
    if let Some(sign) = number.chars().last().filter(|sign| matches!(sign, '<' | '=' | '>')) {
        remarks.push(GaugeRemark::Opinion { sign });
        number = number.strip_suffix(sign).unwrap_or(number).trim_end();
    }
    let lower = number.to_ascii_lowercase();
    // A comma between the number and its unit, and the unit in capitals.
    let with_comma =
        number.rsplit_once(',').map(|(figure, unit)| (figure.trim_end(), unit.trim().to_ascii_lowercase()));
    let with_blank = with_comma.filter(|(_, unit)| matches!(unit.as_str(), "mm" | "in" | "inch"));
    let with_blank = with_blank.map(|(figure, unit)| format!("{figure} {unit}"));
    let lower = with_blank.clone().unwrap_or(lower);
    let number = with_blank.as_deref().unwrap_or(number);
    let inches = ["inch", "in", "\"", "''"].into_iter().find(|unit| lower.ends_with(unit));
    let given = inches.and_then(|unit| number.get(..number.len() - unit.len())).map(str::trim_end);
    // A box that sends a channel tells the unit by its digits alone.
    let given = given.or_else(|| channel.is_some().then_some(number).filter(|number| is_inch_of_channel(number)));
    let is_said = given.is_some() || channel.is_some() || METRIC.iter().any(|unit| number.ends_with(unit));
    let given = given.or_else(|| (!is_said && unit == LineUnit::Inch).then_some(number));
    let given_text = || LengthError::NotANumber { text: bare.trim().to_owned() };
    let told = |error: LengthError| if error == LengthError::Empty && !rest.is_empty() { given_text() } else { error };
    let value = match given {
        Some(given) => {
            // A number in inches with a metric unit behind it is neither.
            if given.contains(char::is_alphabetic) {
                return Err(given_text().into());
            }
            remarks.push(GaugeRemark::Inches { given: given.to_owned() });
            Length::parse_in(&joined(given), Unit::Inch).map_err(told)?
        }
        None => Length::parse_in(&joined(number), Unit::Millimetre).map_err(told)?,
    };
    if !is_said && unit == LineUnit::Said {
        return Err(GaugeError::NoUnit { given: bare.trim().to_owned() });
    }
    Ok(Gauged { value, remarks })
}

/// The units that a length reads by itself.
const METRIC: [&str; 4] = ["mm", "um", "\u{b5}m", "\u{3bc}m"];

/// The channel before a value, and the rest: two digits and an A.
fn channel(text: &str) -> (Option<&str>, &str) {
    let is_channel = |head: &str| {
        let mut chars = head.chars();
        chars.by_ref().take(2).all(|c| c.is_ascii_digit()) && matches!(chars.next(), Some('A' | 'a'))
    };
    match (text.get(..3).filter(|head| is_channel(head)), text.get(3..)) {
        (Some(head), Some(rest)) if rest.starts_with(['+', '-']) => (head.get(..2), rest),
        _ => (None, text),
    }
}

/// A sign, two digits, a decimal sign and five digits.
fn is_inch_of_channel(number: &str) -> bool {
    let digits = number.trim_start_matches(['+', '-']);
    let parts = digits.split_once(['.', ',']);
    parts.is_some_and(|(whole, decimals)| whole.len() == 2 && decimals.len() == 5)
}

/// A sign stands at its number.
fn joined(number: &str) -> String {
    let number = number.trim();
    match number.strip_prefix(['+', '-', '\u{2212}']) {
        Some(digits) => format!("{}{}", number.chars().next().unwrap_or('+'), digits.trim_start()),
        None => number.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gauges_of_all_kinds_give_their_value_and_what_was_taken() {
        for (text, mm, remarks) in [
            ("25,012", "25.012", 0),
            ("+0025.012\r\n", "25.012", 0),
            ("-000.0130", "-0.013", 0),
            ("- 0.013", "-0.013", 0),
            ("\u{2}25.012\u{3}", "25.012", 1),
            ("01A+0000.123", "0.123", 1),
            ("01A-0000.123\r", "-0.123", 1),
            ("01A+01.12345", "28.53563", 2),
            ("25.012 mm =", "25.012", 1),
            ("25.012mm<", "25.012", 1),
            ("25.012>", "25.012", 1),
            ("0.98472 in", "25.011888", 1),
            ("0.5\"", "12.7", 1),
            ("\u{2}02A+0012.030\u{3}\r\n", "12.03", 2),
        ] {
            let gauged = read(text, None).unwrap_or_else(|error| panic!("{text:?}: {error}"));
            assert_eq!((gauged.value, gauged.remarks.len()), (mm.parse().unwrap(), remarks), "{text:?}");
        }
    }

    #[test]
    fn a_number_without_a_unit_is_in_what_the_gauge_is_said_to_send() {
        let read_in = |text: &str, unit| read_line(text, unit, None).map(|gauged| gauged.value.to_string());
        for (text, [said, mm, inch]) in [
            ("25.012", ["", "25.012", "635.3048"]),
            ("25.012 mm", ["25.012"; 3]),
            ("25012 um", ["25.012"; 3]),
            ("0.98472in", ["25.011888"; 3]),
            ("01A+0000.123", ["0.123"; 3]),
            ("01A+00.12345", ["3.13563"; 3]),
            ("25.012=", ["", "25.012", "635.3048"]),
        ] {
            for (unit, wanted) in LineUnit::ALL.into_iter().zip([said, mm, inch]) {
                match read_in(text, unit) {
                    Ok(value) => assert_eq!(value, wanted, "{text} {unit:?}"),
                    Err(error) => {
                        assert!(wanted.is_empty() && matches!(error, GaugeError::NoUnit { .. }), "{text}: {error}");
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_no_single_number_is_refused_with_what_was_given() {
        for text in ["", "=", "25,012 25,013", "A1", "01A", "25.012 mm in", "1.234,5", "25.012 kg", "01A+00x12"] {
            let read = read(text, None);
            assert!(read.is_err(), "{text:?}: {read:?}");
        }
    }

    #[test]
    fn two_numbers_with_a_control_sign_between_them_are_not_one() {
        for text in ["25.0\t12", "25\t013", "25.0\r\n12", "\u{2}25\u{3}\u{2}013\u{3}", "25.\u{0}1", "\u{4}25.1"] {
            let read = read(text, None);
            assert!(matches!(read, Err(GaugeError::Number(_))), "{text:?}: {read:?}");
        }
        assert_eq!(read("25\t013", None).unwrap_err().to_string(), "25 013 is not a number");
    }

    #[test]
    fn the_number_of_an_error_is_no_value_unless_such_a_size_is_asked_for() {
        let size = |text: &str| Some(text.parse::<Length>().unwrap());
        for text in ["911", "912\r\n", "\u{2}919\u{3}"] {
            for asked in [None, size("25"), size("800")] {
                let read = read(text, asked);
                assert!(matches!(read, Err(GaugeError::ErrorText { .. })), "{text:?}: {read:?}");
            }
            assert!(read(text, size("910")).is_ok(), "{text:?}");
        }
        for text in ["911.0", "+911", "911 mm", "91", "9110", "921"] {
            assert!(read(text, size("25")).is_ok(), "{text:?}");
        }
    }
}
