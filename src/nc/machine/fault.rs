//! What ends a run before its end: as the control says it, with block and reason.

mod say;

use std::fmt;

use super::budget::UsedUp;
use super::path::{NcPath, PathError};
use super::store::StoreError;
use crate::control::mask::{MaskError, RenderError};
use crate::control::table::{TableError, WriteError};
use crate::control::variables::Parameter;
use crate::message::{Message, Say};
use crate::nc::program::{LabelFault, ProgramError};
use crate::probing::cycle::CycleError;
use crate::probing::simulated::WorkpieceError;

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
    #[error("there is no parameter {0}: Q and QS go up to 1999, QL and QR up to 499")]
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
