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

use super::text;
use crate::length::Unit;
use crate::message::Located;
use crate::probing::cycle::{self, TextLog};
use crate::probing::cycles::cycle as cycle_of;
use lines::Chunk;

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
        cycle::Log::Points { .. } | cycle::Log::Screen => None,
    }
}

/// Reads every log of a file: one result per log, so that a broken log does not affect the others.
///
/// A file without any log gives one error.
///
/// ```
/// let bytes = std::fs::read("tests/data/samples/logs/en/TCHPR421.TXT")?;
/// let logs = fitcheck::control::log::read(&bytes);
/// let log = logs.first().and_then(|log| log.as_ref().ok());
/// assert_eq!(log.map(|log| log.cycle), Some(421));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn read(bytes: &[u8]) -> Vec<Result<Log, LogError>> {
    each(&text::decode(bytes)).collect()
}

/// The same for a text, one log after the other: memory stays the same however many there are.
pub fn each(text: &str) -> impl Iterator<Item = Result<Log, LogError>> {
    let mut chunks = lines::chunks(text);
    let mut before = None;
    let mut is_empty = true;
    std::iter::from_fn(move || {
        for chunk in chunks.by_ref() {
            if chunk.title.is_none() && !chunk.has_figures() {
                // Everything above the first title.
                let line = chunk.first_line().unwrap_or(1);
                before.get_or_insert(Located::in_line(line, LogWarningKind::TextBefore));
                continue;
            }
            is_empty = false;
            let read = read_one(&chunk).map(|mut log| {
                log.warnings.splice(0..0, before.take());
                log
            });
            return Some(read);
        }
        let reason = if text.trim().is_empty() { LogFault::Empty } else { LogFault::NoLog };
        std::mem::take(&mut is_empty).then(|| Err(reason.at(1)))
    })
}

/// Whether a text looks like a measuring log: a title, and labels followed by figures.
pub fn is_log(text: &str) -> bool {
    lines::chunks(text).any(|chunk| chunk.title.is_some() && chunk.has_figures())
}

fn read_one(chunk: &Chunk<'_>) -> Result<Log, LogError> {
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
        title: title.text.to_owned(),
        date: header.date,
        time: header.time,
        program: header.program,
        unit,
        figures,
        further,
        warnings,
    })
}
