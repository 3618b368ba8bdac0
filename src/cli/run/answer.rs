//! The result of a run, for programs: JSON. The names must not change.
//!
//! Lists are made entry by entry while they are written, so that an answer takes no memory of its own.

use serde::ser::{Serialize, SerializeMap as _, Serializer};
use serde_json::{Map, Value as Json, json};

use super::super::cycle::Source;
use super::super::cycle::answer::{check, source as result_source, value as result_value};
use super::super::{CliRemark, tools};
use super::{Ended, Io, LONGEST_TEXT, Listener, place};
use crate::control::variables::{Parameter, Value};
use crate::length::Length;
use crate::message::Say as _;
use crate::nc::machine::{
    BlockPlace, CycleRun, DatumInForce, Fault, Machine, NcPath, Origin, SetBy, ToolChanged, Window, Written,
};
use crate::probing::cycle::ResultParameter;
use crate::text::cut;

/// The most blocks that a trace keeps.
const MOST: usize = 100_000;
/// The most memory that it takes, bytes: a block may change a thousand texts.
const MOST_BYTES: usize = 32 << 20;

/// A parameter that a block has changed, and its value.
type Changed = (Parameter, Option<Value>);

/// A block of a trace; its text is looked up when it is written.
struct Entry {
    at: BlockPlace,
    changed: Box<[Changed]>,
}

/// Remembers every block with the values that it changed.
pub(super) struct Trace {
    is_wanted: bool,
    at: Option<BlockPlace>,
    blocks: Vec<Entry>,
    bytes: usize,
    /// The first block that is not listed.
    end: Option<BlockPlace>,
    dropped: usize,
}

impl Trace {
    pub(super) const fn new(is_wanted: bool) -> Self {
        Self { is_wanted, at: None, blocks: Vec::new(), bytes: 0, end: None, dropped: 0 }
    }

    /// What the answer says of blocks that are not listed.
    fn remark(&self) -> Option<(&BlockPlace, CliRemark)> {
        Some((self.end.as_ref()?, CliRemark::TraceEnds { blocks: self.blocks.len() }))
    }
}

impl Listener for Trace {
    fn before(&mut self, machine: &Machine) {
        if self.is_wanted {
            self.at = Some(machine.place());
        }
    }

    fn after(&mut self, machine: &Machine, _io: &mut Io<'_>) {
        let Some(at) = self.at.take() else { return };
        let size = |parameter: &Parameter| match machine.variables().get(*parameter) {
            Some(Value::Text(text)) => size_of::<Changed>() + text.len(),
            _ => size_of::<Changed>(),
        };
        self.bytes += size_of::<Entry>() + machine.changed().iter().map(size).sum::<usize>();
        if self.end.is_some() || MOST <= self.blocks.len() || MOST_BYTES < self.bytes {
            self.end.get_or_insert(at);
            self.dropped += 1;
            return;
        }
        let changed = machine.changed().iter().map(|changed| (*changed, machine.variables().get(*changed).cloned()));
        self.blocks.push(Entry { at, changed: changed.collect() });
    }
}

/// A list whose entries are made one after the other while they are written.
struct Each<F>(F);

impl<I: Iterator<Item: Serialize>, F: Fn() -> I> Serialize for Each<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq((self.0)())
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
    let text = program.and_then(|program| program.text_of(block).next()).unwrap_or("").trim();
    let text = cut(text, LONGEST_TEXT);
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
    let name = |found: &ResultParameter| found.key.map_or_else(|| found.name.in_files(), |key| key.to_string());
    let results: Map<String, Json> =
        result.results.iter().map(|found| (name(found), result_value(&found.value))).collect();
    let more = json!({
        "cycle": run.cycle.code,
        "results": results,
        "checks": result.checks.iter().map(check).collect::<Vec<_>>(),
        "status": result.verdict().map(crate::verdict::Status::word),
        "is_reworked": run.is_reworked,
        "stop": result.stop.as_ref().map(ToString::to_string),
        "contacts": result.contacts,
        "remarks": result.remarks.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "warnings": result.warnings().iter().map(ToString::to_string).collect::<Vec<_>>(),
    });
    let mut placed = placed(machine, &run.place, more);
    // Only where a cycle has set one.
    if let (Some(datum), Some(entry)) = (&run.datum, placed.as_object_mut()) {
        entry.insert("datum".to_owned(), in_force(datum));
    }
    placed
}

/// The datum that a cycle counted from.
fn in_force(datum: &DatumInForce) -> Json {
    let by = |by: &SetBy| json!({"line": by.line, "text": by.text});
    let mut said = json!({"zero_mm": datum.zero.map(Length::to_mm_f64), "set_by": datum.set_by.as_ref().map(by)});
    let turns = [
        ("rotation", datum.rotation.as_ref().map(|turn| json!({"degrees": turn.degrees, "set_by": by(&turn.set_by)}))),
        ("tilt", datum.tilt.as_ref().map(|turn| json!({"degrees": turn.degrees, "set_by": by(&turn.set_by)}))),
    ];
    if let Some(entry) = said.as_object_mut() {
        entry.extend(turns.into_iter().filter_map(|(name, turn)| Some((name.to_owned(), turn?))));
    }
    said
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

/// Everything that a run gave.
pub(super) struct Answer<'a> {
    pub(super) machine: &'a Machine,
    pub(super) ended: &'a Ended,
    pub(super) source: &'a Source,
    pub(super) trace: &'a Trace,
}

impl Serialize for Answer<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { machine, ended, source, trace } = *self;
        let window = |window: &Window| {
            let more = json!({"mask": window.mask.to_string(), "window": window.text, "is_open": window.is_open});
            placed(machine, &window.place, more)
        };
        let output = |output: &Written| {
            let more = json!({"file": output.path.to_string(), "output": output.text, "is_saved": output.is_saved});
            placed(machine, &output.place, more)
        };
        let remark = |(at, said): (&BlockPlace, String)| placed(machine, at, json!({"message": said}));
        let tool_change = |changed: &ToolChanged| placed(machine, &changed.place, tools::json(&changed.change));
        let parameters: Map<String, Json> =
            machine.variables().iter().map(|(parameter, value)| (parameter.to_string(), plain(Some(value)))).collect();
        let mut answer = serializer.serialize_map(None)?;
        answer.serialize_entry("blocks", &machine.blocks_run())?;
        answer.serialize_entry("status", &machine.status().map(crate::verdict::Status::word))?;
        answer.serialize_entry("source", &result_source(source))?;
        answer.serialize_entry("parameters", &parameters)?;
        answer.serialize_entry("files", &Each(|| machine.origins().iter().map(file)))?;
        answer.serialize_entry("windows", &Each(|| machine.windows().iter().map(window)))?;
        answer.serialize_entry("outputs", &Each(|| machine.outputs().iter().map(output)))?;
        answer.serialize_entry("cycles", &Each(|| machine.cycles().iter().map(|run| cycle(machine, run))))?;
        if machine.tool_table().is_some() {
            let changed = || machine.tool_changes().iter().map(tool_change);
            answer.serialize_entry("tool_changes", &Each(changed))?;
            answer.serialize_entry("tools_out", &ended.tools_out)?;
        }
        answer.serialize_entry("pauses", &Each(|| ended.pauses.iter().map(ToString::to_string)))?;
        let remarks = || {
            let of_run = machine.remarks().iter().map(|(at, remark)| (at, remark.to_string()));
            let of_trace = trace.remark().map(|(at, remark)| (at, remark.message().to_string()));
            of_run.chain(of_trace).map(remark)
        };
        answer.serialize_entry("remarks", &Each(remarks))?;
        answer.serialize_entry("remarks_not_listed", &machine.unlisted_remarks())?;
        answer.serialize_entry("warnings", &ended.warnings)?;
        answer.serialize_entry("passed_over", machine.passed_over())?;
        answer.serialize_entry("faults", &Each(|| ended.fault.iter().map(fault)))?;
        if trace.is_wanted {
            answer.serialize_entry("trace", &Each(|| trace.blocks.iter().map(|entry| traced(machine, entry))))?;
            answer.serialize_entry("trace_not_listed", &trace.dropped)?;
        }
        answer.end()
    }
}

/// A file that was read, and where it comes from.
fn file((path, origin): (&NcPath, &Origin)) -> Json {
    let from = match origin {
        Origin::Given(name) => json!(name.as_ref().map(|name| name.display().to_string())),
        Origin::BuiltIn | Origin::BuiltInInstead => json!("built in"),
    };
    json!({"file": path.to_string(), "from": from})
}

/// A block of the trace.
fn traced(machine: &Machine, entry: &Entry) -> Json {
    let changed = entry.changed.iter().map(|(parameter, value)| (parameter.to_string(), plain(value.as_ref())));
    placed(machine, &entry.at, json!({"changed": changed.collect::<Map<_, _>>()}))
}
