//! Sentences of the report about one check: status, feature, source of the limits, size, position.
//!
//! Messages without a language; [`Words`] says them. Rules, doubts, caveats and origins bring their own.

use crate::length::Length;
use crate::message::{Message, Say as _};
use crate::report::band::Side;
use crate::tolerance::{Feature, Source};
use crate::verdict::{AxisPosition, PositionVerdict, SizeVerdict, Status};
use crate::words::Words;

/// The word of a status, in capitals: `GOOD`, `NABEWERKING`.
pub const fn status(status: Status) -> Message {
    Message::new(match status {
        Status::Good => "report-status-good",
        Status::Rework => "report-status-rework",
        Status::ReMeasure => "report-status-remeasure",
        Status::Scrap => "report-status-scrap",
    })
}

/// Hole or shaft in words.
pub const fn feature(feature: Feature) -> Message {
    Message::new(match feature {
        Feature::Hole => "report-feature-hole",
        Feature::Shaft => "report-feature-shaft",
    })
}

/// What a part on a side of the zone is.
pub const fn side(side: Side) -> Message {
    Message::new(match side {
        Side::Rework => "report-side-rework",
        Side::Scrap => "report-side-scrap",
    })
}

/// Where the limits come from, and what the standard says where a user's table says something else.
pub fn source(source: &Source, words: &Words) -> Message {
    match source {
        Source::Table { instead_of: Some(standard), .. } => Message::new("report-source-instead")
            .message("source", source.message())
            .text("upper", words.signed_um(standard.upper()))
            .text("lower", words.signed_um(standard.lower())),
        _ => source.message(),
    }
}

/// Why the size is what it is: `12 µm above minimum, 9 µm below maximum`, `2 µm too small`.
pub fn size(verdict: &SizeVerdict, words: &Words) -> Message {
    let um = |length: Length| words.um(length.abs());
    let (above, below) = (verdict.above_minimum, verdict.below_maximum);
    if above < Length::ZERO {
        Message::new("report-too-small").text("um", um(above))
    } else if below < Length::ZERO {
        Message::new("report-too-large").text("um", um(below))
    } else {
        Message::new("report-inside").text("above", um(above)).text("below", um(below))
    }
}

/// The distance to both limits: always two numbers, also outside the zone.
pub fn distances(verdict: &SizeVerdict, words: &Words) -> [Message; 2] {
    let um = |length: Length| words.um(length.abs());
    let (above, below) = (verdict.above_minimum, verdict.below_maximum);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::Deviations;
    use crate::words::Language;

    fn um(um: i32) -> Length {
        Length::from_micrometres(um)
    }

    #[track_caller]
    fn check(message: &Message, english: &str, dutch: &str) {
        assert_eq!(Words::new(Language::En).say(message), english);
        assert_eq!(Words::new(Language::Nl).say(message), dutch);
    }

    #[test]
    fn english_words_are_those_of_the_machine_readable_files() {
        let words = Words::new(Language::En);
        for each in [Status::Good, Status::Rework, Status::ReMeasure, Status::Scrap] {
            assert_eq!(words.say(&status(each)), each.word());
        }
        for each in [Feature::Hole, Feature::Shaft] {
            assert_eq!(words.say(&feature(each)), each.word());
        }
    }

    #[test]
    fn the_source_says_what_a_users_table_overrides() {
        let words = Words::new(Language::En);
        let table = |shipped, instead_of| Source::Table {
            name: "a.tab".into(),
            shipped,
            over: um(18_500),
            to: um(30_000),
            instead_of,
        };
        for each in [table(true, None), table(false, None), Source::File("TCHPR421.TXT".into())] {
            assert_eq!(words.say(&source(&each, &words)), each.to_string());
        }
        let standard = Deviations::new(um(21), um(-5)).ok();
        assert_eq!(
            words.say(&source(&table(false, standard), &words)),
            "table a.tab, over 18.5 up to 30 mm; ISO 286 says +21 and \u{2212}5 µm here"
        );
        let words = Words::new(Language::Nl);
        assert_eq!(
            words.say(&source(&table(true, None), &words)),
            "ingebouwde tabel a.tab, boven 18,5 tot en met 30 mm"
        );
    }

    #[test]
    fn each_axis_says_its_own() {
        let words = Words::new(Language::En);
        let one = |deviation, tolerance| AxisPosition { deviation: um(deviation), tolerance };
        check(
            &axis("X", &one(10, Some(um(10))), &words),
            "X +0.010 mm, permitted ± 0.010 mm: IN",
            "X +0.010 mm, toegestaan ± 0.010 mm: BINNEN",
        );
        check(
            &axis("Y", &one(-11, Some(um(10))), &words),
            "Y \u{2212}0.011 mm, permitted ± 0.010 mm: OUT",
            "Y \u{2212}0.011 mm, toegestaan ± 0.010 mm: BUITEN",
        );
        check(&axis("Y", &one(0, None), &words), "Y 0.000 mm: not monitored", "Y 0.000 mm: niet bewaakt");
    }

    #[test]
    fn the_position_is_in_out_unmonitored_or_unknown() {
        let one = |deviation, tolerance| AxisPosition { deviation: um(deviation), tolerance };
        let both = |x, y| Some(PositionVerdict { axes: [x, y] });
        check(&position(None), "not measured", "niet gemeten");
        check(&position(both(one(5, None), one(0, None))), "not monitored", "niet bewaakt");
        check(&position(both(one(5, None), one(5, Some(um(5))))), "IN", "BINNEN");
        check(&position(both(one(5, Some(um(4))), one(0, None))), "OUT", "BUITEN");
    }
}
