//! Limits that stand in columns of their own: upper and lower limit, or upper and lower deviation from the nominal size.
//!
//! | file | what |
//! |---|---|
//! | here | the columns, and what a row says by them |
//! | `names` | what the name of a column says of a limit |
//! | `find` | which columns have the limits: by their names, and by their numbers where a name may mean two things |
//! | `row` | what a row says by its limits |
//! | `judged` | limits that come without a callout: what a value is judged by, or why it is not |
//!
//! A lower deviation may stand without its minus. That is told, and believed only where every row can be read so. What may be read in two
//! ways is refused, with the words of `--columns` that decide it.

mod find;
mod judged;
mod names;
mod row;

use csv::StringRecord;
use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::{Bounds, Deviations};
use fitcheck_core::verdict::Status;

use super::cell::Cells as _;
use super::claim::{Claim, ClaimAnswer, Figure};
use super::column::LengthColumn;
use super::error::ImportWarningKind;
use super::stated::Stated;
pub(super) use find::{Beside, Found};
pub(super) use judged::{Given, NoLimits};
pub(super) use names::{LimitName, by_name, goes_both_ways};

/// What the numbers of limit columns are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LimitsAre {
    /// Sizes.
    Sizes,
    /// Deviations from the nominal size, each with its sign.
    Deviations,
    /// The same, but that the lower one stands without its minus.
    UnsignedDeviations,
}

/// The columns of the limits: one of them is there at least.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct LimitColumns {
    pub(super) upper: Option<LengthColumn>,
    pub(super) lower: Option<LengthColumn>,
    pub(super) are: LimitsAre,
    /// The names of both, as messages have them.
    pub(super) names: [String; 2],
    /// Whether something else than their names says that they are limits, which is told.
    pub(super) is_concluded: bool,
}

impl LimitColumns {
    /// The columns, the upper one first.
    pub(super) fn iter(&self) -> impl Iterator<Item = LengthColumn> {
        [self.upper, self.lower].into_iter().flatten()
    }

    /// The same, to set their units.
    pub(super) fn iter_mut(&mut self) -> impl Iterator<Item = &mut LengthColumn> {
        self.upper.iter_mut().chain(&mut self.lower)
    }

    /// What is told of the file: a minus that is supplied, limits by their numbers alone.
    pub(super) fn told(&self) -> impl Iterator<Item = ImportWarningKind> {
        let [upper, lower] = &self.names;
        let minus = (self.are == LimitsAre::UnsignedDeviations)
            .then(|| ImportWarningKind::MinusSupplied { column: lower.clone() });
        let columns =
            || [upper.as_str(), lower.as_str()].into_iter().filter(|name| !name.is_empty()).collect::<Vec<_>>();
        let limits = self.is_concluded.then(|| ImportWarningKind::LimitsRead { columns: columns().join(", ") });
        minus.into_iter().chain(limits)
    }

    /// The words of `--columns` by which they are left out.
    pub(super) const fn words(&self) -> &'static str {
        match self.are {
            LimitsAre::Sizes => "maximum=-,minimum=-",
            LimitsAre::Deviations | LimitsAre::UnsignedDeviations => "upper=-,lower=-",
        }
    }

    /// What the cells of a row say beside a callout or a plan: as figures of which nobody says whether they are sizes or deviations.
    pub(super) fn claims(&self, cells: &StringRecord, stated: &Stated) -> Vec<Claim> {
        let figure = |at: usize, unit: Unit| Figure::read(cells.cell(at), unit);
        let columns = [(self.upper, true), (self.lower, false)].into_iter();
        let claim = |(column, is_upper): (Option<LengthColumn>, bool)| {
            let column = column?;
            let of_row = stated.of_limit(column, cells).map_or(column.unit, |column| column.unit);
            let name = self.names.get(usize::from(!is_upper)).map_or("", String::as_str);
            let said = format!("{name} {}", cells.cell(column.at).trim());
            let figure = figure(column.at, of_row)?;
            Some(if is_upper { Claim::upper(&said, figure) } else { Claim::lower(&said, figure) })
        };
        columns.filter_map(claim).collect()
    }

    /// Whether the limits of a row are other ones than these, as far as they can be read; as a text.
    pub(super) fn contradict(&self, cells: &StringRecord, stated: &Stated, bounds: Bounds) -> Option<String> {
        // Nothing of the answer but its limits is compared.
        let answer = ClaimAnswer { bounds, measured: bounds.nominal, status: Status::Good };
        let claims = self.claims(cells, stated);
        let differs = claims.iter().any(|claim| claim.tells(&answer).is_some());
        differs.then(|| claims.iter().map(Claim::said).collect::<Vec<_>>().join(", "))
    }

    /// The limits of a nominal size by two numbers, the upper one first.
    #[inline]
    pub(super) fn bounds(&self, nominal: Option<Length>, [upper, lower]: [Length; 2]) -> Option<(Length, Deviations)> {
        let (nominal, upper, lower) = match self.are {
            LimitsAre::Sizes => {
                let nominal = nominal.unwrap_or(lower);
                (nominal, upper.checked_sub(nominal)?, lower.checked_sub(nominal)?)
            }
            LimitsAre::Deviations => (nominal?, upper, lower),
            LimitsAre::UnsignedDeviations if lower < Length::ZERO => return None,
            LimitsAre::UnsignedDeviations => (nominal?, upper, lower.negated()),
        };
        Deviations::new(upper, lower).ok().map(|deviations| (nominal, deviations))
    }
}
