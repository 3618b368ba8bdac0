//! What of a file is taken now: the units of it that are complete and new.
//!
//! A unit is a row, a log, a print, the values of a part. Whether the last one of a growing file is complete is known by what follows it: what
//! cannot be read at the end may be half a unit, so a file is known up to the end of its last unit that could be read, and the rest is read
//! again when there is more of it.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Read as _, Seek as _, Take};

use fitcheck_core::message::{Message, message};
use fitcheck_exchange::exchange::{
    ByPlan, FirstRows, ImportInputs, Item, MOST_ROWS, Mapping, WHOLE, import_from, recognised,
};
use fitcheck_files::{self as files, FileError};

use super::folder::{FoundFile, Stage};
use super::known::{Extent, FileStanding, TakenFiles, TakenLines};
use super::lines::{Mark, until};
use super::units::{Units, is_value};
use super::{Batch, FileJudging, PATIENCE, Waiting, note};

/// The most lines of a growing file that are taken at once: a look keeps them in memory.
const MOST_LINES: usize = 50_000;

/// How the CSV of verdicts begins that Fitcheck itself writes: nothing of it was measured again.
const VERDICTS: &[u8] = b"file,line,id,callout,nominal_mm,";

/// Why nothing of a file is taken.
#[derive(Debug)]
pub(super) enum Nothing {
    Yet(Waiting),
    /// Nothing is left to take of it as it is.
    Left {
        /// The name under which its content was taken, where that is told.
        same: Option<String>,
        /// What its note says now, where that may have changed.
        note: Option<Vec<Message>>,
    },
}

/// It is waited for: its writer may not be done with it.
const WAIT: Nothing = Nothing::Yet(Waiting::Written);

impl From<io::Error> for Nothing {
    fn from(error: io::Error) -> Self {
        Self::Yet(Waiting::Locked { reason: error.to_string() })
    }
}

/// A file that is looked into.
struct Reading<'a> {
    file: &'a File,
    found: &'a FoundFile,
    judging: FileJudging<'a>,
    line_ends: &'static [u8],
    /// Whether a value that is cut off cannot be read: then each one that can be read is complete.
    shows_end: bool,
    extent: Extent,
    /// What was said of values that were taken too early.
    late: Vec<Message>,
}

/// Looks into a file: what is ready of it.
pub(super) fn read(
    found: &FoundFile,
    judging: FileJudging<'_>,
    known: &mut TakenFiles,
    is_young: bool,
) -> Result<Batch, Nothing> {
    let file = match files::open(&found.path) {
        Ok((file, _)) => file,
        Err(FileError::Missing { .. }) => return Err(Nothing::Left { same: None, note: None }),
        Err(error) => return Err(Nothing::Yet(Waiting::Locked { reason: error.to_string() })),
    };
    let mut body = &file;
    let format = recognised(&found.name, &mut body, judging.masks)?;
    let shows_end = format.is_none_or(|format| format.shows_end);
    let line_ends = format.map_or(b"".as_slice(), |format| format.line_ends);
    let judging = FileJudging { masks: format.map_or(&[], |format| format.masks_of(judging.masks)), ..judging };
    if bytes(&file, VERDICTS.len().try_into().unwrap_or(u64::MAX))? == VERDICTS {
        return Err(Nothing::Left { same: None, note: Some(vec![message!("watch-verdicts")]) });
    }
    // What shows nothing of its end may be cut off anywhere, also where it can be read.
    if !shows_end && line_ends.is_empty() && found.stage() < Stage::Settled {
        return Err(WAIT);
    }
    let extent = known.extent(&found.name, &mut body, line_ends, MOST_LINES)?;
    let late = if extent.known.lines == 0 { Vec::new() } else { known.past(&found.name).late.clone() };
    let reading = Reading { file: &file, found, judging, line_ends, shows_end, extent, late };
    let is_quiet = PATIENCE <= found.quiet;
    match &reading.extent.standing {
        FileStanding::Known(name) if !name.is_empty() && *name != found.name => {
            let note = vec![message!("watch-copy").text("known", name)];
            Err(Nothing::Left { same: Some(name.clone()), note: Some(note) })
        }
        FileStanding::Known(_) => Err(reading.same(found.was_done)?),
        // A program that writes a file anew has not come to its new lines yet; and one that did before this began is not known.
        FileStanding::Cut | FileStanding::CutWithinLine if !is_quiet => Err(WAIT),
        FileStanding::Another if is_young && !is_quiet => Err(WAIT),
        FileStanding::Cut => Err(reading.same(true)?),
        FileStanding::CutWithinLine if found.stage() < Stage::Final => Err(WAIT),
        _ => {
            let batch = reading.batch()?;
            // What changed while it was read may be half old and half new.
            if found.is_unchanged() { Ok(batch) } else { Err(WAIT) }
        }
    }
}

/// A file up to a byte: what is written behind it meanwhile is not seen.
fn beginning(mut file: &File, end: u64) -> io::Result<Take<&File>> {
    file.rewind()?;
    Ok(file.take(end))
}

/// The first bytes of a file, at most this many.
fn bytes(file: &File, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    beginning(file, most)?.read_to_end(&mut bytes)?;
    Ok(bytes)
}

impl Reading<'_> {
    /// Nothing of it is new; `is_told` is whether people are told that it was written again.
    fn same(&self, is_told: bool) -> Result<Nothing, Nothing> {
        // A note that is older than the file may tell of what the file held before.
        let written = note::written(&self.found.path);
        let is_noted = written.is_some_and(|written| self.found.was_done || Some(written) < self.found.changed());
        let note = if is_noted { Some(self.read_to(self.extent.whole)?.problems()) } else { None };
        Ok(Nothing::Left { same: is_told.then(|| self.found.name.clone()), note })
    }

    /// What is taken now, from the shortest beginning of the file that has something to take.
    fn batch(&self) -> Result<Batch, Nothing> {
        let Extent { whole, lines, part, known, .. } = &self.extent;
        let stage = self.found.stage();
        if self.line_ends.is_empty() {
            let all = self.read_to(*whole)?;
            // What cannot be read may be unfinished, and cannot be told from what is broken but by waiting.
            if stage < Stage::Final && all.items.iter().any(|item| matches!(item, Item::Error(_))) {
                return Err(WAIT);
            }
            return Ok(self.made(all, *whole, false));
        }
        let has_tail = lines.end < whole.end;
        // A last line without its end may be half a number.
        let tail = (has_tail && stage == Stage::Final).then_some(*whole);
        // Where a last line without its end may belong to the value before it, both are read together.
        let lines = (self.shows_end || tail.is_none()).then_some(*lines);
        let may_go_on = stage < Stage::Settled || has_tail && tail.is_none();
        let ends: Vec<Mark> = part.iter().copied().chain(lines).chain(tail).collect();
        for (at, end) in (1..).zip(&ends).filter(|(_, end)| known.end < end.end) {
            let is_last = at == ends.len();
            // The last values wait for what may still be said of them.
            let mut all = self.read_to(*end)?;
            let is_held = !self.shows_end && (may_go_on || !is_last) && all.hold_last();
            if !is_held && !all.is_unfinished() {
                return Ok(self.made(all, *end, end.end < whole.end));
            }
            // Where it stays unfinished for long, people are told, and nothing more is waited for.
            let is_final = !is_held && is_last && self.found.is_told();
            let last = all.end();
            if !is_final && last <= self.known_lines(&all) {
                continue;
            }
            // The file is known up to what could be read; its last line may have no end.
            let mark = until(&mut beginning(self.file, end.end)?, self.line_ends, last)?;
            if let Some(mark) = mark.or((is_final || last == end.lines).then_some(*end)) {
                if !is_final {
                    all.up_to(last);
                }
                return Ok(self.made(all, mark, !is_final));
            }
        }
        Err(WAIT)
    }

    /// How many lines at the beginning of the file were taken before. Nobody takes the first line of a log or a print alone.
    fn known_lines(&self, all: &Units) -> usize {
        let lines = self.extent.known.lines;
        if self.shows_end && all.begin_with(lines) { 0 } else { lines }
    }

    /// The batch of what was read: what is new of it, and what is to be said of all of it.
    fn made(&self, mut all: Units, mark: Mark, is_open: bool) -> Batch {
        let Extent { standing, same_lines, begins_as, .. } = &self.extent;
        let known_lines = self.known_lines(&all);
        // A note tells of the whole file, also of what was taken before.
        let mut problems = all.problems();
        let new_late = if self.shows_end { None } else { all.late(known_lines) };
        let new_late = new_late.filter(|new| !self.late.contains(new));
        let late: Vec<Message> = self.late.iter().chain(&new_late).cloned().collect();
        problems.extend(late.iter().cloned());
        let before = all.count(known_lines);
        all.behind(known_lines);
        let new = all;
        let says = |id: &'static str, says: bool| says.then(|| Message::new(id));
        let counted = |message: Message, count: usize| (0 < count).then(|| message.count("count", count));
        let again = if known_lines == 0 { new.count(*same_lines) } else { 0 };
        let older = if *standing == FileStanding::Older { before } else { 0 };
        let as_other = begins_as
            .as_ref()
            .and_then(|(known, lines)| counted(message!("watch-begins-as").text("known", known), new.count(*lines)));
        let is_within_line = !self.line_ends.is_empty() && self.extent.is_within_line(&mark);
        let remarks = [
            counted(message!("watch-again"), again),
            says("watch-other", *standing == FileStanding::Another && new.items.iter().any(is_value)),
            counted(message!("watch-older"), older),
            as_other,
            new_late,
            says("watch-no-line-end", is_within_line && !self.found.is_moved() && new.has_value_at(mark.lines)),
        ];
        Batch {
            path: self.found.path.clone(),
            name: self.found.name.clone(),
            sha256: mark.hash,
            items: new.items,
            problems,
            remarks: remarks.into_iter().flatten().collect(),
            found: self.found.clone(),
            is_open,
            lines: TakenLines { is_open: is_within_line, ..self.extent.taken_lines(&mark) },
            late,
        }
    }

    /// What the file holds up to a place, judged by the plan.
    fn read_to(&self, end: Mark) -> io::Result<Units> {
        let FileJudging { plan, sources, masks, now, temperature, .. } = self.judging;
        let beside = |ending: &str| files::beside(&self.found.path, ending);
        let mapping = self.remembered(end)?;
        let has_plan = plan.is_some();
        let mapping = mapping.as_ref();
        let lasts = RefCell::new(BTreeMap::new());
        let units = |first: usize, last: usize| {
            lasts.borrow_mut().insert(first, last);
        };
        let given = ImportInputs {
            beside: &beside,
            masks,
            mapping,
            most_rows: MOST_ROWS,
            has_plan,
            units: &units,
            temperature,
            ..ImportInputs::new(sources, now)
        };
        let mut items = Vec::new();
        let by_plan = plan.map(ByPlan::new);
        import_from(&self.found.name, &mut beginning(self.file, end.end)?, given, &mut |item| match &by_plan {
            Some(by_plan) => by_plan.item(item, &mut |item| items.push(item)),
            None => items.push(item),
        });
        Ok(Units { items, lasts: lasts.take() })
    }

    /// The columns of the file as the user corrected them for files of its shape.
    fn remembered(&self, end: Mark) -> io::Result<Option<Mapping>> {
        let columns = self.judging.columns.filter(|columns| !columns.is_empty() && self.judging.masks.is_empty());
        let Some(columns) = columns else { return Ok(None) };
        let first = FirstRows::of(&self.found.name, &bytes(self.file, end.end.min(WHOLE))?);
        Ok(first.and_then(|first| columns.find(&first)).map(|(.., mapping)| mapping))
    }
}
