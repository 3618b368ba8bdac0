//! The limit deviations of a callout: table by table, then from the standard.

use std::sync::Arc;

use super::{Absent, LimitsError, Sources, each_once};
use crate::length::Length;
use crate::message::Say as _;
use crate::tolerance::callout::{Callout, PartTolerance, Tolerance};
use crate::tolerance::class::{Feature, ToleranceClass};
use crate::tolerance::deviations::Deviations;
use crate::tolerance::limits::Source;
use crate::tolerance::table::DeviationTable;
use crate::tolerance::{iso286, iso2768, ranges};

impl Sources {
    /// The limit deviations of a callout, and where they come from. `feature` is needed for a fit only.
    ///
    /// # Errors
    /// [`LimitsError`], as for [`Sources::limits`].
    pub fn deviations(&self, callout: &Callout, feature: Option<Feature>) -> Result<(Deviations, Source), LimitsError> {
        let nominal = callout.nominal();
        match callout.tolerance() {
            Tolerance::Class(class) => self.class_deviations(class, nominal),
            Tolerance::Fit { hole, shaft } => match feature {
                Some(Feature::Hole) => self.part_deviations(hole, nominal),
                Some(Feature::Shaft) => self.part_deviations(shaft, nominal),
                None => Err(LimitsError::NoFeature { callout: *callout }),
            },
            Tolerance::General(class) => {
                let iso2768::GeneralCell { deviations, over, to } =
                    iso2768::deviations(class, nominal).map_err(|why| LimitsError::Standard(why.message()))?;
                Ok((deviations, Source::Iso2768 { class, over, to }))
            }
            Tolerance::Deviations(deviations) => Ok((deviations, Source::Callout)),
            Tolerance::Limits { maximum, minimum } => {
                let from = |limit: Length| limit.saturating_sub(nominal);
                let too_large = |_order| LimitsError::TooLarge { nominal };
                Ok((Deviations::new(from(maximum), from(minimum)).map_err(too_large)?, Source::Callout))
            }
        }
    }

    fn part_deviations(&self, part: PartTolerance, nominal: Length) -> Result<(Deviations, Source), LimitsError> {
        match part {
            PartTolerance::Class(class) => self.class_deviations(class, nominal),
            PartTolerance::Deviations(deviations) => Ok((deviations, Source::Callout)),
        }
    }

    fn class_deviations(&self, class: ToleranceClass, nominal: Length) -> Result<(Deviations, Source), LimitsError> {
        let is_own = |source: &Source| matches!(source, Source::Table { shipped: false, .. });
        match &self.absent {
            None => self.found_deviations(class, nominal),
            Some(Absent::Awaited(folder)) => Err(LimitsError::OwnAwaited { folder: Arc::clone(folder) }),
            Some(Absent::Unread(folder)) => match self.found_deviations(class, nominal)? {
                (deviations, source) if !is_own(&source) => {
                    let folder = Arc::clone(folder);
                    Ok((deviations, Source::WithoutOwn { folder, source: Box::new(source) }))
                }
                own => Ok(own),
            },
        }
    }

    fn found_deviations(&self, class: ToleranceClass, nominal: Length) -> Result<(Deviations, Source), LimitsError> {
        let mut beyond = None;
        for table in self.tables() {
            let Some(column) = table.column(class) else { continue };
            let Some((number, over, to)) = table.range(nominal) else {
                beyond.get_or_insert(table);
                continue;
            };
            let Some(deviations) = column.cells.get(number).copied().flatten() else {
                let cells = table.ends.iter().zip(&column.cells);
                let defined = ranges::where_defined(cells.map(|(&to, cell)| (to, cell.is_some())));
                let table = Arc::clone(&table.name);
                return Err(LimitsError::NotDefined { class, table, over, to, defined });
            };
            let name = Arc::clone(&table.name);
            let shipped = table.shipped();
            let instead_of = self.instead_of(table, class, nominal, deviations);
            return Ok((deviations, Source::Table { name, shipped, over, to, instead_of }));
        }
        match (self.base.standard(), beyond) {
            // A user's own class that the standard does not have: the error says where the table ends.
            (Some(standard), Some(table)) if !(standard.knows)(class) => Err(beyond_last_range(table, nominal)),
            // A letter of the standard lacks its grade: the standard says so.
            (Some(_), _) if !class.has_grade() && !iso286::knows_letter(class) => Err(self.no_own_column(class)),
            (Some(standard), _) => (standard.deviations)(class, nominal, self.options),
            (None, Some(table)) => Err(beyond_last_range(table, nominal)),
            (None, None) => Err(self.unknown(class)),
        }
    }

    /// What ISO 286 says where a user's own table differs.
    fn instead_of(
        &self,
        table: &DeviationTable,
        class: ToleranceClass,
        nominal: Length,
        deviations: Deviations,
    ) -> Option<Deviations> {
        if table.shipped() {
            return None;
        }
        let standard = iso286::deviations(class, nominal, self.options).ok()?.deviations;
        (standard != deviations).then_some(standard)
    }

    fn unknown(&self, class: ToleranceClass) -> LimitsError {
        let feature = class.feature();
        let has = |table: &DeviationTable| table.columns().iter().any(|column| column.class.feature() == feature);
        let names: Vec<&str> = self.tables().filter(|table| has(table)).map(|table| table.name()).collect();
        let table = names.join(", ");
        if let Some(other) = self.other_case(class) {
            return LimitsError::OtherCase { class, table, other };
        }
        let known = self.classes(feature);
        let known: Vec<&str> = known.iter().map(ToleranceClass::as_str).collect();
        LimitsError::UnknownClass { class, table, known: known.join(" ") }
    }

    /// Why a name that the standard cannot have has no limits.
    fn no_own_column(&self, class: ToleranceClass) -> LimitsError {
        if self.own.is_empty() {
            return LimitsError::NoOwnTable { class };
        }
        let names: Vec<&str> = self.own.iter().map(|table| table.name()).collect();
        let table = names.join(", ");
        if let Some(other) = self.other_case(class) {
            return LimitsError::OtherCase { class, table, other };
        }
        let both = [class.feature(), class.feature().other()];
        let known = both.map(|feature| each_once(self.table_classes(feature)));
        let known = known.iter().find(|known| !known.is_empty());
        let known: Vec<&str> = known.into_iter().flatten().map(ToleranceClass::as_str).collect();
        LimitsError::NoOwnColumn { class, table, known: known.join(" ") }
    }

    /// The class of the other case, where a table has it: the user may have meant that.
    fn other_case(&self, class: ToleranceClass) -> Option<ToleranceClass> {
        let other = class.other_case();
        self.tables().any(|table| table.column(other).is_some()).then_some(other)
    }
}

fn beyond_last_range(table: &DeviationTable, nominal: Length) -> LimitsError {
    let (over, to) = table.last_range();
    let table = Arc::clone(&table.name);
    LimitsError::BeyondLastRange { nominal, table, over, to }
}
