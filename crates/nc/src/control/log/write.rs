//! A log as a control writes it.
//!
//! Title, header, sections, their order and four decimals of a millimetre are the maker's for cycle 421
//! (`docs/SOURCES.md`). Our rules are: the columns (label and colon left aligned in 46 characters, the value right
//! aligned in 12), CRLF, ASCII or, if the words need it, Latin-1, four decimals of an inch, the lines after the
//! deviations, all sections of the other cycles, and other languages' words. The documented layout has no line for a
//! status, a tolerance class or a tool: a log has the same lines whether the part is good, rework or scrap. Only what a
//! simulation has measured gets a line more, below the title: its mark.
//!
//! What is written reads back as the same log ([`Log::printed`]), or it is an error. What a log lacks is left out and
//! never made up. Nothing here opens a file.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::Say;
use fitcheck_core::probing::cycle::{FigureKind, LogFigure, TextLog};
use fitcheck_core::text::decode;
use fitcheck_core::words::Dialogue;

use super::labels::Labels;
use super::model::DECIMALS;
use super::{Figure, LimitPair, Log, LogError, LogFault, each, layout};
use crate::control::simulated::MARK;

/// Characters of a label and its colon (our rule).
const LABEL_WIDTH: usize = 46;
/// Characters of a value (our rule).
const VALUE_WIDTH: usize = 12;
/// Between lines (our rule).
const LINE_END: &str = "\r\n";

/// Why a log cannot be written.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "log-write", error)]
pub enum LogWriteError {
    /// The cycle does not measure such values, or has no log of this kind.
    Cycle {
        /// The log's cycle.
        cycle: u16,
    },
    /// The words of logs have no title for the cycle: it is new, and its title is still to be written.
    NoTitle {
        /// The log's cycle.
        cycle: u16,
        /// The file of the program's source in which the title is missing.
        file: String,
    },
    /// The control has only millimetres and inches.
    Unit,
    /// A character that the file cannot hold.
    Character {
        /// The text that holds it.
        given: String,
        /// Its code, four to six hexadecimal digits.
        code: String,
    },
    /// The program would not be read back as one.
    Program { given: String },
    /// The log contradicts itself.
    #[say(transparent)]
    Contradiction(LogFault),
    /// The file that gets another log does not end at the end of a line.
    Unfinished,
    /// Something in the log would be read back differently, such as a further result that looks like a date.
    ReadsOtherwise,
}

/// A log as a file of its own, in the words of a language.
///
/// The log's own title, line and warnings are not used. Figures finer than the last decimal are rounded half away from
/// zero ([`Log::printed`] gives the resulting log).
///
/// ```
/// use fitcheck_nc::control::log::{self, Figure, Further, LimitPair, Log};
/// use fitcheck_core::length::Unit;
/// use fitcheck_core::words::Dialogue;
///
/// let limits = LimitPair { maximum: "5.1".parse()?, minimum: "4.95".parse()? };
/// let coordinate = Figure::bare(Some(limits), "5.0231".parse()?);
/// let log = Log {
///     date: Some(jiff::civil::date(2024, 3, 14)),
///     time: Some(jiff::civil::time(8, 5, 9, 0)),
///     program: Some(r"TNC:\PART1.H".to_owned()),
///     further: vec![Further::measuring_height("-3".parse()?, Unit::Millimetre, Dialogue::En)],
///     ..Log::new(427, vec![coordinate], Unit::Millimetre)
/// };
/// let bytes = log::write(&log, Dialogue::En)?;
/// assert!(bytes.starts_with(b"Measuring log for touch probe cycle 427"));
/// assert_eq!(log::read(&bytes), [Ok(log.printed(Dialogue::En))]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`LogWriteError`] for a log that would not be read back as the same log.
pub fn write(log: &Log, language: Dialogue) -> Result<Vec<u8>, LogWriteError> {
    let bytes = encode(&text(log, language)?);
    reads_back(each(&decode(&bytes)), log, language)?;
    Ok(bytes)
}

/// A file of logs with one more at its end, after a blank line; an empty file gets its first log.
///
/// Whether a control overwrites or adds to a file of the same name is not documented: Fitcheck can do both.
///
/// # Errors
/// As for [`write()`]; [`LogWriteError::Unfinished`] if the file ends within a line, because a figure that was cut off
/// would look whole with text after it.
pub fn append(file: &[u8], log: &Log, language: Dialogue) -> Result<Vec<u8>, LogWriteError> {
    if file.is_empty() {
        return write(log, language);
    }
    if !file.ends_with(b"\n") && !file.ends_with(b"\r") && !file.ends_with(b"\0") {
        return Err(LogWriteError::Unfinished);
    }
    let text = text(log, language)?;
    let mut bytes = file.to_vec();
    bytes.extend_from_slice(LINE_END.as_bytes());
    // Two encodings in one file would damage the words of one of them.
    if !file.is_ascii() && std::str::from_utf8(file).is_ok() {
        bytes.extend_from_slice(text.as_bytes());
    } else {
        bytes.extend(encode(&text));
    }
    let old = decode(file);
    let new = decode(&bytes);
    let is_log =
        |log: &Result<Log, LogError>| !matches!(log, Err(LogError { what: LogFault::Empty | LogFault::NoLog, .. }));
    let mut read = each(&new);
    if each(&old).filter(is_log).any(|log| read.next() != Some(log)) {
        return Err(LogWriteError::ReadsOtherwise);
    }
    reads_back(read, log, language)?;
    Ok(bytes)
}

/// Checks that the only log read back is the one that was written.
fn reads_back(
    mut logs: impl Iterator<Item = Result<Log, LogError>>,
    log: &Log,
    language: Dialogue,
) -> Result<(), LogWriteError> {
    let read = match (logs.next(), logs.next()) {
        (Some(Ok(read)), None) => read,
        (Some(Err(error)), None) => return Err(LogWriteError::Contradiction(error.what)),
        _ => return Err(LogWriteError::ReadsOtherwise),
    };
    let printed = Log { line: read.line, warnings: read.warnings.clone(), ..log.printed(language) };
    if let Some(given) = printed.program.as_ref().filter(|given| read.program.as_ref() != Some(given)) {
        return Err(LogWriteError::Program { given: given.clone() });
    }
    if read != printed {
        return Err(LogWriteError::ReadsOtherwise);
    }
    Ok(())
}

fn text(log: &Log, language: Dialogue) -> Result<String, LogWriteError> {
    text_with(Labels::of(language), log, language)
}

fn text_with(labels: &Labels, log: &Log, language: Dialogue) -> Result<String, LogWriteError> {
    let wrong = LogWriteError::Cycle { cycle: log.cycle };
    let layout = layout(log.cycle).filter(|layout| fits(layout, &log.figures)).ok_or(wrong)?;
    if log.unit == Unit::Micrometre {
        return Err(LogWriteError::Unit);
    }
    let no_title = || LogWriteError::NoTitle { cycle: log.cycle, file: format!("assets/logs/{language}.toml") };
    let title = labels.title(log.cycle).ok_or_else(no_title)?;
    let mut page = Page { text: String::new(), unit: log.unit };
    page.line(title);
    page.line("");
    if log.is_simulated {
        page.line(MARK);
    }
    page.header(log, labels)?;
    page.figures(layout, &log.figures, labels);
    if !log.further.is_empty() {
        page.heading(&labels.further);
        for further in &log.further {
            let further = further.printed(labels);
            page.value(sound(&further.label)?, sound(&further.value)?);
        }
        page.line("");
    }
    page.line(&labels.end);
    Ok(page.text)
}

/// Whether the figures fit a layout: the same number of them, with nominal values where the layout has them.
fn fits(layout: &TextLog, figures: &[Figure]) -> bool {
    let is_fit = |(layout, figure): (&LogFigure, &Figure)| match layout.kind {
        FigureKind::Centre(_) => figure.nominal.is_some() && figure.limits.is_some(),
        FigureKind::Size(_) => figure.nominal.is_some(),
        FigureKind::Coordinate => figure.nominal.is_some() || figure.deviation.is_none(),
        FigureKind::Information => *figure == Figure::bare(None, figure.actual),
    };
    layout.figures.len() == figures.len() && layout.figures.iter().zip(figures).all(is_fit)
}

/// A log's lines.
struct Page {
    text: String,
    unit: Unit,
}

impl Page {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push_str(LINE_END);
    }

    fn heading(&mut self, heading: &str) {
        self.line(&format!("{heading}:"));
    }

    /// A value in its column; a value wider than its column extends to the right.
    fn value(&mut self, label: &str, value: &str) {
        let label = format!("{label}:");
        self.line(&format!("{label:<LABEL_WIDTH$}{value:>VALUE_WIDTH$}"));
    }

    /// A section and the blank line after it.
    fn section<'a>(&mut self, heading: &str, figures: impl IntoIterator<Item = (&'a String, Length)>) {
        self.heading(heading);
        for (label, length) in figures {
            self.value(label, &length.rounded(self.unit, DECIMALS));
        }
        self.line("");
    }

    fn header(&mut self, log: &Log, labels: &Labels) -> Result<(), LogWriteError> {
        if let Some(date) = log.date {
            // Day, month and year as in the maker's log.
            self.line(&format!("{}: {:02}-{:02}-{:04}", labels.date, date.day(), date.month(), date.year()));
        }
        if let Some(time) = log.time {
            // The hour without a leading zero, as in the maker's log.
            self.line(&format!("{}: {}:{:02}:{:02}", labels.time, time.hour(), time.minute(), time.second()));
        }
        if let Some(program) = &log.program {
            self.line(&format!("{}: {}", labels.program, sound(program)?));
        }
        self.line(&format!("{}: {}", labels.unit, u8::from(log.unit == Unit::Inch)));
        self.line("");
        Ok(())
    }

    /// Every section with its figures; the deviations only if all of them are known.
    fn figures(&mut self, layout: &TextLog, figures: &[Figure], labels: &Labels) {
        let not_monitored = LimitPair { maximum: Length::ZERO, minimum: Length::ZERO };
        let named: Vec<_> = layout.figures.iter().map(|figure| labels.figure(figure)).zip(figures).collect();
        let limited = layout.figures.iter().zip(&named).filter(|(figure, _)| figure.is_limited());
        let limited: Vec<_> = limited.map(|(_, named)| *named).collect();
        let nominal: Vec<_> = limited.iter().filter_map(|(words, of)| Some((&words.value, of.nominal?))).collect();
        if !nominal.is_empty() {
            self.section(&labels.nominal, nominal);
        }
        let limits = limited.iter().flat_map(|(words, figure)| {
            let LimitPair { maximum, minimum } = figure.limits.unwrap_or(not_monitored);
            [(&words.maximum, maximum), (&words.minimum, minimum)]
        });
        self.section(&labels.limits, limits);
        self.section(&labels.actual, named.iter().map(|(words, figure)| (&words.value, figure.actual)));
        let deviations: Option<Vec<_>> =
            limited.iter().map(|(words, figure)| Some((&words.value, figure.deviation?))).collect();
        if let Some(deviations) = deviations {
            self.section(&labels.deviations, deviations);
        }
    }
}

/// A text that came from outside and fits on a line in Latin-1.
fn sound(text: &str) -> Result<&str, LogWriteError> {
    match text.chars().find(|&c| c.is_control() || u8::try_from(c).is_err()) {
        None => Ok(text),
        Some(character) => Err(LogWriteError::Character {
            given: text.replace(char::is_control, "\u{fffd}"),
            code: format!("{:04X}", u32::from(character)),
        }),
    }
}

/// Latin-1. Every text in a log is [`sound`]; a test proves the same for the words.
fn encode(text: &str) -> Vec<u8> {
    text.chars().map(|c| u8::try_from(c).unwrap_or(b'?')).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cycle_whose_title_is_missing_says_so_and_in_which_file() {
        let words = fitcheck_shipped::text(fitcheck_shipped::LOGS, "nl.toml");
        let kept: Vec<_> = words.lines().filter(|line| !line.starts_with("427 =")).collect();
        assert_eq!(kept.len() + 1, words.lines().count());
        let labels = toml::from_str(&kept.join("\n")).unwrap();
        let log = Log::new(427, vec![Figure::bare(None, "5.0231".parse().unwrap())], Unit::Millimetre);
        let error = text_with(&labels, &log, Dialogue::Nl).unwrap_err();
        assert_eq!(error.to_string(), "the log of cycle 427 has no title in assets/logs/nl.toml");
    }
}
