//! What a cycle found, for programs: JSON and CSV.

use serde_json::{Map, Value as Json, json};

use super::super::rows::csv;
use super::super::tools;
use super::{Io, Run, Source};
use crate::length::Length;
use crate::probing::circle::{Evaluation, Uncertainty};
use crate::probing::cycle::{Check, CircleFound, LogTarget, Move, Plane, ResultParameter, Value};
use crate::probing::{Contact, TouchProbe};
use crate::verdict::Status;
use crate::words::Dialogue;

/// What the contacts cannot tell, and where the log differs.
pub(super) fn warnings(run: &Run<'_>) -> Vec<String> {
    let contacts = run.result.warnings().into_iter();
    contacts.map(|warning| warning.to_string()).chain(run.log.other.map(|other| other.to_string())).collect()
}

object! {
    pub(super) struct Answer<'a> of(run: &'a Run<'_>) {
        cycle: &'a str = run.cycle.code,
        name: &'a str = run.cycle.name(Dialogue::En),
        source: Json = source(run.source),
        probe: Probe = Probe::of(run.result.inputs.probe(), run.ball_radius),
        inputs: Map<String, Json> = inputs(run),
        contacts: &'a [Contact] = &run.result.contacts,
        circle: Option<Circle> = Some(Circle::of(run.result.circle.as_ref()?, run.result.evaluation().as_ref())),
        results: Vec<Json> = run.result.results.iter().map(result).collect(),
        checks: Vec<Json> = run.result.checks.iter().map(check).collect(),
        status: Option<&'a str> = run.result.verdict().map(Status::word),
        stop: Option<String> = run.result.stop.as_ref().map(ToString::to_string),
        log: Option<&'a str> = match run.result.log {
            LogTarget::None => None,
            LogTarget::File(name) => Some(name),
            LogTarget::Screen | LogTarget::Shown => Some("screen"),
        },
        log_text: Option<&'a str> = run.log.shown.as_deref(),
        remarks: Vec<String> = run.result.remarks.iter().map(ToString::to_string).collect(),
        warnings: Vec<String> = warnings(run),
        path: Vec<Step> = run.result.path.iter().map(Step::of).collect(),
        #[serde(skip_serializing_if = "Option::is_none")]
        tool_changes: Option<Vec<Json>> =
            run.tools.has_table.then(|| run.tools.change.iter().map(tools::json).collect()),
        #[serde(skip_serializing_if = "Option::is_none")]
        tools_out: Option<Json> = run.tools.has_table.then(|| json!(run.tools.written)),
    }

    struct Probe of(probe: &TouchProbe, ball_radius: f64) {
        number: u32 = probe.number,
        ball_radius_mm: f64 = ball_radius,
        set_up_mm: f64 = mm(probe.set_up),
        dist_mm: f64 = mm(probe.longest_path),
        cal_of_mm: [f64; 2] = probe.offset.map(mm),
        f_mm_min: u32 = probe.feed,
        fmax_mm_min: u32 = probe.rapid,
    }

    struct Circle of(found: &CircleFound, evaluation: Option<&Evaluation>) {
        plane: Plane = found.plane,
        centre_mm: [f64; 2] = found.centre.map(mm),
        diameter_mm: f64 = mm(found.diameter),
        centre_deviation_mm: [f64; 2] = found.position.axes.map(|axis| mm(axis.deviation)),
        is_in_position: Option<bool> = found.position.is_monitored().then(|| !found.position.is_out()),
        residuals_mm: Option<Vec<f64>> = Some(evaluation?.residuals.clone()),
        arc_deg: Option<f64> = Some(evaluation?.arc_deg),
        uncertainty: Option<Uncertainty> = Some(evaluation?.uncertainty),
    }

    struct Step of(step: &Move) {
        phase: &'static str = step.phase.word(),
        touch: Option<usize> = step.touch,
        from: [f64; 3] = step.from,
        to: [f64; 3] = step.to,
        about: Option<[f64; 3]> = step.about,
    }
}

row! {
    /// A line of CSV: a result, or the status.
    struct Line of(found: &ResultParameter, simulated: bool) {
        key: Option<String> = Some(found.key?.to_string()),
        name: String = found.name.to_string(),
        value: String = found.value.to_string(),
        unit: &'static str = if matches!(found.value, Value::Length(_)) { "mm" } else { "" },
        simulated: bool = simulated,
    }

    /// A line of the path as CSV.
    struct PathLine of(step: usize, to: &Move) {
        step: usize = step,
        phase: &'static str = to.phase.word(),
        touch: Option<usize> = to.touch,
        from_x: f64 = to.from[0],
        from_y: f64 = to.from[1],
        from_z: f64 = to.from[2],
        to_x: f64 = to.to[0],
        to_y: f64 = to.to[1],
        to_z: f64 = to.to[2],
    }
}

fn result(found: &ResultParameter) -> Json {
    json!({"key": found.key.map(|key| key.to_string()), "name": found.name.to_string(), "value": value(&found.value)})
}

/// A length has at most 16 figures and none finer than a nanometre, so its nearest float prints the same.
fn mm(length: Length) -> f64 {
    length.to_mm_f64()
}

pub(in crate::cli) fn value(value: &Value) -> Json {
    match value {
        Value::Length(length) => json!(mm(*length)),
        Value::Angle(angle) => json!(angle.to_degrees_f64()),
        Value::Whole(whole) => json!(whole),
        Value::Number(number) => json!(number),
        Value::Text(_) | Value::Band(_) | Value::Nominal(_) | Value::Predef => json!(value.to_string()),
    }
}

fn inputs(run: &Run<'_>) -> Map<String, Json> {
    let given = run.cycle.parameters.iter().filter_map(|parameter| {
        let given = run.result.inputs.value(parameter.key)?;
        Some((parameter.key.to_string(), value(given)))
    });
    given.collect()
}

/// Where the contacts come from.
pub(in crate::cli) fn source(source: &Source) -> Json {
    match source {
        Source::Perfect => json!({"kind": "perfect"}),
        Source::Workpiece { file, part } => json!({
            "kind": "simulated", "file": file, "seed": part.seed, "temperature_c": part.temperature,
            "expansion_um_per_m_k": part.expansion,
        }),
        Source::Contacts { file, .. } => json!({"kind": "contacts", "file": file}),
    }
}

pub(in crate::cli) fn check(check: &Check) -> Json {
    json!({
        "what": check.what.to_string(),
        "measured_mm": mm(check.measured),
        "minimum_mm": mm(check.minimum),
        "maximum_mm": mm(check.maximum),
        "status": check.status.word(),
    })
}

pub(super) fn print_csv(run: &Run<'_>, io: &mut Io<'_>) {
    let simulated = run.source.origin().is_simulated();
    let key = Some("status".to_owned());
    let name = "status".to_owned();
    let status =
        Line { key, name, value: run.result.verdict().map_or("", Status::word).to_owned(), unit: "", simulated };
    csv(run.result.results.iter().map(|found| Line::of(found, simulated)).chain([status]), io);
}

pub(super) fn print_path_csv(path: &[Move], io: &mut Io<'_>) {
    csv((1_usize..).zip(path).map(|(step, to)| PathLine::of(step, to)), io);
}
