//! What can be done on the parts page.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::part::{Column, Document};
use fitcheck_exchange::exchange::Item;

use super::watch_news::WatchNews;
use super::{AlarmsFound, PartPicture, PartsField, PartsView, PlanField};
use crate::Step;
use crate::records::RecordRow;

/// What can be done on the parts page.
#[derive(Debug, Clone)]
pub enum PartsCommand {
    /// Replaces the text of a field.
    Type(PartsField, String),
    /// Opens a view.
    Show(PartsView),
    /// Does something to the plan.
    Plan(PlanCommand),
    /// Does something on the walk through a part.
    Walk(WalkCommand),
}

/// What can be done to the plan.
#[derive(Debug, Clone)]
pub enum PlanCommand {
    /// Begins a new plan.
    New,
    /// A file of a plan was read, or not.
    Read {
        path: PathBuf,
        /// What it holds.
        result: Result<Box<Document>, Message>,
    },
    /// Replaces the text of a field of the plan.
    Type(PlanField, String),
    /// What was typed into a field of the part is complete.
    SettleHead,
    /// Goes to a cell, by its row; what is selected reaches to it, or is the cell alone.
    Go(usize, Column, bool),
    /// Moves by a step; what is selected grows with it, or is the cell alone.
    Move(Step, bool),
    /// Goes to the next cell, row by row, or to the one before.
    Tab(bool),
    /// Begins to type into the cell: what is in it goes on, or is replaced by this.
    Edit(Option<String>),
    /// Ends typing, and moves by a step.
    Take(Option<Step>),
    /// Ends typing; the cell is as it was.
    Leave,
    /// Empties the selected cells.
    Empty,
    /// Puts the selected cells on the clipboard.
    Copy,
    /// Asks for what is on the clipboard.
    AskForPaste,
    /// Puts cells of a spreadsheet at the cell.
    Paste(String),
    /// Puts a row above the cell.
    Insert,
    /// Deletes the selected rows.
    Delete,
    /// Moves the selected rows up or down.
    MoveRows(Step),
    /// Sorts the features by the column of the cell; once more, the other way round.
    Sort,
    /// Numbers the features from 1.
    Renumber,
    /// Shows every column, or those that are used.
    ShowAll(bool),
    /// Goes to what is wrong, by its place in the list.
    GoToFinding(usize),
    /// Goes to the next thing that is wrong, or to the one before.
    NextFinding(bool),
    /// Goes to what could not be read of the file, by its place in the list.
    GoToProblem(usize),
    /// Puts into the cell what it should probably hold, where its deviations are micrometres.
    TakeMeant,
    /// Leaves out what could not be read of the file.
    LeaveOut,
    /// Puts the balloon of a row on the picture: shares of its width and height.
    PlaceBalloon {
        row: usize,
        /// From the left and from the top.
        at: [f64; 2],
        /// Whether it was let go.
        is_done: bool,
    },
    /// Moves the balloon of a row by a small step.
    NudgeBalloon(usize, Step),
    /// Takes the balloon of a row off the picture.
    RemoveBalloon(usize),
    /// A picture was chosen; its file is beside the plan.
    ChoosePicture(PathBuf),
    /// A picture was read, or not.
    PictureRead { path: PathBuf, result: Result<Arc<PartPicture>, Message> },
    /// Takes the last change back.
    Undo,
    /// Makes it again.
    Redo,
}

/// What can be done on the walk.
#[derive(Debug, Clone)]
pub enum WalkCommand {
    /// Begins a part with the serial number in its field; one that was measured already is asked about first.
    Begin,
    /// Counts the serial number in its field up.
    CountUp,
    /// Asks for a size of the plan, by its position.
    Go(usize),
    /// Asks for another one.
    Move(Step),
    /// Takes the value in its field. One that may be another quantity is asked about first; a second time takes it, half a second later.
    Take,
    /// Takes what the typed value may have been.
    TakeMeant,
    /// The typed value that cannot be is dropped, and another one is asked for.
    MeasureAnew,
    /// Measures the feature by its cycle on a perfect part.
    Simulate,
    /// Asks once more for the size that is looked at.
    Again,
    /// Asks why the size is left out, or not.
    AskSkip(bool),
    /// Of the values of a size that contradict each other the newest one counts.
    CountNewest,
    /// Leaves the size out for a reason.
    Skip(String),
    /// Ends the part and counts up; where something is missing, that is said first and a second time ends it.
    Next,
    /// Asks for cause and action of an open alarm, by the number of its entry.
    AskAlarm(u64),
    /// The alarm is answered later.
    LeaveAlarm,
    /// Records cause and action of the alarm.
    AnswerAlarm,
    /// Alarms were looked for, or cannot be.
    AlarmsFound(Result<Box<AlarmsFound>, Message>),
    /// The part that is measured goes on, though another plan is open.
    KeepOn,
    /// A file of measurements was read, or not.
    Imported {
        /// The number of the part that it was read for.
        run: u64,
        /// Its name without the folder.
        name: String,
        /// What it holds.
        result: Result<Vec<Item>, Message>,
    },
    /// The journal has answered what is known of the part.
    Came {
        /// The number of the question.
        run: u64,
        /// The records, the oldest first.
        result: Result<Vec<RecordRow>, Message>,
    },
    /// Watches a folder from now on; a file is none.
    Watch { folder: PathBuf, is_folder: bool },
    /// Ends the watch.
    StopWatch,
    /// Something came from a watched folder.
    Watched {
        /// The number of the watch.
        run: u64,
        news: Box<WatchNews>,
    },
}
