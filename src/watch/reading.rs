//! What of a file is taken now: the units of it that are complete and new.
//!
//! A unit is a row, a log, a print, the values of a part. Whether the last one of a growing file is complete is known by what follows it: what
//! cannot be read at the end may be half a unit, so a file is known up to its last unit that could be read, and the rest is read again when
//! there is more of it.

use std::fs::File;
use std::io::{Read as _, Seek as _};

use super::folder::Found;
use super::known::{Extent, Known, Mark, until};
use super::part::Beginning;
use super::{Batch, Judging, Look, PATIENCE, Waiting};
use crate::exchange::{
    ByPlan, FirstRows, Given, ImportWarningKind, Item, MOST_ROWS, Mapping, WHOLE, import_from, recognised,
};
use crate::files::{self, FileError};
use crate::message::{Located, Message, Say as _};

/// The most lines of a growing file that are taken at once: a look keeps them in memory.
const MOST_LINES: usize = 50_000;

/// A file that is looked into.
struct Reading<'a> {
    file: &'a File,
    found: &'a Found,
    judging: Judging<'a>,
    line_ends: &'static [u8],
    extent: &'a Extent,
    is_patient: bool,
}

/// Looks into a file; `None` where nothing of it is new, or it is gone. What is the same as another file is told to `look`.
pub(super) fn read(
    found: &Found,
    judging: Judging<'_>,
    known: &mut Known,
    is_young: bool,
    look: &mut Look,
) -> Result<Option<Batch>, Waiting> {
    let file = match files::open(&found.path) {
        Ok((file, _)) => file,
        Err(FileError::Missing { .. }) => return Ok(None),
        Err(error) => return Err(Waiting::Locked { reason: error.to_string() }),
    };
    let is_patient = PATIENCE <= found.quiet;
    let locked = |error: std::io::Error| Waiting::Locked { reason: error.to_string() };
    let mut body = &file;
    let format = recognised(&found.name, &mut body, judging.masks).map_err(locked)?;
    // What shows nothing of its end may be cut off anywhere, also where it can be read.
    if format.is_some_and(|format| !format.shows_end) && !is_patient && !found.is_closed {
        return Err(Waiting::Written);
    }
    let line_ends = format.map_or(b"".as_slice(), |format| format.line_ends);
    let extent = known.extent(&found.name, &mut body, line_ends, MOST_LINES).map_err(locked)?;
    let of_same = |look: &mut Look, other: &str| look.same.push((found.name.clone(), other.to_owned()));
    if extent.is_known {
        let other = known.name_of(&extent.whole.hash).filter(|other| !other.is_empty());
        match other {
            Some(other) if other != found.name || found.was_done => of_same(look, other),
            _ => {}
        }
        return Ok(None);
    }
    // A program that writes a file anew has not come to its new lines yet; and one that did before this began is not known.
    let is_written_anew = !line_ends.is_empty() && (extent.is_cut || is_young && is_another(known, found, &extent));
    if is_written_anew && !is_patient {
        return Err(Waiting::Written);
    }
    if extent.is_cut && !line_ends.is_empty() {
        of_same(look, &found.name);
        return Ok(None);
    }
    let masks = if format.is_some_and(crate::exchange::Format::is_print) { judging.masks } else { &[] };
    let judging = Judging { masks, ..judging };
    let reading = Reading { file: &file, found, judging, line_ends, extent: &extent, is_patient };
    let batch = reading.batch()?;
    // What changed while it was read may be half old and half new.
    if !found.is_unchanged() {
        return Err(Waiting::Written);
    }
    known.add_lines(&found.name, &extent);
    Ok(Some(batch))
}

/// Whether a file of this name had other lines at its beginning.
fn is_another(known: &Known, found: &Found, extent: &Extent) -> bool {
    known.is_from_before(&found.name) && extent.known_lines == 0
}

impl Reading<'_> {
    /// What is taken now, from the shortest beginning of the file that has something to take.
    fn batch(&self) -> Result<Batch, Waiting> {
        let Extent { whole, lines, part, known_end, .. } = self.extent;
        if self.line_ends.is_empty() {
            return self.of_whole();
        }
        // A last line without its end may be half a number.
        let tail = (self.is_patient && lines.end < whole.end).then_some(*whole);
        let ends = part.iter().copied().chain([*lines]).chain(tail).filter(|end| *known_end < end.end);
        for end in ends {
            if let Some(batch) = self.up_to(end) {
                return Ok(batch);
            }
        }
        Err(Waiting::Written)
    }

    /// A file that does not grow: what cannot be read may be unfinished, and cannot be told from what is broken but by waiting.
    fn of_whole(&self) -> Result<Batch, Waiting> {
        let all = self.read_all(self.extent.whole);
        if !self.is_patient && all.iter().any(|item| matches!(item, Item::Error(_))) {
            return Err(Waiting::Written);
        }
        Ok(self.made(all, self.extent.whole, false))
    }

    /// The beginning of a file that may grow; `None` where nothing of it is both complete and new.
    fn up_to(&self, end: Mark) -> Option<Batch> {
        let all = self.read_all(end);
        let last = all.iter().filter(|item| is_value(item)).map(line_of).max().unwrap_or_default();
        let is_unfinished = |item: &Item| last < line_of(item) && is_not_read(item);
        if !all.iter().any(is_unfinished) {
            return Some(self.made(all, end, end.end < self.extent.whole.end));
        }
        let is_final = self.is_patient && end.end == self.extent.whole.end;
        let has_new = self.extent.known_lines < last;
        if !is_final && !has_new {
            return None;
        }
        // The file is known up to what could be read.
        let mark = until(&mut &*self.file, self.line_ends, last).ok().flatten().filter(|_| 0 < last).unwrap_or(end);
        let all = if is_final { all } else { all.into_iter().filter(|item| line_of(item) <= last).collect() };
        Some(self.made(all, mark, !is_final))
    }

    /// Of all that was read the new things, and what is to be said of the whole.
    fn made(&self, all: Vec<Item>, Mark { hash: sha256, .. }: Mark, is_open: bool) -> Batch {
        let Extent { known_lines, same_lines, begins_as, .. } = self.extent;
        // A note tells of the whole file, also of what was taken before.
        let problems: Vec<Message> = all.iter().filter_map(problem).collect();
        let is_new = |item: &Item| *known_lines == 0 || *known_lines < line_of(item);
        let items: Vec<Item> = all.into_iter().filter(is_new).collect();
        let up_to = |line: usize| items.iter().filter(|item| is_value(item) && line_of(item) <= line).count();
        let again = if *known_lines == 0 { up_to(*same_lines) } else { 0 };
        let again = (0 < again).then(|| Message::new("watch-again").count("count", again));
        let as_other = begins_as.as_ref().map(|(known, lines)| (known, up_to(*lines))).filter(|(_, count)| 0 < *count);
        let as_other =
            as_other.map(|(known, count)| Message::new("watch-begins-as").text("known", known).count("count", count));
        Batch {
            path: self.found.path.clone(),
            name: self.found.name.clone(),
            sha256,
            has_values: items.iter().any(is_value),
            items,
            problems,
            remarks: again.into_iter().chain(as_other).collect(),
            found: self.found.clone(),
            is_open,
        }
    }

    /// What the first bytes of the file hold, judged by the plan.
    fn read_all(&self, end: Mark) -> Vec<Item> {
        let Judging { plan, sources, masks, now, .. } = self.judging;
        let beside = |ending: &str| files::beside(&self.found.path, ending);
        let (mapping, has_plan) = (self.remembered(end), plan.is_some());
        let mapping = mapping.as_ref();
        let given =
            Given { beside: &beside, masks, mapping, most_rows: MOST_ROWS, has_plan, ..Given::new(sources, now) };
        let (mut items, mut by_plan) = (Vec::new(), plan.map(ByPlan::new));
        import_from(&self.found.name, &mut Beginning::new(self.file, end.end), given, &mut |item| match &mut by_plan {
            Some(by_plan) => by_plan.item(item, &mut |item| items.push(item)),
            None => items.push(item),
        });
        items
    }

    /// The columns of the file as the user corrected them for files of its shape.
    fn remembered(&self, end: Mark) -> Option<Mapping> {
        let columns = self.judging.columns.filter(|columns| !columns.is_empty() && self.judging.masks.is_empty())?;
        let (mut body, mut bytes) = (Beginning::new(self.file, end.end), Vec::new());
        body.rewind().ok()?;
        body.take(WHOLE).read_to_end(&mut bytes).ok()?;
        let first = FirstRows::of(&self.found.name, &bytes)?;
        columns.find(&first).map(|(.., mapping)| mapping)
    }
}

/// Whether a thing was measured.
const fn is_value(item: &Item) -> bool {
    matches!(item, Item::Record { .. } | Item::Unjudged(_))
}

/// Whether a part of a file could not be read: at its end it may be unfinished.
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
fn problem(item: &Item) -> Option<Message> {
    match item {
        Item::Record { .. } | Item::Contacts(_) => None,
        Item::Warning(warning) => {
            (warning.what.row.is_none() && warning.what.kind.is_loss()).then(|| warning.message())
        }
        Item::Error(error) => Some(error.message()),
        Item::Unjudged(unjudged) => Some(Located::in_line(unjudged.line, unjudged.why.clone()).message()),
    }
}
