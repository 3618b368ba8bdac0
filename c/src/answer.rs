//! What is answered, without pointers: numbers, and a text in the language that was asked for.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say};
use fitcheck_core::probing::{Measurement, Origin, noted};
use fitcheck_core::tolerance::{Callout, Feature, FigureWarning, Limits, Sources};
use fitcheck_core::verdict::{doubt, judge_size};
use fitcheck_core::words::{Language, Words};

use crate::{FitcheckLimits, FitcheckVerdict};

/// A measured diameter.
pub(crate) enum Given<'a> {
    /// Whole nanometres.
    Nanometres(i64),
    /// In millimetres, unless it states another unit.
    Text(&'a str),
}

/// Limits, and a verdict where a diameter was given.
pub(crate) struct Answer {
    pub(crate) verdict: FitcheckVerdict,
    /// Where the limits come from; below it what to look at, a line each.
    pub(crate) text: String,
}

/// The limits of a callout, and the verdict for a diameter; or why there is none, in English or in another language.
pub(crate) fn answer(callout: &str, given: Option<Given<'_>>, language: Option<&str>) -> Result<Answer, String> {
    let language = language.and_then(Language::from_code).filter(|language| *language != Language::En);
    let words = language.map(Words::new);
    let said = |message: &Message| words.as_ref().map_or_else(|| message.to_string(), |words| words.say(message));
    let refused = |error: &dyn Say| said(&error.message());
    let sources = Sources::default();
    let callout: Callout = callout.parse().map_err(|error| refused(&error))?;
    let limits = sources.limits(&callout, None).map_err(|error| refused(&error))?;
    let mut looks: Vec<Message> = Vec::new();
    looks.extend(sources.zone_doubt(&callout, &limits).map(|doubt| doubt.message()));
    looks.extend(FigureWarning::of_limits(&callout, &limits, &sources).map(|warning| warning.message()));
    let mut verdict = FitcheckVerdict { limits: of(&limits), ..FitcheckVerdict::default() };
    if let Some(given) = given {
        let measured = match given {
            Given::Nanometres(nm) => Length::from_nanometres(nm),
            Given::Text(text) => text.parse(),
        };
        let measured = measured.map_err(|error| refused(&error))?;
        if measured <= Length::ZERO {
            return Err(said(&Message::new("cli-not-above-zero").with("diameter", &measured)));
        }
        looks.extend(doubt(&limits, measured).map(|doubt| doubt.message()));
        // What one diameter leaves open of the callout, such as an envelope, and limits beside it that differ.
        let diameter = Measurement::of_diameter(measured, Origin::Typed);
        looks.extend(noted::caveats(callout.notes(), &limits, &diameter).into_iter().map(|caveat| caveat.message()));
        let found = judge_size(&limits, measured);
        verdict.measured_nm = measured.nanometres();
        verdict.deviation_nm = found.deviation.nanometres();
        verdict.remove_nm = found.removal.map_or(0, |removal| removal.to_limit.nanometres());
        verdict.status = i32::try_from(found.status.at()).unwrap_or(i32::MAX);
        verdict.look_first = i32::from(!looks.is_empty());
    } else {
        looks.extend(noted::differing(callout.notes(), &limits).map(|differs| differs.message()));
    }
    let lines = std::iter::once(limits.source.message()).chain(looks);
    let text = lines.map(|line| said(&line)).collect::<Vec<_>>().join("\n");
    Ok(Answer { verdict, text })
}

fn of(limits: &Limits) -> FitcheckLimits {
    FitcheckLimits {
        nominal_nm: limits.nominal.nanometres(),
        minimum_nm: limits.minimum().nanometres(),
        maximum_nm: limits.maximum().nanometres(),
        feature: match limits.feature {
            Some(Feature::Hole) => 1,
            Some(Feature::Shaft) => 2,
            None => 0,
        },
    }
}
