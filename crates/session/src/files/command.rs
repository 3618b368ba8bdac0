//! What can be done with the file dialog, with recent files and with a file that was written.

use std::path::PathBuf;

use fitcheck_core::message::Message;
use fitcheck_files::{FileError, Listing};

use crate::files::Working;
use crate::purpose::Purpose;
use crate::step::Step;

/// Something about files.
#[derive(Debug, Clone)]
pub enum FilesCommand {
    /// Shows a folder in the dialog.
    Show(PathBuf),
    /// Shows the folder above.
    Up,
    /// Shows the user's own folder.
    Home,
    /// A folder was read, or not.
    Listed {
        /// The folder that was asked for.
        folder: PathBuf,
        /// What lies in it.
        result: Result<Box<Listing>, FileError>,
    },
    /// Shows all files, or only those of the kind that is asked for.
    ShowAll(bool),
    /// Goes to another entry of the list.
    Move(Step),
    /// Selects an entry by its number in the list; a folder is shown.
    Select(usize),
    /// Does with an entry what the dialog is for.
    Take(usize),
    /// What was typed into the dialog is a folder.
    IsFolder(PathBuf),
    /// Writes over the file of the name, or asks for another name.
    Replace(bool),
    /// Reads a file from outside the dialog: dropped, or named when the program was started.
    Open(Purpose, PathBuf),
    /// Reads a recent file again, by its number.
    OpenRecent(usize),
    /// Empties the list of recent files.
    ForgetRecent,
    /// Judges the file of the notice on the check page, by what the file itself asks for.
    JudgeUnplanned,
    /// A file was read, or is gone.
    Seen {
        /// What it was read for.
        purpose: Purpose,
        path: PathBuf,
        /// How that went.
        fate: ReadOutcome,
    },
    /// Opens the file of the oldest notice in its own program, or shows it in its folder.
    Launch(Launch),
    /// A program was started, or not.
    Launched(Result<(), Message>),
    /// The files of a set were written into a folder, or none of them.
    SetWritten {
        folder: PathBuf,
        /// The files, the main program first.
        result: Result<Vec<PathBuf>, FileError>,
    },
    /// How far the file is that is being read or written; nothing once it is done.
    Working(Option<Box<Working>>),
    /// Stops reading or writing it.
    StopWorking,
}

/// What came of reading a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReadOutcome {
    Read,
    /// It is there, and could not be read or used.
    Refused,
    /// There is no such file.
    Gone,
}

/// How a file that was written is opened.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Launch {
    /// By the program that the system has for it.
    Open,
    ShowInFolder,
}
