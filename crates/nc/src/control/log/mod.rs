//! Measuring logs of cycles as texts, such as `TCHPR421.TXT`: the cycle's declaration says which figures they have.
//!
//! | file | what |
//! |---|---|
//! | `lines` | a log's lines as header, sections and pairs of label and number |
//! | `values` | the pairs as nominal values, limits, actual values and deviations, and whether they agree |
//! | `error` | errors and warnings for a log |
//! | `write` | a log as a control writes it; several in one file |
//! | `model` | values on the way to a log: differences, limits about a nominal value, figures as printed |
//! | `labels` | a log's words in the control's dialogue languages |
//!
//! The words of a log follow the control's dialogue language, so a log is read by order and numbers alone. A log holds
//! no status and no tolerance class: the verdict is computed elsewhere from its limits and actual values.

mod error;
pub(super) mod labels;
mod lines;
mod model;
mod values;
mod write;

use jiff::civil::{Date, DateTime, Time};

pub use error::{LogError, LogFault, LogWarning, LogWarningKind, Section};
pub use values::{Figure, LimitPair};
pub use write::{LogWriteError, append, write};

use fitcheck_core::length::Unit;
use fitcheck_core::message::Located;
use fitcheck_core::probing::cycle::{self, TextLog};
use fitcheck_core::probing::cycles::cycle as cycle_of;
use fitcheck_core::text;
use lines::{Chunk, Chunks};

/// One measuring log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Log {
    /// The line of the title, from 1.
    pub line: usize,
    /// The number of the measuring cycle.
    pub cycle: u16,
    /// The title as the control wrote it.
    pub title: String,
    /// Day of the measurement.
    pub date: Option<Date>,
    /// Time of the measurement.
    pub time: Option<Time>,
    /// Path of the NC program on the control.
    pub program: Option<String>,
    /// The unit of the figures in the file; all lengths here are converted exactly.
    pub unit: Unit,
    /// The figures in the order of the cycle's declaration.
    pub figures: Vec<Figure>,
    /// Further results, such as the measuring height, as they were written.
    pub further: Vec<Further>,
    /// Whether a simulation has written it, as its mark says: nobody measured.
    pub is_simulated: bool,
    /// Warnings about a log that could still be read.
    pub warnings: Vec<LogWarning>,
}

/// A further result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Further {
    /// Its name in the control's dialogue language.
    pub label: String,
    /// The text after the label.
    pub value: String,
}

impl Log {
    /// When it was measured, if the log gives both day and time.
    pub fn date_time(&self) -> Option<DateTime> {
        Some(self.date?.to_datetime(self.time?))
    }
}

/// The layout of a cycle's log; `None` for an unknown cycle and for one that writes no such log.
pub fn layout(cycle: u16) -> Option<&'static TextLog> {
    match &cycle_of(cycle)?.log {
        cycle::Log::Text(log) => Some(log),
        cycle::Log::Points { .. } | cycle::Log::Screen | cycle::Log::None => None,
    }
}

/// Reads every log of a file: one result per log, so that a broken log does not affect the others.
///
/// A file without any log gives one error.
///
/// ```
/// let bytes = std::fs::read("../../tests/data/samples/logs/en/TCHPR421.TXT")?;
/// let logs = fitcheck_nc::control::log::read(&bytes);
/// let log = logs.first().and_then(|log| log.as_ref().ok());
/// assert_eq!(log.map(|log| log.cycle), Some(421));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn read(bytes: &[u8]) -> Vec<Result<Log, LogError>> {
    each(&text::decode(bytes)).collect()
}

/// The same for a text, one log after the other.
pub fn each(text: &str) -> impl Iterator<Item = Result<Log, LogError>> {
    let mut lines = text::lines_open_from(text, 1);
    let mut logs = Some(Logs::default());
    std::iter::from_fn(move || {
        let reads = logs.as_mut()?;
        let next = lines.by_ref().find_map(|(number, line, is_open)| reads.line(number, line, is_open));
        next.or_else(|| logs.take()?.end())
    })
}

/// Reads logs line by line: memory stays the same however many there are.
#[derive(Debug, Default)]
pub struct Logs {
    chunks: Chunks,
    /// What stood above the next log.
    before: Option<LogWarning>,
    /// Whether the mark of a simulation stood there.
    is_simulated: bool,
    is_found: bool,
    /// Whether there was anything.
    has_text: bool,
}

impl Logs {
    /// Takes a line without its end, and gives the log that ends before it. `is_open` is whether text may be missing behind it.
    pub fn line(&mut self, number: usize, line: &str, is_open: bool) -> Option<Result<Log, LogError>> {
        let chunk = self.chunks.line(number, line, is_open);
        self.has_text = self.has_text || !line.trim_ascii().is_empty();
        self.read(&chunk?)
    }

    /// The log that ends with the text; a text without any gives one error.
    pub fn end(mut self) -> Option<Result<Log, LogError>> {
        let last = self.chunks.end().and_then(|chunk| self.read(&chunk));
        let fault = if self.has_text { LogFault::NoLog } else { LogFault::Empty };
        last.or_else(|| (!self.is_found).then(|| Err(fault.at(1))))
    }

    fn read(&mut self, chunk: &Chunk) -> Option<Result<Log, LogError>> {
        if chunk.title.is_none() && !chunk.has_figures() {
            // Everything above the first title.
            self.is_simulated |= chunk.is_simulated;
            let line = chunk.first_line()?;
            self.before.get_or_insert(Located::in_line(line, LogWarningKind::TextBefore));
            return None;
        }
        self.is_found = true;
        let is_simulated = std::mem::take(&mut self.is_simulated);
        Some(read_one(chunk).map(|mut log| {
            log.is_simulated |= is_simulated;
            log.warnings.splice(0..0, self.before.take());
            log
        }))
    }
}

/// Whether a text looks like a measuring log: a title, and labels followed by figures.
pub fn is_log(text: &str) -> bool {
    let is_log = |chunk: Chunk| chunk.title.is_some() && chunk.has_figures();
    let mut chunks = Chunks::default();
    text::lines(text).any(|(number, line)| chunks.line(number, line, false).is_some_and(is_log))
        || chunks.end().is_some_and(is_log)
}

fn read_one(chunk: &Chunk) -> Result<Log, LogError> {
    let Some(title) = &chunk.title else {
        return Err(LogFault::NoTitle.at(chunk.first_line().unwrap_or(1)));
    };
    if chunk.is_too_long {
        return Err(LogFault::TooLong.at(title.line));
    }
    let mut warnings = Vec::new();
    let mut sections = chunk.sections(&mut warnings)?;
    let header = lines::take_header(&mut sections, &mut warnings)?;
    let unit = header.unit.unwrap_or_else(|| {
        warnings.push(Located::in_line(title.line, LogWarningKind::NoUnit));
        Unit::Millimetre
    });
    if header.date.is_none() || header.time.is_none() {
        warnings.push(Located::in_line(title.line, LogWarningKind::NoTime));
    }
    let body = values::Body::new(chunk, sections, unit);
    let (figures, further) = body.read(title, &mut warnings)?;
    Ok(Log {
        line: title.line,
        cycle: title.cycle,
        title: title.text.clone(),
        date: header.date,
        time: header.time,
        program: header.program,
        unit,
        figures,
        further,
        is_simulated: chunk.is_simulated,
        warnings,
    })
}
