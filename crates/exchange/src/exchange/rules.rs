//! What one row of a CSV says: its measured value, its callout and its limits, or the cell that cannot be used.
//!
//! `measurements` asks it for files that are kept in memory, `batch` for rows by the million.

use std::sync::Arc;

use csv::StringRecord;
use fitcheck_core::length::Length;
use fitcheck_core::message::Say as _;
use fitcheck_core::tolerance::{Callout, CalloutError, Feature, Limits, Sources, Tolerance, ToleranceClass};

use super::column::LengthColumn;
use super::columns::Columns;
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::{shorten, shorten_cell};
use super::imported::{StatedLimits, WhyUnjudged};
use super::limits::{LimitColumns, LimitsAre};
use super::lookup::Lookup;
use super::quantity::{self, Quantity};
use super::refused::{Cell, Refused};
use super::{band, cells, evidence};
use crate::exchange::cell::Cells as _;

/// What a row says.
pub(super) struct RowMeasurement {
    pub(super) measured: Length,
    /// Whether there is one: an angle is none.
    pub(super) is_length: bool,
    /// The limits, with the callout where they are of one; otherwise why the row is not judged.
    pub(super) asked: Result<(Option<Callout>, Limits), WhyUnjudged>,
    /// What a row without a callout says that its value should be.
    pub(super) said: StatedLimits,
    /// Whether it says that nobody measured.
    pub(super) is_simulated: bool,
    /// What it says was measured.
    pub(super) quantity: Option<Quantity>,
}

/// What is known before a row is read.
pub(super) struct Rules<'a> {
    pub(super) columns: &'a Columns,
    /// Whether cells stand between commas, where a decimal comma may have become a separator.
    pub(super) has_commas: bool,
    pub(super) sources: &'a Sources,
    /// What was asked before; `None` where that is remembered elsewhere.
    pub(super) lookup: Option<&'a Lookup>,
    /// The file, as the source of limits that stand in it.
    pub(super) file: &'a Arc<str>,
    /// Whether a plan judges values without a callout: some of them are deviations or coordinates, which may be below zero.
    pub(super) has_plan: bool,
}

impl Rules<'_> {
    /// What a row says, or the first cell that cannot be used.
    pub(super) fn read<'c>(&self, cells: &'c StringRecord) -> Result<RowMeasurement, Refused<'c>> {
        let quantity = self.quantity(cells);
        if quantity.as_ref().is_some_and(|quantity| !quantity.is_size()) {
            return self.other_quantity(cells, quantity);
        }
        self.right_length(cells, self.columns.tolerance)?;
        let asks = self.columns.tolerance.is_some_and(|at| !is_blank(cells, at));
        let may_be_below = !asks && (self.has_plan || self.columns.limits.is_some());
        let measured = if may_be_below { self.any_measured(cells)? } else { self.measured(cells)? };
        let Some((callout, cell)) = self.callout(cells, measured)? else {
            // A plan may judge it: what a file of Fitcheck says against it counts all the same.
            self.columns.own.decided_by_size(cells)?;
            let said = self.said(cells)?;
            let asked = self.by_limits(cells, &said, measured, true)?;
            let is_simulated = self.is_simulated(cells)?;
            return Ok(RowMeasurement { measured, is_length: true, asked, said, is_simulated, quantity });
        };
        let limits = match self.lookup {
            Some(lookup) if callout.class().is_some() => lookup.limits(&callout, self.sources),
            _ => self.sources.limits(&callout, callout.feature().or_else(|| self.columns.feature_of(cells))),
        };
        let limits = limits.map_err(|error| (cell, ImportErrorKind::Limits(error)))?;
        if let Some(columns) = &self.columns.limits
            && let Some(given) = columns.contradict(cells, &self.columns.stated, limits.bounds())
        {
            let minimum = limits.minimum();
            let maximum = limits.maximum();
            let columns = columns.words();
            return Err((cell, ImportErrorKind::LimitsContradict { callout, minimum, maximum, given, columns }));
        }
        let is_simulated = self.is_simulated(cells)?;
        self.columns.own.decided_by_size(cells)?;
        let asked = Ok((Some(callout), limits));
        Ok(RowMeasurement { measured, is_length: true, asked, said: StatedLimits::default(), is_simulated, quantity })
    }

    /// What a row says was measured.
    fn quantity(&self, cells: &StringRecord) -> Option<Quantity> {
        let said = quantity::of_row(&self.columns.quantities, cells).map(|(_, _, quantity)| quantity);
        let by_name = || if self.is_no_length(cells) { Quantity::Other } else { Quantity::Length };
        said.or_else(|| self.is_form_by_name(cells).then(by_name))
    }

    /// What a row says that its value should be: a callout, or limits as far as it has them.
    pub(super) fn planned<'c>(&self, cells: &'c StringRecord) -> Result<(Option<Callout>, StatedLimits), Refused<'c>> {
        // Without commas between cells no measured value is asked whether it fits.
        let callout = self.callout(cells, Length::ZERO)?;
        Ok((callout.map(|(callout, _)| callout), self.said(cells)?))
    }

    /// Whether the name of a row is one of form, and its tolerance one number: `Flatness`, `0.02`.
    fn is_form_by_name(&self, cells: &StringRecord) -> bool {
        let text = cells.cell(self.columns.tolerance).trim();
        text.starts_with(|c: char| c.is_ascii_digit())
            && cells::is_number(text)
            && quantity::is_form(cells.cell(self.columns.id))
    }

    /// The cell by which a row is of another quantity than a size.
    pub(super) fn other_than_size<'c>(&self, cells: &'c StringRecord) -> Option<Cell<'c>> {
        let (at, text, _) = quantity::of_row(&self.columns.quantities, cells).filter(|(_, _, of)| !of.is_size())?;
        Some(Cell { at: Some(at), text })
    }

    /// What a row of another quantity than a size says that it should be; nothing of what is no length.
    pub(super) fn asked_of_other<'c>(&self, cells: &'c StringRecord) -> Result<StatedLimits, Refused<'c>> {
        match self.said(cells) {
            _ if self.is_no_length(cells) => Ok(StatedLimits::default()),
            Ok(said) => Ok(self.or_of_form(cells, said)),
            // Without limits nothing is judged by it, so what cannot be read refuses nothing.
            Err(refused) if self.columns.limits.is_some() => Err(refused),
            Err(_unreadable) => Ok(StatedLimits::default()),
        }
    }

    fn is_no_length(&self, cells: &StringRecord) -> bool {
        let name = || cells.cell(self.columns.id);
        quantity::is_no_length(self.other_than_size(cells).map_or_else(name, |cell| cell.text))
    }

    /// A row of another quantity than a size: its callout, if it has one, is not that of its value.
    fn other_quantity<'c>(
        &self,
        cells: &'c StringRecord,
        quantity: Option<Quantity>,
    ) -> Result<RowMeasurement, Refused<'c>> {
        self.right_length(cells, None)?;
        let is_no_length = self.is_no_length(cells);
        let measured = match self.any_measured(cells) {
            // `65.0018°`
            Err(_) if is_no_length => None,
            measured => Some(measured?),
        };
        let said = self.asked_of_other(cells)?;
        let other = || {
            let name = || cells.cell(self.columns.id).trim();
            let what = self.other_than_size(cells).map_or_else(name, |cell| cell.text);
            WhyUnjudged::NotASize { what: shorten(what) }
        };
        let asked = match measured.map(|measured| self.by_limits(cells, &said, measured, false)).transpose()? {
            None | Some(Err(WhyUnjudged::NoCallout)) => Err(other()),
            Some(asked) => asked,
        };
        let is_length = measured.is_some();
        let measured = measured.unwrap_or(Length::ZERO);
        Ok(RowMeasurement { measured, is_length, asked, said, is_simulated: self.is_simulated(cells)?, quantity })
    }

    /// What a row without a callout says that its value should be.
    fn said<'c>(&self, cells: &'c StringRecord) -> Result<StatedLimits, Refused<'c>> {
        let nominal = self.columns.nominal.filter(|column| !is_blank(cells, column.at));
        let nominal = nominal.map(|column| self.length(cells, column, ImportErrorKind::Nominal)).transpose()?;
        let nominal = nominal.map(|(_, nominal)| nominal);
        let [minimum, maximum] = match &self.columns.limits {
            Some(columns) => {
                // Nothing is rounder than round: a form deviates from zero.
                let is_form = || self.other_than_size(cells).is_some_and(|cell| quantity::is_of_ideal_form(cell.text));
                let of_form = || (columns.are != LimitsAre::Sizes && is_form()).then_some(Length::ZERO);
                let from = nominal.or_else(of_form);
                // What these are deviations from, the plan says.
                let is_open = self.has_plan && from.is_none() && columns.are != LimitsAre::Sizes;
                if is_open { [None, None] } else { self.column_limits(cells, columns, from)? }
            }
            None => self.columns.own.limits(cells),
        };
        Ok(StatedLimits { nominal, minimum, maximum })
    }

    /// That the end of the file may have cut off a last row that has no line end: its measured value, if that has fewer decimals than the
    /// others or there are no others to tell, or its callout. What is cut off behind these changes no verdict.
    pub(super) fn cut_off(&self, cells: &StringRecord) -> Option<ImportWarningKind> {
        let columns = self.columns;
        let last = cells.len().checked_sub(1)?;
        let given = shorten(cells.cell(last).trim());
        let judged_by = [Some(columns.measured.at), columns.tolerance, columns.nominal.map(|column| column.at)];
        let limits = columns.limits.iter().flat_map(LimitColumns::iter).map(|column| column.at);
        let quantities = columns.quantities.iter().map(|column| column.at).chain(limits);
        if judged_by.into_iter().flatten().chain(quantities).max() < Some(last) {
            return None;
        }
        if last != columns.measured.at {
            return Some(ImportWarningKind::OpenEnd { given });
        }
        match (cells::decimals(&given), columns.decimals) {
            (found, Some((fewest, _))) if found < fewest => Some(ImportWarningKind::CutOff { given }),
            (found, Some((_, most))) if 0 < most && most <= found => None,
            _ => Some(ImportWarningKind::OpenEnd { given }),
        }
    }

    /// The measured size of a row, or the first cell that cannot be used. Of a callout only the side counts: a row of the
    /// other one is refused.
    pub(super) fn size<'c>(&self, cells: &'c StringRecord, feature: Feature) -> Result<RowMeasurement, Refused<'c>> {
        self.right_length(cells, None)?;
        if let Some(cell) = self.other_than_size(cells) {
            let what = WhyUnjudged::NotASize { what: shorten(cell.text) }.message();
            return Err((cell, ImportErrorKind::NotASize(what)));
        }
        let measured = self.measured(cells)?;
        let text = cells.cell(self.columns.tolerance).trim();
        let given = shorten_cell(text);
        let class = || given.parse::<ToleranceClass>().ok().filter(|class| class.has_grade());
        let found = match given.parse::<Callout>() {
            Ok(callout) => callout.feature(),
            Err(_) => class().map(ToleranceClass::feature),
        };
        if found.is_some_and(|found| found != feature) {
            return Err((
                Cell { at: self.columns.tolerance, text },
                ImportErrorKind::OtherFeature { given: given.into_owned(), feature },
            ));
        }
        let is_simulated = self.is_simulated(cells)?;
        let quantity = None;
        let asked = Err(WhyUnjudged::NoCallout);
        Ok(RowMeasurement { measured, is_length: true, asked, said: StatedLimits::default(), is_simulated, quantity })
    }

    /// Whether a comment would be a row with a size, were it none.
    pub(super) fn hides_size(&self, cells: &StringRecord, feature: Feature) -> bool {
        self.size(&uncommented(cells), feature).is_ok() || self.hides_measurement(cells)
    }

    /// Whether a comment would be a row with a callout and its measured value, were it none: with its `#` or without.
    pub(super) fn hides_measurement(&self, cells: &StringRecord) -> bool {
        let bare = uncommented(cells);
        let is_row = self.read(&bare).is_ok_and(|found| found.asked.is_ok() || found.said.maximum.is_some());
        is_row || [cells, &bare].into_iter().any(cells::is_data)
    }

    /// There must be enough cells for what is needed, and none beyond the columns.
    fn right_length<'c>(&self, cells: &'c StringRecord, callout: Option<usize>) -> Result<(), Refused<'c>> {
        let expected = self.columns.count;
        let found = cells.len();
        if let Some((at, text)) = cells.iter().enumerate().skip(expected).find(|(_, cell)| !cell.trim().is_empty()) {
            return Err((Cell { at: Some(at), text }, ImportErrorKind::RowLong { found, expected }));
        }
        let needed = callout.into_iter().chain([self.columns.measured.at]).fold(0, usize::max);
        if found <= needed {
            return Err((
                Cell { at: None, text: cells.cell(found.checked_sub(1)) },
                ImportErrorKind::RowShort { found, expected },
            ));
        }
        Ok(())
    }

    /// The measured value of a diameter.
    fn measured<'c>(&self, cells: &'c StringRecord) -> Result<Length, Refused<'c>> {
        let measured = self.any_measured(cells)?;
        if measured <= Length::ZERO {
            let at = self.columns.measured.at;
            let text = cells.cell(at).trim();
            return Err((Cell { at: Some(at), text }, ImportErrorKind::NotPositive { given: shorten(text) }));
        }
        Ok(measured)
    }

    fn any_measured<'c>(&self, cells: &'c StringRecord) -> Result<Length, Refused<'c>> {
        let (cell, measured) = self.length(cells, self.columns.measured, ImportErrorKind::Measured)?;
        let given = || shorten(cell.text);
        if let Some(sign) = self.columns.decimal_sign
            && cells::sign_of(cell.text).is_some_and(|own| own != sign)
        {
            return Err((cell, ImportErrorKind::DecimalSign { given: given(), sign }));
        }
        // 25,012 between separating commas: 25 in this column and 012 in the next one.
        let behind = cells.get(self.columns.measured.at + 1).filter(|behind| cells::is_whole(behind));
        if let Some(behind) = behind
            && self.has_commas
            && cells::is_whole(cell.text)
            && !self.columns.behind.is_some_and(|numbers| numbers.may_have(behind))
        {
            let joined = format!("{},{}", given(), shorten(behind.trim()));
            return Err((cell, ImportErrorKind::DecimalComma { joined }));
        }
        Ok(measured)
    }

    /// A length of a row, in the unit that is stated for it.
    fn length<'c>(
        &self,
        cells: &'c StringRecord,
        column: LengthColumn,
        reason: fn(fitcheck_core::length::LengthError) -> ImportErrorKind,
    ) -> Result<(Cell<'c>, Length), Refused<'c>> {
        let column = self.columns.stated.in_row(column, cells)?;
        let text = cells.cell(column.at).trim();
        let cell = Cell { at: Some(column.at), text };
        let length = cells::length(&shorten_cell(text), column.unit).map_err(|error| (cell, reason(error)))?;
        Ok((cell, length))
    }

    /// The callout of a row and its cell; `None` where the cell is empty or there is no such column.
    fn callout<'c>(
        &self,
        cells: &'c StringRecord,
        measured: Length,
    ) -> Result<Option<(Callout, Cell<'c>)>, Refused<'c>> {
        let Some(at) = self.columns.tolerance else { return Ok(None) };
        let text = cells.cell(at).trim();
        let cell = Cell { at: Some(at), text };
        if text.is_empty() {
            return Ok(None);
        }
        let begins_with_letter = text.starts_with(|c: char| c.is_ascii_alphabetic());
        let given = shorten_cell(text);
        let nominal = match self.columns.nominal {
            Some(column) if begins_with_letter || !is_blank(cells, column.at) => {
                Some(self.length(cells, column, ImportErrorKind::Nominal)?)
            }
            _ => None,
        };
        let is_class = begins_with_letter && nominal.is_some();
        if !is_class && self.columns.stated.is_inch(cells) {
            return Err((cell, ImportErrorKind::CalloutUnit { given: given.into_owned() }));
        }
        let read = match nominal {
            Some((_, nominal)) if begins_with_letter => {
                given.parse().map_err(CalloutError::from).and_then(|class| Callout::new(nominal, class))
            }
            Some((_, nominal)) if band::is_one(&given) => {
                let goes_both_ways = self.columns.tolerance_goes_both_ways;
                let deviations = band::read(&given, goes_both_ways).map_err(|reason| (cell, reason))?;
                Callout::with_deviations(nominal, deviations)
            }
            _ => self.lookup.map_or_else(|| given.parse::<Callout>(), |lookup| lookup.callout(&given)),
        };
        let callout = read.map_err(|error| (cell, ImportErrorKind::Callout(error)))?;
        // Of two limits the nominal size is another than their middle, and within twice of them.
        let is_between = |nominal: Length| match callout.tolerance() {
            Tolerance::Limits { maximum, minimum } => {
                nominal.saturating_sub(maximum) <= maximum && minimum.saturating_sub(nominal) <= nominal
            }
            _ => nominal == callout.nominal(),
        };
        if let Some((_, nominal)) = nominal.filter(|(_, nominal)| !is_between(*nominal)) {
            return Err((cell, ImportErrorKind::NominalDiffers { callout, nominal }));
        }
        self.one_callout(cells, cell, callout, measured)?;
        Ok(Some((callout, cell)))
    }

    /// `25,5 H7,25.512` without a header is 5 H7 of part 25, or 25,5 H7. The measured value shows the doubt.
    fn one_callout<'c>(
        &self,
        cells: &'c StringRecord,
        cell: Cell<'c>,
        callout: Callout,
        measured: Length,
    ) -> Result<(), Refused<'c>> {
        if self.columns.names_known || !self.has_commas {
            return Ok(());
        }
        let Some(before) = cell.at.and_then(|at| at.checked_sub(1)).and_then(|at| cells.get(at)) else { return Ok(()) };
        let joined = format!("{},{}", before.trim(), cell.text);
        let Ok(other) = joined.parse::<Callout>() else { return Ok(()) };
        let off = |nominal: Length| measured.saturating_sub(nominal).abs();
        if off(other.nominal()) < off(callout.nominal()) {
            return Err((cell, ImportErrorKind::DecimalComma { joined: shorten(&joined) }));
        }
        Ok(())
    }

    /// Whether the row says that nobody measured.
    fn is_simulated<'c>(&self, cells: &'c StringRecord) -> Result<bool, Refused<'c>> {
        let text = cells.cell(self.columns.simulated).trim();
        let evidence = evidence::yes_or_no(text).or_else(|| evidence::is_simulated(text));
        let unknown =
            || (Cell { at: self.columns.simulated, text }, ImportErrorKind::Simulated { given: shorten(text) });
        let is_simulated = evidence.ok_or_else(unknown)?;
        Ok(self.columns.evidence.is_simulated(cells)? || is_simulated)
    }
}

/// A comment without its `#`.
fn uncommented(cells: &StringRecord) -> StringRecord {
    let first = cells.cell(0).trim_start().trim_start_matches('#');
    std::iter::once(first).chain(cells.iter().skip(1)).collect()
}

fn is_blank(cells: &StringRecord, at: usize) -> bool {
    cells.get(at).is_none_or(|cell| cell.trim().is_empty())
}
