//! The numbers of all things of a file. QIF wants lists with their counts and the largest number before what they are of, so all is counted
//! first.

use std::io;

use fitcheck_core::probing::Measurement;
use sha2::{Digest as _, Sha256};

use crate::report::Report;
use crate::report::given::{self, Catalogue, Found, Given, Known, remarks};

/// The first number of a characteristic; smaller ones are those of the file's own things.
const FIRST: usize = 10;

/// The things of one characteristic: three of its feature, three of itself.
const EACH: usize = 6;

/// The standard of the characteristics, and the part.
pub(super) const STANDARD: usize = 1;
pub(super) const PART: usize = 2;

/// The numbers of the things of a characteristic.
#[derive(Clone, Copy)]
pub(super) struct CharacteristicIds(usize);

impl CharacteristicIds {
    pub(super) const fn feature_definition(self) -> usize {
        self.0
    }

    pub(super) const fn feature_nominal(self) -> usize {
        self.0 + 1
    }

    pub(super) const fn feature_item(self) -> usize {
        self.0 + 2
    }

    pub(super) const fn definition(self) -> usize {
        self.0 + 3
    }

    pub(super) const fn nominal(self) -> usize {
        self.0 + 4
    }

    pub(super) const fn item(self) -> usize {
        self.0 + 5
    }
}

/// How many values a part has, or the checks of no part.
#[derive(Clone, Copy, Default)]
pub(super) struct Group {
    pub values: usize,
    /// How many of them have a measured centre.
    pub features: usize,
}

/// What is counted of a report.
pub(super) struct Ids {
    pub known: Catalogue,
    /// The parts of the report, and behind them the checks of none.
    pub groups: Vec<Group>,
    /// The name of the file: the same for the same report, another one for any other.
    pub uuid: String,
}

impl Ids {
    pub(super) fn of(report: &Report) -> io::Result<Self> {
        let mut known = Catalogue::default();
        let mut groups = vec![Group::default(); report.parts.len() + 1];
        let head = (&report.title, report.created, &report.program, &report.part, &report.order, &report.inspector);
        let mut hash = Sha256::new_with_prefix(format!("fitcheck qif 1 {head:?}"));
        report.notes.iter().for_each(|note| hash.update(format!("{:?}", note.to_string())));
        given::each(report, &mut |given| {
            known.see(given);
            let number = known.of(given).map_or(0, |known| known.number);
            hash.update(format!("{:?}", (given.part, number, content(given))));
            if let Some(group) = groups.get_mut(given.part.unwrap_or(report.parts.len())) {
                group.values += 1;
                group.features += usize::from(has_feature(given));
            }
            Ok(())
        })?;
        Ok(Self { known, groups, uuid: uuid(&hash.finalize()) })
    }

    /// The largest number.
    pub(super) fn largest(&self) -> usize {
        let of = |group: &Group| group.values + group.features;
        self.results() + 2 * self.groups.len() + self.groups.iter().map(of).sum::<usize>()
    }

    pub(super) const fn of_characteristic(known: Known) -> CharacteristicIds {
        CharacteristicIds(FIRST + (known.number - 1) * EACH)
    }

    /// The first number behind the characteristics.
    fn results(&self) -> usize {
        FIRST + self.known.count() * EACH
    }

    /// The numbers of the results of a group and of its part, and the first one of its values.
    pub(super) fn of_group(&self, at: usize) -> [usize; 3] {
        let before = self.groups.iter().take(at).map(|group| group.values + group.features).sum::<usize>();
        let results = self.results() + 2 * at;
        [results, results + 1, self.results() + 2 * self.groups.len() + before]
    }
}

/// What a value is known by beside what is asked of it.
fn content(given: &Given<'_>) -> (String, String) {
    match given.found {
        Found::Value(record) => (format!("{:?} {}", record.measurement, record.time), remarks(record)),
        Found::LeftOut(reason) => (String::new(), reason.to_owned()),
        Found::Missing => <_>::default(),
    }
}

/// Whether a value has a measured feature: its centre and its height are known.
pub(super) fn has_feature(given: &Given<'_>) -> bool {
    matches!(given.found, Found::Value(record) if centre(&record.measurement).is_some())
}

/// The measured centre with the height of its first contact.
pub(super) fn centre(measurement: &Measurement) -> Option<[String; 3]> {
    let [x, y] = measurement.centre?;
    let height = fitcheck_core::length::Length::from_mm_f64(measurement.contacts.first()?.z).ok()?;
    Some([x, y, height].map(|axis| crate::row::Millimetres(axis).text(0)))
}

/// A name of 32 hexadecimal figures in five groups, of the beginning of a hash: version 8, one's own kind of name.
fn uuid(hash: &[u8]) -> String {
    let mut text = String::new();
    for (at, byte) in hash.iter().take(16).enumerate() {
        let byte = match at {
            6 => 0x80 | byte & 0x0f,
            8 => 0x80 | byte & 0x3f,
            _ => *byte,
        };
        if matches!(at, 4 | 6 | 8 | 10) {
            text.push('-');
        }
        text.extend([byte >> 4, byte & 0x0f].map(|digit| char::from_digit(u32::from(digit), 16).unwrap_or('0')));
    }
    text
}
