//! Series of a journal: checks become values, one series for each feature.
//!
//! A feature is what has the same part, name, callout and limits: where a drawing changes, a new series begins.

use std::collections::BTreeMap;

use fitcheck_core::length::Length;

use super::Value;
use crate::journal::Record;
use crate::journal::entry::{Checked, Entry};
use crate::journal::natural::Natural;

/// So many entries of a journal are read at most, the newest of them.
pub const MOST_READ: usize = 100_000;

/// What makes a feature.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct FeatureKey {
    /// The part; empty where nobody said.
    pub part: Natural,
    /// The feature; empty where the part has one only.
    pub name: Natural,
    /// What was asked for, as it is written, or the limits where there is no callout; empty where there are none.
    pub callout: String,
    /// The nominal size; `None` where only limits are known.
    pub nominal: Option<Length>,
    /// Lower and upper limit.
    pub limits: [Option<Length>; 2],
}

impl FeatureKey {
    /// Its name and what was asked for: `Flange, B1, 25 H7`; a feature of a part is named without it, too.
    pub fn title(&self, with_part: bool) -> String {
        let part = if with_part || self.name.0.is_empty() { self.part.0.as_str() } else { "" };
        joined([part, self.name.0.as_str(), self.callout.as_str()])
    }

    /// The same in two lines: `B1`, and below it `Flange, 25 H7`.
    pub fn lines(&self, with_part: bool) -> [String; 2] {
        let name = self.name.0.as_str();
        let part = if with_part || name.is_empty() { self.part.0.as_str() } else { "" };
        let mut texts = [name, part, self.callout.as_str()].into_iter().filter(|text| !text.is_empty());
        let first = texts.next().map(str::to_owned).unwrap_or_default();
        [first, joined(texts)]
    }
}

fn joined<'a>(texts: impl IntoIterator<Item = &'a str>) -> String {
    texts.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(", ")
}

/// The values of one feature, the oldest first, with those that are left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FeatureSeries {
    pub key: FeatureKey,
    pub values: Vec<Value>,
}

/// Sorts the checks of a journal into series while they are read.
#[derive(Debug, Default)]
pub struct Gathering {
    found: BTreeMap<FeatureKey, Vec<(u64, Value)>>,
    /// In place of which entry a correction stands.
    corrects: BTreeMap<u64, u64>,
}

impl Gathering {
    /// Takes an entry by its number; `is_replaced` where another one corrects it or takes it back.
    pub fn take(&mut self, number: u64, entry: &Entry, is_replaced: bool) {
        let Some(value) = Value::of_entry(number, entry, is_replaced) else { return };
        let (callout, nominal) = match entry.check().map(|check| &check.what) {
            Some(Checked::Size(record)) => (asked_for(record), Some(record.limits.nominal)),
            _ => (String::new(), None),
        };
        let [part, name] = [&value.origin.part, &value.name].map(|text| Natural(text.clone()));
        let key = FeatureKey { part, name, callout, nominal, limits: value.limits };
        self.found.entry(key).or_default().push((number, value));
        self.corrects.extend(entry.corrects().map(|correction| (number, correction.target.number)));
    }

    /// Of each feature the newest `most` values that count, with what was left out between them. What corrects a value stands in its place.
    pub fn finish(self, most: usize) -> Vec<FeatureSeries> {
        let Self { found, corrects } = self;
        let place = |number: u64| {
            let mut number = number;
            // An entry corrects an earlier one.
            while let Some(target) = corrects.get(&number).filter(|target| **target < number) {
                number = *target;
            }
            number
        };
        let newest = |(key, mut values): (FeatureKey, Vec<(u64, Value)>)| {
            values.sort_by_key(|(number, _)| std::cmp::Reverse((place(*number), *number)));
            let mut counted = 0;
            let is_new = |(_, value): &(u64, Value)| {
                counted += usize::from(value.left_out.is_none());
                counted <= most
            };
            let mut values: Vec<Value> = values.into_iter().take_while(is_new).map(|(_, value)| value).collect();
            values.reverse();
            FeatureSeries { key, values }
        };
        found.into_iter().map(newest).collect()
    }
}

/// The callout, or the limits where nobody wrote one.
fn asked_for(record: &Record) -> String {
    let [minimum, maximum] = [record.limits.minimum(), record.limits.maximum()];
    record.callout.map_or_else(|| format!("{minimum} … {maximum} mm"), |callout| callout.to_string())
}
