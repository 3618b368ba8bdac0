//! What a cycle found, for people.

use super::answer::warnings;
use super::{Io, Run, Source};
use crate::probing::cycle::{LogTarget, Move, Unset};
use crate::probing::simulated::Part;

pub(super) fn print(run: &Run<'_>, with_path: bool, io: &mut Io<'_>) {
    let cycle = run.cycle;
    let result = run.result;
    writeln!(io.people(), "{} {}", cycle.code, cycle.name(run.language));
    writeln!(io.people(), "{}", source(run));
    let probe = result.inputs.probe();
    let number = probe.number;
    let set_up = probe.set_up;
    let longest = probe.longest_path;
    let ball = run.ball_radius;
    writeln!(io.people(), "probe {number}: SET_UP {set_up} mm, DIST {longest} mm, ball radius {ball} mm");

    writeln!(io.people());
    writeln!(io.people(), "parameters");
    let shown =
        cycle.parameters.iter().filter(|parameter| parameter.has_effect || result.inputs.is_given(parameter.key));
    let width = shown.clone().map(|parameter| parameter.question(run.language).chars().count()).fold(0, usize::max);
    for parameter in shown {
        let question = parameter.question(run.language);
        let value = match result.inputs.value(parameter.key) {
            Some(value) => value.with_unit().to_string(),
            None => "–".to_owned(),
        };
        let is_default = !result.inputs.is_given(parameter.key) && matches!(parameter.unset, Unset::Value(_));
        let note = if is_default { "  (default)" } else { "" };
        writeln!(io.people(), "  {:<6} {question:<width$}  {value}{note}", parameter.key);
    }

    writeln!(io.people());
    writeln!(io.people(), "contacts");
    for (number, contact) in (1_usize..).zip(&result.contacts) {
        writeln!(io.people(), "  {number}   {:>14.6} {:>14.6} {:>14.6}", contact.x, contact.y, contact.z);
    }
    if with_path {
        writeln!(io.people());
        print_path(&result.path, io);
    }

    writeln!(io.people());
    writeln!(io.people(), "results");
    for found in &result.results {
        let name = found.name.to_string();
        writeln!(io.people(), "  {:<5} {name:<36}  {}", found.called(), found.value.with_unit());
    }
    writeln!(io.people());
    for check in &result.checks {
        writeln!(io.people(), "{check}");
    }
    match (result.verdict(), result.status) {
        (Some(status), _) => writeln!(io.people(), "{status}"),
        (None, Some(_)) => {
            writeln!(io.people(), "no verdict: no limits were given; a control then reports within tolerance");
        }
        (None, None) => writeln!(io.people(), "nothing to judge: no tolerance"),
    }
    if let Some(stop) = &result.stop {
        writeln!(io.people(), "{stop}");
    }
    match result.log {
        LogTarget::None => {}
        LogTarget::File(name) => writeln!(io.people(), "the control writes {name}"),
        LogTarget::Screen => writeln!(io.people(), "the control stops and shows its log on screen"),
        LogTarget::Shown => writeln!(io.people(), "the control shows the result on screen"),
    }
    for remark in &result.remarks {
        writeln!(io.people(), "note: {remark}");
    }
    if let Some(change) = &run.tools.change {
        writeln!(io.people(), "note: {change}");
    }
    for warning in warnings(run) {
        writeln!(io.people(), "note: {warning}");
    }
    if let Some(log) = &run.log.shown {
        writeln!(io.people());
        io.people().write_all(log.as_bytes());
    }
}

fn source(run: &Run<'_>) -> String {
    match run.source {
        Source::Perfect => "perfect workpiece at nominal, perfect probe".to_owned(),
        Source::Workpiece { file, part } => {
            let Part { temperature, expansion, seed, .. } = part;
            // At the reference temperature nothing expands.
            let expansion = if part.is_at_reference() {
                String::new()
            } else {
                format!(", expansion {expansion} millionths per kelvin")
            };
            format!("simulated workpiece {file}, {temperature} °C{expansion}, seed {seed}")
        }
        Source::Contacts { file, .. } => format!("contacts from {file}"),
    }
}

/// The path of the ball's centre.
pub(super) fn print_path(path: &[Move], io: &mut Io<'_>) {
    writeln!(io.people(), "path of the ball's centre");
    for (number, step) in (1_usize..).zip(path) {
        let [x, y, z] = step.to;
        let touch = step.touch.map_or_else(String::new, |touch| format!("touch {touch}"));
        let way = if step.about.is_some() { "on an arc" } else { "" };
        let phase = step.phase.word();
        let line = format!("  {number:>3}  {phase:<12} {touch:<8} to {x:>14.6} {y:>14.6} {z:>14.6}  {way}");
        writeln!(io.people(), "{}", line.trim_end());
    }
}
