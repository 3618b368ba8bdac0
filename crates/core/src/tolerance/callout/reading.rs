//! Reading the grammar of callouts: size, then a class, a fit, a general class or limits; deviations are in `band`.

use super::error::{CalloutError, shorten, shorten_length};
use super::kind::{CalloutErrorKind as Kind, Part};
use super::scanner::{Scanner, TextSpan, is_decimal_sign, is_figure, is_minus, is_sign};
use super::{Callout, PartTolerance};
use crate::length::{Length, LengthError};
use crate::tolerance::{ClassError, GeneralClass, ToleranceClass};

/// The unit that may follow a size.
const SIZE_UNITS: [&str; 1] = ["mm"];

/// What a text may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Grammar {
    /// A callout.
    Callout,
    /// A text of cycles 14xx or of QS400.
    Cycle,
}

/// A text that is being read as a callout.
#[derive(Debug)]
pub(super) struct Reader<'a> {
    pub(super) scanner: Scanner<'a>,
    pub(super) grammar: Grammar,
    /// The decimal sign of the first number that has one.
    decimal_sign: Option<char>,
}

/// A number without its sign, as it was read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Number<'a> {
    pub(super) value: Length,
    /// The figures alone.
    pub(super) figures: &'a str,
    pub(super) unit: Option<&'static str>,
    pub(super) place: TextSpan,
}

/// The size at the beginning.
#[derive(Debug, Clone, Copy)]
pub(super) struct Size {
    pub(super) value: Length,
    /// Whether it has a plus sign.
    pub(super) plus: bool,
    pub(super) place: TextSpan,
}

/// Reads a callout.
pub(super) fn callout(text: &str) -> Result<Callout, CalloutError> {
    let mut reader = Reader::new(text, Grammar::Callout);
    let size = reader.size()?;
    let callout = reader.tolerance(size)?;
    reader.end()?;
    Ok(callout)
}

/// The halves of a callout while it is typed: its size, and everything after it, both as given; either may be empty.
///
/// ```
/// use fitcheck_core::tolerance::callout::halves;
///
/// assert_eq!(halves(" Ø25,5js6"), ("25,5", "js6"));
/// assert_eq!(halves("12 +0.1 -"), ("12", "+0.1 -"));
/// ```
pub fn halves(text: &str) -> (&str, &str) {
    let mut scanner = Scanner::new(text.trim());
    skip_diameter_signs(&mut scanner);
    let start = scanner.offset();
    scanner.eat(|c| c == '+' || is_minus(c));
    scanner.take_while(is_figure);
    (scanner.since(start), scanner.rest().trim_start())
}

/// Ø as drawings, keyboards and fonts have it.
pub(super) const fn is_diameter_sign(c: char) -> bool {
    matches!(c, 'Ø' | 'ø' | '\u{2300}' | '\u{2205}' | 'φ' | 'Φ' | 'ϕ')
}

fn skip_diameter_signs(scanner: &mut Scanner<'_>) {
    scanner.take_while(is_diameter_sign);
    scanner.skip_blanks();
}

impl<'a> Reader<'a> {
    pub(super) const fn new(text: &'a str, grammar: Grammar) -> Self {
        Self { scanner: Scanner::new(text), grammar, decimal_sign: None }
    }

    /// An error at a place.
    pub(super) fn error(&self, place: TextSpan, kind: Kind) -> CalloutError {
        CalloutError::at(self.scanner.text(), place, kind)
    }

    /// The same result, with its error at a place.
    pub(super) fn placed<T>(&self, place: TextSpan, result: Result<T, CalloutError>) -> Result<T, CalloutError> {
        result.map_err(|error| error.placed(self.scanner.text(), place))
    }

    /// The place of the next character, or of the end.
    fn here(&self) -> TextSpan {
        let start = self.scanner.offset();
        TextSpan { start, end: start + self.scanner.peek().map_or(0, char::len_utf8) }
    }

    /// The size at the beginning; its sign is read and judged later.
    pub(super) fn size(&mut self) -> Result<Size, CalloutError> {
        self.scanner.skip_blanks();
        if self.scanner.peek().is_none() {
            return Err(self.error(self.here(), Kind::Empty));
        }
        self.refuse_cycle_sign()?;
        skip_diameter_signs(&mut self.scanner);
        let start = self.scanner.offset();
        let signs = self.scanner.take_while(|c| c == '+' || is_minus(c));
        let number = self.number(&SIZE_UNITS, Kind::Nominal)?;
        let place = self.scanner.place_from(start);
        match number {
            Some(number) if signs.chars().nth(1).is_none() => {
                let plus = signs.starts_with('+');
                let negative = signs.starts_with(is_minus);
                Ok(Size { value: if negative { number.value.negated() } else { number.value }, plus, place })
            }
            None if signs.is_empty() => Err(self.no_nominal(self.here())),
            _ => {
                let text = shorten(self.scanner.since(start));
                Err(self.error(place, Kind::Nominal(LengthError::NotANumber { text })))
            }
        }
    }

    pub(super) fn no_nominal(&self, place: TextSpan) -> CalloutError {
        self.error(place, Kind::NoNominal { text: shorten(self.scanner.text().trim()) })
    }

    /// Reads a number without a sign, with its unit if one of `units` follows; `None` where there is no figure.
    pub(super) fn number(
        &mut self,
        units: &[&'static str],
        wrong: impl Fn(LengthError) -> Kind,
    ) -> Result<Option<Number<'a>>, CalloutError> {
        let start = self.scanner.offset();
        let figures = self.scanner.take_while(is_figure);
        if figures.is_empty() {
            return Ok(None);
        }
        let unit = self.unit(units);
        let place = self.scanner.place_from(start);
        let value = self.scanner.since(start).parse::<Length>();
        let value = value.map_err(|error| self.error(place, wrong(shorten_length(error))))?;
        if let Some(sign) = figures.chars().find(|&c| is_decimal_sign(c))
            && sign != *self.decimal_sign.get_or_insert(sign)
        {
            return Err(self.error(place, Kind::MixedDecimals { number: shorten(figures) }));
        }
        Ok(Some(Number { value, figures, unit, place }))
    }

    /// Reads a unit, perhaps after a blank, unless it is the beginning of a word: `25m6` and `25mm6` keep their class.
    fn unit(&mut self, units: &[&'static str]) -> Option<&'static str> {
        let mut ahead = self.scanner;
        ahead.skip_blanks();
        for &unit in units {
            let mut behind = ahead;
            if behind.eat_word(unit) && !behind.peek().is_some_and(char::is_alphanumeric) {
                self.scanner = behind;
                return Some(unit);
            }
        }
        None
    }

    /// Reads what follows the size.
    pub(super) fn tolerance(&mut self, size: Size) -> Result<Callout, CalloutError> {
        if size.value <= Length::ZERO {
            return Err(self.error(size.place, Kind::NotPositive { nominal: size.value }));
        }
        self.scanner.skip_blanks();
        match self.scanner.peek() {
            None => Err(self.error(self.here(), Kind::NoTolerance)),
            // "+0.2 -0.05" and "+0.2/0.15" are deviations without a size.
            Some(c) if size.plus && (c == '/' || is_sign(c) || is_figure(c)) => Err(self.no_nominal(size.place)),
            Some('/') => self.limits(size),
            Some(c) if is_sign(c) || is_figure(c) => self.band(size),
            Some(_) => {
                self.refuse_cycle_sign()?;
                self.class_or_fit(size)
            }
        }
    }

    /// Reads `/11.985` after a size: limits.
    fn limits(&mut self, size: Size) -> Result<Callout, CalloutError> {
        if self.grammar == Grammar::Cycle {
            return Err(self.error(self.here(), Kind::NotInCycleText { found: '/' }));
        }
        self.scanner.eat(|c| c == '/');
        self.scanner.skip_blanks();
        let start = self.scanner.offset();
        let minimum = self.number(&SIZE_UNITS, |error| Kind::Number { part: Part::Limit, error })?;
        let Some(minimum) = minimum else { return Err(self.expected(Part::Limit, start)) };
        let place = self.scanner.place_from(size.place.start);
        self.placed(place, Callout::with_limits(size.value, minimum.value))
    }

    fn class_or_fit(&mut self, size: Size) -> Result<Callout, CalloutError> {
        let start = self.scanner.offset();
        let token = class_token(&mut self.scanner);
        let place = self.scanner.place_from(start);
        if let Some(general) = GeneralClass::from_letter(token) {
            return self.placed(place, Callout::general(size.value, general));
        }
        if let Some(class) = GeneralClass::from_letter(&token.to_ascii_lowercase()) {
            let offer = self.placed(place, Callout::general(size.value, class))?;
            return Err(self.error(place, Kind::GeneralCapital { class, offer }));
        }
        let first = self.class(token, place)?;
        self.scanner.skip_blanks();
        let Some(between) = self.scanner.peek().filter(|&c| c == '/' || is_minus(c)) else {
            return self.placed(place, Callout::new(size.value, first));
        };
        if self.grammar == Grammar::Cycle {
            return Err(self.error(self.here(), Kind::NotInCycleText { found: between }));
        }
        self.scanner.eat(|_between| true);
        self.scanner.skip_blanks();
        // "25 H7-0.1" may be anything.
        let second = if between == '/' { self.partner()? } else { self.partner_class()? };
        let place = self.scanner.place_from(start);
        self.placed(place, Callout::of_parts(size.value, PartTolerance::Class(first), second))
    }

    /// Reads the second part of a fit, behind its stroke: a class, or deviations.
    pub(super) fn partner(&mut self) -> Result<PartTolerance, CalloutError> {
        if self.scanner.peek().is_some_and(|c| is_sign(c) || c == '0') {
            return Ok(PartTolerance::Deviations(self.deviations()?));
        }
        self.partner_class()
    }

    fn partner_class(&mut self) -> Result<PartTolerance, CalloutError> {
        let start = self.scanner.offset();
        let token = class_token(&mut self.scanner);
        self.class(token, self.scanner.place_from(start)).map(PartTolerance::Class)
    }

    fn class(&self, token: &str, place: TextSpan) -> Result<ToleranceClass, CalloutError> {
        let malformed = || ClassError::Malformed { text: shorten(token) };
        let read = match token.parse::<ToleranceClass>() {
            // Cycles 14xx compute limits by ISO 286: they know no table, and so no column of one.
            Ok(class) if self.grammar == Grammar::Cycle && !class.has_grade() => Err(malformed()),
            Err(ClassError::Malformed { .. }) => Err(malformed()),
            read => read,
        };
        read.map_err(|error| self.error(place, Kind::Class(Box::new(error))))
    }

    /// The error where a number was expected and something else, or nothing, was found.
    pub(super) fn expected(&self, part: Part, start: usize) -> CalloutError {
        let mut scanner = self.scanner;
        scanner.take_while(|c| !c.is_whitespace());
        let place = scanner.place_from(start);
        if self.scanner.peek().is_none() {
            return self.error(place, Kind::Missing { part });
        }
        self.error(place, Kind::NotA { part, found: shorten(scanner.since(start)) })
    }

    /// Refuses `?` and `@`, which have no meaning in a callout.
    fn refuse_cycle_sign(&self) -> Result<(), CalloutError> {
        match self.scanner.peek() {
            Some(sign @ ('?' | '@')) if self.grammar == Grammar::Callout => {
                Err(self.error(self.here(), Kind::CycleSign { sign }))
            }
            _ => Ok(()),
        }
    }

    /// Only blanks may follow.
    pub(super) fn end(&mut self) -> Result<(), CalloutError> {
        self.scanner.skip_blanks();
        self.refuse_cycle_sign()?;
        let found = self.scanner.rest().trim_end();
        if found.is_empty() {
            return Ok(());
        }
        let start = self.scanner.offset();
        Err(self.error(TextSpan { start, end: start + found.len() }, Kind::TooMuch { found: shorten(found) }))
    }
}

/// Letters and grade, or whatever is in their place.
fn class_token<'a>(scanner: &mut Scanner<'a>) -> &'a str {
    scanner.take_while(|c| !c.is_whitespace() && !is_sign(c) && !matches!(c, '/' | '?' | '@'))
}
