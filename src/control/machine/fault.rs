//! What ends a run before its end: as the control says it, with block and reason.

use std::fmt;

use super::budget::Budget;
use super::path::{NcPath, PathError};
use super::store::StoreError;
use crate::control::mask::{MaskError, RenderError};
use crate::control::program::{LabelFault, ProgramError};
use crate::control::table::{TableError, WriteError};
use crate::control::variables::Parameter;
use crate::probing::cycle::CycleError;
use crate::probing::simulated::WorkpieceError;
use crate::words::{Message, Say};

/// A block of a program.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BlockPlace {
    /// The program.
    pub program: NcPath,
    /// The block, counted from 0.
    pub block: usize,
}

/// Why a run stopped, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// The block.
    pub place: BlockPlace,
    /// Its number in the program, where it has one.
    pub number: Option<u32>,
    /// Its first line in the program's text, counted from 1.
    pub line: usize,
    /// What it says, shortened.
    pub text: String,
    /// Why.
    pub kind: Box<FaultKind>,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { place, number, line, text, kind } = self;
        match number {
            Some(number) => write!(f, "{}, block {number}, {text}: {kind}", place.program),
            None => write!(f, "{}, line {line}, {text}: {kind}", place.program),
        }
    }
}

impl std::error::Error for Fault {}

impl Say for Fault {
    fn message(&self) -> Message {
        let message = match self.number {
            Some(number) => Message::new("machine-fault-in-block").text("number", number),
            None => Message::new("machine-fault-in-line").text("line", self.line),
        };
        let message = message.text("program", &self.place.program).text("text", &self.text);
        message.message("fault", self.kind.message())
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
            Self::FileBytes(most) => of("machine-used-file-bytes", most),
        }
    }
}

/// Why a run stopped.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FaultKind {
    /// A budget is used up.
    #[error(transparent)]
    UsedUp(#[from] UsedUp),
    /// A text has more characters than a parameter holds.
    #[error("the text has {length} characters, a parameter holds at most {most}")]
    TextTooLong {
        /// How many it has.
        length: usize,
        /// How many it may have.
        most: usize,
    },
    /// The block is not known, or not understood.
    #[error("this block is not known here: nothing is run that is not understood")]
    UnknownBlock,
    /// A cycle that is not run.
    #[error("cycle {cycle} is not known here; known are {known}")]
    UnknownCycle {
        /// Its number.
        cycle: String,
        /// Those that are.
        known: String,
    },
    /// The program has no end, or not even a beginning.
    #[error("the program is broken: {what} is missing")]
    Broken {
        /// The block that is missing.
        what: &'static str,
    },
    /// A file is no program.
    #[error("{path}: {error}")]
    NoProgram {
        /// The file.
        path: NcPath,
        /// What is wrong.
        error: ProgramError,
    },
    /// A label that cannot be gone to.
    #[error(transparent)]
    Label(#[from] LabelFault),
    /// A parameter does not hold the number of a label.
    #[error("{parameter} = {value} is no label")]
    NoLabel {
        /// The parameter.
        parameter: Parameter,
        /// What it holds.
        value: String,
    },
    /// A parameter without a value.
    #[error("{0} is undefined")]
    Undefined(Parameter),
    /// A parameter that no control has.
    #[error("there is no parameter {0}")]
    NoParameter(Parameter),
    /// A text where a number is needed.
    #[error("{0} holds a text, a number is needed")]
    NotNumber(Parameter),
    /// A number where a text is needed.
    #[error("{0} holds a number, a text is needed")]
    NotText(Parameter),
    /// A divisor of zero.
    #[error("division by zero")]
    DivisionByZero,
    /// A root of a number below zero.
    #[error("the root of {0} does not exist")]
    NegativeRoot(f64),
    /// A function of a number that has none.
    #[error("{function} {value} does not exist")]
    NoResult {
        /// The function.
        function: &'static str,
        /// The number.
        value: f64,
    },
    /// A result that no parameter holds.
    #[error("{0} is beyond the range of values, 10^10 either way")]
    BeyondRange(f64),
    /// A number with decimals, or below zero, where things are counted.
    #[error("{what} = {value}: a whole number from 0 is needed")]
    NotWhole {
        /// What is counted.
        what: &'static str,
        /// What was given.
        value: f64,
    },
    /// A part of a text that begins behind its end.
    #[error("the text has {length} characters, nothing begins at {from}")]
    BehindText {
        /// Its characters.
        length: usize,
        /// Where the part begins.
        from: usize,
    },
    /// A text that is no number.
    #[error("{parameter} = \"{text}\" is no number")]
    NoNumberInText {
        /// The parameter.
        parameter: Parameter,
        /// What it holds.
        text: String,
    },
    /// A system text that is not known.
    #[error("ID{id} NR{number} is not known here; known are date and time, ID10321")]
    UnknownSystemText {
        /// The group.
        id: f64,
        /// The number in the group.
        number: f64,
    },
    /// A path that is not followed.
    #[error(transparent)]
    Path(#[from] PathError),
    /// A file that is not there, or cannot be used.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// FN 27 and FN 28 without FN 26.
    #[error("no table is open")]
    NoTable,
    /// The table is broken.
    #[error("{0}")]
    Table(Box<TableError>),
    /// A column that the table does not have; upper and lower case count.
    #[error("table {table} has no column {column}; its columns are {columns}")]
    NoColumn {
        /// The table.
        table: String,
        /// What was asked for.
        column: String,
        /// What there is.
        columns: String,
    },
    /// A row behind the table's end.
    #[error("table {table} has no row {row}: its rows are 0 to {last}")]
    NoRow {
        /// The table.
        table: String,
        /// What was asked for.
        row: usize,
        /// The last there is.
        last: usize,
    },
    /// A table without rows.
    #[error("table {0} has no rows")]
    NoRows(String),
    /// A cell without a value.
    #[error("table {table}, row {row}, column {column}: the cell is empty")]
    EmptyCell {
        /// The table.
        table: String,
        /// The row.
        row: usize,
        /// The column.
        column: String,
    },
    /// A cell that is no number, and a number is needed.
    #[error("table {table}, row {row}, column {column}: {cell} is no number")]
    NoNumberInCell {
        /// The table.
        table: String,
        /// The row.
        row: usize,
        /// The column.
        column: String,
        /// What stands there.
        cell: String,
    },
    /// A cell that is not kept apart from its neighbour.
    #[error("table {table}, row {row}, column {column}: the cell touches its neighbour, either may be cut wrongly")]
    Touches {
        /// The table.
        table: String,
        /// The row.
        row: usize,
        /// The column.
        column: String,
    },
    /// A table that FN 27 has changed cannot be written.
    #[error("table {table}: {error}")]
    TableWrite {
        /// The table.
        table: String,
        /// Why.
        error: WriteError,
    },
    /// The mask cannot be read.
    #[error("mask {mask}: {error}")]
    Mask {
        /// The mask.
        mask: NcPath,
        /// Why.
        error: Box<MaskError>,
    },
    /// The mask cannot be printed.
    #[error("mask {mask}: {error}")]
    Render {
        /// The mask.
        mask: NcPath,
        /// Why.
        error: Box<RenderError>,
    },
    /// FN 14.
    #[error("the program stopped itself with error {0}")]
    Programmed(u32),
    /// A parameter that the cycle does not have.
    #[error("cycle {cycle} has no parameter {parameter}")]
    NoCycleParameter {
        /// The cycle.
        cycle: &'static str,
        /// The parameter.
        parameter: Parameter,
    },
    /// A parameter that is there twice.
    #[error("cycle {cycle}: {parameter} is given twice")]
    CycleParameterTwice {
        /// The cycle.
        cycle: &'static str,
        /// The parameter.
        parameter: Parameter,
    },
    /// The cycle did not come to its end.
    #[error("cycle {cycle}: {error}")]
    Cycle {
        /// The cycle.
        cycle: &'static str,
        /// Why.
        error: Box<CycleError>,
    },
    /// The workpiece cannot be.
    #[error("workpiece: {0}")]
    Workpiece(Box<WorkpieceError>),
    /// A cycle in a program in inches.
    #[error("cycles are run in programs in MM only")]
    Inch,
}

impl Say for FaultKind {
    fn message(&self) -> Message {
        let of = |id, parameter: &Parameter| Message::new(id).text("parameter", parameter);
        match self {
            Self::UsedUp(used) => used.message(),
            Self::TextTooLong { length, most } => {
                Message::new("machine-text-too-long").text("length", length).text("most", most)
            }
            Self::UnknownBlock => Message::new("machine-unknown-block"),
            Self::UnknownCycle { cycle, known } => {
                Message::new("machine-unknown-cycle").text("cycle", cycle).text("known", known)
            }
            Self::Broken { what } => Message::new("machine-broken").text("what", what),
            Self::NoProgram { path, error } => {
                Message::new("machine-at-file").text("path", path).message("error", error.message())
            }
            Self::Label(fault) => fault.message(),
            Self::NoLabel { parameter, value } => of("machine-no-label", parameter).text("value", value),
            Self::Undefined(parameter) => of("machine-undefined", parameter),
            Self::NoParameter(parameter) => of("machine-no-parameter", parameter),
            Self::NotNumber(parameter) => of("machine-not-number", parameter),
            Self::NotText(parameter) => of("machine-not-text", parameter),
            Self::Path(error) => error.message(),
            Self::Store(error) => error.message(),
            Self::Programmed(number) => Message::new("machine-programmed").text("number", number),
            Self::NoCycleParameter { cycle, parameter } => {
                of("machine-no-cycle-parameter", parameter).text("cycle", cycle)
            }
            Self::CycleParameterTwice { cycle, parameter } => {
                of("machine-cycle-parameter-twice", parameter).text("cycle", cycle)
            }
            Self::Cycle { cycle, error } => {
                Message::new("machine-in-cycle").text("cycle", cycle).message("error", error.message())
            }
            Self::Workpiece(error) => Message::new("machine-workpiece").message("error", error.message()),
            Self::Inch => Message::new("machine-inch"),
            Self::Mask { mask, error } => {
                Message::new("machine-mask").text("mask", mask).message("error", error.message())
            }
            Self::Render { mask, error } => {
                Message::new("machine-mask").text("mask", mask).message("error", error.message())
            }
            _ => self.number_message().or_else(|| self.table_message()).unwrap_or(Message::new("machine-no-table")),
        }
    }
}

impl FaultKind {
    fn number_message(&self) -> Option<Message> {
        Some(match self {
            Self::DivisionByZero => Message::new("machine-division-by-zero"),
            Self::NegativeRoot(value) => Message::new("machine-negative-root").text("value", value),
            Self::NoResult { function, value } => {
                Message::new("machine-no-result").text("function", function).text("value", value)
            }
            Self::BeyondRange(value) => Message::new("machine-beyond-range").text("value", value),
            Self::NotWhole { what, value } => Message::new("machine-not-whole").text("what", what).text("value", value),
            Self::BehindText { length, from } => {
                Message::new("machine-behind-text").text("length", length).text("from", from)
            }
            Self::NoNumberInText { parameter, text } => {
                Message::new("machine-no-number-in-text").text("parameter", parameter).text("text", text)
            }
            Self::UnknownSystemText { id, number } => {
                Message::new("machine-unknown-system-text").text("id", id).text("number", number)
            }
            _ => return None,
        })
    }

    fn table_message(&self) -> Option<Message> {
        let cell = |id, table: &str, row: &usize, column: &str| {
            Message::new(id).text("table", table).text("row", row).text("column", column)
        };
        Some(match self {
            Self::NoTable => Message::new("machine-no-table"),
            Self::Table(error) => error.message(),
            Self::NoColumn { table, column, columns } => {
                Message::new("machine-no-column").text("table", table).text("column", column).text("columns", columns)
            }
            Self::NoRow { table, row, last } => {
                Message::new("machine-no-row").text("table", table).text("row", row).text("last", last)
            }
            Self::NoRows(table) => Message::new("machine-no-rows").text("table", table),
            Self::EmptyCell { table, row, column } => cell("machine-empty-cell", table, row, column),
            Self::NoNumberInCell { table, row, column, cell: text } => {
                cell("machine-no-number-in-cell", table, row, column).text("cell", text)
            }
            Self::Touches { table, row, column } => cell("machine-touches", table, row, column),
            Self::TableWrite { table, error } => {
                Message::new("machine-table-write").text("table", table).message("error", error.message())
            }
            _ => return None,
        })
    }
}

impl Budget {
    /// Fails where so many are already there.
    pub(super) fn one_more(have: usize, most: usize, used_up: fn(usize) -> UsedUp) -> Result<(), UsedUp> {
        if have < most { Ok(()) } else { Err(used_up(most)) }
    }
}
