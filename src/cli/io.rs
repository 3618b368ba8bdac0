//! The standard streams and files: what every subcommand reads and writes.

mod out;

use std::fmt::Display;
use std::io::{BufRead, BufReader, BufWriter, IsTerminal as _, Read as _, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use out::{Out, tame};

use super::admitted::Admits;
use super::progress::{Line, Work};
use super::said::{CliRemark, CliWarning, about, remark, warning};
use super::{CliError, ErrorSubject, IntoCliError as _, OfWindow, Outcome};
use crate::control::deviations;
use crate::exchange::contacts;
use crate::files::{self, FileError};
use crate::journal::chain::Hash;
use crate::journal::entry::{FileRole, UsedFile};
use crate::length::Length;
use crate::message::{IntoArg, Say};
use crate::tolerance::DeviationTable;
use crate::tolerance::fit::thermal::Temperature;
pub(super) use out::{Tame, tame_line};

/// The standard streams, as arguments so that tests can bring their own.
///
/// Nothing is written around its methods: what a person reads on a terminal is tamed.
pub struct Io<'a> {
    /// Standard input.
    pub(super) input: &'a mut (dyn BufRead + Send),
    out: Tame<Out<'a>>,
    err: &'a mut dyn Write,
    /// The files that were read, where they are to be remembered.
    files: Option<Vec<UsedFile>>,
    /// The line that tells how far something is.
    line: Option<Line>,
    /// Whether answers come to a terminal, where the line would stand among them.
    is_terminal: bool,
    /// Whether something was told that asks somebody to look before the answers count.
    wants_a_look: bool,
    /// Whether standard error has warnings and errors only.
    is_quiet: bool,
    /// Asks what only the window knows; none in a program without it.
    of_window: Option<fn() -> OfWindow>,
}

impl<'a> Io<'a> {
    /// Standard input, standard output (buffered) and standard error.
    pub fn new(input: &'a mut (dyn BufRead + Send), out: &'a mut (dyn Write + Send), err: &'a mut dyn Write) -> Self {
        let out = Tame(Out { out, failed: None });
        Self {
            input,
            out,
            err,
            files: None,
            line: None,
            is_terminal: false,
            wants_a_look: false,
            is_quiet: false,
            of_window: None,
        }
    }

    /// Runs with the process's own streams.
    pub(super) fn standard<T>(of_window: Option<fn() -> OfWindow>, run: impl FnOnce(&mut Io<'_>) -> T) -> T {
        // Not locked: workers read and write them, too.
        let mut out = BufWriter::new(std::io::stdout());
        let mut err = std::io::stderr();
        let mut input = BufReader::new(std::io::stdin());
        let is_terminal = std::io::stdout().is_terminal();
        run(&mut Io { is_terminal, of_window, ..Io::new(&mut input, &mut out, &mut err) })
    }

    /// From here on the files that are read are remembered: what was decided with them is to be recorded.
    pub(super) fn remember(&mut self) {
        self.files.get_or_insert_default();
    }

    /// A file that was read for a check.
    pub(super) fn used(&mut self, role: FileRole, name: &str, bytes: &[u8]) {
        if let Some(files) = &mut self.files {
            files.push(UsedFile { role, name: name.into(), sha256: Hash::of_file(bytes) });
        }
    }

    /// The files that were read so far; none where they are not kept.
    pub(super) fn files(&self) -> Vec<UsedFile> {
        self.files.as_ref().map_or_else(Vec::new, Clone::clone)
    }

    /// Standard output for an answer that a person reads.
    pub(super) fn people(&mut self) -> &mut Tame<Out<'a>> {
        self.give_way();
        &mut self.out
    }

    /// Standard output for JSON, CSV and files: byte for byte.
    pub(super) fn data(&mut self) -> &mut Out<'a> {
        self.give_way();
        &mut self.out.0
    }

    /// What only the window knows, where there is one.
    pub(super) fn of_window(&self) -> Option<OfWindow> {
        self.of_window.map(|ask| ask())
    }

    /// Whether nobody reads standard output any more: whoever would go on for ever ends.
    pub(super) fn is_closed(&self) -> bool {
        self.out.0.failed.as_ref().is_some_and(|error| error.kind() == std::io::ErrorKind::BrokenPipe)
    }

    /// Why standard output could not be written, where it could not be. A closed pipe is no error.
    pub(super) fn unwritten(&mut self) -> Option<std::io::Error> {
        self.out.0.flush();
        self.out.0.failed.take().filter(|error| error.kind() != std::io::ErrorKind::BrokenPipe)
    }

    /// Standard input, output and error for workers that read and write in turns.
    pub(super) fn streams(&mut self) -> (&mut (dyn BufRead + Send), &mut (dyn Write + Send), Listener<'_>) {
        let listener = Listener { err: self.err, wants_a_look: &mut self.wants_a_look, is_quiet: self.is_quiet };
        (self.input, self.out.0.out, listener)
    }

    /// From here on what is told stands above the line of a work.
    pub(super) fn watch(&mut self, work: &Work) {
        let line = work.line();
        if self.is_quiet {
            line.give_way();
        }
        self.line = Some(line);
    }

    /// From here on standard error has warnings and errors only.
    pub(super) const fn be_quiet(&mut self) {
        self.is_quiet = true;
    }

    /// Writes a line to standard error that nobody has to act on: none where it is to be quiet.
    pub(super) fn note(&mut self, line: impl Display) {
        if !self.is_quiet {
            self.tell(line);
        }
    }

    /// The line goes where answers come to the same terminal.
    fn give_way(&self) {
        if let Some(line) = self.line.as_ref().filter(|_| self.is_terminal) {
            line.give_way();
        }
    }

    /// Standard input beside standard output, for an answer to each line.
    pub(super) fn input_and_data(&mut self) -> (&mut dyn BufRead, &mut Out<'a>) {
        (self.input, &mut self.out.0)
    }

    /// Writes a line to standard error. It is not an error if nobody listens there or nothing more fits: the answer and
    /// the exit code stand without it.
    pub(super) fn tell(&mut self, line: impl Display) {
        let is_quiet = self.is_quiet;
        let mut listener = Listener { err: self.err, wants_a_look: &mut self.wants_a_look, is_quiet };
        match &self.line {
            Some(shown) => shown.beside(|| listener.tell(line)),
            None => listener.tell(line),
        }
    }

    /// Prints an answer for programs.
    pub(super) fn json(&mut self, answer: &impl serde::Serialize) {
        let out = self.data();
        let written = serde_json::to_writer_pretty(&mut *out, answer);
        out.keep(written.map_err(std::io::Error::from));
        writeln!(out);
    }

    /// Prints a warning. Whether somebody has to look first is decided with its kind.
    pub(super) fn warn(&mut self, what: &impl Admits) {
        self.wants_a_look |= what.wants_a_look();
        self.tell(warning(what));
    }

    /// Prints a warning about something: a file, a part.
    pub(super) fn warn_about(&mut self, name: &(impl IntoArg + ?Sized), what: &impl Admits) {
        self.wants_a_look |= what.wants_a_look();
        self.tell(warning(&about(name, what)));
    }

    /// Something was told that asks somebody to look before the answers count.
    pub(super) fn look_first(&mut self) {
        self.wants_a_look = true;
    }

    /// What the exit code must admit of all that was told.
    pub(super) const fn admitted(&self) -> Outcome {
        if self.wants_a_look { Outcome::LookFirst } else { Outcome::Done }
    }

    /// Prints a remark.
    pub(super) fn remark(&mut self, what: &impl Say) {
        self.note(remark(what));
    }

    /// Prints what failed, while the rest continues.
    pub(super) fn fail(&mut self, error: impl Display) {
        self.tell(format_args!("fitcheck: {error}"));
    }
}

/// Standard error, while the other streams are in use.
pub(super) struct Listener<'a> {
    err: &'a mut dyn Write,
    wants_a_look: &'a mut bool,
    is_quiet: bool,
}

impl Listener<'_> {
    /// As [`Io::tell`].
    pub(super) fn tell(&mut self, line: impl Display) {
        let _unheard = writeln!(self.err, "{}", tame_line(&line.to_string()));
    }

    /// As [`Io::note`].
    pub(super) fn note(&mut self, line: impl Display) {
        if !self.is_quiet {
            self.tell(line);
        }
    }

    /// As [`Io::look_first`].
    pub(super) fn look_first(&mut self) {
        *self.wants_a_look = true;
    }
}

/// Whether an argument is a dash, which stands for standard input or output.
pub(super) fn is_dash(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// Refuses a dash for what standard output cannot take: a folder, a database, one of several files.
pub(super) fn not_dash(path: &Path) -> Result<(), CliError> {
    if is_dash(path) { Err(CliError::Dash) } else { Ok(()) }
}

/// Prints help, or what is wrong with the arguments, and ends the program.
#[expect(clippy::exit, reason = "as clap itself ends it; nothing is open yet")]
pub(super) fn end(error: &clap::Error) -> ! {
    if !error.use_stderr() {
        error.exit();
    }
    // Without clap's colours: what it repeats was given by somebody, and is tamed with the rest.
    let _unheard = std::io::stderr().lock().write_all(tame(&error.render().to_string()).as_bytes());
    std::process::exit(error.exit_code())
}

/// Prints on standard error why the program ends; if it is closed, nobody is left to tell.
pub fn tell(message: &str) -> ExitCode {
    let _unheard = writeln!(std::io::stderr().lock(), "fitcheck: {}", tame_line(message));
    ExitCode::FAILURE
}

/// Prints a remark on the process's own standard error, from where the streams are not at hand.
pub(super) fn tell_at_once<T: Say>(what: &T) {
    let mut err = std::io::stderr().lock();
    let mut wants_a_look = false;
    Listener { err: &mut err, wants_a_look: &mut wants_a_look, is_quiet: false }.tell(remark(what));
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

/// A file of contacts that count as taken at a temperature, and the name to call it by.
pub(super) fn read_contacts(
    path: &Path,
    counted: Temperature,
    io: &mut Io<'_>,
) -> Result<(String, contacts::Contacts), CliError> {
    let (name, bytes) = read_input(path, io)?;
    io.used(FileRole::Measurements, &name, &bytes);
    let read = contacts::read(&bytes).about(&name)?;
    for column in &read.ignored {
        io.warn_about(&name, &CliWarning::ColumnNotUsed { column });
    }
    if let Some(told) = read.told_of_temperature(counted) {
        io.warn_about(&name, &told);
    }
    Ok((name, read))
}

/// Warns of inputs that are named twice: their rows are counted twice.
pub(super) fn warn_of_repeats(paths: &[PathBuf], io: &mut Io<'_>) {
    // What cannot be found is refused where it is read.
    let places: Vec<_> = paths.iter().map(|path| path.canonicalize().ok()).collect();
    for (number, (path, place)) in paths.iter().zip(&places).enumerate() {
        let is_repeated = place.is_some() && places.iter().take(number).any(|before| before == place);
        if is_repeated {
            io.warn_about(&path.display().to_string(), &CliWarning::FileTwice);
        }
    }
}

/// A control table of deviations, the name to call it by, and its bytes.
pub(super) fn read_table(path: &Path, io: &mut Io<'_>) -> Result<(DeviationTable, String, Vec<u8>), CliError> {
    let (name, bytes) = read_input(path, io)?;
    let (table, warnings) = deviations::read_table(&bytes, &name, &name, false).said()?;
    for warning in &warnings {
        io.warn(warning);
    }
    match table {
        Some(table) => Ok((table, name, bytes)),
        None => Err(CliError::NotATable { name }),
    }
}

/// A measured diameter in mm, above zero.
pub(super) fn diameter(text: &str, what: ErrorSubject<'_>) -> Result<Length, CliError> {
    let diameter: Length = text.parse().about(&what)?;
    if Length::ZERO < diameter { Ok(diameter) } else { Err(CliError::NotAboveZero { diameter }).about(&what) }
}

/// Writes an output file and prints its name on standard error.
pub(super) fn save(path: &Path, bytes: &[u8], io: &mut Io<'_>) -> Result<(), CliError> {
    files::write(path, bytes)?;
    io.note(CliRemark::Wrote { path: path.display().to_string() });
    Ok(())
}

/// Writes a file that is not there yet, or any where that is forced.
pub(super) fn write_new(path: &Path, bytes: &[u8], is_forced: bool) -> Result<(), CliError> {
    let write = if is_forced { files::write } else { files::write_new };
    write(path, bytes).map_err(|error| unless_forced(error, is_forced))
}

/// Why a file was not written, and how to force it.
pub(super) fn unless_forced(error: FileError, is_forced: bool) -> CliError {
    match error {
        error @ FileError::Exists { .. } if !is_forced => CliError::UseForce { error },
        error => error.into(),
    }
}

/// Writes an output file piece by piece and prints its name on standard error.
pub(super) fn save_with(
    path: &Path,
    write: &mut dyn FnMut(&mut (dyn Write + Send)) -> std::io::Result<()>,
    io: &mut Io<'_>,
) -> Result<(), CliError> {
    files::write_with(path, write)?;
    io.note(CliRemark::Wrote { path: path.display().to_string() });
    Ok(())
}

/// The same where standard output takes what no file is named for, or a dash.
pub(super) fn put(
    path: Option<&Path>,
    write: &mut dyn FnMut(&mut (dyn Write + Send)) -> std::io::Result<()>,
    io: &mut Io<'_>,
) -> Result<(), CliError> {
    match path.filter(|path| !is_dash(path)) {
        Some(path) => save_with(path, write, io),
        None => Ok(write(io.data())?),
    }
}

/// The local date and time to the second: what a person reads, and what every control prints.
pub(super) fn now() -> jiff::civil::DateTime {
    let now = files::now().datetime();
    now.with().subsec_nanosecond(0).build().unwrap_or(now)
}
