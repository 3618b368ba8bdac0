//! What a file declares: entries of parts and characteristics, each with its line, until a value needs them.

use std::collections::BTreeMap;

use super::error::AqdefFault;
use super::keys::{Entry, Key, Level};
use crate::exchange::error::ImportErrorKind;

/// The most memory of all entries, 64 MiB.
const MOST: usize = 64 << 20;

/// What an entry or a characteristic takes besides its text.
const EACH: usize = 256;

/// The text of an entry, and its line.
pub(super) type EntryText = (usize, String);

pub(super) type Entries = BTreeMap<Key, EntryText>;

/// Everything that was declared.
#[derive(Debug, Default)]
pub(super) struct Description {
    /// How many characteristics are announced, and where.
    pub(super) announced: Option<(usize, u32)>,
    parts: BTreeMap<u32, Entries>,
    characteristics: BTreeMap<u32, CharacteristicDescription>,
    /// Entries with the number 0, for all parts and all characteristics.
    all_parts: Entries,
    all_characteristics: Entries,
    /// The part that was named last: characteristics are those of it.
    part: Option<u32>,
    /// Entries of characteristics by which values are judged, and that stand twice with different texts: the line of the second one,
    /// and the first text.
    twice: BTreeMap<(u32, Key), EntryText>,
    bytes: usize,
}

#[derive(Debug, Default)]
struct CharacteristicDescription {
    part: u32,
    entries: Entries,
}

impl Description {
    /// Keeps an entry. The line of the same entry before it, where that has another text.
    ///
    /// # Errors
    /// [`AqdefFault::TooLarge`].
    pub(super) fn keep(&mut self, line: usize, entry: &Entry<'_>) -> Result<Option<usize>, ImportErrorKind> {
        self.bytes += EACH + entry.text.len();
        if MOST < self.bytes {
            return Err(AqdefFault::TooLarge { most: MOST >> 20 }.into());
        }
        let entries = match (entry.key.level(), entry.index) {
            (Level::Part, 0) => &mut self.all_parts,
            (Level::Part, index) => {
                self.part = Some(index);
                self.parts.entry(index).or_default()
            }
            (_, 0) => &mut self.all_characteristics,
            (_, index) => {
                let part = self.part.unwrap_or(1);
                &mut self
                    .characteristics
                    .entry(index)
                    .or_insert_with(|| CharacteristicDescription { part, ..CharacteristicDescription::default() })
                    .entries
            }
        };
        let before = entries.insert(entry.key, (line, entry.text.to_owned()));
        if let Some((_, text)) = before.as_ref().filter(|(_, text)| text != entry.text)
            && entry.key.is_judged_by()
        {
            self.twice.entry((entry.index, entry.key)).or_insert_with(|| (line, text.clone()));
        }
        Ok(before.filter(|(_, text)| text != entry.text).map(|(line, _)| line))
    }

    /// The numbers of the characteristics.
    pub(super) fn characteristics(&self) -> impl Iterator<Item = u32> {
        self.characteristics.keys().copied()
    }

    /// How many characteristics there are.
    pub(super) fn count(&self) -> usize {
        self.characteristics.len()
    }

    /// Whether nothing was declared.
    pub(super) fn is_empty(&self) -> bool {
        self.characteristics.is_empty() && self.parts.is_empty() && self.announced.is_none()
    }

    /// How many characteristics were announced, if they are not those that were declared: line, announced, declared.
    pub(super) fn miscount(&self) -> Option<(usize, u32, usize)> {
        let (line, expected) = self.announced?;
        let found = self.count();
        (usize::try_from(expected) != Ok(found)).then_some((line, expected, found))
    }

    /// The entries of a characteristic; `None` where it is not declared.
    pub(super) fn of(&self, number: u32) -> Option<CharacteristicEntries<'_>> {
        let CharacteristicDescription { part, entries } = self.characteristics.get(&number)?;
        Some(CharacteristicEntries { number, entries, part: self.parts.get(part), all: self })
    }
}

/// The entries of a characteristic and of its part.
#[derive(Debug, Clone, Copy)]
pub(super) struct CharacteristicEntries<'a> {
    pub(super) number: u32,
    entries: &'a Entries,
    part: Option<&'a Entries>,
    all: &'a Description,
}

impl<'a> CharacteristicEntries<'a> {
    /// An entry of it, else that for all, with its line; `None` where it is missing or empty.
    pub(super) fn get(&self, key: u16) -> Option<(usize, &'a str)> {
        let (own, all) = match Key(key).level() {
            Level::Part => (self.part, &self.all.all_parts),
            _ => (Some(self.entries), &self.all.all_characteristics),
        };
        let found = own.and_then(|own| own.get(&Key(key))).or_else(|| all.get(&Key(key)));
        found.map(|(line, text)| (*line, text.as_str())).filter(|(_, text)| !text.is_empty())
    }

    /// The entries that stand twice with different texts: key, line and the other text.
    pub(super) fn twice(&self) -> impl Iterator<Item = (Key, usize, &'a str)> {
        let of = |number: u32| self.all.twice.range((number, Key(0))..=(number, Key(u16::MAX)));
        let all = of(0).filter(|((_, key), _)| !self.entries.contains_key(key));
        let own = if self.number == 0 { None } else { Some(of(self.number)) };
        own.into_iter().flatten().chain(all).map(|((_, key), (line, text))| (*key, *line, text.as_str()))
    }

    /// The text of an entry; empty where it is missing.
    pub(super) fn text(&self, key: u16) -> &'a str {
        self.get(key).map_or("", |(_, text)| text)
    }

    /// The line where the characteristic begins.
    pub(super) fn line(&self) -> usize {
        self.entries.values().map(|(line, _)| *line).min().unwrap_or(1)
    }
}
