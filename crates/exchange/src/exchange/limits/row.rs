//! What a row says by its limits: as sizes, and as limits to judge by.

use csv::StringRecord;
use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::{Callout, Limits, LimitsError};

use super::judged::{Given, NoLimits};
use super::{LimitColumns, LimitsAre};
use crate::exchange::cell::Cells as _;
use crate::exchange::cells;
use crate::exchange::column::LengthColumn;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::{shorten, shorten_cell};
use crate::exchange::imported::{StatedLimits, WhyUnjudged};
use crate::exchange::refused::{Cell, Refused};
use crate::exchange::rules::Rules;

impl Rules<'_> {
    /// The limits of a row without a callout, or why it has none to judge by. With a plan its limits are compared with those of the plan.
    pub(in crate::exchange) fn by_limits<'c>(
        &self,
        cells: &'c StringRecord,
        said: &StatedLimits,
        measured: Length,
        is_size: bool,
    ) -> Result<Result<(Option<Callout>, Limits), WhyUnjudged>, Refused<'c>> {
        let at = self.columns.measured.at;
        let text = cells.cell(at).trim();
        let not_positive = || WhyUnjudged::NotPositive { given: shorten(text), column: at + 1 };
        if self.has_plan || said.minimum.or(said.maximum).is_none() || self.columns.limits.is_none() && is_size {
            let is_below = is_size && measured <= Length::ZERO;
            return match is_below {
                true if self.has_plan => Ok(Err(not_positive())),
                true => Err((Cell { at: Some(at), text }, ImportErrorKind::NotPositive { given: shorten(text) })),
                false => Ok(Err(WhyUnjudged::NoCallout)),
            };
        }
        // Nothing measures zero or less that has to be larger.
        if is_size && measured <= Length::ZERO && said.minimum.is_some_and(|minimum| Length::ZERO < minimum) {
            return Err((Cell { at: Some(at), text }, ImportErrorKind::NotPositive { given: shorten(text) }));
        }
        let feature = self.columns.feature_of(cells);
        match said.limits(Given { feature, is_size, file: self.file, sources: self.sources }) {
            Ok(limits) => Ok(Ok((None, limits))),
            Err(NoLimits::Unjudged(why)) => Ok(Err(why)),
            Err(NoLimits::Refused(error)) => {
                let at = self.columns.limits.as_ref().and_then(|limits| limits.iter().next()).map(|column| column.at);
                Err((Cell { at, text: cells.cell(at).trim() }, ImportErrorKind::Limits(*error)))
            }
        }
    }

    /// A tolerance of form is one number: `0.02`.
    pub(in crate::exchange) fn or_of_form(&self, cells: &StringRecord, said: StatedLimits) -> StatedLimits {
        let text = cells.cell(self.columns.tolerance).trim();
        let is_form = said.nominal.is_none_or(|nominal| nominal == Length::ZERO);
        let one = cells::length(text, Unit::Millimetre).ok();
        let one = one.filter(|one| is_form && Length::ZERO < *one && text.starts_with(|c: char| c.is_ascii_digit()));
        if said.minimum.or(said.maximum).is_some() { said } else { StatedLimits { maximum: one, ..said } }
    }

    /// The limits that stand in columns of their own, as sizes: the smaller one first.
    pub(in crate::exchange) fn column_limits<'c>(
        &self,
        cells: &'c StringRecord,
        columns: &LimitColumns,
        nominal: Option<Length>,
    ) -> Result<[Option<Length>; 2], Refused<'c>> {
        let read = |column: Option<LengthColumn>| -> Result<Option<(Cell<'c>, Length)>, Refused<'c>> {
            let Some(column) = column else { return Ok(None) };
            let text = cells.cell(column.at).trim();
            if matches!(text, "" | "-" | "\u{2013}" | "\u{2014}") {
                return Ok(None);
            }
            let column = self.columns.stated.of_limit(column, cells)?;
            let cell = Cell { at: Some(column.at), text };
            let length = cells::length(&shorten_cell(text), column.unit);
            length.map(|length| Some((cell, length))).map_err(|error| (cell, ImportErrorKind::Limit(error)))
        };
        let upper = read(columns.upper)?;
        let lower = read(columns.lower)?;
        let size = |found: Option<(Cell<'c>, Length)>, is_lower: bool| -> Result<Option<Length>, Refused<'c>> {
            let Some((cell, length)) = found else { return Ok(None) };
            let deviation = match columns.are {
                LimitsAre::Sizes => return Ok(Some(length)),
                LimitsAre::UnsignedDeviations if is_lower && length < Length::ZERO => {
                    return Err((cell, ImportErrorKind::MinusAgain { given: shorten(cell.text) }));
                }
                LimitsAre::UnsignedDeviations if is_lower => length.negated(),
                LimitsAre::Deviations | LimitsAre::UnsignedDeviations => length,
            };
            let nominal = nominal.ok_or((cell, ImportErrorKind::QifNoNominal))?;
            let too_large = || (cell, ImportErrorKind::Limits(LimitsError::TooLarge { nominal }));
            nominal.checked_add(deviation).map(Some).ok_or_else(too_large)
        };
        Ok([size(lower, true)?, size(upper, false)?])
    }
}
