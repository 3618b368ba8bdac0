//! The texts that cycles 14xx take as a nominal value: a callout, less, or more. This file reads and writes them; what
//! a control does with them is elsewhere.

use std::fmt;
use std::str::FromStr;

use super::error::CalloutError;
use super::kind::{CalloutErrorKind, Part};
use super::reading::{Grammar, Reader, Size};
use super::scanner::{is_figure, is_sign};
use super::{Callout, Tolerance};
use crate::length::Length;
use crate::tolerance::Deviations;

/// A text of cycles 14xx: `10H7`, `?10H7`, `?`, `10H7@10.004`.
///
/// The tolerance is a class of ISO 286, a general class of ISO 2768-1, or deviations in either order, so `8-2-1` means
/// −1 and −2. These cycles have neither fits nor limits of size.
///
/// ```
/// use fitcheck_core::tolerance::callout::CycleText;
///
/// let text: CycleText = "? 10 H7 @ 10,004".parse()?;
/// assert!(text.position_unknown);
/// assert_eq!(text.callout().unwrap().to_string(), "10 H7");
/// assert_eq!(text.to_string(), "?10H7@10.004");
/// # Ok::<(), fitcheck_core::tolerance::CalloutError>(())
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct CycleText {
    /// A leading `?`: the operator positions the probe.
    pub position_unknown: bool,
    /// The nominal value; a lone `?` has none.
    pub size: Option<CycleSize>,
    /// The actual value after an `@`, in millimetres: a position, so it may be zero or less.
    pub actual: Option<Length>,
}

/// The nominal value of a cycle text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CycleSize {
    /// A number alone, in millimetres: a position, so it may be zero or less.
    Nominal(Length),
    /// A size above zero with its tolerance.
    Callout(Callout),
    /// A position in millimetres with its deviations, where that is no size: it, or its lower limit, is zero or less.
    Position(Length, Deviations),
}

impl CycleText {
    /// The nominal value in millimetres, with or without tolerance.
    pub const fn nominal(&self) -> Option<Length> {
        match self.size {
            Some(CycleSize::Nominal(nominal) | CycleSize::Position(nominal, _)) => Some(nominal),
            Some(CycleSize::Callout(callout)) => Some(callout.nominal()),
            None => None,
        }
    }

    /// The nominal size with its tolerance, where it has one.
    pub const fn callout(&self) -> Option<Callout> {
        match self.size {
            Some(CycleSize::Callout(callout)) => Some(callout),
            _ => None,
        }
    }
}

impl FromStr for CycleText {
    type Err = CalloutError;

    fn from_str(text: &str) -> Result<Self, CalloutError> {
        let mut reader = Reader::new(text, Grammar::Cycle);
        reader.scanner.skip_blanks();
        let position_unknown = reader.scanner.eat(|c| c == '?');
        reader.scanner.skip_blanks();
        if position_unknown && reader.scanner.peek().is_none() {
            return Ok(Self { position_unknown, ..Self::default() });
        }
        let size = reader.size()?;
        reader.scanner.skip_blanks();
        let size = match reader.scanner.peek() {
            None | Some('@') => CycleSize::Nominal(size.value),
            Some(c) if is_sign(c) || is_figure(c) => with_deviations(&mut reader, size)?,
            Some(_) => CycleSize::Callout(reader.tolerance(size)?),
        };
        reader.scanner.skip_blanks();
        let actual = if reader.scanner.eat(|c| c == '@') { Some(actual(&mut reader)?.value) } else { None };
        reader.end()?;
        Ok(Self { position_unknown, size: Some(size), actual })
    }
}

/// A size or a position, and its deviations.
fn with_deviations(reader: &mut Reader<'_>, size: Size) -> Result<CycleSize, CalloutError> {
    let deviations = reader.deviations_of(size)?;
    let nominal = size.value;
    let minimum = nominal.checked_add(deviations.lower());
    if nominal <= Length::ZERO || minimum.is_some_and(|minimum| minimum <= Length::ZERO) {
        return Ok(CycleSize::Position(nominal, deviations));
    }
    reader.placed(size.place, Callout::with_deviations(nominal, deviations)).map(CycleSize::Callout)
}

/// The number after an `@`.
fn actual(reader: &mut Reader<'_>) -> Result<Size, CalloutError> {
    reader.scanner.skip_blanks();
    let start = reader.scanner.offset();
    reader.size().map_err(|error| match error.kind {
        CalloutErrorKind::Empty | CalloutErrorKind::NoNominal { .. } => {
            reader.scanner.skip_blanks();
            reader.expected(Part::Actual, start)
        }
        CalloutErrorKind::Nominal(error) => {
            reader.error(reader.scanner.place_from(start), CalloutErrorKind::Number { part: Part::Actual, error })
        }
        _ => error,
    })
}

/// The notation of a control: no blanks, a decimal point, a sign on every deviation, never `±` or `Ø`.
///
/// A fit and limits of size, which these cycles do not have, are printed as callouts.
impl fmt::Display for CycleText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = String::from(if self.position_unknown { "?" } else { "" });
        match self.size {
            Some(CycleSize::Nominal(nominal)) => text.push_str(&nominal.to_string()),
            Some(CycleSize::Callout(callout)) => text.push_str(&callout_text(&callout)),
            Some(CycleSize::Position(nominal, deviations)) => text.push_str(&deviations_text(nominal, deviations)),
            None => {}
        }
        if let Some(actual) = self.actual {
            text.push('@');
            text.push_str(&actual.to_string());
        }
        f.pad(&text)
    }
}

fn callout_text(callout: &Callout) -> String {
    let nominal = callout.nominal();
    match callout.tolerance() {
        Tolerance::Class(class) => format!("{nominal}{class}"),
        Tolerance::Deviations(deviations) => deviations_text(nominal, deviations),
        Tolerance::Fit { .. } | Tolerance::General(_) | Tolerance::Limits { .. } => callout.to_string(),
    }
}

fn deviations_text(nominal: Length, deviations: Deviations) -> String {
    let upper = deviations.upper();
    let lower = deviations.lower();
    let upper_sign = if upper < Length::ZERO { '-' } else { '+' };
    let lower_sign = if Length::ZERO < lower { '+' } else { '-' };
    format!("{nominal}{upper_sign}{}{lower_sign}{}", upper.abs(), lower.abs())
}
