//! The result of a run, for programs: JSON. The names must not change.

use serde_json::{Map, Value as Json, json};

use super::super::cycle::answer::{check, value as result_value};
use super::{CliError, Ended, Io, Listener, place};
use crate::control::variables::{Parameter, Value};
use crate::nc::machine::{BlockPlace, CycleRun, Fault, Machine, NcPath};

/// The most blocks that a trace keeps.
const MOST: usize = 100_000;

/// Remembers every block with the values that it changed.
pub(super) struct Trace {
    is_wanted: bool,
    at: Option<BlockPlace>,
    blocks: Vec<Json>,
    dropped: usize,
}

impl Trace {
    pub(super) const fn new(is_wanted: bool) -> Self {
        Self { is_wanted, at: None, blocks: Vec::new(), dropped: 0 }
    }
}

impl Listener for Trace {
    fn before(&mut self, machine: &Machine) {
        if self.is_wanted {
            self.at = Some(machine.place());
        }
    }

    fn after(&mut self, machine: &Machine, _io: &mut Io<'_>) -> Result<(), CliError> {
        let Some(BlockPlace { program, block }) = &self.at else { return Ok(()) };
        if MOST <= self.blocks.len() {
            self.dropped += 1;
            return Ok(());
        }
        let changed = |parameter: &Parameter| (parameter.to_string(), plain(machine.variables().get(*parameter)));
        let mut entry = located(machine, program, *block);
        entry.insert("changed".to_owned(), machine.changed().iter().map(changed).collect::<Map<_, _>>().into());
        self.blocks.push(entry.into());
        Ok(())
    }
}

/// A value as JSON; null where the parameter is undefined.
fn plain(value: Option<&Value>) -> Json {
    match value {
        None => Json::Null,
        Some(Value::Length(length)) => json!(length.to_mm_f64()),
        Some(Value::Number(number)) => json!(number),
        Some(Value::Text(text)) => json!(text),
    }
}

/// Program, line and text of a block.
fn located(machine: &Machine, path: &NcPath, block: usize) -> Map<String, Json> {
    let (_, line) = place(machine, path, block);
    let program = machine.program(path);
    let number = program.and_then(|program| program.blocks().get(block)).and_then(|block| block.number);
    let text = program.and_then(|program| program.text_of(block).next()).unwrap_or_default().trim();
    let entries =
        [("program", json!(path.to_string())), ("line", json!(line)), ("number", json!(number)), ("text", json!(text))];
    entries.map(|(name, value)| (name.to_owned(), value)).into_iter().collect()
}

/// The same with more values.
fn placed(machine: &Machine, at: &BlockPlace, more: Json) -> Json {
    let mut entry = located(machine, &at.program, at.block);
    if let Json::Object(more) = more {
        entry.extend(more);
    }
    entry.into()
}

fn cycle(machine: &Machine, run: &CycleRun) -> Json {
    let result = &run.result;
    let results: Map<String, Json> =
        result.results.iter().map(|found| (found.key.to_string(), result_value(&found.value))).collect();
    let more = json!({
        "cycle": run.cycle.code,
        "results": results,
        "checks": result.checks.iter().map(check).collect::<Vec<_>>(),
        "status": result.status.map(crate::verdict::Status::word),
        "stop": result.stop.as_ref().map(ToString::to_string),
        "contacts": result.contacts,
        "remarks": result.remarks.iter().map(ToString::to_string).collect::<Vec<_>>(),
    });
    placed(machine, &run.place, more)
}

fn fault(fault: &Fault) -> Json {
    json!({
        "program": fault.place.program.to_string(),
        "line": fault.line,
        "number": fault.number,
        "text": fault.text,
        "message": fault.kind.to_string(),
    })
}

pub(super) fn print(machine: &Machine, ended: &Ended, trace: Trace, io: &mut Io<'_>) -> Result<(), CliError> {
    let parameters: Map<String, Json> =
        machine.variables().iter().map(|(parameter, value)| (parameter.to_string(), plain(Some(value)))).collect();
    let windows = machine.windows().iter().map(|window| {
        let more = json!({"mask": window.mask.to_string(), "window": window.text, "is_open": window.is_open});
        placed(machine, &window.place, more)
    });
    let outputs = machine.outputs().iter().map(|output| {
        let more = json!({"file": output.path.to_string(), "output": output.text, "is_saved": output.is_saved});
        placed(machine, &output.place, more)
    });
    let remarks =
        machine.remarks().iter().map(|(at, remark)| placed(machine, at, json!({"message": remark.to_string()})));
    let mut answer = json!({
        "blocks": machine.blocks_run(),
        "status": machine.status().map(crate::verdict::Status::word),
        "parameters": parameters,
        "windows": windows.collect::<Vec<_>>(),
        "outputs": outputs.collect::<Vec<_>>(),
        "cycles": machine.cycles().iter().map(|run| cycle(machine, run)).collect::<Vec<_>>(),
        "pauses": ended.pauses.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "remarks": remarks.collect::<Vec<_>>(),
        "remarks_not_listed": machine.unlisted_remarks(),
        "faults": ended.fault.iter().map(fault).collect::<Vec<_>>(),
    });
    if let (true, Json::Object(answer)) = (trace.is_wanted, &mut answer) {
        answer.insert("trace".to_owned(), trace.blocks.into());
        answer.insert("trace_not_listed".to_owned(), trace.dropped.into());
    }
    io.json(&answer)
}
