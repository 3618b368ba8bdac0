//! What every page for people says of a part and of a check, in words: HTML and PDF say the same.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Say as _, message};
use fitcheck_core::part::FeatureStanding;
use fitcheck_core::verdict::{Removal, SizeVerdict, Status, Verdict};
use fitcheck_core::words::Words;

use super::Report;
use super::part::PartSheet;
use crate::journal::Record;

/// The title of the report: its own, that of its template, or the usual one.
pub(super) fn title(report: &Report, words: &Words) -> String {
    let of_template = || report.template.text(&report.template.title, words);
    let mut titles = std::iter::once(report.title.clone()).chain(std::iter::once_with(of_template));
    titles.find(|title| !title.is_empty()).unwrap_or_else(|| words.get("report-title"))
}

pub(super) fn heading(part: &PartSheet, words: &Words) -> String {
    let name = &part.plan.head.part;
    let serial = part.serial();
    words.say(&match (name.is_empty(), serial.is_empty()) {
        (true, true) => message!("report-part"),
        (true, false) => message!("walk-page-part-serial").text("serial", serial),
        (false, true) => message!("walk-page-part-no-serial").text("part", name),
        (false, false) => message!("walk-page-part").text("part", name).text("serial", serial),
    })
}

/// The names of the sizes that their rule accepts although they lie beyond a limit.
pub(super) fn beyond_limits(part: &PartSheet) -> impl Iterator<Item = String> {
    let is_it = |record: &Record| record.verdict.is_beyond_limits();
    part.sizes().filter(move |(_, _, record)| record.is_some_and(|record| is_it(record))).map(|(size, ..)| size.name())
}

/// What keeps the part from being good, and what the list does not show.
pub(super) fn lacks(part: &PartSheet, words: &Words) -> Vec<String> {
    let mut lacks = Vec::new();
    let missing = part.missing();
    if !missing.is_empty() {
        lacks.push(words.say(&message!("walk-page-missing").text("names", missing.join(", "))));
    }
    for (name, reason) in part.left_out() {
        let left = words.say(&message!("walk-page-skipped").text("reason", reason));
        lacks.push(format!("{name}: {left}"));
    }
    let simulated = part.standing().simulated;
    if 0 < simulated {
        lacks.push(words.say(&message!("walk-page-simulated").count("count", simulated)));
    }
    let beyond: Vec<String> = beyond_limits(part).collect();
    if !beyond.is_empty() {
        lacks.push(words.say(&message!("walk-page-accepted").text("names", beyond.join(", "))));
    }
    let older = part.older();
    if 0 < older {
        lacks.push(words.say(&message!("report-part-older").count("count", older)));
    }
    lacks
}

/// A balloon in words: its number, its feature, and what became of it.
pub(super) fn balloon_said(label: &str, name: &str, standing: &FeatureStanding, words: &Words) -> String {
    let FeatureStanding { status, is_simulated, is_skipped, .. } = *standing;
    let word = match status {
        None if is_skipped => words.get("parts-page-balloon-skipped"),
        None => words.get("parts-page-balloon-open"),
        Some(status) if is_simulated => {
            words.say(&message!("parts-page-balloon-simulated").text("status", words.told(&status)))
        }
        Some(status) => words.told(&status),
    };
    words.say(&message!("parts-page-balloon").text("label", label).text("name", name).text("status", word))
}

/// Why the part is worse than its size alone.
pub(super) fn cause(verdict: &Verdict, words: &Words) -> Option<String> {
    (verdict.status() != verdict.size.status).then(|| {
        let alone = words.told(&verdict.size.status);
        words.say(&message!("report-cause-position").text("status", alone))
    })
}

/// Why the value is to be measured again: what its contacts cannot tell, or the guard band.
pub(super) fn undecided(verdict: &Verdict, words: &Words) -> Option<String> {
    let why = match verdict.undecided {
        Some(why) => why.message(),
        None => message!("report-in-guard-band"),
    };
    (verdict.size.status == Status::ReMeasure).then(|| words.say(&why))
}

/// What to remove, on the diameter.
pub(super) fn removal_said(verdict: &Verdict, words: &Words) -> Option<String> {
    let removal = verdict.size.removal?;
    let amount = |amount: Length, id: &str| format!("{} µm {}", words.um(amount), words.get(id));
    let nearest = amount(removal.to_limit, nearest(&verdict.size, removal));
    let middle = amount(removal.to_middle, "report-remove-to-middle");
    Some(format!("{} {}: {nearest}, {middle}", words.get("report-remove"), words.get("report-on-diameter")))
}

/// Up to where is to be removed at least: the nearest limit, or what the rule accepts.
pub(super) fn nearest(size: &SizeVerdict, removal: Removal) -> &'static str {
    let is_to_limit = size.above_minimum.min(size.below_maximum).negated() == removal.to_limit;
    if is_to_limit { "report-remove-to-limit" } else { "report-remove-to-accepted" }
}

/// How many decimals a size has in millimetres.
pub(super) fn decimals_of(length: Length) -> usize {
    length.to_string().split_once('.').map_or(0, |(_, decimals)| decimals.len())
}

/// Control characters, and marks that change the direction of writing and so the order of figures: a page must not contain them, and shows
/// a replacement character in their place.
pub(super) fn is_hidden(c: char) -> bool {
    c.is_control() || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{fffe}' | '\u{ffff}')
}
