//! The numbers of a table: which keys it may have, and their ranges.

use toml::Spanned;

use super::error::BudgetError;
use crate::message::{FilePlace, Located};
use crate::probing::simulated::{column_at, line_at};

/// The largest uncertainty, in micrometres or kelvin: a metre.
pub(super) const FAR: f64 = 1e6;

/// The largest expansion per kelvin: a mistaken unit is a million times as large.
pub(super) const ALPHA: f64 = 0.001;

/// The farthest that a temperature can be from 20 °C, in kelvin: 293 is a temperature and no distance.
pub(super) const DEGREES: f64 = 100.0;

/// The temperatures between which a piece is measured, in °C: those of `thermal::Range::MEASURED`. 68 are degrees Fahrenheit, 293 kelvin.
pub(super) const COLDEST: f64 = -20.0;
pub(super) const WARMEST: f64 = 50.0;

/// A number of a table, if it is there.
pub(super) type Number = Option<Spanned<f64>>;

/// A refusal with its place.
pub(super) type Refusal = Located<BudgetError>;

/// What is wrong at a place of a text, which counts bytes.
pub(super) fn refused(text: &str, offset: usize, what: BudgetError) -> Refusal {
    Located { what, place: FilePlace::in_line(line_at(text, offset), column_at(text, offset)) }
}

/// The numbers of one table of a file.
pub(super) struct Numbers<'t> {
    /// The whole file.
    pub(super) text: &'t str,
    /// Where the table is, for what is missing.
    pub(super) offset: usize,
    /// What the table is called: the name of a contribution, or `[calibrated]`.
    pub(super) table: &'t str,
    /// Every key that such a table can have.
    pub(super) all: &'t [(&'static str, &'t Number)],
}

impl Numbers<'_> {
    fn get(&self, key: &str) -> Option<(f64, usize)> {
        let (_, number) = self.all.iter().find(|(known, _)| *known == key)?;
        let number = number.as_ref()?;
        Some((*number.get_ref(), number.span().start))
    }

    /// Whether the key is there.
    pub(super) fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// Refuses every key that is not one of these.
    pub(super) fn only(&self, allowed: &[&str]) -> Result<(), Refusal> {
        let mut others = self.all.iter().filter(|(key, _)| !allowed.contains(key));
        let found = others.find_map(|(key, _)| Some((key, self.get(key)?.1)));
        found.map_or(Ok(()), |(key, offset)| {
            let what = BudgetError::Key { table: self.table.to_owned(), key, allowed: allowed.join(", ") };
            Err(refused(self.text, offset, what))
        })
    }

    /// A number of a range, both ends included; `None` where it is not given.
    pub(super) fn within(&self, key: &'static str, least: f64, most: f64) -> Result<Option<f64>, Refusal> {
        let Some((given, offset)) = self.get(key) else { return Ok(None) };
        if (least..=most).contains(&given) {
            return Ok(Some(given));
        }
        let table = self.table.to_owned();
        Err(refused(self.text, offset, BudgetError::Range { table, key, given, least, most }))
    }

    /// The same where it must be given.
    pub(super) fn needed(&self, key: &'static str, least: f64, most: f64) -> Result<f64, Refusal> {
        self.within(key, least, most)?.ok_or_else(|| self.missing(key))
    }

    /// What is missing.
    pub(super) fn missing(&self, keys: &'static str) -> Refusal {
        refused(self.text, self.offset, BudgetError::Missing { table: self.table.to_owned(), keys })
    }
}
