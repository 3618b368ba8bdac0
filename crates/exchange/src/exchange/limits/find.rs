//! Which columns have the limits: by their names, and by their numbers where a name may mean two things.

use csv::StringRecord;
use fitcheck_core::length::{Length, Unit};

use super::names::{LimitName, by_name, by_sign};
use super::{LimitColumns, LimitsAre};
use crate::exchange::cell::Cells as _;
use crate::exchange::column::{LengthColumn, listed, name_of, several, unit_of};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::role::Role;
use crate::exchange::sample::Sample;
use crate::exchange::{cells, units};

/// What else is known of the columns of a file.
#[derive(Clone, Copy)]
pub(in crate::exchange) struct Beside<'a> {
    pub(in crate::exchange) names: &'a StringRecord,
    pub(in crate::exchange) measured: usize,
    pub(in crate::exchange) nominal: Option<usize>,
    /// Whether there is a column of callouts.
    pub(in crate::exchange) has_callouts: bool,
}

/// Columns that may have the limits, as far as they are known.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::exchange) struct Found {
    pub(in crate::exchange) upper: Option<usize>,
    pub(in crate::exchange) lower: Option<usize>,
    /// What they are, where somebody says it.
    pub(in crate::exchange) are: Option<LimitsAre>,
}

impl Sample {
    /// The columns of the limits by the names of a header; `None` where it has none, or none that is more than a comparison.
    ///
    /// # Errors
    /// Where a name may mean two things.
    pub(in crate::exchange) fn limit_columns(
        &self,
        beside: Beside<'_>,
        is_free: impl Fn(usize) -> bool,
    ) -> Result<Option<LimitColumns>, ImportErrorKind> {
        let all: Vec<(usize, LimitName)> = (0..)
            .zip(beside.names)
            .filter(|(at, _)| is_free(*at) && *at != beside.measured && !self.is_empty(*at))
            .filter_map(|(at, name)| Some((at, by_name(name).or_else(|| by_sign(name, beside.names))?)))
            .collect();
        let of = |wanted: fn(&LimitName) -> bool| -> Vec<(usize, LimitName)> {
            all.iter().copied().filter(|(_, name)| wanted(name)).collect()
        };
        let limits = of(|name| name.is_sure() && !name.is_deviation());
        let deviations = of(|name| name.is_deviation());
        let open = of(|name| !name.is_sure());
        let has_base = beside.nominal.is_some() || beside.has_callouts;
        let chosen = if !limits.is_empty() {
            limits
        } else if !deviations.is_empty() {
            if !has_base {
                return Ok(None);
            }
            deviations
        } else if open.is_empty() || beside.has_callouts && open.iter().any(|(_, name)| name.may_be_reading()) {
            // Beside a callout these may be the largest and the smallest of several readings: they are compared.
            return Ok(None);
        } else {
            open
        };
        let one = |is_upper: bool| -> Result<Option<usize>, ImportErrorKind> {
            let found: Vec<usize> =
                chosen.iter().filter(|(_, name)| name.is_upper() == is_upper).map(|(at, _)| *at).collect();
            match found.as_slice() {
                [] => Ok(None),
                [at] => Ok(Some(*at)),
                _ => Err(several(if is_upper { Role::Maximum } else { Role::Minimum }, beside.names, &found)),
            }
        };
        let found = Found { upper: one(true)?, lower: one(false)?, are: None };
        if chosen.iter().any(|(_, name)| name.may_be_reading()) && !self.are_limits(found, beside) {
            return Err(Self::asked(found, beside.names, Asked::Readings));
        }
        let is_sure = chosen.iter().all(|(_, name)| name.is_sure());
        let are = self.kind(found, beside, is_sure.then(|| chosen.iter().any(|(_, name)| name.is_deviation())))?;
        let is_minus = chosen.iter().any(|(_, name)| *name == LimitName::Minus);
        let are = if are == LimitsAre::Deviations { self.signs(found, beside, is_minus)? } else { are };
        Self::columns_of(found, beside.names, are, !is_sure).map(Some)
    }

    /// The columns of the limits that somebody has said.
    ///
    /// # Errors
    /// A unit that is none, or signs that may mean two things.
    pub(in crate::exchange) fn said_limits(
        found: Found,
        names: &StringRecord,
    ) -> Result<Option<LimitColumns>, ImportErrorKind> {
        let Some(are) = found.are.filter(|_| found.upper.or(found.lower).is_some()) else { return Ok(None) };
        Self::columns_of(found, names, are, false).map(Some)
    }

    fn columns_of(
        found: Found,
        names: &StringRecord,
        are: LimitsAre,
        is_concluded: bool,
    ) -> Result<LimitColumns, ImportErrorKind> {
        let column = |at: usize| -> Result<LengthColumn, ImportErrorKind> {
            Ok(LengthColumn { at, unit: unit_of(names.cell(at))? })
        };
        let name = |at: Option<usize>| at.map_or_else(String::new, |at| name_of(at, names.cell(at)));
        Ok(LimitColumns {
            upper: found.upper.map(column).transpose()?,
            lower: found.lower.map(column).transpose()?,
            are,
            names: [name(found.upper), name(found.lower)],
            is_concluded,
        })
    }

    /// The numbers of columns, row by row, where all of them have one.
    fn numbers<const N: usize>(&self, names: &StringRecord, columns: [usize; N]) -> impl Iterator<Item = [Length; N]> {
        let below = self.units_row.and_then(|row| self.rows.get(row)).map(|(_, cells)| cells);
        let of_row = |at: usize| below.and_then(|cells| units::known(cells.cell(at)));
        let units = columns.map(|at| units::unit(names.cell(at)).ok().flatten().or_else(|| of_row(at)));
        // Beside sizes in inch, limits are in inch as well.
        let open = if units.contains(&Some(Unit::Inch)) { Unit::Inch } else { Unit::Millimetre };
        let rows = self.rows.iter().skip(self.above);
        rows.filter_map(move |(_, row)| {
            let mut all = [Length::ZERO; N];
            for (place, (at, unit)) in all.iter_mut().zip(columns.into_iter().zip(units)) {
                *place = cells::length(row.get(at)?, unit.unwrap_or(open)).ok()?;
            }
            Some(all)
        })
    }

    /// Whether columns of the largest and the smallest are limits and no readings: a value lies outside of them, they stand before the
    /// value, or different values have the same ones.
    fn are_limits(&self, found: Found, beside: Beside<'_>) -> bool {
        let Found { upper: Some(upper), lower: Some(lower), .. } = found else { return false };
        if upper.max(lower) < beside.measured {
            return true;
        }
        let all: Vec<[Length; 3]> = self.numbers(beside.names, [upper, lower, beside.measured]).collect();
        let is_outside = |[upper, lower, measured]: &[Length; 3]| *upper < *measured || *measured < *lower;
        let repeats = |row: &[Length; 3]| {
            let [upper, lower, measured] = row;
            let same = |[other_upper, other_lower, other]: &[Length; 3]| {
                (other_upper, other_lower) == (upper, lower) && other != measured
            };
            upper != lower && all.iter().any(same)
        };
        all.iter().any(is_outside) || !all.is_empty() && all.iter().all(repeats)
    }

    /// Whether the numbers are sizes or deviations; `said` is what the names say.
    fn kind(&self, found: Found, beside: Beside<'_>, said: Option<bool>) -> Result<LimitsAre, ImportErrorKind> {
        // Without a nominal size the measured value is as near.
        let base = beside.nominal.unwrap_or(beside.measured);
        let mut sizes = 0_usize;
        let mut deviations = 0_usize;
        for at in [found.upper, found.lower].into_iter().flatten() {
            for [base, number] in self.numbers(beside.names, [base, at]).filter(|[base, _]| Length::ZERO < *base) {
                let off = number.saturating_sub(base).abs();
                // Within half of the size, or at most a quarter of it.
                sizes += usize::from(off <= base.saturating_sub(off));
                deviations += usize::from(number.abs().nanometres() <= base.nanometres() / 4);
            }
        }
        match (said, sizes, deviations) {
            (Some(true), 0, _) | (Some(true), 1.., 1..) => Ok(LimitsAre::Deviations),
            (Some(false), _, 0) | (Some(false), 1.., 1..) | (None, 1.., 0) => Ok(LimitsAre::Sizes),
            (None, 0, 1..) if beside.nominal.is_some() => Ok(LimitsAre::Deviations),
            _ => Err(Self::asked(found, beside.names, Asked::Deviations)),
        }
    }

    /// Whether lower deviations stand without their minus: none of them has a sign, and one is not below its upper deviation, or the name
    /// has the minus.
    fn signs(&self, found: Found, beside: Beside<'_>, is_minus: bool) -> Result<LimitsAre, ImportErrorKind> {
        let Some(lower) = found.lower else { return Ok(LimitsAre::Deviations) };
        let is_signed = |cell: &str| cell.starts_with(['+', '-', '\u{2212}', '\u{2013}']);
        let is_positive = |cell: &str| cells::length(cell, Unit::Millimetre).is_ok_and(|length| Length::ZERO < length);
        let has_sign = self.cells(lower).any(|cell| is_signed(cell) && !is_zero(cell));
        if has_sign || !self.cells(lower).any(is_positive) {
            return Ok(LimitsAre::Deviations);
        }
        let is_above = |[upper, lower]: [Length; 2]| Length::ZERO < lower && upper <= lower;
        let upper = found.upper;
        if is_minus || upper.is_some_and(|upper| self.numbers(beside.names, [upper, lower]).any(is_above)) {
            return Ok(LimitsAre::UnsignedDeviations);
        }
        Err(Self::asked(found, beside.names, Asked::Minus))
    }

    fn asked(found: Found, names: &StringRecord, what: Asked) -> ImportErrorKind {
        let asked: Vec<usize> = match what {
            Asked::Minus => found.lower.into_iter().collect(),
            Asked::Deviations | Asked::Readings => [found.upper, found.lower].into_iter().flatten().collect(),
        };
        let columns: Vec<String> = asked.iter().map(|at| name_of(*at, names.cell(*at))).collect();
        let columns = listed(&columns);
        let number = |at: Option<usize>| at.map_or_else(|| "-".to_owned(), |at| (at + 1).to_string());
        let upper = number(found.upper);
        let lower = number(found.lower);
        match what {
            Asked::Readings => ImportErrorKind::LimitsOrReadings { columns, upper, lower },
            Asked::Deviations => ImportErrorKind::LimitsOrDeviations { columns, upper, lower },
            Asked::Minus => ImportErrorKind::MinusOrPlus { columns, lower },
        }
    }
}

/// What is asked about.
#[derive(Clone, Copy)]
enum Asked {
    Readings,
    Deviations,
    Minus,
}

fn is_zero(cell: &str) -> bool {
    !cell.contains(|c| ('1'..='9').contains(&c))
}
