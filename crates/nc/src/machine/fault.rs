//! What stops a run early: the block and the reason, as a control shows them.

use fitcheck_core::message::{Message, Say, display, message};
use fitcheck_core::probing::cycle::CycleError;
use fitcheck_core::probing::simulated::WorkpieceError;
use fitcheck_core::text::cut;

use super::budget::UsedUp;
use super::change::{Change, may_set_datum};
use super::path::{NcPath, PathError};
use super::store::StoreError;
use crate::control::mask::{MaskError, RenderError};
use crate::control::table::{TableError, WriteError};
use crate::control::tool_table::ToolFault;
use crate::control::variables::Parameter;
use crate::program::{CycleName, LabelFault, Mode, Program, ProgramError};

/// A block of a program.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BlockPlace {
    pub program: NcPath,
    /// The block, counted from 0.
    pub block: usize,
}

/// Why a run stopped, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    pub place: BlockPlace,
    /// Its number in the program, if it has one.
    pub number: Option<u32>,
    /// Its first line in the program's text, counted from 1.
    pub line: usize,
    /// Its text, shortened.
    pub text: String,
    /// Why.
    pub kind: Box<FaultKind>,
}

impl Fault {
    /// A fault of a block; after the last block, the fault names the last one.
    pub(super) fn new(program: &Program, mut place: BlockPlace, kind: FaultKind) -> Self {
        place.block = place.block.min(program.blocks().len().saturating_sub(1));
        let block = program.blocks().get(place.block);
        let text = program.first_line_of(place.block);
        let number = block.and_then(|block| block.number);
        let front = text.trim();
        // Lathe controls write `N5` for block 5.
        let front = front.strip_prefix(['N', 'n']).unwrap_or(front).trim_start();
        let bare = front.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
        let bare = if number.is_some() { bare } else { text.trim() };
        let text = cut(bare, 80).replace(char::is_control, " ");
        let line = block.map_or_else(|| program.line_count(), |block| block.lines.start + 1);
        Self { place, number, line, text, kind: Box::new(kind) }
    }
}

impl Say for Fault {
    fn message(&self) -> Message {
        let message = match self.number {
            Some(number) => message!("machine-fault-in-block").with("number", &number),
            None => message!("machine-fault-in-line").with("line", &self.line),
        };
        message.with("program", &self.place.program).with("text", &self.text).with("fault", &self.kind)
    }
}

display!(Fault);

impl std::error::Error for Fault {}

/// What a block counts with a whole number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "machine-counted")]
pub enum Counted {
    /// The row of a table.
    Row,
    /// What a word of the block says: `BEG`, `LEN`.
    Word(#[say(name = "word")] &'static str),
}

/// Why a run stopped.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "machine", error)]
pub enum FaultKind {
    /// A budget is used up.
    #[say(transparent)]
    UsedUp(#[from] UsedUp),
    /// A text has more characters than a parameter holds.
    TextTooLong {
        /// How many it has.
        length: usize,
        /// How many it may have.
        most: usize,
    },
    /// The block is unknown, or cannot be understood.
    UnknownBlock,
    /// A cycle that Fitcheck does not run.
    UnknownCycle {
        cycle: String,
        /// The cycles that it runs.
        known: String,
    },
    /// A program copies, moves or deletes the table that FN 26 has opened: what FN 27 has changed is not in its file yet.
    FileOpen {
        /// The file.
        path: NcPath,
    },
    /// The program has no end, or not even a beginning.
    Broken {
        /// The block that is missing.
        what: &'static str,
    },
    /// A file is not a program.
    NoProgram {
        /// The file.
        path: NcPath,
        /// What is wrong.
        error: ProgramError,
    },
    /// A label that no jump can reach.
    #[say(transparent)]
    Label(#[from] LabelFault),
    /// A parameter does not hold the number of a label.
    NoLabel {
        parameter: Parameter,
        /// What it holds.
        value: f64,
    },
    /// A parameter that holds a measure of the tool in the spindle, which only a tool table knows.
    NoToolData(#[say(name = "parameter")] Parameter),
    /// A parameter without a value.
    Undefined(#[say(name = "parameter")] Parameter),
    /// A parameter that a block may have set which was not run.
    Lost {
        parameter: Parameter,
        /// The line of the block, from 1.
        line: usize,
        text: String,
    },
    /// A file that a block may have written or removed which was not run.
    FileUnknown {
        /// The file.
        path: NcPath,
        /// The line of the block, from 1.
        line: usize,
        text: String,
    },
    /// A tool whose values a block may have changed which was not run.
    ToolsUnknown {
        /// The line of the block, from 1.
        line: usize,
        text: String,
    },
    /// Recorded contacts behind a measurement that was not run: some of them may be of it.
    ContactsUnknown {
        /// The line of its block, from 1.
        line: usize,
        text: String,
    },
    /// An unknown block that decides what runs next, or hands values to another program.
    NotSkipped,
    /// A parameter that does not exist on a control.
    NoParameter(#[say(name = "parameter")] Parameter),
    /// A variable that does not exist on a lathe control.
    NoVariable {
        variable: Parameter,
        family: &'static str,
        /// The first number of the family.
        least: u16,
        /// The last.
        most: u16,
    },
    /// A number with decimals for a variable that holds whole numbers.
    WholeOnly {
        /// The variable.
        parameter: Parameter,
        /// What it would get.
        value: f64,
    },
    /// A program that asks for a value which was not given before the run.
    NoAnswer {
        /// Where it goes.
        parameter: Parameter,
        question: String,
    },
    /// A text where a number is needed.
    NotNumber(#[say(name = "parameter")] Parameter),
    /// A number where a text is needed.
    NotText(#[say(name = "parameter")] Parameter),
    /// A divisor of zero.
    DivisionByZero,
    /// A root of a number below zero.
    NegativeRoot(f64),
    /// A function without a result for its number.
    NoResult { function: &'static str, value: f64 },
    /// A result that no parameter can hold.
    BeyondRange(f64),
    /// A number with decimals, or below zero, where a count is needed.
    NotWhole {
        what: Counted,
        /// What was given.
        value: f64,
    },
    /// A part of a text that begins after its end.
    BehindText {
        /// The number of its characters.
        length: usize,
        /// Where the part begins.
        from: usize,
    },
    /// A text that is not a number.
    NoNumberInText {
        parameter: Parameter,
        /// What it holds.
        text: String,
    },
    UnknownSystemText {
        /// The group.
        id: f64,
        /// The number in the group.
        number: f64,
    },
    /// A path that Fitcheck does not follow.
    #[say(transparent)]
    Path(#[from] PathError),
    /// A file that does not exist, or cannot be used.
    #[say(transparent)]
    Store(#[from] StoreError),
    /// FN 27 or FN 28 without FN 26.
    NoTable,
    /// A text parameter with the names of several columns, where a class is one.
    SeveralColumns { parameter: Parameter, text: String },
    /// The table is broken.
    #[say(transparent)]
    Table(Box<TableError>),
    /// A column that the table does not have; names are case-sensitive.
    NoColumn {
        table: String,
        /// The column requested.
        column: String,
        columns: String,
    },
    /// A row after the table's end.
    NoRow {
        table: String,
        /// The row requested.
        row: usize,
        /// The last row.
        last: usize,
    },
    /// A table without rows.
    NoRows(#[say(name = "table")] String),
    /// A cell without a value.
    EmptyCell { table: String, row: usize, column: String },
    /// A cell that is not a number, where a number is needed.
    NoNumberInCell {
        table: String,
        row: usize,
        column: String,
        /// The text found.
        cell: String,
    },
    /// A cell without a blank between it and its neighbour.
    Touches { table: String, row: usize, column: String },
    /// A table that FN 27 has changed, but that cannot be written.
    TableWrite {
        table: String,
        /// Why.
        error: WriteError,
    },
    /// The mask cannot be read.
    Mask {
        mask: NcPath,
        /// Why.
        error: Box<MaskError>,
    },
    /// The mask cannot be printed.
    #[say(id = "machine-mask")]
    Render {
        mask: NcPath,
        /// Why.
        error: Box<RenderError>,
    },
    /// FN 14.
    Programmed(#[say(name = "number")] u32),
    /// A parameter that the cycle does not have.
    NoCycleParameter { cycle: &'static str, parameter: CycleName },
    /// A parameter that is given twice.
    CycleParameterTwice { cycle: &'static str, parameter: CycleName },
    /// A parameter that is given twice, while the one behind it in the cycle is not given.
    CycleParameterFor {
        cycle: &'static str,
        parameter: CycleName,
        /// The one that is missing.
        other: String,
    },
    /// The program ends within a subprogram: its `LBL 0` is missing.
    OpenSubprogram {
        /// The line of the call, from 1.
        line: usize,
    },
    /// A repeat of a part whose label stands behind it.
    RepeatAhead {
        /// The line of the label, from 1.
        line: usize,
    },
    /// A parameter of GLOBAL DEF 120 that is given no number: an earlier value would stay in force.
    GlobalNotNumber {
        /// The number of the GLOBAL DEF.
        number: String,
        parameter: CycleName,
    },
    /// A parameter that stands twice in one GLOBAL DEF.
    GlobalTwice {
        /// The number of the GLOBAL DEF.
        number: String,
        parameter: CycleName,
    },
    /// The cycle did not finish.
    Cycle {
        cycle: &'static str,
        /// Why.
        error: Box<CycleError>,
    },
    /// A tool that cannot be monitored, or is broken.
    #[say(transparent)]
    Tool(#[from] ToolFault),
    /// The workpiece is impossible.
    Workpiece(#[say(name = "error")] Box<WorkpieceError>),
    /// A measuring cycle before any TOOL CALL that names an axis.
    NoToolCall,
    /// A measuring cycle in another mode than milling.
    Mode(#[say(name = "mode")] Mode),
    /// A measuring cycle under a change of the system that is not followed here.
    Changed {
        change: Change,
        /// The line that made it, from 1.
        line: usize,
        text: String,
    },
    /// A datum for a row of the active datum table, which only the control has.
    NoDatumTable { row: u32 },
    /// A cycle sets a datum in a tilted plane.
    DatumInTilt {
        /// The line of the block that tilts it, in its program, from 1.
        line: usize,
        text: String,
    },
    /// Cycle 0 or 1, where every cycle meets what it expects.
    PointWithoutPart,
    /// Cycle 0 or 1, from a place that is not known in all axes.
    PointFromNowhere,
    /// A row that the preset table lacks.
    NoPreset { table: String, row: u32 },
    /// A row of the preset table that is locked.
    PresetLocked { table: String, row: u32 },
    /// A datum for the row of the active preset under a datum shift: what becomes of the shift is not known.
    ShiftedPreset { row: u32 },
    /// `CALL SELECTED PGM` without `SEL PGM`.
    NothingSelected,
}

impl FaultKind {
    /// Whether it comes of a block that may set a datum and is not run here: to skip it leads no further, for nothing is measured after it.
    pub fn is_of_datum(&self) -> bool {
        match self {
            Self::UnknownCycle { cycle, .. } => may_set_datum(cycle),
            Self::Changed { change, .. } => *change == Change::NotKnown,
            Self::NoDatumTable { .. } | Self::DatumInTilt { .. } | Self::ShiftedPreset { .. } => true,
            _ => false,
        }
    }
}
