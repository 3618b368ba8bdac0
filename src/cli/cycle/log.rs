//! The measuring log of a run: written into a folder (Q281 = 1, cycle 444) or shown (Q281 = 2).

use std::path::{Path, PathBuf};

use super::super::io::not_dash;
use super::super::{CliWarning, ErrorSubject, IntoCliError as _};
use super::{CliError, Io, Source};
use crate::control::cycle_log::{CycleLog, Heading, OtherVerdict};
use crate::files::{self, FileError};
use crate::length::Unit;
use crate::message::{FilePlace, Located};
use crate::probing::cycle::{Cycle, CycleResult, LogTarget};
use crate::text::decode;
use crate::words::Dialogue;

/// Where and how the log is kept.
#[derive(Debug, clap::Args)]
pub(super) struct LogArgs {
    /// Folder for the log that Q281 = 1 and cycle 444 ask for; an existing log is continued
    #[arg(long, value_name = "FOLDER")]
    log_folder: Option<PathBuf>,
    /// Path of the NC program on the control, for the log, such as TNC:\PART1.H
    #[arg(long, value_name = "PATH")]
    program: Option<String>,
    /// Date and time of the measurement in the log; default: now
    #[arg(long, value_name = "YYYY-MM-DDTHH:MM")]
    time: Option<jiff::civil::DateTime>,
}

/// What became of the log.
#[derive(Debug, Default)]
pub(super) struct Kept {
    /// The text, where it goes on the screen.
    pub(super) shown: Option<String>,
    /// Where the log differs from the cycle.
    pub(super) other: Option<OtherVerdict>,
}

impl LogArgs {
    /// Writes the log if the cycle asks for a file and a folder was given, and makes the text for the screen.
    pub(super) fn keep(
        &self,
        cycle: &Cycle,
        result: &CycleResult,
        source: &Source,
        language: Dialogue,
        io: &mut Io<'_>,
    ) -> Result<Kept, CliError> {
        self.log_folder.as_deref().map_or(Ok(()), not_dash)?;
        let date_time = Some(self.time.unwrap_or_else(super::super::now));
        let program = self.program.clone();
        let unit = Unit::Millimetre;
        let heading = Heading { date_time, program, unit, is_simulated: source.origin().is_simulated() };
        let log = match result.log {
            LogTarget::None | LogTarget::Shown => None,
            LogTarget::File(_) | LogTarget::Screen => CycleLog::of(cycle, result, &heading, language),
        };
        let Some(log) = log else {
            let (warning, is_due) = match result.log {
                LogTarget::File(_) | LogTarget::Screen => (CliWarning::LogUnknown { code: cycle.code }, true),
                LogTarget::None => (CliWarning::LogOff, self.log_folder.is_some()),
                LogTarget::Shown => (CliWarning::LogNone, self.log_folder.is_some()),
            };
            if is_due {
                io.warn(&warning);
            } else {
                self.warn_of_heading(io);
            }
            return Ok(Kept::default());
        };
        let mut kept = Kept { shown: None, other: log.other_verdict(result, language) };
        match (result.log, &self.log_folder) {
            (LogTarget::File(name), Some(folder)) => add(&log, folder, name, language, io)?,
            (LogTarget::Screen, _) => {
                let bytes = log.write(language).about(&ErrorSubject::Log)?;
                kept.shown = Some(decode(&bytes).replace("\r\n", "\n"));
            }
            // Nothing is written, so nothing differs.
            _ => {
                kept.other = None;
                self.warn_of_heading(io);
            }
        }
        if let (LogTarget::Screen, Some(_)) = (result.log, &self.log_folder) {
            io.warn(&CliWarning::LogOnScreen);
        }
        Ok(kept)
    }
}

impl LogArgs {
    /// Warns of what a log would have said, where there is none.
    fn warn_of_heading(&self, io: &mut Io<'_>) {
        for (option, is_given) in [("program", self.program.is_some()), ("time", self.time.is_some())] {
            if is_given {
                io.warn(&CliWarning::LogOption { option });
            }
        }
    }
}

/// Adds the log to the file; neither file nor folder need be there yet.
fn add(log: &CycleLog, folder: &Path, name: &str, language: Dialogue, io: &mut Io<'_>) -> Result<(), CliError> {
    let path = &folder.join(name);
    let before = match files::read(path) {
        Ok(bytes) => bytes,
        Err(FileError::Missing { .. }) => Vec::new(),
        Err(error) => return Err(error.into()),
    };
    let of_file =
        |what| Located { what, place: FilePlace { file: Some(path.to_string_lossy().into()), ..FilePlace::default() } };
    let bytes = log.append(&before, language).map_err(of_file).about(&ErrorSubject::Log)?;
    files::make_folder(folder)?;
    super::super::save(path, &bytes, io)
}
