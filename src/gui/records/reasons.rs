//! Everything that a record says, line by line.

use crate::gui::check::{distances, worth_lines, worth_reasons};
use crate::gui::view::{Digits, View, datum_lines, doubt_text};
use crate::journal::entry::{Checked, Correction, CycleCheck, CycleOrigin, Entry, Reported, UsedFile};
use crate::journal::{Alarm, AlarmAnswer, Record};
use crate::length::Length;
use crate::message::{Message, Say as _, message};
use crate::probing::Origin;
use crate::session::RecordRow;
use crate::session::records::local_time;
use crate::text::grouped;
use crate::tolerance::Feature;

/// A line of an open record.
pub(super) enum Line {
    Named(String, String),
    Heading(String),
    Sentence(String),
}

pub(super) fn lines(view: &View<'_>, row: &RecordRow, by: Option<&RecordRow>) -> Vec<Line> {
    let entry = match &row.entry {
        Ok(entry) => entry,
        Err(why) => return vec![Line::Sentence(view.words.say(why))],
    };
    let mut lines = void(view, by);
    lines.extend(about(view, entry, row.went_back));
    if let Some(check) = entry.check() {
        lines.push(Line::Heading(view.text("records-page-decided")));
        match &check.what {
            Checked::Size(record) => size(view, record, &mut lines),
            Checked::Cycle(cycle) => of_cycle(view, cycle, &mut lines),
        }
        lines.extend(check.remark().map(|remark| Line::Sentence(view.words.told(&remark))));
        lines.extend(check.files.iter().map(|file| of_file(view, file)));
    }
    if let Some(report) = entry.report() {
        of_report(view, report, &mut lines);
    }
    if let Some(alarm) = entry.alarm() {
        let by = by.and_then(|by| by.entry.as_ref().ok()?.alarm()?.answer.as_ref());
        of_alarm(view, alarm, alarm.answer.as_ref().or(by), &mut lines);
    }
    lines.push(Line::Heading(view.text("records-page-chain")));
    let named = |id: &str, text: String| Line::Named(view.text(id), text);
    lines.push(named("records-page-hash", row.head.hash.to_string()));
    let chain = view.session.recording().journal.as_ref().map(|journal| journal.chain.to_string());
    lines.extend(chain.map(|chain| named("records-page-chain-name", chain)));
    lines
}

/// Why a record stands no longer, and who said so.
fn void(view: &View<'_>, by: Option<&RecordRow>) -> Vec<Line> {
    let correction = by.and_then(|by| by.entry.as_ref().ok()).and_then(Entry::corrects);
    let Some(Correction { reason, by, .. }) = correction else { return Vec::new() };
    let texts = [("records-page-void-why", reason), ("records-page-void-by", by)];
    let told = texts.into_iter().filter(|(_, text)| !text.is_empty());
    told.map(|(id, text)| Line::Named(view.text(id), text.clone())).collect()
}

/// Who, where, when.
fn about(view: &View<'_>, entry: &Entry, went_back: bool) -> Vec<Line> {
    let about = &entry.about;
    let zone = &about.time.zone;
    let offset = message!("records-page-time").text("time", local_time(&about.time)).text("zone", zone);
    let offset = offset.text("offset", offset_text(about.time.offset_min));
    let mut lines = Vec::new();
    if let Some(correction) = entry.corrects() {
        lines.push(Line::Named(view.text("records-page-reason"), correction.reason.clone()));
        if !correction.by.is_empty() {
            lines.push(Line::Named(view.text("records-page-corrector"), correction.by.clone()));
        }
    }
    // Who reads a file in did not measure what it holds.
    let is_of_file = entry.check().is_some_and(|check| match &check.what {
        Checked::Size(record) => matches!(
            record.measurement.origin,
            Origin::Imported { .. } | Origin::Contacts { .. } | Origin::ImportedSimulation { .. }
        ),
        Checked::Cycle(_) => false,
    });
    let who = if is_of_file { "records-page-importer" } else { "records-page-who" };
    let texts = [
        ("head-time", view.words.say(&offset)),
        ("head-part", about.part.clone()),
        ("records-page-serial", about.serial.clone()),
        ("records-page-feature", about.feature.clone()),
        (who, about.who.clone()),
        ("records-page-station", about.station.clone()),
        ("records-page-remark", about.remark.clone()),
    ];
    let told = texts.into_iter().filter(|(_, text)| !text.is_empty());
    lines.extend(told.map(|(id, text)| Line::Named(view.text(id), text)));
    if went_back {
        lines.push(Line::Sentence(view.text("records-page-clock")));
    }
    lines
}

/// How far local time is ahead of UTC: `+01:00`.
fn offset_text(minutes: i32) -> String {
    let sign = if minutes < 0 { '\u{2212}' } else { '+' };
    format!("{sign}{:02}:{:02}", (minutes / 60).abs(), (minutes % 60).abs())
}

/// Limits, measurement, rule, figures.
fn size(view: &View<'_>, record: &Record, lines: &mut Vec<Line>) {
    let words = view.words;
    let named = |id: &str, text: String| Line::Named(view.text(id), text);
    let bounds = record.limits.bounds();
    let limits = format!("{} … {} mm", words.mm(bounds.minimum(), 3), words.mm(bounds.maximum(), 3));
    let callout = message!("records-page-callout").text("callout", crate::journal::query::callout(record));
    let feature = match record.limits.feature {
        Some(Feature::Hole) => "hole",
        Some(Feature::Shaft) => "shaft",
        None => "neither",
    };
    lines.push(named("head-callout", words.say(&callout.text("feature", feature))));
    lines.push(named("records-page-limits", limits));
    lines.push(named("records-page-source", words.told(&record.limits.source)));
    lines.push(named("head-measured", format!("{} mm", Digits::Exact.mm(words, record.measurement.diameter, 3))));
    let size = &record.verdict.size;
    let [of_minimum, of_maximum] = distances(words, record);
    let distance = match (size.above_minimum < Length::ZERO, size.below_maximum < Length::ZERO) {
        (true, _) => of_minimum,
        (_, true) => of_maximum,
        _ => format!("{of_minimum}, {of_maximum}"),
    };
    lines.push(named("records-page-distance", distance));
    lines.push(named("head-from", words.told(&record.measurement.origin)));
    let contacts = record.measurement.contacts.len();
    if 0 < contacts {
        lines.push(named("records-page-contacts", contacts.to_string()));
    }
    lines.push(named("records-page-rule", words.told(&record.verdict.rule)));
    let said = worth_lines(words, record).into_iter().chain(worth_reasons(view, record));
    lines.extend(said.map(Line::Sentence));
    lines.extend(record.doubt.map(|doubt| Line::Sentence(doubt_text(words, doubt))));
    let caveat = |what: Message| words.say(&message!("why-caveat").message("what", what));
    lines.extend(record.caveats().into_iter().map(|what| Line::Sentence(caveat(what.message()))));
}

/// What a cycle says: its parameters, what it compared, its results.
fn of_cycle(view: &View<'_>, cycle: &CycleCheck, lines: &mut Vec<Line>) {
    let words = view.words;
    let named = |id: &str, text: String| Line::Named(view.text(id), text);
    lines.push(named("records-page-cycle-number", cycle.cycle.to_string()));
    let origin = match &cycle.origin {
        CycleOrigin::Perfect => message!("cycles-from-perfect"),
        CycleOrigin::Workpiece { seed, .. } => message!("cycles-from-simulated").text("seed", seed),
        CycleOrigin::Contacts { file } => message!("cycles-from-recorded").text("file", file),
    };
    lines.push(named("head-from", words.say(&origin)));
    if let Some((program, line)) = &cycle.block {
        let said = message!("records-page-block").text("program", program).text("line", line);
        lines.push(named("records-page-program", words.say(&said)));
    }
    if let Some(datum) = &cycle.datum {
        lines.extend(datum_lines(words, datum).into_iter().map(|said| named("records-page-datum", said)));
    }
    for compared in &cycle.compared {
        let mm = |length| words.mm(length, 3);
        let text = format!("{} mm ({} … {} mm)", mm(compared.measured), mm(compared.minimum), mm(compared.maximum));
        lines.push(Line::Named(compared.what.clone(), text));
    }
    let parameters: Vec<String> =
        cycle.parameters.iter().map(|(name, value)| format!("{name}={}", words.number(value))).collect();
    lines.push(named("records-page-parameters", parameters.join("  ")));
    let figures: Vec<String> =
        cycle.figures.iter().map(|(name, length)| format!("{name} {}", words.mm(*length, 3))).collect();
    lines.push(named("records-page-figures", figures.join(", ")));
}

/// What was written, and what it shows.
/// Which rule fired since which part, and the answer.
fn of_alarm(view: &View<'_>, alarm: &Alarm, answer: Option<&AlarmAnswer>, lines: &mut Vec<Line>) {
    lines.push(Line::Heading(view.text("records-page-alarm")));
    lines.push(Line::Sentence(view.words.told(alarm)));
    if let Some(answer) = answer {
        lines.push(Line::Named(view.text("walk-page-alarm-cause"), answer.cause.clone()));
        lines.push(Line::Named(view.text("walk-page-alarm-action"), answer.action.clone()));
    }
}

fn of_report(view: &View<'_>, report: &Reported, lines: &mut Vec<Line>) {
    let words = view.words;
    let Reported { name, format, sha256, bytes, title, shown } = report;
    let named = |id: &str, text: String| Line::Named(view.text(id), text);
    lines.push(Line::Heading(view.text("records-page-report-entry")));
    lines.push(named("records-page-report-file", name.clone()));
    lines.push(named("records-page-report-format", format.clone()));
    lines.push(named(
        "records-page-report-size",
        words.say(&message!("records-page-report-bytes").text("count", grouped(*bytes))),
    ));
    if !title.is_empty() {
        lines.push(named("records-page-report-title", title.clone()));
    }
    lines.push(named("records-page-report-sha256", sha256.to_string()));
    lines.push(named("records-page-report-checks", grouped(shown.checks.count())));
    let numbers = shown
        .checks
        .ranges()
        .iter()
        .map(|[first, last]| if first == last { first.to_string() } else { format!("{first} … {last}") });
    let numbers = numbers.collect::<Vec<_>>().join(", ");
    if !numbers.is_empty() {
        lines.push(named("records-page-report-numbers", numbers));
    }
    if 0 < shown.unrecorded {
        lines.push(named("records-page-report-unrecorded", grouped(shown.unrecorded)));
    }
    lines.extend(shown.head.map(|head| named("records-page-report-head", format!("{} ({})", head.number, head.hash))));
}

/// A file, and SHA-256 of its bytes.
fn of_file(view: &View<'_>, file: &UsedFile) -> Line {
    let text = format!("{} · SHA-256 {}", file.name, file.sha256);
    Line::Named(view.text(&format!("records-page-file-{}", file.role.word())), text)
}
