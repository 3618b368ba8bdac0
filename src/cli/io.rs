//! The standard streams and files: what every subcommand reads and writes.

use std::fmt::Display;
use std::io::{BufRead, BufReader, BufWriter, IsTerminal as _, Read as _, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use super::progress::{Line, Work};
use super::said::{CliRemark, CliWarning, about, remark, warning};
use super::{CliError, Refused as _, What};
use crate::control::deviations;
use crate::exchange::contacts;
use crate::files::{self, FileError};
use crate::journal::chain::Hash;
use crate::journal::entry::{FileRole, UsedFile};
use crate::length::Length;
use crate::message::{IntoArg, Say};
use crate::tolerance::DeviationTable;

/// The standard streams, as arguments so that tests can bring their own.
///
/// Nothing is written around its methods: what a person reads on a terminal is tamed.
pub struct Io<'a> {
    /// Standard input.
    pub(super) input: &'a mut (dyn BufRead + Send),
    out: Tame<'a>,
    err: &'a mut dyn Write,
    /// The files that were read, where they are to be remembered.
    files: Option<Vec<UsedFile>>,
    /// The line that tells how far something is.
    line: Option<Line>,
    /// Whether answers come to a terminal, where the line would stand among them.
    is_terminal: bool,
}

impl<'a> Io<'a> {
    /// Standard input, standard output (buffered) and standard error.
    pub fn new(input: &'a mut (dyn BufRead + Send), out: &'a mut (dyn Write + Send), err: &'a mut dyn Write) -> Self {
        Self { input, out: Tame { out }, err, files: None, line: None, is_terminal: false }
    }

    /// Runs with the process's own streams.
    pub(super) fn standard<T>(run: impl FnOnce(&mut Io<'_>) -> T) -> T {
        // Not locked: workers read and write them, too.
        let mut out = BufWriter::new(std::io::stdout());
        let mut err = std::io::stderr();
        let mut input = BufReader::new(std::io::stdin());
        let is_terminal = std::io::stdout().is_terminal();
        run(&mut Io { is_terminal, ..Io::new(&mut input, &mut out, &mut err) })
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

    /// The files that were read so far.
    pub(super) fn files(&self) -> Vec<UsedFile> {
        self.files.clone().unwrap_or_default()
    }

    /// Standard output for an answer that a person reads.
    pub(super) fn people(&mut self) -> &mut dyn Write {
        self.give_way();
        &mut self.out
    }

    /// Standard output for JSON, CSV and files: byte for byte.
    pub(super) fn data(&mut self) -> &mut dyn Write {
        self.give_way();
        self.out.out
    }

    /// Standard input, output and error for workers that read and write in turns.
    pub(super) fn streams(&mut self) -> (&mut (dyn BufRead + Send), &mut (dyn Write + Send), Listener<'_>) {
        (self.input, self.out.out, Listener(self.err))
    }

    /// From here on what is told stands above the line of a work.
    pub(super) fn watch(&mut self, work: &Work) {
        self.line = Some(work.line());
    }

    /// The line goes where answers come to the same terminal.
    fn give_way(&self) {
        if let Some(line) = self.line.as_ref().filter(|_| self.is_terminal) {
            line.give_way();
        }
    }

    /// Standard input beside standard output, for an answer to each line.
    pub(super) fn input_and_data(&mut self) -> (&mut dyn BufRead, &mut dyn Write) {
        (self.input, self.out.out)
    }

    /// Writes a line to standard error. It is not an error if nobody listens there or nothing more fits: the answer and
    /// the exit code stand without it.
    pub(super) fn tell(&mut self, line: impl Display) {
        let mut listener = Listener(self.err);
        match &self.line {
            Some(shown) => shown.beside(|| listener.tell(line)),
            None => listener.tell(line),
        }
    }

    /// Prints an answer for programs.
    pub(super) fn json(&mut self, answer: &impl serde::Serialize) -> Result<(), CliError> {
        let written = serde_json::to_writer_pretty(self.data(), answer).map_err(std::io::Error::from);
        heard_or_not(written.and_then(|()| writeln!(self.data())))
    }

    /// Prints a warning.
    pub(super) fn warn(&mut self, what: &impl Say) {
        self.tell(warning(what));
    }

    /// Prints a warning about something: a file, a part.
    pub(super) fn warn_about(&mut self, name: &(impl IntoArg + ?Sized), what: &impl Say) {
        self.tell(warning(&about(name, what)));
    }

    /// Prints a remark.
    pub(super) fn remark(&mut self, what: &impl Say) {
        self.tell(remark(what));
    }

    /// Prints what failed, while the rest continues.
    pub(super) fn fail(&mut self, error: impl Display) {
        self.tell(format_args!("fitcheck: {error}"));
    }
}

/// Standard output for people: every text that is written to it is tamed.
struct Tame<'a> {
    out: &'a mut (dyn Write + Send),
}

/// Standard error, while the other streams are in use.
pub(super) struct Listener<'a>(&'a mut dyn Write);

impl Listener<'_> {
    /// As [`Io::tell`].
    pub(super) fn tell(&mut self, line: impl Display) {
        let _unheard = writeln!(self.0, "{}", tame(&line.to_string()));
    }
}

impl Write for Tame<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.out.write_all(tame(&String::from_utf8_lossy(bytes)).as_bytes())?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.out.flush()
    }
}

/// A text from a file, a name or an argument, safe for a terminal: control characters, which could write a title or
/// hide a line, and the marks that turn the direction of a text (Unicode's `Bidi_Control`), which could show
/// `SCRAP` where something else is written, become blanks.
fn tame(text: &str) -> String {
    let is_wild = |c: char| {
        c.is_control() && c != '\n' && c != '\t'
            || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    text.chars().map(|c| if is_wild(c) { ' ' } else { c }).collect()
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
    let _unheard = writeln!(std::io::stderr().lock(), "fitcheck: {}", tame(message));
    ExitCode::FAILURE
}

/// Prints a remark on the process's own standard error, from where the streams are not at hand.
pub(super) fn tell_at_once<T: Say>(what: &T) {
    Listener(&mut std::io::stderr().lock()).tell(remark(what));
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
pub(super) fn read_contacts(path: &Path, io: &mut Io<'_>) -> Result<(String, contacts::Contacts), CliError> {
    let (name, bytes) = read_input(path, io)?;
    io.used(FileRole::Measurements, &name, &bytes);
    let read = contacts::read(&bytes).about(&name)?;
    for column in &read.ignored {
        io.warn_about(&name, &CliWarning::ColumnNotUsed { column });
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
pub(super) fn diameter(text: &str, what: What<'_>) -> Result<Length, CliError> {
    let diameter: Length = text.parse().about(&what)?;
    if Length::ZERO < diameter { Ok(diameter) } else { Err(CliError::NotAboveZero { diameter }).about(&what) }
}

/// Writes an output file and prints its name on standard error.
pub(super) fn save(path: &Path, bytes: &[u8], io: &mut Io<'_>) -> Result<(), CliError> {
    files::write(path, bytes)?;
    io.tell(CliRemark::Wrote { path: path.display().to_string() });
    Ok(())
}

/// The same for a file that is written piece by piece.
pub(super) fn save_with(
    path: &Path,
    write: &mut dyn FnMut(&mut (dyn Write + Send)) -> std::io::Result<()>,
    io: &mut Io<'_>,
) -> Result<(), CliError> {
    files::write_with(path, write)?;
    io.tell(CliRemark::Wrote { path: path.display().to_string() });
    Ok(())
}

/// The local date and time to the second: what a person reads, and what every control prints.
pub(super) fn now() -> jiff::civil::DateTime {
    let now = files::now().datetime();
    now.with().subsec_nanosecond(0).build().unwrap_or(now)
}
