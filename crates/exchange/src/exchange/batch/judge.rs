//! Rows judged one after the other: most of them fast, the others exactly as `import` reads them, with the same answer.

use super::compared::{Compared, told};
use super::court::StreamJudging;
use super::cut::Block;
use super::figures::{bounds_of, number};
use super::judged::Judged;
use super::known::{Classes, Figures};
use super::layout::{Layout, utf8};
use super::tally::{RowNoteKind, Tally};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::evidence::marks_simulation;
use crate::exchange::imported::WhyUnjudged;
use crate::exchange::index::{Broken, Index, LONGEST_ROW, line_end};
use crate::exchange::row::TextRow;
use crate::exchange::rules::{RowMeasurement, Rules};
use crate::exchange::{ImportWarningKind, cells, left_out, stated, words};
use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::Say;
use fitcheck_core::probing::noted;
use fitcheck_core::text::Within as _;
use fitcheck_core::tolerance::fit::thermal::Temperature;
use fitcheck_core::tolerance::{Bounds, Feature, ToleranceClass};
use fitcheck_core::verdict::{Status, doubt_of};
use std::fmt;

/// Takes what is found in a block, in its order.
pub trait Take {
    /// The line at which the next thing begins, from 0 in its block; for those who count lines.
    #[inline]
    fn at(&mut self, _line: usize) {}
    /// The class of the row that comes next, with the number that the judge has given it; `None` for a callout without a
    /// class. For those who tell classes apart.
    #[inline]
    fn class(&mut self, _class: Option<(usize, ToleranceClass)>) {}
    /// A row with its verdict. The text of rows is UTF-8.
    fn judged(&mut self, row: &TextRow<'_>, judged: &Judged);
    /// A row without a verdict, and why; nothing where there is nothing in its cells.
    fn refused(&mut self, row: &TextRow<'_>, reason: &str);
    /// A line that cannot be split into cells, or only its beginning, with the reason.
    fn broken(&mut self, line: &str, reason: &ImportErrorKind);
    /// A line that is no row: empty, or a comment. With its line end.
    fn line(&mut self, line: &[u8]);
}

/// Judges blocks of rows, and remembers the classes that it met.
#[derive(Debug)]
pub struct Judge<'a> {
    pub(super) court: &'a StreamJudging<'a>,
    classes: Classes<'a>,
    /// The verdicts of each class, by its number.
    counts: Vec<Counts>,
    /// The verdicts of callouts without a class.
    others: Counts,
    index: Index,
    /// What stands beside a value and may contradict its answer.
    compared: Compared<'a>,
    /// Words of holes and shafts that were met.
    pub(super) sides: Vec<(Vec<u8>, Option<Feature>)>,
}

/// How many rows are good, rework, to be measured again, scrap: in the order of [`Status::ALL`].
pub type Counts = [u64; Status::ALL.len()];

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JudgedCounts {
    /// The classes with their verdicts.
    pub by_class: Vec<(ToleranceClass, Counts)>,
    /// The verdicts of callouts without a class.
    pub others: Counts,
    /// What to check about the figures behind the limits.
    pub figures: Figures,
}

impl StreamJudging<'_> {
    /// A worker's own judge.
    pub fn judge(&self) -> Judge<'_> {
        Judge {
            court: self,
            classes: Classes::new(self.sources, &self.steps),
            counts: Vec::new(),
            others: Counts::default(),
            index: Index::default(),
            compared: Compared::with(&self.layout.columns),
            sides: Vec::new(),
        }
    }
}

impl Judge<'_> {
    /// The layout of the rows.
    pub const fn layout(&self) -> &Layout {
        self.court.layout
    }

    /// Judges the rows of a block. The lines of the tally count from the beginning of the block, from 0.
    pub fn block(&mut self, block: &Block, take: &mut impl Take) -> Tally {
        let mut tally = Tally::default();
        let text = block.text.as_slice();
        if let Some(broken) = block.broken {
            Self::broken(broken, text, &mut tally, take);
            tally.lines = 1;
            return tally;
        }
        let mut own = std::mem::take(&mut self.index);
        if block.index.is_none() {
            own.find_plain(text, self.court.layout.separator);
        }
        let is_utf8 = std::str::from_utf8(text).is_ok();
        let mut start = 0;
        for ends in block.index.as_ref().unwrap_or(&own).rows() {
            let row = TextRow::new(text, start, ends);
            start = row.next();
            let lines = if block.index.is_some() && !self.court.layout.is_typed { row.lines() } else { 1 };
            if 1 < lines && self.hides_rows(&row) {
                Self::torn(&row, &mut tally, take);
                continue;
            }
            take.at(tally.lines);
            if is_utf8 || std::str::from_utf8(row.bytes()).is_ok() {
                self.row(&row, &mut tally, take);
            } else {
                tally.not_utf8 += 1;
                let whole = text.within(row.start..start);
                self.other_text(&utf8(whole), &mut tally, take);
            }
            if 1 < lines {
                tally.note(RowNoteKind::SeveralLines, None, || ImportWarningKind::SeveralLines { lines }.message());
            }
            tally.lines += lines;
        }
        self.index = own;
        tally
    }

    /// Whether lines within the quotation marks of a row look like rows.
    #[cold]
    fn hides_rows(&self, row: &TextRow<'_>) -> bool {
        self.court.layout.columns.hides_rows(&row.record(), self.court.layout.separator)
    }

    /// A row with such lines: none of them has a verdict.
    #[cold]
    fn torn(row: &TextRow<'_>, tally: &mut Tally, take: &mut impl Take) {
        let mut start = row.start;
        while start < row.next() {
            take.at(tally.lines);
            let rest = row.text.within(start..row.next());
            let end = memchr::memchr2(b'\n', b'\r', rest).map_or(rest.len(), |at| at + line_end(rest, at));
            let is_first = start == row.start;
            let reason = if is_first { ImportErrorKind::OpenQuote } else { ImportErrorKind::WithinQuotes };
            Self::no_row(&reason, rest.within(..end), tally, take);
            tally.lines += 1;
            start += end;
        }
    }

    /// A row whose bytes are not those of the stream any more.
    #[cold]
    fn other_text(&mut self, text: &str, tally: &mut Tally, take: &mut impl Take) {
        let mut index = Index::default();
        let _whole = index.find_quoted(text.as_bytes(), self.court.layout.separator, true);
        if let Some(ends) = index.rows().next() {
            self.row(&TextRow::new(text.as_bytes(), 0, ends), tally, take);
        }
    }

    #[inline]
    fn row(&mut self, row: &TextRow<'_>, tally: &mut Tally, take: &mut impl Take) {
        if self.fast(row, tally, take).is_none() {
            self.slow(row, tally, take);
        }
    }

    #[expect(clippy::inline_always, reason = "its answer stays in registers, for each of millions of rows")]
    #[inline(always)]
    pub(super) fn give(
        &mut self,
        row: &TextRow<'_>,
        judged: &Judged,
        class: Option<(usize, ToleranceClass)>,
        tally: &mut Tally,
        take: &mut impl Take,
    ) {
        tally.rows += 1;
        let counts = match class.map(|(number, _)| (number, self.counts.get_mut(number))) {
            Some((_, Some(counts))) => counts,
            Some((number, None)) => Self::more(&mut self.counts, number),
            None => &mut self.others,
        };
        if let Some(count) = counts.get_mut(judged.status.at()) {
            *count += 1;
        }
        if let Some(doubt) = doubt_of(&judged.bounds, judged.measured) {
            tally.note(RowNoteKind::Doubt, None, || doubt.message());
        }
        tally.nominal += u64::from(judged.measured == judged.bounds.nominal);
        self.compared.compare(row, judged, tally);
        take.class(class);
        take.judged(row, judged);
    }

    /// Room for the verdicts of a class, and its own.
    #[cold]
    fn more(counts: &mut Vec<Counts>, number: usize) -> &mut Counts {
        counts.resize(counts.len().max(number), Counts::default());
        counts.push_mut(Counts::default())
    }

    pub fn met(self) -> JudgedCounts {
        // A class that was looked up for a row without a verdict counts nothing: whether it has a number here depends on the block.
        let counted = (0..).zip(self.counts).filter(|(_, counts)| *counts != Counts::default());
        let classes = counted.filter_map(|(number, counts)| Some((self.classes.class(number)?, counts)));
        JudgedCounts { by_class: classes.collect(), others: self.others, figures: self.classes.into_figures() }
    }

    /// Judges a plain row; `None` for every row that is not plain.
    #[expect(clippy::inline_always, reason = "its answer stays in registers, for each of millions of rows")]
    #[inline(always)]
    fn fast(&mut self, row: &TextRow<'_>, tally: &mut Tally, take: &mut impl Take) -> Option<()> {
        let fast = &self.court.fast;
        if row.len() != fast.count
            || LONGEST_ROW < row.end - row.start
            || fast.has_comments && (may_be_comment(row) || row.text.len() == row.end)
        {
            return None;
        }
        let said = match fast.unit {
            Some(at) => Some(stated::plain_unit(row.cell(at)?)?),
            None => None,
        };
        let in_unit = |(at, unit): (usize, Unit)| (at, said.unwrap_or(unit));
        let (measured, sign) = number(row, in_unit(fast.measured))?;
        if measured <= Length::ZERO || sign.is_some() && sign == fast.foreign_sign || sign.is_none() && fast.has_commas
        {
            return None;
        }
        let at = match fast.tolerance {
            Some(at) if fast.limits.is_none() || row.cell(at).is_some_and(|cell| !cell.is_empty()) => at,
            _ => return self.by_limits(row, measured, said, tally, take),
        };
        if fast.may_join && at.checked_sub(1).and_then(|before| row.cell(before)).is_some_and(may_be_number) {
            return None;
        }
        let callout = row.part(at)?.plain()?;
        let letters = callout.bytes().iter().position(u8::is_ascii_alphabetic)?;
        let (size, class) = callout.split(letters);
        let nominal = match (letters, fast.nominal) {
            (0, Some(own)) => number(row, in_unit(own))?.0,
            (0, None) => return None,
            _ if fast.is_inch || said == Some(Unit::Inch) => return None,
            (_, own) => {
                let nominal = size.without_spaces_behind().number(Unit::Millimetre)?.0;
                if let Some(own) = own
                    && !row.part(own.0)?.plain()?.bytes().is_empty()
                    && number(row, in_unit(own))?.0 != nominal
                {
                    return None;
                }
                nominal
            }
        };
        if nominal <= Length::ZERO {
            return None;
        }
        if !fast.is_plain_size(row)? {
            return None;
        }
        let number = self.classes.number(class)?;
        let (class, feature, deviations) = self.classes.deviations(number, nominal)?;
        // Within a step a zone is as wide everywhere; whether it reaches to zero depends on the size.
        let bounds = Bounds::new(feature, nominal, deviations).filter(|bounds| Length::ZERO < bounds.minimum())?;
        if let Some(limits) = fast.limits {
            let own = bounds_of(row, limits, Some(nominal), said)?;
            let bounds_of_row = Bounds::new(feature, own.0, own.1)?;
            if (bounds_of_row.minimum(), bounds_of_row.maximum()) != (bounds.minimum(), bounds.maximum()) {
                return None;
            }
        }
        self.give(row, &Judged::new(bounds, measured), Some((number, class)), tally, take);
        Some(())
    }

    /// A row as `import` reads it.
    #[cold]
    fn slow(&mut self, row: &TextRow<'_>, tally: &mut Tally, take: &mut impl Take) {
        let whole = row.text.within(row.start..row.next());
        if LONGEST_ROW < row.bytes().len() {
            return Self::broken(Broken::TooLong, whole, tally, take);
        }
        let cells = row.record();
        if cells::is_blank(&cells) {
            // With separators alone it has the cells of a row, and gets those that are added.
            let is_line = row.len() == 1 && !self.court.layout.is_typed;
            return if is_line { take.line(whole) } else { take.refused(row, "") };
        }
        let columns = &self.court.layout.columns;
        if columns.stated.is_row_of_units(&cells) {
            return take.refused(row, "");
        }
        let stray = || stated::stray(columns, &cells);
        let has_commas = self.court.fast.has_commas;
        let sources = self.court.sources;
        let file = &self.court.file;
        let rules = Rules { columns, has_commas, sources, has_plan: false, lookup: None, file };
        if self.court.fast.has_comments && cells::is_comment(&cells) {
            if marks_simulation(&cells) && !columns.evidence.are_simulated {
                return Self::refuse(row, None, &ImportErrorKind::SimulatedBelow, tally, take);
            }
            if rules.hides_measurement(&cells) {
                return Self::refuse(row, None, &ImportErrorKind::Comment, tally, take);
            }
            if let Some(reason) = stray() {
                return Self::refuse(row, None, &reason, tally, take);
            }
            told(left_out::said_against(&cells, columns.counted_at(usize::MAX, Temperature::REFERENCE)), tally);
            tally.comments += 1;
            return take.line(whole);
        }
        match rules.read(&cells) {
            Ok(RowMeasurement { measured, asked: Ok((callout, limits)), is_simulated, .. }) => {
                if self.court.fast.has_comments
                    && row.line_end().is_empty()
                    && let Some(warning) = rules.cut_off(&cells)
                {
                    tally.against += u64::from(warning.stands_against());
                    tally.note(RowNoteKind::CutOff, Some(columns.measured.at), || warning.message());
                }
                let bounds = limits.bounds();
                let class = callout.and_then(|callout| callout.class());
                let class = class.map(|class| (self.classes.number_of(class), class));
                if let Some(callout) = &callout {
                    self.classes.note(callout, &limits);
                    if let Some(differs) = noted::differing(callout.notes(), &limits) {
                        tally.against += 1;
                        tally.note(RowNoteKind::ClaimDiffers, None, || differs.message());
                    }
                }
                tally.simulated += u64::from(is_simulated);
                self.give(row, &Judged::new(bounds, measured), class, tally, take);
            }
            Ok(RowMeasurement { asked: Err(why), .. }) => {
                let cell = rules.other_than_size(&cells).filter(|_| matches!(why, WhyUnjudged::NotASize { .. }));
                Self::refuse(row, cell.and_then(|cell| cell.at), &why, tally, take);
            }
            Err(_) if columns.stated.repeats_names(&cells) || words::is_summary(&cells) => take.refused(row, ""),
            Err((cell, _)) if columns.are_renamed_by(&cells) => {
                Self::refuse(row, cell.at, &ImportErrorKind::OtherHeader, tally, take);
            }
            Err((cell, reason)) => Self::refuse(row, cell.at, &stray().unwrap_or(reason), tally, take),
        }
    }

    fn refuse(
        row: &TextRow<'_>,
        at: Option<usize>,
        reason: &(impl Say + fmt::Display),
        tally: &mut Tally,
        take: &mut impl Take,
    ) {
        tally.rows += 1;
        tally.note(RowNoteKind::Refused, at, || reason.message());
        take.refused(row, &reason.to_string());
    }

    #[cold]
    fn broken(broken: Broken, line: &[u8], tally: &mut Tally, take: &mut impl Take) {
        let reason = match broken {
            Broken::OpenQuote => ImportErrorKind::OpenQuote,
            Broken::TooLong => ImportErrorKind::RowTooLong { most: LONGEST_ROW >> 10 },
        };
        Self::no_row(&reason, line, tally, take);
    }

    #[cold]
    fn no_row(reason: &ImportErrorKind, line: &[u8], tally: &mut Tally, take: &mut impl Take) {
        tally.rows += 1;
        tally.note(RowNoteKind::Refused, None, || reason.message());
        let line = line.strip_suffix(b"\n").unwrap_or(line);
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        // Of a megabyte, the beginning tells which line it was; a character is not cut in two.
        let shown = line.get(..BEGINNING).map_or_else(
            || utf8(line).into_owned(),
            |beginning| format!("{}…", String::from_utf8_lossy(beginning).trim_end_matches('\u{fffd}')),
        );
        take.broken(&shown, reason);
    }
}

/// How much of a broken line is kept, in bytes.
const BEGINNING: usize = 200;

/// Whether a row begins like a comment, or with something that may hide the mark of one.
#[inline]
fn may_be_comment(row: &TextRow<'_>) -> bool {
    let first = row.text.get(row.start).map_or(b' ', |first| *first);
    first <= b' ' || first == b'#' || 0x80 <= first || first == b'"' && may_be_quoted_comment(row)
}

#[inline(never)]
fn may_be_quoted_comment(row: &TextRow<'_>) -> bool {
    row.text.get(row.start + 1).is_none_or(|byte| *byte <= b' ' || matches!(byte, b'#' | b'"') || 0x80 <= *byte)
}

/// Whether a cell may be the first half of a callout whose decimal comma became a separator.
#[inline]
fn may_be_number(cell: &[u8]) -> bool {
    !cell.first().is_some_and(u8::is_ascii_alphabetic)
}
