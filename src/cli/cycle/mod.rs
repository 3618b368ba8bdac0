//! `fitcheck cycle`: one measuring cycle on a simulated workpiece or on recorded contacts.
//!
//! | file | what |
//! |---|---|
//! | `source` | where the contacts come from |
//! | `list` | the declaration of a cycle |
//! | `json` | a JSON object, with names that occur twice |
//! | `answer` | what the cycle found, for programs |
//! | `text` | the same for people |
//! | `log` | its measuring log |

pub(super) mod answer;
mod json;
mod list;
mod log;
mod source;
mod text;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

pub(super) use source::{Source, SourceArgs};
use source::{remark_on_moves, warn_of_unused};

use super::args::dialogue;
use super::record::RecordArgs;
use super::tools::ToolArgs;
use super::{CliError, CliWarning, ErrorSubject, Format, IntoCliError as _, Io, Outcome, read_input};
use crate::control::probe_block::{self, ProbeBlockError, ProbeBlockFault};
use crate::control::probe_table::ProbeTable;
use crate::control::tool_table::{Changed, ToolChange};
use crate::journal::entry::CycleCheck;
use crate::length::Length;
use crate::message::Located;
use crate::nc::machine::{Remark, alone};
use crate::probing::TouchProbe;
use crate::probing::cycle::{Control, Cycle, CycleResult, Inputs, Key, Remark as CycleRemark, Value};
use crate::probing::cycles::{CYCLES, cycle_named};
use crate::probing::simulated::Shape;
use crate::text::decode;
use crate::words::Dialogue;

/// The examples and a description of the files; the names of logs and workpieces come from the declarations.
fn help() -> String {
    let logs = CYCLES.iter().filter_map(|cycle| cycle.log.file()).collect::<Vec<_>>();
    let tables = Shape::ALL.map(|shape| format!("[{}]", shape.table()));
    include_str!("help.txt")
        .replace("{logs}", &logs.join(", "))
        .replace("{tables}", &tables.join(", "))
        .trim_end()
        .to_owned()
}

/// The names that people use for the cycles.
fn codes() -> String {
    CYCLES.iter().map(|cycle| cycle.code).collect::<Vec<_>>().join(", ")
}

/// The largest JSON object of inputs in bytes: a real one has some hundred, and in memory it takes many times as many.
const LARGEST_INPUTS: usize = 1 << 20;

/// The options of a run, by their fields: without one they have no effect.
const OF_RUN: [&str; 10] =
    ["workpiece", "contacts", "seed", "from", "to", "position", "path", "log_folder", "program", "time"];

/// The options that give parameters and probe.
const OF_INPUTS: [&str; 6] = ["settings", "globals", "inputs", "block", "probe_table", "probe"];

/// Everything that `fitcheck cycle` may be given.
#[derive(Debug, clap::Args)]
#[command(about = format!("Run a measuring cycle: {}", codes()), after_help = help())]
pub(super) struct Args {
    #[arg(value_name = "CYCLE", value_parser = known, help = format!("The cycle: {}", codes()))]
    cycle: &'static Cycle,
    /// Parameters such as Q263=35, QS400=0.4-0.1 or BR=1
    #[arg(long = "set", value_name = "NAME=VALUE", num_args = 1..)]
    settings: Vec<String>,
    /// Values that PREDEF stands for, as GLOBAL DEF gives them, such as Q320=2
    #[arg(long = "predef", value_name = "NAME=VALUE", num_args = 1..)]
    globals: Vec<String>,
    /// Parameters as a JSON object; - reads standard input
    #[arg(long, value_name = "FILE.json")]
    inputs: Option<PathBuf>,
    /// The cycle's block in an NC program, in any dialogue language; - reads standard input
    #[arg(long, value_name = "FILE.h", conflicts_with = "inputs")]
    block: Option<PathBuf>,
    /// A line of the block to run, in a program with several
    #[arg(long, value_name = "LINE", requires = "block")]
    at: Option<usize>,
    #[command(flatten)]
    from: SourceArgs,
    /// Touch-probe table of a control, instead of the built-in one
    #[arg(long, value_name = "FILE.tp")]
    probe_table: Option<PathBuf>,
    #[command(flatten)]
    record: RecordArgs,
    #[command(flatten)]
    tools: ToolArgs,
    /// Number of the probe in the table; default: the first one
    #[arg(long, value_name = "N")]
    probe: Option<u32>,
    /// Position of the ball before the cycle, mm (G785)
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    position: Option<String>,
    /// Show the path of the probe, move by move
    #[arg(long)]
    path: bool,
    /// Show the parameters of the cycle and run nothing
    #[arg(long, conflicts_with_all = OF_RUN, conflicts_with_all = OF_INPUTS)]
    list: bool,
    /// Print the cycle as a block for an NC program, in the given language, and run nothing
    #[arg(long, conflicts_with = "list", conflicts_with_all = OF_RUN)]
    as_block: bool,
    #[command(flatten)]
    log: log::LogArgs,
    /// Language of the log, and of the control's questions and names as far as they are known
    #[arg(long, default_value = "en", value_parser = dialogue())]
    language: Dialogue,
    /// Format of the result
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// Everything that is printed.
struct Run<'a> {
    cycle: &'static Cycle,
    language: Dialogue,
    source: &'a Source,
    ball_radius: f64,
    result: &'a CycleResult,
    log: &'a log::Kept,
    tools: &'a Monitoring,
}

/// What the monitoring of a tool gave.
#[derive(Debug, Default)]
struct Monitoring {
    has_table: bool,
    change: Option<ToolChange>,
    /// Where the table was written to.
    written: Option<String>,
}

fn known(text: &str) -> Result<&'static Cycle, String> {
    cycle_named(text).ok_or_else(|| format!("the cycles are {}", codes()))
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let language = self.language;
        if self.list {
            list::print(self.cycle, language, self.format, io);
            return Ok(Outcome::Done);
        }
        let recorder = self.record.recorder(io)?;
        let inputs = self.read_inputs(io)?;
        if self.as_block {
            // A block that the control would refuse is not written.
            self.cycle.checked(&inputs).about(&self.what())?;
            let block = probe_block::write(self.cycle, &inputs, language);
            write!(io.data(), "{}", block.said()?);
            return Ok(Outcome::Done);
        }
        self.warn_without_effect(&inputs, io);
        let source = self.from.read(io)?;
        let mut prober = source.prober(self.cycle, &inputs)?;
        let (path, result) = self.cycle.measure_along(&inputs, &mut *prober);
        remark_on_moves(&source, &inputs, &path, io);
        let result = match result {
            Ok(result) => result,
            Err(error) => {
                if self.path && self.format == Format::Text {
                    text::print_path(&path, io);
                }
                return Err(error).about(&self.what());
            }
        };
        warn_of_unused(&source, &path, io);
        let (result, tools) = self.monitored(result, io)?;
        let ball_radius = prober.ball_radius();
        let log = self.log.keep(self.cycle, &result, &source, language, io)?;
        let run = Run {
            cycle: self.cycle,
            language,
            source: &source,
            ball_radius,
            result: &result,
            log: &log,
            tools: &tools,
        };
        match self.format {
            Format::Text => text::print(&run, self.path, io),
            Format::Csv if self.path => answer::print_path_csv(&path, io),
            Format::Csv => answer::print_csv(&run, io),
            Format::Json => io.json(&answer::Answer::of(&run)),
        }
        if let Some(mut recorder) = recorder {
            if result.verdict().is_some() {
                recorder.cycle(CycleCheck::of(self.cycle, &result, source.origin()), io.files())?;
            }
            recorder.keep(io)?;
        }
        if let (Some(stop), Format::Csv) = (&result.stop, self.format) {
            io.tell(stop);
        }
        if let (Some(change), Format::Csv) = (&tools.change, self.format) {
            io.remark(change);
        }
        if let Some(ToolChange { what: Changed::Locked(broken), .. }) = &tools.change {
            io.fail(broken);
            return Ok(Outcome::BadData);
        }
        if result.remarks.iter().any(CycleRemark::stands_against) {
            io.look_first();
        }
        self.look_at_limits(&result, io);
        Ok(result.verdict().map_or(Outcome::Done, Outcome::Judged))
    }

    /// Warns of options that this cycle and its parameters make no use of.
    fn warn_without_effect(&self, inputs: &Inputs, io: &mut Io<'_>) {
        if self.position.is_some() && self.cycle.control == Control::Milling {
            io.warn(&CliWarning::PositionUnused { code: self.cycle.code });
        }
        // Pairs that are none were refused before.
        for (name, _) in pairs(&self.globals).into_iter().flatten() {
            let key = self.cycle.parameter_named(name).map(|parameter| parameter.key);
            if key.and_then(|key| inputs.value(key)) != Some(&Value::Predef) {
                io.warn(&CliWarning::PredefUnused { name });
            }
        }
    }

    /// A block that leaves its limits out may have been meant to judge; one that only measures has limits of zero.
    fn look_at_limits(&self, result: &CycleResult, io: &mut Io<'_>) {
        let filled = self.block.as_ref().and_then(|_| Remark::filled(self.cycle, result));
        if let Some(filled @ Remark::Filled { are_limits: true, .. }) = filled {
            io.remark(&filled);
            io.look_first();
        }
    }

    /// Monitors the tool of Q330, where a tool table is given.
    fn monitored(&self, result: CycleResult, io: &mut Io<'_>) -> Result<(CycleResult, Monitoring), CliError> {
        let Some(mut table) = self.tools.read(io)? else { return Ok((result, Monitoring::default())) };
        let monitored = table.monitor(self.cycle, &result).about(&self.what())?;
        if monitored.is_none() {
            io.warn(&CliWarning::NoToolMonitored);
        }
        let (change, same_name) = monitored.map_or((None, None), |found| (found.change, found.same_name));
        if let Some((tool, more)) = same_name {
            io.remark(&Remark::SameName { tool, more });
        }
        let written = self.tools.write(Some(&table), change.is_some(), io)?;
        Ok((result.with_tool_table(), Monitoring { has_table: true, change, written }))
    }

    fn read_inputs(&self, io: &mut Io<'_>) -> Result<Inputs, CliError> {
        let mut inputs = Inputs::new().with_probe(self.touch_probe(io)?);
        if let Some(path) = &self.inputs {
            inputs = self.with_json(inputs, path, io)?;
        }
        if let Some(path) = &self.block {
            inputs = self.with_block(inputs, path, io)?;
        }
        let mut names = BTreeSet::new();
        for (name, value) in pairs(&self.settings)? {
            inputs = self.cycle.set(inputs, name, value).said()?;
            if !names.insert(self.cycle.parameter_named(name).map(|parameter| parameter.key)) {
                return Err(CliError::SetTwice { name: name.to_owned() });
            }
        }
        for (name, value) in pairs(&self.globals)? {
            let unknown = || CliError::NotPredef { name: name.to_owned() };
            let parameter = self.cycle.parameter_named(name).filter(|parameter| parameter.may_be_predef);
            let parameter = parameter.ok_or_else(unknown)?;
            let value = parameter.accept(value).said()?;
            inputs = inputs.with_global(parameter.key, value);
        }
        if let Some(text) = &self.position {
            inputs = inputs.with_position(position(text)?);
        }
        Ok(inputs)
    }

    fn with_block(&self, inputs: Inputs, path: &Path, io: &mut Io<'_>) -> Result<Inputs, CliError> {
        let (name, bytes) = read_input(path, io)?;
        let text = decode(&bytes);
        let read = self.at.map_or_else(|| probe_block::read(&text), |line| probe_block::read_at(&text, line));
        let block = match read {
            Err(ProbeBlockError { what: ProbeBlockFault::SecondBlock { .. }, .. }) => {
                let blocks = probe_block::beginnings(&text);
                return Err(CliError::SeveralBlocks { blocks }).about(&name);
            }
            read => read.about(&name)?,
        };
        if block.cycle.number != self.cycle.number {
            let other = CliError::OtherCycle { given: block.cycle.code, wanted: self.cycle.code };
            return Err(Located::in_line(block.line, other)).about(&name);
        }
        if let Some(unused) = &block.unused {
            io.warn_about(&name, unused);
        }
        for lost in &alone(&text, &block) {
            io.warn_about(&name, lost);
        }
        block.put_into(inputs).about(&name)
    }

    fn with_json(&self, mut inputs: Inputs, path: &Path, io: &mut Io<'_>) -> Result<Inputs, CliError> {
        use serde_json::Value as Json;
        let (name, bytes) = read_input(path, io)?;
        if LARGEST_INPUTS < bytes.len() {
            return Err(CliError::InputsTooLarge { most: LARGEST_INPUTS >> 10 }).about(&name);
        }
        let read = serde_json::from_slice(&bytes);
        let json::Pairs(object) =
            read.map_err(|error| CliError::NotAnObject { error: error.to_string() }).about(&name)?;
        let mut given: BTreeSet<Key> = BTreeSet::new();
        for (key, value) in &object {
            let text = match value {
                Json::Number(number) => number.to_string(),
                Json::String(text) => text.clone(),
                other => {
                    let wrong = CliError::NotAnInput { name: key.clone(), value: other.to_string() };
                    return Err(wrong).about(&name);
                }
            };
            inputs = self.cycle.set(inputs, key, &text).about(&name)?;
            if self.cycle.parameter_named(key).is_some_and(|parameter| !given.insert(parameter.key)) {
                return Err(CliError::GivenTwice { name: key.clone() }).about(&name);
            }
        }
        Ok(inputs)
    }

    fn touch_probe(&self, io: &mut Io<'_>) -> Result<TouchProbe, CliError> {
        let table = probe_table(self.probe_table.as_deref(), io)?;
        let missing = || CliError::NoProbe { number: self.probe.unwrap_or(1) };
        table.probe(self.probe).copied().ok_or_else(missing)
    }

    const fn what(&self) -> ErrorSubject<'static> {
        ErrorSubject::Cycle { code: self.cycle.code }
    }
}

/// A user's touch-probe table, or the built-in one.
pub(super) fn probe_table(path: Option<&Path>, io: &mut Io<'_>) -> Result<ProbeTable, CliError> {
    let Some(path) = path else { return Ok(ProbeTable::shipped().clone()) };
    let (name, bytes) = read_input(path, io)?;
    let table = ProbeTable::read(&bytes, &name).said()?;
    for warning in &table.warnings {
        io.warn(warning);
    }
    Ok(table)
}

pub(super) fn pairs(texts: &[String]) -> Result<Vec<(&str, &str)>, CliError> {
    let no_pair = |text: &str| CliError::NotAPair { text: text.to_owned() };
    texts.iter().map(|text| text.split_once('=').ok_or_else(|| no_pair(text))).collect()
}

/// `X,Y,Z` in millimetres.
fn position(text: &str) -> Result<[f64; 3], CliError> {
    let wrong = || CliError::NotAPosition { text: text.to_owned() };
    let parts: Vec<f64> = text
        .split(',')
        .map(|part| part.trim().parse().map(Length::to_mm_f64))
        .collect::<Result<_, _>>()
        .map_err(|_number| wrong())?;
    parts.try_into().map_err(|_count| wrong())
}
