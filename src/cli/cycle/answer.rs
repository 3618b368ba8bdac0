//! What a cycle found, for programs: JSON and CSV.

use serde::Serialize;
use serde_json::{Map, Value as Json, json};

use super::super::tools;
use super::{CliError, Io, Run, Source};
use crate::length::Length;
use crate::probing::cycle::{Check, LogTarget, Move, Value};
use crate::report::csv::cell;
use crate::words::Dialogue;

/// What the contacts cannot tell, and where the log differs.
pub(super) fn warnings(run: &Run<'_>) -> Vec<String> {
    let contacts = run.result.warnings().into_iter();
    contacts.map(|warning| warning.to_string()).chain(run.log.other.map(|other| other.to_string())).collect()
}

/// The answer; its names must not change.
#[derive(Debug, Serialize)]
struct Answer<'a> {
    cycle: &'a str,
    name: &'a str,
    source: Json,
    probe: Json,
    inputs: Map<String, Json>,
    contacts: &'a [crate::probing::Contact],
    circle: Option<Json>,
    results: Vec<Json>,
    checks: Vec<Json>,
    status: Option<&'a str>,
    stop: Option<String>,
    log: Option<&'a str>,
    log_text: Option<&'a str>,
    remarks: Vec<String>,
    warnings: Vec<String>,
    path: Vec<Json>,
    /// Only with a tool table.
    #[serde(skip_serializing_if = "Option::is_none")]
    tool_changes: Option<Vec<Json>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tools_out: Option<Json>,
}

pub(super) fn print_json(run: &Run<'_>, io: &mut Io<'_>) -> Result<(), CliError> {
    let result = run.result;
    let answer = Answer {
        cycle: run.cycle.code,
        name: run.cycle.name(Dialogue::En),
        source: source(run.source),
        probe: probe(run),
        inputs: inputs(run),
        contacts: &result.contacts,
        circle: circle(run),
        results: result
            .results
            .iter()
            .map(|found| {
                let key = found.key.map(|key| key.to_string());
                json!({"key": key, "name": found.name.to_string(), "value": value(&found.value)})
            })
            .collect(),
        checks: result.checks.iter().map(check).collect(),
        status: result.verdict().map(crate::verdict::Status::word),
        stop: result.stop.as_ref().map(ToString::to_string),
        log: match result.log {
            LogTarget::None => None,
            LogTarget::File(name) => Some(name),
            LogTarget::Screen | LogTarget::Shown => Some("screen"),
        },
        log_text: run.log.shown.as_deref(),
        remarks: result.remarks.iter().map(ToString::to_string).collect(),
        warnings: warnings(run),
        path: result.path.iter().map(step).collect(),
        tool_changes: run.tools.has_table.then(|| run.tools.change.iter().map(tools::json).collect()),
        tools_out: run.tools.has_table.then(|| json!(run.tools.written)),
    };
    io.json(&answer)
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
        Value::Text(_) | Value::Band(_) | Value::Predef => json!(value.to_string()),
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

fn probe(run: &Run<'_>) -> Json {
    let probe = run.result.inputs.probe();
    json!({
        "number": probe.number,
        "ball_radius_mm": run.ball_radius,
        "set_up_mm": mm(probe.set_up),
        "dist_mm": mm(probe.longest_path),
        "cal_of_mm": probe.offset.map(mm),
        "f_mm_min": probe.feed,
        "fmax_mm_min": probe.rapid,
    })
}

fn circle(run: &Run<'_>) -> Option<Json> {
    let found = run.result.circle.as_ref()?;
    let evaluation = run.result.evaluation();
    let [axis_1, axis_2] = found.position.axes;
    Some(json!({
        "plane": found.plane,
        "centre_mm": found.centre.map(mm),
        "diameter_mm": mm(found.diameter),
        "centre_deviation_mm": [mm(axis_1.deviation), mm(axis_2.deviation)],
        "is_in_position": found.position.is_monitored().then(|| !found.position.is_out()),
        "residuals_mm": evaluation.as_ref().map(|evaluation| &evaluation.residuals),
        "arc_deg": evaluation.as_ref().map(|evaluation| evaluation.arc_deg),
        "uncertainty": evaluation.as_ref().map(|evaluation| evaluation.uncertainty),
    }))
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

fn step(step: &Move) -> Json {
    json!({"phase": step.phase.word(), "touch": step.touch, "from": step.from, "to": step.to, "about": step.about})
}

pub(super) fn print_csv(run: &Run<'_>, io: &mut Io<'_>) -> Result<(), CliError> {
    let mut writer = csv::Writer::from_writer(io.data());
    writer.write_record(["key", "name", "value", "unit", "simulated"])?;
    let simulated = run.source.origin().is_simulated().to_string();
    for found in &run.result.results {
        let unit = if matches!(found.value, Value::Length(_)) { "mm" } else { "" };
        let key = found.key.map(|key| key.to_string()).unwrap_or_default();
        let (name, value) = (found.name.to_string(), found.value.to_string());
        writer.write_record([key.as_str(), &name, &cell(&value), unit, &simulated])?;
    }
    let status = run.result.verdict().map_or("", crate::verdict::Status::word);
    writer.write_record(["status", "status", status, "", &simulated])?;
    writer.flush()?;
    Ok(())
}

pub(super) fn print_path_csv(path: &[Move], io: &mut Io<'_>) -> Result<(), CliError> {
    let mut writer = csv::Writer::from_writer(io.data());
    let names = ["step", "phase", "touch", "from_x", "from_y", "from_z", "to_x", "to_y", "to_z"];
    writer.write_record(names)?;
    for (number, step) in (1_usize..).zip(path) {
        let places = step.from.iter().chain(&step.to).map(ToString::to_string);
        let touch = step.touch.map(|touch| touch.to_string()).unwrap_or_default();
        let row: Vec<String> =
            [number.to_string(), step.phase.word().to_owned(), touch].into_iter().chain(places).collect();
        writer.write_record(&row)?;
    }
    writer.flush()?;
    Ok(())
}
