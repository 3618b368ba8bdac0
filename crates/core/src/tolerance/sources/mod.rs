//! The sources behind one question, "what are the limits of this callout": ISO 286, a control's tables and whatever
//! else is in the list of `bases`.
//!
//! ISO 286 is the default. A user's own tables come first for the classes and sizes that they hold; they are searched
//! as in program 82551 (LBL 1 to LBL 99). Every answer says where it comes from.

mod bases;
mod deviations;
mod error;

pub use bases::Base;
pub use error::LimitsError;

use std::sync::Arc;

use super::callout::{Callout, Tolerance};
use super::class::{Feature, ToleranceClass};
use super::deviations::Deviations;
use super::iso286;
use super::limits::{Bounds, Limits, Source};
use super::proportion::{self, ZoneDoubt};
use super::table::DeviationTable;
use crate::length::Length;

/// Where limits are looked up: the user's own tables first, then one source of the list.
///
/// A table that has the class and reaches the size gives the answer, which may be "not defined here"; for a class or a
/// size that it lacks, the next source is asked. Cloning is cheap.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Sources {
    /// The user's own, in the order in which they are asked.
    own: Vec<Arc<DeviationTable>>,
    base: Base,
    /// The control's, in the order in which they are asked; empty where a standard is the base.
    control: Vec<Arc<DeviationTable>>,
    options: iso286::Options,
    absent: Option<Absent>,
    takes_wide_zones: bool,
}

/// A folder of own tables that limits should come from and do not.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Absent {
    /// It is still being read: until then no class has limits, for they might be others a moment later.
    Awaited(Arc<str>),
    /// It could not be read: limits come from the next source, and say so.
    Unread(Arc<str>),
}

impl Sources {
    /// Only tables, as on a control.
    pub fn of_tables(tables: impl IntoIterator<Item = impl Into<Arc<DeviationTable>>>) -> Self {
        Self::default().with_base(Base::ControlTables, || tables.into_iter().map(Into::into).collect())
    }

    /// A copy with another base. `tables` is called only where the control's tables are the base.
    #[must_use]
    pub fn with_base(self, base: Base, tables: impl FnOnce() -> Vec<Arc<DeviationTable>>) -> Self {
        Self { base, control: if base.is_standard() { Vec::new() } else { tables() }, ..self }
    }

    /// A copy with a user's own tables, which are asked first.
    #[must_use]
    pub fn with_own(self, own: impl IntoIterator<Item = impl Into<Arc<DeviationTable>>>) -> Self {
        Self { own: own.into_iter().map(Into::into).collect(), ..self }
    }

    /// A copy with other options of ISO 286.
    #[must_use]
    pub const fn with_options(mut self, options: iso286::Options) -> Self {
        self.options = options;
        self
    }

    /// A copy that takes zones out of all proportion as they are given, because somebody said that they are meant; or one that does not.
    #[must_use]
    pub fn with_wide_zones(self, takes_wide_zones: bool) -> Self {
        Self { takes_wide_zones, ..self }
    }

    /// A copy that knows which own tables are absent, if any.
    #[must_use]
    pub fn with_absent(self, absent: Option<Absent>) -> Self {
        Self { absent, ..self }
    }

    /// The own tables that limits should come from and do not.
    pub const fn absent(&self) -> Option<&Absent> {
        self.absent.as_ref()
    }

    /// The user's own tables.
    pub fn own(&self) -> &[Arc<DeviationTable>] {
        &self.own
    }

    /// The source that is asked after them.
    pub const fn base(&self) -> Base {
        self.base
    }

    /// The options of ISO 286.
    pub const fn options(&self) -> iso286::Options {
        self.options
    }

    /// All tables in the order in which they are asked.
    pub fn tables(&self) -> impl Iterator<Item = &Arc<DeviationTable>> {
        let has_namesake = |table: &DeviationTable| self.own.iter().any(|own| same_name(own, table));
        self.own.iter().chain(self.control.iter().filter(move |table| !has_namesake(table)))
    }

    /// The classes to choose from for holes or for shafts, each once: those of the tables, then the usual ones of the
    /// standard. Any other class of the standard also has an answer.
    pub fn classes(&self, feature: Feature) -> Vec<ToleranceClass> {
        let usual = self.base.standard().map(|standard| (standard.usual_classes)(feature));
        each_once(self.table_classes(feature).chain(usual.into_iter().flatten()))
    }

    /// The classes of the tables for holes or for shafts, table by table; a class that is in two tables comes twice.
    pub fn table_classes(&self, feature: Feature) -> impl Iterator<Item = ToleranceClass> {
        let columns = self.tables().flat_map(|table| table.columns().iter().map(|column| column.class));
        columns.filter(move |class| class.feature() == feature)
    }

    /// The upper, inclusive ends of all size steps, ascending: within a step no class has another answer.
    pub fn step_ends(&self) -> Vec<Length> {
        let tables = self.tables().flat_map(|table| table.ends().iter().copied());
        let mut ends: Vec<Length> = iso286::step_ends().chain(tables).collect();
        ends.sort_unstable();
        ends.dedup();
        ends
    }

    /// Every class that the standard has at a size, by letter and then by grade; none where the control's tables answer.
    pub fn standard_classes_at(
        &self,
        feature: Feature,
        nominal: Length,
    ) -> impl Iterator<Item = (ToleranceClass, Deviations)> {
        let is_awaited = matches!(self.absent, Some(Absent::Awaited(_)));
        let standard = self.base.standard().filter(|_| !is_awaited);
        standard.into_iter().flat_map(move |standard| (standard.classes_at)(feature, nominal, self.options))
    }

    /// The limits of a callout. The letter's case says hole or shaft; where a callout has no letters, `feature` says it, or nobody: a
    /// distance or a depth is neither. Of a fit, `feature` says which part is meant.
    ///
    /// ```
    /// use fitcheck_core::tolerance::{Feature, Sources};
    ///
    /// let sources = Sources::default();
    /// let limits = sources.limits(&"280 M6".parse()?, None)?;
    /// assert_eq!(limits.maximum().to_string(), "279.991");
    /// assert_eq!(limits.source.to_string(), "ISO 286, over 250 up to 315 mm");
    /// let limits = sources.limits(&"12 ±0.02".parse()?, Some(Feature::Shaft))?;
    /// assert_eq!(limits.minimum().to_string(), "11.98");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`LimitsError`] names what is missing and what there is instead; nothing is clamped.
    pub fn limits(&self, callout: &Callout, feature: Option<Feature>) -> Result<Limits, LimitsError> {
        if let (Some(class), Some(feature)) = (callout.class(), feature)
            && class.feature() != feature
        {
            return Err(LimitsError::OtherFeature { class });
        }
        let limits = self.whatever_limits(callout, feature)?;
        self.undoubted(|| self.zone_doubt(callout, &limits))?;
        Ok(limits)
    }

    /// The limits of a hole or a shaft: as [`Sources::limits`], where one of the two has to be known.
    ///
    /// # Errors
    /// [`LimitsError::NoFeature`] where neither the callout nor `feature` says it, and those of [`Sources::limits`], which come first: what
    /// is doubted has to be written anew anyway.
    pub fn feature_limits(&self, callout: &Callout, feature: Option<Feature>) -> Result<Limits, LimitsError> {
        let limits = self.limits(callout, feature)?;
        match limits.feature {
            Some(_) => Ok(limits),
            None => Err(LimitsError::NoFeature { callout: *callout }),
        }
    }

    /// What is doubtful about the limits of a callout, whether or not wide zones are meant.
    pub fn zone_doubt(&self, callout: &Callout, limits: &Limits) -> Option<ZoneDoubt> {
        if self.is_of_standard(callout, limits) {
            return None;
        }
        let doubt = proportion::doubt(&limits.bounds())?;
        Some(if matches!(callout.tolerance(), Tolerance::Limits { .. }) { doubt.without_offer() } else { doubt })
    }

    /// The limits of a coordinate that a callout gives: its zone may be wide, for its size is only how far it lies from some zero.
    ///
    /// # Errors
    /// [`LimitsError`], as for [`Sources::limits`].
    pub fn coordinate_limits(&self, callout: &Callout, feature: Option<Feature>) -> Result<Limits, LimitsError> {
        let limits = self.whatever_limits(callout, feature)?;
        self.proportionate_coordinate(limits.nominal, limits.deviations)?;
        Ok(limits)
    }

    /// The limits, whether or not their zone is in proportion.
    fn whatever_limits(&self, callout: &Callout, feature: Option<Feature>) -> Result<Limits, LimitsError> {
        let (deviations, source) = self.deviations(callout, feature)?;
        Limits::new(callout.feature().or(feature), callout.nominal(), deviations, source)
            .ok_or(LimitsError::TooLarge { nominal: callout.nominal() })
    }

    /// Whether the figures are those of a standard, which nobody has typed.
    fn is_of_standard(&self, callout: &Callout, limits: &Limits) -> bool {
        let is_iso286 = |class| {
            let cell = iso286::deviations(class, limits.nominal, self.options);
            cell.is_ok_and(|cell| cell.deviations == limits.deviations)
        };
        match &limits.source {
            Source::Callout | Source::File(_) | Source::Recorded { .. } => false,
            Source::Table { shipped: false, .. } => callout.class_for(limits.feature).is_some_and(is_iso286),
            Source::Standard { .. } | Source::Iso2768 { .. } | Source::Table { .. } | Source::WithoutOwn { .. } => true,
        }
    }

    /// Refuses sizes whose zone is out of all proportion, unless wide zones are meant. For limits that come without a callout.
    ///
    /// # Errors
    /// [`LimitsError::Zone`] with what was probably meant.
    pub fn proportionate(&self, bounds: &Bounds) -> Result<(), LimitsError> {
        self.undoubted(|| proportion::doubt(bounds))
    }

    /// The same for a coordinate, or for a deviation from a place.
    ///
    /// # Errors
    /// [`LimitsError::Zone`] with what was probably meant.
    pub fn proportionate_coordinate(&self, nominal: Length, deviations: Deviations) -> Result<(), LimitsError> {
        self.undoubted(|| proportion::doubt_of_coordinate(nominal, deviations))
    }

    fn undoubted(&self, doubt: impl FnOnce() -> Option<ZoneDoubt>) -> Result<(), LimitsError> {
        let doubt = if self.takes_wide_zones { None } else { doubt() };
        doubt.map_or(Ok(()), |doubt| Err(LimitsError::Zone(Box::new(doubt))))
    }
}

/// The same classes in the same order without repetitions.
fn each_once(classes: impl Iterator<Item = ToleranceClass>) -> Vec<ToleranceClass> {
    let mut each = Vec::new();
    for class in classes {
        if !each.contains(&class) {
            each.push(class);
        }
    }
    each
}

fn same_name(one: &DeviationTable, other: &DeviationTable) -> bool {
    one.name.eq_ignore_ascii_case(&other.name)
}
