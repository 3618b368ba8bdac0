//! A row of a report: the name of a characteristic, what it should be, and what was measured.

use fitcheck_core::length::{Length, LengthError, Unit};
use fitcheck_core::message::FilePlace;
use jiff::civil::DateTime;

use super::{Computed, Printed, PrintedFault, PrintedLine, set_aside};
use crate::exchange::characteristic::{Characteristic, CharacteristicKind, Value};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::imported::{Sink, WhyUnjudged};
use crate::exchange::quantity::{self, Quantity};
use crate::exchange::source::Context;
use crate::exchange::{Labels, units};

/// What a figure of a row is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::exchange) enum Figure {
    Measured,
    Nominal,
    /// The tolerances are deviations with their signs.
    Upper,
    Lower,
    Deviation,
    /// How far the value is beyond its tolerance; empty within it.
    Beyond,
}

/// What a row says that its characteristic should be, what was measured of it, and what the report has computed of both.
#[derive(Debug)]
pub(in crate::exchange) struct PrintedRow {
    pub(in crate::exchange) characteristic: Characteristic,
    /// Where it has none, it is none that a value is missing of.
    pub(in crate::exchange) measured: Result<Printed, ImportErrorKind>,
    computed: Computed,
    /// Whether it says its unit.
    pub(in crate::exchange) has_unit: bool,
}

/// What names the figures of a report, in its words.
pub(in crate::exchange) type FigureNames = fn(Figure) -> &'static str;

impl PrintedRow {
    /// The row of a characteristic, of which `what` says what was measured; figures without a unit are in this one.
    ///
    /// # Errors
    /// What it should be cannot be read.
    pub(in crate::exchange) fn read(
        (name, what): (&str, &str),
        figures: &[(Figure, &str)],
        given: Option<Unit>,
        names: FigureNames,
    ) -> Result<Self, ImportErrorKind> {
        let cell = |wanted: Figure| {
            let cell = figures.iter().find(|(figure, _)| *figure == wanted).map(|(_, cell)| *cell);
            cell.filter(|cell| !cell.is_empty())
        };
        let (_, said) = cell(Figure::Measured).map_or(Ok(("", None)), without_unit)?;
        let read = |wanted: Figure| -> Result<Option<Printed>, ImportErrorKind> {
            let Some(cell) = cell(wanted) else { return Ok(None) };
            let (number, own) = without_unit(cell)?;
            let unit = own.or(said).or(given).unwrap_or(Unit::Millimetre);
            let wrong = |reason: LengthError| PrintedFault::Number { column: names(wanted).to_owned(), reason }.into();
            Printed::read(number, unit).map(Some).map_err(wrong)
        };
        let column = names(Figure::Measured);
        let measured =
            read(Figure::Measured).and_then(|measured| measured.ok_or_else(|| PrintedFault::NoValue { column }.into()));
        let nominal = read(Figure::Nominal)?.map(|nominal| nominal.length);
        let limit = |wanted: Figure| -> Result<Option<Length>, ImportErrorKind> {
            let Some((nominal, deviation)) = nominal.zip(read(wanted)?) else { return Ok(None) };
            let too_large = || LengthError::TooLarge { text: cell(wanted).unwrap_or("").to_owned() };
            let wrong = || PrintedFault::Number { column: names(wanted).to_owned(), reason: too_large() }.into();
            nominal.checked_add(deviation.length).map(Some).ok_or_else(wrong)
        };
        let (minimum, maximum) = (limit(Figure::Lower)?, limit(Figure::Upper)?);
        let computed = Computed { deviation: read(Figure::Deviation)?, beyond: read(Figure::Beyond)? };
        let is_length = said.is_some() || !quantity::is_no_length(what);
        let quantity = match quantity::of_text(what) {
            Some(Quantity::Other) if is_length => Some(Quantity::Length),
            _ if !is_length => Some(Quantity::Other),
            quantity => quantity,
        };
        let kind = match quantity {
            Some(Quantity::Diameter) => CharacteristicKind::Size,
            Some(Quantity::Other) => CharacteristicKind::Other(shorten(what)),
            _ if minimum.is_none() && maximum.is_none() => CharacteristicKind::Length(WhyUnjudged::NoTolerance),
            _ => CharacteristicKind::Length(WhyUnjudged::NotASize { what: shorten(what) }),
        };
        let characteristic = Characteristic {
            name: name.to_owned(),
            what: kind,
            class: String::new(),
            feature: None,
            nominal,
            minimum,
            maximum,
            expanded: None,
            labels: Labels { quantity, ..Labels::default() },
        };
        Ok(Self { characteristic, measured, computed, has_unit: said.or(given).is_some() })
    }

    /// Judges its value, and tells what the report computed otherwise than its figures give. `said` names how far the value is beyond
    /// its tolerance.
    pub(in crate::exchange) fn judge(
        self,
        row: PrintedLine<'_>,
        (labels, time): (Labels, Option<DateTime>),
        said: &str,
        context: &Context<'_>,
        sink: &mut Sink<'_>,
    ) {
        let Self { characteristic, measured, computed, .. } = self;
        let line = row.number;
        let labels = Labels { quantity: characteristic.labels.quantity.clone(), ..labels };
        if let CharacteristicKind::Other(what) = characteristic.what {
            let why = WhyUnjudged::NotASize { what };
            return sink.set_aside(set_aside(line, characteristic.name, labels, time, why, context));
        }
        let measured = match measured {
            Ok(measured) => measured,
            Err(kind) => return sink.refuse(FilePlace::line(line), kind, shorten(row.text.trim())),
        };
        for warning in computed.tells(measured.length, &characteristic.said()) {
            sink.warn(FilePlace::line(line), Some(line), warning.into());
        }
        let said = computed.beyond.map_or_else(String::new, |beyond| format!("{said} {}", beyond.length));
        let labels =
            Labels { claims: computed.claim(&said).into_iter().collect(), rounded_by: measured.rounded_by(), ..labels };
        let value = Value { line, measured: measured.length, time, labels, is_simulated: false };
        characteristic.judge(value, context, sink);
    }
}

/// A figure without its unit, and that unit.
fn without_unit(cell: &str) -> Result<(&str, Option<Unit>), ImportErrorKind> {
    match cell.rsplit_once(' ') {
        Some((number, unit)) => match units::known(unit) {
            Some(unit) => Ok((number.trim(), Some(unit))),
            None => Err(ImportErrorKind::Unit { unit: shorten(unit) }),
        },
        None => Ok((cell, None)),
    }
}
