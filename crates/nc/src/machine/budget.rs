//! How much a run may use, and its settings.

use fitcheck_core::message::Say;
use fitcheck_core::words::Dialogue;
use jiff::civil::DateTime;

use crate::control::probe_table::ProbeTable;
use crate::control::tool_table::ToolTable;

/// What a run may use; each limit has a fault of its own that ends the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Budget {
    pub blocks: u64,
    /// Nested calls of labels.
    pub label_calls: usize,
    /// Nested calls of programs.
    pub program_calls: usize,
    /// Characters of a text parameter: 254 on older controls, 255 on newer ones.
    pub text: usize,
    /// Windows that FN 16 opens.
    pub windows: usize,
    /// Outputs of FN 16 and of measuring logs to files. Each is written through to the disk, which takes milliseconds.
    pub outputs: usize,
    /// Files that these outputs go to.
    pub output_files: usize,
    /// Folders that files are written into, with the folders above them: missing ones are made.
    pub folders: usize,
    /// Times that a table which FN 27 has changed is written to its file.
    pub table_writes: usize,
    /// Bytes that FN 16 prints, to windows and files together.
    pub output_bytes: usize,
    /// Cycles that are run.
    pub cycles: usize,
    /// Moves of the path.
    pub path: usize,
    /// Different programs and changed tables that are kept.
    pub files: usize,
    /// The memory that they take together, bytes.
    pub file_bytes: usize,
    /// Bytes that are read from files and written to them, repeated ones included; 4 KiB for a smaller file.
    pub traffic: usize,
    /// Remarks; more are only counted.
    pub remarks: usize,
}

impl Default for Budget {
    /// Nesting and text as on newer controls, everything else far beyond any measuring program.
    fn default() -> Self {
        Self {
            blocks: 10_000_000,
            label_calls: 20,
            program_calls: 10,
            text: 255,
            windows: 1_000,
            outputs: 2_000,
            output_files: 1_000,
            folders: 100,
            table_writes: 500,
            output_bytes: 4 << 20,
            cycles: 10_000,
            path: 200_000,
            files: 100,
            file_bytes: 64 << 20,
            traffic: 256 << 20,
            remarks: 1_000,
        }
    }
}

/// The settings of a run.
#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of the control")]
pub struct Settings {
    /// The dialogue language, for masks.
    pub language: Dialogue,
    /// Local date and time, for masks and `SYSSTR`.
    pub time: DateTime,
    /// What the run may use.
    pub budget: Budget,
    /// Whether an unknown block is skipped with a remark instead of stopping the run.
    pub skip_unknown: bool,
    /// Whether a cycle without a TOOL CALL before it measures along Z with the first probe, with a remark, instead of stopping
    /// the run.
    pub assumes_tool: bool,
    /// Whether blocks with a `/` are skipped.
    pub block_skip: bool,
    /// Whether M1 stops.
    pub optional_stop: bool,
    /// The touch-probe table.
    pub probe_table: ProbeTable,
    /// The tool table, which cycles with Q330 change during the run. Without one no tool is monitored.
    pub tool_table: Option<ToolTable>,
}

impl Settings {
    /// The control's own: unknown blocks and cycles without a tool stop, blocks with a `/` run, M1 does not stop, the
    /// built-in touch-probe table, no tool table.
    pub fn new(language: Dialogue, time: DateTime) -> Self {
        Self {
            language,
            time,
            budget: Budget::default(),
            skip_unknown: false,
            assumes_tool: false,
            block_skip: false,
            optional_stop: false,
            probe_table: ProbeTable::shipped().clone(),
            tool_table: None,
        }
    }
}

/// A budget that is used up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "machine-used", error)]
pub enum UsedUp {
    Blocks(#[say(name = "most")] u64),
    LabelCalls(#[say(name = "most")] usize),
    ProgramCalls(#[say(name = "most")] usize),
    Windows(#[say(name = "most")] usize),
    /// Outputs to files.
    Outputs(#[say(name = "most")] usize),
    OutputFiles(#[say(name = "most")] usize),
    /// Folders that files are written into.
    Folders(#[say(name = "most")] usize),
    /// Changed tables that are written.
    TableWrites(#[say(name = "most")] usize),
    /// Bytes of output.
    Output(#[say(name = "most")] usize),
    Cycles(#[say(name = "most")] usize),
    /// Moves.
    Path(#[say(name = "most")] usize),
    /// Programs and tables.
    Files(#[say(name = "most")] usize),
    /// Bytes read and written.
    Traffic(#[say(name = "most")] usize),
    /// Their size.
    FileBytes(#[say(name = "most")] usize),
}

impl Budget {
    /// An error if this many are already there.
    pub(super) fn one_more(have: usize, most: usize, used_up: fn(usize) -> UsedUp) -> Result<(), UsedUp> {
        if have < most { Ok(()) } else { Err(used_up(most)) }
    }
}
