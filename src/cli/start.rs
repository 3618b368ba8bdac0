//! What the program was started for: a subcommand, the window, or files that the window opens.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::error::ErrorKind;
use clap::{CommandFactory as _, Parser as _};

use super::{Cli, io};
use crate::message::Say;

/// What the program was started for.
#[derive(Debug)]
pub enum Start {
    /// A subcommand.
    Subcommand(Box<Cli>),
    /// The window, with files that exist.
    Window(Vec<PathBuf>),
}

/// Why a file that was named cannot be opened.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "start", error)]
enum StartError {
    /// There is no such file.
    Missing { path: PathBuf },
    /// It is a folder.
    Folder { path: PathBuf },
}

impl Cli {
    /// Reads the process's arguments. Help and wrong usage end the program here.
    pub fn start() -> Start {
        let given: Vec<OsString> = std::env::args_os().collect();
        match Self::try_parse_from(&given) {
            Ok(cli) if cli.command.is_some() => Start::Subcommand(Box::new(cli)),
            Ok(_) => Start::Window(Vec::new()),
            // A subcommand of the name comes first; what is none may be a file.
            Err(error) if error.kind() == ErrorKind::InvalidSubcommand => {
                let paths: Vec<PathBuf> = given.into_iter().skip(1).map(PathBuf::from).collect();
                match paths.first() {
                    Some(first) if first.is_file() || is_like_a_file(first) => match unopenable(&paths) {
                        Some(error) => Self::wrong_usage(&error),
                        None => Start::Window(paths),
                    },
                    _ => io::end(&error),
                }
            }
            Err(error) => io::end(&error),
        }
    }

    /// Ends the program: the arguments make no sense.
    pub fn wrong_usage(error: &impl std::fmt::Display) -> ! {
        io::end(&Self::command().error(ErrorKind::ValueValidation, error))
    }
}

fn unopenable(paths: &[PathBuf]) -> Option<StartError> {
    let path = paths.iter().find(|path| !path.is_file())?.clone();
    Some(if path.is_dir() { StartError::Folder { path } } else { StartError::Missing { path } })
}

/// Whether somebody who typed this meant a file: it has a folder or an ending, as no subcommand has.
fn is_like_a_file(path: &Path) -> bool {
    let is_ending = |ending: &std::ffi::OsStr| ending.to_string_lossy().chars().any(char::is_alphabetic);
    path.extension().is_some_and(is_ending) || 1 < path.components().count() || path.is_absolute()
}
