//! The ways to read some lines as what a mask prints at a time: two are enough to know that there is no one way.

use fitcheck_core::text::{before, behind, part};

use super::{Piece, Printed, Step, Values};
use crate::control::mask::{Format, FormatLetter};

/// What the width of a field fills up with, and what people put between fields. A no-break space is a character of the mask.
const BLANKS: [char; 2] = [' ', '\t'];

/// The longest line that is read back, in bytes; a control's has some hundred.
const LONGEST_LINE: usize = 1 << 10;

/// How many places are looked at for one print before it counts as ambiguous.
const MOST_STEPS: usize = 20_000;

/// What a line takes of them in any case, so that not every way to leave out records is tried.
const LINE_STEPS: usize = 50;

/// A field, and where its value begins and ends in a line.
type Range = (usize, (usize, usize));

/// The ways to read some lines as one print.
pub(super) struct Search<'a> {
    print: &'a [Step],
    lines: &'a [&'a str],
    pub(super) ways: Vec<Printed>,
    /// How many places may still be looked at.
    pub(super) left: usize,
    /// How many lines were read before one that is another than that of a line of the mask, and that line.
    pub(super) furthest: (usize, usize),
}

impl<'a> Search<'a> {
    /// All of the ways from the beginning, or two of them.
    pub(super) fn of(print: &'a [Step], lines: &'a [&'a str]) -> Self {
        let mut search = Self { print, lines, ways: Vec::new(), left: MOST_STEPS, furthest: (0, 0) };
        search.step(0, 0, &mut Vec::new());
        search
    }

    /// Reads from a record of the mask and a line of the file on. Two ways are enough.
    fn step(&mut self, record: usize, line: usize, values: &mut Values) {
        self.left = self.left.saturating_sub(1);
        if self.left == 0 || 1 < self.ways.len() {
            return;
        }
        let print = self.print;
        let Some(step) = print.get(record) else {
            let way = Printed { lines: line, values: values.clone() };
            if 0 < line && !self.ways.contains(&way) {
                self.ways.push(way);
            }
            return;
        };
        self.lines_of(step, (record, 0), line, values);
        if step.hides && step.has_text_parameter() {
            self.step(record + 1, line, values);
        }
    }

    /// Reads the lines of a record from one of them on.
    fn lines_of(&mut self, step: &Step, (record, part): (usize, usize), line: usize, values: &mut Values) {
        let Some(pieces) = step.lines.get(part) else { return self.step(record + 1, line, values) };
        let text = self.lines.get(line).copied();
        let mut ways = Ways::default();
        if let Some(line) = text.filter(|text| text.len() <= LONGEST_LINE) {
            let left = self.left.saturating_sub(LINE_STEPS);
            ways = Ways { pieces, line, wants_texts: step.hides, left, ..ways };
            ways.from(0, 0, &mut Vec::new());
            self.left = ways.left;
        }
        let ways = ways.found;
        let is_begun = self.print.iter().take(record).any(Step::is_marked);
        if ways.is_empty() && self.furthest.0 < line && is_begun {
            self.furthest = (line, step.line);
        }
        for way in ways {
            let count = values.len();
            values.extend(way);
            self.lines_of(step, (record, part + 1), line + 1, values);
            values.truncate(count);
        }
    }
}

impl Step {
    fn has_text_parameter(&self) -> bool {
        let is_one = |piece: &Piece| matches!(piece, Piece::Slot { is_text_parameter: true, .. });
        self.lines.iter().flatten().any(is_one)
    }

    fn is_marked(&self) -> bool {
        self.lines.iter().flatten().any(Piece::is_mark)
    }
}

/// The ways to read a line; two are enough.
#[derive(Default)]
struct Ways<'a> {
    pieces: &'a [Piece],
    line: &'a str,
    /// Whether no text parameter may be empty.
    wants_texts: bool,
    /// How many places may still be looked at.
    left: usize,
    /// Places from which the rest of the line cannot be read.
    failed: Vec<bool>,
    found: Vec<Values>,
}

impl Ways<'_> {
    /// Whether the line can be read from a piece and a byte on.
    fn from(&mut self, piece: usize, at: usize, values: &mut Vec<Range>) -> bool {
        self.left = self.left.saturating_sub(1);
        if self.left == 0 || 1 < self.found.len() || self.has_failed(piece, at) {
            return false;
        }
        let rest = behind(self.line, at);
        let pieces = self.pieces;
        let is_read = match pieces.get(piece) {
            None => {
                let is_end = rest.trim_start_matches(BLANKS).is_empty();
                if is_end {
                    let text = |(start, end): (usize, usize)| part(self.line, start, end).to_owned();
                    let values: Values = values.iter().map(|(slot, range)| (*slot, text(*range))).collect();
                    if !self.found.contains(&values) {
                        self.found.push(values);
                    }
                }
                is_end
            }
            Some(Piece::Literal(literal)) => {
                let end = literal_end(literal, rest, piece == 0);
                end.is_some_and(|end| self.from(piece + 1, at + end, values))
            }
            Some(Piece::Slot { number, format, is_text_parameter }) => match format.decimals() {
                None => self.text((piece, at), *number, (format, *is_text_parameter && self.wants_texts), values),
                Some(decimals) => {
                    let touches = match pieces.get(piece + 1) {
                        Some(Piece::Slot { .. }) => true,
                        Some(Piece::Literal(text)) => text.starts_with(|c: char| c.is_ascii_digit()),
                        None => false,
                    };
                    number_end(rest, decimals, touches).is_some_and(|(start, end)| {
                        let value = (*number, (at + start, at + end));
                        let padded = at + end + padding(format, (start, end), rest);
                        // Whoever edits a print may take the padding out.
                        self.with(value, (piece + 1, padded), values) || self.with(value, (piece + 1, at + end), values)
                    })
                }
            },
        };
        if !is_read {
            let place = self.place(piece, at);
            if self.failed.is_empty() {
                self.failed.resize(self.place(self.pieces.len() + 1, 0), false);
            }
            if let Some(failed) = self.failed.get_mut(place) {
                *failed = true;
            }
        }
        is_read
    }

    const fn place(&self, piece: usize, at: usize) -> usize {
        piece * (self.line.len() + 1) + at
    }

    fn has_failed(&self, piece: usize, at: usize) -> bool {
        self.failed.get(self.place(piece, at)).is_some_and(|failed| *failed)
    }

    fn with(&mut self, value: Range, (piece, at): (usize, usize), values: &mut Vec<Range>) -> bool {
        values.push(value);
        let is_read = self.from(piece, at, values);
        values.pop();
        is_read
    }

    /// A text may end at every place after which the rest of the line can be read.
    fn text(
        &mut self,
        (piece, at): (usize, usize),
        number: usize,
        (format, wants_text): (&Format, bool),
        values: &mut Vec<Range>,
    ) -> bool {
        let rest = behind(self.line, at);
        let most = format.digits.filter(|_| format.kind == FormatLetter::Text).unwrap_or(usize::MAX);
        let columns = format.columns();
        // Where tabs separate, none is within a text.
        let ends_at_tab = matches!(self.pieces.get(piece + 1), Some(Piece::Literal(next)) if next.contains('\t'));
        let mut is_read = false;
        // The last piece reaches to the end of the line.
        let first = if piece + 1 == self.pieces.len() { rest.len() } else { 0 };
        let tail = behind(rest, first);
        let ends = tail.char_indices().map(|(end, _)| first + end).chain([rest.len()]);
        let mut is_behind_blank = false;
        for (count, end) in ends.enumerate() {
            self.left = self.left.saturating_sub(1);
            let is_end = end == rest.len();
            let may_end = match columns {
                Some(columns) if first == 0 => count == columns || is_end && count < columns,
                // Blanks behind it belong to what comes next.
                _ => is_end || end == 0 || !is_behind_blank,
            };
            is_behind_blank = rest.get(end..).is_some_and(|behind| behind.starts_with(BLANKS));
            if self.left == 0 {
                break;
            }
            if !may_end || self.has_failed(piece + 1, at + end) {
                continue;
            }
            let whole = before(rest, end);
            let text = whole.trim_matches(BLANKS);
            let is_long = most != usize::MAX && most < text.chars().count();
            // Of a text in no columns nothing is printed, empty or not.
            let is_missing = wants_text && 0 < most && text.is_empty();
            if is_long || is_missing || ends_at_tab && whole.contains('\t') {
                continue;
            }
            let start = at + (end - whole.trim_start_matches(BLANKS).len());
            is_read |= self.with((number, (start, start + text.len())), (piece + 1, at + end), values);
        }
        is_read
    }
}

/// How many blanks behind a number fill up its width, where it stands on the left of that.
fn padding(format: &Format, (start, end): (usize, usize), rest: &str) -> usize {
    let tail = behind(rest, end);
    let blanks = tail.len() - tail.trim_start_matches(' ').len();
    if format.left { format.width.saturating_sub(end - start).min(blanks) } else { 0 }
}

/// Where a literal text ends in a line that begins with it: a run of blanks matches any run, or the end of the line; one with tabs
/// matches as many tabs, since they tell fields apart that have blanks.
fn literal_end(literal: &str, line: &str, is_first: bool) -> Option<usize> {
    let mut left = if is_first { literal.trim_start_matches(' ') } else { literal };
    let is_blank = left.is_empty() || left.starts_with(BLANKS);
    // The width of the field before may have put blanks there.
    let mut rest = if is_blank { line } else { line.trim_start_matches(BLANKS) };
    let mut signs = left.chars();
    while let Some(c) = signs.next() {
        let behind = left.trim_start_matches(BLANKS);
        let run = before(left, left.len() - behind.len());
        if run.is_empty() {
            rest = rest.strip_prefix(c)?;
            left = signs.as_str();
            continue;
        }
        let is_last = behind.is_empty();
        rest = match run.matches('\t').count() {
            0 if !is_last => behind_blanks(rest)?,
            _ if is_last && rest.is_empty() => rest,
            0 => {
                behind_blanks(rest)?;
                // Further blanks may be those before the next literal text, with an empty text between them.
                let found = rest.len() - rest.trim_start_matches(' ').len();
                rest.get(run.len().min(found).max(1)..)?
            }
            tabs if is_last => behind_tabs(rest, tabs)?,
            tabs => behind_tabs(rest, tabs)?.trim_start_matches(' '),
        };
        left = behind;
        signs = left.chars();
    }
    Some(line.len() - rest.len())
}

/// What comes behind so many tabs and the blanks between them.
fn behind_tabs(text: &str, tabs: usize) -> Option<&str> {
    (0..tabs).try_fold(text, |rest, _| rest.trim_start_matches(' ').strip_prefix('\t'))
}

/// What comes behind at least one blank.
fn behind_blanks(text: &str) -> Option<&str> {
    let rest = text.trim_start_matches(BLANKS);
    (rest.len() < text.len()).then_some(rest)
}

/// Where a number with so many decimals begins and ends. With `touches` another field may begin behind it.
fn number_end(line: &str, decimals: usize, touches: bool) -> Option<(usize, usize)> {
    let rest = line.trim_start_matches(BLANKS);
    let start = line.len() - rest.len();
    let unsigned = rest.strip_prefix(['+', '-', '\u{2212}']).unwrap_or(rest);
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let whole = digits(unsigned);
    let mut end = line.len() - unsigned.len() + whole;
    if whole == 0 {
        return None;
    }
    if 0 < decimals {
        let count = digits(line.get(end..)?.strip_prefix(['.', ','])?);
        if count < decimals || decimals < count && !touches {
            return None;
        }
        end += 1 + decimals;
    }
    Some((start, end))
}
