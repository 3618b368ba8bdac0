//! Mappings by the shape of the file that they were made for: the names of its header and the separator between them, or without a
//! header the number of its columns.

use std::collections::BTreeMap;

use jiff::civil::DateTime;
use serde::{Deserialize, Serialize};

use super::{Choice, FirstRows, Mapping, Separator};
use crate::exchange::cells::may_be_names;
use crate::exchange::sample::{ABOVE_HEADER, Sample};
use crate::journal::chain::Hash;

/// The most shapes that are kept; the one that was corrected longest ago makes room.
pub const MOST_KEPT: usize = 50;

/// A mapping that is kept, and what it is for.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Kept {
    /// The names of the header; none where the file has no header.
    names: Vec<String>,
    #[serde(rename = "separator")]
    split: Split,
    /// How many columns there are.
    count: usize,
    /// How many lines below the header the first row is, where that was chosen.
    #[serde(skip_serializing_if = "Option::is_none")]
    below: Option<usize>,
    /// The mapping as TOML.
    mapping: String,
    /// When it was chosen: ISO 8601.
    when: String,
}

/// How a file of a shape is split into cells.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "String", into = "String")]
enum Split {
    /// A workbook has cells of its own; its word is empty.
    #[default]
    Workbook,
    By(Separator),
    /// By a word that is not known here, as another version may have kept it: no file is of the shape, and it is left as it is.
    Unknown(String),
}

impl From<String> for Split {
    fn from(word: String) -> Self {
        if word.is_empty() { Self::Workbook } else { word.parse().map_or(Self::Unknown(word), Self::By) }
    }
}

impl From<Split> for String {
    fn from(split: Split) -> Self {
        split.to_string()
    }
}

impl std::fmt::Display for Split {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Workbook => Ok(()),
            Self::By(separator) => separator.fmt(f),
            Self::Unknown(word) => f.write_str(word),
        }
    }
}

/// Mappings by shapes.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Remembered(BTreeMap<String, Kept>);

/// The header of a file.
enum Header {
    None,
    Line(usize),
}

impl Header {
    const fn line(&self) -> Option<usize> {
        match self {
            Self::None => None,
            Self::Line(line) => Some(*line),
        }
    }
}

/// Names as they are compared: trimmed, and without empty ones at the end.
fn bare<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut names: Vec<String> = names.map(|name| name.trim().to_owned()).collect();
    while names.pop_if(|name| name.is_empty()).is_some() {}
    names
}

impl Kept {
    /// What was chosen for a file; `None` where its columns are not known with it.
    pub fn of(first: &FirstRows, choice: &Choice, now: DateTime) -> Option<Self> {
        let mut mapping = choice.mapping(&first.names(choice));
        let detected = first.detect(&mapping).ok()?;
        let below = mapping.first_row.zip(detected.header).and_then(|(first, header)| first.checked_sub(header));
        if detected.header.is_some() {
            // Another file may have more lines above its header.
            mapping.first_row = None;
        }
        mapping.sheet = None;
        Some(Self {
            names: bare(detected.names.iter().map(String::as_str)),
            split: choice.separator.map_or(Split::Workbook, Split::By),
            count: usual_width(&first.sample(&mapping)),
            below,
            mapping: mapping.to_toml().ok()?,
            when: now.strftime("%Y-%m-%dT%H:%M:%S").to_string(),
        })
    }

    /// The day on which it was chosen: `2026-11-24`.
    pub fn day(&self) -> &str {
        self.when.split_once('T').map_or(self.when.as_str(), |(day, _)| day)
    }

    /// The name of its shape in the state file.
    fn key(&self) -> String {
        let shape = format!("{}\n{}\n{}", self.split, self.count_of_shape(), self.names.join("\n"));
        Hash::of_file(shape.as_bytes()).to_string().chars().take(16).collect()
    }

    /// With a header the names alone count.
    const fn count_of_shape(&self) -> usize {
        if self.names.is_empty() { self.count } else { 0 }
    }

    /// The mapping for a file of the shape; `None` where the file is of another one.
    fn mapping_for(&self, first: &FirstRows) -> Option<Mapping> {
        let is_of_its_kind = match self.split {
            Split::By(_) => first.is_text(),
            Split::Workbook => !first.is_text(),
            Split::Unknown(_) => false,
        };
        if !is_of_its_kind {
            return None;
        }
        let kept = Mapping::from_toml(&self.mapping).ok()?;
        let sheets = first.sheets();
        let sheets: Vec<Option<&str>> =
            if sheets.is_empty() { vec![None] } else { sheets.into_iter().map(Some).collect() };
        sheets.into_iter().find_map(|sheet| {
            let mapping = Mapping { sheet: sheet.map(str::to_owned), ..kept.clone() };
            let sample = first.sample(&mapping);
            let header = self.header_in(&sample)?;
            let below = header.line().zip(self.below).map(|(header, below)| header + below);
            Some(Mapping { first_row: below.or(mapping.first_row), ..mapping })
        })
    }

    /// The header in a file of the shape; `None` in any other file.
    fn header_in(&self, sample: &Sample) -> Option<Header> {
        if self.names.is_empty() {
            let is_headless = sample.header.is_none()
                && sample.rows.first().is_some_and(|(_, cells)| !may_be_names(cells))
                && usual_width(sample) == self.count;
            return is_headless.then_some(Header::None);
        }
        let above = sample.rows.iter().take(ABOVE_HEADER + 1);
        let found = above.into_iter().find(|(_, cells)| bare(cells.iter()) == self.names);
        found.map(|(line, _)| Header::Line(*line))
    }
}

impl Remembered {
    /// The mapping for a file, with the name of its shape and what is kept of it.
    pub fn find(&self, first: &FirstRows) -> Option<(&str, &Kept, Mapping)> {
        let mut kept: Vec<(&String, &Kept)> = self.0.iter().collect();
        kept.sort_by(|(_, one), (_, other)| other.when.cmp(&one.when));
        kept.into_iter().find_map(|(key, kept)| Some((key.as_str(), kept, kept.mapping_for(first)?)))
    }

    /// Keeps a mapping in place of another one of the same shape; returns the name of the shape.
    pub fn keep(&mut self, kept: Kept) -> String {
        let key = kept.key();
        self.0.insert(key.clone(), kept);
        while MOST_KEPT < self.0.len() {
            let oldest = self.0.iter().min_by(|(_, one), (_, other)| one.when.cmp(&other.when));
            let Some(oldest) = oldest.map(|(key, _)| key.clone()) else { break };
            self.0.remove(&oldest);
        }
        key
    }

    /// Forgets the mapping of a shape; whether there was one.
    pub fn forget(&mut self, key: &str) -> bool {
        self.0.remove(key).is_some()
    }

    /// Whether a shape has a mapping.
    pub fn has(&self, key: &str) -> bool {
        self.0.contains_key(key)
    }

    /// How many shapes are known.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether none is.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl FirstRows {
    /// The names of the header as a choice has it; none where the file has no header.
    pub fn names(&self, choice: &Choice) -> Vec<String> {
        // By their numbers columns are found without a name.
        let mapping = choice.mapping(&[]);
        match self.detect(&mapping) {
            Ok(detected) if !detected.names.is_empty() => detected.names,
            _ => names_above(&self.sample(&mapping)),
        }
    }
}

/// The row above the first numbers that has names in every column: what it calls them means nothing to anybody yet.
fn names_above(sample: &Sample) -> Vec<String> {
    let above = sample.rows.iter().take_while(|(_, cells)| may_be_names(cells)).take(ABOVE_HEADER + 1);
    let width = usual_width(sample);
    let has_all = |cells: &csv::StringRecord| {
        let named = cells.iter().filter(|cell| cell.chars().any(char::is_alphabetic)).count();
        cells.len() == width && named == width
    };
    let names = above.map(|(_, cells)| cells).filter(|cells| has_all(cells)).last();
    names.map_or_else(Vec::new, |cells| cells.iter().map(|cell| cell.trim().to_owned()).collect())
}

/// How many cells most rows have.
fn usual_width(sample: &Sample) -> usize {
    /// The width of a file without rows.
    const NO_ROWS: usize = 0;
    let count = |width: usize| sample.rows.iter().filter(|(_, cells)| cells.len() == width).count();
    let widths = sample.rows.iter().map(|(_, cells)| cells.len());
    widths.max_by_key(|width| count(*width)).unwrap_or(NO_ROWS)
}
