//! Lengths: a signed whole number of nanometres.
//!
//! Sizes, deviations and limits are compared exactly, so none of them is ever a float. This file is the only
//! place where text becomes a length, a length becomes text, and a length meets `f64` (once per direction, for
//! circle fits and plots). It knows nothing of tolerances, tables or languages.

mod decimal;
mod line;
mod plain;
mod rounded;

use std::fmt;
use std::str::FromStr;

use line::ROOM;
pub use line::{Line, Window};

use crate::message::{Arg, IntoArg, Say};

/// Nanometres in a millimetre.
const NM_PER_MM: i64 = 1_000_000;

/// A signed length in whole nanometres, at most [`Length::MAX`] either way.
///
/// The bound (a thousand kilometres) is far beyond any machine and keeps every length exact in an `f64`, too.
///
/// ```
/// use fitcheck_core::length::Length;
///
/// let measured: Length = "25,0120 mm".parse()?;
/// assert_eq!(measured.nanometres(), 25_012_000);
/// assert_eq!(measured.to_string(), "25.012");
/// # Ok::<(), fitcheck_core::length::LengthError>(())
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Length(i64);

/// The unit in which a number without a unit of its own is read, or in which a length is printed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Unit {
    /// Millimetres.
    #[default]
    Millimetre,
    /// Micrometres.
    Micrometre,
    /// Inches of exactly 25.4 mm.
    Inch,
}

impl Unit {
    /// Nanometres in one of this unit.
    const fn nanometres(self) -> i64 {
        match self {
            Self::Millimetre => NM_PER_MM,
            Self::Micrometre => 1_000,
            Self::Inch => 25_400_000,
        }
    }

    /// Nanometres in one of its last decimal, where that is a whole number of them.
    #[inline]
    fn last_decimal(self, decimals: usize) -> Option<i64> {
        let all: &[i64] = match self {
            Self::Millimetre => &[NM_PER_MM, 100_000, 10_000, 1_000, 100, 10, 1],
            Self::Micrometre => &[1_000, 100, 10, 1],
            Self::Inch => &[25_400_000, 2_540_000, 254_000, 25_400, 2_540, 254],
        };
        all.get(decimals).copied()
    }
}

/// Why a text or a number is not a length.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "length", error)]
pub enum LengthError {
    /// There is no text.
    Empty,
    /// The text is not a decimal number with an optional unit.
    NotANumber {
        /// What was given.
        text: String,
    },
    /// Point and comma both occur, so either could be the decimal sign.
    Ambiguous {
        /// What was given.
        text: String,
    },
    /// There are figures beyond the nanometre.
    TooFine {
        /// What was given.
        text: String,
    },
    /// The length is beyond [`Length::MAX`].
    #[say(args(max = Length::MAX))]
    TooLarge {
        /// What was given.
        text: String,
    },
}

/// In millimetres, without its unit.
impl IntoArg for Length {
    fn arg(&self) -> Arg {
        Arg::Number(self.to_string())
    }
}

impl Length {
    /// A length of zero.
    pub const ZERO: Self = Self(0);
    /// The largest length, 1 000 000 000 mm; the smallest is its opposite.
    pub const MAX: Self = Self(1_000_000_000 * NM_PER_MM);

    /// A length of this many nanometres.
    ///
    /// # Errors
    /// [`LengthError::TooLarge`] beyond [`Length::MAX`].
    pub fn from_nanometres(nm: i64) -> Result<Self, LengthError> {
        if Self::MAX.0.unsigned_abs() < nm.unsigned_abs() {
            return Err(LengthError::TooLarge { text: format!("{nm} nm") });
        }
        Ok(Self(nm))
    }

    /// A length of this many micrometres, for constants in the code: any `i32` is in range.
    pub const fn from_micrometres(um: i32) -> Self {
        // `as` widens here; `From` is not const.
        #[expect(clippy::as_conversions, reason = "widening in a const function")]
        Self(um as i64 * 1_000)
    }

    /// A length of this many nanometres, for declarations in the code: the caller stays within [`Length::MAX`].
    pub const fn constant(nm: i64) -> Self {
        Self(nm)
    }

    /// The whole number of nanometres.
    pub const fn nanometres(self) -> i64 {
        self.0
    }

    /// Reads a number in `unit` unless the text names its own (`mm`, `µm`, `um`): decimal point or comma, optional
    /// sign (`+`, `-` or U+2212), exact to the nanometre.
    ///
    /// ```
    /// use fitcheck_core::length::{Length, Unit};
    ///
    /// assert_eq!(Length::parse_in("+7,5", Unit::Micrometre)?.nanometres(), 7_500);
    /// assert_eq!(Length::parse_in("1.0005", Unit::Inch)?.to_string(), "25.4127");
    /// assert!(Length::parse_in("1.234,5", Unit::Millimetre).is_err());
    /// # Ok::<(), fitcheck_core::length::LengthError>(())
    /// ```
    ///
    /// # Errors
    /// [`LengthError`] says what is wrong with the text; nothing is rounded or guessed.
    pub fn parse_in(text: &str, unit: Unit) -> Result<Self, LengthError> {
        if let Some((length, _)) = Self::plain(text.as_bytes(), 0, text.len(), unit) {
            return Ok(length);
        }
        let given = text.trim();
        if given.is_empty() {
            return Err(LengthError::Empty);
        }
        let (number, unit) = split_unit(given, unit);
        let negative = number.starts_with(['-', '\u{2212}']);
        let digits = number.strip_prefix(['+', '-', '\u{2212}']).unwrap_or(number);
        let nm = decimal_nanometres(digits, unit, given)?;
        Self::from_nanometres(if negative { -nm } else { nm })
            .map_err(|_range| LengthError::TooLarge { text: given.to_owned() })
    }

    /// Reads what most numbers are, from the bytes of a text between `start` and `end`: up to nine digits, and up to six more
    /// after a decimal sign, which is given with it. `None` for anything else, which [`Length::parse_in`] may still read.
    #[expect(clippy::inline_always, reason = "its answer stays in registers, for each of millions of rows")]
    #[inline(always)]
    pub fn plain(text: &[u8], start: usize, end: usize, unit: Unit) -> Option<(Self, Option<u8>)> {
        let plain = plain::read(text, start, end)?;
        let factor = unit.last_decimal(plain.decimals)?;
        let nm = i64::try_from(plain.number).ok()?.checked_mul(factor)?;
        Some((Self::within(nm)?, plain.sign))
    }

    /// The sum, or `None` beyond [`Length::MAX`].
    #[inline]
    pub fn checked_add(self, other: Self) -> Option<Self> {
        Self::within(self.0.checked_add(other.0)?)
    }

    /// So many nanometres, or `None` beyond [`Length::MAX`].
    #[inline]
    fn within(nm: i64) -> Option<Self> {
        (nm.unsigned_abs() <= Self::MAX.0.unsigned_abs()).then_some(Self(nm))
    }

    /// The difference, or `None` beyond [`Length::MAX`].
    #[inline]
    pub fn checked_sub(self, other: Self) -> Option<Self> {
        Self::within(self.0.checked_sub(other.0)?)
    }

    /// The difference, at most [`Length::MAX`] either way: for distances that are shown, never for limits.
    #[must_use]
    #[inline]
    pub fn saturating_sub(self, other: Self) -> Self {
        // Two lengths are at most 2e15 nm apart, far inside i64.
        Self((self.0 - other.0).clamp(-Self::MAX.0, Self::MAX.0))
    }

    /// The middle between two lengths, with a half nanometre rounded towards the larger.
    #[must_use]
    #[inline]
    pub fn midpoint(self, other: Self) -> Self {
        let sum = self.0 + other.0;
        Self(sum.div_euclid(2) + sum.rem_euclid(2))
    }

    /// The length without its sign.
    #[must_use]
    #[inline]
    pub const fn abs(self) -> Self {
        Self(self.0.abs())
    }

    /// The length with the other sign.
    #[must_use]
    #[inline]
    pub const fn negated(self) -> Self {
        Self(-self.0)
    }

    /// Millimetres as a float, for geometry and plots. Exact to the last bit that an `f64` has.
    #[expect(clippy::as_conversions, clippy::cast_precision_loss, reason = "below 2^53 nm, so the cast is exact")]
    pub fn to_mm_f64(self) -> f64 {
        self.0 as f64 / 1e6
    }

    /// Micrometres as the nearest float, for figures and plots.
    #[expect(clippy::as_conversions, clippy::cast_precision_loss, reason = "below 2^53 nm, so the cast is exact")]
    pub fn to_um_f64(self) -> f64 {
        self.0 as f64 / 1e3
    }

    /// The nearest whole nanometre to a geometric result in millimetres.
    ///
    /// # Errors
    /// [`LengthError::NotANumber`] for NaN and infinities, [`LengthError::TooLarge`] beyond [`Length::MAX`].
    pub fn from_mm_f64(mm: f64) -> Result<Self, LengthError> {
        if !mm.is_finite() {
            return Err(LengthError::NotANumber { text: mm.to_string() });
        }
        let nm = (mm * 1e6).round();
        if Self::MAX.to_mm_f64() * 1e6 < nm.abs() {
            return Err(LengthError::TooLarge { text: format!("{mm} mm") });
        }
        #[expect(
            clippy::as_conversions,
            clippy::cast_possible_truncation,
            reason = "finite and in range, just checked"
        )]
        Ok(Self(nm as i64))
    }

    /// The exact number in `unit`, with a point and only the decimals it has, but at least `decimals`.
    ///
    /// Inches are not printed exactly (1 nm has no finite number of decimals); they are rounded to 7 decimals.
    pub fn exact(self, unit: Unit, decimals: usize) -> String {
        match (unit, u8::try_from(decimals)) {
            (Unit::Millimetre, Ok(least @ ..=6)) => Self::text(|out| self.put_mm(least, out)),
            (Unit::Micrometre, Ok(least @ ..=3)) => Self::text(|out| self.put_um(least, out)),
            (Unit::Inch, _) => self.rounded_up_to(unit, 7.max(decimals), decimals),
            (Unit::Millimetre | Unit::Micrometre, _) => self.rounded(unit, decimals),
        }
    }

    /// A text of ASCII.
    fn text(write: impl FnOnce(&mut Window<'_>)) -> String {
        let mut bytes = [0; ROOM];
        let mut window = Window::new(&mut bytes);
        write(&mut window);
        String::from_utf8_lossy(window.bytes()).into_owned()
    }

    /// Appends what [`Length::exact`] gives in millimetres, with at least `least` decimals, at most 6 of them.
    #[inline]
    pub fn put_mm(self, least: u8, out: &mut Window<'_>) {
        decimal::put::<1_000_000>(self.0, least, out);
    }

    /// Appends what [`Length::exact`] gives in micrometres, with at least `least` decimals, at most 3 of them.
    #[inline]
    pub fn put_um(self, least: u8, out: &mut Window<'_>) {
        decimal::put::<1_000>(self.0, least, out);
    }

    /// The number in `unit` rounded to `most` decimals, without the last ones where they are zero, but at least `least`.
    fn rounded_up_to(self, unit: Unit, most: usize, least: usize) -> String {
        let mut text = self.rounded(unit, most);
        if let Some(point) = text.find('.') {
            let digits = text.trim_end_matches('0').len();
            text.truncate(digits.max(point + 1 + least));
            if text.ends_with('.') {
                text.pop();
            }
        }
        text
    }

    /// Micrometres exactly, with a sign unless zero: `+21`, `-7.5`, `0`.
    pub fn signed_um(self) -> String {
        let plus = if Self::ZERO < self { "+" } else { "" };
        format!("{plus}{}", self.exact(Unit::Micrometre, 0))
    }

    /// The number in `unit` with exactly this many decimals, rounded half away from zero, with a point.
    pub fn rounded(self, unit: Unit, decimals: usize) -> String {
        let magnitude = i128::from(self.0).unsigned_abs();
        let one = i128::from(unit.nanometres()).unsigned_abs();
        // 12 decimals are more than any unit needs; beyond that the number is padded with zeros.
        let kept = decimals.min(12);
        let scale = (0..kept).fold(1_u128, |scale, _| scale * 10);
        let scaled = (magnitude * scale * 2 + one) / (one * 2);
        let sign = if self.0.is_negative() && scaled != 0 { "-" } else { "" };
        if decimals == 0 {
            return format!("{sign}{scaled}");
        }
        let padding = decimals - kept;
        format!("{sign}{}.{:0kept$}{:0<padding$}", scaled / scale, scaled % scale, "")
    }
}

/// A printed number without the zeros at the end of its decimals: `1.5` for `1.500`, `20` for `20.0` and for `20`.
pub fn without_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// The figures of an unsigned decimal number before and behind its sign; `None` for any other text.
pub fn decimal_parts(number: &str) -> Option<(&str, &str)> {
    let (whole, decimals) = number.split_once(['.', ',']).unwrap_or((number, ""));
    let are_figures = [whole, decimals].iter().all(|part| part.bytes().all(|byte| byte.is_ascii_digit()));
    (are_figures && !(whole.is_empty() && decimals.is_empty())).then_some((whole, decimals))
}

/// Splits a unit off the end of a number.
fn split_unit(text: &str, unit: Unit) -> (&str, Unit) {
    for (suffix, named) in [
        ("mm", Unit::Millimetre),
        ("\u{b5}m", Unit::Micrometre),
        ("\u{3bc}m", Unit::Micrometre),
        ("um", Unit::Micrometre),
    ] {
        if let Some(number) = text.strip_suffix(suffix) {
            return (number.trim_end(), named);
        }
    }
    (text, unit)
}

/// The nanometres of an unsigned decimal number; `given` is the whole text, for errors.
fn decimal_nanometres(digits: &str, unit: Unit, given: &str) -> Result<i64, LengthError> {
    let text = || given.to_owned();
    if digits.contains('.') && digits.contains(',') && digits.bytes().all(|b| b.is_ascii_digit() || b".,".contains(&b))
    {
        return Err(LengthError::Ambiguous { text: text() });
    }
    let (whole, decimals) = decimal_parts(digits).ok_or_else(|| LengthError::NotANumber { text: text() })?;
    let decimals = decimals.trim_end_matches('0');
    // Micrometres end at the nanometre after 3 decimals, millimetres after 6, and inches as well: 0.000005 in are 127 nm,
    // and a seventh decimal leaves a part of one. Beyond that the number is finer, whatever its figures.
    if 6 < decimals.len() {
        return Err(LengthError::TooFine { text: text() });
    }
    let too_large = || LengthError::TooLarge { text: text() };
    let number = |part: &str| match part.trim_start_matches('0') {
        "" => Ok(0),
        part if 18 < part.len() => Err(too_large()),
        part => part.parse::<i128>().map_err(|_figures| too_large()),
    };
    let scale = decimals.bytes().fold(1_i128, |scale, _| scale * 10);
    let scaled = (number(whole)? * scale + number(decimals)?) * i128::from(unit.nanometres());
    if scaled % scale != 0 {
        return Err(LengthError::TooFine { text: text() });
    }
    i64::try_from(scaled / scale).map_err(|_range| too_large())
}

impl FromStr for Length {
    type Err = LengthError;

    /// Reads millimetres, or the unit that the text names.
    fn from_str(text: &str) -> Result<Self, LengthError> {
        Self::parse_in(text, Unit::Millimetre)
    }
}

/// Millimetres with a point and only the decimals it has: `25`, `25.5`, `-0.000001`.
impl fmt::Display for Length {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.exact(Unit::Millimetre, 0))
    }
}
