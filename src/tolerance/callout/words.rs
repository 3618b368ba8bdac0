//! What errors of callouts say in every language.

use super::error::CalloutError;
use super::kind::{CalloutErrorKind, Part, capital};
use crate::length::signed_mm;
use crate::message::{Message, Say};

impl Say for CalloutError {
    fn message(&self) -> Message {
        match self.told_place() {
            Some(at) => Message::new("callout-at").message("reason", self.kind.message()).text("at", at),
            None => self.kind.message(),
        }
    }
}

impl Say for CalloutErrorKind {
    fn message(&self) -> Message {
        match self {
            Self::Empty => Message::new("callout-empty"),
            Self::NoNominal { text } => Message::new("callout-no-nominal").text("text", text),
            Self::Nominal(error) => Message::new("callout-nominal").message("error", error.message()),
            Self::NotPositive { nominal } => {
                signed_mm(Message::new("callout-not-positive"), "nominal-sign", "nominal", *nominal)
            }
            Self::NoTolerance => Message::new("callout-no-tolerance"),
            Self::Class(error) => error.message(),
            Self::GeneralCapital { class, offer } => {
                Message::new("callout-general-capital").text("class", capital(*class)).text("offer", offer)
            }
            Self::FitOrder { offer } => Message::new("callout-fit-order").text("offer", offer),
            Self::FitSide { first, second } => {
                Message::new("callout-fit-side").text("first", first).text("second", second)
            }
            Self::Number { part, error } => Message::new(number_id(*part)).message("error", error.message()),
            Self::NotA { part, found } => Message::new(not_a_id(*part)).text("found", found),
            Self::Missing { part } => Message::new(missing_id(*part)),
            Self::NoSign { number } => Message::new("callout-no-sign").text("number", number),
            Self::NoUnit { number } => Message::new("callout-no-unit").text("number", number),
            Self::DeviationOrder { offer } => Message::new("callout-deviation-order").text("offer", offer),
            Self::LimitsOrder { offer } => Message::new("callout-limits-order").text("offer", offer),
            Self::LimitsApart { larger, smaller } => {
                Message::new("callout-limits-apart").mm("larger", *larger).mm("smaller", *smaller)
            }
            Self::LimitsOrDeviation { limits, deviation } => {
                Message::new("callout-limits-or-deviation").text("limits", limits).text("deviation", deviation)
            }
            Self::LimitsMeant { limits } => Message::new("callout-limits-meant").text("limits", limits),
            Self::MinimumNotPositive { minimum } => {
                signed_mm(Message::new("callout-minimum"), "minimum-sign", "minimum", *minimum)
            }
            Self::TooLarge { nominal } => Message::new("limits-too-large").mm("nominal", *nominal),
            Self::MixedDecimals { number } => Message::new("callout-mixed-decimals").text("number", number),
            Self::CycleSign { sign } => Message::new("callout-cycle-sign").text("sign", sign),
            Self::NotInCycleText { found } => Message::new("callout-not-in-cycle-text").text("found", found),
            Self::TooMuch { found } => Message::new("callout-too-much").text("found", found),
            Self::TooLong { most } => Message::new("callout-too-long").text("most", most),
            Self::BandOrder => Message::new("callout-band-order"),
        }
    }
}

/// What is wrong with a number.
const fn number_id(part: Part) -> &'static str {
    match part {
        Part::Deviation => "callout-deviation",
        Part::Limit => "callout-limit",
        Part::Actual => "callout-actual",
    }
}

/// Something else stands in its place.
const fn not_a_id(part: Part) -> &'static str {
    match part {
        Part::Deviation => "callout-no-deviation",
        Part::Limit => "callout-no-limit",
        Part::Actual => "callout-no-actual",
    }
}

/// Nothing stands in its place.
const fn missing_id(part: Part) -> &'static str {
    match part {
        Part::Deviation => "callout-deviation-missing",
        Part::Limit => "callout-limit-missing",
        Part::Actual => "callout-actual-missing",
    }
}
