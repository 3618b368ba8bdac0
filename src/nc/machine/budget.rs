//! How much a program may do, and how a run is set up.

use jiff::civil::DateTime;

use crate::control::probe_table::ProbeTable;
use crate::message::{Message, Say};
use crate::words::Dialogue;

/// What a run may use; each of them ends it with a fault of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Budget {
    /// Blocks.
    pub blocks: u64,
    /// Calls of labels within one another.
    pub label_calls: usize,
    /// Calls of programs within one another.
    pub program_calls: usize,
    /// Characters of a text parameter: 254 on older controls, 255 on newer ones.
    pub text: usize,
    /// Windows that FN 16 opens.
    pub windows: usize,
    /// Outputs of FN 16 to files.
    pub outputs: usize,
    /// Bytes that FN 16 prints, to windows and files together.
    pub output_bytes: usize,
    /// Cycles that are run.
    pub cycles: usize,
    /// Moves of the path.
    pub path: usize,
    /// Different programs and changed tables that are kept.
    pub files: usize,
    /// Their size together, bytes.
    pub file_bytes: usize,
    /// Bytes that are read from files and written to them, over and over again included.
    pub traffic: usize,
    /// Remarks; more are only counted.
    pub remarks: usize,
}

impl Default for Budget {
    /// Nesting and text as on newer controls, the rest far beyond any measuring program.
    fn default() -> Self {
        Self {
            blocks: 10_000_000,
            label_calls: 20,
            program_calls: 10,
            text: 255,
            windows: 1_000,
            outputs: 10_000,
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

/// How a run is set up.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// The dialogue language, for masks.
    pub language: Dialogue,
    /// Local date and time, for masks and `SYSSTR`.
    pub time: DateTime,
    /// What the run may use.
    pub budget: Budget,
    /// Whether a block that is not known is passed over with a remark instead of stopping the run.
    pub skip_unknown: bool,
    /// Whether blocks with a `/` are passed over.
    pub block_skip: bool,
    /// Whether M1 stops.
    pub optional_stop: bool,
    /// The touch-probe table.
    pub probe_table: ProbeTable,
}

impl Settings {
    /// The control's own: unknown blocks stop, blocks with a `/` run, M1 does not stop, the shipped touch-probe table.
    pub fn new(language: Dialogue, time: DateTime) -> Self {
        Self {
            language,
            time,
            budget: Budget::default(),
            skip_unknown: false,
            block_skip: false,
            optional_stop: false,
            probe_table: ProbeTable::shipped().clone(),
        }
    }
}

/// A budget that is used up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum UsedUp {
    /// Blocks.
    #[error("the run has used up its {0} blocks: does it loop for ever?")]
    Blocks(u64),
    /// Calls of labels.
    #[error("{0} calls of labels are within one another, one more is not allowed: does the program call itself?")]
    LabelCalls(usize),
    /// Calls of programs.
    #[error("{0} calls of programs are within one another, one more is not allowed: does the program call itself?")]
    ProgramCalls(usize),
    /// Windows.
    #[error("the run has opened {0} windows, one more is not allowed")]
    Windows(usize),
    /// Outputs to files.
    #[error("the run has printed to files {0} times, one more is not allowed")]
    Outputs(usize),
    /// Bytes of output.
    #[error("the run has printed {0} bytes, more is not allowed")]
    Output(usize),
    /// Cycles.
    #[error("the run has measured {0} times, one more is not allowed")]
    Cycles(usize),
    /// Moves.
    #[error("the path has {0} moves, one more is not allowed")]
    Path(usize),
    /// Programs and tables.
    #[error("{0} programs and changed tables are open, one more is not allowed")]
    Files(usize),
    /// Bytes read and written.
    #[error("the run has read and written {0} bytes, more is not allowed")]
    Traffic(usize),
    /// Their size.
    #[error("programs and changed tables have more than {0} bytes together")]
    FileBytes(usize),
}

impl Say for UsedUp {
    fn message(&self) -> Message {
        let of = |id, most: &usize| Message::new(id).text("most", most);
        match self {
            Self::Blocks(most) => Message::new("machine-used-blocks").text("most", most),
            Self::LabelCalls(most) => of("machine-used-label-calls", most),
            Self::ProgramCalls(most) => of("machine-used-program-calls", most),
            Self::Windows(most) => of("machine-used-windows", most),
            Self::Outputs(most) => of("machine-used-outputs", most),
            Self::Output(most) => of("machine-used-output", most),
            Self::Cycles(most) => of("machine-used-cycles", most),
            Self::Path(most) => of("machine-used-path", most),
            Self::Files(most) => of("machine-used-files", most),
            Self::Traffic(most) => of("machine-used-traffic", most),
            Self::FileBytes(most) => of("machine-used-file-bytes", most),
        }
    }
}

impl Budget {
    /// Fails where so many are already there.
    pub(super) fn one_more(have: usize, most: usize, used_up: fn(usize) -> UsedUp) -> Result<(), UsedUp> {
        if have < most { Ok(()) } else { Err(used_up(most)) }
    }
}
