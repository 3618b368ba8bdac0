//! The standard streams and files: what every subcommand reads and writes.

use std::fmt::Display;
use std::io::{BufRead, Read as _, Write};
use std::path::Path;

use super::said::{CliRemark, CliWarning, about, remark, warning};
use super::{CliError, Refused as _, What};
use crate::control::deviations;
use crate::exchange::contacts;
use crate::files::{self, FileError};
use crate::length::Length;
use crate::message::{IntoArg, Say};
use crate::probing::Contact;
use crate::tolerance::DeviationTable;

/// The standard streams, as arguments so that tests can bring their own.
pub struct Io<'a> {
    /// Standard input.
    pub input: &'a mut dyn BufRead,
    /// Standard output, buffered.
    pub out: &'a mut dyn Write,
    /// Standard error.
    pub err: &'a mut dyn Write,
}

impl Io<'_> {
    /// Writes a line to standard error; it is not an error if nobody listens there, so that the rest is still done.
    pub(super) fn tell(&mut self, line: impl Display) -> Result<(), CliError> {
        heard_or_not(writeln!(self.err, "{}", tame(&line.to_string())))
    }

    /// Prints an answer for programs.
    pub(super) fn json(&mut self, answer: &impl serde::Serialize) -> Result<(), CliError> {
        let text = serde_json::to_string_pretty(answer)?;
        heard_or_not(writeln!(self.out, "{text}"))
    }

    /// Prints a warning.
    pub(super) fn warn(&mut self, what: &impl Say) -> Result<(), CliError> {
        self.tell(warning(what))
    }

    /// Prints a warning about something: a file, a part.
    pub(super) fn warn_about(&mut self, name: &(impl IntoArg + ?Sized), what: &impl Say) -> Result<(), CliError> {
        self.tell(warning(&about(name, what)))
    }

    /// Prints a remark.
    pub(super) fn remark(&mut self, what: &impl Say) -> Result<(), CliError> {
        self.tell(remark(what))
    }

    /// Prints what failed, while the rest continues.
    pub(super) fn fail(&mut self, error: impl Display) -> Result<(), CliError> {
        self.tell(format_args!("fitcheck: {error}"))
    }
}

/// A text from a file, safe for a terminal: control characters, which could write a title or hide a line, become
/// blanks.
pub(super) fn tame(text: &str) -> String {
    text.chars().map(|c| if c.is_control() && c != '\n' && c != '\t' { ' ' } else { c }).collect()
}

/// A closed pipe is not an error, and must never end a subcommand before its verdict.
pub(super) fn heard_or_not(written: std::io::Result<()>) -> Result<(), CliError> {
    match written {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

/// The bytes of a file, or of standard input for `-`, and the name to call it by.
pub(super) fn read_input(path: &Path, io: &mut Io<'_>) -> Result<(String, Vec<u8>), CliError> {
    if path.as_os_str() == "-" {
        let mut bytes = Vec::new();
        std::io::Read::take(&mut *io.input, files::LARGEST + 1).read_to_end(&mut bytes)?;
        if files::LARGEST < u64::try_from(bytes.len()).unwrap_or(u64::MAX) {
            return Err(FileError::TooLarge { path: path.to_owned() }.into());
        }
        return Ok(("standard input".to_owned(), bytes));
    }
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    Ok((name, files::read(path)?))
}

/// A file of contacts, and the name to call it by.
pub(super) fn read_contacts(path: &Path, io: &mut Io<'_>) -> Result<(String, Vec<Contact>), CliError> {
    let (name, bytes) = read_input(path, io)?;
    let read = contacts::read(&bytes).about(&name)?;
    for column in &read.ignored {
        io.warn_about(&name, &CliWarning::ColumnNotUsed { column })?;
    }
    Ok((name, read.contacts))
}

/// A control table of deviations, the name to call it by, and its bytes.
pub(super) fn read_table(path: &Path, io: &mut Io<'_>) -> Result<(DeviationTable, String, Vec<u8>), CliError> {
    let (name, bytes) = read_input(path, io)?;
    let (table, warnings) = deviations::read_table(&bytes, &name, &name, false).said()?;
    for warning in &warnings {
        io.warn(warning)?;
    }
    match table {
        Some(table) => Ok((table, name, bytes)),
        None => Err(CliError::NotATable { name }),
    }
}

/// A measured diameter in mm, above zero.
pub(super) fn diameter(text: &str, what: What<'_>) -> Result<Length, CliError> {
    let diameter: Length = text.parse().about(&what)?;
    if Length::ZERO < diameter { Ok(diameter) } else { Err(CliError::NotAboveZero { diameter }).about(&what) }
}

/// Writes an output file and prints its name on standard error.
pub(super) fn save(path: &Path, bytes: &[u8], io: &mut Io<'_>) -> Result<(), CliError> {
    files::write(path, bytes)?;
    io.tell(CliRemark::Wrote { path: path.display().to_string() })
}

/// The local date and time to the second: what a person reads, and what every control prints.
pub(super) fn now() -> jiff::civil::DateTime {
    let now = jiff::Zoned::now().datetime();
    now.with().subsec_nanosecond(0).build().unwrap_or(now)
}
