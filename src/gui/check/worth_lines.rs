//! What the card and its reasons say about rule, uncertainty and temperature.

use crate::gui::check::rule_panel::accepted_text;
use crate::gui::view::{Digits, View};
use crate::journal::{Decision, Record};
use crate::message::{Message, message};
use crate::tolerance::fit::thermal::Correction;
use crate::verdict::Status;
use crate::verdict::rules::percent;
use crate::words::Words;

/// The lines of the card: proven or not, the temperature, a budget that does not count.
pub(in crate::gui) fn lines(words: &Words, record: &Record) -> Vec<String> {
    let mut lines = Vec::new();
    if let Some(Decision { zones, proven, .. }) = record.decision() {
        lines.extend(proven.map(|is_proven| words.get(if is_proven { "rule-proven" } else { "rule-not-proven" })));
        if zones.accepted.is_none() {
            lines.push(words.get("rule-accepts-nothing"));
        }
    }
    lines.extend(record.correction.as_ref().map(|correction| corrected(words, correction)));
    if let Some(budget) = &record.budget {
        lines.extend(budget.warnings.iter().map(|warning| words.told(warning)));
    }
    lines
}

/// What is to be done with what can neither be used nor machined, and why; that the rule accepts what lies beyond a limit.
pub(super) fn advice(words: &Words, record: &Record) -> Option<(String, String)> {
    let verdict = &record.verdict;
    let [what, why] = match verdict.status() {
        Status::ReMeasure => {
            let why = verdict.undecided.map(|why| words.told(&why));
            return Some((words.get("measure-again"), why.unwrap_or_else(|| words.get("measure-again-why"))));
        }
        Status::OutOfLimits => ["out-of-limits", "out-of-limits-why"],
        Status::Scrap if verdict.size.status == Status::Scrap => ["set-aside", "set-aside-why"],
        Status::Scrap => ["set-aside", "set-aside-why-position"],
        Status::Good if verdict.is_beyond_limits() => ["beyond-limits", "beyond-limits-why"],
        Status::Good | Status::Rework => return None,
    };
    Some((words.get(what), words.get(why)))
}

/// How the value was brought to 20 °C.
fn corrected(words: &Words, correction: &Correction) -> String {
    let message = message!("check-corrected")
        .text("measured", words.mm(correction.measured, 3))
        .text("temperature", words.number(&correction.part.temperature.to_string()))
        .text("change", words.signed_um(correction.change()));
    words.say(&message)
}

/// What engineers want to know: the accepted zone, the probabilities, where the uncertainty comes from, what the correction
/// took.
pub(in crate::gui) fn reasons(view: &View<'_>, record: &Record) -> Vec<String> {
    let words = view.words;
    let mut reasons = Vec::new();
    if let Some(Decision { zones, conformity, .. }) = record.decision() {
        reasons.push(accepted_text(view, zones.accepted));
        if let Some(found) = conformity {
            let percent = |probability: f64| words.number(&percent(probability));
            let said = message!("why-conformity")
                .text("within", percent(found.within))
                .text("below", percent(found.below))
                .text("above", percent(found.above));
            reasons.push(words.say(&said));
            let wrong = match record.verdict.size.status {
                Status::Good => Some(("why-wrong-good", 1.0 - found.within)),
                Status::Rework | Status::OutOfLimits | Status::Scrap => Some(("why-wrong-bad", found.within)),
                Status::ReMeasure => None,
            };
            reasons.extend(wrong.map(|(id, risk)| words.say(&Message::new(id).text("percent", percent(risk)))));
        }
    }
    if let Some(budget) = &record.budget {
        let said = message!("why-budget")
            .text("name", &budget.name)
            .text("date", budget.date.to_string())
            .text("by", &budget.by)
            .text("until", budget.valid_until.to_string());
        reasons.push(words.say(&said));
    }
    if let Some(correction) = &record.correction {
        let said = message!("why-corrected")
            .text("expansion", words.number(&correction.part.expansion.to_string()))
            .text("at-reference", Digits::Exact.mm(words, correction.at_reference, 3));
        reasons.push(words.say(&said));
        reasons.extend(correction.scale.map(|scale| {
            let said = message!("why-scales")
                .text("temperature", words.number(&scale.temperature.to_string()))
                .text("expansion", words.number(&scale.expansion.to_string()));
            words.say(&said)
        }));
    }
    reasons
}
