//! A check and a part in words, for tables that people read: a cell each for the callout, the verdict, and what there is to say of it.

use std::borrow::Cow;

use fitcheck_core::length::Length;
use fitcheck_core::message::message;
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::part::PartSheet;
use super::said::{beyond_limits, cause, is_hidden, undecided};
use super::{origins, text};
use crate::journal::Record;

/// The mark beside the word of a verdict, so that neither colour nor language is needed to tell them apart. What nobody measured has no
/// verdict, so its mark is the dash.
pub(super) const fn mark(status: Option<Status>) -> &'static str {
    match status {
        Some(Status::Good) => "\u{2713}",
        Some(Status::Rework) => "\u{21bb}",
        Some(Status::ReMeasure) => "?",
        Some(Status::OutOfLimits) => "\u{2195}",
        Some(Status::Scrap) => "\u{2717}",
        None => "\u{2013}",
    }
}

/// The callout, or the nominal size where the limits are those of no class.
pub(super) fn callout(record: &Record, words: &Words) -> String {
    match &record.callout {
        Some(callout) => words.number(&callout.to_string()),
        None => format!("{} mm", words.mm(record.limits.nominal, 0)),
    }
}

/// Mark and word of a check; of a simulated one the word says so, and the mark is that of no verdict.
pub(super) fn verdict(record: &Record, words: &Words) -> String {
    let word = words.told(&record.verdict);
    if record.measurement.origin.is_simulated() {
        let said = words.say(&message!("status-simulated").text("status", word));
        return format!("{} {said}", mark(None));
    }
    format!("{} {word}", mark(Some(record.verdict.status())))
}

/// Mark and word of a part as far as it has a verdict.
pub(super) fn standing(part: &PartSheet, words: &Words) -> String {
    let status = part.status();
    let word = match status {
        Some(Status::Good) if beyond_limits(part).next().is_some() => words.get("status-accepted"),
        Some(status) => words.told(&status),
        None => words.get("walk-page-not-complete"),
    };
    format!("{} {word}", mark(status))
}

/// Where the numbers of a check come from, and everything else that there is to say of it.
pub(super) struct CheckSaid {
    pub limits_from: String,
    pub measured_from: String,
    pub rule: String,
    pub remarks: Vec<String>,
}

impl CheckSaid {
    pub(super) fn of(record: &Record, words: &Words) -> Self {
        let mut said = Self {
            limits_from: String::new(),
            measured_from: String::new(),
            rule: String::new(),
            remarks: reasons(record, words),
        };
        let columns = ["report-limits-from", "report-measured-from", "report-verdict-from"].map(|id| words.get(id));
        for entry in origins::of(record, words) {
            match columns.iter().position(|label| *label == entry.label) {
                Some(0) => said.limits_from = entry.value,
                Some(1) => said.measured_from = entry.value,
                Some(_) => said.rule = entry.value,
                None => said.remarks.push(format!("{}: {}", entry.label, entry.value)),
            }
        }
        said.remarks.extend(record.caveats().iter().map(|caveat| words.told(caveat)));
        said
    }
}

/// Why it is what it is, and what to remove.
fn reasons(record: &Record, words: &Words) -> Vec<String> {
    let verdict = &record.verdict;
    let size = &verdict.size;
    let is_outside = size.above_minimum < Length::ZERO || size.below_maximum < Length::ZERO;
    let mut reasons: Vec<String> = cause(verdict, words).into_iter().chain(undecided(verdict, words)).collect();
    reasons.extend(is_outside.then(|| words.say(&text::size(size, words))));
    if let Some(removal) = size.removal {
        let amount = |id: &str, amount| format!("{} µm {}", words.um(amount), words.get(id));
        let both = [("report-remove-to-limit", removal.to_limit), ("report-remove-to-middle", removal.to_middle)];
        let both = both.map(|(id, of)| amount(id, of)).join(", ");
        reasons.push(format!("{} {}: {both}", words.get("report-remove"), words.get("report-on-diameter")));
    }
    reasons.extend(record.doubt.map(|doubt| words.told(&doubt)));
    if let Some(position) = verdict.position {
        let axes = ["X", "Y"].iter().zip(&position.axes);
        reasons.extend(axes.map(|(name, axis)| words.say(&text::axis(name, axis, words))));
    }
    reasons
}

/// A text on one line, without what a page does not show: line ends and tabs become blanks, control characters and marks that turn the
/// direction of writing a replacement character.
pub(super) fn on_one_line(text: &str) -> String {
    let flat: String = text.chars().map(|c| if matches!(c, '\n' | '\r' | '\t') { ' ' } else { c }).collect();
    printable(flat.trim()).into_owned()
}

/// The text without what a page must not contain: control characters, and marks that change the direction of writing
/// and so the order of figures. Each becomes a replacement character, so that it is visible.
pub(super) fn printable(page: &str) -> Cow<'_, str> {
    let hidden = |c: char| is_hidden(c) && c != '\n' && c != '\t';
    if !page.chars().any(hidden) {
        return Cow::Borrowed(page);
    }
    page.chars().map(|c| if hidden(c) { char::REPLACEMENT_CHARACTER } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_mark_is_another_one() {
        let all = Status::ALL.into_iter().map(Some).chain([None]).map(mark);
        let marks: std::collections::BTreeSet<_> = all.collect();
        assert_eq!(marks.len(), Status::ALL.len() + 1);
    }

    #[test]
    fn a_text_has_one_line() {
        assert_eq!(on_one_line(" a\r\nb\tc\u{202e}\u{0} "), "a  b c\u{fffd}\u{fffd}");
    }
}
