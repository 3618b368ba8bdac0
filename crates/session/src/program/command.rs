//! What can be done on the program page, and the names of its choices.

use std::path::PathBuf;

use fitcheck_core::message::Message;
use fitcheck_core::words::Dialogue;
use fitcheck_nc::control::variables::Parameter;
use fitcheck_nc::machine::{BlockPlace, NcPath};
use fitcheck_nc::program::ProgramWarning;
use fitcheck_nc::sets::Control;

use super::run::Speed;
use super::{Document, ProgramField, SetFrom};
use crate::Step;

/// What can be done on the program page.
#[derive(Debug, Clone)]
pub enum ProgramCommand {
    /// Opens a built-in program by its file name.
    OpenShipped(&'static str),
    /// A program's file was read, or not.
    Read {
        path: PathBuf,
        /// The program and its warnings.
        result: Result<(Box<Document>, Vec<ProgramWarning>), Message>,
    },
    /// Replaces the text of a field.
    Type(ProgramField, String),
    /// Chooses what is measured. A part or contacts are asked for where there are none.
    ChooseWorkpiece(WorkpieceFrom),
    /// Runs until a stop, a breakpoint, an error or the end; continues where it paused.
    Run,
    /// Runs one block.
    Step,
    /// Runs one block, including everything that it calls.
    StepOver,
    /// Runs up to the selected block.
    RunToSelected,
    /// Runs the next slice; the window asks for it while a run goes on.
    Tick,
    Pause,
    /// Goes back to before the first block.
    Reset,
    /// Chooses how fast a run goes.
    SetSpeed(Speed),
    /// Switches something about the run on or off; takes effect at its next start.
    Toggle(Switch),
    /// Sets or removes a breakpoint at a block of the shown program; at the selected block where none is named.
    ToggleBreakpoint(Option<usize>),
    /// Selects a block of the shown program.
    Select(usize),
    /// Selects a block near the selected one.
    Move(Step),
    /// Shows a program of the call stack by its path.
    ShowProgram(NcPath),
    /// Shows a block of any program of the run and selects it.
    GoTo(BlockPlace),
    /// Keeps a parameter at the top of the list, or not.
    Pin(Parameter, bool),
    /// Gives the parameter in its field the value in its field at the next start.
    SetValue,
    /// Removes such a value.
    DropValue(Parameter),
    /// Opens the page at the files for a control.
    ShowCreating,
    /// Makes them for a control.
    CreateFor(Control),
    /// Makes them in a language of its dialogue.
    CreateIn(Dialogue),
    /// Makes them of the callout, or of the plan.
    CreateFrom(SetFrom),
    /// Makes them for a series of parts, or for a part alone.
    CreateSeries(bool),
    /// Has diameters measured by the cycle that takes their tolerances as texts, or not.
    CreateByText(bool),
    /// Shows what is in one of them, by its name, or in none.
    CreateShow(Option<String>),
}

/// What can be switched on or off for a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Switch {
    /// Unknown blocks are skipped with a remark instead of ending the run.
    SkipUnknown,
    /// A cycle without a TOOL CALL before it measures along Z instead of ending the run.
    AssumeTool,
    /// Blocks with a `/` are skipped.
    BlockSkip,
    /// M1 stops.
    OptionalStop,
}

impl Switch {
    /// All of them, in the order of the menu.
    pub const ALL: [Self; 4] = [Self::SkipUnknown, Self::AssumeTool, Self::BlockSkip, Self::OptionalStop];
}

/// What is measured.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum WorkpieceFrom {
    /// A perfect one in the middle of the limits, where they are known; else at nominal.
    #[default]
    Perfect,
    /// A perfect one with the diameter and the centre of the fields.
    Given,
    /// The simulated workpiece, the same as on the cycles page.
    Simulated,
    /// Contacts that were recorded and opened on this page.
    Recorded,
    /// A simulated part of several features.
    Part,
}

impl WorkpieceFrom {
    /// Every source.
    pub const ALL: [Self; 5] = [Self::Perfect, Self::Given, Self::Simulated, Self::Part, Self::Recorded];
}

/// Where the open program came from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Origin {
    /// It is built in; its file name.
    Shipped(&'static str),
    File(PathBuf),
}
