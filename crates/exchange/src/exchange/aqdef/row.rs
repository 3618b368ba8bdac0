//! The values that are read and not yet judged: those of one part, or one value of a characteristic after the other.

use std::collections::BTreeMap;

use super::keys::{BETWEEN_CHARACTERISTICS, BETWEEN_FIELDS, Key};

/// The keys of the fields of a measured value, in a line without keys.
const MEASURED: [u16; 10] = [1, 2, 4, 5, 6, 7, 8, 10, 11, 12];

/// The same of counted parts and error log sheets; the third field has no key.
const COUNTED: [u16; 12] = [20, 21, 0, 2, 4, 5, 6, 7, 8, 10, 11, 12];

/// The most values that wait: of a file that repeats no key until then, what comes later for them is told.
const MOST: usize = 20_000;

/// What a file says of one value.
#[derive(Debug, Clone, Default)]
pub(super) struct Fields {
    /// The line where it begins.
    pub(super) line: usize,
    /// The last line that says something of it.
    pub(super) last: usize,
    /// Which keys it has, a bit for each.
    seen: u128,
    pub(super) value: String,
    pub(super) attribute: String,
    pub(super) date: String,
    /// What stands beside the value in words.
    pub(super) text: String,
    pub(super) batch: String,
    pub(super) who: String,
    pub(super) machine: String,
    pub(super) serial: String,
    pub(super) gauge: String,
    /// A text that the end of the file may have cut off.
    pub(super) cut_off: Option<(Key, String)>,
    /// Whether the mark of the value came before it.
    is_mark_first: bool,
    /// A mark for all values that stands between two rows: it may be that of this one.
    pub(super) doubt: Option<String>,
}

impl Fields {
    pub(super) const fn has(&self, key: Key) -> bool {
        self.seen & (1 << (key.0 % 128)) != 0
    }

    /// Whether it is a value at all, and not only something beside one.
    pub(super) const fn is_value(&self) -> bool {
        self.has(Key(1)) || self.has(Key(2)) || self.is_counted()
    }

    /// Whether parts or errors were counted.
    pub(super) const fn is_counted(&self) -> bool {
        self.has(Key(20)) || self.has(Key(21))
    }

    /// Whether the key is one of those that are used.
    pub(super) const fn is_used(key: Key) -> bool {
        matches!(key.0, 1 | 2 | 4 | 6 | 8 | 9 | 10 | 12 | 14 | 20 | 21)
    }

    pub(super) fn first(&self) -> Key {
        let [low, high, ..] = self.seen.trailing_zeros().to_le_bytes();
        Key(u16::from_le_bytes([low, high]))
    }

    pub(super) fn set(&mut self, key: Key, text: &str) {
        self.is_mark_first |= key == Key(2) && !self.has(Key(1));
        self.seen |= 1 << (key.0 % 128);
        if let Some(field) = self.field(key) {
            text.clone_into(field);
        }
    }

    const fn field(&mut self, key: Key) -> Option<&mut String> {
        Some(match key.0 {
            1 => &mut self.value,
            2 => &mut self.attribute,
            4 => &mut self.date,
            6 => &mut self.batch,
            8 => &mut self.who,
            9 => &mut self.text,
            10 => &mut self.machine,
            12 => &mut self.gauge,
            14 => &mut self.serial,
            _ => return None,
        })
    }

    /// Takes from what is said of all values what this one does not say.
    fn complete(&mut self, all: &Self) {
        let mut all = all.clone();
        for key in [2, 4, 6, 8, 9, 10, 12, 14].map(Key) {
            if all.has(key)
                && !self.has(key)
                && let Some(text) = all.field(key).map(std::mem::take)
                && let Some(field) = self.field(key)
            {
                *field = text;
            }
        }
    }
}

/// The values that wait, by the number of the characteristic.
#[derive(Debug, Default)]
pub(super) struct WaitingValues {
    /// What is said of all of them.
    pub(super) all: Fields,
    pub(super) values: BTreeMap<u32, Fields>,
    /// What marks all values of this row, if it came after them.
    mark: Option<String>,
    /// The same of the row before.
    mark_before: Option<String>,
}

impl WaitingValues {
    /// Whether an entry begins another row.
    pub(super) fn is_closed_by(&self, key: Key, index: u32) -> bool {
        let fields = if index == 0 { Some(&self.all) } else { self.values.get(&index) };
        fields.is_some_and(|fields| fields.has(key)) || MOST < self.values.len()
    }

    /// Whether an entry is a further mark of a value that waits: the one that takes the value out counts.
    pub(super) fn takes_mark(&mut self, index: u32, text: &str) -> bool {
        let Some(fields) = self.values.get_mut(&index) else { return false };
        if !fields.has(Key(2)) || fields.is_mark_first {
            return false;
        }
        if is_mark(text) {
            text.clone_into(&mut fields.attribute);
        }
        true
    }

    /// Keeps an entry.
    pub(super) fn set(&mut self, line: usize, key: Key, index: u32, text: &str) -> &mut Fields {
        if index == 0 && key == Key(2) && !self.values.is_empty() && is_mark(text) {
            self.mark = Some(text.to_owned());
        }
        let fields = if index == 0 {
            &mut self.all
        } else {
            self.values.entry(index).or_insert_with(|| Fields { line, ..Fields::default() })
        };
        fields.set(key, text);
        fields.last = line;
        fields
    }

    /// The last line that says something of a value.
    pub(super) fn last(&self) -> usize {
        self.values.values().chain([&self.all]).map(|fields| fields.last).fold(0, usize::max)
    }

    /// The values in the order of their lines, and the row is empty.
    pub(super) fn take(&mut self) -> Vec<(u32, Fields)> {
        let all = std::mem::take(&mut self.all);
        let mut values: Vec<_> = std::mem::take(&mut self.values).into_iter().collect();
        let doubt = std::mem::replace(&mut self.mark_before, self.mark.take()).filter(|_| !all.has(Key(2)));
        for (_, fields) in &mut values {
            fields.complete(&all);
            fields.doubt.clone_from(&doubt);
        }
        values.sort_by_key(|(_, fields)| fields.line);
        values
    }
}

/// The values of a line without keys, by the number of the characteristic; empty ones as well.
pub(super) fn values(line: &str) -> impl Iterator<Item = (u32, &str)> {
    (1..).zip(line.split(BETWEEN_CHARACTERISTICS))
}

/// The fields of one value, with their keys; how many there are and how many there may be, where those are too many.
pub(super) fn fields(value: &str, kind: Option<u32>) -> Result<impl Iterator<Item = (Key, &str)>, (usize, usize)> {
    let value = value.trim_end_matches(BETWEEN_FIELDS);
    let count = value.split(BETWEEN_FIELDS).count();
    let is_counted = kind.map_or(MEASURED.len() < count, is_counted);
    let keys: &[u16] = if is_counted { &COUNTED } else { &MEASURED };
    if keys.len() < count {
        return Err((count, keys.len()));
    }
    Ok(keys.iter().map(|&key| Key(key)).zip(value.split(BETWEEN_FIELDS)).map(|(key, text)| (key, text.trim())))
}

/// Whether an attribute is one: 0 says that the value is as good as any.
fn is_mark(attribute: &str) -> bool {
    !matches!(attribute, "" | "0")
}

/// Whether K2004 says that parts or errors are counted.
pub(super) const fn is_counted(kind: u32) -> bool {
    matches!(kind, 1 | 5 | 6)
}
