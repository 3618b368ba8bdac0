//! A text as a length: the answer is that of a computation on paper, and what is printed reads back.

use fitcheck::control::variables::Parameter;
use fitcheck::length::{Length, LengthError, Unit};
use fitcheck::probing::cycle::Angle;

use super::decimal::Decimal;
use super::shared::{Figures, told};

/// The longest length in nanometres.
const MOST: &str = "1000000000000000";

pub fn run(bytes: &[u8]) {
    let mut figures = Figures(bytes);
    let unit = figures.one_of(&[Unit::Millimetre, Unit::Micrometre, Unit::Inch]);
    let Ok(text) = std::str::from_utf8(figures.0) else { return };
    let found = Length::parse_in(text, unit);
    match (&found, on_paper(text, unit)) {
        (Ok(length), Ok(nanometres)) => assert_eq!(length.nanometres().to_string(), nanometres.rounded(0).text()),
        (Err(error), Err(allowed)) => {
            let kind = Kind::of(error);
            assert!(allowed.contains(&kind), "{text:?} is {kind:?}, not {allowed:?}");
            told(bytes, error);
        }
        (found, expected) => panic!("{text:?}: {found:?} instead of {expected:?}"),
    }
    if let Ok(length) = found {
        is_printed(length);
    }
    if let Ok(angle) = text.parse::<Angle>() {
        assert_eq!(angle.to_string().parse(), Ok(angle));
    }
    if let Ok(parameter) = text.parse::<Parameter>() {
        assert_eq!(parameter.to_string().parse(), Ok(parameter));
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Empty,
    NotANumber,
    Ambiguous,
    TooFine,
    TooLarge,
}

impl Kind {
    const fn of(error: &LengthError) -> Self {
        match error {
            LengthError::Empty => Self::Empty,
            LengthError::NotANumber { .. } => Self::NotANumber,
            LengthError::Ambiguous { .. } => Self::Ambiguous,
            LengthError::TooFine { .. } => Self::TooFine,
            LengthError::TooLarge { .. } => Self::TooLarge,
        }
    }
}

/// Nanometres, or what may be said against the text.
fn on_paper(text: &str, unit: Unit) -> Result<Decimal, Vec<Kind>> {
    let text = text.trim();
    if text.is_empty() {
        return Err(vec![Kind::Empty]);
    }
    let units =
        [("mm", Unit::Millimetre), ("µm", Unit::Micrometre), ("μm", Unit::Micrometre), ("um", Unit::Micrometre)];
    let named = units.iter().find_map(|(name, named)| Some((text.strip_suffix(name)?.trim_end(), *named)));
    let (number, unit) = named.unwrap_or((text, unit));
    let digits = number.strip_prefix(['+', '-', '−']).unwrap_or(number);
    let is_sound = |part: &str| part.chars().all(|digit| digit.is_ascii_digit());
    let signs = digits.matches(['.', ',']).count();
    if digits.contains('.') && digits.contains(',') && is_sound(&digits.replace(['.', ','], "")) {
        return Err(vec![Kind::Ambiguous]);
    }
    if 1 < signs || digits.len() == signs || !is_sound(&digits.replace(['.', ','], "")) {
        return Err(vec![Kind::NotANumber]);
    }
    let (whole, decimals) = digits.split_once(['.', ',']).unwrap_or((digits, ""));
    let number = Decimal::of(number.starts_with(['-', '−']), whole, decimals);
    let nanometres = match unit {
        Unit::Millimetre => number.times_ten_to(6),
        Unit::Micrometre => number.times_ten_to(3),
        Unit::Inch => number.times(254).times_ten_to(5),
    };
    let mut wrong = Vec::new();
    if !nanometres.is_whole() {
        wrong.push(Kind::TooFine);
    }
    let size = nanometres.text().trim_start_matches('-').to_owned();
    let whole = size.split('.').next().unwrap_or_default();
    let is_beyond = (MOST.len(), MOST) < (whole.len(), whole) || whole == MOST && !nanometres.is_whole();
    if is_beyond {
        wrong.push(Kind::TooLarge);
    }
    if wrong.is_empty() { Ok(nanometres) } else { Err(wrong) }
}

fn is_printed(length: Length) {
    for unit in [Unit::Millimetre, Unit::Micrometre] {
        for decimals in [0, 4] {
            assert_eq!(Length::parse_in(&length.exact(unit, decimals), unit), Ok(length));
        }
    }
    assert_eq!(length.to_string().parse(), Ok(length));
    assert_eq!(Length::from_mm_f64(length.to_mm_f64()), Ok(length));
    let nanometres = Decimal::plain(&length.nanometres().to_string());
    for decimals in [0, 1, 3, 4, 6, 14] {
        let millimetres = nanometres.clone().over_ten_to(6).rounded(decimals);
        assert_eq!(length.rounded(Unit::Millimetre, decimals), millimetres.text());
    }
}
