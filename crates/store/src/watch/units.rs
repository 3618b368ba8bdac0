//! What a file holds with the lines that each thing takes: a row is one line, a log, a print and a value of AQDEF are several.

use std::collections::BTreeMap;

use fitcheck_core::message::{Located, Message, Say as _};
use fitcheck_exchange::exchange::{ImportWarningKind, Item};

/// What was read, and the lines of it.
#[derive(Debug, Default)]
pub(super) struct Units {
    pub(super) items: Vec<Item>,
    /// The last line of what has several lines, by the first one.
    lasts: BTreeMap<usize, usize>,
}

impl Units {
    pub(super) const fn new(items: Vec<Item>, lasts: BTreeMap<usize, usize>) -> Self {
        Self { items, lasts }
    }

    /// The first and the last line of a thing.
    fn lines(&self, item: &Item) -> (usize, usize) {
        let line = line_of(item);
        let unit = self.lasts.range(..=line).next_back().filter(|(_, last)| line <= **last);
        unit.map_or((line, line), |(first, last)| (*first, *last))
    }

    /// The last line of what was measured.
    pub(super) fn end(&self) -> usize {
        let values = self.items.iter().filter(|item| is_value(item));
        values.map(|item| self.lines(item).1).max().unwrap_or_default()
    }

    /// Leaves out the last values, which another line may say more of; whether there were any.
    pub(super) fn hold_last(&mut self) -> bool {
        let last = self.end();
        let values = self.items.iter().filter(|item| is_value(item)).map(|item| self.lines(item));
        let Some(first) = values.filter(|(_, end)| *end == last).map(|(first, _)| first).min() else { return false };
        self.items.retain(|item| line_of(item) < first);
        true
    }

    /// Whether something behind what was measured could not be read: at the end of a file it may be unfinished.
    pub(super) fn is_unfinished(&self) -> bool {
        let end = self.end();
        self.items.iter().any(|item| end < self.lines(item).0 && is_not_read(item))
    }

    /// Leaves what stands up to a line.
    pub(super) fn up_to(&mut self, end: usize) {
        let Self { items, lasts } = std::mem::take(self);
        let kept: Vec<Item> = items.into_iter().filter(|item| line_of(item) <= end).collect();
        *self = Self { items: kept, lasts };
    }

    /// Whether a thing of several lines begins with a line: nothing can have been taken from that line alone.
    pub(super) fn begin_with(&self, line: usize) -> bool {
        self.lasts.get(&line).is_some_and(|last| line < *last)
    }

    /// How many values end in the first lines.
    pub(super) fn count(&self, lines: usize) -> usize {
        self.items.iter().filter(|item| is_value(item) && self.lines(item).1 <= lines).count()
    }

    /// The values that were taken from the first lines, and of which later ones say more: the first and the last line.
    pub(super) fn late(&self, lines: usize) -> Option<(usize, usize)> {
        let mut late = self.lasts.range(..=lines).filter(|(_, last)| lines < **last);
        let (first, last) = late.next()?;
        Some((*first, *last))
    }

    /// Leaves what begins behind the first lines.
    pub(super) fn behind(mut self, lines: usize) -> Self {
        self.items.retain(|item| lines < line_of(item));
        self
    }

    /// Whether one of the values ends in a line.
    pub(super) fn has_value_at(&self, line: usize) -> bool {
        self.items.iter().any(|item| is_value(item) && self.lines(item).1 == line)
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

/// What is to be said of a thing that is no check.
pub(super) fn problem(item: &Item) -> Option<Message> {
    match item {
        Item::Record { .. } | Item::Contacts(_) => None,
        Item::Warning(warning) => {
            (warning.what.row.is_none() && warning.what.kind.is_loss()).then(|| warning.message())
        }
        Item::Error(error) => Some(error.message()),
        Item::Unjudged(unjudged) => Some(Located::in_line(unjudged.line, unjudged.why.clone()).message()),
    }
}
