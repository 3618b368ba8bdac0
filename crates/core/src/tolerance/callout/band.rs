//! Reading deviations: `+0.01 -0.015`, `±0.02`, `+0.2/0`, `-0.1`, `+10 µm -15 µm`.

use super::error::{CalloutError, shorten};
use super::kind::{CalloutErrorKind as Kind, Part};
use super::reading::{Grammar, Number, Reader, Size};
use super::scanner::{TextSpan, is_figure, is_minus, is_sign};
use super::{Callout, PartTolerance, Tolerance, signed};
use crate::length::Length;
use crate::tolerance::Deviations;

/// The units that may follow a deviation.
const UNITS: [&str; 4] = ["mm", "\u{b5}m", "\u{3bc}m", "um"];

/// The sign before a deviation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sign {
    None,
    Plus,
    Minus,
    Both,
}

/// A deviation as it was read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Deviation<'a> {
    pub(super) sign: Sign,
    /// The value with its sign.
    pub(super) value: Length,
    number: Number<'a>,
    place: TextSpan,
}

/// The deviations of a band as they were read.
enum Pair<'a> {
    /// `±0.02`.
    Around(Deviation<'a>),
    /// `+0.2`; the other is 0.
    One(Deviation<'a>),
    /// `+0.1 -0.2`.
    Two(Deviation<'a>, Deviation<'a>),
}

/// Reads deviations without a nominal size, in the grammar of callouts: `±0.05`, `+0.1/-0.05`, `-20 µm`.
///
/// ```
/// use fitcheck_core::tolerance::callout::band;
///
/// let deviations = band("+0,1/-0,05")?;
/// assert_eq!((deviations.upper().to_string(), deviations.lower().to_string()), ("0.1".into(), "-0.05".into()));
/// # Ok::<(), fitcheck_core::tolerance::CalloutError>(())
/// ```
///
/// # Errors
/// [`CalloutError`] for any other text, also for one that begins with a size, and for a lower deviation before the upper
/// one.
pub fn band(text: &str) -> Result<Deviations, CalloutError> {
    Reader::new(text, Grammar::Callout).lone_band()
}

impl<'a> Reader<'a> {
    /// Reads one or two deviations after a size.
    pub(super) fn band(&mut self, size: Size) -> Result<Callout, CalloutError> {
        let start = self.scanner.offset();
        let callout = match self.pair()? {
            Pair::Around(one) => self.with_deviations(size, one.place, one.value, one.value.negated())?,
            Pair::One(only) => return self.single(size, &only),
            Pair::Two(first, second) => self.both(size, &first, &second)?,
        };
        self.scanner.skip_blanks();
        let Tolerance::Deviations(first) = callout.tolerance() else { return Ok(callout) };
        if !self.scanner.eat(|c| c == '/') {
            return Ok(callout);
        }
        // The second part of a fit.
        self.scanner.skip_blanks();
        let second = self.partner()?;
        let place = self.scanner.place_from(start);
        self.placed(place, Callout::of_parts(size.value, PartTolerance::Deviations(first), second))
    }

    /// Reads one or two deviations without a size.
    pub(super) fn lone_band(&mut self) -> Result<Deviations, CalloutError> {
        let deviations = self.deviations()?;
        self.end()?;
        Ok(deviations)
    }

    /// Reads the deviations of a cycle text, in either order. Behind a plus sign one alone may be a deviation without a size.
    pub(super) fn deviations_of(&mut self, size: Size) -> Result<Deviations, CalloutError> {
        let pair = self.pair()?;
        if size.plus && matches!(pair, Pair::One(_)) {
            return Err(self.no_nominal(size.place));
        }
        self.between(&pair)
    }

    /// The same with something behind them.
    pub(super) fn deviations(&mut self) -> Result<Deviations, CalloutError> {
        self.scanner.skip_blanks();
        let pair = self.pair()?;
        self.between(&pair)
    }

    fn between(&self, pair: &Pair<'a>) -> Result<Deviations, CalloutError> {
        let (one, other) = match pair {
            Pair::Around(one) => (one.value, one.value.negated()),
            Pair::One(only) if only.value == Length::ZERO => {
                let end = TextSpan { start: only.place.end, end: only.place.end };
                return Err(self.error(end, Kind::Missing { part: Part::Deviation }));
            }
            Pair::One(only) => (only.value, Length::ZERO),
            Pair::Two(first, second) if first.value < second.value && self.grammar == Grammar::Callout => {
                let place = TextSpan { start: first.place.start, end: second.place.end };
                let offer = format!("{} {}", signed(second.value), signed(first.value));
                return Err(self.error(place, Kind::LoneOrder { offer }));
            }
            Pair::Two(first, second) => (first.value, second.value),
        };
        Ok(Deviations::spanning(one, other))
    }

    fn pair(&mut self) -> Result<Pair<'a>, CalloutError> {
        let first = self.deviation()?;
        self.refuse_no_sign(&first)?;
        if first.sign == Sign::Both {
            return Ok(Pair::Around(first));
        }
        self.scanner.skip_blanks();
        let stroke = self.scanner.eat(|c| c == '/');
        self.scanner.skip_blanks();
        if !stroke && !self.scanner.peek().is_some_and(|c| is_sign(c) || is_figure(c)) {
            return Ok(Pair::One(first));
        }
        let start = self.scanner.offset();
        let second = self.deviation()?;
        self.refuse_no_sign(&second)?;
        if second.sign == Sign::Both {
            let found = shorten(self.scanner.since(start));
            return Err(self.error(second.place, Kind::NotA { part: Part::Deviation, found }));
        }
        self.refuse_one_unit(&first, &second)?;
        Ok(Pair::Two(first, second))
    }

    /// Reads a sign and a number with its unit.
    pub(super) fn deviation(&mut self) -> Result<Deviation<'a>, CalloutError> {
        let start = self.scanner.offset();
        let sign = self.sign();
        self.scanner.skip_blanks();
        let number = self.number(&UNITS, |error| Kind::Number { part: Part::Deviation, error })?;
        let Some(number) = number else { return Err(self.expected(Part::Deviation, start)) };
        let value = if sign == Sign::Minus { number.value.negated() } else { number.value };
        Ok(Deviation { sign, value, number, place: self.scanner.place_from(start) })
    }

    fn sign(&mut self) -> Sign {
        if self.scanner.eat(is_minus) {
            return Sign::Minus;
        }
        if self.scanner.eat(|c| c == '±') {
            return Sign::Both;
        }
        if !self.scanner.eat(|c| c == '+') {
            return Sign::None;
        }
        // `+/-`, and `+-` as keyboards without `±` write it.
        let mut ahead = self.scanner;
        if (ahead.eat(|c| c == '/') || self.grammar == Grammar::Callout) && ahead.eat(is_minus) {
            self.scanner = ahead;
            return Sign::Both;
        }
        Sign::Plus
    }

    /// One signed deviation, as in QS400 of cycle 444: the other one is zero.
    fn single(&self, size: Size, only: &Deviation<'_>) -> Result<Callout, CalloutError> {
        let whole = TextSpan { start: size.place.start, end: only.place.end };
        if only.value == Length::ZERO {
            let end = TextSpan { start: only.place.end, end: only.place.end };
            return Err(self.error(end, Kind::Missing { part: Part::Deviation }));
        }
        let as_deviation = self.with_deviations(size, only.place, only.value, Length::ZERO);
        // "12.01-11.985" and "12-11" may also be limits of size.
        let nominal = size.value;
        let removed = only.value.negated();
        if removed < nominal.saturating_sub(removed) {
            return as_deviation;
        }
        let Ok(limits) = Callout::with_limits(nominal.max(removed), nominal.min(removed)) else { return as_deviation };
        Err(match as_deviation {
            Ok(deviation) => {
                let limits = Box::new(limits);
                let deviation = Box::new(deviation);
                self.error(whole, Kind::LimitsOrDeviation { limits, deviation })
            }
            Err(_leaves_nothing) => self.error(whole, Kind::LimitsMeant { limits }),
        })
    }

    /// Upper and lower deviation. A callout must have the upper one first.
    fn both(&self, size: Size, first: &Deviation<'_>, second: &Deviation<'_>) -> Result<Callout, CalloutError> {
        let place = TextSpan { start: first.place.start, end: second.place.end };
        let callout = self.with_deviations(size, place, first.value, second.value)?;
        if first.value < second.value {
            return Err(self.error(place, Kind::DeviationOrder { offer: callout }));
        }
        Ok(callout)
    }

    /// A callout between two deviations in either order.
    fn with_deviations(
        &self,
        size: Size,
        place: TextSpan,
        one: Length,
        other: Length,
    ) -> Result<Callout, CalloutError> {
        self.placed(place, Callout::with_deviations(size.value, Deviations::spanning(one, other)))
    }

    /// Only zero may have no sign.
    fn refuse_no_sign(&self, deviation: &Deviation<'_>) -> Result<(), CalloutError> {
        if deviation.sign == Sign::None && deviation.value != Length::ZERO {
            return Err(self.no_sign(deviation));
        }
        Ok(())
    }

    /// The texts of QS400 have neither `±` nor units.
    pub(super) fn refuse_both_and_unit(&self, deviation: &Deviation<'_>) -> Result<(), CalloutError> {
        if deviation.sign == Sign::Both || deviation.number.unit.is_some() {
            let found = shorten(self.scanner.since(deviation.place.start));
            return Err(self.error(deviation.place, Kind::NotA { part: Part::Deviation, found }));
        }
        Ok(())
    }

    pub(super) fn no_sign(&self, deviation: &Deviation<'_>) -> CalloutError {
        self.error(deviation.place, Kind::NoSign { number: shorten(deviation.number.figures) })
    }

    /// `+10 -15 µm` may mean 10 mm or 10 µm.
    fn refuse_one_unit(&self, first: &Deviation<'_>, second: &Deviation<'_>) -> Result<(), CalloutError> {
        let micrometres = |one: &Deviation<'_>| one.number.unit.is_some_and(|unit| unit != "mm");
        let bare = |one: &Deviation<'_>| one.number.unit.is_none() && one.value != Length::ZERO;
        for (one, other) in [(first, second), (second, first)] {
            if bare(one) && micrometres(other) {
                let number = shorten(one.number.figures);
                return Err(self.error(one.number.place, Kind::NoUnit { number }));
            }
        }
        Ok(())
    }
}
