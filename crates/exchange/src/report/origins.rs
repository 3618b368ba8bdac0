//! Where each number of a check comes from: limits, measured value, temperature, rule and uncertainty.

use fitcheck_core::budget::{Provenance, Validity};
use fitcheck_core::length::Length;
use fitcheck_core::message::{Say as _, message};
use fitcheck_core::tolerance::fit::thermal::Correction;
use fitcheck_core::verdict::Rule;
use fitcheck_core::verdict::rules::percent;
use fitcheck_core::words::Words;

use super::said::decimals_of;
use crate::journal::{Decision, Record};

/// A label and what it says.
pub(super) struct Entry {
    pub label: String,
    pub value: String,
}

/// Limits, measured value, verdict, and what a rule, a temperature and a budget add.
pub(in crate::report) fn of(record: &Record, words: &Words) -> Vec<Entry> {
    let entry = |id: &str, value: String| Entry { label: words.get(id), value };
    let mut entries = vec![
        entry("report-limits-from", words.say(&super::text::source(&record.limits.source, words))),
        entry("report-measured-from", measured(record, words)),
    ];
    entries.extend(record.correction.map(|correction| entry("report-temperature", corrected(&correction, words))));
    entries.push(entry("report-verdict-from", rule(record.verdict.rule, words)));
    entries.extend(record.decision().map(|decision| entry("report-accepted", accepted(&decision, words))));
    entries.extend(record.decision().and_then(|decision| Some(entry("report-proof", proof(&decision, words)?))));
    entries.extend(record.budget.as_ref().map(|found| entry("report-budget", budget(found, words))));
    entries
}

/// Where the measured value comes from.
pub(super) fn measured(record: &Record, words: &Words) -> String {
    let measurement = &record.measurement;
    let origin = words.told(&measurement.origin);
    match measurement.circle {
        Some(_) => words.say(
            &message!("report-origin-circle").text("origin", origin).count("contacts", measurement.contacts.len()),
        ),
        None => origin,
    }
}

/// The rule's sentence, and the uncertainty where it does not have it.
pub(in crate::report) fn rule(rule: Rule, words: &Words) -> String {
    let sentence = words.told(&rule);
    match rule.uncertainty() {
        Some(uncertainty) if !rule.name().says_uncertainty() => format!("{sentence}; {}", words.told(&uncertainty)),
        _ => sentence,
    }
}

/// The measured value on its way to 20 °C.
pub(super) fn corrected(correction: &Correction, words: &Words) -> String {
    let decimals = [correction.measured, correction.at_reference].map(decimals_of);
    let mm = |length: Length| words.mm(length, decimals.into_iter().fold(3, usize::max));
    let Correction { measured, at_reference, part, .. } = *correction;
    let message = message!("report-corrected")
        .text("measured", mm(measured))
        .number("temperature", part.temperature)
        .number("expansion", part.expansion)
        .text("change", words.signed_um(correction.change()))
        .text("reference", mm(at_reference));
    format!("{}; {}", words.say(&message), scales(correction, words))
}

pub(super) fn scales(correction: &Correction, words: &Words) -> String {
    words.say(&match correction.scale {
        Some(scale) => {
            message!("report-scales").number("temperature", scale.temperature).number("expansion", scale.expansion)
        }
        None => message!("report-scales-none"),
    })
}

pub(super) fn accepted(decision: &Decision, words: &Words) -> String {
    words.say(&match decision.zones.accepted {
        Some([least, most]) => {
            let decimals = [least, most].into_iter().map(decimals_of).fold(3, usize::max);
            message!("report-accepted-zone")
                .text("least", words.mm(least, decimals))
                .text("most", words.mm(most, decimals))
        }
        None => message!("report-accepted-none"),
    })
}

/// Whether the rule proves the status, and the probability of conformity; `None` where it says neither.
pub(super) fn proof(decision: &Decision, words: &Words) -> Option<String> {
    let proven =
        decision.proven.map(|is_proven| words.get(if is_proven { "report-proven" } else { "report-not-proven" }));
    let conformity = decision
        .conformity
        .map(|conformity| words.say(&message!("report-conformity").number("percent", percent(conformity.within))));
    let said: Vec<String> = proven.into_iter().chain(conformity).collect();
    (!said.is_empty()).then(|| said.join("; "))
}

/// Name, who made it and when, how long it counts, and what to check about it.
pub(super) fn budget(budget: &Provenance, words: &Words) -> String {
    let Provenance { name, date, by, valid_until, validity, warnings, .. } = budget;
    let mut said = vec![
        words.say(
            &message!("report-budget-made")
                .text("name", name)
                .text("date", date.to_string())
                .text("by", by)
                .text("until", valid_until.to_string()),
        ),
    ];
    // What is not valid is told by a warning, too; the word stands first.
    let word = match validity {
        Validity::Valid => None,
        Validity::Expired => Some("report-budget-expired"),
        Validity::NotYet => Some("report-budget-not-yet"),
    };
    said.extend(word.map(|id| words.get(id)));
    said.extend(
        warnings.iter().filter(|warning| !warning.is_about_validity()).map(|warning| words.say(&warning.message())),
    );
    said.join("; ")
}
