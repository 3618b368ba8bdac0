//! A plan as a TOML file.
//!
//! ```toml
//! fitcheck_plan = 1
//! part = "Flange 4711"
//! picture = "flange.png"        # beside the plan
//! travel_x = [-250, 250]        # of the machine, mm
//!
//! [[feature]]
//! number = 1
//! name = "BORE_A"
//! callout = "25 H7"
//! x = 40
//! y = 30.5
//! z = -8
//! ```
//!
//! The keys of a feature are those of [`Column`], those before the first feature [`HeadField`]. Numbers are read as they are written,
//! figure by figure. Everything that is wrong is told at once, with line and column, and what is right is read.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::Document;
use super::column::{Column, HeadField};
use super::csv::LARGEST;
use super::draft::{Draft, DraftCell, DraftFeature};
use super::fault::{PlanError, PlanFault};
use super::plan::MOST_FEATURES;
use super::values::beginning;
use crate::length::Length;
use crate::message::{FilePlace, Located};
use crate::text::decode;

/// The key that says that a file is a plan, with the version of its form.
const VERSION_KEY: &str = "fitcheck_plan";

/// The version that is written, and the newest that is read.
const VERSION: u32 = 1;

/// The table of a feature.
const FEATURE: &str = "feature";

/// Whether a file is a plan as TOML and not as CSV: it has a line such as `[[feature]]` or `fitcheck_plan = 1`.
pub(super) fn is_toml(bytes: &[u8]) -> bool {
    let head = bytes.get(..64 << 10).unwrap_or(bytes);
    String::from_utf8_lossy(head).lines().any(|line| {
        let line = line.trim_start_matches('\u{feff}').trim();
        line.starts_with("[[feature")
            || line.strip_prefix(VERSION_KEY).is_some_and(|rest| rest.trim_start().starts_with('='))
    })
}

/// Whether a file says so itself: a simulated part has `[[feature]]` tables, too.
pub(super) fn says_plan(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head);
    let mut lines = text.lines().map(|line| line.trim_start_matches('\u{feff}').trim());
    lines.any(|line| line.strip_prefix(VERSION_KEY).is_some_and(|rest| rest.trim_start().starts_with('=')))
}

/// Reads a plan.
pub(super) fn read(bytes: &[u8]) -> Result<Document, PlanError> {
    if LARGEST < bytes.len() {
        return Err(Located { what: PlanFault::TooLarge { most: LARGEST >> 10 }, place: FilePlace::default() });
    }
    let text = decode(bytes);
    let text = text.trim_start_matches('\u{feff}');
    let lines = Lines::of(text);
    let (table, errors) = DeTable::parse_recoverable(text);
    let document = Document { comments: comments(text), ..Document::default() };
    let mut reader = Reader { lines, document };
    for error in errors {
        let at = error.span().map_or(0, |span| span.start);
        reader.problem(at, PlanFault::Toml { said: error.message().to_owned() });
    }
    reader.table(table.get_ref());
    Ok(reader.document)
}

/// How many comments a file has: `#` outside of texts.
fn comments(text: &str) -> usize {
    let mut count = 0;
    let mut rest = text;
    while let Some(found) = rest.find(['#', '"', '\'']).and_then(|at| rest.get(at..)) {
        let ends = [("\"\"\"", true), ("'''", false), ("\"", true), ("'", false)];
        let begun = ends.into_iter().find_map(|(end, escapes)| Some((found.strip_prefix(end)?, end, escapes)));
        rest = if let Some((inner, end, escapes)) = begun {
            after_text(inner, end, escapes)
        } else {
            count += 1;
            found.split_once('\n').map_or("", |(_comment, after)| after)
        };
    }
    count
}

/// What comes after the end of a text.
fn after_text<'a>(text: &'a str, end: &str, escapes: bool) -> &'a str {
    let mut rest = text;
    loop {
        if let Some(after) = rest.strip_prefix(end) {
            return after;
        }
        let mut signs = rest.chars();
        match signs.next() {
            None => return "",
            Some('\n') if end.len() == 1 => return signs.as_str(),
            Some('\\') if escapes => _ = signs.next(),
            Some(_) => {}
        }
        rest = signs.as_str();
    }
}

struct Reader<'a> {
    lines: Lines<'a>,
    document: Document,
}

impl Reader<'_> {
    fn problem(&mut self, at: usize, what: PlanFault) {
        let place = self.lines.place(at);
        self.document.problems.push(Located { what, place });
    }

    fn table(&mut self, table: &DeTable<'_>) {
        if !table.iter().any(|(key, _)| key.get_ref() == VERSION_KEY) {
            self.problem(0, PlanFault::NoColumn { column: VERSION_KEY });
        }
        let mut seen = Vec::new();
        for (key, value) in table {
            let at = key.span().start;
            match key.get_ref().as_ref() {
                VERSION_KEY => self.version(value),
                FEATURE => self.features(value),
                name => {
                    let field = HeadField::of_key(name);
                    if let Some(twice) = field.filter(|field| seen.contains(field)) {
                        self.problem(at, PlanFault::ColumnTwice { column: twice.key() });
                    } else {
                        seen.extend(field);
                        self.head(name, at, value);
                    }
                }
            }
        }
    }

    fn head(&mut self, name: &str, at: usize, value: &Spanned<DeValue<'_>>) {
        let Some(field) = HeadField::of_key(name) else {
            let known = format!("{VERSION_KEY}, {}, {FEATURE}", HeadField::known());
            return self.problem(at, PlanFault::UnknownKey { key: beginning(name), known });
        };
        if let Some(text) = self.text_or_range(field.key(), field.is_travel(), value) {
            let place = self.lines.place(value.span().start);
            self.document.draft.put(field, DraftCell::at(text, place));
        }
    }

    fn version(&mut self, value: &Spanned<DeValue<'_>>) {
        let given = match value.get_ref() {
            DeValue::Integer(number) => number.as_str().to_owned(),
            other => other.type_str().to_owned(),
        };
        if given.parse::<u32>().ok().is_none_or(|version| version == 0 || VERSION < version) {
            self.problem(value.span().start, PlanFault::OtherVersion { given: beginning(&given), newest: VERSION });
        }
    }

    fn features(&mut self, value: &Spanned<DeValue<'_>>) {
        let Some(features) = value.get_ref().as_array() else {
            return self.other(FEATURE, value, "[[feature]] tables");
        };
        for feature in features {
            if self.document.draft.rows.len() == MOST_FEATURES {
                return self.problem(feature.span().start, PlanFault::TooMany { most: MOST_FEATURES });
            }
            let Some(table) = feature.get_ref().as_table() else {
                self.other(FEATURE, feature, "[[feature]] tables");
                continue;
            };
            let mut row = DraftFeature::at(self.lines.place(feature.span().start));
            let mut seen = Vec::new();
            for (key, value) in table {
                let name = key.get_ref().as_ref();
                let Some(column) = Column::of_key(name) else {
                    let what = PlanFault::UnknownKey { key: beginning(name), known: Column::known() };
                    self.problem(key.span().start, what);
                    continue;
                };
                // TOML itself refuses the same spelling alone.
                if seen.contains(&column) {
                    self.problem(key.span().start, PlanFault::ColumnTwice { column: column.key() });
                    continue;
                }
                seen.push(column);
                if let Some(text) = self.text_or_range(column.key(), column.is_range(), value) {
                    row.put(column, DraftCell::at(text, self.lines.place(value.span().start)));
                }
            }
            self.document.draft.rows.push(row);
        }
    }

    /// A range is two numbers, anything else a text or a number.
    fn text_or_range(&mut self, key: &'static str, is_range: bool, value: &Spanned<DeValue<'_>>) -> Option<String> {
        let expected = if is_range { "two numbers in brackets" } else { "a text or a number" };
        let Some(numbers) = value.get_ref().as_array().filter(|_| is_range) else {
            return self.text(key, value, expected);
        };
        let texts: Option<Vec<String>> = numbers.iter().map(|number| self.text(key, number, expected)).collect();
        Some(texts?.join(" "))
    }

    fn text(&mut self, key: &'static str, value: &Spanned<DeValue<'_>>, expected: &'static str) -> Option<String> {
        match value.get_ref() {
            DeValue::String(text) => Some(text.to_string()),
            DeValue::Integer(number) if number.radix() == 10 => Some(number.as_str().replace('_', "")),
            DeValue::Float(number) => Some(number.as_str().replace('_', "")),
            _ => {
                self.other(key, value, expected);
                None
            }
        }
    }

    fn other(&mut self, key: &'static str, value: &Spanned<DeValue<'_>>, expected: &'static str) {
        let found = value.get_ref().type_str();
        self.problem(value.span().start, PlanFault::OtherValue { key, found, expected });
    }
}

/// Where the lines of a text begin.
struct Lines<'a> {
    text: &'a str,
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    fn of(text: &'a str) -> Self {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n').map(|(at, _)| at + 1);
        Self { text, starts: std::iter::once(0).chain(ends).collect() }
    }

    /// Line and character of a byte.
    fn place(&self, at: usize) -> FilePlace {
        let (begun, _) = self.starts.split_at(self.starts.partition_point(|start| *start <= at));
        let before = begun.last().and_then(|start| self.text.get(*start..at));
        FilePlace::in_line(begun.len(), 1 + before.map_or(0, |text| text.chars().count()))
    }
}

/// The plan as TOML.
pub(super) fn write(draft: &Draft) -> String {
    let mut text = format!("{VERSION_KEY} = {VERSION}\n");
    for field in HeadField::ALL {
        if let Some(given) = draft.text(field) {
            let range = bracketed(given).filter(|_| field.is_travel());
            let value = range.unwrap_or_else(|| quoted(given, field == HeadField::Uncertainty));
            writeln_to(&mut text, field.key(), &value);
        }
    }
    for row in &draft.rows {
        text.push_str("\n[[feature]]\n");
        for column in Column::ALL {
            if let Some(given) = row.text(column) {
                let range = bracketed(given).filter(|_| column.is_range());
                let value = range.unwrap_or_else(|| quoted(given, column.is_number()));
                writeln_to(&mut text, column.key(), &value);
            }
        }
    }
    text
}

/// The two numbers of a range in brackets; `None` of a text that is not as they are read: it stays a text.
fn bracketed(given: &str) -> Option<String> {
    let numbers: Vec<&str> = given.split(' ').collect();
    let are_two = numbers.len() == 2 && numbers.iter().all(|word| is_number(word));
    are_two.then(|| format!("[{}]", numbers.join(", ")))
}

fn writeln_to(text: &mut String, key: &str, value: &str) {
    text.extend([key, " = ", value, "\n"]);
}

/// A number as it is, where TOML reads it back as the same text; else a text with quotation marks.
fn quoted(given: &str, may_be_number: bool) -> String {
    if may_be_number && is_number(given) { given.to_owned() } else { toml::Value::from(given).to_string() }
}

/// Whether TOML has it as a number with the same figures: a sign, figures without a zero before them, a point and figures.
fn is_number(text: &str) -> bool {
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    let (whole, decimals) = unsigned.split_once('.').map_or((unsigned, None), |(whole, rest)| (whole, Some(rest)));
    let are_figures = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    are_figures(whole)
        && (whole == "0" || !whole.starts_with('0'))
        && decimals.is_none_or(are_figures)
        && text.parse::<Length>().is_ok()
}
