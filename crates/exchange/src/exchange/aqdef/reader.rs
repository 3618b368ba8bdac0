//! Reads a file line by line: what was declared is kept, and the values of a row are judged as soon as the row is complete.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use fitcheck_core::text::{PLAIN_LINE_ENDS, plain_lines_from};

use super::declared::Declared;
use super::description::Description;
use super::error::{AqdefFault, AqdefWarning};
use super::keys::{BETWEEN_FIELDS, Entry, Key, Level, Line, line};
use super::row::{self, Fields, WaitingValues};
use super::told::AqdefReporter;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::imported::Sink;
use crate::exchange::index::LONGEST_ROW;
use crate::exchange::pieces::Pieces;
use crate::exchange::source::Context;

/// How many values of a characteristic were read, and the most decimals that one had.
#[derive(Debug, Clone, Copy, Default)]
struct ValueCount {
    values: u32,
    decimals: usize,
}

/// What is read from a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Half {
    Both,
    /// Its characteristics; values are counted and left out.
    Characteristics,
    /// Its values: the characteristics are known from another file.
    Values,
}

/// Reads one file, or one after the other.
pub(super) struct Reader<'a, 's> {
    pub(super) context: Context<'a>,
    pub(super) told: AqdefReporter<'s, 'a>,
    pub(super) description: Description,
    declared: BTreeMap<u32, Rc<Declared>>,
    row: WaitingValues,
    /// How many values the row before had.
    before: usize,
    seen: BTreeMap<u32, ValueCount>,
    shortest_date: Option<usize>,
    pub(super) has_times: bool,
    pub(super) half: Half,
    /// How many lines of values were left out.
    pub(super) left: usize,
    skipped: BTreeSet<Key>,
    /// Whether a value was read.
    pub(super) has_values: bool,
    is_full: bool,
}

impl<'a, 's> Reader<'a, 's> {
    pub(super) fn new(context: Context<'a>, sink: &'a mut Sink<'s>) -> Self {
        Self {
            context,
            told: AqdefReporter::new(sink),
            description: Description::default(),
            declared: BTreeMap::new(),
            row: WaitingValues::default(),
            before: 0,
            seen: BTreeMap::new(),
            shortest_date: None,
            has_times: false,
            half: Half::Both,
            left: 0,
            skipped: BTreeSet::new(),
            has_values: false,
            is_full: false,
        }
    }

    /// Reads all lines of a file.
    ///
    /// # Errors
    /// What is wrong with the whole file.
    pub(super) fn read(&mut self, mut pieces: Pieces<'_>) -> Result<(), ImportErrorKind> {
        let mut next = 1;
        let mut is_open = false;
        while let Some(piece) = pieces.next()? {
            is_open = !piece.ends_with(PLAIN_LINE_ENDS);
            let mut lines = plain_lines_from(&piece, next).peekable();
            while let Some((number, text)) = lines.next() {
                next = number + 1;
                self.line(number, text, is_open && lines.peek().is_none())?;
                if self.is_full {
                    return Ok(());
                }
            }
        }
        let found = self.row.values.len();
        let expected = self.before;
        if is_open && 0 < found && found < expected {
            self.told.warn(next - 1, AqdefWarning::Fewer { found, expected }.into());
        }
        self.flush();
        Ok(())
    }

    fn line(&mut self, number: usize, text: &str, is_open: bool) -> Result<(), ImportErrorKind> {
        if text.contains('\0') {
            self.zeros(number, text);
            return Ok(());
        }
        if LONGEST_ROW < text.len() {
            self.told.refuse(number, ImportErrorKind::RowTooLong { most: LONGEST_ROW >> 10 }, "");
            return Ok(());
        }
        match line(text) {
            Line::Blank => {}
            Line::Entry(entry) => match entry.key.level() {
                Level::Count => self.count(number, &entry),
                Level::Value if self.half == Half::Characteristics => self.left += 1,
                Level::Value => self.value(number, &entry, is_open),
                Level::Part | Level::Characteristic => self.declare(number, &entry)?,
                Level::Other => self.skip(entry.key),
            },
            Line::Values(_) if self.half == Half::Characteristics => self.left += 1,
            Line::Values(text) => self.values(number, text, is_open),
            Line::Unknown if self.half == Half::Characteristics => {
                self.told.fault(number, AqdefFault::Line.into(), text);
            }
            Line::Unknown => self.told.refuse(number, AqdefFault::Line.into(), text),
        }
        Ok(())
    }

    /// A line with bytes 0: a file that was not written to its end has them, so a value before them may be half a number.
    fn zeros(&mut self, line: usize, text: &str) {
        let rest = text.trim_matches('\0').trim();
        if rest.is_empty() {
            self.told.warn(line, AqdefWarning::Zeros.into());
        } else if self.half == Half::Characteristics {
            self.told.fault(line, AqdefFault::Zeros.into(), rest);
        } else {
            self.told.refuse(line, AqdefFault::Zeros.into(), rest);
        }
    }

    fn skip(&mut self, key: Key) {
        // K0101 says nothing that is needed.
        if key != Key(101) {
            self.skipped.insert(key);
        }
    }

    /// `K0100`: files that were joined have another one in the middle.
    fn count(&mut self, line: usize, entry: &Entry<'_>) {
        self.flush();
        if self.half == Half::Values {
            return;
        }
        let announced = super::keys::number(entry.text);
        if announced.is_none() {
            let fault = AqdefFault::Whole { key: entry.key.to_string(), given: shorten(entry.text) };
            self.told.refuse(line, fault.into(), entry.text);
        }
        if !self.description.is_empty() {
            self.end_of_description();
            self.description = Description::default();
            self.declared.clear();
            self.seen.clear();
            self.before = 0;
        }
        self.description.announced = announced.map(|announced| (line, announced));
    }

    /// Tells where characteristics are missing.
    pub(super) fn end_of_description(&mut self) {
        if let Some((line, expected, found)) = self.description.miscount() {
            self.told.declared(line, AqdefWarning::Count { expected, found }.into());
        }
    }

    fn declare(&mut self, line: usize, entry: &Entry<'_>) -> Result<(), ImportErrorKind> {
        self.flush();
        let is_used = entry.key.is_used();
        let kept = if is_used { *entry } else { Entry { text: "", ..*entry } };
        if self.description.keep(line, &kept)?.is_some() && !entry.key.is_judged_by() {
            self.told.declared(line, AqdefWarning::Repeated { key: entry.key.to_string() }.into());
        }
        if !is_used {
            self.skip(entry.key);
        } else if entry.key.level() == Level::Characteristic && entry.index != 0 {
            self.declared.remove(&entry.index);
        } else {
            self.declared.clear();
        }
        Ok(())
    }

    /// A characteristic; what is odd about it is told the first time.
    pub(super) fn declared(&mut self, number: u32) -> Option<Rc<Declared>> {
        if let Some(declared) = self.declared.get(&number) {
            return Some(Rc::clone(declared));
        }
        let declared = Declared::read(self.description.of(number)?);
        for (line, kind, given) in &declared.errors {
            self.told.fault(*line, kind.clone(), given);
        }
        for (line, kind) in &declared.warnings {
            self.told.declared(*line, kind.clone());
        }
        let declared = Rc::new(declared);
        self.declared.insert(number, Rc::clone(&declared));
        Some(declared)
    }

    fn value(&mut self, line: usize, entry: &Entry<'_>, is_open: bool) {
        let Entry { key, index, .. } = *entry;
        if !Fields::is_used(key) {
            return self.skip(key);
        }
        self.has_values = true;
        let Some(declared) = (if index == 0 { None } else { self.declared(index) }) else {
            if index == 0 && matches!(key.0, 1 | 20 | 21) {
                self.told.refuse(line, AqdefFault::OfAll { key: key.to_string() }.into(), entry.text);
            } else if index == 0 {
                self.value_of_all(line, entry);
            } else if matches!(key.0, 1 | 20) {
                self.told.refuse(line, AqdefFault::Undeclared { number: index }.into(), entry.text);
            }
            return;
        };
        if let Some(number) = entry.value {
            let now = self.seen.get(&index).map_or(0, |seen| seen.values);
            if number <= now && !(number == now && self.row.values.contains_key(&index)) {
                return self.told.warn(line, AqdefWarning::Late { key: key.to_string() }.into());
            }
            if now < number {
                self.flush_if(self.row.values.contains_key(&index));
                // Its number follows when it is kept.
                self.seen.entry(index).or_default().values = number - 1;
            }
        }
        if key == Key(2) && self.row.takes_mark(index, entry.text) {
            return;
        }
        self.flush_if(self.row.is_closed_by(key, index));
        if !self.row.values.contains_key(&index) {
            self.seen.entry(index).or_default().values += 1;
        }
        let cut_off = self.is_cut_off(key, index, (entry.text, declared.decimals), is_open);
        let fields = self.row.set(line, key, index, entry.text);
        if cut_off {
            fields.cut_off = Some((key, shorten(entry.text)));
        }
    }

    /// An entry of all values of a row, after them or before them.
    fn value_of_all(&mut self, line: usize, entry: &Entry<'_>) {
        if let Some(number) = entry.value {
            let is_now = |index| self.seen.get(index).is_some_and(|seen: &ValueCount| seen.values == number);
            if !self.row.values.keys().any(is_now) {
                return self.told.warn(line, AqdefWarning::Late { key: entry.key.to_string() }.into());
            }
        }
        self.flush_if(self.row.is_closed_by(entry.key, 0));
        self.row.set(line, entry.key, 0, entry.text);
    }

    /// A line of values without keys.
    fn values(&mut self, line: usize, text: &str, is_open: bool) {
        self.flush();
        self.has_values = true;
        let mut found = 0;
        let count = row::values(text).count();
        for (number, (index, value)) in (1..).zip(row::values(text)) {
            let Some(declared) = self.declared(index) else {
                if !value.trim_matches(|sign: char| sign.is_control() || sign == ' ').is_empty() {
                    self.told.refuse(line, AqdefFault::Undeclared { number: index }.into(), value);
                }
                continue;
            };
            found += 1;
            self.seen.entry(index).or_default().values += 1;
            match row::fields(value, declared.kind) {
                Ok(fields) => {
                    let mut last = (Key(1), "");
                    for (key, text) in fields {
                        last = (key, text);
                        self.field(line, index, key, text);
                    }
                    let (key, text) = last;
                    let is_last = is_open && number == count;
                    // Behind the sign between fields there was an attribute, or it is missing.
                    let key = if is_last && key == Key(1) && value.contains(BETWEEN_FIELDS) { Key(2) } else { key };
                    if self.is_cut_off(key, index, (text, declared.decimals), is_last)
                        && let Some(fields) = self.row.values.get_mut(&index)
                    {
                        fields.cut_off = Some((key, shorten(text)));
                    }
                }
                Err((found, most)) => self.told.refuse(line, AqdefFault::Fields { found, most }.into(), value),
            }
        }
        let expected = self.description.count();
        if found < expected {
            self.told.warn(line, AqdefWarning::Fewer { found, expected }.into());
        }
    }

    /// A field of a line without keys.
    fn field(&mut self, line: usize, index: u32, key: Key, text: &str) {
        if matches!(key, Key(1 | 20)) || !text.is_empty() && Fields::is_used(key) {
            self.row.set(line, key, index, text);
        } else if !text.is_empty() && key != Key(0) {
            self.skip(key);
        }
    }

    /// Whether the text may be a part of one: where the file ends behind it without a line end. Of a value that is told by its decimals,
    /// and where nothing says how many it should have, it is not known. An attribute may be missing or half.
    fn is_cut_off(&mut self, key: Key, index: u32, (text, decimals): (&str, Option<usize>), is_open: bool) -> bool {
        match key.0 {
            1 => {
                let seen = self.seen.entry(index).or_default();
                let expected = decimals.map_or(seen.decimals, |decimals| seen.decimals.max(decimals));
                let found = decimals_of(text);
                seen.decimals = seen.decimals.max(found);
                let is_whole = 0 < expected && expected <= found && !text.contains(['e', 'E']);
                is_open && !is_whole
            }
            // No number goes on after 0.
            2 => is_open && text != "0",
            4 => self.shorter_date(text) && is_open,
            _ => false,
        }
    }

    fn shorter_date(&mut self, text: &str) -> bool {
        let is_shorter = self.shortest_date.is_some_and(|shortest| text.len() < shortest);
        self.shortest_date = Some(self.shortest_date.unwrap_or(usize::MAX).min(text.len()));
        is_shorter
    }

    fn flush_if(&mut self, is_closed: bool) {
        if is_closed {
            self.flush();
        }
    }

    /// Judges the values that wait.
    fn flush(&mut self) {
        if self.row.values.is_empty() {
            return;
        }
        let last = self.row.last();
        let values = self.row.take();
        self.before = values.len();
        for (_, fields) in &values {
            self.told.sink.unit(fields.line, last);
        }
        for (index, fields) in values {
            if self.told.is_full(fields.line) {
                self.is_full = true;
                return;
            }
            self.judge(index, fields);
        }
    }

    /// Tells what was left out; after the last line.
    pub(super) fn end(&mut self) {
        self.end_of_description();
        if !self.skipped.is_empty() {
            let keys: Vec<String> = self.skipped.iter().take(NAMED).map(ToString::to_string).collect();
            let more = if NAMED < self.skipped.len() { ", …" } else { "" };
            self.told.warn(1, AqdefWarning::Skipped { keys: format!("{}{more}", keys.join(", ")) }.into());
        }
        self.told.end();
    }
}

/// How many decimals a number has; its sign may be a comma.
fn decimals_of(text: &str) -> usize {
    text.split_once(['.', ',']).map_or(0, |(_, decimals)| decimals.len())
}

/// How many keys a message names.
const NAMED: usize = 24;
