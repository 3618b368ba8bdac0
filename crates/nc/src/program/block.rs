//! What the blocks of a program say.

use std::fmt;
use std::ops::Range;

use fitcheck_core::message::as_text;

use super::around::{Frame, Goes, Mode, PassedOver};
use super::cycle_block::{CycleBlock, CycleName};
use super::expression::{Expression, Relation, Test, TextExpression};
use super::movement::{Axis, MachineFunction, Movement};
use super::operand::{Operand, TextOperand};
use crate::control::variables::Parameter;

/// One block: a line of the program, or several where a line ends in `~`.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// Its lines in the program's text, counted from 0.
    pub lines: Range<usize>,
    /// The block number in the program, if there is one.
    pub number: Option<u32>,
    /// Whether a `/` precedes it: with block skip it is skipped.
    pub may_be_skipped: bool,
    /// What it says.
    pub body: Body,
}

/// The unit of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Unit {
    /// Millimetres.
    Mm,
    Inch,
}

/// As it is written after the name of the program.
impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Mm => "MM",
            Self::Inch => "INCH",
        })
    }
}

/// What FN 18 asks the control for: `ID50 NR2 IDX5`.
#[derive(Debug, Clone, PartialEq)]
pub struct SystemDatum {
    /// ID: the group.
    pub group: u32,
    /// NR: which value of it.
    pub number: Option<Operand>,
    /// IDX: of which axis or tool.
    pub index: Option<Operand>,
}

/// What a block does with files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FileFunction {
    /// `FUNCTION FILECOPY "a" TO "b"`
    Copy { from: TextOperand, to: TextOperand },
    /// `FUNCTION FILEMOVE "a" TO "b"`
    Move { from: TextOperand, to: TextOperand },
    /// `FUNCTION FILEDELETE "a"`
    Delete(TextOperand),
}

/// What a block says.
#[derive(Debug, Clone, PartialEq)]
pub enum Body {
    /// `BEGIN PGM name MM`, `%NAME.nc` with the unit of the head
    Begin {
        /// The program's name.
        name: String,
        unit: Unit,
    },
    /// `END PGM name MM`
    End {
        /// The program's name.
        name: String,
        unit: Unit,
    },
    /// Only a comment, or only a number.
    Nothing,
    /// `* - text`: structure.
    Heading {
        /// How deep, from 1; deeper with more blanks.
        depth: usize,
        /// The text without the signs before it.
        text: String,
    },
    /// `LBL 11`, `LBL "LOOP"`; `LBL 0` ends a subprogram. Never a parameter.
    Label(Target),
    /// `CALL LBL 7`, `CALL LBL 5 REP 3`
    CallLabel {
        label: Target,
        /// How often the part from the label to this block is repeated.
        repeat: Option<Operand>,
    },
    /// `CALL PGM TNC:\Plan.h`
    CallProgram(TextOperand),
    /// `SEL PGM "TNC:\Plan.h"`
    SelectProgram(TextOperand),
    /// `CALL SELECTED PGM`
    CallSelectedProgram,
    /// `Q5 = ...`, `FN 0: Q5 = ...` to `FN 8` and `FN 13`
    Assign {
        /// Q, QL or QR.
        to: Parameter,
        value: Expression,
    },
    /// `FN 0: Q5 SET UNDEFINED`
    Undefine(Parameter),
    /// `DECLARE STRING QS1 = "H7"`, `QS1 = ...`
    AssignText {
        /// A QS parameter.
        to: Parameter,
        value: TextExpression,
    },
    /// FN 9 to FN 12
    Jump {
        condition: Condition,
        /// The destination.
        label: Target,
    },
    /// `IF`, `WHILE`, `ELSE`, `ENDWHILE`, `CASE`, `BREAK` of lathe controls: goes to another block unless the condition holds.
    Branch {
        /// The condition; without one it always goes there.
        unless: Option<Box<Test>>,
        /// That block, counted from 0.
        to: usize,
    },
    /// `SUBPROGRAM "NAME"` of lathe controls: a label for the block behind it. Whoever comes from above goes past its end.
    Subprogram {
        label: Target,
        /// The block behind its end, counted from 0.
        behind: usize,
    },
    /// `PRINT("text",#l1)` of lathe controls: a text on the screen.
    Show(TextExpression),
    /// `INPUT("text",#l1)` of lathe controls: asks for a value.
    Input {
        question: String,
        /// The variable that it goes to.
        to: Parameter,
    },
    /// `G909` of lathe controls: blocks are read ahead only up to here.
    ReadNoFurther,
    /// `FN 14: ERROR= 1005`
    Error(Operand),
    /// `FN 16: F-PRINT mask / output`
    Print {
        /// The mask's path.
        mask: TextOperand,
        /// `SCREEN:`, `SCLR:`, or the output's path.
        output: TextOperand,
    },
    /// `FUNCTION FILECOPY`, `FILEMOVE`, `FILEDELETE`
    File(FileFunction),
    /// `FN 26: TABOPEN path`
    TableOpen(TextOperand),
    /// `FN 28: TABREAD Q10 = 6/"X,Y,D"`
    TableRead {
        /// The first parameter that is filled; several columns fill the following ones.
        to: Parameter,
        /// The row, from 0.
        row: Operand,
        columns: Columns,
    },
    /// `FN 27: TABWRITE 40/"NAME" = QS10`
    TableWrite {
        /// The row, from 0.
        row: Operand,
        columns: Columns,
        /// The first parameter that is written.
        from: Parameter,
    },
    /// `TOOL CALL 5 Z S2000`
    ToolCall {
        /// Number, name or QS parameter; `None` changes only speed or feed.
        tool: Option<Tool>,
        /// The tool axis.
        axis: Option<Axis>,
        /// The rest (S, F, DL …), as written.
        rest: String,
    },
    /// `L  X+10  Y+Q21 R0 FMAX M3`
    Move(Movement),
    /// `M30`, and other M functions alone.
    MachineFunctions(Vec<MachineFunction>),
    /// `STOP`, `STOP M6`
    Stop(Vec<MachineFunction>),
    /// `TCH PROBE 427 NAME ~` and its lines, `G785 R0 K2`; runs where it is in the program.
    Probe(CycleBlock),
    /// `CYCL DEF 200 NAME ~` and its lines: a machining cycle. Only its parameters are kept.
    CycleDefinition(CycleBlock),
    /// `GLOBAL DEF 120 NAME ~` and its lines: the values that `PREDEF` stands for.
    GlobalDefinition(CycleBlock),
    /// `FUNCTION MODE TURN`
    Mode(Mode),
    /// A change of the system that coordinates count in.
    Frame(Frame),
    /// `FN 18: SYSREAD Q1 = ID20 NR1`: what the control's system holds.
    SystemRead {
        /// The parameter that it goes to.
        to: Parameter,
        /// What is asked for; `None` where it is written in another form.
        datum: Option<SystemDatum>,
    },
    /// A block that changes nothing that a measurement depends on.
    PassedOver(PassedOver),
    /// Anything else, kept as text.
    Other,
}

/// A label.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Target {
    /// By number; 0 ends a subprogram.
    Number(u32),
    Name(String),
    /// The name is in a QS parameter, or the number in a Q parameter.
    Parameter(Parameter),
}

/// As it is written after `LBL`: `5`, `"LOOP"`, `QS5`.
impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Name(name) => f.write_str(&super::write_formula::quoted(name)),
            Self::Parameter(parameter) => write!(f, "{parameter}"),
        }
    }
}

as_text!(Unit, Target, CycleName);

/// The condition of a jump.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Condition {
    /// FN 9 to FN 12 with two values.
    Compare(Operand, Relation, Operand),
    IsDefined(Parameter),
    IsUndefined(Parameter),
}

/// Columns of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Columns {
    /// `"X,Y,D"`: one or more names.
    Names(Vec<String>),
    /// The name is in a QS parameter.
    Parameter(Parameter),
}

#[derive(Debug, Clone, PartialEq)]
pub enum Tool {
    /// By number, or by the number in a Q parameter.
    Number(Operand),
    /// By name, or by the name in a QS parameter.
    Name(TextOperand),
}

/// A block that is passed over, moves nothing and has no M functions.
pub(super) fn still(words: impl Into<String>) -> Body {
    Body::PassedOver(PassedOver { words: words.into(), goes: Goes::default(), machine: Vec::new() })
}
