//! The form of a gauge's lines, learnt from one line and the value that it gave.
//!
//! The value stands at one place of the line: with a point or a comma, in millimetres or moved by a power of ten, or in inches. A later
//! line is read only if it differs in nothing but digits and blanks, and its number has as many decimals: a gauge that was switched to
//! inches, or of whose line a part was lost, shows itself by them.

use fitcheck_core::length::{Length, LengthError, Unit};
use fitcheck_core::message::Say;
use serde::{Deserialize, Serialize};

use super::shape::{Number, Piece, are_alike, pieces};
use super::{FRAME, GaugeError, GaugeRemark, Gauged, not_an_error};

/// The form of a gauge's lines.
///
/// ```
/// use fitcheck_exchange::exchange::gauge::Taught;
///
/// let taught = Taught::by("No. 7;DIA= 250123;OK", "25.0123".parse()?)?;
/// assert_eq!(taught.read("No. 12;DIA=1250098;OK", None)?.value, "125.0098".parse()?);
/// assert!(taught.read("No. 13;DIA= 250107;NG", None).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "TaughtBy", into = "TaughtBy")]
pub struct Taught {
    line: String,
    gave: Length,
    meaning: Meaning,
}

/// The example that a form was learnt from: all that is kept of it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct TaughtBy {
    line: String,
    /// Millimetres.
    gave: String,
}

/// Why an example teaches nothing.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "teach", error)]
pub enum TeachError {
    #[say(transparent)]
    Value(#[from] LengthError),
    /// Every zero of the line could be it, in any unit.
    Zero,
    /// The line has a character that is no text.
    NotText {
        line: String,
    },
    Nowhere {
        value: Length,
        line: String,
    },
    /// At two places, or at one in two ways.
    Twice {
        value: Length,
        line: String,
    },
    /// The unit behind the number is another one.
    OtherUnit {
        value: Length,
        given: String,
    },
}

/// Where the value stands in a line, and what its digits are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Meaning {
    place: usize,
    /// What stands before the decimals; `None` where there are none.
    decimal: Option<char>,
    unit: Unit,
    /// How far the decimal sign is moved to the right.
    power: i8,
}

/// How far a gauge may move the decimal sign: from nanometres to metres, and a little more.
const POWERS: std::ops::RangeInclusive<i8> = -9..=3;

/// A number of inches with fewer decimals could be any number.
const LEAST_INCH_DECIMALS: usize = 3;

/// What lines name as units, with what a number before it is in.
const UNITS: [(&str, Unit, i8); 9] = [
    ("mm", Unit::Millimetre, 0),
    ("cm", Unit::Millimetre, 1),
    ("um", Unit::Millimetre, -3),
    ("\u{b5}m", Unit::Millimetre, -3),
    ("\u{3bc}m", Unit::Millimetre, -3),
    ("inch", Unit::Inch, 0),
    ("in", Unit::Inch, 0),
    ("\"", Unit::Inch, 0),
    ("''", Unit::Inch, 0),
];

impl Taught {
    /// Learns from a line, and the value that the gauge showed.
    ///
    /// # Errors
    /// [`TeachError`] where the value stands nowhere in the line or more than once.
    pub fn by(line: &str, gave: Length) -> Result<Self, TeachError> {
        let bare = line.trim_matches(FRAME);
        let line = || bare.to_owned();
        if gave == Length::ZERO {
            return Err(TeachError::Zero);
        }
        if has_control(bare) {
            return Err(TeachError::NotText { line: bare.replace(char::is_control, " ") });
        }
        let mut found = Vec::new();
        let mut refused = None;
        for decimal in [None, Some('.'), Some(',')] {
            let pieces = pieces(bare, decimal);
            for (place, piece) in pieces.iter().enumerate() {
                let Piece::Number(number) = piece else { continue };
                let behind = pieces.get(place + 1..).unwrap_or_default();
                // A whole number is found without a decimal sign, and one with decimals with its own.
                if number.decimals.is_empty() != decimal.is_none() || has_exponent(behind) {
                    continue;
                }
                let said = unit_of(behind);
                for (unit, power) in ways(number, gave) {
                    match said.filter(|(_, said, moved)| (*said, *moved) != (unit, power)) {
                        Some((name, ..)) => refused = Some(format!("{} {name}", text(number, decimal))),
                        None => found.push(Meaning { place, decimal, unit, power }),
                    }
                }
            }
        }
        match (found.as_slice(), refused) {
            ([meaning], _) => Ok(Self { line: line(), gave, meaning: *meaning }),
            ([], Some(given)) => Err(TeachError::OtherUnit { value: gave, given }),
            ([], None) => Err(TeachError::Nowhere { value: gave, line: line() }),
            _ => Err(TeachError::Twice { value: gave, line: line() }),
        }
    }

    /// The line that it was learnt from.
    pub fn line(&self) -> &str {
        &self.line
    }

    /// What that line gave.
    pub const fn gave(&self) -> Length {
        self.gave
    }

    /// Reads a line of this form.
    ///
    /// # Errors
    /// [`GaugeError`] where the line has another form, or its number is no length.
    pub fn read(&self, line: &str, asked: Option<Length>) -> Result<Gauged, GaugeError> {
        let bare = line.trim_matches(FRAME);
        let Meaning { place, decimal, unit, power } = self.meaning;
        let [taught, read] = [self.line.as_str(), bare].map(|line| pieces(line, decimal));
        let number_of = |pieces: &[Piece<'_>]| match pieces.get(place) {
            Some(Piece::Number(number)) => Some((number.decimals.len(), number.moved(power), text(number, decimal))),
            _ => None,
        };
        let (Some((decimals, ..)), Some((given, moved, text)), true, false) =
            (number_of(&taught), number_of(&read), are_alike(&taught, &read), has_control(bare))
        else {
            let given = bare.replace(char::is_control, " ");
            return Err(GaugeError::OtherForm { given, example: self.line.clone() });
        };
        if given != decimals {
            return Err(GaugeError::OtherDecimals { given: text, decimals: given, taught: decimals });
        }
        let value = Length::parse_in(&moved, unit)?;
        let remarks = if unit == Unit::Inch { vec![GaugeRemark::Inches { given: text }] } else { Vec::new() };
        not_an_error(bare, Gauged { value, remarks }, asked)
    }
}

/// In what ways a number is a value.
fn ways(number: &Number<'_>, value: Length) -> Vec<(Unit, i8)> {
    let is_it = |power: &i8| Length::parse_in(&number.moved(*power), Unit::Millimetre) == Ok(value);
    let mut ways: Vec<_> = POWERS.filter(is_it).map(|power| (Unit::Millimetre, power)).collect();
    let decimals = number.decimals.len();
    // The display in millimetres is rounded, so the number is what is left of it in inches.
    let in_inches = value.rounded(Unit::Inch, decimals);
    let given = Length::parse_in(&number.moved(0), Unit::Inch);
    if LEAST_INCH_DECIMALS <= decimals && given.is_ok() && given == Length::parse_in(&in_inches, Unit::Inch) {
        ways.push((Unit::Inch, 0));
    }
    ways
}

/// Whether a power of ten follows a number, which is then another one.
fn has_exponent(behind: &[Piece<'_>]) -> bool {
    matches!(behind, [Piece::Sign('e' | 'E'), Piece::Number(number), ..] if number.decimals.is_empty())
}

/// The unit that stands behind a number.
fn unit_of(behind: &[Piece<'_>]) -> Option<(&'static str, Unit, i8)> {
    let sign = |piece: &Piece<'_>| if let Piece::Sign(sign) = piece { Some(sign.to_ascii_lowercase()) } else { None };
    let signs: String = behind.iter().map_while(sign).collect();
    UNITS.into_iter().find(|(name, ..)| {
        let rest = signs.strip_prefix(name);
        // The beginning of a word is no unit.
        rest.is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
    })
}

/// A number as it stands in its line.
fn text(number: &Number<'_>, decimal: Option<char>) -> String {
    let sign = if number.is_negative { "-" } else { "" };
    match decimal.filter(|_| !number.decimals.is_empty()) {
        Some(decimal) => format!("{sign}{}{decimal}{}", number.whole, number.decimals),
        None => format!("{sign}{}", number.whole),
    }
}

/// Whether a line has a character that is no text. Tabulators are blanks.
fn has_control(line: &str) -> bool {
    line.chars().any(|sign| sign.is_control() && sign != '\t')
}

impl TryFrom<TaughtBy> for Taught {
    type Error = TeachError;

    fn try_from(example: TaughtBy) -> Result<Self, TeachError> {
        Self::by(&example.line, example.gave.parse()?)
    }
}

impl From<Taught> for TaughtBy {
    fn from(taught: Taught) -> Self {
        Self { line: taught.line, gave: taught.gave.to_string() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn taught(line: &str, gave: &str) -> Taught {
        Taught::by(line, gave.parse().unwrap()).unwrap_or_else(|error| panic!("{line}: {error}"))
    }

    #[track_caller]
    fn refused(line: &str, gave: &str) -> TeachError {
        Taught::by(line, gave.parse().unwrap()).expect_err(line)
    }

    #[test]
    fn a_line_teaches_where_the_value_stands_and_in_what() {
        for (line, gave, later, value) in [
            ("M1 25.0123 mm OK", "25.0123", "M12   9.5000 mm OK", "9.5"),
            ("01,25.0123,mm", "25.0123", "02,125.0987,mm", "125.0987"),
            ("01;25,0123;5", "25.0123", "11;24,9999;6", "24.9999"),
            ("X=   250123", "25.0123", "X=  1250123", "125.0123"),
            ("D 25012.3 \u{b5}m", "25.0123", "D 9500.0 \u{b5}m", "9.5"),
            ("D 25012.3", "25.0123", "D -13.5", "-0.0135"),
            ("CH2: -0.013", "-0.013", "CH2: +0.021", "0.021"),
            ("- 0.013", "-0.013", "  0.021", "0.021"),
            ("A1 .98472", "25.0119", "A1 1.00000", "25.4"),
            ("25,4000 1", "25.4", "25,4013 2", "25.4013"),
            ("10:42:07\t25.0123", "25.0123", "9:05:11\t25.0101", "25.0101"),
            ("\u{2}25.0123!\u{3}", "25.0123", "25.0101!\r", "25.0101"),
        ] {
            let read = taught(line, gave).read(later, None);
            assert_eq!(read.map(|gauged| gauged.value), Ok(value.parse().unwrap()), "{line}, then {later}");
        }
    }

    #[test]
    fn an_example_that_leaves_a_doubt_teaches_nothing() {
        for (line, gave) in [("", "25"), ("no value", "25"), ("25.0124", "25.0123"), ("25.0123E+01", "250.123")] {
            assert!(matches!(refused(line, gave), TeachError::Nowhere { .. }), "{line}");
        }
        for (line, gave) in
            [("25.0123 25.0123", "25.0123"), ("25.0123 250123", "25.0123"), ("1 10", "1"), ("0.984 25.0", "25")]
        {
            assert!(matches!(refused(line, gave), TeachError::Twice { .. }), "{line}");
        }
        assert_eq!(refused("0.000", "0"), TeachError::Zero);
        assert!(matches!(refused("25.0123 in", "25.0123"), TeachError::OtherUnit { .. }));
        assert!(matches!(refused("25.0123 cm", "25.0123"), TeachError::OtherUnit { .. }));
        assert!(matches!(refused("25.\u{0}0123", "25.0123"), TeachError::NotText { .. }));
        assert_eq!(
            refused("25.0124", "25.0123").to_string(),
            "25.0123 mm does not stand in the line 25.0124: type the value that the gauge showed for it"
        );
    }

    #[test]
    fn a_line_of_another_form_is_refused() {
        let gauge = taught("M1 25.0123 mm OK", "25.0123");
        for line in [
            "",
            "M1 25.0123 mm NG",
            "M1 25.0123 in OK",
            "M1 25.0123",
            "M1 mm OK",
            "M1 25,0123 mm OK",
            "M1 25.0123.4 mm OK",
            "M1 2 25.0123 mm OK",
        ] {
            let read = gauge.read(line, None);
            assert!(matches!(read, Err(GaugeError::OtherForm { .. })), "{line}: {read:?}");
        }
    }

    #[test]
    fn a_number_in_inches_or_of_a_half_line_has_other_decimals() {
        let gauge = taught("25.012", "25.012");
        for line in ["0.98472", "25.01", "25"] {
            let read = gauge.read(line, None);
            assert!(matches!(read, Err(GaugeError::OtherDecimals { .. })), "{line}: {read:?}");
        }
        assert_eq!(
            gauge.read("0.98472", None).unwrap_err().to_string(),
            "0.98472 has 5 decimals, and the line that the gauge was taught with has 3: the gauge sends another unit, or a part of the number was lost"
        );
    }

    #[test]
    fn what_is_taught_is_kept_as_its_example() {
        let gauge = taught("M1 25.0123 mm OK", "25.0123");
        let text = toml::to_string(&gauge).unwrap();
        assert_eq!(text, "line = \"M1 25.0123 mm OK\"\ngave = \"25.0123\"\n");
        assert_eq!(toml::from_str::<Taught>(&text).unwrap(), gauge);
        assert!(toml::from_str::<Taught>("line = \"25\"\ngave = \"26\"").is_err());
    }
}
