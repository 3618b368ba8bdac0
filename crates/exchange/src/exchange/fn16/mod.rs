//! What a control printed with FN 16, read back through the mask that printed it.
//!
//! | file | what |
//! |---|---|
//! | here | which mask fits, and its prints one after the other |
//! | `roles` | which field of a mask is what: measured value, limits, callout, status, time |
//! | `fields` | the fields of a mask, and a value as numbers of fields |
//! | `part` | which fields tell the part: its number, its serial number, a counter |
//! | `labelled` | the values of a part in a series, by the words before their fields |
//! | `judged` | a print as a measurement |
//!
//! A mask is needed: the file alone does not say what its figures are. The mask whose literal texts the beginning of the file has is the
//! one; a file that none or several of them fit is refused.

mod fields;
mod judged;
mod labelled;
mod part;
mod roles;

use std::collections::VecDeque;

use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::imported::Sink;
use super::pieces::Pieces;
use super::source::{Beginning, Source};
use super::{Format, cells, stated};
use fitcheck_core::message::{FilePlace, Say as _};
use fitcheck_core::text;
use fitcheck_nc::control::mask::{Inverse, Mask, PrintMatch, Printed};
use fitcheck_nc::control::simulated::is_mark;
use judged::PrintJudging;
use roles::Roles;

/// Never recognised: it needs a mask, and where one is given every file is read through it.
pub(super) const FORMAT: Format = Format {
    name: "fn16",
    endings: &["txt"],
    description: "exchange-format-fn16",
    recognises: |_beginning| false,
    read,
    plan: None,
    line_ends: text::LINE_END_BYTES,
    has_marks: false,
    shows_end: true,
};

/// A mask that fits, and what the beginning of the file has of it.
struct Fitting<'a> {
    name: &'a str,
    inverse: Inverse,
    sample: Vec<Printed>,
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let context = source.context.clone();
    let masks = source.given.masks;
    let Fitting { name, inverse, sample } = fitting(masks, &source.beginning().text())?;
    let roles = Roles::of(name, inverse.slots(), &sample, context.sources)?;
    let ignored = roles.ignored(inverse.slots());
    if !ignored.is_empty() {
        sink.warn(
            FilePlace::line(1),
            None,
            ImportWarningKind::IgnoredColumns { columns: super::column::listed(&ignored) },
        );
    }
    in_mm(&mut source.pieces(text::LINE_END_BYTES)?)?;
    let has_plan = source.given.has_plan;
    let judging = PrintJudging { slots: inverse.slots(), roles: &roles, context: &context, has_plan };
    let mut pieces = source.pieces(text::LINE_END_BYTES)?;
    let mut window = Window { inverse: &inverse, lines: VecDeque::new(), simulated_from: None };
    let mut next = 1;
    while let Some(piece) = pieces.next()? {
        for (number, line) in text::lines_from(&piece, next) {
            next = number + 1;
            if is_mark(line) {
                window.simulated_from.get_or_insert(number);
                continue;
            }
            window.lines.push_back((number, line.to_owned()));
            if inverse.most_lines() <= window.lines.len() && !window.first(&judging, sink) {
                return Ok(());
            }
        }
    }
    while !window.lines.is_empty() {
        if !window.first(&judging, sink) {
            return Ok(());
        }
    }
    if sink.rows() == 0 { Err(ImportErrorKind::NoRows) } else { Ok(()) }
}

/// Refuses a print that says inch anywhere.
fn in_mm(pieces: &mut Pieces<'_>) -> Result<(), ImportErrorKind> {
    let mut next = 1;
    while let Some(piece) = pieces.next()? {
        for (line, text) in text::lines_from(&piece, next) {
            next = line + 1;
            if let Some(unit) = stated::inch_in(text) {
                return Err(ImportErrorKind::PrintUnit { line, unit: shorten(unit) });
            }
        }
    }
    Ok(())
}

/// Whether one of the masks, or several, seem to have printed a file.
pub(super) fn fits(masks: &[(String, Mask)], beginning: &Beginning<'_>) -> bool {
    !masks.is_empty() && !matches!(fitting(masks, &beginning.text()), Err(ImportErrorKind::MaskNone { .. }))
}

/// The one mask that fits the beginning of a file.
fn fitting<'a>(masks: &'a [(String, Mask)], head: &str) -> Result<Fitting<'a>, ImportErrorKind> {
    let mut fit = Vec::new();
    for (name, mask) in masks {
        let inverse = mask.inverse();
        let inverse =
            inverse.map_err(|error| ImportErrorKind::MaskBackwards { mask: name.clone(), reason: error.message() })?;
        if let Some(sample) = sample(&inverse, head) {
            fit.push(Fitting { name, inverse, sample });
        }
    }
    let names = |of: &mut dyn Iterator<Item = &str>| of.collect::<Vec<_>>().join(", ");
    match fit.pop() {
        None => Err(ImportErrorKind::MaskNone { masks: names(&mut masks.iter().map(|(name, _)| name.as_str())) }),
        Some(only) if fit.is_empty() => Ok(only),
        Some(last) => {
            let all = &mut fit.iter().map(|mask| mask.name).chain([last.name]);
            Err(ImportErrorKind::MaskSeveral { masks: names(all) })
        }
    }
}

/// What the beginning of a file has of a mask; `None` where most of its lines are others.
fn sample(inverse: &Inverse, head: &str) -> Option<Vec<Printed>> {
    let lines: Vec<&str> = text::lines(head).map(|(_, line)| line).filter(|line| !is_mark(line)).collect();
    let mut at = 0;
    let mut fit = 0;
    let mut other = 0;
    let mut sample = Vec::new();
    while let Some(rest) = lines.get(at..).filter(|rest| !rest.is_empty()) {
        let count = match inverse.at(rest) {
            PrintMatch::Printed(printed) => {
                let count = printed.lines;
                sample.push(inverse.by_parameter(printed));
                count
            }
            PrintMatch::Ambiguous(count) | PrintMatch::Broken(count, _) => count,
            PrintMatch::Nothing => {
                other += usize::from(!rest.first().is_some_and(|line| line.trim().is_empty()));
                at += 1;
                continue;
            }
        };
        fit += count;
        at += count.max(1);
    }
    (other < fit).then_some(sample)
}

/// Whether a line that the mask does not print may be a record all the same: it has several numbers with a decimal sign, as limits and
/// values have.
fn seems_record(line: &str) -> bool {
    let words = line.split(|c: char| c.is_whitespace() || matches!(c, ';' | '|' | '=' | ':'));
    let is_figure = |word: &&str| word.contains(['.', ',']) && cells::is_number(word);
    1 < words.filter(is_figure).count()
}

/// The lines that come next.
struct Window<'a> {
    inverse: &'a Inverse,
    lines: VecDeque<(usize, String)>,
    /// The line of the mark below which all is simulated, where there is one.
    simulated_from: Option<usize>,
}

impl Window<'_> {
    /// Reads what begins at the first line; `false` where no more is wanted.
    fn first(&mut self, judging: &PrintJudging<'_>, sink: &mut Sink<'_>) -> bool {
        let lines: Vec<&str> = self.lines.iter().map(|(_, line)| line.as_str()).collect();
        let found = self.inverse.at(&lines);
        let Some(&(number, ref text)) = self.lines.front() else { return true };
        if found != PrintMatch::Nothing && sink.is_full(number) {
            return false;
        }
        let count = match found {
            PrintMatch::Printed(printed) => {
                let printed = self.inverse.by_parameter(printed);
                let last = self.lines.get(printed.lines.saturating_sub(1)).map_or(number, |(last, _)| *last);
                let is_simulated = self.simulated_from.is_some_and(|from| from < last);
                sink.unit(number, number + printed.lines.saturating_sub(1));
                judging.judge(number, &printed, is_simulated, sink);
                printed.lines
            }
            PrintMatch::Ambiguous(count) => {
                sink.unit(number, number + count.saturating_sub(1));
                sink.refuse(FilePlace::line(number), ImportErrorKind::PrintAmbiguous, shorten(text));
                count
            }
            PrintMatch::Broken(count, line) => {
                let at = number + count;
                sink.unit(number, at);
                sink.refuse(FilePlace::line(at), ImportErrorKind::PrintBroken { line }, String::new());
                count
            }
            PrintMatch::Nothing => {
                if seems_record(text) {
                    if sink.is_full(number) {
                        return false;
                    }
                    sink.refuse(FilePlace::line(number), ImportErrorKind::PrintOther, shorten(text.trim()));
                } else if !text.trim().is_empty() {
                    sink.warn(FilePlace::line(number), None, ImportWarningKind::NotUsed { text: shorten(text.trim()) });
                }
                1
            }
        };
        self.lines.drain(..count.clamp(1, self.lines.len()));
        true
    }
}
