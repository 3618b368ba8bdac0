//! The lines of a log as header, sections and pairs of label and number.
//!
//! Labels are never interpreted, only distinguished from numbers: they follow the control's dialogue language.

use std::collections::BTreeSet;
use std::path::Path;

use fitcheck_core::length::Unit;
use fitcheck_core::message::{FilePlace, Located};
use jiff::civil::{Date, Time};

use super::error::{LONGEST_LINE, LogError, LogFault, LogWarning, LogWarningKind, MOST_LINES};
use crate::control::simulated::is_mark;

/// The measuring cycles whose number marks a title line.
const CYCLES: std::ops::RangeInclusive<u16> = 420..=431;

/// The first line of a log.
#[derive(Debug)]
pub(super) struct Title {
    pub(super) line: usize,
    pub(super) cycle: u16,
    pub(super) text: String,
}

/// The lines of one log.
#[derive(Debug, Default)]
pub(super) struct Chunk {
    pub(super) title: Option<Title>,
    /// The lines after the title that are not blank, up to [`MOST_LINES`].
    lines: Vec<(usize, String)>,
    /// Whether there are more of them, or one is longer than [`LONGEST_LINE`].
    pub(super) is_too_long: bool,
    /// Whether one of them is the mark of a simulation, which is none of them.
    pub(super) is_simulated: bool,
    /// How many of them hold a figure after a label.
    figures: usize,
    /// Which of them may go on: the last one of a file that ends without a line end, and those that byte 0 ends.
    open: BTreeSet<usize>,
}

/// A figure, or another text, and its label.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair<'a> {
    pub(super) line: usize,
    /// Column of the value in characters, from 1.
    pub(super) column: usize,
    pub(super) label: &'a str,
    pub(super) given: &'a str,
}

impl Pair<'_> {
    pub(super) fn wrong(&self, what: LogFault) -> LogError {
        Located { what, place: FilePlace::in_line(self.line, self.column) }
    }

    fn ignored(&self) -> LogWarning {
        let text = format!("{}: {}", self.label, self.given);
        Located::in_line(self.line, LogWarningKind::Ignored { text })
    }
}

/// Pairs under a heading; the first section has the title as its heading.
#[derive(Debug)]
pub(super) struct Section<'a> {
    pub(super) line: usize,
    pub(super) pairs: Vec<Pair<'a>>,
}

/// What the header contains.
#[derive(Debug, Default)]
pub(super) struct Header {
    pub(super) date: Option<Date>,
    pub(super) time: Option<Time>,
    pub(super) program: Option<String>,
    pub(super) unit: Option<Unit>,
}

enum Line<'a> {
    Title(u16),
    Label { label: &'a str, value: &'a str },
    Value,
    Text,
}

/// Cuts lines into logs: each begins at a title, or where a second date shows that a title is missing.
#[derive(Debug, Default)]
pub(super) struct Chunks {
    /// What was read so far of the next log.
    chunk: Chunk,
    /// Whether the line before is a label that waits for its value.
    waits: bool,
}

impl Chunks {
    /// Takes a line, and gives the log that ends before it. `is_open` is whether it may go on.
    pub(super) fn line(&mut self, number: usize, line: &str, is_open: bool) -> Option<Chunk> {
        let line = line.trim_end();
        let bare = line.trim_start();
        if bare.is_empty() {
            return None;
        }
        if LONGEST_LINE < line.len() {
            self.chunk.is_too_long = true;
            self.waits = false;
            return None;
        }
        if is_mark(bare) {
            self.chunk.is_simulated = true;
            return None;
        }
        let kind = classify(bare);
        let value = match kind {
            Line::Label { value, .. } => value,
            Line::Value if self.waits => bare,
            Line::Value | Line::Title(_) | Line::Text => "",
        };
        self.waits = matches!(kind, Line::Label { value: "", .. });
        if let Line::Title(cycle) = kind {
            let title = Some(Title { line: number, cycle, text: bare.to_owned() });
            return std::mem::replace(&mut self.chunk, Chunk { title, ..Chunk::default() }).if_any();
        }
        // A date after the nominal values: the title between two logs is damaged.
        let is_lost = date(value).is_some() && 3 <= self.chunk.figures;
        let before = is_lost.then(|| std::mem::take(&mut self.chunk));
        self.chunk.add(number, line, value, is_open);
        before.and_then(Chunk::if_any)
    }

    /// The log that ends with the text.
    pub(super) fn end(&mut self) -> Option<Chunk> {
        std::mem::take(&mut self.chunk).if_any()
    }
}

impl Chunk {
    /// It, if it has anything.
    fn if_any(self) -> Option<Self> {
        (self.title.is_some() || !self.lines.is_empty() || self.is_too_long || self.is_simulated).then_some(self)
    }

    /// Adds a line that is not blank, with the value that it has after a label.
    fn add(&mut self, number: usize, line: &str, value: &str, is_open: bool) {
        self.figures += usize::from(is_number(value));
        if self.lines.len() < MOST_LINES {
            self.lines.push((number, line.to_owned()));
            self.open.extend(is_open.then_some(number));
        } else {
            self.is_too_long = true;
        }
    }

    /// Whether there are labels with figures: more than one or two lines by chance.
    pub(super) const fn has_figures(&self) -> bool {
        3 <= self.figures
    }

    pub(super) fn first_line(&self) -> Option<usize> {
        self.lines.first().map(|(line, _)| *line)
    }

    /// The last line that is not blank, or the line of the title.
    pub(super) fn last_line(&self) -> usize {
        let title = self.title.as_ref().map_or(1, |title| title.line);
        self.lines.last().map_or(title, |(line, _)| *line)
    }

    /// Whether the file may end within this line.
    pub(super) fn ends_within(&self, line: usize) -> bool {
        self.open.contains(&line)
    }

    /// Labels with their values, on the same line or the next. A label without a value is a heading.
    pub(super) fn sections(&self, warnings: &mut Vec<LogWarning>) -> Result<Vec<Section<'_>>, LogError> {
        let title = self.title.as_ref().map_or(1, |title| title.line);
        let mut sections = vec![Section { line: title, pairs: Vec::new() }];
        let mut open: Option<(usize, &str)> = None;
        for (line, text) in &self.lines {
            let line = *line;
            let bare = text.trim_start();
            let column = |value: &str| text.chars().count().saturating_sub(value.chars().count()) + 1;
            let pair = match classify(bare) {
                Line::Label { label, value } => {
                    if let Some((line, _heading)) = open.take() {
                        sections.push(Section { line, pairs: Vec::new() });
                    }
                    if value.is_empty() {
                        open = Some((line, label));
                        continue;
                    }
                    if let Line::Label { label, value } = classify(value)
                        && label.starts_with(char::is_alphabetic)
                        && is_number(value)
                    {
                        // A heading and its first figure on one line.
                        let pair = Pair { line, column: column(value), label, given: value };
                        sections.push(Section { line, pairs: vec![pair] });
                        continue;
                    }
                    Pair { line, column: column(value), label, given: value }
                }
                Line::Value => {
                    let Some((_, label)) = open.take() else {
                        return Err(LogFault::NoLabel { given: bare.to_owned() }.at(line));
                    };
                    Pair { line, column: column(bare), label, given: bare }
                }
                Line::Title(_) | Line::Text => {
                    if bare.contains(|c: char| c.is_ascii_digit()) {
                        warnings.push(Located::in_line(line, LogWarningKind::Ignored { text: bare.to_owned() }));
                    }
                    open = None;
                    sections.push(Section { line, pairs: Vec::new() });
                    continue;
                }
            };
            if let Some(section) = sections.last_mut() {
                section.pairs.push(pair);
            }
        }
        Ok(sections)
    }
}

/// Takes date, time, program and unit out of the sections; nothing else of the first section is needed if another one
/// has pairs.
pub(super) fn take_header(sections: &mut [Section<'_>], warnings: &mut Vec<LogWarning>) -> Result<Header, LogError> {
    let mut header = Header::default();
    let mut wrong = None;
    for section in sections.iter_mut() {
        section.pairs.retain(|pair| match header.take(pair, warnings) {
            Ok(taken) => !taken,
            Err(error) => {
                wrong.get_or_insert(error);
                true
            }
        });
    }
    if let Some(error) = wrong {
        return Err(error);
    }
    if let Some((first, others)) = sections.split_first_mut()
        && others.iter().any(|section| !section.pairs.is_empty())
    {
        warnings.extend(first.pairs.drain(..).map(|pair| pair.ignored()));
    }
    Ok(header)
}

impl Header {
    /// Whether the pair belongs to the header. A repeated entry, or an impossible day or time, gives a warning.
    fn take(&mut self, pair: &Pair<'_>, warnings: &mut Vec<LogWarning>) -> Result<bool, LogError> {
        let mut odd = || warnings.push(pair.ignored());
        if is_unit_label(pair.label) {
            let unit = match pair.given {
                "0" => Some(Unit::Millimetre),
                "1" => Some(Unit::Inch),
                _ => None,
            };
            if unit.is_none() || self.unit.is_some() && self.unit != unit {
                return Err(pair.wrong(LogFault::Unit { given: pair.given.to_owned() }));
            }
            self.unit = unit;
        } else if let Some(date) = date(pair.given) {
            match date {
                Ok(date) if self.date.is_none() => self.date = Some(date),
                _ => odd(),
            }
        } else if let Some(time) = time(pair.given) {
            match time {
                Ok(time) if self.time.is_none() => self.time = Some(time),
                _ => odd(),
            }
        } else if is_program(pair.given) {
            if self.program.is_none() {
                self.program = Some(pair.given.to_owned());
            } else {
                odd();
            }
        } else {
            return Ok(false);
        }
        Ok(true)
    }
}

fn classify(line: &str) -> Line<'_> {
    let begins_with_digit = line.trim_start_matches(['+', '-', '\u{2212}']).starts_with(|c: char| c.is_ascii_digit());
    if begins_with_digit && (time(line).is_some() || !line.contains(':')) || is_path(line) {
        return Line::Value;
    }
    if let Some((label, value)) = line.split_once(':') {
        return Line::Label { label: label.trim_end(), value: value.trim() };
    }
    title_cycle(line).map_or(Line::Text, Line::Title)
}

/// The number of a measuring cycle in a line of words without `:`.
fn title_cycle(line: &str) -> Option<u16> {
    // A row of a table is not a title.
    if line.contains([':', ';', '|', '\t']) || !line.contains(char::is_alphabetic) {
        return None;
    }
    // A point or an underscore would make it a number such as 425.0000 or a file name; letters other than ASCII's may
    // be next to it, because some languages have no blanks.
    line.split(|c: char| !(c.is_ascii_alphanumeric() || ".,_\\".contains(c)))
        .filter(|word| word.len() == 3)
        .filter_map(|word| word.parse().ok())
        .find(|cycle| CYCLES.contains(cycle))
}

/// `Type of dimension (0 = MM / 1 = INCH)` in any language.
fn is_unit_label(label: &str) -> bool {
    label.contains("(0 =") || label.contains("(0=")
}

/// A path on its own line: `TNC:\PART.H`.
fn is_path(line: &str) -> bool {
    line.split_once(":\\")
        .is_some_and(|(drive, _)| !drive.is_empty() && drive.bytes().all(|b| b.is_ascii_alphanumeric()))
}

fn is_program(value: &str) -> bool {
    let ending = Path::new(value).extension();
    value.contains(":\\") || ending.is_some_and(|end| end.eq_ignore_ascii_case("h") || end.eq_ignore_ascii_case("i"))
}

fn is_number(value: &str) -> bool {
    fitcheck_core::length::Length::parse_in(value, Unit::Millimetre).is_ok()
}

/// Looks like a day or time, but does not exist.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct NoSuchTime;

/// Three numbers with the same sign between them.
fn date(value: &str) -> Option<Result<Date, NoSuchTime>> {
    ['-', '.', '/'].into_iter().find_map(|sign| {
        let [day, month, year] = three(value, sign)?;
        let day = day.parse().ok().zip(month.parse().ok()).zip(year.parse().ok().filter(|year| 1000 <= *year));
        Some(day.and_then(|((day, month), year)| Date::new(year, month, day).ok()).ok_or(NoSuchTime))
    })
}

/// Hours, minutes and seconds.
fn time(value: &str) -> Option<Result<Time, NoSuchTime>> {
    let [hour, minute, second] = three(value, ':')?;
    let time = hour.parse().ok().zip(minute.parse().ok()).zip(second.parse().ok());
    Some(time.and_then(|((hour, minute), second)| Time::new(hour, minute, second, 0).ok()).ok_or(NoSuchTime))
}

fn three(value: &str, sign: char) -> Option<[&str; 3]> {
    let mut parts = value.split(sign);
    let three = [parts.next()?, parts.next()?, parts.next()?];
    let sound = |part: &&str| !part.is_empty() && part.len() <= 4 && part.bytes().all(|byte| byte.is_ascii_digit());
    (parts.next().is_none() && three.iter().all(sound)).then_some(three)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_are_told_by_the_number_of_a_cycle() {
        for (line, cycle) in [
            ("Measuring log for touch probe cycle 421 Hole measuring", Some(421)),
            ("Messzyklus-427", Some(427)),
            ("测头循环422测量", Some(422)),
            ("Measuring log for cycle 419", None),
            ("Measuring log end", None),
            ("421.0000", None),
            ("TCHPR421.TXT", None),
            ("bore 421;25 H7;25.012", None),
            ("Diameter of 421: 25", None),
        ] {
            assert_eq!(title_cycle(line), cycle, "{line}");
        }
    }

    #[test]
    fn days_and_times_are_told_from_numbers() {
        assert_eq!(date("30-06-2005"), Some(Ok(Date::constant(2005, 6, 30))));
        assert_eq!(date("1.2.2024"), Some(Ok(Date::constant(2024, 2, 1))));
        assert_eq!(date("14/03/2024"), Some(Ok(Date::constant(2024, 3, 14))));
        assert_eq!(date("31-02-2024"), Some(Err(NoSuchTime)));
        assert_eq!(date("25.0134"), None);
        assert_eq!(date("-22.5000"), None);
        assert_eq!(time("6:55:04"), Some(Ok(Time::constant(6, 55, 4, 0))));
        assert_eq!(time("25:00:00"), Some(Err(NoSuchTime)));
        assert_eq!(time("6:55"), None);
    }
}
