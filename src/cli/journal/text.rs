//! An entry with its whole reasoning, for people.

use std::fmt::Display;

use super::row::origin;
use super::{CliRemark, Io};
use crate::cli::people::mm;
use crate::cli::said::{decided, remark};
use crate::journal::chain::{ChainId, Head};
use crate::journal::entry::{
    About, Begin, BlockKept, Check, Checked, Content, Correction, CycleCheck, Entry, Reported,
};
use crate::journal::{Alarm, AlarmAnswer, Record};
use crate::message::Say as _;
use crate::probing::cycle::Angle;
use crate::store::local::ListedEntry;
use crate::tolerance::{Feature, FigureWarning};

/// So many contacts are listed.
const MOST_CONTACTS: usize = 100;

/// Writes a line after its name.
pub(super) fn line(name: &str, text: impl Display, io: &mut Io<'_>) {
    writeln!(io.people(), "{name:<13}{text}");
}

/// The same, unless there is nothing to say.
fn some(name: &str, text: &str, io: &mut Io<'_>) {
    if !text.is_empty() {
        line(name, text, io);
    }
}

pub(super) fn print(row: &ListedEntry, chain: ChainId, last: u64, io: &mut Io<'_>) {
    let head = row.kept.head;
    line("entry", format_args!("{} of {last}", head.number), io);
    line("chain", chain, io);
    line("hash", head.hash, io);
    let Ok(Entry { about, content }) = &row.entry else { return };
    print_about(about, io);
    match content {
        Content::Begin(begin) => print_begin(begin, io),
        Content::Withdrawal(correction) => print_correction("withdraws", correction, io),
        Content::Check(check) => print_check(check, io),
        Content::Report(report) => print_report(report, io),
        Content::Alarm(alarm) => print_alarm(alarm, io),
    }
    if let Some(number) = row.corrected_by {
        let does =
            if matches!(content, Content::Alarm(_)) { "answers this one" } else { "corrects this one or withdraws it" };
        line("see", format_args!("entry {number}, which {does}"), io);
    }
}

fn print_about(about: &About, io: &mut Io<'_>) {
    let zone = if about.time.zone.is_empty() { String::new() } else { format!(" ({})", about.time.zone) };
    line("recorded", format_args!("{}{zone}", about.time.text()), io);
    some("station", &about.station, io);
    some("who", &about.who, io);
    some("part", &about.part, io);
    some("serial", &about.serial, io);
    some("feature", &about.feature, io);
    some("remark", &about.remark, io);
}

fn print_begin(begin: &Begin, io: &mut Io<'_>) {
    line("begins", format_args!("the chain {}, by {}", begin.chain, begin.program), io);
    if let Some((chain, head)) = begin.after {
        line("after", format_args!("the chain {chain}, of which entry {}:{} is known", head.number, head.hash), io);
    }
}

fn print_correction(name: &str, correction: &Correction, io: &mut Io<'_>) {
    line(name, format_args!("entry {} ({})", correction.target.number, correction.target.hash), io);
    line("reason", &correction.reason, io);
    line("corrected by", &correction.by, io);
}

fn print_report(report: &Reported, io: &mut Io<'_>) {
    let Reported { name, format, sha256, bytes, title, shown } = report;
    line("report", name, io);
    line("format", format, io);
    some("title", title, io);
    line("size", format_args!("{bytes} bytes"), io);
    line("SHA-256", sha256, io);
    line("shows", super::written::shown(report), io);
    if let Some(Head { number, hash }) = shown.head {
        line("made after", format_args!("entry {number} ({hash})"), io);
    }
}

fn print_alarm(alarm: &Alarm, io: &mut Io<'_>) {
    line("alarm", alarm.message(), io);
    line("rule", format_args!("{}, {}", alarm.rule.word(), alarm.place.word()), io);
    line("values", format_args!("of the entries {} to {}", alarm.first, alarm.last), io);
    if let Some(AlarmAnswer { target, cause, action }) = &alarm.answer {
        line("answers", format_args!("entry {} ({})", target.number, target.hash), io);
        line("cause", cause, io);
        line("action", action, io);
    }
}

fn print_check(check: &Check, io: &mut Io<'_>) {
    line("verdict", check.status().map_or("none", crate::verdict::Status::word), io);
    match &check.what {
        Checked::Size(record) => print_size(record, io),
        Checked::Cycle(cycle) => print_cycle(cycle, io),
    }
    line("origin", origin(check), io);
    if check.is_simulated() {
        io.tell(remark(&CliRemark::Simulated));
    }
    if let Some(remark) = check.remark() {
        io.warn(&remark);
    }
    for file in &check.files {
        line("file", format_args!("{} {}, SHA-256 {}", file.role.word(), file.name, file.sha256), io);
    }
    if let Some(correction) = &check.corrects {
        print_correction("corrects", correction, io);
    }
}

fn print_size(record: &Record, io: &mut Io<'_>) {
    let Record { limits, measurement, verdict, .. } = record;
    some("named", &record.id, io);
    line("measured on", record.time, io);
    if let Some(callout) = &record.callout {
        line("callout", callout, io);
    }
    let upper = limits.deviations.upper().signed_um();
    let lower = limits.deviations.lower().signed_um();
    let minimum = mm(limits.minimum());
    let maximum = mm(limits.maximum());
    let feature = limits.feature.map_or("neither hole nor shaft", Feature::word);
    line("limits", format_args!("{minimum} to {maximum} mm ({feature}, {lower} / {upper} µm)"), io);
    line("source", limits.source.with_difference(), io);
    line("measured", format_args!("{} mm", mm(measurement.diameter)), io);
    if let Some(correction) = &record.correction {
        let as_measured = mm(correction.measured);
        let part = correction.part;
        let change = correction.change().signed_um();
        let warm = format!("{as_measured} mm at {} °C, {} · 10⁻⁶/K: {change} µm", part.temperature, part.expansion);
        line("at 20 °C", warm, io);
        if let Some(scale) = correction.scale {
            line("scales", format_args!("at {} °C, {} · 10⁻⁶/K", scale.temperature, scale.expansion), io);
        }
    }
    print_judgement(record, io);
    if let Some([x, y]) = measurement.centre {
        line("centre", format_args!("X {}, Y {} mm", mm(x), mm(y)), io);
    }
    if let Some(position) = verdict.position.filter(crate::verdict::PositionVerdict::is_monitored) {
        line("position", if position.is_out() { "OUT" } else { "IN" }, io);
    }
    print_contacts(&measurement.contacts, io);
    for caveat in record.caveats() {
        line("", caveat, io);
    }
}

/// Which rule decided, with what, and what it says.
fn print_judgement(record: &Record, io: &mut Io<'_>) {
    line("rule", record.verdict.rule, io);
    for said in record.decision().iter().flat_map(decided) {
        line("", said, io);
    }
    if let Some(why) = record.verdict.undecided {
        line("", why, io);
    }
    if let Some(removal) = record.verdict.size.removal {
        line("", CliRemark::Remove { limit: removal.to_limit, middle: removal.to_middle }, io);
    }
    if let Some(budget) = &record.budget {
        let date = budget.date;
        let until = budget.valid_until;
        let validity = budget.validity.word();
        line(
            "budget",
            format_args!("{}, created {date} by {}, valid until {until}: {validity}", budget.name, budget.by),
            io,
        );
        for warning in &budget.warnings {
            line("", warning, io);
        }
    }
    if let Some(doubt) = record.doubt {
        line("doubt", doubt, io);
    }
    let sources = crate::tolerance::Sources::default();
    let figure = record.callout.and_then(|callout| FigureWarning::of_limits(&callout, &record.limits, &sources));
    if let Some(warning) = figure {
        line("figure", warning, io);
    }
}

fn print_cycle(cycle: &CycleCheck, io: &mut Io<'_>) {
    line("cycle", cycle.cycle, io);
    if let Some((file, number)) = &cycle.block {
        line("program", format_args!("{file}, line {number}"), io);
    }
    if let Some(datum) = &cycle.datum {
        let [x, y, z] = datum.zero.map(mm);
        let by = |block: &BlockKept| format!("line {}: {}", block.line, block.text);
        let set = datum.set_by.as_ref().map_or_else(String::new, |block| format!(", set in {}", by(block)));
        line("datum", format_args!("zero at X {x}, Y {y}, Z {z} mm{set}"), io);
        if let Some((angle, block)) = &datum.rotation {
            line("datum", format_args!("axes turned by {}, since {}", Angle::nearest(*angle), by(block)), io);
        }
        if let Some((angles, block)) = &datum.tilt {
            let tilted = ["A", "B", "C"].into_iter().zip(angles);
            let tilted = tilted.map(|(axis, angle)| format!("{axis} {}", Angle::nearest(*angle)));
            let tilted = tilted.collect::<Vec<_>>().join(", ");
            line("datum", format_args!("plane tilted by {tilted}, since {}", by(block)), io);
        }
    }
    for (name, value) in &cycle.parameters {
        line("parameter", format_args!("{name} = {value}"), io);
    }
    for one in &cycle.compared {
        let minimum = mm(one.minimum);
        let maximum = mm(one.maximum);
        let what = &one.what;
        let measured = mm(one.measured);
        let status = one.status.word();
        line("compared", format_args!("{what} {measured} mm, {minimum} to {maximum} mm: {status}"), io);
    }
    for (name, length) in &cycle.figures {
        line("result", format_args!("{name} {} mm", mm(*length)), io);
    }
    print_contacts(&cycle.contacts, io);
}

fn print_contacts(contacts: &[crate::probing::Contact], io: &mut Io<'_>) {
    for contact in contacts.iter().take(MOST_CONTACTS) {
        let [x, y, z] = contact.place();
        line("contact", format_args!("X {x:.4}, Y {y:.4}, Z {z:.4}"), io);
    }
    let more = contacts.len().saturating_sub(MOST_CONTACTS);
    if 0 < more {
        line("", format_args!("and {more} more contacts"), io);
    }
}
