//! One fit for people: a few aligned lines.

use std::fmt::Display;

use super::answer::{Answer, Equivalent, Measured};
use super::heat::{Heat, Heated};
use super::line::line;
use crate::cli::Io;
use crate::cli::limits::lower_and_upper;
use crate::cli::material::Part;
use crate::cli::people::{mm, negative, range};
use crate::length::Length;
use crate::tolerance::fit::basis;
use crate::tolerance::fit::preferred::{function, preference};
use crate::tolerance::{Limits, PartTolerance, ToleranceClass};
use crate::verdict::{Status, Verdict};

pub(super) fn write(answer: &Answer<'_>, io: &mut Io<'_>) {
    let Answer { callout, hole, shaft, fit, .. } = answer;
    writeln!(io.people(), "{callout}  {}", with_remarks(&fit.kind(), answer.classes()));
    let minimum = fit.minimum_clearance();
    let maximum = fit.maximum_clearance();
    let range = range(minimum, maximum);
    line("clearance", format_args!("{range}, mean {} µm{}", fit.mean_clearance().signed_um(), negative(minimum)), io);
    part("hole", *hole, fit.hole(), io);
    part("shaft", *shaft, fit.shaft(), io);
    if let Some(other) = &answer.equivalent {
        line("other basis", equivalent(other), io);
    }
    measured(&answer.measured, io);
    if let Some((heat, heated)) = &answer.heated {
        temperature(heat, heated, io);
    }
    if let Some((named, press)) = &answer.press {
        super::press::write(named, press, io);
    }
}

/// `clearance fit, hole basis, preferred fit of the hole basis, sliding`
pub(super) fn with_remarks(kind: &dyn Display, classes: Option<(ToleranceClass, ToleranceClass)>) -> String {
    let Some((hole, shaft)) = classes else { return kind.to_string() };
    let basis = basis(hole, shaft).map(|basis| basis.to_string());
    let preferred = preference(hole, shaft).map(|preference| preference.to_string());
    // "preferred fit of the hole basis" also names the basis, unless it is both.
    let basis = basis.filter(|basis| preferred.as_ref().is_none_or(|preferred| !preferred.ends_with(basis.as_str())));
    let function = function(hole, shaft).map(|function| function.to_string());
    let all = [Some(kind.to_string()), basis, preferred, function];
    all.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn part(name: &str, tolerance: PartTolerance, limits: &Limits, io: &mut Io<'_>) {
    let range = format!("{} … {} mm", mm(limits.minimum()), mm(limits.maximum()));
    let deviations = format!("({} µm)", lower_and_upper(&limits.deviations));
    let source = limits.source.with_difference();
    line(&format!("{name} {tolerance}"), format_args!("{range:<22}  {deviations:<18}  from {source}"), io);
}

fn equivalent(other: &Equivalent) -> String {
    let callout = &other.callout;
    match &other.fit {
        Ok((_, difference)) if difference.is_none() => format!("{callout}, exactly the same clearances"),
        Ok((fit, _)) => {
            let range = range(fit.minimum_clearance(), fit.maximum_clearance());
            format!("{callout}, not the same: {range}, {}", fit.kind())
        }
        Err(error) => format!("{callout} does not exist: {error}"),
    }
}

fn measured(measured: &Measured, io: &mut Io<'_>) {
    let judged = |diameter: Length, verdict: &Verdict| {
        let removal = verdict.size.removal.filter(|_| verdict.status() == Status::Rework);
        let removal = removal
            .map_or_else(String::new, |removal| format!(", remove {} mm to the nearest limit", removal.to_limit));
        format!("{} mm  {}{removal}", mm(diameter), verdict.status())
    };
    match measured {
        Measured::None => {}
        Measured::One(part) => {
            line(&format!("this {}", part.feature), judged(part.measured, &part.verdict), io);
            let range = range(part.minimum, part.maximum);
            let other = part.feature.other();
            line("possible", format_args!("{range} with a {other} within its limits"), io);
        }
        Measured::Both(actual) => {
            line("this hole", judged(actual.hole, &actual.hole_verdict), io);
            line("this shaft", judged(actual.shaft, &actual.shaft_verdict), io);
            let conforms = if actual.conforms { "within what the fit allows" } else { "outside what the fit allows" };
            line("actual", format_args!("{} µm, {conforms}", actual.clearance.signed_um()), io);
        }
    }
}

fn temperature(heat: &Heat, heated: &Heated, io: &mut Io<'_>) {
    let hole = heat.hole.warm.temperature;
    let shaft = heat.shaft.warm.temperature;
    let name = if hole == shaft { format!("at {hole} °C") } else { "when warm".to_owned() };
    let range = range(heated.minimum, heated.maximum);
    let kind = heated.kind();
    let change = heated.change.signed_um();
    line(&name, format_args!("{range}, {kind}, {change} µm against 20 °C"), io);
    if let Some(actual) = heated.actual {
        line("", format_args!("actual {} µm", actual.signed_um()), io);
    }
    line("", format_args!("hole {}", material(&heat.hole)), io);
    line("", format_args!("shaft {}", material(&heat.shaft)), io);
}

/// `at 220 °C: steel, 11.5 millionths per kelvin from -100 to 250 °C (published value)`
fn material(part: &Part) -> String {
    let name = part.name.as_ref().map_or_else(String::new, |name| format!("{name}, "));
    let temperature = part.warm.temperature;
    let expansion = part.warm.expansion;
    let certainty = part.certainty;
    let least = part.range.least;
    let most = part.range.most;
    format!("at {temperature} °C: {name}{expansion} millionths per kelvin from {least} to {most} °C ({certainty})")
}
