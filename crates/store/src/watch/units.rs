//! What a file holds with the lines that each thing takes: a row is one line, a log, a print and a value of AQDEF are several.

use std::collections::BTreeMap;

use fitcheck_core::message::{Located, Message, Say as _, message};
use fitcheck_exchange::exchange::{ImportWarningKind, Item};

/// What was read, and the lines of it.
#[derive(Debug)]
pub(super) struct Units {
    pub(super) items: Vec<Item>,
    /// The last line of what has several lines, by the first one.
    pub(super) lasts: BTreeMap<usize, usize>,
}

impl Units {
    /// The first and the last line of a thing.
    fn lines(&self, item: &Item) -> (usize, usize) {
        let line = line_of(item);
        let unit = self.lasts.range(..=line).next_back().filter(|(_, last)| line <= **last);
        unit.map_or((line, line), |(first, last)| (*first, *last))
    }

    /// The first and the last line of each thing that was measured.
    fn values(&self) -> impl Iterator<Item = (usize, usize)> {
        self.items.iter().filter(|item| is_value(item)).map(|item| self.lines(item))
    }

    /// The last line of what was measured.
    pub(super) fn end(&self) -> usize {
        self.values().map(|(_, last)| last).fold(0, usize::max)
    }

    /// Leaves out the last values, of which the next line may say more. Returns whether there were any.
    pub(super) fn hold_last(&mut self) -> bool {
        let end = self.end();
        let Some(begin) = self.values().filter(|(_, last)| *last == end).map(|(first, _)| first).min() else {
            return false;
        };
        self.items.retain(|item| line_of(item) < begin);
        true
    }

    /// Whether something behind what was measured could not be read: at the end of a file it may be unfinished.
    pub(super) fn is_unfinished(&self) -> bool {
        let end = self.end();
        self.items.iter().any(|item| end < self.lines(item).0 && is_not_read(item))
    }

    /// Keeps only what stands up to a line.
    pub(super) fn up_to(&mut self, line: usize) {
        self.items.retain(|item| line_of(item) <= line);
    }

    /// Keeps only what stands behind a line.
    pub(super) fn behind(&mut self, line: usize) {
        self.items.retain(|item| line < line_of(item));
    }

    /// Whether a thing of several lines begins with a line: nothing can have been taken from that line alone.
    pub(super) fn begin_with(&self, line: usize) -> bool {
        self.lasts.get(&line).is_some_and(|last| line < *last)
    }

    /// How many values end in the first lines.
    pub(super) fn count(&self, lines: usize) -> usize {
        self.values().filter(|(_, last)| *last <= lines).count()
    }

    /// Whether one of the values ends in a line.
    pub(super) fn has_value_at(&self, line: usize) -> bool {
        self.values().any(|(_, last)| last == line)
    }

    /// That lines behind the first ones add to values which end there: those were taken too early.
    pub(super) fn late(&self, lines: usize) -> Option<Message> {
        let (first, last) = self.lasts.range(..=lines).find(|(_, last)| lines < **last)?;
        Some(message!("watch-late").text("first", first).text("last", last))
    }

    /// What is to be said of the things that are no checks.
    pub(super) fn problems(&self) -> Vec<Message> {
        let problem = |item: &Item| match item {
            Item::Record { .. } | Item::Contacts(_) => None,
            Item::Warning(warning) => {
                (warning.what.row.is_none() && warning.what.kind.is_loss()).then(|| warning.message())
            }
            Item::Error(error) => Some(error.message()),
            Item::Unjudged(unjudged) => Some(Located::in_line(unjudged.line, unjudged.why.clone()).message()),
        };
        self.items.iter().filter_map(problem).collect()
    }
}

/// Whether a thing was measured.
pub(super) const fn is_value(item: &Item) -> bool {
    matches!(item, Item::Record { .. } | Item::Unjudged(_))
}

/// Whether a part of a file could not be read.
fn is_not_read(item: &Item) -> bool {
    match item {
        Item::Error(_) => true,
        Item::Warning(warning) => matches!(warning.what.kind, ImportWarningKind::NotUsed { .. }),
        Item::Record { .. } | Item::Unjudged(_) | Item::Contacts(_) => false,
    }
}

/// The line of a thing in its file.
fn line_of(item: &Item) -> usize {
    match item {
        Item::Record { line, .. } => *line,
        Item::Unjudged(unjudged) => unjudged.line,
        Item::Error(error) => error.place.line.unwrap_or(usize::MAX),
        Item::Warning(warning) => warning.what.row.or(warning.place.line).unwrap_or(usize::MAX),
        Item::Contacts(_) => usize::MAX,
    }
}
