//! What the program was started for: a subcommand, the window, or files that the window opens.

use std::ffi::{OsStr, OsString};
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
    /// Reads the process's arguments. Help and wrong usage end the program here. `knows_ending` says whether a path ends
    /// as a file that the window may read.
    pub fn start(knows_ending: fn(&Path) -> bool) -> Start {
        let given: Vec<OsString> = wild::args_os().collect();
        // What follows two hyphens is a file, whatever it is called.
        let names_files = given.get(1).is_some_and(|first| first == "--");
        match Self::try_parse_from(&given) {
            Ok(cli) if cli.command.is_some() => Start::Subcommand(Box::new(cli)),
            Ok(_) => Start::Window(Vec::new()),
            // A subcommand of the name comes first; what is none may be a file.
            Err(error) if names_files || error.kind() == ErrorKind::InvalidSubcommand => {
                let names = given.into_iter().skip(1 + usize::from(names_files));
                let paths: Vec<PathBuf> = names.map(PathBuf::from).collect();
                let is_file = |path: &Path| names_files || path.is_file() || is_in_folder(path) || knows_ending(path);
                match paths.first() {
                    Some(first) if is_file(first) => match unopenable(&paths) {
                        Some(error) => Self::wrong_usage(&error),
                        None => Start::Window(paths),
                    },
                    _ => io::end(&Self::on_one_line(error, paths.iter().map(|path| path.as_os_str()))),
                }
            }
            Err(error) => io::end(&Self::on_one_line(error, given.iter().skip(1).map(OsString::as_os_str))),
        }
    }

    /// The same error of arguments in which nothing begins another line: clap repeats them as they are.
    fn on_one_line<'a>(error: clap::Error, given: impl Iterator<Item = &'a OsStr>) -> clap::Error {
        let given: Vec<_> = given.map(OsStr::to_string_lossy).collect();
        let tamed: Vec<String> = given.iter().map(|arg| io::tame_line(arg)).collect();
        if given == tamed {
            return error;
        }
        let again = Self::try_parse_from(std::iter::once("fitcheck".to_owned()).chain(tamed)).err();
        again.filter(|again| again.kind() == error.kind()).unwrap_or_else(|| {
            let kind = error.kind();
            let said = error.render().to_string();
            Self::command().error(kind, io::tame_line(&said))
        })
    }

    /// Ends the program: the arguments make no sense.
    pub fn wrong_usage(error: &impl std::fmt::Display) -> ! {
        io::end(&Self::command().error(ErrorKind::ValueValidation, io::tame_line(&error.to_string())))
    }
}

fn unopenable(paths: &[PathBuf]) -> Option<StartError> {
    let path = paths.iter().find(|path| !path.is_file())?.clone();
    Some(if path.is_dir() { StartError::Folder { path } } else { StartError::Missing { path } })
}

/// Whether a path has a folder, as no subcommand has.
fn is_in_folder(path: &Path) -> bool {
    1 < path.components().count() || path.is_absolute()
}
