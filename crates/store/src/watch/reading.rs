//! What of a file is taken now: the units of it that are complete and new.
//!
//! A unit is a row, a log, a print, the values of a part. Whether the last one of a growing file is complete is known by what follows it: what
//! cannot be read at the end may be half a unit, so a file is known up to the end of its last unit that could be read, and the rest is read
//! again when there is more of it.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Read as _, Seek as _};

use fitcheck_core::message::{Message, message};
use fitcheck_exchange::exchange::{ByPlan, FirstRows, Given, Item, MOST_ROWS, Mapping, WHOLE, import_from, recognised};
use fitcheck_files::{self as files, FileError};

use super::folder::Found;
use super::known::{Extent, Known, Mark, until};
use super::part::Beginning;
use super::units::{Units, is_value, problem};
use super::{Batch, Judging, PATIENCE, Told, Waiting, note};

/// The most lines of a growing file that are taken at once: a look keeps them in memory.
const MOST_LINES: usize = 50_000;

/// A file that is looked into.
struct Reading<'a> {
    file: &'a File,
    found: &'a Found,
    judging: Judging<'a>,
    line_ends: &'static [u8],
    extent: &'a Extent,
    /// Whether what is cut off cannot be read.
    shows_end: bool,
    /// Whether a file of its name was taken before this is running, and had other lines at its beginning.
    is_another: bool,
    /// What was said of values that were taken too early.
    late: Vec<Message>,
}

/// How the CSV of verdicts begins that Fitcheck itself writes: nothing of it was measured again.
const VERDICTS: &[u8] = b"file,line,id,callout,nominal_mm,";

/// Looks into a file; `None` where nothing of it is new, or it is gone. What is to be said of it then comes to `told`.
pub(super) fn read(
    found: &Found,
    judging: Judging<'_>,
    known: &mut Known,
    is_young: bool,
    told: &mut Told,
) -> Result<Option<Batch>, Waiting> {
    let file = match files::open(&found.path) {
        Ok((file, _)) => file,
        Err(FileError::Missing { .. }) => return Ok(None),
        Err(error) => return Err(Waiting::Locked { reason: error.to_string() }),
    };
    let locked = |error: std::io::Error| Waiting::Locked { reason: error.to_string() };
    let mut body = &file;
    let format = recognised(&found.name, &mut body, judging.masks).map_err(locked)?;
    let shows_end = format.is_none_or(|format| format.shows_end);
    let line_ends = format.map_or(b"".as_slice(), |format| format.line_ends);
    let masks = format.map_or(&[][..], |format| format.masks_of(judging.masks));
    let masked = Judging { masks, ..judging };
    if has_beginning(&file, VERDICTS).map_err(locked)? {
        told.notes.push((found.path.clone(), vec![message!("watch-verdicts")]));
        return Ok(None);
    }
    // What shows nothing of its end may be cut off anywhere, also where it can be read.
    if !shows_end && line_ends.is_empty() && !found.is_settled() {
        return Err(Waiting::Written);
    }
    let mut extent = known.extent(&found.name, &mut body, line_ends, MOST_LINES).map_err(locked)?;
    let is_noted = note::written(&found.path).is_some_and(|written| found.was_done || found.is_changed_since(written));
    let all = |extent: &Extent| {
        let (is_another, late) = (false, Vec::new());
        let reading = Reading { file: &file, found, judging: masked, line_ends, extent, shows_end, is_another, late };
        reading.read_all(extent.whole).items.iter().filter_map(problem).collect::<Vec<Message>>()
    };
    if extent.is_known {
        let other = known.name_of(&extent.whole.hash, &found.name).filter(|other| !other.is_empty());
        match other {
            Some(other) if other != found.name => {
                told.same.push((found.name.clone(), other.to_owned()));
                told.notes.push((found.path.clone(), vec![message!("watch-copy").text("known", other)]));
            }
            _ => {
                told.same.extend(found.was_done.then(|| (found.name.clone(), found.name.clone())));
                // What the note says may be of what it held before.
                told.notes.extend(is_noted.then(|| (found.path.clone(), all(&extent))));
            }
        }
        // It is known from before this is running.
        if other == Some(found.name.as_str()) && !known.has_lines(&found.name) {
            known.add_lines(&found.name, extent.marks(extent.whole.lines), extent.is_within_line(&extent.whole));
        }
        return Ok(None);
    }
    let is_quiet = PATIENCE <= found.quiet;
    let has_lines = !line_ends.is_empty();
    // A program that writes a file anew has not come to its new lines yet; and one that did before this began is not known.
    if has_lines && !is_quiet && (extent.is_cut || is_young && is_another(known, found, &extent)) {
        return Err(Waiting::Written);
    }
    if has_lines && extent.is_cut_whole {
        told.same.push((found.name.clone(), found.name.clone()));
        told.notes.extend(is_noted.then(|| (found.path.clone(), all(&extent))));
        return Ok(None);
    }
    if has_lines && extent.is_cut && !found.is_final() {
        return Err(Waiting::Written);
    }
    // It took the place of what was taken before: its first lines may be the same, and are other measurements.
    if extent.is_replaced || extent.is_cut {
        (extent.known, extent.part) = (Mark::default(), None);
    } else if has_lines && 0 < extent.known.lines && !known.has_lines(&found.name) && !extent.is_older {
        known.add_lines(&found.name, extent.marks(extent.known.lines), extent.is_within_line(&extent.known));
    }
    let late = if extent.known.lines == 0 { Vec::new() } else { known.late(&found.name).to_vec() };
    let is_another = has_lines && is_another(known, found, &extent);
    let reading =
        Reading { file: &file, found, judging: masked, line_ends, extent: &extent, shows_end, is_another, late };
    let batch = reading.batch()?;
    // What changed while it was read may be half old and half new.
    if !found.is_unchanged() {
        return Err(Waiting::Written);
    }
    Ok(Some(batch))
}

/// Whether a file of this name had other lines at its beginning.
fn is_another(known: &Known, found: &Found, extent: &Extent) -> bool {
    known.is_from_before(&found.name) && extent.known.lines == 0
}

/// Whether a file begins with some bytes; it is at its beginning afterwards.
fn has_beginning(mut file: &File, bytes: &[u8]) -> std::io::Result<bool> {
    let mut head = Vec::new();
    file.rewind()?;
    file.take(bytes.len().try_into().unwrap_or(u64::MAX)).read_to_end(&mut head)?;
    file.rewind()?;
    Ok(head == bytes)
}

impl Reading<'_> {
    /// What is taken now, from the shortest beginning of the file that has something to take.
    fn batch(&self) -> Result<Batch, Waiting> {
        let Extent { whole, lines, part, known, .. } = self.extent;
        if self.line_ends.is_empty() {
            return self.of_whole();
        }
        let has_tail = lines.end < whole.end;
        // A last line without its end may be half a number.
        let tail = (has_tail && self.found.is_final()).then_some(*whole);
        // Where the last line may belong to the value before it, they are read together.
        let lines = (self.shows_end || tail.is_none()).then_some(*lines);
        let may_go_on = !self.shows_end && !self.found.is_settled() || has_tail && tail.is_none();
        let ends: Vec<Mark> = part.iter().copied().chain(lines).chain(tail).collect();
        for (at, end) in (1..).zip(&ends).filter(|(_, end)| known.end < end.end) {
            let is_last = at == ends.len();
            let batch = self.up_to(*end, is_last, !self.shows_end && (may_go_on || !is_last));
            if let Some(batch) = batch {
                return Ok(batch);
            }
        }
        Err(Waiting::Written)
    }

    /// A file that does not grow: what cannot be read may be unfinished, and cannot be told from what is broken but by waiting.
    fn of_whole(&self) -> Result<Batch, Waiting> {
        let all = self.read_all(self.extent.whole);
        if !self.found.is_final() && all.items.iter().any(|item| matches!(item, Item::Error(_))) {
            return Err(Waiting::Written);
        }
        Ok(self.made(all, self.extent.whole, false))
    }

    /// The beginning of a file that may grow; `None` where nothing of it is both complete and new. `is_last` is whether no longer one is
    /// looked at, and `holds` whether its last values wait for what may still be said of them.
    #[expect(clippy::fn_params_excessive_bools, reason = "two questions about the same place")]
    fn up_to(&self, end: Mark, is_last: bool, holds: bool) -> Option<Batch> {
        let mut all = self.read_all(end);
        let is_held = holds && all.hold_last();
        if !is_held && !all.is_unfinished() {
            return Some(self.made(all, end, end.end < self.extent.whole.end));
        }
        // What its writer has left like that for long is told, and may still be completed.
        let is_final = !is_held && is_last && self.found.is_told();
        let last = all.end();
        if !is_final && last <= self.known_lines(&all) {
            return None;
        }
        // The file is known up to what could be read.
        let mark = until(&mut &*self.file, self.line_ends, last).ok().flatten().filter(|_| 0 < last);
        let mark = match mark {
            Some(mark) => mark,
            // The last line has no end.
            None if last == end.lines => end,
            None if is_final => end,
            None => return None,
        };
        if !is_final {
            all.up_to(last);
        }
        Some(self.made(all, mark, !is_final))
    }

    /// How many lines at the beginning of the file were taken before. Nobody takes the first line of a log or a print alone.
    fn known_lines(&self, all: &Units) -> usize {
        let lines = self.extent.known.lines;
        if self.shows_end && all.begin_with(lines) { 0 } else { lines }
    }

    /// Of all that was read the new things, and what is to be said of the whole.
    fn made(&self, all: Units, mark: Mark, is_open: bool) -> Batch {
        let Extent { same_lines, begins_as, is_older, .. } = self.extent;
        let known_lines = self.known_lines(&all);
        // A note tells of the whole file, also of what was taken before.
        let mut problems: Vec<Message> = all.items.iter().filter_map(problem).collect();
        let late = if self.shows_end { None } else { all.late(known_lines) };
        let late = late.map(|(first, last)| message!("watch-late").text("first", first).text("last", last));
        let late = late.filter(|late| !self.late.contains(late));
        let all_late: Vec<Message> = self.late.iter().chain(&late).cloned().collect();
        problems.extend(all_late.iter().cloned());
        let before = all.count(known_lines);
        let new = all.behind(known_lines);
        let counted = |id: &'static str, count: usize| (0 < count).then(|| Message::new(id).count("count", count));
        let again = if known_lines == 0 { counted("watch-again", new.count(*same_lines)) } else { None };
        let other = self.is_another && new.items.iter().any(is_value);
        let other = other.then(|| message!("watch-other"));
        let older = if *is_older { counted("watch-older", before) } else { None };
        let as_other =
            begins_as.as_ref().map(|(known, lines)| (known, new.count(*lines))).filter(|(_, count)| 0 < *count);
        let as_other =
            as_other.map(|(known, count)| message!("watch-begins-as").text("known", known).count("count", count));
        let is_within_line = !self.line_ends.is_empty() && self.extent.is_within_line(&mark);
        let no_end = is_within_line && !self.found.is_moved() && new.has_value_at(mark.lines);
        let no_end = no_end.then(|| message!("watch-no-line-end"));
        let remarks = [again, other, older, as_other, late, no_end].into_iter().flatten().collect();
        Batch {
            path: self.found.path.clone(),
            name: self.found.name.clone(),
            sha256: mark.hash,
            has_values: new.items.iter().any(is_value),
            items: new.items,
            problems,
            remarks,
            found: self.found.clone(),
            is_open,
            marks: self.extent.marks(mark.lines),
            is_within_line,
            late: all_late,
        }
    }

    /// What the first bytes of the file hold, judged by the plan.
    fn read_all(&self, end: Mark) -> Units {
        let Judging { plan, sources, masks, now, temperature, .. } = self.judging;
        let beside = |ending: &str| files::beside(&self.found.path, ending);
        let (mapping, has_plan) = (self.remembered(end), plan.is_some());
        let (mapping, lasts) = (mapping.as_ref(), RefCell::new(BTreeMap::new()));
        let units = |first: usize, last: usize| {
            lasts.borrow_mut().insert(first, last);
        };
        let given = Given {
            beside: &beside,
            masks,
            mapping,
            most_rows: MOST_ROWS,
            has_plan,
            units: &units,
            temperature,
            ..Given::new(sources, now)
        };
        let (mut items, by_plan) = (Vec::new(), plan.map(ByPlan::new));
        import_from(&self.found.name, &mut Beginning::new(self.file, end.end), given, &mut |item| match &by_plan {
            Some(by_plan) => by_plan.item(item, &mut |item| items.push(item)),
            None => items.push(item),
        });
        Units::new(items, lasts.take())
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
