//! Sentences of the report about one check: feature, source of the limits, size, position.
//!
//! Messages without a language; [`Words`] puts them into one. Rules, doubts, caveats and origins have their own.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::tolerance::{Feature, Source};
use fitcheck_core::verdict::{AxisPosition, PositionVerdict, SizeVerdict};
use fitcheck_core::words::Words;

use crate::report::band::Side;

/// Hole, shaft or neither in words.
pub const fn feature(feature: Option<Feature>) -> Message {
    Message::new(match feature {
        Some(Feature::Hole) => "report-feature-hole",
        Some(Feature::Shaft) => "report-feature-shaft",
        None => "report-feature-neither",
    })
}

/// What a part on a side of the zone is.
pub const fn side(side: Side) -> Message {
    Message::new(match side {
        Side::Rework => "report-side-rework",
        Side::Scrap => "report-side-scrap",
        Side::Out => "report-side-out",
    })
}

/// Where the limits come from, and what the standard says where a user's table differs.
pub fn source(source: &Source, words: &Words) -> Message {
    match source {
        Source::Table { instead_of: Some(standard), .. } => message!("report-source-instead")
            .message("source", source.message())
            .text("upper", words.signed_um(standard.upper()))
            .text("lower", words.signed_um(standard.lower())),
        _ => source.message(),
    }
}

/// Why the size is what it is: `12 µm above minimum, 9 µm below maximum`, `2 µm too small`.
pub fn size(verdict: &SizeVerdict, words: &Words) -> Message {
    let um = |length: Length| words.um(length.abs());
    let above = verdict.above_minimum;
    let below = verdict.below_maximum;
    if above < Length::ZERO {
        message!("report-too-small").text("um", um(above))
    } else if below < Length::ZERO {
        message!("report-too-large").text("um", um(below))
    } else {
        message!("report-inside").text("above", um(above)).text("below", um(below))
    }
}

/// The distance to both limits: always two numbers, also outside the zone.
pub fn distances(verdict: &SizeVerdict, words: &Words) -> [Message; 2] {
    let um = |length: Length| words.um(length.abs());
    let above = verdict.above_minimum;
    let below = verdict.below_maximum;
    [
        Message::new(if above < Length::ZERO { "report-below-minimum" } else { "report-above-minimum" })
            .text("um", um(above)),
        Message::new(if below < Length::ZERO { "report-above-maximum" } else { "report-below-maximum" })
            .text("um", um(below)),
    ]
}

/// Whether the centre is in position: in, out, not monitored, or not measured at all.
pub fn position(position: Option<PositionVerdict>) -> Message {
    Message::new(match position {
        None => "report-position-unknown",
        Some(position) if position.is_out() => "report-position-out",
        Some(position) if position.is_monitored() => "report-position-in",
        Some(_) => "report-position-unmonitored",
    })
}

/// One axis of the centre, `name` being `X` or `Y`: its deviation and what is permitted.
pub fn axis(name: &str, axis: &AxisPosition, words: &Words) -> Message {
    let id = match axis.tolerance {
        None => "report-axis-unmonitored",
        Some(_) if axis.is_out() => "report-axis-out",
        Some(_) => "report-axis-in",
    };
    let message = Message::new(id).text("axis", name).text("deviation", signed_mm(axis.deviation, words));
    match axis.tolerance {
        Some(tolerance) => message.text("tolerance", words.mm(tolerance, 3)),
        None => message,
    }
}

/// Millimetres with a sign unless zero and at least three decimals.
fn signed_mm(length: Length, words: &Words) -> String {
    let plus = if Length::ZERO < length { "+" } else { "" };
    format!("{plus}{}", words.mm(length, 3))
}
